// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/place_of_type.hpp>
#include <typemesh/core/option_bits.hpp>

#include <concepts>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A key that distinguishes policies: the type of a policy, and the options that matter.
struct policy_key {
    const void* type = nullptr;  ///< null: the policy cannot be distinguished from others of its type
    option_bits options;

    friend bool operator==(const policy_key&, const policy_key&) noexcept = default;
};

/// A policy that states its options: `option_bits cache_key() const noexcept`.
template <class P>
concept has_cache_key = requires(const P& p) {
    { p.cache_key() } noexcept -> std::convertible_to<option_bits>;
};

/// A policy whose results can be kept in a glyph_cache. A policy without data members needs no cache_key(), because its
/// type is enough.
template <class P>
concept cacheable_policy = has_cache_key<P> || std::is_empty_v<P>;

/// A policy's key. The key has no type if the policy is not a cacheable_policy.
template <class Policy>
[[nodiscard]] policy_key key_of(const Policy& p) noexcept
{
    policy_key key;
    if constexpr (cacheable_policy<Policy>) key.type = &detail::place_of_type<Policy>;
    if constexpr (has_cache_key<Policy>) key.options = p.cache_key();
    return key;
}

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/option_bits.hpp>

#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// A hash of 128 bits of any number of option bits, as two numbers. Policies that hold other policies use it.
struct option_hash {
    std::uint64_t first = 0x6A09'E667'F3BC'C908u;
    std::uint64_t second = 0xBB67'AE85'84CA'A73Bu;

    void add(std::uint64_t word) noexcept
    {
        for (const std::uint64_t half : {word >> 32, word & 0xFFFF'FFFFu}) {
            first = mixed_key(first, half);
            second = mixed_key(second, ~half);
        }
    }
    void add(const option_bits& bits) noexcept
    {
        for (const std::uint64_t word : bits.words) add(word);
    }

    /// Adds the key of a policy. A policy without options has no key.
    template <class Policy>
    void add_key_of(const Policy& p) noexcept
    {
        if constexpr (requires { p.cache_key(); }) add(p.cache_key());
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

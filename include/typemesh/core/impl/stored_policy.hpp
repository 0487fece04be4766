// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/place_of_type.hpp>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Stores one policy of any type inside itself, and passes it on as a Ref: discretiser_ref, triangulator_ref,
/// observer_ref. A policy has at most `room` bytes. Nothing is allocated.
///
///     stored_policy<discretiser_ref> flatten{certified{}};
///     flatten = two_lines{};
///     if (const auto* lines = flatten.get<two_lines>()) ...
///
/// It is move-only, because policies may be. A stored_policy that was moved from still holds its policy, moved from.
template <class Ref>
class stored_policy {
public:
    static constexpr std::size_t room = 64;

    template <class Policy>
        requires(!std::same_as<Policy, stored_policy>)
    explicit stored_policy(Policy policy) noexcept
    {
        hold(std::move(policy));
    }
    stored_policy(stored_policy&& other) noexcept : life_{other.life_}, calls_{other.calls_}
    {
        life_->move(bytes_, other.bytes_);
    }
    stored_policy& operator=(stored_policy&& other) noexcept
    {
        if (this == &other) return *this;
        life_->end(bytes_);
        life_ = other.life_;
        calls_ = other.calls_;
        life_->move(bytes_, other.bytes_);
        return *this;
    }
    template <class Policy>
        requires(!std::same_as<Policy, stored_policy>)
    stored_policy& operator=(Policy policy) noexcept
    {
        life_->end(bytes_);
        hold(std::move(policy));
        return *this;
    }
    ~stored_policy() { life_->end(bytes_); }

    /// The policy if it has this type, otherwise null.
    template <class Policy>
    [[nodiscard]] Policy* get() noexcept
    {
        return life_->type == &detail::place_of_type<Policy> ? std::launder(reinterpret_cast<Policy*>(bytes_))
                                                             : nullptr;
    }

    /// Refers to the policy, until the policy is replaced or this object is moved.
    [[nodiscard]] Ref ref() noexcept { return Ref{bytes_, *calls_}; }

private:
    struct life {
        void (*move)(void* to, void* from) noexcept;
        void (*end)(void* policy) noexcept;
        const void* type;
    };
    template <class Policy>
    static constexpr life life_of = {
        [](void* to, void* from) noexcept { new (to) Policy(std::move(*static_cast<Policy*>(from))); },
        [](void* policy) noexcept { static_cast<Policy*>(policy)->~Policy(); }, &detail::place_of_type<Policy>};

    template <class Policy>
    void hold(Policy policy) noexcept
    {
        static_assert(sizeof(Policy) <= room,
                      "typemesh: a mesher stores a policy of at most 64 bytes: let a larger one refer to its data.");
        static_assert(alignof(Policy) <= alignof(std::max_align_t),
                      "typemesh: a policy must have an alignment of at most 16 bytes.");
        static_assert(std::is_nothrow_move_constructible_v<Policy>, "typemesh: moving a policy must be noexcept.");
        new (bytes_) Policy(std::move(policy));
        life_ = &life_of<Policy>;
        calls_ = &Ref::template table<Policy>::of;
    }

    alignas(std::max_align_t) std::byte bytes_[room];
    const life* life_;
    const typename Ref::calls* calls_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

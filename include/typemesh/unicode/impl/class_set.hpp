// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A set of character classes, to test several at once. Class is an enumeration of at most 64 values from 0 on.
template <class Class>
class class_set {
public:
    template <class... Classes>
    constexpr class_set(Classes... c) noexcept : bits_{(std::uint64_t{0} | ... | bit(c))}
    {
    }

    [[nodiscard]] constexpr bool holds(Class c) const noexcept { return (bits_ & bit(c)) != 0; }
    [[nodiscard]] constexpr bool meets(class_set other) const noexcept { return (bits_ & other.bits_) != 0; }
    constexpr void add(Class c) noexcept { bits_ |= bit(c); }
    constexpr void add(class_set other) noexcept { bits_ |= other.bits_; }
    [[nodiscard]] friend constexpr class_set operator|(class_set a, class_set b) noexcept
    {
        a.add(b);
        return a;
    }

private:
    static constexpr std::uint64_t bit(Class c) noexcept { return std::uint64_t{1} << static_cast<unsigned>(c); }

    std::uint64_t bits_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The type of an index, wherever indices are written: an integer of 8 to 64 bits, unsigned as in graphics interfaces
/// or signed as in Eigen, Godot, Qt and VTK. Not a bool, a character or an enumeration.
template <class T>
concept vertex_index =
    std::integral<T> && !std::is_const_v<T> && !std::same_as<T, bool> && !std::same_as<T, char> &&
    !std::same_as<T, wchar_t> && !std::same_as<T, char8_t> && !std::same_as<T, char16_t> && !std::same_as<T, char32_t>;

/// Whether Index can number that many vertices from 0. Its greatest value (0xFFFF, 0xFFFFFFFF; 0x7FFFFFFF of an int) is
/// reserved: graphics interfaces read it as "primitive restart".
template <vertex_index Index>
[[nodiscard]] constexpr bool index_can_number(std::uint64_t vertices) noexcept
{
    return vertices <= static_cast<std::uint64_t>((std::numeric_limits<Index>::max)());
}

/// Writes consecutive triangles as three indices each and adds a base vertex to all: each element once, in ascending
/// order, never read back. Shared by all sinks over memory.
template <class Index>
class index_writer {
    static_assert(vertex_index<Index>,
                  "typemesh: indices must be writable integers of 8 to 64 bits, for example std::uint16_t, "
                  "std::uint32_t or int.");

public:
    explicit constexpr index_writer(std::uint32_t base_vertex) noexcept : base_{base_vertex} {}

    /// error::index_overflow if Index cannot number so many vertices after the base vertex, otherwise none.
    [[nodiscard]] constexpr error numbers(std::uint64_t vertices) const noexcept
    {
        return index_can_number<Index>(base_ + vertices) ? error{} : error{error::index_overflow, base_ + vertices};
    }

    constexpr void start(Index* first) noexcept { next_ = first; }
    constexpr void skip(std::size_t indices) noexcept { next_ += indices; }

    /// Whether one more triangle ends before `end`; false before start().
    [[nodiscard]] constexpr bool fits_before(const Index* end) const noexcept
    {
        return next_ != nullptr && end - next_ >= 3;
    }

    constexpr void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        next_[0] = static_cast<Index>(base_ + a);
        next_[1] = static_cast<Index>(base_ + b);
        next_[2] = static_cast<Index>(base_ + c);
        next_ += 3;
    }

private:
    Index* next_ = nullptr;
    std::uint64_t base_;  // 64 bits wide, so that storing a 32-bit index cannot alias it and force a reload
};

}  // namespace typemesh::inline TYPEMESH_ABI

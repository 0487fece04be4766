// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The first i in [first, last) for which `holds(i)` is true, or last where it is for none. If it holds for one i it
/// must for all behind it.
///
/// Cost   O(log(last - first))
template <class Holds>
[[nodiscard]] constexpr std::size_t first_where(std::size_t first, std::size_t last, const Holds& holds) noexcept
{
    while (first < last) {
        const std::size_t middle = first + (last - first) / 2;
        if (holds(middle)) last = middle;
        else first = middle + 1;
    }
    return first;
}

/// Which of some ranges that lie behind one another holds i, the ranges being given by their starts, ascending:
///
///     starts   [ 0 | first of range 1 | first of range 2 | ... ]      one more, where the last range ends, is of no
///                                                                     account while i lies before it
///
/// Of several that start at one place, all but the last being empty, it is the last. Needs starts[0] <= i.
[[nodiscard]] constexpr std::size_t range_of(std::span<const std::uint32_t> starts, std::uint32_t i) noexcept
{
    return first_where(1, starts.size(), [&](std::size_t k) noexcept { return starts[k] > i; }) - 1;
}

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/version.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The first i in [first, last) for which `holds(i)` is true, or last if there is none: binary search. If `holds` is
/// true for some i, it must be true for all greater ones.
///
/// Cost   O(log(last - first))
template <class Holds>
[[nodiscard]] constexpr std::size_t first_where(std::size_t first, std::size_t last, const Holds& holds) noexcept
{
    while (first < last) {
        const std::size_t middle = first + (last - first) / 2;
        if (holds(middle))
            last = middle;
        else
            first = middle + 1;
    }
    return first;
}

/// Which of several consecutive ranges contains i. The ranges are given by their starts, in ascending order:
///
///     starts   [ 0 | first of range 1 | first of range 2 | ... ]      a final entry, the end of the last range, makes
///                                                                     no difference while i lies before it
///
/// If several ranges have the same start, all but the last are empty; the result is the last one. Precondition:
/// starts[0] <= i.
[[nodiscard]] constexpr std::size_t range_of(array_view<const std::uint32_t> starts, std::uint32_t i) noexcept
{
    return first_where(1, starts.size(), [&](std::size_t k) noexcept { return starts[k] > i; }) - 1;
}

}  // namespace typemesh::inline TYPEMESH_ABI

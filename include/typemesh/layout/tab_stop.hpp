// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The least distance by which a tab moves the pen, computed from the advance of "0". It is half of this advance, as in
/// CSS, so that text before and after the tab does not look like one word.
[[nodiscard]] constexpr double least_tab(double digit) noexcept { return 0.5 * digit; }

/// The pen's position after a tab: the next stop, or the stop after it if the next stop is nearer than `least`.
///
///     apart    the distance between stops, which start at 0; more than 0
[[nodiscard]] inline double tab_stop_behind(double pen, double apart, double least) noexcept
{
    const double stop = (std::floor(pen / apart) + 1.0) * apart;
    return stop - pen < least ? stop + apart : stop;
}

}  // namespace typemesh::inline TYPEMESH_ABI

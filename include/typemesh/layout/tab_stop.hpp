// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// How near a tab stop may be for a tab to lead there, from the advance of "0": half of it, as in CSS, so that what a
/// tab parts does not read as one word.
[[nodiscard]] constexpr double least_tab(double digit) noexcept { return 0.5 * digit; }

/// Where a pen goes on behind a tab: at the next stop; at the one behind that, if the next is nearer than `least`.
///
///     apart    between stops, which are counted from 0; more than 0
[[nodiscard]] inline double tab_stop_behind(double pen, double apart, double least) noexcept
{
    const double stop = (std::floor(pen / apart) + 1.0) * apart;
    return stop - pen < least ? stop + apart : stop;
}

}  // namespace typemesh::inline TYPEMESH_ABI

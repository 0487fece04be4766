// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/tab_stop.hpp>

#include <cstdint>
#include <limits>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A width into which fits what was measured to be as wide, whatever was rounded: wider by 10^-12 of it.
[[nodiscard]] constexpr double widened(double width) noexcept { return width + 1e-12 * width; }

/// How much room lines have, in font units.
struct line_room {
    double width = std::numeric_limits<double>::infinity();
    double indent = 0.0;                 ///< of a paragraph's first line
    double shrink = 0.0;                 ///< by which part of their width spaces may be narrower, so that more fits
    double tab = 0.0;                    ///< between tab stops; 0: a tab has no width
    double least_tab = 0.0;              ///< stops that are nearer to the pen are passed over
    std::span<const double> stops = {};  ///< tab stops of their own before those, ascending, times `stop_unit`
    double stop_unit = 1.0;
    std::uint32_t max_lines = 0xFFFF'FFFFu;  ///< breakers need not find more

    /// Where the pen stands when a line begins.
    [[nodiscard]] double start(bool begins_paragraph) const noexcept { return begins_paragraph ? indent : 0.0; }

    /// Where it goes on behind a tab: at the next stop.
    [[nodiscard]] double after_tab(double pen) const noexcept
    {
        for (const double stop : stops)
            if (stop * stop_unit > pen && stop * stop_unit - pen >= least_tab) return stop * stop_unit;
        return tab > 0.0 ? tab_stop_behind(pen, tab, least_tab) : pen;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

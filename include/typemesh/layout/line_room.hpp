// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/tab_stop.hpp>

#include <cstdint>
#include <limits>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A width that text of the given width fits into in spite of rounding: it is greater by 10^-12 of the width.
[[nodiscard]] constexpr double widened(double width) noexcept { return width + 1e-12 * width; }

/// The space that lines have, in font units.
struct line_room {
    double width = std::numeric_limits<double>::infinity();
    double indent = 0.0;                 ///< the indent of a paragraph's first line
    double shrink = 0.0;                 ///< the fraction of their width by which spaces may shrink, so that more text
                                         ///< fits
    double tab = 0.0;                    ///< the distance between tab stops; 0: a tab has no width
    double least_tab = 0.0;              ///< tab stops nearer to the pen than this are skipped
    std::span<const double> stops = {};  ///< explicit tab stops before the regular ones, ascending, to be multiplied by
                                         ///< `stop_unit`
    double stop_unit = 1.0;
    std::uint32_t max_lines = 0xFFFF'FFFFu;  ///< breakers need not find more lines than this

    /// The pen at the start of a line.
    [[nodiscard]] double start(bool begins_paragraph) const noexcept { return begins_paragraph ? indent : 0.0; }

    /// The pen after a tab: the next stop.
    [[nodiscard]] double after_tab(double pen) const noexcept
    {
        for (const double stop : stops)
            if (stop * stop_unit > pen && stop * stop_unit - pen >= least_tab) return stop * stop_unit;
        return tab > 0.0 ? tab_stop_behind(pen, tab, least_tab) : pen;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

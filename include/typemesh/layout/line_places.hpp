// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/layout/alignment.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaper.hpp>

#include <cstddef>

namespace typemesh {

/// How shaped lines are put together.
struct layout_options {
    alignment align = alignment::left;
    double line_spacing = 1.0;  ///< times the font's own distance between lines; any finite number
    double tab_width = 4.0;     ///< between tab stops, in spaces; 0: a tab is like other characters (see shape_line())
};

/// What of them is out of range, or none.
[[nodiscard]] inline error trouble_of(const layout_options& options) noexcept
{
    if (!is_finite(options.line_spacing)) return error::bad("line_spacing");
    if (!is_finite(options.tab_width) || options.tab_width < 0.0) return error::bad("tab_width");
    return {};
}

/// Where the lines of a text stand; see layout().
class line_places {
public:
    line_places(const line_metrics& metrics, double units_per_em, direction way, const layout_options& options) noexcept
        : vertical_{way == direction::top_to_bottom}, align_{options.align}
    {
        const double measured = metrics.ascender - metrics.descender + metrics.gap;
        distance_ = (measured > 0.0 ? measured : units_per_em) * options.line_spacing;
    }

    /// How far a line runs, from the way of its pen; never negative.
    [[nodiscard]] double advance(point way) const noexcept
    {
        const double along = vertical_ ? -way.y : way.x;
        return along > 0.0 ? along : 0.0;
    }

    /// Where a line begins, from how far it runs. Lines count from 0.
    [[nodiscard]] point origin(std::size_t line, double advance) const noexcept
    {
        const double back = align_ == alignment::left ? 0.0 : align_ == alignment::centre ? advance / 2 : advance;
        const double across = 0.0 - distance_ * static_cast<double>(line);
        return vertical_ ? point{across, back} : point{0.0 - back, across};
    }

private:
    bool vertical_;
    alignment align_;
    double distance_;
};

}  // namespace typemesh

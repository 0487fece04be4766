// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaper.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// The positions of the lines of a text; see layout().
class line_places {
public:
    /// `rightwards`: each column is to the right of the previous one.
    line_places(const line_metrics& metrics, double units_per_em, direction flow, const layout_options& options,
                bool rightwards = false) noexcept
        : vertical_{flow == direction::top_to_bottom}, align_{options.align}
    {
        const double measured = metrics.ascender - metrics.descender + metrics.gap;
        distance_ = (measured > 0.0 ? measured : units_per_em) * options.line_spacing;
        if (rightwards) distance_ = 0.0 - distance_;
    }

    /// The length of a line, from the offset of its pen; never negative.
    [[nodiscard]] double advance(point total) const noexcept
    {
        const double along = vertical_ ? -total.y : total.x;
        return along > 0.0 ? along : 0.0;
    }

    /// The start of a line, from its length. Lines are numbered from 0.
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

}  // namespace typemesh::inline TYPEMESH_ABI

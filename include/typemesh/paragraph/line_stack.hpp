// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/paragraph/paragraph_options.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// Where the lines of a paragraph stand, one below the other, or its columns, one to the left of the other. In font
/// units.
class line_stack {
public:
    line_stack(const line_metrics& metrics, double units_per_em, const paragraph_options& options, std::size_t lines,
               bool down) noexcept
        : down_{down}
    {
        const double measured = metrics.ascender - metrics.descender + metrics.gap;
        distance_ = (measured > 0.0 ? measured : units_per_em) * options.line_spacing;
        const double all = lines == 0 ? 0.0 : distance_ * static_cast<double>(lines - 1);
        const double height = options.height * units_per_em;
        switch (options.anchor) {
        case vertical_anchor::first_baseline: break;
        case vertical_anchor::last_baseline: first_ = all; break;
        case vertical_anchor::top: first_ = 0.0 - metrics.ascender; break;
        case vertical_anchor::middle: first_ = (all - height - metrics.ascender - metrics.descender) / 2; break;
        case vertical_anchor::bottom: first_ = all - height - metrics.descender; break;
        }
    }

    /// The place of a line's pen, `along` the line.
    [[nodiscard]] point at(std::size_t line, double along) const noexcept
    {
        const double across = first_ - distance_ * static_cast<double>(line);
        return down_ ? point{across, 0.0 - along} : point{along, across};
    }

private:
    bool down_;
    double distance_ = 0.0;
    double first_ = 0.0;
};

}  // namespace typemesh::inline TYPEMESH_ABI

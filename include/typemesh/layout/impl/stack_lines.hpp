// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/layout/laid_line.hpp>
#include <typemesh/layout/layout_options.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The direction in which lines follow each other.
enum class line_stack : std::uint8_t {
    downwards,   ///< lines, each below the previous one
    leftwards,   ///< columns
    rightwards,  ///< columns of Mongolian
};

/// Places the lines of a paragraph one below the other, or its columns beside each other. It sets the origin of each,
/// from its metrics. The distance between two baselines is the extent of each line towards the other, plus half of both
/// gaps, or one em if that is not positive; then it is multiplied by line_spacing. `top` is the edge where the text
/// begins. In columns that go to the right this is the first column's descender, on the left.
///
/// Returns their total height, from the first line's outer edge to the last line's, in font units.
inline double stack_lines(array_view<laid_line> lines, double units_per_em, const layout_options& options,
                          line_stack way) noexcept
{
    if (lines.empty()) return 0.0;
    const auto before = [way](const line_metrics& m) noexcept {  // towards the previous lines
        return way == line_stack::rightwards ? 0.0 - m.descender : m.ascender;
    };
    const auto after = [way](const line_metrics& m) noexcept {
        return way == line_stack::rightwards ? m.ascender : 0.0 - m.descender;
    };
    double natural = 0.0;  // from the first baseline, before line_spacing
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (k > 0) {
            const line_metrics &above = lines[k - 1].metrics, &below = lines[k].metrics;
            const double distance = before(below) + after(above) + (above.gap + below.gap) / 2;
            natural += distance > 0.0 ? distance : units_per_em;
        }
        lines[k].origin.y = natural * options.line_spacing;
    }
    const double all = lines.back().origin.y, height = options.height * units_per_em;
    const double first_edge = before(lines.front().metrics), last_edge = after(lines.back().metrics);
    double first = 0.0;
    switch (options.anchor) {
    case vertical_anchor::first_baseline: break;
    case vertical_anchor::last_baseline: first = all; break;
    case vertical_anchor::top: first = 0.0 - first_edge; break;
    case vertical_anchor::middle: first = (all - height - first_edge + last_edge) / 2; break;
    case vertical_anchor::bottom: first = all - height + last_edge; break;
    }
    for (laid_line& line : lines) {
        const double across = first - line.origin.y;
        line.origin = way == line_stack::downwards    ? point{0.0, across}
                      : way == line_stack::rightwards ? point{0.0 - across, 0.0}
                                                      : point{across, 0.0};
    }
    return first_edge + all + last_edge;
}

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/paragraph/laid_line.hpp>
#include <typemesh/paragraph/paragraph_options.hpp>

#include <cstddef>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Puts the lines of a paragraph one below the other, or its columns one to the left of the other: sets the origin of
/// each, from its metrics. Between two baselines is what hangs from the first, what rises from the second and half of
/// either's gap, or one em if that is not positive; times line_spacing.
///
/// Returns how high they are together, from the first one's ascender to the last one's descender, in font units.
inline double stack_lines(std::span<laid_line> lines, double units_per_em, const paragraph_options& options,
                          bool down) noexcept
{
    if (lines.empty()) return 0.0;
    double natural = 0.0;  // from the first baseline, before line_spacing
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (k > 0) {
            const line_metrics &above = lines[k - 1].metrics, &below = lines[k].metrics;
            const double distance = below.ascender - above.descender + (above.gap + below.gap) / 2;
            natural += distance > 0.0 ? distance : units_per_em;
        }
        lines[k].origin.y = natural * options.line_spacing;
    }
    const double all = lines.back().origin.y, height = options.height * units_per_em;
    const double ascender = lines.front().metrics.ascender, descender = lines.back().metrics.descender;
    double first = 0.0;
    switch (options.anchor) {
    case vertical_anchor::first_baseline: break;
    case vertical_anchor::last_baseline: first = all; break;
    case vertical_anchor::top: first = 0.0 - ascender; break;
    case vertical_anchor::middle: first = (all - height - ascender - descender) / 2; break;
    case vertical_anchor::bottom: first = all - height - descender; break;
    }
    for (laid_line& line : lines) {
        const double across = first - line.origin.y;
        line.origin = down ? point{across, 0.0} : point{0.0, across};
    }
    return ascender + all - descender;
}

}  // namespace typemesh::inline TYPEMESH_ABI

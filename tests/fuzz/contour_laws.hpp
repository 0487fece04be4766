// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include <typemesh/core/outline.hpp>

#include <cstdint>

namespace fuzz {

/// In each contour a curve begins at the end of the one before it, the first at the end of the last; all are in bounds.
inline broken_law of_contours(const typemesh::outline& o)
{
    for (std::uint32_t k = 0; k < o.contour_count(); ++k) {
        if (o.starts[k + 1] <= o.starts[k]) return "a contour without a curve";
        typemesh::point at = o.curves[o.starts[k + 1] - 1].end();
        for (std::uint32_t i = o.starts[k]; i < o.starts[k + 1]; ++i) {
            const typemesh::curve& c = o.curves[i];
            if (!(c.start() == at)) return "a contour is open";
            at = c.end();
            for (std::uint32_t j = 0; j <= c.degree; ++j)
                if (!(c.p[j].x >= o.bounds.low.x && c.p[j].x <= o.bounds.high.x && c.p[j].y >= o.bounds.low.y &&
                      c.p[j].y <= o.bounds.high.y))
                    return "a point is beyond the bounds";
        }
    }
    return {};
}

}  // namespace fuzz

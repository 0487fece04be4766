// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/outline/outline_recorder.hpp>

#include <algorithm>

namespace test {

/// Whether two outlines have the same contours and bounds, curve by curve and point by point.
inline bool same_curves(const typemesh::outline& a, const typemesh::outline& b)
{
    return std::ranges::equal(a.starts, b.starts) && a.bounds.low == b.bounds.low && a.bounds.high == b.bounds.high &&
           std::ranges::equal(a.curves, b.curves, [](const typemesh::curve& c, const typemesh::curve& d) {
               return c.degree == d.degree && std::ranges::equal(c.p, d.p);
           });
}

}  // namespace test

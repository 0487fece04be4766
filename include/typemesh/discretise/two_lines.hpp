// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/discretise/discretiser.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A discretiser that replaces every curve by two lines, which meet at t = 1/2: the lowest quality of the thesis,
/// exactly as published.
///
/// It keeps no tolerance and ignores the tolerance argument: on real fonts, lines deviate from their curves by up to
/// 1/20 em.
struct two_lines {
    static constexpr bool keeps_no_tolerance = true;
    template <class Put>
    void operator()(const quadratic& q, double, Put&& put) const noexcept
    {
        put(0.25 * (q.p0 + q.p2) + 0.5 * q.p1, 0.5);
        put(q.p2, 1.0);
    }

    template <class Put>
    void operator()(const cubic& q, double, Put&& put) const noexcept
    {
        put(0.125 * (q.p0 + q.p3) + 0.375 * (q.p1 + q.p2), 0.5);
        put(q.p3, 1.0);
    }
};
static_assert(discretiser<two_lines>);

}  // namespace typemesh::inline TYPEMESH_ABI

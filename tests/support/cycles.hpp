// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/region.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace test {

/// A region's boundary cycles with curve and t of every edge, each from its smallest visit, sorted: equal exactly if the
/// cycles are equal.
using cycle = std::vector<std::array<double, 5>>;

inline std::vector<cycle> cycles_of(const typemesh::region& r)
{
    std::vector<cycle> all;
    for (std::uint32_t l = 0; l < r.loop_count(); ++l) {
        cycle c;
        for (std::uint32_t i = r.starts()[l]; i < r.starts()[l + 1]; ++i) {
            const typemesh::contour_edge e = r.edges()[i];
            c.push_back({double(r.points()[i].x), double(r.points()[i].y), double(e.curve), e.t0, e.t1});
        }
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        all.push_back(c);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace test

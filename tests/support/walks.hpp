// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/region.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace test {

/// A region's walks with curve and t of every edge, each from its smallest visit on, in order: equal exactly when the
/// walks are the same circles.
using walk = std::vector<std::array<double, 5>>;

inline std::vector<walk> walks_of(const typemesh::region& r)
{
    std::vector<walk> all;
    for (std::uint32_t l = 0; l < r.loop_count(); ++l) {
        walk w;
        for (std::uint32_t i = r.starts()[l]; i < r.starts()[l + 1]; ++i) {
            const typemesh::contour_edge e = r.edges()[i];
            w.push_back({double(r.points()[i].x), double(r.points()[i].y), double(e.curve), e.t0, e.t1});
        }
        std::rotate(w.begin(), std::min_element(w.begin(), w.end()), w.end());
        all.push_back(w);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

// Whether triangles are Delaunay, and sets of triangles to compare.

#include "support/regions.hpp"

#include <typemesh/core/region.hpp>
#include <typemesh/inspect/delaunay_check.hpp>
#include <typemesh/offset/impl/int128.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace test::oracle {

using int128 = typemesh::detail::int128;

/// Why triangles that obey all other laws are not Delaunay, or nothing.
inline std::string broken_delaunay(const typemesh::region& r, std::span<const typemesh::triangle> triangles)
{
    return check_delaunay(r, triangles).broken();
}

/// The triangles by the numbers of their points, each from its smallest, sorted: equal if the sets are equal.
inline std::vector<std::array<std::uint32_t, 3>> as_set(std::span<const typemesh::triangle> triangles)
{
    std::vector<std::array<std::uint32_t, 3>> set;
    set.reserve(triangles.size());
    for (const typemesh::triangle t : triangles) {
        if (t.a < t.b && t.a < t.c)
            set.push_back({t.a, t.b, t.c});
        else if (t.b < t.c)
            set.push_back({t.b, t.c, t.a});
        else
            set.push_back({t.c, t.a, t.b});
    }
    std::sort(set.begin(), set.end());
    return set;
}

using placed_triangle = std::array<grid_point, 3>;

inline bool operator_less(const placed_triangle& s, const placed_triangle& t)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (!(s[i] == t[i])) return comes_first(s[i], t[i]);
    return false;
}

/// The triangles as places, each from its smallest corner, sorted: equal if the sets are equal, whatever the numbers of
/// the points.
inline std::vector<placed_triangle> as_set(std::span<const grid_point> points,
                                           std::span<const typemesh::triangle> triangles)
{
    std::vector<placed_triangle> set;
    for (const typemesh::triangle t : triangles) {
        placed_triangle p{points[t.a], points[t.b], points[t.c]};
        std::rotate(p.begin(), (std::min_element)(p.begin(), p.end(), comes_first), p.end());
        set.push_back(p);
    }
    std::sort(set.begin(), set.end(), operator_less);
    return set;
}

}  // namespace test::oracle

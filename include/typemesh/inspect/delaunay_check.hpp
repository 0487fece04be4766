// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

namespace detail {

/// A sum of products that exceeds 64 bits, in signed digits of 2^30, for compilers without a 128-bit type.
struct long_number {
    std::int64_t digits[6] = {};  // lowest first

    /// Adds a * b. |a|, |b| < 2^61.
    constexpr void add_product(std::int64_t a, std::int64_t b) noexcept
    {
        constexpr std::int64_t base = std::int64_t{1} << 30;
        const std::int64_t p[3] = {a % base, a / base % base, a / base / base},
                           q[3] = {b % base, b / base % base, b / base / base};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t product = p[i] * q[k];  // below 2^60
                digits[i + k] += product % base;
                if (product / base != 0) digits[i + k + 1] += product / base;
            }
    }
    /// -1, 0 or 1.
    [[nodiscard]] constexpr int sign() const noexcept
    {
        constexpr std::int64_t base = std::int64_t{1} << 30;
        std::int64_t carry = 0;
        bool rest = false;
        for (const std::int64_t d : digits) {
            const std::int64_t sum = d + carry;
            const std::int64_t lower = (sum % base + base) % base;
            carry = (sum - lower) / base;
            rest = rest || lower != 0;
        }
        return carry < 0 ? -1 : carry > 0 || rest ? 1 : 0;
    }
};

}  // namespace detail

/// The position of d relative to the circle through a, b, c (counter-clockwise): 1 inside, 0 on it, -1 outside. It is
/// the textbook determinant, exact for |coordinate| <= 2^28.
[[nodiscard]] constexpr int circle_side(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    const std::int64_t ax = std::int64_t{a.x} - d.x, ay = std::int64_t{a.y} - d.y, bx = std::int64_t{b.x} - d.x,
                       by = std::int64_t{b.y} - d.y;
    const std::int64_t cx = std::int64_t{c.x} - d.x, cy = std::int64_t{c.y} - d.y;
    detail::long_number determinant;
    determinant.add_product(ax * ax + ay * ay, bx * cy - by * cx);
    determinant.add_product(bx * bx + by * by, cx * ay - cy * ax);
    determinant.add_product(cx * cx + cy * cy, ax * by - ay * bx);
    return determinant.sign();
}

/// The order that decides ties: by x, then by y.
[[nodiscard]] constexpr bool comes_first(grid_point a, grid_point b) noexcept
{
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

/// The inner edges that do not belong to the constrained Delaunay triangulation.
struct delaunay_check {
    std::size_t inner_edges = 0;   ///< the number of examined edges, which have a triangle on both sides
    std::size_t not_delaunay = 0;  ///< the number of edges whose far corner lies inside the circumcircle of the near
                                   ///< triangle
    std::size_t wrong_ties = 0;    ///< the number of diagonals of four cocircular corners that do not end at the
                                   ///< smallest corner (x, then y)

    /// A description of the first fault; "" if there is none.
    [[nodiscard]] constexpr const char* broken() const noexcept
    {
        if (not_delaunay != 0) return "an edge is not Delaunay";
        if (wrong_ties != 0) return "a diagonal of cocircular points does not end at the smallest";
        return "";
    }
};

/// Tests each edge between two triangles. Precondition: the triangles pass check_cap() (see cap_check.hpp).
///
/// Exact. Cost: O(n log n) for n triangles
[[nodiscard]] inline delaunay_check check_delaunay(const region& r, std::span<const triangle> triangles)
{
    const auto points = r.points();
    struct side_of_edge {
        std::uint64_t edge;  // both ends, the smaller number first
        std::uint32_t apex;
    };
    std::vector<side_of_edge> sides;
    sides.reserve(3 * triangles.size());
    const auto add = [&](std::uint64_t p, std::uint64_t q, std::uint32_t apex) {
        sides.push_back({(std::min)(p, q) << 32 | (std::max)(p, q), apex});
    };
    for (const triangle t : triangles) {
        add(t.a, t.b, t.c);
        add(t.b, t.c, t.a);
        add(t.c, t.a, t.b);
    }
    std::sort(sides.begin(), sides.end(), [](const side_of_edge& s, const side_of_edge& t) { return s.edge < t.edge; });
    delaunay_check found;
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].edge != sides[i - 1].edge) continue;
        ++found.inner_edges;
        const std::uint64_t edge = sides[i].edge;
        grid_point a = points[static_cast<std::uint32_t>(edge >> 32)], b = points[edge & 0xFFFF'FFFFu];
        const grid_point c = points[sides[i].apex], d = points[sides[i - 1].apex];
        if (side(a, b, c) < 0) std::swap(a, b);
        const int where = circle_side(a, b, c, d);
        if (where > 0) ++found.not_delaunay;
        if (where != 0) continue;
        const grid_point smallest = (std::min)({a, b, c, d}, comes_first);
        if (!(smallest == a) && !(smallest == b)) ++found.wrong_ties;
    }
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect

// SPDX-License-Identifier: MIT
#pragma once

// A region swept inwards with joins, compared with the same region with mitred corners: they differ only near the joins.

#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/monotone.hpp>
#include "support/segments.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// Compares the boundaries of both caps outside the discs of 4 widths round all corners with joins. A corner with a longer
/// mitre has such discs along its whole mitre.
class joined_offsets {
public:
    static constexpr double limit = 2.0;  ///< of mitres, in widths

    bool refused = false;          ///< one of the sweeps was, because it crosses on the grid
    std::size_t corners = 0;       ///< corners with joins
    std::size_t compared = 0;      ///< points of both boundaries outside the discs
    std::size_t left_out = 0;      ///< points within them
    double farthest = 0.0;         ///< distance of a compared point from the other boundary, in cells
    typemesh::grid_point where{};  ///< that point
    std::string failed;            ///< why there is nothing to compare, or empty

    /// To check that a difference is noticed:
    ///
    ///     beyond    how much farther the mitred sweep goes, in cells
    ///     radius    of the discs, in widths
    explicit joined_offsets(const typemesh::region& r, double width, double beyond = 0.0, double radius = 4.0)
        : width_{width}, radius_{radius}
    {
        typemesh::swept_region joined, mitred;
        if (!sweep(r, width, limit, joined) || !sweep(r, width + beyond, 0.0, mitred)) return;
        for (const auto& j : joined.joins) add_corner(r, j.point);
        for (const auto& j : mitred.joins) add_corner(r, j.point);
        const auto a = sides_of(joined), b = sides_of(mitred);
        compare(a, b);
        compare(b, a);
    }

private:
    using place = typemesh::point;
    struct side {
        place from, to;
    };

    bool sweep(const typemesh::region& r, double width, double mitre_limit, typemesh::swept_region& out)
    {
        using namespace typemesh;
        workspace space;
        triangle_list triangles;
        error e = monotone{}(r, space, triangles);
        if (!e) {
            workspace::scope scratch{space};
            const double levels[] = {0.0, width};
            sweep_options how;
            how.levels = levels;
            how.mitre_limit = mitre_limit;
            e = sweep_inwards(r, triangles.view(), how, scratch, out);
        }
        if (e.code == error::crossing_contours)
            refused = true;
        else if (e)
            failed = e.message();
        return !e;
    }

    /// Adds the way of the mitre's tip at a corner of the region, unless it is known.
    void add_corner(const typemesh::region& r, std::uint32_t corner)
    {
        if (!seen_.empty() && std::find(seen_.begin(), seen_.end(), corner) != seen_.end()) return;
        seen_.push_back(corner);
        ++corners;
        std::uint32_t loop = 0;
        while (corner >= r.starts()[loop + 1]) ++loop;
        const std::uint32_t first = r.starts()[loop], end = r.starts()[loop + 1];
        const place at = as_place(r.points()[corner]),
                    before = as_place(r.points()[corner == first ? end - 1 : corner - 1]),
                    after = as_place(r.points()[corner + 1 == end ? first : corner + 1]);
        const place in = unit(before, at), out = unit(at, after);
        const double turn = 1.0 + in.x * out.x + in.y * out.y;
        const double scale = turn > 1e-12 ? width_ / turn : 0.0;  // a needle gets joins in either sweep
        ways_.push_back({at, {at.x - scale * (in.y + out.y), at.y + scale * (in.x + out.x)}});
    }

    static place as_place(typemesh::grid_point p) { return {double(p.x), double(p.y)}; }
    static place unit(place from, place to) { return 1.0 / length(to - from) * (to - from); }
    static std::vector<side> sides_of(const typemesh::swept_region& s)
    {
        std::vector<side> sides;
        for (std::uint32_t k = 0; k < s.cap.contour_count(); ++k) {
            const std::uint32_t first = s.cap.starts[k], end = s.cap.starts[k + 1];
            for (std::uint32_t i = first; i < end; ++i)
                sides.push_back({as_place(s.cap.points[i]), as_place(s.cap.points[i + 1 == end ? first : i + 1])});
        }
        return sides;
    }
    [[nodiscard]] bool is_left_out(place p) const
    {
        for (const side& way : ways_)
            if (distance_to_segment(p, way.from, way.to) <= radius_ * width_) return true;
        return false;
    }

    /// Compares points on the sides of one boundary, both ends included, with the sides of the other.
    void compare(const std::vector<side>& own, const std::vector<side>& other)
    {
        constexpr int pieces = 4;
        for (const side& s : own)
            for (int i = 0; i < pieces; ++i) {
                const place p = lerp(s.from, s.to, double(i) / pieces);
                if (is_left_out(p)) {
                    ++left_out;
                    continue;
                }
                ++compared;
                double nearest = 1e9;
                for (const side& o : other) nearest = (std::min)(nearest, distance_to_segment(p, o.from, o.to));
                if (nearest <= farthest) continue;
                farthest = nearest;
                where = {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)};
            }
    }

    double width_, radius_;
    std::vector<std::uint32_t> seen_;
    std::vector<side> ways_;
};

}  // namespace test

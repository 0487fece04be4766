// SPDX-License-Identifier: MIT
#pragma once

// What a sweep inwards gives as long as nothing meets: every corner moves along its bisector. For tests of bevels that
// rest on no other stage. Corners turned away from the interior get joins, if these are on.

#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/offset/sweep_inwards.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace sweeps {

using namespace typemesh;

/// It does not look whether edges meet, and leaves out the cap.
struct plain_sweep {
    void operator()(const region& r, const sweep_options& reach, swept_region& out) const
    {
        std::vector<corner> corners = corners_of(r, reach, out);
        for (const double level : reach.levels) push(out.levels, level);
        for (const grid_point p : r.points()) push(out.nodes, swept_node{p, 0.0f});
        for (std::uint32_t k = 0; k < reach.levels.size(); ++k) {
            push(out.at_level, static_cast<std::uint32_t>(out.edges_at.size()));
            const std::vector<corner> before = corners;
            if (k != 0) {
                for (corner& c : corners) c.node = add(out, c, reach.levels[k]);
            }
            for (std::uint32_t i = 0; i < corners.size(); ++i) {
                const std::uint32_t next = corners[i].next, a = corners[i].node, b = corners[next].node;
                if (a != b) push(out.edges_at, swept_edge_at{corners[i].edge, a, b});
                if (k == 0) continue;
                push(out.cells, swept_cell{corners[i].edge, k - 1, static_cast<std::uint32_t>(out.triangles.size())});
                if (before[i].node != before[next].node)
                    push(out.triangles, triangle{before[i].node, before[next].node, b});
                push(out.triangles, triangle{before[i].node, b, a});
            }
        }
        push(out.cells, swept_cell{0, static_cast<std::uint32_t>(reach.levels.size() - 1),
                                   static_cast<std::uint32_t>(out.triangles.size())});
        push(out.at_level, static_cast<std::uint32_t>(out.edges_at.size()));
    }

private:
    /// Where two edges meet, the latter being `edge`.
    struct corner {
        grid_point at;
        point speed;
        std::uint32_t edge, next, node, point_index;
    };

    template <class T>
    static void push(buffer<T>& b, T value)
    {
        if (!b.push_back(value)) std::abort();
    }

    static point speed_of(point m, point n) { return (1.0 / (1.0 + dot(m, n))) * (m + n); }

    static std::vector<corner> corners_of(const region& r, const sweep_options& reach, swept_region& out)
    {
        std::vector<corner> all;
        const auto points = r.points();
        const auto n = static_cast<std::uint32_t>(points.size());
        for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
            const std::uint32_t begin = r.starts()[loop], end = r.starts()[loop + 1];
            const auto first = static_cast<std::uint32_t>(all.size());
            for (std::uint32_t i = begin; i < end; ++i) {
                const grid_point a = points[i == begin ? end - 1 : i - 1], b = points[i],
                                 c = points[i + 1 == end ? begin : i + 1];
                std::vector<point> inward{-1.0 * wall_normal(a, b)};
                const point last = -1.0 * wall_normal(b, c);
                const double turn = std::atan2(cross(inward[0], last), dot(inward[0], last));
                const bool joined =
                    turn < 0.0 && reach.mitre_limit > 0.0 && std::cos(turn / 2.0) * reach.mitre_limit < 1.0;
                const int joins = !joined ? 0 : reach.tolerance > 0.0 ? 7 : 1;
                for (int j = 1; j <= joins; ++j) {
                    const double angle = turn * j / (joins + 1);
                    const point m = inward[0];
                    inward.push_back(
                        {m.x * std::cos(angle) - m.y * std::sin(angle), m.x * std::sin(angle) + m.y * std::cos(angle)});
                    push(out.joins, swept_join{i, rounded(inward.back())});
                }
                inward.push_back(last);
                for (std::size_t j = 1; j < inward.size(); ++j) {
                    const bool own = j + 1 == inward.size();
                    const auto join =
                        static_cast<std::uint32_t>(out.joins.size() - static_cast<std::size_t>(joins) + j - 1);
                    all.push_back({b, speed_of(inward[j - 1], inward[j]), own ? i : n + join,
                                   static_cast<std::uint32_t>(all.size() + 1), i, i});
                }
            }
            all.back().next = first;
        }
        return all;
    }

    static std::uint32_t add(swept_region& out, const corner& c, double distance)
    {
        const double x = c.at.x + distance * c.speed.x, y = c.at.y + distance * c.speed.y;
        push(out.nodes,
             swept_node{{static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))},
                        static_cast<float>(distance)});
        return static_cast<std::uint32_t>(out.nodes.size() - 1);
    }
};

}  // namespace sweeps

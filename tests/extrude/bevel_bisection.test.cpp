// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_bisection.hpp>

#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/impl/bevel_sweep.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "shapes.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

namespace {

/// The sizes of a map that bends along x, or along a diagonal, so that edges may be so many cells long there.
struct bending_along {
    double x = 1.0, y = 0.0, up = 0.0;
    double most = 20'000.0;

    [[nodiscard]] double of(double dx, double dy, double dz) const
    {
        const double w = (x * std::fabs(dx) + y * std::fabs(dy) + up * std::fabs(dz)) / most;
        return w * w;
    }
    [[nodiscard]] double flat(grid_point p, grid_point q) const { return of(p.x - q.x, p.y - q.y, 0.0); }
    [[nodiscard]] double slope(const detail::raised_point& a, const detail::raised_point& b,
                               const detail::raised_point& c) const
    {
        const auto width = [](double p, double q, double r) { return (std::max)({p, q, r}) - (std::min)({p, q, r}); };
        return of(width(a.at.x, b.at.x, c.at.x), width(a.at.y, b.at.y, c.at.y), width(a.behind, b.behind, c.behind));
    }
    [[nodiscard]] bool turns(const detail::raised_point&, const detail::raised_point&,
                             const detail::raised_point&) const
    {
        return false;
    }
    [[nodiscard]] double span(const detail::raised_point& a, const detail::raised_point& b) const
    {
        return of(a.at.x - b.at.x, a.at.y - b.at.y, a.behind - b.behind);
    }
    [[nodiscard]] double upright(grid_point p, grid_point q, double h) const { return of(p.x - q.x, p.y - q.y, h); }
    [[nodiscard]] double rim(grid_point p, grid_point q) const { return 2.0 * flat(p, q); }
    [[nodiscard]] double outer(grid_point p, grid_point q) const { return flat(p, q); }
};

/// A shape with all edges short enough that they can stay.
shapes::shape in_pieces(const shapes::shape& s, const bending_along& by)
{
    std::vector<std::vector<curve>> outlines;
    for (std::uint32_t k = 0; k < s.contour_count(); ++k) {
        std::vector<point> corners;
        for (std::uint32_t i = s.loops.starts[k]; i < s.loops.starts[k + 1]; ++i) {
            const grid_point p = s.loops.points[i], q = s.loops.points[s.next(i)];
            const int n = 1 + static_cast<int>(1.5 * std::sqrt(by.flat(p, q)));
            for (int j = 0; j < n; ++j)
                corners.push_back((1.0 / 512.0) *
                                  lerp(point{double(p.x), double(p.y)}, {double(q.x), double(q.y)}, double(j) / n));
        }
        outlines.push_back(shapes::polygon(corners));
    }
    return {s.name, {outlines[0]}, {outlines.begin() + 1, outlines.end()}, 1};
}

double area_of(const swept_region& swept)
{
    double twice = 0.0;
    for (const triangle& t : swept.triangles)
        twice += double(orientation(swept.nodes[t.a].at, swept.nodes[t.b].at, swept.nodes[t.c].at));
    for (std::uint32_t k = 0; k < swept.cap.contour_count(); ++k)
        for (std::uint32_t i = swept.cap.starts[k], end = swept.cap.starts[k + 1]; i < end; ++i) {
            const grid_point p = swept.cap.points[i], q = swept.cap.points[i + 1 == end ? swept.cap.starts[k] : i + 1];
            twice += double(p.x) * double(q.y) - double(p.y) * double(q.x);
        }
    return twice;
}

/// The laws of a sweep, after its triangles have been divided.
void check_divided(const swept_region& swept, const swept_region& before, const bending_along& by,
                   const detail::swept_heights& heights)
{
    CHECK(area_of(swept) == area_of(before));  // exact: sums of integers below 2^53
    using edge = std::pair<std::uint32_t, std::uint32_t>;
    std::multiset<edge> sides;
    std::size_t flat = 0, large = 0, wrong_level = 0;
    for (std::size_t c = 0; c + 1 < swept.cells.size(); ++c)
        for (std::uint32_t t = swept.cells[c].first_triangle; t < swept.cells[c + 1].first_triangle; ++t) {
            const triangle& at = swept.triangles[t];
            const std::uint32_t band = swept.cells[c].band;
            const auto raised_at = [&](std::uint32_t n) {
                const double from = swept.levels[band], to = swept.levels[band + 1],
                             share = (double{swept.nodes[n].distance} - from) / (to - from);
                wrong_level += share < -1e-6 || share > 1.0 + 1e-6;
                return detail::raised_point{swept.nodes[n].at,
                                            (1.0 - share) * heights.begin(band) + share * heights.end(band)};
            };
            const detail::raised_point corners[] = {raised_at(at.a), raised_at(at.b), raised_at(at.c)};
            flat += orientation(corners[0].at, corners[1].at, corners[2].at) <= 0;
            large += !(by.slope(corners[0], corners[1], corners[2]) <= 1.0 + 1e-6);
            for (const edge& e : {edge{at.a, at.b}, edge{at.b, at.c}, edge{at.c, at.a}}) sides.insert(e);
        }
    CHECK(flat == 0);
    CHECK(large == 0);
    CHECK(wrong_level == 0);
    // Each side is met by its reverse, by an edge of the region, or by an edge of the cap.
    std::multiset<edge> open;
    for (const edge& e : sides)
        if (sides.count({e.second, e.first}) != sides.count(e)) open.insert(e);
    const std::size_t last = swept.at_level.size() - 2;
    std::multiset<edge> bounds;
    for (const std::size_t k : {std::size_t{0}, last})
        for (std::uint32_t i = swept.at_level[k]; i < swept.at_level[k + 1]; ++i) {
            const swept_edge_at& e = swept.edges_at[i];
            if (sides.count({e.a, e.b}) == sides.count({e.b, e.a})) continue;  // bevels meet in a ridge
            bounds.insert(k == 0 ? edge{e.a, e.b} : edge{e.b, e.a});
            if (k == last) CHECK_QUICKLY(by.rim(swept.nodes[e.a].at, swept.nodes[e.b].at) <= 1.0);
        }
    CHECK(open == bounds);
    REQUIRE(swept.cap.points.size() == swept.cap_nodes.size());
    REQUIRE(swept.cap.points.size() == swept.cap.edges.size());
    for (std::size_t i = 0; i < swept.cap_nodes.size(); ++i)
        CHECK_QUICKLY(swept.nodes[swept.cap_nodes[i]].at == swept.cap.points[i]);
    for (std::size_t i = 0; i < before.nodes.size(); ++i) CHECK_QUICKLY(swept.nodes[i].at == before.nodes[i].at);
}

}  // namespace

TEST_CASE("a bevel's triangles are divided until none is too large, and still fit together",
          "[extrude][bevel_bisection]")
{
    detail::bevel_bisection divide;
    workspace space;
    std::size_t added = 0;
    for (const auto& whole : shapes::several(shapes::rectangle(), shapes::letter_e(), shapes::ring(),
                                             shapes::letter_d(), shapes::ribbon(), shapes::star(), shapes::notch()))
        for (const bending_along by : {bending_along{}, bending_along{0.6, 0.8}, bending_along{0.5, 0.1, 0.5, 9'000.0}})
            for (const double width : {5'000.0, 40'000.0, 300'000.0})
                for (const auto& profile : {chamfer_profile(), round_profile(3), stepped_profile()}) {
                    INFO(whole.name << ", " << width << " cells wide, " << by.x << ' ' << by.y << ' ' << by.up);
                    const auto s = in_pieces(whole, by);
                    const profile_scale scale{width, 20'000.0, 0.0, true};
                    const profile_levels levels{profile.at(scale), scale};
                    const bevel_sweep sweep{.tolerance = 640.0};
                    swept_region before, after;
                    if (sweep(s.made(), s.cap, levels, space, before)) continue;
                    REQUIRE_FALSE(sweep(s.made(), s.cap, levels, space, after));
                    const detail::swept_heights heights{levels, 20'000.0};
                    REQUIRE_FALSE(divide.run(after, heights, by, 1'000'000));
                    check_divided(after, before, by, heights);
                    added += after.nodes.size() - before.nodes.size();
                }
    CHECK(added > 1000);
}

TEST_CASE("slopes are divided only where the map bends", "[extrude][bevel_bisection]")
{
    // Slopes beside upright edges are divided across, slopes beside level edges, which are short already, are not.
    const bending_along by{.most = 10'000.0};
    const auto s = in_pieces(shapes::rectangle(), by);
    workspace space;
    swept_region before, after;
    const profile_levels levels{chamfer_profile().at({15'000.0, 15'000.0, 0.0}), {15'000.0, 15'000.0, 0.0}};
    REQUIRE_FALSE(bevel_sweep{}(s.made(), s.cap, levels, space, before));
    REQUIRE_FALSE(bevel_sweep{}(s.made(), s.cap, levels, space, after));
    detail::bevel_bisection divide;
    const detail::swept_heights heights{levels, 15'000.0};
    REQUIRE_FALSE(divide.run(after, heights, by, 1000));
    check_divided(after, before, by, heights);
    CHECK(after.triangles.size() > before.triangles.size());
    CHECK(after.triangles.size() < before.triangles.size() + 40);
    CHECK(divide.run(before, heights, bending_along{.most = 100.0}, 1000) == error::too_many_points);
    // A map that does not bend needs nothing.
    REQUIRE_FALSE(bevel_sweep{}(s.made(), s.cap, levels, space, before));
    const std::size_t triangles = before.triangles.size();
    REQUIRE_FALSE(divide.run(before, heights, bending_along{.x = 0.0}, 1000));
    CHECK(before.triangles.size() == triangles);
}

TEST_CASE("both triangles of an edge that is flipped belong to the larger one's face, even if nothing is halved",
          "[extrude][bevel_bisection]")
{
    //        .--2--.          Beyond the edge from 0 to 1 lies a thin triangle of another face; its image turns.
    //      0---------1
    //       \__   __/
    //          \3/
    struct turning_sliver : bending_along {
        [[nodiscard]] bool turns(const detail::raised_point& a, const detail::raised_point& b,
                                 const detail::raised_point& c) const
        {
            return (std::min)({a.at.y, b.at.y, c.at.y}) == 0;
        }
    };
    swept_region swept;
    for (const swept_node n : {swept_node{{0, 0}, 0.0f}, {{1000, 0}, 9.0f}, {{500, 10}, 9.0f}, {{500, -400}, 0.0f}})
        REQUIRE(swept.nodes.push_back(n));
    for (const triangle t : {triangle{0, 1, 2}, {0, 3, 1}}) REQUIRE(swept.triangles.push_back(t));
    for (const swept_cell c : {swept_cell{0, 0, 0}, {1, 0, 1}, {2, 0, 2}}) REQUIRE(swept.cells.push_back(c));
    for (const double level : {0.0, 9.0}) REQUIRE(swept.levels.push_back(level));
    for (const swept_edge_at e : {swept_edge_at{1, 0, 3}, {1, 2, 1}}) REQUIRE(swept.edges_at.push_back(e));
    for (const std::uint32_t n : {0u, 1u, 2u}) REQUIRE(swept.at_level.push_back(n));
    const profile_scale scale{9.0, 9.0, 0.0};
    detail::bevel_bisection divide;
    REQUIRE_FALSE(divide.run(swept, {{chamfer_profile().at(scale), scale}, 9.0}, turning_sliver{}, 100));
    REQUIRE((swept.nodes.size() == 4 && swept.triangles.size() == 2));
    CHECK((swept.cells[0].first_triangle == 0 && swept.cells[1].first_triangle == 0));
    CHECK(swept.cells[2].first_triangle == 2);
}

TEST_CASE("dividing a bevel fails cleanly without memory, and needs no more once it is warm",
          "[extrude][bevel_bisection]")
{
    const bending_along by{.most = 5'000.0};
    const auto s = in_pieces(shapes::letter_e(), by);
    const profile_scale scale{15'000.0, 15'000.0, 0.0};
    const profile_levels levels{round_profile(2).at(scale), scale};
    const detail::swept_heights heights{levels, 15'000.0};
    workspace space;
    std::size_t fails = 1;
    for (;; ++fails) {
        test::counting_memory scarce;  // outlives what may hold its memory
        swept_region swept;
        REQUIRE_FALSE(bevel_sweep{}(s.made(), s.cap, levels, space, swept));
        scarce.fail_at = fails;
        detail::bevel_bisection divide{scarce.source()};
        const error e = divide.run(swept, heights, by, 100'000);
        if (!e) break;
        REQUIRE(e == error::out_of_memory);
        REQUIRE(fails < 1000);
    }
    CHECK(fails > 10);
    test::counting_memory counted;
    detail::bevel_bisection divide{counted.source()};
    std::size_t before = 0;
    for (int round = 0; round < 4; ++round) {
        swept_region swept;
        REQUIRE_FALSE(bevel_sweep{}(s.made(), s.cap, levels, space, swept));
        if (round == 3) before = counted.requests;
        REQUIRE_FALSE(divide.run(swept, heights, by, 100'000));
    }
    CHECK(counted.requests == before);
}

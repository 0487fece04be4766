// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/boundary_cutter.hpp>
#include <typemesh/refine/impl/write_cap.hpp>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::boundary_cutter;
using detail::refinable_mesh;

namespace {

/// A lens: its lower edge stands for a curve that bulges downwards, its upper edge is straight but for its middle.
struct bowl {
    std::vector<curve> curves;
    contours loops;
    region filled;
    triangle_list cap;

    /// `sag` is how deep the curve hangs, in units of 512 cells; the chord is 400 units long. The lower edge begins and
    /// ends so far from the curve's ends, in cells. A floor may lie below the bowl, in units.
    explicit bowl(double sag, std::int32_t moved = 0, double floor = 0.0)
    {
        loops.grid = {512.0, 1024.0};
        const point a{0.0, 0.0}, b{400.0, 0.0};
        curves = {curve::from(quadratic{a, {200.0, -2.0 * sag}, b})};
        REQUIRE(loops.starts.push_back(0));
        const auto add = [&](point p, std::uint32_t on, std::int32_t up = 0) {
            grid_point g = loops.grid.snap(p);
            g.y += up;
            REQUIRE(loops.points.push_back(g));
            REQUIRE(loops.edges.push_back({on, 0.0f, 1.0f}));
        };
        add(a, 0, moved);
        add(b, 1, moved);
        if (floor > 0.0) {  // the wall of a slot, open on the left
            add({400.0, -floor}, 1);
            add({0.0, -floor}, 1);
            add({0.0, -300.0}, 1);
            add({500.0, -300.0}, 1);
            add({500.0, 300.0}, 1);
        } else {
            add({400.0, 300.0}, 1);
        }
        add({0.0, 300.0}, 1);
        REQUIRE(loops.starts.push_back(std::uint32_t(loops.points.size())));
        loops.curves = curves;
        filled = region::proven(loops, 0, 1);
        workspace space;
        REQUIRE_FALSE(constrained_delaunay{}(filled, space, cap));
    }

    /// How far a point lies from the place of the curve at t, in cells.
    [[nodiscard]] double off_curve(grid_point p, double t) const
    {
        const point on = loops.grid.cells * curves[0].at(t);
        return std::hypot(on.x - p.x, on.y - p.y);
    }
};

/// Opens a mesh, and splits its first edge once.
struct one_cut {
    refinable_mesh mesh;
    boundary_cutter cut;
    std::uint32_t made = boundary_cutter::none;

    one_cut(const bowl& b, double share, double t)
    {
        REQUIRE(mesh.open(b.filled, b.cap.view()));
        cut.open(b.filled);
        const auto v = cut(mesh, 0, share, t);
        REQUIRE(v);
        made = *v;
    }
};

}  // namespace

TEST_CASE("a cut boundary edge gets a point on its curve, on either side of the chord", "[refine]")
{
    for (const double sag : {30.0, -30.0, 5.0, -0.01})
        for (const double t : {0.5, 0.3, 0.71}) {
            CAPTURE(sag, t);
            const bowl b{sag};
            const one_cut c{b, t, t};
            REQUIRE(c.made != boundary_cutter::none);
            CHECK(b.off_curve(c.mesh.place(c.made), t) < 0.7072);
            CHECK(c.mesh.at(0).edge.t1 == float(t));
            CHECK(c.mesh.at(c.made).edge.t0 == float(t));
            CHECK(c.mesh.at(c.made).edge.t1 == 1.0f);
            CHECK(c.mesh.at(c.made).source == 0);
        }
}

TEST_CASE("a cut edge that does not end on its curve, or whose curve is not free, gets a point on itself", "[refine]")
{
    const auto is_on_chord = [](const one_cut& c, std::int32_t y) {
        const grid_point p = c.mesh.place(c.made);
        return std::abs(p.x - 200 * 512) <= 1 && p.y == y;
    };
    CHECK(is_on_chord(one_cut{bowl{30.0, 3}, 0.5, 0.5}, 3));        // moved by three cells: bold letters
    CHECK_FALSE(is_on_chord(one_cut{bowl{30.0, 1}, 0.5, 0.5}, 1));  // moved by a cell: rounding
    CHECK(is_on_chord(one_cut{bowl{30.0, 0, 20.0}, 0.5, 0.5}, 0));  // the slot's wall lies between chord and curve
    CHECK_FALSE(is_on_chord(one_cut{bowl{30.0, 0, 40.0}, 0.5, 0.5}, 0));
    CHECK(is_on_chord(one_cut{bowl{130.0}, 0.5, 0.5}, 0));  // more than 0.3 of the chord away
    CHECK(is_on_chord(one_cut{bowl{-290.0}, 0.5, 0.5}, 0));
}

TEST_CASE("an edge too short for two halves of four cells is not cut", "[refine]")
{
    std::size_t cut_edges = 0, left = 0;
    for (std::int32_t size = 2; size < 14; ++size) {
        const test::filled_shape shape{test::shape{"square", {test::square(0, 0, size)}}};
        workspace space;
        triangle_list cap;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, cap));
        refinable_mesh mesh;
        REQUIRE(mesh.open(shape.filled, cap.view()));
        boundary_cutter cut;
        cut.open(shape.filled);
        const auto made = cut(mesh, 0, 0.5, 0.5);
        REQUIRE(made);
        CAPTURE(size);
        CHECK((*made == boundary_cutter::none) == (size < 8));
        ++(*made == boundary_cutter::none ? left : cut_edges);
    }
    CHECK(cut_edges == 6);
    CHECK(left == 6);
}

TEST_CASE("cuts at random keep a boundary simple, whatever its curves would do", "[refine]")
{
    // Each edge of random polygons gets a curve of its own, which may cross any other edge.
    test::dice d{51};
    std::size_t beyond = 0, cuts = 0;
    refinable_mesh mesh;
    boundary_cutter cut;
    for (int round = 0; round < 150; ++round) {
        test::shape s{"random polygon", {test::random_polygon(8 + d.roll(20), 12 + d.roll(20), d)}};
        for (grid_point& p : s.loops[0]) p = {300 * p.x, 300 * p.y};
        if (!inspect::is_region(test::loops_of(s))) continue;
        test::filled_shape shape{s};
        const std::size_t n = shape.loops.points.size();
        std::vector<curve> curves;
        contours loops;
        loops.grid = {1.0, 1000.0};
        loops.tolerance = 1e4;
        REQUIRE(loops.points.append(shape.filled.points()));
        REQUIRE(loops.starts.append(shape.filled.starts()));
        for (std::size_t i = 0; i < n; ++i) {
            const grid_point a = loops.points[i], b = loops.points[(i + 1) % n];
            const point from{double(a.x), double(a.y)}, to{double(b.x), double(b.y)}, way = to - from;
            const double bulge = d.fraction() * 1.1 - 0.55;
            curves.push_back(curve::from(quadratic{from, 0.5 * (from + to) + bulge * point{-way.y, way.x}, to}));
            REQUIRE(loops.edges.push_back({std::uint32_t(i), 0.0f, 1.0f}));
        }
        loops.curves = curves;
        const region r = region::proven(loops, 0, 1);
        workspace space;
        triangle_list cap;
        REQUIRE_FALSE(constrained_delaunay{}(r, space, cap));
        REQUIRE(mesh.open(r, cap.view()));
        cut.open(r);
        for (int k = 0; k < 40; ++k) {
            const auto v = static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(mesh.vertex_count())));
            const contour_edge e = mesh.at(v).edge;
            const grid_point a = mesh.place(v), b = mesh.place(mesh.next_on_boundary(v));
            const auto made = cut(mesh, v, 0.5, 0.5 * (double(e.t0) + double(e.t1)));
            REQUIRE(made);
            if (*made == boundary_cutter::none) continue;
            ++cuts;
            beyond += orientation(a, b, mesh.place(*made)) < 0;
        }
        buffer<std::uint32_t> numbers;
        test::refined_result out;
        REQUIRE_FALSE(write_cap(mesh, r, numbers, out.out()));
        INFO(s);
        CHECK(test::broken_refinement(r, out) == "");
        CHECK(test::is_delaunay(out));
    }
    CAPTURE(cuts, beyond);
    CHECK(cuts > 2000);
    CHECK(beyond > 500);
}

TEST_CASE("a curve's parameter is found by the distance from either end", "[refine]")
{
    const bowl b{30.0};
    boundary_cutter cut;
    cut.open(b.filled);
    for (const bool from_first : {true, false})
        for (const double share : {0.0, 0.1, 0.5, 0.9}) {
            const double distance = share * 400.0 * 512.0, t = cut.parameter_at({0, 0.0f, 1.0f}, from_first, distance);
            const point on = b.loops.grid.cells * b.curves[0].at(t),
                        end = b.loops.grid.cells * b.curves[0].at(from_first ? 0.0 : 1.0);
            CHECK(std::hypot(on.x - end.x, on.y - end.y) == Approx(distance).margin(1e-3));
        }
    CHECK(cut.ends_on_curve(0));
    CHECK_FALSE(cut.ends_on_curve(1));  // it names a curve that does not exist
    for (std::uint32_t i = 0; i < 4; ++i) CHECK(cut.next_point(i) == (i + 1) % 4);
    const test::filled_shape rings{test::square_with_holes(2, 5)};
    cut.open(rings.filled);
    const auto starts = rings.filled.starts();
    for (std::uint32_t loop = 0; loop + 1 < starts.size(); ++loop)
        for (std::uint32_t i = starts[loop]; i < starts[loop + 1]; ++i)
            CHECK(cut.next_point(i) == (i + 1 < starts[loop + 1] ? i + 1 : starts[loop]));
}

TEST_CASE("a cut without memory says so", "[refine]")
{
    const bowl b{30.0};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        refinable_mesh mesh{memory.source()};
        if (!mesh.open(b.filled, b.cap.view())) continue;
        boundary_cutter cut{memory.source()};
        cut.open(b.filled);
        error e;
        for (std::uint32_t k = 0; k < 3 && !e; ++k) {
            const auto made = cut(mesh, 0, 0.5, 0.5 * (double(mesh.at(0).edge.t0) + double(mesh.at(0).edge.t1)));
            if (!made) e = made.error();
        }
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
    }
}

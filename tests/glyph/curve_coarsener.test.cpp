// SPDX-License-Identifier: MIT

#include <typemesh/glyph/impl/curve_coarsener.hpp>

#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "extrude/shapes.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/level_laws.hpp"

using namespace typemesh;

namespace {

contours copy_of(const contours& loops, memory source = heap())
{
    contours made{source};
    REQUIRE(made.points.append(loops.points.view()));
    REQUIRE(made.edges.append(loops.edges.view()));
    REQUIRE(made.starts.append(loops.starts.view()));
    made.curves = loops.curves;
    made.grid = loops.grid;
    return made;
}

test::loop_points loops_in(const contours& loops) { return test::loops_with(loops.points.view(), loops.starts.view()); }

/// Whether each edge begins and ends where its curve is at its parameters.
bool ends_on_curves(const contours& loops)
{
    const test::loop_points all = loops_in(loops);
    std::size_t next = 0;
    for (const auto& l : all)
        for (std::size_t i = 0; i < l.size(); ++i) {
            const contour_edge e = loops.edges[next++];
            for (const auto& [p, t] : {std::pair{l[i], e.t0}, std::pair{l[(i + 1) % l.size()], e.t1}}) {
                const point at = loops.grid.cells * loops.curves[e.curve].at(double{t});
                if (length(at - point{double(p.x), double(p.y)}) > 1.0) return false;
            }
        }
    return true;
}

std::size_t points_after(const contours& loops, double tolerance)
{
    contours made = copy_of(loops);
    REQUIRE_FALSE(detail::curve_coarsener{}(made, tolerance));
    return made.points.size();
}

const std::vector<shapes::shape>& curved_shapes()
{
    static const std::vector<shapes::shape> all =
        shapes::several(shapes::ring(32), shapes::letter_d(40), shapes::ribbon(37), shapes::drop(48), shapes::pair(21));
    return all;
}

/// The contours of a shape with more than a thousand points.
contours finely_flattened(const shapes::shape& s)
{
    outline drawn;
    REQUIRE(drawn.curves.append(array_view<const curve>{s.curves}));
    REQUIRE(drawn.starts.append(array_view<const std::uint32_t>{{0, static_cast<std::uint32_t>(s.curves.size())}}));
    contours fine;
    const certified flatten;
    REQUIRE(discretise(drawn, flatten, 0.002, s.loops.grid, fine));
    fine.curves = array_view<const curve>{s.curves};
    return fine;
}

/// A half moon over a line, and a triangle between the two: the hole or, if the moon lies outside it, a second letter.
shapes::shape moon_with_speck(double height, int pieces)
{
    return {"moon",
            {{shapes::cube({0, 0}, {0, 400}, {1000, 400}, {1000, 0}), shapes::line({1000, 0}, {1000, -200}),
              shapes::line({1000, -200}, {0, -200}), shapes::line({0, -200}, {0, 0})}},
            {shapes::polygon({{480, height}, {500, height + 10}, {520, height}})},
            pieces};
}

}  // namespace

TEST_CASE("coarser loops bound a region, keep the tolerance, and lose only points", "[glyph][levels]")
{
    for (const shapes::shape& s : curved_shapes()) {
        contours made = copy_of(s.loops);
        detail::curve_coarsener drop;
        for (const double tolerance : {100.0, 700.0, 3000.0, 12000.0, 60000.0, 1e6}) {
            INFO(s.name << " at " << tolerance);
            const test::loop_points finer = loops_in(made);
            REQUIRE_FALSE(drop(made, tolerance));
            const test::loop_points level = loops_in(made);
            CHECK(test::bound_a_region(level));
            CHECK(test::is_nested_in(level, finer));
            CHECK(made.edges.size() == made.points.size());
            CHECK(ends_on_curves(made));
            CHECK(test::farthest_curve_place(level, made.edges, made.curves, made.grid.cells) <=
                  std::max(tolerance, 200.0));  // 200: of the shapes themselves
        }
        // At last only the ends of curves are left, and what a loop needs to have three points.
        CHECK(made.points.size() <= s.curves.size() + 2);
    }
}

TEST_CASE("a level of a finely flattened curve has hardly more points than certified needs", "[glyph][levels]")
{
    for (const shapes::shape& s : curved_shapes()) {
        outline drawn;
        REQUIRE(drawn.curves.append(array_view<const curve>{s.curves}));
        REQUIRE(drawn.starts.append(array_view<const std::uint32_t>{{0, static_cast<std::uint32_t>(s.curves.size())}}));
        contours fine, fresh;
        const certified flatten;
        REQUIRE(discretise(drawn, flatten, 0.02, s.loops.grid, fine));
        for (const double tolerance : {0.32, 1.28, 5.12}) {  // of 4, 8 and 16 fine chords
            INFO(s.name << " at " << tolerance);
            REQUIRE(discretise(drawn, flatten, tolerance, s.loops.grid, fresh));
            const std::size_t ours = points_after(fine, tolerance * s.loops.grid.cells);
            CHECK(ours <= fresh.points.size() + s.curves.size());
            CHECK(ours + s.curves.size() >= fresh.points.size());
        }
    }
}

TEST_CASE("points stay where a chord would run over another loop", "[glyph][levels]")
{
    for (const double height : {20.0, 150.0, 250.0, 285.0}) {
        const shapes::shape s = moon_with_speck(height, 64);
        contours made = copy_of(s.loops);
        REQUIRE(test::bound_a_region(loops_in(made)));
        REQUIRE_FALSE(detail::curve_coarsener{}(made, 1e6));  // half the height of the letter
        const test::loop_points level = loops_in(made);
        INFO("height " << height);
        CHECK(test::bound_a_region(level));
        REQUIRE(level.size() == 2);
        CHECK(level[0].size() > 4);  // 4: the hole would lie outside
        CHECK(level[0].size() < 10);
    }
}

TEST_CASE("points stay where a hole's chord would run over its letter", "[glyph][levels]")
{
    // Two arcs of a stroke of one unit: the inner chord of a quarter would cross the outer arc's chords.
    const shapes::shape s{"hairline", {shapes::cubic_circle({0, 0}, 400)}, {shapes::cubic_circle({0, 0}, 399)}, 32};
    contours made = copy_of(s.loops);
    for (const double tolerance : {300.0, 2000.0, 20000.0, 1e6}) {
        REQUIRE_FALSE(detail::curve_coarsener{}(made, tolerance));
        CHECK(test::bound_a_region(loops_in(made)));
    }
}

TEST_CASE("corners inside a curve stay", "[glyph][levels]")
{
    const shapes::shape s = shapes::cusp();  // its cubic stops at t = 1/2
    contours made = copy_of(s.loops);
    REQUIRE_FALSE(detail::curve_coarsener{}(made, 1e6));
    CHECK(made.points.size() == 3);
    bool has_cusp = false;
    for (const contour_edge& e : made.edges) has_cusp = has_cusp || same(e.t1, 0.5f);
    CHECK(has_cusp);
}

TEST_CASE("every loop keeps three points, and a point where loops touch stays", "[glyph][levels]")
{
    const shapes::shape lens{
        "lens", {{shapes::quad({0, 0}, {50, 40}, {100, 0}), shapes::quad({100, 0}, {50, -40}, {0, 0})}}, {}, 16};
    CHECK(points_after(lens.loops, 1e6) == 3);
    CHECK(points_after(shapes::drop(16).loops, 1e6) == 3);
    CHECK(points_after(lens.loops, 1e-3) == lens.loops.points.size());

    // The second letter's corner touches the first one's arc.
    const shapes::shape touching{"touching",
                                 {{shapes::quad({0, 0}, {100, 200}, {200, 0}), shapes::line({200, 0}, {0, 0})},
                                  shapes::polygon({{50, 75}, {40, 120}, {20, 120}})},
                                 {},
                                 16};
    contours made = copy_of(touching.loops);
    REQUIRE_FALSE(detail::curve_coarsener{}(made, 1e6));
    std::size_t visits = 0;
    for (const grid_point p : made.points) visits += p == grid_point{25600, 38400};
    CHECK(visits == 2);
    CHECK(made.points.size() < touching.loops.points.size());
}

TEST_CASE("the levels do not depend on where a contour begins, and memory may fail", "[glyph][levels]")
{
    for (const shapes::shape& s : curved_shapes()) {
        INFO(s.name);
        const std::size_t expected = points_after(s.loops, 3000.0);
        for (std::uint32_t turn = 1; turn < 40; turn += 7) {
            contours turned = copy_of(s.loops);
            for (std::uint32_t k = 0; k < turned.contour_count(); ++k) {
                const std::uint32_t first = turned.starts[k], n = turned.starts[k + 1] - first;
                for (std::uint32_t i = 0; i < n; ++i) {
                    turned.points[first + i] = s.loops.points[first + (i + turn) % n];
                    turned.edges[first + i] = s.loops.edges[first + (i + turn) % n];
                }
            }
            REQUIRE_FALSE(detail::curve_coarsener{}(turned, 3000.0));
            CHECK(turned.points.size() == expected);
            CHECK(ends_on_curves(turned));
        }
    }
    const shapes::shape s = shapes::ring(16);
    CHECK(test::check_each_failure([&](memory source) {
              contours made = copy_of(s.loops);
              return detail::curve_coarsener{source}(made, 3000.0);
          }) > 0);
    const contours many = finely_flattened(s);
    REQUIRE(many.points.size() > 512);  // enough for a tree of chunks
    const std::size_t requests = test::check_each_failure([&](memory source) {
        contours made = copy_of(many);
        return detail::curve_coarsener{source}(made, 3000.0);
    });
    CHECK(requests == 6);  // the last one for the tree
    test::counting_memory counted;
    detail::curve_coarsener drop{counted.source()};
    for (int again = 0; again < 2; ++again) {
        contours made = copy_of(s.loops);
        const std::size_t before = counted.requests;
        REQUIRE_FALSE(drop(made, 3000.0));
        if (again == 1) CHECK(counted.requests == before);
    }
}

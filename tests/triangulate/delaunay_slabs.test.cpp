// SPDX-License-Identifier: MIT
//
// The part of constrained_delaunay that is O(n log n) for every region, used for everything: max_flips = 0.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/proving_memory.hpp"

using namespace typemesh;

namespace {

constexpr constrained_delaunay slabs_only{.max_flips = 0};

/// What is wrong with the triangles of this filled shape, or how they differ from those of flips.
std::string difference(const test::shape& s, std::size_t& touching)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = fill(loops, fill_rule::non_zero, space);
    if (!filled) return filled.error() == error::crossing_contours ? "" : filled.error().message();
    touching += filled->is_touching();
    triangle_list flips, slabs;
    if (const error e = constrained_delaunay{}(*filled, space, flips)) return e.message();
    if (const error e = slabs_only(*filled, space, slabs)) return e.message();
    if (auto wrong = test::oracle::broken_law(*filled, slabs.view()); !wrong.empty()) return wrong;
    if (auto wrong = test::oracle::broken_delaunay(*filled, slabs.view()); !wrong.empty()) return wrong;
    return test::oracle::as_set(flips.view()) == test::oracle::as_set(slabs.view()) ? "" : "flips make other triangles";
}

}  // namespace

TEST_CASE("slabs make the same triangles as flips", "[triangulate][delaunay]")
{
    std::size_t touching = 0;
    for (const test::shape& s : test::delaunay_shapes()) {
        for (const double degrees : {0.0, 0.001, 33.0, 90.0, 180.0, 230.0, 270.0}) {
            const test::shape t = test::turned(s, degrees);
            INFO(t.name);
            CHECK(difference(t, touching) == "");
            CHECK(difference(test::mirrored(t), touching) == "");
        }
    }
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        CHECK(difference(c.shape, touching) == "");
    }
}

TEST_CASE("slabs make the same triangles as flips of regions that touch themselves", "[triangulate][delaunay]")
{
    std::size_t touching = 0;
    for (const int rows : {2, 5, 24}) {
        for (const double degrees : {0.0, 90.0, 180.0}) {
            INFO(rows << " turned by " << degrees);
            CHECK(difference(test::turned(test::chess_board(rows), degrees), touching) == "");
        }
    }
    CHECK(touching == 9);
    test::dice d{11};
    for (int i = 0; i < 6000; ++i) {
        const int width = 3 + d.roll(14), count = 1 + d.roll(4);
        const test::shape s = test::random_polylines(d, count, 3, 8, width);
        INFO(s);
        CHECK(difference(s, touching) == "");
    }
    CHECK(touching > 3000);
}

TEST_CASE("slabs make the same triangles as flips of random polygons on tiny grids", "[triangulate][delaunay]")
{
    test::dice d{12};
    std::size_t touching = 0;
    for (int i = 0; i < 3000; ++i) {
        const int width = 4 + d.roll(14), n = 3 + d.roll((std::min)(width * width / 3, 50));
        const test::shape s{"random polygon", {test::random_polygon(n, width, d)}};
        INFO(s);
        CHECK(difference(s, touching) == "");
    }
}

TEST_CASE("slabs take 100,000 points and thousands of holes", "[triangulate][delaunay]")
{
    for (const test::shape& s :
         {test::shape{"parabola", {test::parabola(100'000, true)}},
          test::shape{"rough parabola on its side", {test::rough_parabola(100'000, false)}},
          test::shape{"facing parabolas", {test::facing_parabolas(100'000, true)}},
          test::shape{"random monotone chains", {test::random_monotone(100'000, 4)}},
          test::shape{"sawtooth", {test::sawtooth(50'000, true)}}, test::shape{"comb", {test::comb(30'000, 1 << 20)}},
          test::shape{"star", {test::star(50'000, 2e8, 9)}}, test::nested_squares(10'000, true),
          test::square_with_holes(70, 16), test::circle_with_holes(20'000, 2000), test::chess_board(200),
          test::shape{"spiral", {test::spiral(50'000, 60, 1'000'000)}}}) {
        INFO(s.name);
        const test::meshed m = test::mesh_of(s, slabs_only);
        CHECK(m.mistake == "");
        CHECK(m.triangles.size() > 39'000);
    }
}

TEST_CASE("slabs make the same triangles when flips run out halfway", "[triangulate][delaunay]")
{
    for (const test::shape& s : {test::shape{"circle", {test::circle(5000, 1e8)}}, test::circle_with_holes(3000, 100),
                                 test::shape{"parabola", {test::parabola(3000, true)}}}) {
        const auto expected = test::mesh_of(s, slabs_only).triangles;
        for (const std::uint32_t max_flips : {1u, 2u, 3u, 1000u}) {
            INFO(s.name << ", " << max_flips << " flips a triangle");
            CHECK((test::mesh_of(s, {.max_flips = max_flips}).triangles == expected));
        }
    }
}

TEST_CASE("slabs report that memory ran out, and need none once warm", "[triangulate][delaunay]")
{
    test::check_proving_memory(slabs_only, test::square_with_holes(12, 24));
}

TEST_CASE("slabs take at most 170 bytes of scratch memory a point and 88 a hole", "[triangulate][delaunay]")
{
    for (const test::shape& s : {test::shape{"circle", {test::circle(50'000, 1e8)}},
                                 test::shape{"star", {test::star(50'000, 1e8, 3)}}, test::square_with_holes(60, 8)}) {
        const contours loops = test::contours_of(s);
        INFO(s.name);
        test::check_scratch_memory(slabs_only, loops, 170 * loops.points.size() + 88 * loops.contour_count() + 64 * 64);
    }
}

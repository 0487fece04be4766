// SPDX-License-Identifier: MIT
//
// The way of constrained_delaunay that is O(n log n) whatever the region is, taken for everything: max_flips = 0.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/delaunay_shapes.hpp"

using namespace typemesh;

namespace {

constexpr constrained_delaunay slabs_alone{.max_flips = 0};

/// What is wrong with the triangles of this filled shape, or how they differ from those that flips make.
std::string difference(const test::shape& s, std::size_t& touching)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = fill(loops, fill_rule::non_zero, space);
    if (!filled) return filled.error() == error::crossing_contours ? "" : filled.error().message();
    touching += filled->is_touching();
    triangle_list flips, slabs;
    if (const error e = constrained_delaunay{}(*filled, space, flips)) return e.message();
    if (const error e = slabs_alone(*filled, space, slabs)) return e.message();
    if (auto wrong = test::oracle::broken_law(*filled, slabs.view()); !wrong.empty()) return wrong;
    if (auto wrong = test::oracle::broken_delaunay(*filled, slabs.view()); !wrong.empty()) return wrong;
    return test::oracle::as_set(flips.view()) == test::oracle::as_set(slabs.view()) ? "" : "flips make other triangles";
}

}  // namespace

TEST_CASE("slabs make the triangles that flips make", "[triangulate][delaunay]")
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

TEST_CASE("slabs make the triangles that flips make also of regions that touch themselves", "[triangulate][delaunay]")
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
        test::shape s{"polylines " + std::to_string(i), {}};
        for (int c = 0; c < count; ++c) {
            test::polyline l;
            for (int n = 3 + d.roll(8); n > 0; --n) l.push_back({d.roll(width), d.roll(width)});
            s.loops.push_back(l);
        }
        const std::string wrong = difference(s, touching);
        if (!wrong.empty()) {
            INFO(s);
            CHECK(wrong == "");
        }
    }
    CHECK(touching > 3000);
}

TEST_CASE("slabs make the triangles that flips make of random polygons on tiny grids", "[triangulate][delaunay]")
{
    test::dice d{12};
    std::size_t touching = 0;
    for (int i = 0; i < 3000; ++i) {
        const int width = 4 + d.roll(14), n = 3 + d.roll((std::min)(width * width / 3, 50));
        const test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(n, width, d)}};
        const std::string wrong = difference(s, touching);
        if (!wrong.empty()) {
            INFO(s);
            CHECK(wrong == "");
        }
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
        const test::meshed m = test::mesh_of(s, slabs_alone);
        CHECK(m.mistake == "");
        CHECK(m.triangles.size() > 39'000);
    }
}

TEST_CASE("when flips are spent on the way slabs make the same triangles", "[triangulate][delaunay]")
{
    for (const test::shape& s : {test::shape{"circle", {test::circle(5000, 1e8)}}, test::circle_with_holes(3000, 100),
                                 test::shape{"parabola", {test::parabola(3000, true)}}}) {
        const auto expected = test::mesh_of(s, slabs_alone).triangles;
        for (const std::uint32_t max_flips : {1u, 2u, 3u, 1000u}) {
            INFO(s.name << ", " << max_flips << " flips a triangle");
            CHECK((test::mesh_of(s, {.max_flips = max_flips}).triangles == expected));
        }
    }
}

TEST_CASE("slabs without memory say so, and after warming up ask for none", "[triangulate][delaunay]")
{
    const contours loops = test::contours_of(test::square_with_holes(12, 24));
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out{memory.source()};
        memory.fail_at = nth;
        memory.fail_once = true;
        const result<region> proven = slabs_alone.prove(loops, space, out);
        const bool was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!proven) {
            CHECK(proven.error() == error::out_of_memory);
            CHECK(out.empty());
        }
        out.clear();
        REQUIRE(slabs_alone.prove(loops, space, out));
        const std::size_t warm = memory.requests;
        out.clear();
        REQUIRE(slabs_alone.prove(loops, space, out));
        CHECK(memory.requests == warm);
        if (!was_asked) break;
    }
}

TEST_CASE("slabs take at most 170 bytes of scratch memory a point and 88 a hole", "[triangulate][delaunay]")
{
    for (const test::shape& s : {test::shape{"circle", {test::circle(50'000, 1e8)}},
                                 test::shape{"star", {test::star(50'000, 1e8, 3)}}, test::square_with_holes(60, 8)}) {
        const contours loops = test::contours_of(s);
        const std::size_t wanted = 170 * loops.points.size() + 88 * loops.contour_count() + 64 * 64;
        test::counting_memory memory;
        workspace measured{memory.source()};
        {
            workspace::scope whole{measured};
            REQUIRE(whole.take<char>(wanted) != nullptr);
        }
        const std::size_t before = memory.requests;
        triangle_list out;
        INFO(s.name);
        REQUIRE(slabs_alone.prove(loops, measured, out));
        CHECK(memory.requests == before);
    }
}

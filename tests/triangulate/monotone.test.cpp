// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/proving_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// What is wrong with monotone's answer for a shape: it must accept exactly the regions and obey the laws.
std::string mistake_on(const test::shape& s)
{
    const contours loops = test::contours_of(s);
    workspace space;
    triangle_list out;
    if (!out.push_back({7, 8, 9})) return "no memory";
    const result<region> proven = monotone{}.prove(loops, space, out);
    const bool truth = test::oracle::is_region(test::loops_of(s));
    if (!proven) {
        if (!(proven.error() == error::crossing_contours)) return proven.error().message();
        if (out.size() != 1) return "a refusal left triangles behind";
        return truth ? "refused a region" : "";
    }
    if (!truth) return "accepted what is no region";
    if (std::string law = test::oracle::broken_law(*proven, out.view().subspan(1)); !law.empty()) return law;
    triangle_list trusting;
    if (const error e = monotone{}(*proven, space, trusting)) return e.message();
    return std::equal(trusting.begin(), trusting.end(), out.begin() + 1, out.end()) ? ""
                                                                                    : "trusting differs from proving";
}

}  // namespace

TEST_CASE("monotone accepts exactly the regions of the corpus", "[triangulate][monotone]")
{
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        CHECK(test::oracle::is_region(test::loops_of(c.shape)) == c.is_region);
        CHECK(test::oracle::is_crossing(test::loops_of(c.shape)) == c.is_crossing);
        for (const test::shape& s : test::in_positions(c.shape)) CHECK(mistake_on(s) == "");
        const contours loops = test::contours_of(c.shape);
        workspace space;
        triangle_list out;
        const result<region> proven = monotone{}.prove(loops, space, out);
        REQUIRE(bool(proven) == c.is_region);
        if (!proven) continue;
        CHECK(proven->outers() == c.outers);
        CHECK(proven->holes() == c.holes);
        CHECK(out.size() == c.triangles);
    }
}

TEST_CASE("monotone proves generated shapes in every position", "[triangulate][monotone]")
{
    for (const test::shape& s : test::generated_regions()) {
        for (const test::shape& t : test::in_positions(s, {0.0, 0.001, 90.0, 180.0, 270.0, 33.0})) {
            INFO(t.name);
            CHECK(mistake_on(t) == "");
        }
    }
}

TEST_CASE("monotone refuses random polylines on tiny grids exactly where the oracle does", "[triangulate][monotone]")
{
    test::dice d{1};
    int accepted = 0;
    for (int i = 0; i < 60'000; ++i) {
        const int width = 3 + d.roll(7), count = 1 + d.roll(3);
        const test::shape s = test::random_polylines(d, count, 3, count == 1 ? 6 : 3, width);
        INFO(s);
        CHECK(mistake_on(s) == "");
        accepted += test::oracle::is_region(test::loops_of(s));
    }
    CHECK(accepted > 2000);
}

TEST_CASE("monotone refuses random polygons within polygons exactly where the oracle does", "[triangulate][monotone]")
{
    test::dice d{2};
    int accepted = 0;
    for (int i = 0; i < 6000; ++i) {
        test::shape s{"polygons " + std::to_string(i), {}};
        const int width = 5 + d.roll(5), scale = 2 + d.roll(8);
        test::polyline outer = test::random_polygon(3 + d.roll(9), width, d);
        if (test::oracle::doubled_area(outer) < 0) std::reverse(outer.begin(), outer.end());
        for (grid_point& p : outer) p = {p.x * scale, p.y * scale};
        s.loops.push_back(outer);
        for (int inner = d.roll(4); inner > 0; --inner) {
            test::polyline l = test::random_polygon(3 + d.roll(4), 2 + d.roll(3), d);
            const bool should_be_hole = d.roll(8) != 0;
            if ((test::oracle::doubled_area(l) < 0) != should_be_hole) std::reverse(l.begin(), l.end());
            const grid_point at{d.roll(width * scale), d.roll(width * scale)};
            for (grid_point& p : l) p = {p.x + at.x, p.y + at.y};
            s.loops.push_back(l);
        }
        INFO(s);
        CHECK(mistake_on(s) == "");
        accepted += s.loops.size() > 1 && test::oracle::is_region(test::loops_of(s));
    }
    CHECK(accepted > 300);
}

TEST_CASE("monotone finds the only crossing in a shape of thousands of spans", "[triangulate][monotone]")
{
    test::dice d{3};
    for (const test::polyline& simple :
         {test::comb(600), test::star(3000, 1'000'000, 5), test::spiral(2000, 30, 5000)}) {
        for (const double degrees : {0.0, 90.0, 180.0}) {
            test::shape s = test::turned({"shape", {simple}}, degrees);
            CHECK(mistake_on(s) == "");
            for (int i = 0; i < 12; ++i) {  // one point goes astray
                test::shape t = s;
                grid_point& p = t.loops[0][static_cast<std::size_t>(d.roll(static_cast<int>(t.loops[0].size())))];
                p = {p.x + d.roll(4001) - 2000, p.y + d.roll(4001) - 2000};
                INFO("turn " << degrees << ", try " << i);
                CHECK(mistake_on(t) == "");
            }
        }
    }
}

TEST_CASE("contours without points are the empty region", "[triangulate][monotone]")
{
    contours none;
    workspace space;
    triangle_list out;
    const result<region> proven = monotone{}.prove(none, space, out);
    REQUIRE(proven);
    CHECK(proven->points().empty());
    CHECK(proven->triangle_count() == 0);
    CHECK(out.empty());
}

TEST_CASE("prove() reports that memory ran out, and needs none once warm", "[triangulate][monotone]")
{
    test::check_proving_memory(monotone{}, test::square_with_holes(12, 12));
}

TEST_CASE("monotone takes at most 130 bytes of scratch memory a point, 260 while its workspace grows",
          "[triangulate][monotone]")
{
    for (const double radius : {1e6, 1e8}) {  // keys of 64 bits and wider ones
        const contours loops = test::contours_of({test::circle(100'000, radius)});
        const auto n = static_cast<double>(loops.points.size());
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out;
        REQUIRE(monotone{}.prove(loops, space, out));
        CHECK(static_cast<double>(memory.bytes_held) < 260.0 * n);

        workspace measured{memory.source()};
        const std::size_t before = memory.bytes_held;
        {
            workspace::scope whole{measured};
            REQUIRE(whole.take<char>(static_cast<std::size_t>(130.0 * n)) != nullptr);
        }
        out.clear();
        REQUIRE(monotone{}.prove(loops, measured, out));
        CHECK(memory.bytes_held - before < static_cast<std::size_t>(131.0 * n));
    }
}

TEST_CASE("prove_touching() reports a touching corner, and a refusal leaves the triangles as they were",
          "[triangulate][monotone]")
{
    workspace space;
    triangle_list out;
    REQUIRE(out.push_back({7, 8, 9}));
    contours corner = test::contours_of({"two squares", {test::square(0, 0, 4), test::square(4, 4, 4)}});
    REQUIRE(sort_points(corner, space));
    const auto proven = monotone{}.prove_touching(corner, space, out);
    REQUIRE(proven);
    CHECK(proven->is_touching());
    CHECK(out.size() == 5);

    contours crossing = test::contours_of({"two squares", {test::square(0, 0, 4), test::square(2, 2, 4)}});
    REQUIRE(sort_points(crossing, space));
    CHECK_FALSE(monotone{}.prove(crossing, space, out));
    CHECK(out.size() == 5);
}

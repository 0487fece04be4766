// SPDX-License-Identifier: MIT

#include <typemesh/fill/nest.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// What is wrong with nest()'s result for a shape under a rule, or nothing. It must refuse exactly what meets, and else
/// keep exactly the boundary, with the interior on the left and the edges that belong to it.
std::string nesting_mistake(const test::shape& s, fill_rule rule)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = nest(loops, rule, space);
    const auto given = test::loops_of(s);
    if (test::oracle::is_crossing(given)) {
        if (filled) return "accepted contours that meet";
        if (!(filled.error() == error::crossing_contours)) return filled.error().message();
        if (!std::ranges::equal(test::contours_of(s).points, loops.points)) return "a refusal changed the contours";
        return {};
    }
    if (!filled) return filled.error().message();

    std::vector<test::polyline> expected;
    std::vector<std::uint32_t> first_edge;
    std::uint32_t holes = 0, edge = 0;
    for (std::size_t l = 0; l < given.size(); ++l) {
        const test::oracle::separated w = test::oracle::separated_by(given, l);
        const bool inside = is_filled(rule, w.inside), outside = is_filled(rule, w.outside);
        if (inside != outside && !given[l].empty()) {
            test::polyline kept = s.loops[l];
            if ((test::oracle::doubled_area(given[l]) > 0) != inside) std::reverse(kept.begin(), kept.end());
            expected.push_back(kept);
            first_edge.push_back(edge);
            holes += !inside;
        }
        edge += static_cast<std::uint32_t>(given[l].size());
    }
    const auto kept = test::oracle::loops_of(*filled);
    if (kept.size() != expected.size()) return "keeps the wrong contours";
    for (std::size_t l = 0; l < kept.size(); ++l) {
        if (!std::ranges::equal(kept[l], expected[l])) return "a contour has the wrong points";
        const contours before = test::contours_of(s);
        for (std::size_t i = 0; i < kept[l].size(); ++i) {
            const contour_edge e = filled->edges()[filled->starts()[l] + i];
            const std::uint32_t local = e.curve - first_edge[l], size = static_cast<std::uint32_t>(kept[l].size());
            if (local >= size) return "an edge comes from another contour";
            const grid_point from = before.points[first_edge[l] + local],
                             to = before.points[first_edge[l] + (local + 1) % size];
            const grid_point a = kept[l][i], b = kept[l][(i + 1) % size];
            if (!(e.t0 < e.t1 ? a == from && b == to : a == to && b == from))
                return "an edge is not between its points";
        }
    }
    if (filled->holes() != holes || filled->outers() != expected.size() - holes)
        return "holes and outer loops are miscounted";
    if (!test::oracle::is_region(kept)) return "the result is no region";
    const double area = test::oracle::doubled_filled_area(given, rule),
                 left = static_cast<double>(test::oracle::doubled_area(kept));
    if (std::fabs(area - left) > 1e-9 * (area + 1)) return "the area is not what the contours fill";
    return {};
}

std::string nesting_mistake(const test::shape& s)
{
    const std::string m = nesting_mistake(s, fill_rule::non_zero);
    return m.empty() ? nesting_mistake(s, fill_rule::even_odd) : m;
}

}  // namespace

TEST_CASE("nest() refuses exactly the corpus' shapes that meet, and counts the others", "[fill][nest]")
{
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        for (const test::shape& s : test::in_positions(c.shape)) CHECK(nesting_mistake(s) == "");
        contours loops = test::contours_of(c.shape);
        workspace space;
        const result<region> filled = nest(loops, fill_rule::non_zero, space);
        REQUIRE(bool(filled) != c.is_crossing);
        if (!filled) continue;
        CHECK(filled->outers() == c.outers);
        CHECK(filled->holes() == c.holes);
        CHECK(filled->triangle_count() == c.triangles);
    }
}

TEST_CASE("nest() makes regions of generated shapes in every position", "[fill][nest]")
{
    for (const test::shape& s : test::generated_regions()) {
        if (s.loops.size() > 150) continue;  // the slabs of the oracle take long
        for (const double degrees : {0.0, 0.001, 90.0, 180.0}) {
            const test::shape t = test::turned(s, degrees);
            if (t.loops[0].size() > 500 && degrees != 90.0) continue;
            INFO(t.name);
            CHECK(nesting_mistake(t) == "");
            CHECK(nesting_mistake(test::reversed(t), fill_rule::non_zero) == "");
        }
    }
}

TEST_CASE("nest() nests contours of one direction by the rule", "[fill][nest]")
{
    for (int depth = 1; depth < 12; ++depth) {
        contours loops = test::contours_of(test::nested_squares(depth, false));
        workspace space;
        const result<region> non_zero = nest(loops, fill_rule::non_zero, space);
        REQUIRE(non_zero);
        CHECK(non_zero->loop_count() == 1);
        CHECK(loops.points.size() == 4);
        loops = test::contours_of(test::nested_squares(depth, false));
        const result<region> even_odd = nest(loops, fill_rule::even_odd, space);
        REQUIRE(even_odd);
        CHECK(even_odd->loop_count() == static_cast<std::uint32_t>(depth));
        CHECK(even_odd->holes() == static_cast<std::uint32_t>(depth / 2));
        CHECK(nesting_mistake(test::nested_squares(depth, false)) == "");
        CHECK(nesting_mistake(test::nested_squares(depth, true)) == "");
    }
}

TEST_CASE("nest() agrees with the oracle about random polylines on tiny grids", "[fill][nest]")
{
    test::dice d{11};
    int accepted = 0;
    for (int i = 0; i < 30'000; ++i) {
        const int width = 3 + d.roll(7), count = 1 + d.roll(3);
        const test::shape s = test::random_polylines(d, count, 3, count == 1 ? 6 : 3, width);
        INFO(s);
        CHECK(nesting_mistake(s) == "");
        accepted += !test::oracle::is_crossing(test::loops_of(s));
    }
    CHECK(accepted > 2000);
}

TEST_CASE("nest() agrees with the oracle about polygons within polygons, in both directions", "[fill][nest]")
{
    test::dice d{12};
    int accepted = 0;
    for (int i = 0; i < 6000; ++i) {
        test::shape s{"polygons " + std::to_string(i), {}};
        std::int32_t reach = 6 + d.roll(6), at = 0;
        for (int c = 1 + d.roll(5); c > 0; --c) {  // each mostly within the one before
            test::polyline l = test::random_polygon(3 + d.roll(4), 2 + d.roll(3), d);
            for (grid_point& p : l) p = {p.x * reach * 4 + at, p.y * reach * 4 + at};
            at += reach * (2 + d.roll(5));
            reach = (reach + 2) / 3;
            s.loops.push_back(l);
        }
        INFO(s);
        CHECK(nesting_mistake(s) == "");
        accepted += s.loops.size() > 1 && !test::oracle::is_crossing(test::loops_of(s));
    }
    CHECK(accepted > 500);
}

TEST_CASE("nest() makes the empty region of no contours", "[fill][nest]")
{
    workspace space;
    contours none;
    const result<region> empty = nest(none, fill_rule::non_zero, space);
    REQUIRE(empty);
    CHECK(empty->points().empty());
    CHECK(empty->triangle_count() == 0);
    contours hollow = test::contours_of({test::polyline{}, test::square(0, 0, 2), test::polyline{}});
    const result<region> one = nest(hollow, fill_rule::non_zero, space);
    REQUIRE(one);
    CHECK(one->loop_count() == 1);
    CHECK(one->outers() == 1);
}

TEST_CASE("nest() without memory reports it and keeps the contours, and needs none once warm", "[fill][nest]")
{
    const test::shape s = test::reversed(test::square_with_holes(12, 12));
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        workspace space{memory.source()};
        contours loops = test::contours_of(s);
        const result<region> filled = nest(loops, fill_rule::non_zero, space);
        was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!filled) {
            CHECK(filled.error() == error::out_of_memory);
            CHECK(std::ranges::equal(loops.points, test::contours_of(s).points));
            REQUIRE(nest(loops, fill_rule::non_zero, space));
        }
        REQUIRE(nest(loops, fill_rule::non_zero, space));
        const std::size_t warm = memory.requests;
        REQUIRE(nest(loops, fill_rule::non_zero, space));
        CHECK(memory.requests == warm);
    }
}

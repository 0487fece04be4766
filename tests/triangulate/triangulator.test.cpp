// SPDX-License-Identifier: MIT

// The laws that every triangulator obeys.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <tuple>

using namespace typemesh;

namespace {

using triangulators = std::tuple<monotone, constrained_delaunay>;  // a new one joins the list

/// Fills and triangulates; the first broken law, or what went wrong before. Shapes whose edges meet break none.
template <class Triangulator>
std::string broken_law(const test::shape& s, fill_rule rule = fill_rule::non_zero)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = fill(loops, rule, space);
    if (!filled) return filled.error() == error::crossing_contours ? "" : filled.error().message();
    triangle_list out;
    if (!out.push_back({7, 8, 9})) return "no memory";
    if (const error e = Triangulator{}(*filled, space, out)) return e.message();
    if (!(out[0] == triangle{7, 8, 9})) return "what was there before is overwritten";
    return test::oracle::broken_law(*filled, out.view().subspan(1));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a triangulator cuts every shape of the corpus into triangles over its own points",
                        "[triangulate]", triangulators)
{
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        if (c.is_crossing) continue;
        for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
            const test::shape s = test::turned(c.shape, degrees);
            INFO(s);
            for (const test::shape& t : {s, test::mirrored(s), test::reversed(s)}) CHECK(broken_law<TestType>(t) == "");
        }
        contours loops = test::contours_of(c.shape);
        workspace space;
        const result<region> filled = fill(loops, fill_rule::non_zero, space);
        INFO(c);
        REQUIRE(filled);
        triangle_list out;
        CHECK_FALSE(TestType{}(*filled, space, out));
        CHECK(out.size() == c.triangles);
    }
}

TEMPLATE_LIST_TEST_CASE("a triangulator cuts shapes of all kinds into triangles over their own points", "[triangulate]",
                        triangulators)
{
    for (const test::shape& s : test::generated_regions()) {
        for (const double degrees : {0.0, 0.001, 33.0, 90.0, 180.0}) {
            const test::shape t = test::turned(s, degrees);
            INFO(t.name);
            CHECK(broken_law<TestType>(t) == "");
            CHECK(broken_law<TestType>(test::mirrored(t)) == "");
            CHECK(broken_law<TestType>(test::reversed(t)) == "");
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a triangulator cuts random polygons on tiny grids", "[triangulate]", triangulators)
{
    test::dice d{42};
    for (int i = 0; i < 3000; ++i) {
        const int width = 4 + d.roll(12), n = 3 + d.roll((std::min)(width * width / 3, 40));
        const test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(n, width, d)}};
        INFO(s);
        CHECK(broken_law<TestType>(s) == "");
    }
}

TEMPLATE_LIST_TEST_CASE("the laws do not depend on where contours begin or how they are ordered", "[triangulate]",
                        triangulators)
{
    for (const test::shape& s : test::generated_regions()) {
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            INFO(s.name << ", shuffle " << seed);
            CHECK(broken_law<TestType>(test::shuffled(s, seed)) == "");
        }
    }
}

TEMPLATE_LIST_TEST_CASE("equal regions give equal triangles, whatever the workspace was used for before",
                        "[triangulate]", triangulators)
{
    contours loops = test::contours_of(test::circle_with_holes(300, 40)),
             others = test::contours_of(test::square_with_holes(9, 9));
    workspace fresh, used;
    const result<region> filled = fill(loops, fill_rule::non_zero, fresh),
                         other = fill(others, fill_rule::non_zero, fresh);
    REQUIRE(filled);
    REQUIRE(other);
    triangle_list first, second;
    REQUIRE_FALSE(TestType{}(*filled, fresh, first));
    REQUIRE_FALSE(TestType{}(*other, used, second));
    second.clear();
    REQUIRE_FALSE(TestType{}(*filled, used, second));
    CHECK(std::equal(first.begin(), first.end(), second.begin(), second.end()));
}

TEMPLATE_LIST_TEST_CASE("the empty region has no triangles", "[triangulate]", triangulators)
{
    workspace space;
    triangle_list out;
    CHECK_FALSE(TestType{}(region{}, space, out));
    CHECK(out.empty());
}

TEMPLATE_LIST_TEST_CASE("a triangulator without memory says so and leaves everything as it was", "[triangulate]",
                        triangulators)
{
    contours loops = test::contours_of(test::square_with_holes(30, 12));
    workspace for_fill;
    const result<region> filled = fill(loops, fill_rule::non_zero, for_fill);
    REQUIRE(filled);
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out{memory.source()};
        REQUIRE(out.push_back({7, 8, 9}));
        memory.requests = 0;
        memory.fail_at = nth;
        memory.fail_once = true;
        const error e = TestType{}(*filled, space, out);
        const bool was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!e) {
            // the workspace may do without joining its blocks, but nothing else may fail unnoticed
            CHECK(test::oracle::broken_law(*filled, out.view().subspan(1)) == "");
            if (!was_asked) break;
            continue;
        }
        CHECK(e == error::out_of_memory);
        CHECK(out.size() == 1);
        CHECK(out[0] == triangle{7, 8, 9});
        REQUIRE_FALSE(TestType{}(*filled, space, out));
        CHECK(test::oracle::broken_law(*filled, out.view().subspan(1)) == "");
    }
}

TEMPLATE_LIST_TEST_CASE("a triangulator that has warmed up allocates nothing", "[triangulate]", triangulators)
{
    contours loops = test::contours_of(test::square_with_holes(10, 12));
    workspace for_fill;
    const result<region> filled = fill(loops, fill_rule::non_zero, for_fill);
    REQUIRE(filled);
    test::counting_memory memory;
    workspace space{memory.source()};
    triangle_list out{memory.source()};
    REQUIRE_FALSE(TestType{}(*filled, space, out));
    const std::size_t warm = memory.requests;
    for (int i = 0; i < 3; ++i) {
        out.clear();
        REQUIRE_FALSE(TestType{}(*filled, space, out));
    }
    CHECK(memory.requests == warm);
}

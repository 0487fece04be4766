// SPDX-License-Identifier: MIT

// Laws that every triangulator obeys.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/filled_shape.hpp"
#include "support/regions.hpp"

#include <tuple>

using namespace typemesh;

namespace {

using triangulators = std::tuple<monotone, constrained_delaunay>;  // a new one joins the list

/// The first law that the triangles of a filled shape break, or an earlier error. Shapes whose edges meet break none.
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
        for (const test::shape& s : test::in_positions(c.shape)) {
            INFO(s);
            CHECK(broken_law<TestType>(s) == "");
        }
        INFO(c);
        test::filled_shape f{c.shape};
        triangle_list out;
        CHECK_FALSE(TestType{}(f.filled, f.space, out));
        CHECK(out.size() == c.triangles);
    }
}

TEMPLATE_LIST_TEST_CASE("a triangulator cuts shapes of all kinds into triangles over their own points", "[triangulate]",
                        triangulators)
{
    for (const test::shape& s : test::generated_regions()) {
        for (const test::shape& t : test::in_positions(s, {0.0, 0.001, 33.0, 90.0, 180.0})) {
            INFO(t.name);
            CHECK(broken_law<TestType>(t) == "");
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

TEMPLATE_LIST_TEST_CASE("the laws do not depend on the start or order of contours", "[triangulate]", triangulators)
{
    for (const test::shape& s : test::generated_regions()) {
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            INFO(s.name << ", shuffle " << seed);
            CHECK(broken_law<TestType>(test::shuffled(s, seed)) == "");
        }
    }
}

TEMPLATE_LIST_TEST_CASE("equal regions give equal triangles, whatever the workspace did before", "[triangulate]",
                        triangulators)
{
    test::filled_shape one{test::circle_with_holes(300, 40)}, other{test::square_with_holes(9, 9)};
    workspace used;
    triangle_list first, second;
    REQUIRE_FALSE(TestType{}(one.filled, one.space, first));
    REQUIRE_FALSE(TestType{}(other.filled, used, second));
    second.clear();
    REQUIRE_FALSE(TestType{}(one.filled, used, second));
    CHECK(std::ranges::equal(first, second));
}

TEMPLATE_LIST_TEST_CASE("the empty region has no triangles", "[triangulate]", triangulators)
{
    workspace space;
    triangle_list out;
    CHECK_FALSE(TestType{}(region{}, space, out));
    CHECK(out.empty());
}

TEMPLATE_LIST_TEST_CASE("a triangulator without memory reports it and keeps the triangles before it", "[triangulate]",
                        triangulators)
{
    const test::filled_shape f{test::square_with_holes(30, 12)};
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out{memory.source()};
        REQUIRE(out.push_back({7, 8, 9}));
        memory.requests = 0;
        memory.fail_at = nth;
        memory.fail_once = true;
        const error e = TestType{}(f.filled, space, out);
        const bool was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!e) {
            // the workspace may do without joining its blocks, but nothing else may fail unnoticed
            CHECK(test::oracle::broken_law(f.filled, out.view().subspan(1)) == "");
            if (!was_asked) break;
            continue;
        }
        CHECK(e == error::out_of_memory);
        CHECK(out.size() == 1);
        CHECK(out[0] == triangle{7, 8, 9});
        REQUIRE_FALSE(TestType{}(f.filled, space, out));
        CHECK(test::oracle::broken_law(f.filled, out.view().subspan(1)) == "");
    }
}

TEMPLATE_LIST_TEST_CASE("a triangulator that has warmed up allocates nothing", "[triangulate]", triangulators)
{
    const test::filled_shape f{test::square_with_holes(10, 12)};
    test::counting_memory memory;
    workspace space{memory.source()};
    triangle_list out{memory.source()};
    REQUIRE_FALSE(TestType{}(f.filled, space, out));
    const std::size_t warm = memory.requests;
    for (int i = 0; i < 3; ++i) {
        out.clear();
        REQUIRE_FALSE(TestType{}(f.filled, space, out));
    }
    CHECK(memory.requests == warm);
}

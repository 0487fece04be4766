// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

TEST_CASE("fill() treats contours that do not meet as nest() does, and resolves the others", "[fill]")
{
    test::dice d{31};
    int nested = 0, resolved = 0;
    for (int i = 0; i < 5000; ++i) {
        const int width = 3 + d.roll(7), count = 1 + d.roll(3);
        const test::shape s = test::random_polylines(d, count, 3, 3, width, 8);
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            INFO(s);
            contours one = test::contours_of(s), two = test::contours_of(s);
            workspace space;
            const bool meets = test::oracle::is_crossing(test::loops_of(s));
            const result<region> filled = fill(one, rule, space);
            const result<region> reference = meets ? resolve(two, rule, space) : nest(two, rule, space);
            REQUIRE(filled);
            REQUIRE(reference);
            CHECK(std::ranges::equal(one.points, two.points));
            CHECK(std::ranges::equal(one.starts, two.starts));
            CHECK(filled->holes() == reference->holes());
            CHECK(filled->outers() == reference->outers());
            ++(meets ? resolved : nested);
        }
    }
    CHECK(nested > 500);
    CHECK(resolved > 500);
}

TEST_CASE("fill() refuses contours of more than max_pieces pieces, and no others", "[fill]")
{
    const test::polyline square{{0, 0}, {80, 0}, {80, 80}, {0, 80}};
    const test::shape crossing{"crossing squares", {square, {{40, 40}, {120, 40}, {120, 120}, {40, 120}}}};
    const test::shape apart{"squares apart", {square, {{90, 40}, {120, 40}, {120, 120}, {90, 120}}}};
    const auto filled = [](const test::shape& s, std::uint32_t most) {
        contours loops = test::contours_of(s), given = test::contours_of(s);
        workspace space;
        const auto made = fill(loops, fill_rule::non_zero, space, {.max_pieces = most});
        if (!made) {
            CHECK(made.error() == error::too_many_pieces);
            CHECK(made.error().count == most);
            CHECK(std::ranges::equal(loops.points, given.points));
        }
        return static_cast<bool>(made);
    };
    CHECK_FALSE(filled(crossing, 7));
    CHECK(filled(crossing, 100));
    CHECK(filled(apart, 7));
}

TEST_CASE("fill() makes the empty region of contours without area", "[fill]")
{
    contours none;
    contours lines[] = {test::contours_of({test::polyline{}}), test::contours_of({test::polyline{{3, 4}}}),
                        test::contours_of({{{3, 4}, {5, 6}}}), test::contours_of({{{3, 4}, {5, 6}, {3, 4}}})};
    for (contours* const empty : {&none, lines, lines + 1, lines + 2, lines + 3}) {
        workspace space;
        const result<region> filled = fill(*empty, fill_rule::non_zero, space);
        REQUIRE(filled);
        CHECK(filled->points().empty());
        CHECK(filled->loop_count() == 0);
        CHECK(filled->triangle_count() == 0);
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

TEST_CASE("fill() leaves contours that do not meet as nest() does, and resolves the others", "[fill]")
{
    test::dice d{31};
    int nested = 0, resolved = 0;
    for (int i = 0; i < 5000; ++i) {
        const int width = 3 + d.roll(7), count = 1 + d.roll(3);
        test::shape s{"polylines " + std::to_string(i), {}};
        for (int c = 0; c < count; ++c) {
            test::polyline l;
            for (int n = 3 + d.roll(3); n > 0; --n) l.push_back({d.roll(width) * 8, d.roll(width) * 8});
            s.loops.push_back(l);
        }
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            INFO(s);
            contours one = test::contours_of(s), two = test::contours_of(s);
            workspace space;
            const bool meets = test::oracle::is_crossing(test::loops_of(s));
            const result<region> filled = fill(one, rule, space);
            const result<region> reference = meets ? resolve(two, rule, space) : nest(two, rule, space);
            REQUIRE(filled);
            REQUIRE(reference);
            CHECK(std::equal(one.points.begin(), one.points.end(), two.points.begin(), two.points.end()));
            CHECK(std::equal(one.starts.begin(), one.starts.end(), two.starts.begin(), two.starts.end()));
            CHECK(filled->holes() == reference->holes());
            CHECK(filled->outers() == reference->outers());
            ++(meets ? resolved : nested);
        }
    }
    CHECK(nested > 500);
    CHECK(resolved > 500);
}

TEST_CASE("fill() refuses contours that cross more often than it is told, and no others", "[fill]")
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
            CHECK(std::equal(loops.points.begin(), loops.points.end(), given.points.begin(), given.points.end()));
        }
        return static_cast<bool>(made);
    };
    CHECK_FALSE(filled(crossing, 7));
    CHECK(filled(crossing, 100));
    CHECK(filled(apart, 7));
}

TEST_CASE("fill() of nothing is the empty region", "[fill]")
{
    workspace space;
    contours none;
    const result<region> empty = fill(none, fill_rule::non_zero, space);
    REQUIRE(empty);
    CHECK(empty->points().empty());
    CHECK(empty->triangle_count() == 0);
    for (const test::polyline& l : {test::polyline{}, test::polyline{{3, 4}}, test::polyline{{3, 4}, {5, 6}},
                                    test::polyline{{3, 4}, {5, 6}, {3, 4}}}) {
        contours point = test::contours_of({l});
        const result<region> nothing = fill(point, fill_rule::non_zero, space);
        REQUIRE(nothing);
        CHECK(nothing->points().empty());
        CHECK(nothing->loop_count() == 0);
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/fill_check.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;
using inspect::check_fill;
using inspect::fill_check;

TEST_CASE("fill() keeps what crossing contours fill, and a lost or turned loop is found", "[inspect]")
{
    const test::polyline outer = test::square(0, 0, 20), hole = test::reversed(test::square(4, 4, 6)),
                         other = test::square(15, 15, 20);
    const std::vector<inspect::loop> given{outer, hole, other};
    for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
        contours loops = test::contours_of({outer, hole, other});
        workspace space;
        const auto r = fill(loops, rule, space);
        REQUIRE(r);
        const auto kept = inspect::loops_of(*r);
        const fill_check right = check_fill(given, rule, kept, 50);
        CHECK(right.places > 500);
        CHECK(right.wrong == 0);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            auto lost = kept;
            lost.erase(lost.begin() + static_cast<std::ptrdiff_t>(i));
            CHECK(check_fill(given, rule, lost, 50).wrong > 0);
            const test::polyline turned = test::reversed(test::polyline{kept[i].begin(), kept[i].end()});
            auto with_turned = kept;
            with_turned[i] = turned;
            CHECK(check_fill(given, rule, with_turned, 50).wrong > 0);
        }
        const auto by_other =
            check_fill(given, rule == fill_rule::non_zero ? fill_rule::even_odd : fill_rule::non_zero, kept, 50);
        CHECK(by_other.wrong > 0);
    }
}

TEST_CASE("all grid points of small contours are compared", "[inspect]")
{
    const test::polyline box = test::square(0, 0, 4);
    const fill_check c = check_fill({box}, fill_rule::non_zero, {box}, 12, 0.0);
    CHECK(c.places == 9);
    CHECK(c.skipped == 16);
    CHECK(c.wrong == 0);
    CHECK(check_fill({box}, fill_rule::non_zero, {}, 12, 0.0).wrong == 9);
    CHECK(check_fill({}, fill_rule::non_zero, {box}).places == 0);
}

// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/simple_sweep.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// Compares simple_sweep with a trial of all pairs.
void compare(const test::shape& s)
{
    contours loops = test::contours_of(s);
    const auto views = test::loops_of(s);
    workspace space;
    REQUIRE(sort_points(loops, space));
    std::vector<detail::contour_sides> sides(s.loops.size());
    detail::simple_sweep sweep;
    const error e = sweep.run(loops, space, sides.data());
    INFO(s);
    REQUIRE((e == error::crossing_contours) == test::oracle::is_crossing(views));
    if (e) return;
    for (std::size_t l = 0; l < views.size(); ++l) {
        const auto expected = test::oracle::separated_by(views, l);
        CHECK(sides[l].outside == expected.outside);
        CHECK(sides[l].inside == expected.inside);
        CHECK(sides[l].counter_clockwise == (test::oracle::doubled_area(views[l]) > 0));
    }
}

}  // namespace

TEST_CASE("The simple sweep finds whether two edges meet, or what every contour separates", "[fill][simple_sweep]")
{
    test::dice d{101};
    for (int i = 0; i < 20'000; ++i) {
        test::shape s{"triangles " + std::to_string(i), {}};
        const int width = 3 + d.roll(30), count = 1 + d.roll(4);
        for (int c = 0; c < count; ++c) {
            const grid_point at{d.roll(width), d.roll(width)};
            const int size = 2 + d.roll(width);
            test::polyline l;
            for (int n = 3 + d.roll(2); n > 0; --n) l.push_back({at.x + d.roll(size), at.y + d.roll(size)});
            s.loops.push_back(l);
        }
        compare(s);
    }
}

TEST_CASE("The simple sweep separates nested contours of every direction", "[fill][simple_sweep]")
{
    for (int depth = 1; depth < 12; ++depth) {
        for (const bool alternating : {false, true}) {
            const test::shape s = test::nested_squares(depth, alternating);
            compare(s);
            compare(test::mirrored(s));
            compare(test::turned(s, 45.0));
            for (std::uint64_t seed = 1; seed < 6; ++seed) compare(test::shuffled(s, seed));
        }
    }
}

TEST_CASE("The simple sweep reports that memory ran out", "[fill][simple_sweep]")
{
    contours loops = test::contours_of({test::square(0, 0, 8)});
    workspace sorting;
    REQUIRE(sort_points(loops, sorting));
    test::counting_memory memory{.fail_at = 1};
    workspace space{memory.source()};
    detail::contour_sides sides[1];
    CHECK(detail::simple_sweep{}.run(loops, space, sides) == error::out_of_memory);
    CHECK(detail::simple_sweep{}.run(test::contours_of(std::vector<test::polyline>{}), space, sides) == error::none);
}

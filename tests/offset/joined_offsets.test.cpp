// SPDX-License-Identifier: MIT

// Joins change what is left of a region near their corners, and nowhere else.

#include <typemesh/fill/fill.hpp>

#include "support/catch.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/joined_offsets.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace joined_offset_shapes {

/// A shape twice as large as an em usually is, if it has no more points than told.
struct large_shape {
    test::shape shape;
    double size = 0.0;  ///< the larger of its extents, in cells

    explicit large_shape(test::shape given) : shape{std::move(given)}
    {
        box around;
        for (const auto& l : shape.loops)
            for (const grid_point p : l) around.add({double(p.x), double(p.y)});
        size = (std::max)(around.high.x - around.low.x, around.high.y - around.low.y);
        for (; size <= 0x1p20; size *= 2)
            for (auto& l : shape.loops)
                for (grid_point& p : l) p = {2 * p.x, 2 * p.y};
    }
    [[nodiscard]] std::size_t points() const
    {
        std::size_t n = 0;
        for (const auto& l : shape.loops) n += l.size();
        return n;
    }
};

/// What was found of all shapes together.
struct joins_found {
    std::size_t corners = 0, compared = 0, refused = 0;
};

void check_joins(const test::shape& s, double width, joins_found& sum)
{
    contours loops = test::contours_of(s);
    workspace space;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    REQUIRE(filled);
    const test::joined_offsets both{*filled, width};
    sum.corners += both.corners;
    sum.compared += both.compared;
    sum.refused += both.refused;
    if (both.failed.empty() && both.farthest <= 2.0) return;
    CAPTURE(s, width, both.where.x, both.where.y);
    CHECK(both.failed == "");
    CHECK(both.farthest <= 2.0);
}

}  // namespace joined_offset_shapes

TEST_CASE("joins change a swept region within 4 widths of their corners only: generated shapes", "[offset][joins]")
{
    using namespace joined_offset_shapes;
    std::vector<test::shape> shapes = test::delaunay_shapes();
    for (std::uint64_t seed = 10; seed < 16; ++seed)
        shapes.push_back({"star of seed " + std::to_string(seed), {test::star(10 + 2 * int(seed), 1e6, seed)}});
    joins_found sum;
    for (const test::shape& given : shapes) {
        const large_shape large{given};
        if (large.points() > 130 || large.size > 0x1p26) continue;
        for (const double share : {0.0005, 0.005, 0.02})
            for (const test::shape& s : {large.shape, test::mirrored(large.shape), test::turned(large.shape, 30.0)})
                check_joins(s, std::floor(share * large.size), sum);
    }
    CHECK(sum.corners > 100);
    CHECK(sum.compared > 10'000);
    CHECK(sum.refused == 0);
}

TEST_CASE("joins change a swept region within 4 widths of their corners only: random polygons", "[offset][joins]")
{
    using namespace joined_offset_shapes;
    joins_found sum;
    for (int i = 0; i < 60; ++i) {
        test::dice d{static_cast<std::uint64_t>(1000 + i)};
        const large_shape large{{"random polygon " + std::to_string(i), {test::random_polygon(8 + i / 2, 40, d)}}};
        const test::shape s = i % 3 == 0   ? large.shape
                              : i % 3 == 1 ? test::mirrored(large.shape)
                                           : test::turned(large.shape, 30.0);
        for (const double share : {0.0005, 0.005, 0.02}) check_joins(s, std::floor(share * large.size), sum);
    }
    CHECK(sum.corners > 500);
    CHECK(sum.compared > 10'000);
    CHECK(sum.refused == 0);
}

TEST_CASE("what joins change is seen: a cap swept farther, and a join's own corner", "[offset][joins]")
{
    // Of a tooth that is 200 wide and 1,000 high, the mitre is 5.1 widths long: with joins the cap reaches closer.
    contours loops = test::contours_of({"square with a narrow cut",
                                        {{{0, 0},
                                          {100'000, 0},
                                          {100'000, 100'000},
                                          {51'000, 100'000},
                                          {50'000, 90'000},
                                          {49'000, 100'000},
                                          {0, 100'000}}}});
    workspace space;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    REQUIRE(filled);
    const test::joined_offsets both{*filled, 1'000};
    CHECK(both.corners == 1);
    CHECK(both.left_out >= 6);
    CHECK(both.compared >= 20);
    CHECK(both.farthest <= 1.0);
    CHECK(test::joined_offsets{*filled, 1'000, 3.0}.farthest > 2.0);
    CHECK(test::joined_offsets{*filled, 1'000, 0.0, 0.1}.farthest > 100.0);  // discs of a tenth of the width
}

// SPDX-License-Identifier: MIT

// Joins change the rest of a region near their corners, and nowhere else.

#include "support/joined_offsets.hpp"
#include "support/catch.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/filled_shape.hpp"
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

/// A shape enlarged to twice the usual size of an em.
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

/// The counts of all shapes together.
struct joins_found {
    std::size_t corners = 0, compared = 0, refused = 0;
};

void check_joins(const test::shape& s, double width, joins_found& sum)
{
    const test::filled_shape f{s};
    const test::joined_offsets both{f.filled, width};
    sum.corners += both.corners;
    sum.compared += both.compared;
    sum.refused += both.refused;
    if (both.failed.empty() && both.farthest <= 2.0) return;
    CAPTURE(s, width, both.where.x, both.where.y);
    CHECK(both.failed == "");
    CHECK(both.farthest <= 2.0);
}

}  // namespace joined_offset_shapes

TEST_CASE("joins change generated shapes only within 4 widths of their corners", "[offset][joins]")
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

TEST_CASE("joins change random polygons only within 4 widths of their corners", "[offset][joins]")
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

TEST_CASE("the comparison notices a cap swept too far, and a join's own corner", "[offset][joins]")
{
    // The mitre of a tooth 200 wide and 1,000 high is 5.1 widths long: with joins the cap reaches closer.
    const test::polyline cut{{0, 0},           {100'000, 0},      {100'000, 100'000}, {51'000, 100'000},
                             {50'000, 90'000}, {49'000, 100'000}, {0, 100'000}};
    const test::filled_shape f{{"square with a narrow cut", {cut}}};
    const test::joined_offsets both{f.filled, 1'000};
    CHECK(both.corners == 1);
    CHECK(both.left_out >= 6);
    CHECK(both.compared >= 20);
    CHECK(both.farthest <= 1.0);
    CHECK(test::joined_offsets{f.filled, 1'000, 3.0}.farthest > 2.0);
    CHECK(test::joined_offsets{f.filled, 1'000, 0.0, 0.1}.farthest > 100.0);  // discs of a tenth of the width
}

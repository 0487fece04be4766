// SPDX-License-Identifier: MIT

#include <typemesh/refine/non_obtuse.hpp>

#include "support/refined_shape.hpp"

#include <limits>

using namespace typemesh;

namespace {

error refine_right(const non_obtuse& how, const test::filled_shape& shape, test::refined_result& out)
{
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
    non_obtuse::scratch scratch;
    return how(shape.filled, given.view(), scratch, out.out());
}

/// The largest power of two that keeps a shape within half of the grid.
std::int32_t greatest_scale(const test::shape& s)
{
    std::int32_t farthest = 1;
    for (const auto& loop : s.loops)
        for (const grid_point p : loop) farthest = (std::max)({farthest, std::abs(p.x), std::abs(p.y)});
    std::int32_t scale = 1;
    while (farthest <= (1 << 26) / scale) scale *= 2;
    return scale;
}

test::shape scaled(test::shape s, std::int32_t scale)
{
    for (auto& loop : s.loops)
        for (grid_point& p : loop) p = {p.x * scale, p.y * scale};
    return s;
}

/// A grid with an em, for options in em.
constexpr grid with_em{512.0, 1024.0};

}  // namespace

TEST_CASE("no angle of a refined shape is above 90 degrees, but for rounding, and the triangles fill the shape",
          "[refine]")
{
    std::size_t shapes = 0, too_narrow = 0;
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s)) || s.loops[0].size() > 400) continue;
        for (const std::int32_t scale : {1, greatest_scale(s)}) {
            const test::shape turned = test::turned(scaled(s, scale), 17.0);
            if (!inspect::is_region(test::loops_of(turned))) continue;
            INFO(turned.name << ", times " << scale);
            const test::filled_shape shape{turned};
            test::refined_result out;
            const error e = refine_right({.max_points = 20'000}, shape, out);
            if (e == error::too_many_points) {  // a long gap
                ++too_narrow;
                continue;
            }
            REQUIRE_FALSE(e);
            CHECK(test::broken_refinement(shape.filled, out) == "");
            const test::wide_corners wide = test::wide_corners_of(out);
            CHECK(wide.above == out.kept);  // a triangle has one obtuse corner at most
            if (scale > 100) CHECK(wide.above == 0);
            ++shapes;
        }
    }
    CHECK(shapes > 20);
    CHECK(10 * too_narrow < shapes);
}

TEST_CASE("random polygons on a fine grid have no angle above 90.1 degrees", "[refine]")
{
    test::dice d{11};
    int divided = 0;
    for (int round = 0; round < 20; ++round) {
        test::shape s{"polygon", {{}}};
        const int n = 5 + d.roll(40);
        for (int i = 0; i < n; ++i)
            s.loops[0].push_back(test::on_circle(0, 0, (0.3 + 0.7 * d.fraction()) * 0x1p27, test::turn_once * i / n));
        CAPTURE(round, n);
        const test::filled_shape shape{s};
        test::refined_result out;
        REQUIRE_FALSE(refine_right({}, shape, out));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        const test::wide_corners wide = test::wide_corners_of(out);
        CHECK(wide.above == 0);
        CHECK(wide.greatest < 90.1);
        divided += wide.rounded > 0;
    }
    CHECK(divided > 10);
}

TEST_CASE("a shape that has right triangles already is not divided", "[refine]")
{
    const test::filled_shape shape{test::shape{"square", {test::square(0, 0, 1 << 20)}}};
    test::refined_result out;
    REQUIRE_FALSE(refine_right({}, shape, out));
    CHECK(out.triangles.size() == 2);
    CHECK(out.kept == 0);
}

TEST_CASE("no edge between right triangles is longer than max_edge", "[refine]")
{
    const test::filled_shape shape{test::shape{"disc", {test::circle(60, 200'000)}}, fill_rule::non_zero, with_em};
    for (const float longest : {0.5f, 0.1f, 0.02f}) {
        test::refined_result out;
        REQUIRE_FALSE(refine_right({longest}, shape, out));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        CHECK(test::wide_corners_of(out).above == 0);
        const std::vector<grid_point> p = out.points();
        double found = 0.0;
        for (const auto& [edge, apex] : test::edges_of(out))
            found = (std::max)(found, std::sqrt(double(squared_distance(p[edge.first], p[edge.second]))));
        CHECK(found <= double(longest) * 512.0 * 1024.0);
        CHECK(found > 0.2 * double(longest) * 512.0 * 1024.0);
    }
}

TEST_CASE("options of right triangles that are out of range are refused by name", "[refine]")
{
    const test::filled_shape shape{test::shape{"disc", {test::circle(60, 200'000)}}, fill_rule::non_zero, with_em};
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    struct row {
        non_obtuse how;
        const char* option;
    };
    for (const row& r : {row{{.max_edge = -0.1f}, "max_edge"}, row{{.max_edge = infinite}, "max_edge"},
                         row{{.max_edge = nan}, "max_edge"}, row{{.max_edge = 5e-5f}, "max_edge"},
                         row{{.max_points = 1u << 29}, "max_points"}}) {
        test::refined_result out;
        const error e = refine_right(r.how, shape, out);
        CAPTURE(r.option);
        CHECK(e == error::bad_option);
        CHECK(std::string(e.option) == r.option);
    }
    test::refined_result out;
    REQUIRE_FALSE(refine_right({}, shape, out));
    const auto points = static_cast<std::uint32_t>(out.points().size());
    CHECK_FALSE(refine_right({.max_points = points}, shape, out));
    CHECK(refine_right({.max_points = points - 1}, shape, out) == error::too_many_points);
    CHECK_FALSE(non_obtuse{}.cache_key() == non_obtuse{.max_edge = 1.0f}.cache_key());
    CHECK_FALSE(non_obtuse{}.cache_key() == non_obtuse{.max_points = 1}.cache_key());
}

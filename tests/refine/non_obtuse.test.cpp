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

/// A grid with an em, for options in em.
constexpr grid with_em{512.0, 1024.0};

}  // namespace

TEST_CASE("no angle of a refined shape is above 90 degrees, but for rounding; the triangles fill the shape", "[refine]")
{
    std::size_t shapes = 0;
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s)) || s.loops[0].size() > 400) continue;
        for (const double degrees : {0.0, 17.0}) {
            const test::shape turned = test::turned(s, degrees);
            if (!inspect::is_region(test::loops_of(turned))) continue;
            INFO(turned.name);
            const test::filled_shape shape{turned};
            test::refined_result out;
            REQUIRE_FALSE(refine_right({}, shape, out));
            CHECK(test::broken_refinement(shape.filled, out) == "");
            const test::wide_corners wide = test::wide_corners_of(out);
            CHECK(wide.above <= out.kept);
            CHECK((out.kept == 0) == (wide.above == 0));
            CHECK(1000 * wide.above <= out.triangles.size());
            ++shapes;
        }
    }
    CHECK(shapes > 20);
}

TEST_CASE("random polygons on a fine grid have no angle above 90.1 degrees", "[refine]")
{
    test::dice d{11};
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
        CHECK(wide.rounded > 0);
        CHECK(wide.greatest < 90.1);
    }
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
                         row{{.max_points = 1u << 30}, "max_points"}}) {
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

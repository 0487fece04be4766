// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_strips.hpp>

#include <typemesh/extrude/bevel_profile.hpp>

#include <cmath>

#include "support/catch.hpp"

using namespace typemesh;
using Catch::Approx;

namespace {

constexpr profile_scale wide_scale{3000.0, 4000.0, 0.0};

struct strips_of {
    buffer<bevel_strip> made;

    strips_of(const profile_points& points, float crease, bevel_shading shading = bevel_shading::by_slope)
    {
        REQUIRE(add_strips({points, wide_scale}, crease, shading, made));
    }
    [[nodiscard]] bevel_slopes slopes(bevel_shading shading = bevel_shading::by_slope) const
    {
        return {made.view(), wide_scale.depth, shading};
    }
};

bevel_vertex vertex_at(std::uint32_t strip, float share)
{
    bevel_vertex v;
    v.strip = strip;
    v.share = share;
    return v;
}

double degrees(bevel_tilt t)
{
    CHECK(std::hypot(t.out, t.up) == Approx(1.0));
    return std::atan2(t.up, t.out) * 57.29577951308232;
}

}  // namespace

TEST_CASE("a strip lies between each two levels, and a riser at a level with two heights", "[bevel_strips]")
{
    const strips_of s{{{0, 0}, {0, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.25f}, {1, 1}}, 30.0f};
    REQUIRE(s.made.size() == 4);
    const float run[] = {0.0f, 1500.0f, 0.0f, 1500.0f}, from[] = {0.0f, 0.5f, 0.5f, 0.25f},
                to[] = {0.5f, 0.5f, 0.25f, 1.0f};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(s.made[i].run == Approx(run[i]));
        CHECK(s.made[i].from == Approx(from[i]));
        CHECK(s.made[i].to == Approx(to[i]));
        CHECK_FALSE(s.made[i].smooth_before);
    }
    const bevel_slopes slopes = s.slopes();
    CHECK(degrees(slopes.tilt(vertex_at(0, 1.0f))) == Approx(0.0));
    CHECK(degrees(slopes.tilt(vertex_at(1, 0.0f))) == Approx(90.0));
    CHECK(std::abs(degrees(slopes.tilt(vertex_at(2, 0.0f)))) == Approx(180.0));
    CHECK(degrees(slopes.tilt(vertex_at(3, 0.0f))) == Approx(26.56505));
    CHECK(slopes.is_riser(vertex_at(0, 0.0f)));
    CHECK_FALSE(slopes.is_riser(vertex_at(1, 0.0f)));
    CHECK(s.made[1].smooth_after == false);
    CHECK(slopes.length(vertex_at(3, 1.0f)) == Approx(2000.0 + 1500.0 + 1000.0 + std::hypot(1500.0, 3000.0)));
    CHECK(slopes.length(vertex_at(1, 0.5f)) == Approx(2750.0));
}

TEST_CASE("heights equal those of a strip's ends to the bit, and are even between them", "[bevel_strips]")
{
    const strips_of s{{{0, 0}, {0.3f, 0.1f}, {1, 0.7f}}, 30.0f};
    const bevel_slopes slopes = s.slopes();
    CHECK(same(slopes.height(vertex_at(0, 1.0f)), 0.1f));
    CHECK(same(slopes.height(vertex_at(1, 0.0f)), 0.1f));
    CHECK(same(slopes.height(vertex_at(1, 1.0f)), 0.7f));
    CHECK(slopes.height(vertex_at(1, 0.5f)) == Approx(0.4));
}

TEST_CASE("strips that differ by less than the crease angle share the mean of their normals", "[bevel_strips]")
{
    // Drawn as wide as deep: 32.0 degrees to the wall, 36.2 between the strips, 21.8 to the cap.
    const profile_points bent{{0, 0}, {0.5f, 0.8f}, {1, 1}};
    const strips_of hard{bent, 36.0f}, soft{bent, 44.0f}, softer{bent, 65.0f};
    CHECK_FALSE(hard.made[0].smooth_after);
    CHECK_FALSE(hard.made[1].smooth_after);
    CHECK(soft.made[0].smooth_after);
    CHECK(soft.made[1].smooth_before);
    CHECK(soft.made[1].smooth_after);
    CHECK_FALSE(soft.made[0].smooth_before);
    CHECK(softer.made[0].smooth_before);
    const double lower = degrees(tilt_of(hard.made[0], 4000.0)), upper = degrees(tilt_of(hard.made[1], 4000.0));
    CHECK(lower == Approx(std::atan2(1500.0, 3200.0) * 57.29577951308232));
    CHECK(degrees(hard.slopes().tilt(vertex_at(0, 0.0f))) == Approx(lower));
    CHECK(degrees(hard.slopes().tilt(vertex_at(0, 1.0f))) == Approx(lower));
    CHECK(degrees(hard.slopes().tilt(vertex_at(1, 0.0f))) == Approx(upper));
    CHECK(degrees(soft.slopes().tilt(vertex_at(0, 0.0f))) == Approx(lower));
    CHECK(degrees(soft.slopes().tilt(vertex_at(0, 1.0f))) == Approx((lower + upper) / 2.0));
    CHECK(degrees(soft.slopes().tilt(vertex_at(1, 0.0f))) == Approx((lower + upper) / 2.0));
    CHECK(degrees(soft.slopes().tilt(vertex_at(1, 1.0f))) == Approx(90.0));
    CHECK(degrees(softer.slopes().tilt(vertex_at(0, 0.0f))) == Approx(0.0));

    const strips_of quarter{round_profile(6).at(wide_scale), 30.0f};
    const bevel_slopes slopes = quarter.slopes();
    for (std::uint32_t i = 1; i < 6; ++i) {
        const double below = degrees(tilt_of(quarter.made[i - 1], 4000.0)),
                     above = degrees(tilt_of(quarter.made[i], 4000.0));
        CHECK(degrees(slopes.tilt(vertex_at(i - 1, 1.0f))) == Approx((below + above) / 2.0));
        CHECK(degrees(slopes.tilt(vertex_at(i, 0.0f))) == Approx((below + above) / 2.0));
    }
}

TEST_CASE("the normal that two steep strips share is above both", "[bevel_strips]")
{
    const strips_of s{{{0, 0}, {0.5f, 1}, {1, 0}}, 180.0f};
    REQUIRE(s.made[0].smooth_after);
    for (const double depth : {4000.0, 1e5, 1e6}) {
        const bevel_slopes slopes{s.made.view(), depth, bevel_shading::by_slope};
        for (const bevel_tilt n : {slopes.tilt(vertex_at(0, 1.0f)), slopes.tilt(vertex_at(1, 0.0f))})
            for (const bevel_strip& strip : s.made) {
                const bevel_tilt own = tilt_of(strip, depth);
                CHECK(n.out * own.out + n.up * own.up > 0.0);
            }
    }
}

TEST_CASE("rounded shading turns from the wall to the cap with the profile's length", "[bevel_strips]")
{
    const strips_of s{{{0, 0}, {0.5f, 0.5f}, {1, 1}}, 0.0f, bevel_shading::rounded};
    CHECK(s.made[0].smooth_after);
    const bevel_slopes slopes = s.slopes(bevel_shading::rounded);
    CHECK(degrees(slopes.tilt(vertex_at(0, 0.0f))) == Approx(0.0));
    CHECK(degrees(slopes.tilt(vertex_at(0, 1.0f))) == Approx(45.0));
    CHECK(degrees(slopes.tilt(vertex_at(1, 0.0f))) == Approx(45.0));
    CHECK(degrees(slopes.tilt(vertex_at(1, 1.0f))) == Approx(90.0));
}

// Three steps turn by 30 degrees each, and by 15 at the ends: the default crease angle and half of it.
TEST_CASE("an angle equal to the crease angle is smooth at every width", "[bevel_strips]")
{
    for (int i = 0; i < 2000; ++i) {
        const double width = 500.0 + 7.3 * i;
        const profile_scale scale{width, width, 0.0};
        const profile_points points = round_profile(3).at(scale);
        buffer<bevel_strip> made;
        REQUIRE(add_strips({points, scale}, 30.0f, bevel_shading::by_slope, made));
        REQUIRE(made.size() == 3);
        for (const bevel_strip& s : made) {
            REQUIRE(s.smooth_before);
            REQUIRE(s.smooth_after);
        }
    }
}

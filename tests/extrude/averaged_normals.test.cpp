// SPDX-License-Identifier: MIT

#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/shared_normals.hpp>

#include "support/regions.hpp"
#include "walls.hpp"

#include <utility>

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

TEST_CASE("averaged normals are the normalised sums of two walls, and no point is doubled", "[extrude]")
{
    for (const auto& s : shapes::all()) {
        const built b = build(s, extruded<averaged_normals>{.texture = texture_mapping::box});
        CHECK(b.announced.vertices == 4 * s.points());
        for (std::uint32_t i = 0; i < s.points(); ++i) {
            const walls w = at(s, i);
            check_equal(b.vertices[b.first_vertex(part::side) + 2 * i].normal, w.before + w.after, 0.0);
        }
    }
}

TEST_CASE("at the tip of a needle the styles still give unit normals along it", "[extrude]")
{
    const shapes::shape needle{"needle", {shapes::polygon({{-524288, 0}, {524288, 0.001}, {-524288, 0.001}})}};
    REQUIRE(needle.loops.points[1] == grid_point{1 << 28, 1});
    const auto tip = [&](const auto& how) {
        const built b = build(needle, how);
        for (const auto& v : b.vertices) CHECK(meshes::length(v.normal) == Approx(1.0).margin(1e-6));
        return b.vertices;
    };
    CHECK(tip(extruded<averaged_normals>{.texture = texture_mapping::box})[6 + 2].normal.x == Approx(1.0));
    CHECK(tip(extruded<creased_normals>{.normals = {180.0f}}).size() == 12 + 2);
    CHECK(tip(extruded<curve_normals>{.normals = {180.0f}}).size() == 12 + 2);
    CHECK(tip(extruded<shared_normals>{})[1].normal == vec3{0.0f, 0.0f, 1.0f});
    CHECK(tip(extruded<shared_normals>{.front = false})[1].normal.x == Approx(1.0));
}

namespace {

/// The other side of the sharpest needle on the grid along u: cross(u, v) is 1, and v not longer than u.
grid_point beside(grid_point u)
{
    std::int64_t a = u.x, b = u.y, ax = 1, bx = 0, ay = 0, by = 1;  // Euclid: a = ax * u.x + ay * u.y
    while (b != 0) {
        const std::int64_t q = a / b;
        a = std::exchange(b, a - q * b);
        ax = std::exchange(bx, ax - q * bx);
        ay = std::exchange(by, ay - q * by);
    }
    if (a * a != 1) return {0, 0};  // the coordinates have a factor in common
    grid_point v{static_cast<std::int32_t>(-a * ay), static_cast<std::int32_t>(a * ax)};
    if (std::int64_t{v.x} * u.x + std::int64_t{v.y} * u.y < 0) v = {v.x + u.x, v.y + u.y};
    return v;
}

}  // namespace

TEST_CASE("averaged normals run along a needle at its tip, and along a notch that is as narrow", "[extrude]")
{
    // The walls' normals are as good as opposite: their sum is what rounding has left of them. Along a needle the two
    // edges' directions add up without loss.
    test::dice d{31};
    const std::int32_t reach = 1 << 27;
    int needles = 0;
    while (needles < 2000) {
        const grid_point u{d.roll(2 * reach) - reach, d.roll(2 * reach) - reach}, v = beside(u);
        if (v == grid_point{0, 0}) continue;
        ++needles;
        const grid_point tip{u.x / 2, u.y / 2}, a{tip.x - v.x, tip.y - v.y}, c{tip.x - u.x, tip.y - u.y};
        REQUIRE(orientation(a, tip, c) == 1);
        // A triangle, and the same as a hole: what is a tip in one is a notch in the other.
        const contours loops = test::contours_of({{a, tip, c}, {c, tip, a}});
        std::vector<side_point> sides(6);
        REQUIRE_FALSE(averaged_normals{}(region::proven(loops, 1, 1), sides));

        const double ul = std::hypot(double(u.x), double(u.y)), vl = std::hypot(double(v.x), double(v.y));
        const point along{u.x / ul + v.x / vl, u.y / ul + v.y / vl};
        INFO("needle along " << u.x << ", " << u.y << " and " << v.x << ", " << v.y);
        check_equal({sides[1].after.x, sides[1].after.y, 0.0f}, along, 0.0);
        check_equal({sides[4].after.x, sides[4].after.y, 0.0f}, -1.0 * along, 0.0);
    }
}

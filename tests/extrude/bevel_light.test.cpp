// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_light.hpp>

#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/texture.hpp>

#include <cmath>
#include <vector>

#include "plain_sweep.hpp"
#include "shapes.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using Catch::Approx;

namespace {

/// A shape, swept, with its light.
struct lit_shape {
    shapes::shape of;
    buffer<side_point> sides;
    swept_region swept;
    workspace space;
    workspace::scope scratch{space};
    bevel_light light{em_mapping::after_seam};

    lit_shape(shapes::shape s, double width, double mitre_limit = 0.0) : of{std::move(s)}
    {
        const region r = of.made();
        REQUIRE(plan_sides(r, curve_normals{}, texture_mapping::em, sides));
        const double levels[] = {0.0, width / 2.0, width};
        sweeps::plain_sweep{}(r, {levels, mitre_limit, 1.0}, swept);
        REQUIRE(light.prepare(r, sides.view(), swept, scratch));
    }
};

}  // namespace

TEST_CASE("along the paths of its corners an edge is lit like the ends of its wall", "[bevel_light]")
{
    lit_shape all[] = {{shapes::letter_e(), 10000.0}, {shapes::ring(8), 10000.0}, {shapes::letter_d(8), 10000.0}};
    for (const lit_shape& s : all) {
        INFO(s.of.name);
        for (const swept_edge_at& e : s.swept.edges_at) {
            const side_point &a = s.sides[e.edge], &b = s.sides[s.of.next(e.edge)];
            const auto from = s.light.at(e.edge, s.swept.nodes[e.a]), to = s.light.at(e.edge, s.swept.nodes[e.b]);
            const double slack = e.a < s.of.points() ? 1e-6 : 1e-3;  // nodes are rounded to the grid
            CHECK(length(from.outward - point{a.after.x, a.after.y}) < slack);
            CHECK(length(to.outward - point{b.before.x, b.before.y}) < slack);
            const double edge = b.along - (a.seam ? 0.0 : double(a.along));
            CHECK(from.along == Approx(a.seam ? 0.0 : double(a.along)).margin(edge * slack));
            CHECK(to.along == Approx(double(b.along)).margin(edge * slack));
            CHECK(length(from.outward) == Approx(1.0));
        }
    }
}

TEST_CASE("an edge's light changes evenly between its corners, and is constant beyond them", "[bevel_light]")
{
    const lit_shape s{shapes::rectangle(), 10000.0};  // its first edge runs from (100, 0) to (500, 0)
    const auto along = [&](double x, double y) {
        const swept_node n{{static_cast<std::int32_t>(x * 512), static_cast<std::int32_t>(y * 512)},
                           static_cast<float>(y * 512)};
        return s.light.at(0, n).along / 512.0;
    };
    CHECK(along(301, 0) == Approx(400.0));  // at distance 0 an edge has only two ends
    CHECK(along(300, 10) == Approx(200.0));
    CHECK(along(110, 10) == Approx(0.0).margin(1e-6));
    CHECK(along(205, 10) == Approx(100.0));
    CHECK(along(200, 100) == Approx(0.0).margin(1e-6));
    CHECK(along(150, 100) == Approx(0.0).margin(1e-6));
    CHECK(along(450, 100) == Approx(400.0));
    CHECK(along(350, 300) == Approx(200.0));  // beyond where its own two ways have met
}

TEST_CASE("joins turn from the wall before them to the wall after", "[bevel_light]")
{
    const lit_shape s{shapes::notch(), 10000.0, 2.0};
    REQUIRE(s.swept.joins.size() == 7);
    const std::uint32_t n = s.of.points(), tip = s.swept.joins[0].point;
    point last{s.sides[tip].before.x, s.sides[tip].before.y};
    for (std::uint32_t j = 0; j < 7; ++j)
        for (std::uint32_t k = s.swept.at_level[2]; k < s.swept.edges_at.size(); ++k) {
            const swept_edge_at& e = s.swept.edges_at[k];
            if (e.edge != n + j) continue;
            const auto from = s.light.at(e.edge, s.swept.nodes[e.a]), to = s.light.at(e.edge, s.swept.nodes[e.b]);
            CHECK(length(from.outward - last) < 1e-3);
            CHECK(cross(from.outward, to.outward) < 0.0);  // clockwise, as the corner turns
            CHECK(from.along == Approx(double(s.sides[tip].along)));
            last = to.outward;
        }
    CHECK(length(last - point{s.sides[tip].after.x, s.sides[tip].after.y}) < 1e-3);
}

// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/boundary_mover.hpp>

#include <cmath>
#include <vector>

#include "capped.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using Catch::Approx;

namespace {

/// Area of a shape whose edges have moved outwards, by Steiner's formula for polygons: exact as long as nothing meets.
double moved_area_at(const shapes::shape& s, double distance)
{
    double area = shapes::area_of(s.loops);
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        const grid_point a = s.loops.points[s.previous(i)], b = s.loops.points[i], c = s.loops.points[s.next(i)];
        const point in{double(b.x) - a.x, double(b.y) - a.y}, on{double(c.x) - b.x, double(c.y) - b.y};
        const double turn = std::atan2(cross(in, on), dot(in, on));
        area += distance * length(on) + distance * distance * std::tan(turn / 2.0);
    }
    return area;
}

struct moved {
    contours loops;
    buffer<curve> curves;
};

moved moved_by(const shapes::shape& s, double distance, const corner_rule& how)
{
    moved m;
    meshes::caps_by<> caps{s.made()};
    auto maker = caps.maker();
    boundary_mover move;
    REQUIRE(m.curves.append(s.loops.curves));
    REQUIRE_FALSE(move(s.made(), distance, how, maker, m.curves, m.loops));
    m.loops.curves = m.curves.view();
    return m;
}

}  // namespace

TEST_CASE("a moved boundary encloses the area of Steiner's formula, outwards and inwards", "[boundary_mover]")
{
    const shapes::shape all[] = {shapes::rectangle(), shapes::letter_e(), shapes::ring(8), shapes::letter_d(8),
                                 shapes::ribbon()};
    for (const auto& s : all)
        for (const double units : {-20.0, -3.0, 3.0, 20.0, 40.0}) {
            INFO(s.name << " by " << units);
            const moved m = moved_by(s, units * 512.0, {.mitre_limit = 0.0f});
            CHECK(shapes::area_of(m.loops) ==
                  Approx(moved_area_at(s, units * 512.0)).margin(2e6));  // a cell along all edges
            CHECK(m.curves.size() == s.curves.size());
            for (std::uint32_t i = 0; i < m.loops.points.size(); ++i) CHECK(m.loops.edges[i].curve < s.curves.size());
        }
}

TEST_CASE("less than four cells move nothing", "[boundary_mover]")
{
    const auto s = shapes::letter_d(8);
    for (const double distance : {0.0, 3.9, -3.9}) {
        const moved m = moved_by(s, distance, {});
        REQUIRE(m.loops.points.size() == s.points());
        for (std::uint32_t i = 0; i < s.points(); ++i) CHECK(m.loops.points[i] == s.loops.points[i]);
    }
    CHECK_FALSE(moved_by(s, 4.0, {}).loops.points[0] == s.loops.points[0]);
}

TEST_CASE("moved edges and joins run in the direction of their curves", "[boundary_mover]")
{
    shapes::shape sharp = shapes::spike();
    sharp.loops.tolerance = 50.0;
    const shapes::shape all[] = {shapes::ring(16), shapes::letter_d(16), shapes::ribbon(16), std::move(sharp)};
    for (const auto& s : all)
        for (const double units : {-20.0, 20.0}) {
            INFO(s.name << " by " << units);
            const moved m = moved_by(s, units * 512.0, {});
            CHECK(m.curves.size() >= s.curves.size());
            for (std::uint32_t k = 0; k < m.loops.contour_count(); ++k)
                for (std::uint32_t i = m.loops.starts[k], end = m.loops.starts[k + 1]; i < end; ++i) {
                    const contour_edge& e = m.loops.edges[i];
                    const grid_point a = m.loops.points[i],
                                     b = m.loops.points[i + 1 == end ? m.loops.starts[k] : i + 1];
                    const point along{double(b.x) - a.x, double(b.y) - a.y};
                    if (length(along) < 100.0) continue;
                    const double t = 0.5 * (double(e.t0) + double(e.t1));
                    const point direction = (e.t0 < e.t1 ? 1.0 : -1.0) * tangent(m.curves[e.curve], t, side_of::after);
                    CHECK(dot(along, direction) > std::cos(4.0 / 57.3) * length(along) * length(direction));
                }
        }
}

// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/cap_edges.hpp>

#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/offset/sweep_inwards.hpp>

#include <cmath>

#include "extrude/shapes.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct swept_shape {
    swept_region swept;
    buffer<curve> curves;
};

swept_shape swept_by(const shapes::shape& s, double units, double mitre_limit, double tolerance, bool round)
{
    swept_shape made;
    workspace space;
    workspace::scope scratch{space};
    const double levels[] = {0.0, units * 512.0};
    REQUIRE_FALSE(sweep_inwards(s.made(), s.cap, {levels, mitre_limit, tolerance}, scratch, made.swept));
    REQUIRE(made.curves.append(s.loops.curves));
    REQUIRE_FALSE(name_cap_edges(s.made(), round, made.swept, made.curves, scratch));
    return made;
}

/// Where a point of the cap lies before the curve of an edge that begins or ends there: its distances along the curve
/// and from it, in units.
struct foot {
    double along, away;
};
foot foot_of(const curve& c, double t, grid_point p)
{
    const point at{p.x / 512.0 - c.at(t).x, p.y / 512.0 - c.at(t).y}, d = tangent(c, t, side_of::after);
    return {dot(at, d) / length(d), std::fabs(cross(at, d)) / length(d)};
}

}  // namespace

TEST_CASE("an edge of the cap names the part of its curve that lies behind it", "[cap_edges]")
{
    for (const auto& s : {shapes::ring(32), shapes::letter_d(32), shapes::drop(64), shapes::ribbon(32)}) {
        INFO(s.name);
        const swept_shape made = swept_by(s, 20.0, 4.0, 0.0, true);
        const contours& cap = made.swept.cap;
        REQUIRE(cap.points.size() > 8);
        for (std::uint32_t k = 0; k < cap.contour_count(); ++k)
            for (std::uint32_t i = cap.starts[k], end = cap.starts[k + 1]; i < end; ++i) {
                const contour_edge& e = cap.edges[i];
                REQUIRE(e.curve < s.curves.size());
                CHECK(e.t0 != e.t1);  // NOLINT
                const curve& c = made.curves[e.curve];
                if (c.degree == 1) continue;
                const grid_point ends[] = {cap.points[i], cap.points[i + 1 == end ? cap.starts[k] : i + 1]};
                for (const int side : {0, 1}) {
                    const foot f = foot_of(c, double(side == 0 ? e.t0 : e.t1), ends[side]);
                    CHECK(f.away == Catch::Approx(20.0).margin(0.5));
                    CHECK(std::fabs(f.along) < 2.0);
                }
            }
    }
}

TEST_CASE("edges that follow each other on a curve still do so after they have moved", "[cap_edges]")
{
    const auto s = shapes::ring(16);
    const swept_shape made = swept_by(s, 20.0, 4.0, 0.0, true);
    const contours& cap = made.swept.cap;
    std::size_t joints = 0;
    for (std::uint32_t k = 0; k < cap.contour_count(); ++k)
        for (std::uint32_t i = cap.starts[k], end = cap.starts[k + 1]; i < end; ++i) {
            const contour_edge &e = cap.edges[i], &f = cap.edges[i + 1 == end ? cap.starts[k] : i + 1];
            if (e.curve != f.curve)
                ++joints;
            else
                CHECK(e.t1 == f.t0);  // NOLINT
        }
    CHECK(joints == 4 + 8);
}

TEST_CASE("joins have curves of their own: round ones turn from edge to edge, others are straight", "[cap_edges]")
{
    const shapes::shape notch{
        "notch", {shapes::polygon({{0, 0}, {600, 0}, {600, 600}, {330, 600}, {300, 200}, {270, 600}, {0, 600}})}};
    for (const bool round : {true, false}) {
        const swept_shape made = swept_by(notch, 20.0, 2.0, round ? 20.0 : 0.0, round);
        const auto joins = static_cast<std::uint32_t>(made.swept.joins.size());
        REQUIRE(made.curves.size() == notch.curves.size() + joins);
        REQUIRE((round ? joins > 3 : joins == 1));
        std::uint32_t seen = 0;
        const contours& cap = made.swept.cap;
        for (std::uint32_t i = 0; i < cap.points.size(); ++i) seen += cap.edges[i].curve >= notch.curves.size();
        CHECK(seen == joins);
        for (std::uint32_t j = 0; j < joins; ++j) {
            const curve& c = made.curves[notch.curves.size() + j];
            CHECK(c.degree == (round ? 2 : 1));
            const point own{double(made.swept.joins[j].inward.y), -double(made.swept.joins[j].inward.x)};
            const point middle = tangent(c, 0.5, side_of::after);
            CHECK(dot(own, middle) > 0.99 * length(middle));
            if (!round || j + 1 == joins) continue;
            const point last = tangent(c, 1.0, side_of::before),
                        next = tangent(made.curves[notch.curves.size() + j + 1], 0.0, side_of::after);
            CHECK(dot(last, next) == Catch::Approx(length(last) * length(next)));
        }
        if (!round) continue;
        const point in = tangent(made.curves[notch.curves.size()], 0.0, side_of::after),
                    on = tangent(made.curves[notch.curves.size() + joins - 1], 1.0, side_of::before);
        CHECK(in.x / in.y == Catch::Approx(30.0 / 400.0));
        CHECK(on.x / on.y == Catch::Approx(-30.0 / 400.0));
    }
}

TEST_CASE("an empty cap has no names", "[cap_edges]")
{
    const swept_shape made = swept_by(shapes::rectangle(), 250.0, 4.0, 0.0, true);
    CHECK(made.swept.cap.points.empty());
    CHECK(made.curves.size() == 4);
}

// SPDX-License-Identifier: MIT

#include <typemesh/extrude/flat.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include "mesh.hpp"
#include "support/counting_memory.hpp"
#include "support/curved_shape.hpp"
#include "support/random_outlines.hpp"

using namespace typemesh;
using namespace meshes;

static_assert(extruder<flat_curved> && capping_extruder<flat_curved> && has_front_triangles<flat_curved>);
static_assert(cacheable_policy<flat_curved> && extruder<one_of<flat, flat_curved>>);

namespace {

/// The contours of a shape as an outline, turned by an angle, and mirrored if `mirrored`.
outline outline_of(const shapes::shape& s, double degrees, bool mirrored)
{
    outline out;
    outline_recorder to{out};
    const double radians = degrees * 0.017453292519943295, cosine = std::cos(radians), sine = std::sin(radians);
    const auto placed = [&](point p) {
        const point q = mirrored ? point{-p.x, p.y} : p;
        return point{cosine * q.x - sine * q.y, sine * q.x + cosine * q.y};
    };
    bool first = true;
    point start{}, last{};
    for (const curve& c : s.curves) {
        if (first || !(c.start() == last)) {
            if (!first) to.close();
            to.move(placed(c.start()));
            start = c.start();
            first = false;
        }
        if (c.degree == 1) to.line(placed(c.p[1]));
        if (c.degree == 2) to.quadratic(placed(c.p[1]), placed(c.p[2]));
        if (c.degree == 3) to.cubic(placed(c.p[1]), placed(c.p[2]), placed(c.p[3]));
        last = c.end();
    }
    to.close();
    REQUIRE_FALSE(to.finish());
    out.rule = fill_rule::even_odd;  // holes of shapes run as their outer contours
    return out;
}

}  // namespace

TEST_CASE("curved triangles do not overlap, and the shader fills what the curves fill", "[extrude][curved]")
{
    for (const auto& s : shapes::all())
        for (const double degrees : {0.0, 203.5})
            for (const bool mirrored : {false, true}) {
                INFO(s.name << " turned by " << degrees << (mirrored ? ", mirrored" : ""));
                const outline curves = outline_of(s, degrees, mirrored);
                for (const double tolerance : {0.0, 1.0 / 800, 1.0 / 100}) {
                    INFO("tolerance " << tolerance);
                    test::curved_shape made;
                    REQUIRE_FALSE(made.make(curves, 1000.0, tolerance));
                    CHECK(test::broken_curved(made) == "");
                    CHECK_FALSE(made.gave_up());
                    const auto wrong = test::sample(made, curves, tolerance > 0.0 ? 100 : 300, 3.0);
                    CAPTURE(wrong.farthest);
                    CHECK(wrong.far_away == 0);
                }
            }
}

TEST_CASE("a curve needs one triangle, and its number does not depend on the tolerance", "[extrude][curved]")
{
    // Eight quadratics: a triangle for each, and an inner polygon of eight points.
    const shapes::shape disc{"disc", {shapes::quadratic_circle({0, 0}, 400)}};
    for (const double tolerance : {1.0 / 100, 1.0 / 800, 1.0 / 16000, 0.0}) {
        CAPTURE(tolerance);
        test::curved_shape made;
        REQUIRE_FALSE(made.make(outline_of(disc, 0.0, false), 1000.0, tolerance));
        CHECK(made.curve_triangles() == 8);
        CHECK(made.mesh.triangles.size() == 8 + 6);
        CHECK(made.mesh.vertices.size() == 8 + 3 * 8);
        // Three arcs for each of the four cubics.
        REQUIRE_FALSE(
            made.make(outline_of({"disc", {shapes::cubic_circle({0, 0}, 400)}}, 0.0, false), 1000.0, tolerance));
        CHECK(made.curve_triangles() == 12);
    }
}

TEST_CASE("curved triangles of hostile outlines do not overlap either", "[extrude][curved]")
{
    std::size_t usable = 0, curves = 0, without = 0;
    // Small loops that turn over if their crossings are moved; the last one may turn over in any case.
    std::vector<std::uint64_t> seeds{1851, 2252, 2261, 3472};
    for (std::uint64_t seed = 1; seed <= 30; ++seed) seeds.push_back(seed);
    for (const std::uint64_t seed : seeds) {
        const test::random_outline hostile{seed};
        if (!hostile.is_usable()) continue;
        INFO("seed " << seed << ": " << hostile.kind);
        for (const double tolerance : {1.0 / 16000, 1.0 / 160}) {
            test::curved_shape made;
            REQUIRE_FALSE(made.make(hostile.curves, hostile.units_per_em, tolerance));
            if (made.mesh.triangles.size() > 4000) continue;
            CHECK(test::broken_curved(made) == "");
            without += made.gave_up();
            ++usable;
            curves += made.curve_triangles();
            const double allowed = made.filled.tolerance() + 4.5;
            CHECK(test::sample(made, hostile.curves, 40, allowed, seed).far_away == 0);
        }
    }
    CAPTURE(usable, curves);
    CHECK(usable > 30);
    CHECK(curves > 100);
    CHECK(without <= 1);
}

TEST_CASE("curved shapes without memory say so, and ask for none once they are warm", "[extrude][curved]")
{
    const outline curves = outline_of(shapes::letter_d(), 0.0, false);
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        test::curved_shape made{memory.source()};
        const error e = made.make(curves, 1000.0, 1.0 / 800);
        was_asked = memory.requests >= nth;
        if (e) CHECK(e == error::out_of_memory);
        memory.fail_at = 0;
        REQUIRE_FALSE(made.make(curves, 1000.0, 1.0 / 800));
        REQUIRE_FALSE(made.make(curves, 1000.0, 1.0 / 800));
        const std::size_t warm = memory.requests;
        REQUIRE_FALSE(made.make(curves, 1000.0, 1.0 / 800));
        CHECK(memory.requests == warm);
    }
}

TEST_CASE("other extruders leave the attribute curve inside", "[extrude][curved]")
{
    const auto s = shapes::letter_d();
    mesh<attribute::position | attribute::curve> m;
    REQUIRE(extrude(s.made(), s.cap, flat{}, in_em(), m));
    REQUIRE_FALSE(m.vertices.empty());
    for (const auto& v : m.vertices) CHECK(v.curve == vec3{-1.0f, 0.0f, 0.0f});
}

TEST_CASE("curved plans of nothing are empty", "[extrude][curved]")
{
    CHECK(refused_options(flat_curved{}) == error::none);
    flat_curved_data data;
    no_caps nothing;
    const auto plan = plan_solid(flat_curved{}, region{}, data, nothing);
    REQUIRE(plan);
    CHECK(plan->sizes.total() == mesh_size{});
}

// SPDX-License-Identifier: MIT

// Glyphs of all smoke fonts, carved: closed, and as deep as they are far from the outline, on slopes and on ridges.

#include "support/bevel_surface.hpp"
#include "support/catch.hpp"
#include "support/regions.hpp"
#include "support/ridge_laws.hpp"
#include "support/smoke_glyphs.hpp"
#include "support/solid_in_cells.hpp"

#include <typemesh/extrude/carved.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_view.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

using namespace typemesh;

namespace {

/// The worst of all glyphs, in cells.
struct carved_errors {
    std::size_t solids = 0, narrowed = 0, points = 0, lines = 0, lone = 0, valleys = 0, touching = 0;
    double too_deep = 0.0, too_shallow = 0.0;  ///< of random points of the slopes; the latter beyond the tolerance
    double ridge_too_deep = 0.0, ridge_too_shallow = 0.0;
};

void check_carved(const region& r, cap_builder& caps, const carved& how, test::dice& d, carved_errors& sum)
{
    carved_data data;
    test::bevel_surface mesh;
    const double em = test::em_of(r);
    const auto plan = test::write_in_cells(how, r, caps, em, data, mesh);
    REQUIRE(plan);
    ++sum.solids;
    sum.narrowed += plan->narrowed;
    CHECK(inspect::check_closedness(inspect::mesh_view{mesh.vertices, mesh.indices}).is_closed());
    const auto own = data.own.of<carved_depth>().view()[0];
    const double slope = std::tan(double(how.tool_angle) * 3.14159265358979323846 / 360.0), tolerance = r.tolerance();
    const test::plain_outline outline{r};
    const auto slopes = mesh.triangles_of(part::front_bevel);
    REQUIRE(slopes.end > slopes.begin);
    for (int k = 0; k < 24; ++k) {
        const std::size_t t = slopes.begin + static_cast<std::size_t>(d.roll(int(slopes.end - slopes.begin)));
        double a = d.fraction(), b = d.fraction();
        if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
        const auto p = mesh.corner(t, 0), q = mesh.corner(t, 1), s = mesh.corner(t, 2);
        const auto mixed = [a, b](double u, double v, double w) { return u + a * (v - u) + b * (w - u); };
        const double x = mixed(p.x, q.x, s.x), y = mixed(p.y, q.y, s.y), z = mixed(p.z, q.z, s.z);
        const double off = z * slope - outline.distance(x, y);
        sum.too_deep = (std::max)(sum.too_deep, off);
        sum.too_shallow = (std::max)(sum.too_shallow, -off - tolerance);
    }
    const auto floor = mesh.triangles_of(part::front);
    const float top = static_cast<float>(double(own.depth) * em);
    for (std::size_t t = floor.begin; t < floor.end; ++t) CHECK(mesh.vertices[mesh.indices[3 * t]].z == top);
    const auto ridges = data.own.of<ridge_point>().view();
    const test::ridge_laws laws{r, ridges, tolerance, how.max_depth > 0.0f ? double(own.reach) : 0.0};
    sum.points += laws.points;
    sum.lines += laws.lines;
    sum.lone += laws.lone;
    sum.valleys += laws.valleys;
    sum.ridge_too_deep = (std::max)(sum.ridge_too_deep, laws.too_deep);
    sum.ridge_too_shallow = (std::max)(sum.ridge_too_shallow, laws.too_shallow);
    if (r.is_touching())
        ++sum.touching;  // outlines that touch themselves join the places of two ridges
    else
        CHECK(laws.broken() == "");
}

}  // namespace

TEST_CASE("every smoke font's glyphs are carved as deep as they are far from the outline", "[workload][ridges]")
{
    cap_builder caps;
    outline drawn;
    carved_errors sum;
    test::dice d{32};
    test::each_smoke_glyph(401, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        if (!record(font, glyph, drawn) || drawn.curves.empty()) return;
        for (const double tolerance : {1.0 / 100, 1.0 / 800}) {
            const region r = test::region_of(caps, drawn, font.units_per_em(), tolerance);
            if (r.points().empty() || r.points().size() > 2000) continue;
            INFO(name << " at " << tolerance);
            check_carved(r, caps, {.tool_angle = 60.0f, .ridges = true}, d, sum);
            check_carved(r, caps, {.tool_angle = 100.0f, .max_depth = 0.02f, .ridges = true}, d, sum);
        }
    });
    CAPTURE(sum.solids, sum.points, sum.lines, sum.lone, sum.valleys, sum.touching);
    CAPTURE(sum.too_deep, sum.too_shallow, sum.ridge_too_deep, sum.ridge_too_shallow);
    CHECK(sum.solids > 1000);
    CHECK(sum.lines > 10 * sum.solids);
    CHECK(sum.narrowed == 0);
    CHECK(sum.too_deep < 4.0);
    CHECK(sum.too_shallow < 4.0);
    CHECK(sum.ridge_too_deep < 4.0);
    CHECK(sum.ridge_too_shallow < 4.0);
    CHECK(sum.valleys < sum.points / 100);
}

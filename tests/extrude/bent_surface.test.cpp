// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bent_surface.hpp>

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/taper.hpp>
#include <typemesh/bend/twist.hpp>

#include <cmath>
#include <vector>

#include "mesh.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;
using namespace meshes;

namespace {

/// A map of one's own: turned by an angle around the baseline, then scaled.
struct turned_and_scaled {
    double cosine = 1.0;
    double sine = 0.0;
    double factor = 1.0;
    double rough = 0.0;  ///< claimed as a bound of triangles that begin at this x
    double rough_at = 0.0;

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const double3 x{factor, 0.0, 0.0}, y{0.0, factor * cosine, factor * sine},
            z{0.0, -factor * sine, factor * cosine};
        return {p.x * x + p.y * y + p.z * z, x, y, z};
    }
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept { return {.xx = b.low.x <= rough_at ? rough : 0.0}; }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

/// Receives what a solid writes flat, and keeps it bent.
template <deformation D>
mesh<everything> mesh_bent_by(const shapes::shape& s, const D& how, const placement& at)
{
    const detail::bent_axes<D> axes{how, at};
    mesh<everything> out = build(s, extruded<>{}, axes.flat());
    for (auto& v : out.vertices) v = axes.template bend<everything>(v);
    return out;
}

}  // namespace

TEST_CASE("vertices under a deformation that does nothing are those of the placed solid", "[extrude][bent_surface]")
{
    frame mirrored = right_handed_y_up;
    mirrored.right = {-1.0f, 0.0f, 0.0f};
    const frame lying{.right = {0.0f, 1.0f, 0.0f}, .up = {0.0f, 0.0f, 1.0f}, .toward = {1.0f, 0.0f, 0.0f}};
    for (const auto& s : shapes::all())
        for (const frame& f : {right_handed_y_up, mirrored, lying}) {
            INFO(s.name);
            placement at = in_em(f);
            at.unit_per_cell *= 24.0;  // 24 units per em
            at.unit_per_depth = 24.0;
            at.em_pen = {40'000.0, -3'000.0};
            at.pen = {90'000.0, 11'000.0};
            const built placed = build(s, extruded<>{}, at);
            const auto same = mesh_bent_by(s, turned_and_scaled{}, at);
            REQUIRE(same.vertices.size() == placed.vertices.size());
            double off = 0.0, turned = 0.0;
            std::size_t other_hands = 0;
            for (std::size_t i = 0; i < same.vertices.size(); ++i) {
                const auto &a = same.vertices[i], &b = placed.vertices[i];
                off = (std::max)(off, length(detail::as_double3(a.position) - detail::as_double3(b.position)));
                turned = (std::max)(turned, length(detail::as_double3(a.normal) - detail::as_double3(b.normal)));
                const double3 ta{double{a.tangent.x}, double{a.tangent.y}, double{a.tangent.z}},
                    tb{double{b.tangent.x}, double{b.tangent.y}, double{b.tangent.z}};
                turned = (std::max)(turned, length(ta - tb));
                other_hands += a.tangent.w != b.tangent.w;
                CHECK_QUICKLY(a.uv == b.uv);
                CHECK_QUICKLY(a.part == b.part);
            }
            CHECK(off < 3e-5);  // 24 units of 2^-24
            CHECK(turned < 1e-6);
            CHECK(other_hands == 0);
        }
}

TEST_CASE("normals stay perpendicular to the bent surface, and tangents lie in it", "[extrude][bent_surface]")
{
    const auto check = [](const auto& how) {
        const placement at = in_em();
        const detail::bent_axes axes{how, at};
        for (const auto& s : shapes::all()) {
            const built flat_form = build(s, extruded<>{}, axes.flat());
            for (const auto& v : flat_form.vertices) {
                const auto bent_v = axes.template bend<everything>(v);
                // A small step in the flat surface, bent, by differences: no derivative of the deformation is used.
                const double3 n = detail::as_double3(v.normal), p = detail::as_double3(v.position),
                              side = cross(n, std::fabs(n.z) < 0.9 ? double3{0.0, 0.0, 1.0} : double3{1.0, 0.0, 0.0});
                const auto step = [&](double3 way) { return 5e3 * (how(p + 1e-4 * way).at - how(p - 1e-4 * way).at); };
                const double3 one = step(side), other = step(cross(n, side)),
                              normal = detail::as_double3(bent_v.normal);
                CHECK_QUICKLY(std::fabs(dot(normal, one)) < 1e-5 && std::fabs(dot(normal, other)) < 1e-5);
                CHECK_QUICKLY(dot(normal, cross(one, other)) > 0.0);  // (side, n x side, n) is right-handed
                CHECK_QUICKLY(std::fabs(length(normal) - 1.0) < 1e-6);
                const double3 t{double{bent_v.tangent.x}, double{bent_v.tangent.y}, double{bent_v.tangent.z}};
                CHECK_QUICKLY(std::fabs(length(t) - 1.0) < 1e-6 && std::fabs(dot(t, normal)) < 1e-6);
                CHECK_QUICKLY(std::fabs(bent_v.tangent.w) == 1.0f);
            }
        }
    };
    check(on_cylinder{.radius = 0.7});
    check(on_cylinder{.radius = -3.0, .axis = text_axis::along});
    check(twist{.degrees_per_em = 70.0, .across = 0.35});
    check(taper{.growth = 0.6});
}

TEST_CASE("a bent surface knows its greatest error and its bounds", "[extrude][bent_surface]")
{
    buffer<double3> places;
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const extruded<> how;
        plan_data_of<extruded<>> data;
        no_caps nothing;
        const auto plan = plan_solid(how, s.made(), data, nothing);
        REQUIRE(plan);
        const solid_of<extruded<>> form{{s.loops.points.view(), s.loops.starts.view(), s.cap}, data.read()};
        const on_cylinder ring{.radius = 1.0};
        const detail::bent_axes axes{ring, in_em()};
        detail::bent_surface surface{ring, places};
        REQUIRE_FALSE(surface.read(how, form, *plan, axes.flat()));
        CHECK_FALSE(surface.turns());
        const on_cylinder narrow{.radius = 0.05};  // the letters go around it several times
        detail::bent_surface rolled{narrow, places};
        REQUIRE_FALSE(rolled.read(how, form, *plan, axes.flat()));
        CHECK(rolled.turns());
        const built flat_form = build(s, how, axes.flat());
        const box3 around = surface.bounds();
        double worst = 0.0;
        for (const auto& t : flat_form.triangles) {
            double3 p[3];
            for (int k = 0; k < 3; ++k) p[k] = detail::as_double3(flat_form.vertices[t[std::size_t(k)]].position);
            for (int k = 0; k < 3; ++k) {
                const double3 &from = p[k], &to = p[(k + 1) % 3], image = ring(from).at;
                worst = (std::max)(worst, length(ring(0.5 * (from + to)).at - 0.5 * (image + ring(to).at)));
                CHECK_QUICKLY(image.x >= around.low.x && image.y >= around.low.y && image.z >= around.low.z &&
                              image.x <= around.high.x && image.y <= around.high.y && image.z <= around.high.z);
            }
        }
        CHECK(surface.greatest_error() >= worst);
        CHECK(surface.greatest_error() < 4.0 * worst + 1e-12);

        const turned_and_scaled rigid{.cosine = 0.6, .sine = 0.8, .factor = 2.0};
        detail::bent_surface straight{rigid, places};
        REQUIRE_FALSE(straight.read(how, form, *plan, axes.flat()));
        CHECK(straight.greatest_error() == 0.0);
#ifndef __FAST_MATH__  // there no number is a NaN
        // What is no number in a single place is not lost.
        const turned_and_scaled broken{.rough = std::nan(""), .rough_at = 0.5 * straight.bounds().low.x + 1e-9};
        detail::bent_surface unknown{broken, places};
        REQUIRE_FALSE(unknown.read(how, form, *plan, axes.flat()));
        CHECK_FALSE(unknown.greatest_error() <= 1e300);
#endif

        test::counting_memory memory{.fail_at = 1};
        buffer<double3> scarce{memory.source()};
        detail::bent_surface poor{ring, scarce};
        CHECK(poor.read(how, form, *plan, axes.flat()) == error::out_of_memory);
    }
}

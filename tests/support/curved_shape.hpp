// SPDX-License-Identifier: MIT
#pragma once

// An outline that flat_curved has made triangles of, and their laws. The shader's formula is evaluated here, in doubles.

#include "support/catch.hpp"

#include <typemesh/core/orientation.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// A vertex in cells.
struct curved_vertex {
    typemesh::vec3 position;
    typemesh::vec3 curve;
};

/// What the shader draws of a mesh.
class shaded_mesh {
public:
    static constexpr auto wants = typemesh::attribute::position | typemesh::attribute::curve;

    std::vector<curved_vertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    typemesh::mesh_size announced;

    // --- a sink

    typemesh::error begin(typemesh::mesh_size exact) noexcept
    {
        announced = exact;
        return {};
    }
    void vertex(const typemesh::surface_point<wants>& s) noexcept { vertices.push_back({s.position, s.curve}); }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { triangles.push_back({a, b, c}); }
    void end() noexcept {}

    // --- the picture

    /// Below 0 inside; 1 where there is no triangle.
    [[nodiscard]] double at(typemesh::point q) const
    {
        double least = 1.0;
        for (const auto& t : triangles) {
            const auto &u = vertices[t[0]], &v = vertices[t[1]], &w = vertices[t[2]];
            const typemesh::point a{double{u.position.x}, double{u.position.y}},
                b{double{v.position.x}, double{v.position.y}}, c{double{w.position.x}, double{w.position.y}};
            const double area = cross(b - a, c - a), of_a = cross(b - q, c - q) / area,
                         of_b = cross(c - q, a - q) / area, of_c = 1.0 - of_a - of_b;
            if (of_a < 0.0 || of_b < 0.0 || of_c < 0.0) continue;
            const auto mixed = [&](float x, float y, float z) {
                return of_a * double{x} + of_b * double{y} + of_c * double{z};
            };
            const double x = mixed(u.curve.x, v.curve.x, w.curve.x), y = mixed(u.curve.y, v.curve.y, w.curve.y),
                         z = mixed(u.curve.z, v.curve.z, w.curve.z);
            least = (std::min)(least, x * std::abs(x) - y * z);
        }
        return least;
    }

    /// The triangles as grid points.
    [[nodiscard]] std::vector<std::array<typemesh::grid_point, 3>> on_grid() const
    {
        std::vector<std::array<typemesh::grid_point, 3>> all;
        for (const auto& t : triangles) {
            auto& corners = all.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto p = vertices[t[k]].position;
                corners[k] = {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)};
            }
        }
        return all;
    }
};

/// An outline, its region, and its curved triangles.
class curved_shape {
public:
    explicit curved_shape(typemesh::memory source = typemesh::heap()) : caps_{source}, further_{source}, data{source} {}

    typemesh::region filled;
    typemesh::solid_plan plan;
    shaded_mesh mesh;

private:
    typemesh::cap_builder caps_, further_;

public:
    typemesh::flat_curved_data data;

    /// Plans and writes an outline. `tolerance` is in em, or 0 for the finest.
    [[nodiscard]] typemesh::error make(const typemesh::outline& curves, double units_per_em, double tolerance)
    {
        using namespace typemesh;
        static const certified flatten;
        static const monotone cut;
        no_observer nobody;
        const auto cells = grid::fitting(units_per_em, curves.bounds);
        if (!cells) return cells.error();
        const double finest = 2.0 * cells->snap_error(), wanted = tolerance * units_per_em;
        const auto made = caps_.build(curves, wanted > finest ? wanted : finest, *cells, {curves.rule},
                                      cap_policies{flatten, cut, nobody});
        if (!made) return made.error();
        return make(*made, caps_.triangles().view());
    }

    /// Plans and writes a region.
    [[nodiscard]] typemesh::error make(const typemesh::region& r, typemesh::array_view<const typemesh::triangle> cap)
    {
        using namespace typemesh;
        static const monotone cut;
        filled = r;
        data.clear();
        region_caps maker{caps_, further_, cut, cap};
        const flat_curved how;
        const auto planned = how.plan(filled, data, maker);
        if (!planned) return planned.error();
        plan = *planned;
        mesh = {};
        const solid_of<flat_curved> form{{r.points(), r.starts(), cap}, data.read()};
        return write_solid<flat_curved>({form, plan}, how, placement{}, mesh).error();
    }

    [[nodiscard]] std::size_t curve_triangles() const { return data.read().of<typemesh::curve_triangle>().size(); }

    /// Whether the region itself was taken, without curves.
    [[nodiscard]] bool gave_up() const
    {
        bool has_arcs = false;
        for (const auto& p : data.boundary.pieces()) has_arcs = has_arcs || !p.is_straight();
        return has_arcs && curve_triangles() == 0;
    }
};

/// The first law of the triangles that is broken; "" if none is. Exact, except for the last: the area of curves that are
/// parabolas, compared with the region's.
[[nodiscard]] inline std::string broken_curved(const curved_shape& s)
{
    using namespace typemesh;
    if (s.mesh.vertices.size() != s.mesh.announced.vertices) return "the number of vertices";
    if (s.mesh.triangles.size() != s.mesh.announced.triangles) return "the number of triangles";
    const auto triangles = s.mesh.on_grid();
    const auto separates = [](const auto& a, const auto& b) {
        for (std::size_t k = 0; k < 3; ++k) {
            bool all = true;
            for (const grid_point p : b) all = all && orientation(a[k], a[(k + 1) % 3], p) <= 0;
            if (all) return true;
        }
        return false;
    };
    std::vector<std::array<grid_point, 3>> by_x = triangles;
    const auto left = [](const auto& t) { return (std::min)({t[0].x, t[1].x, t[2].x}); };
    const auto right = [](const auto& t) { return (std::max)({t[0].x, t[1].x, t[2].x}); };
    std::sort(by_x.begin(), by_x.end(), [&](const auto& a, const auto& b) { return left(a) < left(b); });
    for (std::size_t i = 0; i < by_x.size(); ++i) {
        if (orientation(by_x[i][0], by_x[i][1], by_x[i][2]) <= 0) return "a triangle is not counter-clockwise";
        for (std::size_t k = i + 1; k < by_x.size() && left(by_x[k]) < right(by_x[i]); ++k)
            if (!separates(by_x[i], by_x[k]) && !separates(by_x[k], by_x[i])) return "two triangles overlap";
    }
    // A tip where contours cross may have moved to where their curves do: curved_boundary::move_crossing().
    const double beyond = s.data.boundary.moved() != 0 ? 4.0 * s.filled.tolerance() + 4.0 : 3.0;
    for (const grid_point p : s.filled.points())
        if (p.x < s.plan.around.low.x - beyond || p.x > s.plan.around.high.x + beyond) return "the box";

    double area = 0.0, of_region = 0.0, around = 0.0;
    const auto data = s.data.read();
    for (const triangle t : data.of<triangle>()) {
        const auto p = data.of<grid_point>();
        area += 0.5 * static_cast<double>(orientation(p[t.a], p[t.b], p[t.c]));
    }
    for (const curve_triangle& t : data.of<curve_triangle>()) {
        if (t.weight < 1.0f || t.weight > 1.0f) return {};
        const auto whole = static_cast<double>(orientation(t.corners[0], t.corners[1], t.corners[2]));
        area += (t.concave != 0 ? 1.0 : 2.0) / 6.0 * whole;
    }
    for (std::uint32_t l = 0; l < s.filled.loop_count(); ++l)
        for (std::uint32_t i = s.filled.starts()[l], end = s.filled.starts()[l + 1]; i < end; ++i) {
            const point p = placement::exact(s.filled.points()[i]),
                        q = placement::exact(s.filled.points()[i + 1 < end ? i + 1 : s.filled.starts()[l]]);
            of_region += 0.5 * cross(p, q);
            around += length(q - p);
        }
    const double allowed = s.filled.tolerance() > 0.0 ? s.filled.tolerance() + 2.0 : 1e300;
    return std::abs(area - of_region) <= allowed * (around + 4.0) ? "" : "the area";
}

/// The places in which the shader's picture differs from the curves' fill, and their distances from the curves.
struct wrong_places {
    std::size_t places = 0;
    std::size_t far_away = 0;  ///< the number of those farther than `allowed`
    double farthest = 0.0;
};

/// Samples the picture: half of the places anywhere in the outline's box, half near the curves.
[[nodiscard]] inline wrong_places sample(const curved_shape& s, const typemesh::outline& curves, std::size_t places,
                                         double allowed, std::uint64_t seed = 1)
{
    using namespace typemesh;
    wrong_places found;
    if (curves.curves.empty()) return found;
    const double cells = s.filled.grid().cells;
    const inspect::curve_chords chords{curves, cells, 0.1};
    std::uint64_t state = seed * 0x9E37'79B9'7F4A'7C15u | 1;
    const auto fraction = [&state] {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return static_cast<double>(state >> 11) * 0x1p-53;
    };
    for (std::size_t i = 0; i < places; ++i) {
        const box& b = curves.bounds;
        point q = cells * point{b.low.x + fraction() * b.width(), b.low.y + fraction() * b.height()};
        if (i % 2 != 0) {
            const curve& c =
                curves.curves[static_cast<std::size_t>(fraction() * static_cast<double>(curves.curves.size()))];
            const double angle = 6.283185307179586 * fraction(),
                         away = allowed + (i % 4 == 1 ? 3.0 : 60.0) * fraction();
            q = cells * c.at(fraction()) + away * point{std::cos(angle), std::sin(angle)};
        }
        ++found.places;
        if ((s.mesh.at(q) < 0.0) == is_filled(curves.rule, chords.winding(q))) continue;
        const double distance = std::sqrt(inspect::curve_chords::squared_distance(q, chords.all()));
        found.farthest = (std::max)(found.farthest, distance);
        found.far_away += distance > allowed;
    }
    return found;
}

}  // namespace test

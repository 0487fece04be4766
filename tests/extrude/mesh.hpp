// SPDX-License-Identifier: MIT
#pragma once

// Meshes collected whole, and what their laws need.

#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/shared_normals.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "shapes.hpp"
#include "support/catch.hpp"
#include "support/mesh_laws.hpp"

namespace meshes {

using namespace typemesh;

inline constexpr attribute everything = attribute::position | attribute::normal | attribute::uv | attribute::tangent |
                                        attribute::glyph | attribute::cluster | attribute::part;

/// 1000 font units to the em, 512 cells to the unit; positions in em.
inline placement in_em(const frame& f = right_handed_y_up)
{
    placement at;
    at.unit_per_cell = at.em_per_cell = 1.0 / 512000.0;
    at.frame = f;
    return at;
}

/// Box mapping over the shape's own box, which holds this many tiles.
inline placement over_box(const shapes::shape& s, const frame& f, point tiles = {1.0, 1.0})
{
    box b;
    for (const grid_point g : s.loops.points) b.add(point{static_cast<double>(g.x), static_cast<double>(g.y)});
    placement at = in_em(f);
    at.texture_pen = -1.0 * b.low;
    at.texture_per_cell = {tiles.x / b.width(), tiles.y / b.height()};
    return at;
}

/// A mesh as a sink gets it.
template <attribute Wants = everything>
struct mesh {
    static constexpr attribute wants = Wants;

    std::vector<surface_point<Wants>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    mesh_size announced;
    int begun = 0, ended = 0;
    bool in_order = true;

    error begin(mesh_size exact) noexcept
    {
        announced = exact;
        ++begun;
        return {};
    }
    void vertex(const surface_point<Wants>& v) noexcept
    {
        in_order = in_order && begun == 1 && triangles.empty() && ended == 0;
        vertices.push_back(v);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        in_order = in_order && vertices.size() == announced.vertices && ended == 0;
        triangles.push_back({a, b, c});
    }
    void end() noexcept { ++ended; }
};

/// The mesh with what was planned of it.
struct built : mesh<everything> {
    part_sizes sizes;
    std::vector<side_point> sides;

    std::uint32_t first_vertex(part p) const { return sum_before(p, sizes.vertices); }
    std::uint32_t first_triangle(part p) const { return sum_before(p, sizes.triangles); }
    /// The last triangle of one part, and one more.
    std::uint32_t end_triangle(part p) const { return first_triangle(p) + sizes.triangles[p]; }
    std::uint32_t doubled() const
    {
        std::uint32_t n = 0;
        for (const side_point& s : sides) n += s.doubled;
        return n;
    }

private:
    template <class Counts>
    static std::uint32_t sum_before(part p, const Counts& counts)
    {
        std::uint32_t sum = 0;
        for (const part q : all_parts) sum += q < p ? counts[q] : 0;
        return sum;
    }
};

template <class E>
built build(const shapes::shape& s, const E& how, const placement& at = in_em())
{
    built b;
    plan_data_of<E> data;
    no_caps nothing;
    const region r = s.made();
    if (const auto plan = plan_solid(how, r, data, nothing))
        b.sizes = plan->sizes;
    else
        std::abort();
    if (!extrude(r, s.cap, how, at, data, static_cast<mesh<everything>&>(b))) std::abort();
    if constexpr (requires { data.template of<side_point>(); }) {
        const auto sides = data.read().template of<side_point>();
        b.sides.assign(sides.begin(), sides.end());
    }
    return b;
}

inline placement with_box_texture(placement at)
{
    at.texture_per_cell = {1.0 / 512000.0, 1.0 / 512000.0};
    return at;
}

/// Two meshes have equal vertices, to the bit, and equally many triangles.
template <class A, class B>
void check_same_vertices(const A& a, const B& b)
{
    REQUIRE(a.vertices.size() == b.vertices.size());
    CHECK(a.triangles.size() == b.triangles.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        CHECK(a.vertices[i].position == b.vertices[i].position);
        CHECK(a.vertices[i].normal == b.vertices[i].normal);
        CHECK(a.vertices[i].uv == b.vertices[i].uv);
        CHECK(a.vertices[i].tangent == b.vertices[i].tangent);
    }
}

/// Two meshes are equal to the bit.
template <class A, class B>
void check_same(const A& a, const B& b)
{
    check_same_vertices(a, b);
    CHECK(a.triangles == b.triangles);
}

/// A vector in double precision.
using wide_vec = std::array<double, 3>;

inline wide_vec wide(vec3 v) { return {v.x, v.y, v.z}; }
inline wide_vec wide(vec4 v) { return {v.x, v.y, v.z}; }
inline wide_vec minus(wide_vec a, wide_vec b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline wide_vec scaled(double s, wide_vec a) { return {s * a[0], s * a[1], s * a[2]}; }
inline wide_vec cross(wide_vec a, wide_vec b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(wide_vec a, wide_vec b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline wide_vec unit(wide_vec a) { return scaled(1.0 / std::sqrt(dot(a, a)), a); }
inline double length(vec3 v) { return std::sqrt(dot(wide(v), wide(v))); }
inline wide_vec bitangent(const surface_point<everything>& v)
{
    return scaled(v.tangent.w, cross(wide(v.normal), wide(v.tangent)));
}

/// The tangent has unit length and a sign, and is at right angles to the normal.
inline void check_tangent(const surface_point<everything>& v, double margin)
{
    REQUIRE(length(vec3{v.tangent.x, v.tangent.y, v.tangent.z}) == Catch::Approx(1.0).margin(margin));
    REQUIRE(std::abs(dot(wide(v.tangent), wide(v.normal))) < margin);
    REQUIRE(std::abs(v.tangent.w) == 1.0f);  // NOLINT
}

/// The triangle's own normal by its winding, of unit length.
template <class Mesh>
wide_vec face_normal(const Mesh& m, const std::array<std::uint32_t, 3>& t)
{
    wide_vec p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = wide(m.vertices[t[k]].position);
    return unit(cross(minus(p[1], p[0]), minus(p[2], p[0])));
}

/// The mesh's triangles as one array of indices.
template <class Mesh>
std::vector<std::uint32_t> indices_of(const Mesh& m)
{
    std::vector<std::uint32_t> all;
    for (const auto& t : m.triangles) all.insert(all.end(), t.begin(), t.end());
    return all;
}

/// Directed edges between welded positions that are not met by their reverse equally often.
template <class Mesh>
std::size_t open_edges(const Mesh& m)
{
    return check_closedness(inspect::mesh_view{m.vertices, indices_of(m)}).unmatched_edges;
}

/// These keys all differ.
template <class E>
void check_different_keys(const E& plain, const std::vector<E>& others)
{
    for (std::size_t i = 0; i < others.size(); ++i) {
        INFO(i);
        CHECK_FALSE(others[i].cache_key() == plain.cache_key());
        for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(others[i].cache_key() == others[k].cache_key());
    }
}

inline frame with_origin(frame f, uv_origin origin)
{
    f.uv = origin;
    return f;
}

inline std::vector<frame> frames()
{
    frame godot = right_handed_y_up;
    godot.winding = -1;
    frame bottom = right_handed_z_up;
    bottom.uv = uv_origin::bottom_left;
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    frame turned{.right = {c, s, 0.0f}, .up = {-s * c, c * c, s}, .toward = {s * s, -c * s, c}};
    frame turned_left = turned;
    turned_left.right = {-c, -s, 0.0f};
    turned_left.winding = -1;
    return {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up, godot, bottom, turned,
            turned_left};
}

}  // namespace meshes

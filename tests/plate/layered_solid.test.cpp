// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/plate/layered_solid.hpp>
#include <typemesh/triangulate/monotone.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr cell_set layer_a = cells_of_layer(0), layer_b = cells_of_layer(1), layer_c = cells_of_layer(2);

struct mesh {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] inspect::mesh_view<vec3, std::uint32_t> view() const { return {vertices, indices}; }
};

mesh mesh_of(const layered_solid& solid)
{
    mesh m;
    constexpr auto position = [](const surface_point<attribute::position>& p) noexcept { return p.position; };
    REQUIRE(solid.write(into(m.vertices, m.indices, position), {}));
    return m;
}

void add_polygon(layer_arrangement& cells, const std::vector<grid_point>& p, std::uint32_t layer)
{
    const std::array<std::uint32_t, 2> starts{0, static_cast<std::uint32_t>(p.size())};
    REQUIRE(cells.add({p.data(), p.size()}, {starts.data(), 2}, layer));
}
void add_box(layer_arrangement& cells, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
             std::uint32_t layer)
{
    add_polygon(cells, {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, layer);
}

}  // namespace

TEST_CASE("slabs of random boxes are closed, with their volume, however they lie", "[layered_solid]")
{
    std::mt19937 random{7};
    std::uniform_int_distribution<std::int32_t> place{0, 6}, size{1, 5};
    std::uniform_int_distribution<std::uint32_t> any;
    layer_arrangement cells;
    layered_solid solid;
    workspace space;
    int strict = 0;
    for (int run = 0; run < 400; ++run) {
        cells.begin({});
        for (std::uint32_t layer = 0; layer < 3; ++layer)
            add_box(cells, place(random), place(random), size(random), size(random), layer);
        REQUIRE(cells.cut(space));
        std::vector<layered_solid::slab> slabs;
        cell_set filled{any(random) & ~1u};
        const bool nested = run % 2 == 0;
        for (int k = 0; k < 4; ++k) {
            slabs.push_back({filled, static_cast<float>(k + 1)});
            filled = nested ? filled & cell_set{any(random) | any(random)} : cell_set{any(random) & ~1u};
        }
        REQUIRE(solid.plan(cells, 0.0f, {slabs.data(), slabs.size()}, 0, monotone{}, space));
        const mesh m = mesh_of(solid);
        CHECK(m.vertices.size() == solid.size().vertices);
        const auto faults = inspect::check_manifoldness(m.view());
        CHECK(faults.open_edges == 0);
        CHECK(faults.bad_triangles == 0);
        CHECK(inspect::measure(m.view()).volume == Catch::Approx(solid.volume()).margin(1e-6));
        if (nested && solid.touching() == 0) CHECK(solid.hanging() == 0);
        if (nested && solid.touching() == 0) {
            CHECK(faults.is_manifold());
            ++strict;
        }
        if (faults.crowded_edges != 0) CHECK(solid.touching() + solid.hanging() != 0);
    }
    CHECK(strict > 100);
}

TEST_CASE("a wall has a point at each level at which others end beside it, and nowhere else", "[layered_solid]")
{
    layer_arrangement cells;
    layered_solid solid;
    workspace space;
    cells.begin({});
    add_box(cells, 0, 0, 10, 10, 1);
    add_box(cells, 2, 2, 4, 4, 0);  // a pocket inside: the rim is not divided
    REQUIRE(cells.cut(space));
    const layered_solid::slab inside[] = {{layer_b, 1.0f}, {layer_b & ~layer_a, 2.0f}};
    REQUIRE(solid.plan(cells, 0.0f, {inside, 2}, 4, monotone{}, space));
    CHECK(solid.size(plate_part::rim) == mesh_size{16, 8});
    CHECK(solid.size(plate_part::wall) == mesh_size{16, 8});
    CHECK(solid.size(plate_part::back) == mesh_size{4, 2});
    CHECK(solid.size(plate_part::floor) == mesh_size{4, 2});
    CHECK(solid.size(plate_part::front) == mesh_size{8, 8});
    CHECK(solid.range(plate_part::wall).first_vertex == 8 + 4 + 16 + 4);
    cells.begin({});
    add_box(cells, 0, 0, 10, 10, 1);
    add_box(cells, 2, 2, 4, 20, 0);  // a groove that ends in the upper side
    REQUIRE(cells.cut(space));
    REQUIRE(solid.plan(cells, 0.0f, {inside, 2}, 4, monotone{}, space));
    // Of the upper side's three walls, the two beside the groove have a fifth point; the groove's two walls do not.
    CHECK(solid.size(plate_part::rim) == mesh_size{3 * 4 + 5 + 4 + 5, 3 * 2 + 3 + 2 + 3});
    CHECK(inspect::check_manifoldness(mesh_of(solid).view()).is_manifold());
}

TEST_CASE("slabs that touch in a point or hang in an edge are counted", "[layered_solid]")
{
    layer_arrangement cells;
    layered_solid solid;
    workspace space;
    cells.begin({});
    add_box(cells, 0, 0, 10, 10, 0);
    add_box(cells, 10, 0, 10, 10, 1);
    add_box(cells, 20, 10, 10, 10, 2);
    REQUIRE(cells.cut(space));
    const layered_solid::slab stairs[] = {{layer_a, 1.0f}, {layer_b | layer_c, 2.0f}};
    REQUIRE(solid.plan(cells, 0.0f, {stairs, 2}, 0, monotone{}, space));
    CHECK(solid.hanging() == 1);
    CHECK(solid.touching() == 1);
    const auto faults = inspect::check_manifoldness(mesh_of(solid).view());
    CHECK(faults.open_edges == 0);
    CHECK(faults.crowded_edges == 2);
}

TEST_CASE("slabs that cannot be are refused, and the solid is empty", "[layered_solid]")
{
    layer_arrangement cells;
    layered_solid solid;
    workspace space;
    cells.begin({});
    add_box(cells, 0, 0, 10, 10, 0);
    REQUIRE(cells.cut(space));
    const auto refusal = [&](std::vector<layered_solid::slab> slabs, float bottom = 0.0f) {
        const auto done = solid.plan(cells, bottom, {slabs.data(), slabs.size()}, 0, monotone{}, space);
        CHECK(solid.size() == mesh_size{});
        return std::string{done.error().option};
    };
    CHECK(refusal({}) == "slabs");
    CHECK(refusal(std::vector<layered_solid::slab>(9, {layer_a, 1.0f})) == "slabs");
    CHECK(refusal({{layer_a, 0.0f}}) == "top");
    CHECK(refusal({{layer_a, 1.0f}, {layer_a, 1.0f}}) == "top");
    CHECK(refusal({{layer_a, std::numeric_limits<float>::infinity()}}) == "top");
    CHECK(refusal({{~layer_a, 1.0f}}) == "cells");
    CHECK(refusal({{layer_a, 1.0f}}, std::numeric_limits<float>::quiet_NaN()) == "height");
    CHECK(refusal({{layer_a, 1.0f, -0.1f}}) == "bevel");
    CHECK(refusal({{layer_a, 1.0f}, {layer_a, 2.0f, 0.0f, std::numeric_limits<float>::infinity()}}) == "bevel");
    CHECK(refusal({{layer_a, 1.0f, 0.1f, 0.0f, layer_a}, {layer_a, 2.0f}}) == "rim");
    CHECK(refusal({{layer_a, 1.0f, 0.1f, 0.0f, ~layer_a}}) == "rim");
    CHECK(refusal({{layer_a, 1.0f, 0.1f, 0.0f, layer_b}}) == "rim");  // it does not contain the slab
    for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        const layered_solid::slab one[] = {{layer_a, 1.0f, 0.1f}};
        const auto option = [&](const layered_base& base) {
            return std::string{solid.plan(cells, base, {one, 1}, 0, monotone{}, space).error().option};
        };
        CHECK(option({.unit_per_em = scale}) == "unit_per_em");
        if (!same(scale, 0.0)) CHECK(option({.tolerance = scale}) == "tolerance");
        CHECK(solid.size() == mesh_size{});
    }
}

TEST_CASE("boxes with bevels and fillets in a grid of their own are closed, wherever the upper one stands",
          "[layered_solid]")
{
    std::mt19937 random{11};
    std::uniform_int_distribution<std::int32_t> place{-100, 700};
    std::uniform_int_distribution<int> tenths{0, 4};
    layer_arrangement cells;
    layered_solid solid;
    workspace space;
    grid em;
    em.cells = 1000.0;
    em.units_per_em = 1.0;
    int with_fillet = 0, without = 0;
    for (int run = 0; run < 24; ++run) {
        cells.begin(em);
        add_box(cells, 0, 0, 1000, 1000, 0);
        add_box(cells, place(random), place(random), 300, 200, 1);
        add_box(cells, place(random), place(random), 200, 300, 1);
        if (!cells.cut(space)) continue;
        const auto some = [&] { return 0.1f * static_cast<float>(tenths(random)); };
        const layered_base base{.height = 0.5f, .bevel = some(), .round = run % 2 != 0, .unit_per_em = 2.0};
        const layered_solid::slab slabs[] = {{layer_a | layer_b, 2.0f, some()}, {layer_b, 3.0f, some(), some()}};
        REQUIRE(solid.plan(cells, base, {slabs, 2}, 4, monotone{}, space));
        const mesh m = mesh_of(solid);
        CHECK(m.vertices.size() == solid.size().vertices);
        const auto faults = inspect::check_manifoldness(m.view());
        CHECK(faults.open_edges == 0);
        CHECK(faults.bad_triangles == 0);
        CHECK((solid.touching() != 0 || faults.is_manifold()));
        // In cells along the plane, so a volume in cells times output units.
        CHECK(inspect::measure(m.view()).volume == Catch::Approx(solid.volume()).epsilon(1e-5));
        CHECK(solid.bevel(0) <= slabs[0].bevel);
        CHECK(solid.fillet(1) <= slabs[1].fillet);
        ++(solid.fillet(1) > 0.0f ? with_fillet : without);
    }
    CHECK(with_fillet > 2);
    CHECK(without > 2);
}

TEST_CASE("tangents are perpendicular to the normals, and on all but walls they point where u grows", "[layered_solid]")
{
    struct lit {
        vec3 position, normal;
        vec4 tangent;
        vec2 uv;
    };
    constexpr auto all = attribute::position | attribute::normal | attribute::tangent | attribute::uv;
    constexpr auto as_lit = [](const surface_point<all>& p) noexcept {
        return lit{p.position, p.normal, p.tangent, p.uv};
    };
    const auto dot = [](vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const auto minus = [](vec3 a, vec3 b) { return vec3{a.x - b.x, a.y - b.y, a.z - b.z}; };
    const auto turned = [](vec3 a, vec3 b) {
        return vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    layer_arrangement cells;
    layered_solid solid;
    workspace space;
    grid em;
    em.cells = 1000.0;
    em.units_per_em = 1.0;
    cells.begin(em);
    add_box(cells, 0, 0, 1000, 1000, 0);
    add_box(cells, 300, 300, 400, 400, 1);
    REQUIRE(cells.cut(space));
    const layered_solid::slab slabs[] = {{layer_a, 1.0f, 0.1f}, {layer_b, 2.0f, 0.05f, 0.05f}};
    REQUIRE(solid.plan(cells, {.bevel = 0.1f, .round = true}, {slabs, 2}, 4, monotone{}, space));
    for (const bool mirrored : {false, true})
        for (const uv_origin origin : {uv_origin::top_left, uv_origin::bottom_left})
            for (const frame& axes : {right_handed_y_up, left_handed_y_up, right_handed_z_up}) {
                layered_placement to{{.unit_per_cell = 0.001, .em_per_cell = 0.001, .frame = axes}, mirrored};
                to.at.frame.uv = origin;
                std::vector<lit> vertices;
                std::vector<std::uint32_t> indices;
                REQUIRE(solid.write(into(vertices, indices, as_lit), to));
                std::size_t leaning = 0, wrong_u = 0, wrong_v = 0, outside = 0;
                for (const lit& v : vertices) {
                    const vec3 t{v.tangent.x, v.tangent.y, v.tangent.z};
                    leaning += !(std::fabs(dot(t, t) - 1.0f) < 1e-5f && std::fabs(dot(t, v.normal)) < 1e-5f);
                    const float upright = origin == uv_origin::top_left ? 1.0f - v.uv.y : v.uv.y;
                    outside += !(upright >= 0.0f && upright <= 1.0f);
                }
                std::size_t flat = 0;
                for (std::size_t i = 0; i < indices.size(); i += 3) {
                    const lit &a = vertices[indices[i]], &b = vertices[indices[i + 1]], &c = vertices[indices[i + 2]];
                    const vec3 p = minus(b.position, a.position), q = minus(c.position, a.position);
                    const vec2 s{b.uv.x - a.uv.x, b.uv.y - a.uv.y}, r{c.uv.x - a.uv.x, c.uv.y - a.uv.y};
                    const float area = s.x * r.y - r.x * s.y;
                    if (!(std::fabs(area) > 1e-9f)) continue;  // of a wall
                    ++flat;
                    const vec3 u{(p.x * r.y - q.x * s.y) / area, (p.y * r.y - q.y * s.y) / area,
                                 (p.z * r.y - q.z * s.y) / area};
                    const vec3 v{(q.x * s.x - p.x * r.x) / area, (q.y * s.x - p.y * r.x) / area,
                                 (q.z * s.x - p.z * r.x) / area};
                    for (const lit& l : {a, b, c}) {
                        const vec3 t{l.tangent.x, l.tangent.y, l.tangent.z};
                        wrong_u += !(dot(t, u) > 0.0f);
                        wrong_v += !(l.tangent.w * dot(turned(l.normal, t), v) > -1e-5f);  // 0 at a wall's end
                    }
                }
                CHECK(flat > 20);
                CHECK(leaning == 0);
                CHECK(wrong_u == 0);
                CHECK(wrong_v == 0);
                CHECK(outside == 0);
            }
}

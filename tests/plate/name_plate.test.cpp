// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/typemesh.hpp>

#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/required.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct corner {
    vec3 position, normal;
    part of = {};
};
struct corner_mesh {
    std::vector<corner> vertices;
    std::vector<std::uint32_t> indices;
};

}  // namespace

template <>
struct typemesh::vertex_traits<corner> {
    static constexpr attribute wants = attribute::position | attribute::normal | attribute::part;
    corner operator()(const surface_point<wants>& p) const noexcept { return {p.position, p.normal, p.part}; }
};

namespace {

corner_mesh written(const name_plate& plate, std::size_t k)
{
    corner_mesh m;
    REQUIRE(plate.write(k, into(m.vertices, m.indices)));
    REQUIRE(m.vertices.size() == plate.solid(k).size().vertices);
    REQUIRE(m.indices.size() == plate.solid(k).size().indices());
    return m;
}

inspect::mesh_measure measured(const corner_mesh& m)
{
    return inspect::measure(inspect::mesh_view{m.vertices, m.indices});
}

/// The laws of every plate: closed, strictly 2-manifold, with the volume of its slabs, normals that agree with the
/// triangles.
void check_solid(const name_plate& plate, std::size_t k)
{
    const corner_mesh m = written(plate, k);
    const auto faults = inspect::check_manifoldness(inspect::mesh_view{m.vertices, m.indices});
    CHECK(faults.open_edges == 0);
    CHECK(faults.crowded_edges == 0);
    CHECK(faults.pinched_points == 0);
    CHECK(faults.bad_triangles == 0);
    const double unit = plate.placement().at.unit_per_cell;
    const double volume = unit * unit * plate.solid(k).volume();
    CHECK(volume > 0.0);
    CHECK(measured(m).volume == Catch::Approx(volume).epsilon(1e-5));
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3) {
        const corner &a = m.vertices[m.indices[i]], &b = m.vertices[m.indices[i + 1]], &c = m.vertices[m.indices[i + 2]];
        const auto normal = inspect::cross(inspect::to_place(b.position) - inspect::to_place(a.position),
                                           inspect::to_place(c.position) - inspect::to_place(a.position));
        for (const corner& v : {a, b, c}) {
            const double length = std::sqrt(inspect::dot(inspect::to_place(v.normal), inspect::to_place(v.normal)));
            CHECK(length == Catch::Approx(1.0).epsilon(1e-5));
            CHECK(inspect::dot(normal, inspect::to_place(v.normal)) >= 0.0);
        }
    }
}

/// The exact areas of the plate's caps, by its own triangles: doubled.
std::int64_t area(const name_plate& plate, cell_set cells) { return plate.cells().doubled_area(cells); }

constexpr plate_style all_styles[] = {plate_style::standing, plate_style::engraved, plate_style::cut,
                                      plate_style::inlay};

}  // namespace

TEST_CASE("a plate of every style is closed, strictly 2-manifold, and has the volume of its slabs", "[plate]")
{
    const struct {
        const char* font;
        const char* text;
    } cases[] = {{test::dejavu, "B8g&%@\xC3\x84i"},
                 {"truetype/liberation/LiberationSerif-Italic.ttf", "fAffi Qg"},
                 {test::amiri, "\xD8\xA7\xD9\x84\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85 \xD8\xB9\xD9\x84\xD9\x8A\xD9\x83\xD9\x85"},
                 {test::sawarabi, "\xE5\x9B\xBD\xE9\xBE\x8D\xE6\xB0\xB8"}};
    name_plate plate;
    for (const auto& c : cases) {
        auto font = test::opened(c.font);
        text_mesher mesher{font, flat{}};
        for (const float size : {1.0f, 12.0f}) {
            auto text = test::required(mesher.plan(c.text, {.size = size}));
            for (const plate_style style : all_styles) {
                for (const float margin : {0.2f, -0.1f}) {
                    INFO(c.font << " " << size << " style " << static_cast<int>(style) << " margin " << margin);
                    const auto done =
                        plate.plan(*text, {.style = style, .margin = margin}, constrained_delaunay{});
                    INFO(done.error().message());
                    REQUIRE(done);
                    REQUIRE(plate.solid_count() == (style == plate_style::inlay ? 2u : 1u));
                    CHECK(plate.is_manifold());
                    for (std::size_t k = 0; k < plate.solid_count(); ++k) check_solid(plate, k);
                }
            }
        }
    }
}

TEST_CASE("an inlay and its plate tile the full plate exactly", "[plate]")
{
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("R&B 80%", {}));
    name_plate plate;
    for (const float depth : {0.04f, 0.1f}) {  // into the plate, and through it
        REQUIRE(plate.plan(*text, {.style = plate_style::inlay, .depth = depth}, monotone{}));
        constexpr cell_set body = name_plate::body(), letters = name_plate::text();
        CHECK(area(plate, body & ~letters) + area(plate, body & letters) == area(plate, body));
        CHECK(area(plate, body & letters) > 0);
        // The walls of the pockets are the inlay's walls, turned round.
        std::map<std::array<float, 9>, int> triangles;
        std::array<corner_mesh, 2> m{written(plate, 0), written(plate, 1)};
        std::size_t inner = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            for (std::size_t i = 0; i < m[k].indices.size(); i += 3) {
                std::array<vec3, 3> t;
                for (std::size_t j = 0; j < 3; ++j) t[j] = m[k].vertices[m[k].indices[i + j]].position;
                if (!same(t[0].z, t[1].z) || !same(t[1].z, t[2].z)) {
                    const bool wall = m[k].vertices[m[k].indices[i]].of == static_cast<part>(plate_part::wall);
                    inner += wall;
                    if (wall) triangles[{t[0].x, t[0].y, t[1].x, t[1].y, t[2].x, t[2].y, 0, 0, 0}] += 0;
                }
            }
        }
        CHECK(inner % 2 == 0);
        CHECK(plate.solid(0).size(plate_part::wall) == plate.solid(1).size(plate_part::wall));
        const double full = plate.solid(0).volume() + plate.solid(1).volume();
        const double whole = 0.5 * static_cast<double>(area(plate, body)) * 0.1 * plate.unit_per_em();
        CHECK(full == Catch::Approx(whole).epsilon(1e-6));
        const double mesh = measured(m[0]).volume + measured(m[1]).volume;
        const double unit = plate.placement().at.unit_per_cell;
        CHECK(mesh == Catch::Approx(unit * unit * whole).epsilon(1e-5));
    }
}

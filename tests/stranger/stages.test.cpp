// SPDX-License-Identifier: MIT

// A stranger's policies, through the stages' free functions.

#include <typemesh/typemesh.hpp>

#include <vector>

#include "strangers.hpp"
#include "support/catch.hpp"
#include "support/required.hpp"

using namespace typemesh;
using Catch::Approx;

namespace {

/// One sign of the stranger's font, all the way to a region and its triangles.
struct meshed {
    stranger::stamps font;
    outline drawn;
    contours loops;
    workspace space;
    region filled;
    triangle_list cap;

    explicit meshed(glyph_id id)
    {
        REQUIRE(record(font, id, drawn));
        const auto g = test::required(grid::fitting(font.units_per_em(), drawn.bounds));
        REQUIRE(discretise(drawn, stranger::thirds{}, 0.1, *g, loops));
        filled = *test::required(fill(loops, drawn.rule, space));
        REQUIRE_FALSE(stranger::patient{}(filled, space, cap));
    }

    placement in_em() const
    {
        placement at;
        at.unit_per_cell = at.em_per_cell = 1.0 / (100.0 * filled.grid().cells);
        return at;
    }
    double cap_area() const
    {
        std::int64_t twice = 0;
        for (const triangle t : cap)
            twice += orientation(filled.points()[t.a], filled.points()[t.b], filled.points()[t.c]);
        return static_cast<double>(twice) / 2.0 / (10000.0 * filled.grid().cells * filled.grid().cells);
    }
};

}  // namespace

TEST_CASE("a stranger's triangulator fills the contours of a stranger's discretiser and source", "[stranger]")
{
    for (const glyph_id id : {1u, 2u, 3u}) {
        meshed m{id};
        CHECK(m.cap.size() == m.filled.triangle_count());
        CHECK(m.filled.points().size() == (id == 1 ? 4u : id == 2 ? 16u : 8u));
    }
    CHECK(meshed{1}.cap_area() == Approx(0.64));
    CHECK(meshed{2}.cap_area() < 0.64 - 0.15);
    CHECK(meshed{3}.cap_area() == Approx(0.2));

    outline nothing;
    stranger::stamps font;
    CHECK(record(font, 77, nothing) == error::unknown_glyph);
}

TEST_CASE("a stranger's extruder, sink and style of normals work with the library's own", "[stranger]")
{
    meshed m{2};
    extruded<>::plan_data sides;
    stranger::volume sink;

    REQUIRE(extrude(m.filled, m.cap.view(), extruded<>{.depth = 0.5f}, m.in_em(), sides, sink));
    CHECK(sink.ended);
    CHECK(sink.value() == Approx(0.5 * m.cap_area()).epsilon(1e-4));

    REQUIRE(extrude(m.filled, m.cap.view(), extruded<stranger::faceted>{.depth = 0.5f}, m.in_em(), sides, sink));
    CHECK(sink.count == 6 * m.filled.points().size());
    CHECK(sink.value() == Approx(0.5 * m.cap_area()).epsilon(1e-4));

    REQUIRE(extrude(m.filled, m.cap.view(), stranger::fence{.tall = 0.5f}, m.in_em(), sink));
    CHECK(sink.count == 2 * m.filled.points().size());
    CHECK(sink.triangles == 2 * m.filled.points().size());

    placement mirrored = m.in_em();
    mirrored.frame = left_handed_y_up;
    REQUIRE(extrude(m.filled, m.cap.view(), extruded<>{.depth = 0.5f}, mirrored, sides, sink));
    CHECK(sink.value() == Approx(0.5 * m.cap_area()).epsilon(1e-4));
}

TEST_CASE("a stranger's vertex, writer and stream contain the surface's values", "[stranger]")
{
    meshed m{1};
    extruded<>::plan_data sides;
    std::vector<std::uint16_t> indices;

    std::vector<stranger::vertex> vertices;
    auto grow = into(vertices, indices);
    REQUIRE(extrude(m.filled, m.cap.view(), extruded<>{}, m.in_em(), sides, grow));
    REQUIRE(vertices.size() == 24);
    CHECK(vertices[0].normal[2] == 127);
    CHECK(vertices[4].normal[2] == -127);
    CHECK(vertices[4].place[2] == -0.2f);

    std::vector<stranger::packed_vertex> packed;
    auto pack = into(packed, indices, stranger::packing_writer{-1.0f, 1.0f, 0xFF8800u});
    REQUIRE(extrude(m.filled, m.cap.view(), flat{}, m.in_em(), pack));
    REQUIRE(packed.size() == 4);
    for (const auto& v : packed) {
        CHECK(v.colour == 0xFF8800u);
        CHECK(v.place[2] == 32768);
    }

    std::vector<std::array<std::int8_t, 4>> normals(24);
    std::vector<vec3> positions(24);
    indices.assign(36, 0);
    stream_sink streams{std::span{indices}, stream<attribute::position, vec3>{positions},
                        stranger::byte_normals{normals.data(), normals.size()}};
    REQUIRE(extrude(m.filled, m.cap.view(), extruded<>{}, m.in_em(), sides, streams));
    for (std::size_t i = 0; i < 24; ++i) {
        CHECK(normals[i][2] == vertices[i].normal[2]);
        CHECK(positions[i] == vec3{vertices[i].place[0], vertices[i].place[1], vertices[i].place[2]});
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/extrude/extrude.hpp>

#include <typemesh/extrude/flat.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;

namespace {

struct refusing_sink : mesh<> {
    error begin(mesh_size exact) noexcept
    {
        (void)mesh<>::begin(exact);
        return {error::buffer_too_small, exact.vertices};
    }
};

/// More vertices than 32 bits can number.
struct endless {
    result<part_sizes> plan(const region&) const noexcept
    {
        part_sizes s;
        s.vertices[part::front] = s.vertices[part::back] = 0xF000'0000u;
        return s;
    }
    height_range heights() const noexcept { return {}; }
    template <attribute Wants, class Put>
    void vertices(part, const solid&, const placement&, Put&&) const noexcept
    {
    }
    template <class Put>
    void triangles(part, const solid&, const first_vertices&, Put&&) const noexcept
    {
    }
};

}  // namespace

TEST_CASE("a sink that refuses in begin() gets nothing else", "[extrude]")
{
    const auto s = shapes::letter_e();
    extruded<>::plan_data sides;
    refusing_sink sink;
    const error e = extrude(s.made(), s.cap, extruded<>{}, in_em(), sides, sink).error();
    CHECK(e == error::buffer_too_small);
    CHECK(e.count == 72);
    CHECK(sink.vertices.empty());
    CHECK(sink.triangles.empty());
    CHECK(sink.ended == 0);
}

TEST_CASE("more vertices than 32 bits can number are refused as too large", "[extrude]")
{
    const auto s = shapes::rectangle();
    mesh<> sink;
    CHECK(extrude(s.made(), s.cap, endless{}, in_em(), sink) == error::too_large);
    CHECK(sink.begun == 0);
}

TEST_CASE("scratch from an earlier shape does not leak into the next", "[extrude]")
{
    extruded<>::plan_data sides;
    const auto d = shapes::letter_d();
    const auto e = shapes::letter_e();
    mesh<> used, fresh;
    REQUIRE(extrude(d.made(), d.cap, extruded<>{.texture = texture_mapping::em}, in_em(), sides, used));
    used = {};
    REQUIRE(extrude(e.made(), e.cap, extruded<>{}, in_em(), sides, used));
    extruded<>::plan_data clean;
    REQUIRE(extrude(e.made(), e.cap, extruded<>{}, in_em(), clean, fresh));
    check_same(used, fresh);
}

TEST_CASE("vertices and triangles lie part after part", "[extrude]")
{
    const auto s = shapes::ring();
    const built b = build(s, extruded<>{});
    for (const part p : all_parts)
        for (std::uint32_t t = b.first_triangle(p); t < b.end_triangle(p); ++t)
            for (const auto v : b.triangles[t]) {
                CHECK(v >= b.first_vertex(p));
                CHECK(v < b.first_vertex(p) + b.sizes.vertices[p]);
            }
}

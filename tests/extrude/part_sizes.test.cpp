// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/extrude/part_sizes.hpp>

#include <cstdint>

using namespace typemesh;

TEST_CASE("parts follow each other without a gap, beginning at the given place", "[extrude]")
{
    const part_sizes all[] = {{{{4, 5, 6}}, {{1, 2, 3}}}, {{{0, 5, 0}}, {{0, 7, 0}}}, {{{3, 0, 0}}, {{1, 0, 0}}}, {}};
    for (const part_sizes& s : all) {
        for (const std::uint32_t vertex : {0u, 100u})
            for (const std::uint32_t index : {0u, 33u}) {
                std::uint32_t next_vertex = vertex, next_index = index;
                for (const part p : all_parts) {
                    const mesh_range r = s.range(p, vertex, index);
                    CHECK(r == mesh_range{next_vertex, s.vertices[p], next_index, 3 * s.triangles[p]});
                    CHECK(s.vertices.starts(vertex)[p] == next_vertex);
                    next_vertex += r.vertex_count;
                    next_index += r.index_count;
                }
                CHECK(s.total().vertices == next_vertex - vertex);
                CHECK(s.total().indices() == next_index - index);
            }
        CHECK(s.range(part::side).first_index == 3 * s.starts().triangles[part::side]);
    }
}

TEST_CASE("sizes can be added and subtracted again, and totals follow", "[extrude]")
{
    const part_sizes a{{{4, 5, 6}}, {{1, 2, 3}}}, b{{{10, 0, 7}}, {{8, 9, 0}}};
    CHECK((a + b) - b == a);
    CHECK((a + b).total() == a.total() + b.total());
}

TEST_CASE("totals count beyond 32 bits, and report whether 32 bits suffice", "[extrude]")
{
    const part_sizes most{{{0xFFFF'FFFFu, 0xFFFF'FFFFu, 0xFFFF'FFFFu}}, {{0xFFFF'FFFFu, 0xFFFF'FFFFu, 0xFFFF'FFFFu}}};
    CHECK(most.total().vertices == 0x2'FFFF'FFFDu);
    CHECK(most.total().indices() == 0x8'FFFF'FFF7u);

    CHECK(mesh_size{0xFFFF'FFFFu, 0x5555'5555u}.fits_32_bits());
    CHECK_FALSE(mesh_size{0x1'0000'0000u, 0}.fits_32_bits());
    CHECK_FALSE(mesh_size{0, 0x5555'5556u}.fits_32_bits());
}

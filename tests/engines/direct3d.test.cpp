// SPDX-License-Identifier: MIT

#include "engines/stand_in/d3d9.hpp"

#include "engines/direct3d9.hpp"
#include "engines/stand_in/d3d11.hpp"

#include "engines/direct3d11.hpp"

#include <cstring>

#include "recipe_laws.hpp"
#include "support/guarded_bytes.hpp"

using namespace recipes;
using test::guarded_bytes;

namespace d9 = engines::direct3d9;
namespace d11 = engines::direct3d11;

namespace {

template <class Index>
std::vector<std::uint32_t> numbers(const void* at, std::size_t n)
{
    std::vector<Index> read(n);
    std::memcpy(read.data(), at, n * sizeof(Index));
    return {read.begin(), read.end()};
}

}  // namespace

TEMPLATE_TEST_CASE("Direct3D 9 gets left-handed 32-byte vertices, clockwise triangles and either index format",
                   "[engines]", bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, d9::options());
    for (const D3DFORMAT format : {D3DFMT_INDEX16, D3DFMT_INDEX32}) {
        const std::size_t width = format == D3DFMT_INDEX16 ? 2 : 4;
        IDirect3DVertexBuffer9 vertices{std::vector<std::uint8_t>(32 * plan.size().vertices)};
        IDirect3DIndexBuffer9 indices{format, std::vector<std::uint8_t>(width * plan.size().indices())};
        REQUIRE(d9::fill(plan, vertices, indices));
        CHECK(vertices.locks == 0);
        CHECK(indices.locks == 0);
        seen mesh;
        for (std::size_t i = 0; i < plan.size().vertices; ++i) {
            float f[8];
            std::memcpy(f, vertices.bytes.data() + 32 * i, sizeof f);
            mesh.add({f[0], f[1], f[2]}, f + 3, nullptr, f + 6);
        }
        mesh.index = width == 2 ? numbers<std::uint16_t>(indices.bytes.data(), plan.size().indices())
                                : numbers<std::uint32_t>(indices.bytes.data(), plan.size().indices());
        obeys(mesh, plan, direct3d);
    }
}

TEST_CASE("Direct3D 9 buffers that are too small are refused and stay unchanged", "[engines]")
{
    bench b;
    const auto plan = planned(b, d9::options());
    IDirect3DVertexBuffer9 vertices{std::vector<std::uint8_t>(32 * plan.size().vertices - 1, 0xEE)};
    IDirect3DIndexBuffer9 indices{D3DFMT_INDEX16, std::vector<std::uint8_t>(2 * plan.size().indices(), 0xEE)};
    const error e = d9::fill(plan, vertices, indices).error();
    CHECK(e == error::buffer_too_small);
    CHECK(e.count == plan.size().vertices);
    CHECK(vertices.bytes == std::vector<std::uint8_t>(vertices.bytes.size(), 0xEE));
    CHECK(indices.bytes == std::vector<std::uint8_t>(indices.bytes.size(), 0xEE));
    CHECK(vertices.locks == 0);
}

TEMPLATE_TEST_CASE("Direct3D 11 gets 32-byte and packed vertices, up to the last byte of mapped memory", "[engines]",
                   bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, d11::options());
    const std::size_t n = plan.size().vertices, m = plan.size().indices();
    {
        const guarded_bytes vertices{n * sizeof(d11::vertex)}, indices{m * 2};
        REQUIRE(d11::fill<d11::vertex>(plan, vertices.bytes().data(), n * sizeof(d11::vertex), indices.bytes().data(),
                                       m * 2, DXGI_FORMAT_R16_UINT));
        seen mesh;
        for (const d11::vertex& v : vertices.as<d11::vertex>())
            mesh.add({v.position[0], v.position[1], v.position[2]}, v.normal, nullptr, v.uv);
        mesh.index = numbers<std::uint16_t>(indices.bytes().data(), m);
        obeys(mesh, plan, direct3d);
    }
    {
        const guarded_bytes vertices{n * sizeof(d11::packed_vertex)}, indices{m * 4};
        REQUIRE(d11::fill<d11::packed_vertex>(plan, vertices.bytes().data(), n * sizeof(d11::packed_vertex),
                                              indices.bytes().data(), m * 4, DXGI_FORMAT_R32_UINT));
        seen mesh;
        std::size_t of_second = 0;
        for (const d11::packed_vertex& v : vertices.as<d11::packed_vertex>()) {
            mesh.add({v.position[0], v.position[1], v.position[2]}, v.normal, v.tangent, v.uv);
            CHECK((v.cluster == 0 || v.cluster == 1 || v.cluster == 3 || v.cluster == 4));  // bytes of UTF-8
            of_second += v.cluster == 1;
        }
        std::size_t all_of_second = 0;
        for (const part p : plan.parts()) all_of_second += plan.range(1, p).vertex_count;
        CHECK(of_second == all_of_second);
        mesh.index = numbers<std::uint32_t>(indices.bytes().data(), m);
        engine packed = direct3d;
        packed.off_direction = 0.01;
        packed.off_uv = 1e-3;  // half a step of a half from 2 em on
        obeys(mesh, plan, packed);
    }
}

TEST_CASE("input layouts and vertex declarations have the offsets of the vertices", "[engines]")
{
    CHECK(d9::declaration[1].Offset == offsetof(d9::vertex, nx));
    CHECK(d9::declaration[2].Offset == offsetof(d9::vertex, tu));
    CHECK(d11::layout[1].AlignedByteOffset == offsetof(d11::vertex, normal));
    CHECK(d11::layout[2].AlignedByteOffset == offsetof(d11::vertex, uv));
    CHECK(d11::packed_layout[1].AlignedByteOffset == offsetof(d11::packed_vertex, normal));
    CHECK(d11::packed_layout[2].AlignedByteOffset == offsetof(d11::packed_vertex, tangent));
    CHECK(d11::packed_layout[3].AlignedByteOffset == offsetof(d11::packed_vertex, uv));
    CHECK(d11::packed_layout[4].AlignedByteOffset == offsetof(d11::packed_vertex, cluster));
}

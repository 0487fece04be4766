// SPDX-License-Identifier: MIT

#include "engines/stand_in/godot.hpp"
#include "engines/stand_in/unity.hpp"
#include "engines/stand_in/unreal.hpp"

#include "engines/godot.hpp"
#include "engines/unity.hpp"
#include "engines/unreal.hpp"

#include <cstring>

#include "recipe_laws.hpp"

using namespace recipes;
using namespace UnityEngine::Rendering;

namespace {

const std::vector<VertexAttributeDescriptor> descriptors = {
    {VertexAttribute::Position, VertexAttributeFormat::Float32, 3, 0},
    {VertexAttribute::Normal, VertexAttributeFormat::SNorm16, 4, 1},
    {VertexAttribute::Tangent, VertexAttributeFormat::SNorm16, 4, 1},
    {VertexAttribute::Color, VertexAttributeFormat::UNorm8, 4, 1},
    {VertexAttribute::TexCoord0, VertexAttributeFormat::Float16, 2, 1},
};

engines::unity::mesh_data pointers(MeshData& data, bool wide)
{
    return {data.GetVertexData(0), data.GetVertexData(1), data.GetIndexData(), wide};
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Unity's two streams contain a left-handed mesh with clockwise triangles, and attributes of multiples of 4 bytes",
    "[engines]", bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::unity::options());
    for (const bool wide : {false, true}) {
        MeshData data;
        REQUIRE(data.SetVertexBufferParams(static_cast<int>(plan.size().vertices), descriptors));
        data.SetIndexBufferParams(static_cast<int>(plan.size().indices()),
                                  wide ? IndexFormat::UInt32 : IndexFormat::UInt16);
        REQUIRE(data.GetVertexData(1).size() == engines::unity::stream1_bytes * plan.size().vertices);
        const rgba8 of_part[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}};
        const part_colours<> colours{of_part[0], of_part[1], of_part[2], of_part[3], of_part[4]};
        REQUIRE(engines::unity::write(plan, pointers(data, wide), colours));

        seen mesh;
        for (std::size_t i = 0; i < plan.size().vertices; ++i) {
            struct {
                snorm16 normal[4], tangent[4];
                unorm8 colour[4];
                half uv[2];
            } v;
            static_assert(sizeof v == 24);
            vec3 p;
            std::memcpy(&p, data.GetVertexData(0).data() + 12 * i, 12);
            std::memcpy(&v, data.GetVertexData(1).data() + 24 * i, 24);
            mesh.add(p, v.normal, v.tangent, v.uv);
            for (const part where : plan.parts()) {
                const mesh_range range = plan.range(where);
                if (i - range.first_vertex >= range.vertex_count) continue;
                const rgba8 own = of_part[static_cast<std::size_t>(where)];
                CHECK((v.colour[0] == own.r && v.colour[1] == own.g && v.colour[2] == own.b && v.colour[3] == own.a));
            }
        }
        for (std::size_t i = 0; i < plan.size().indices(); ++i) {
            std::uint32_t n = 0;
            std::memcpy(&n, data.GetIndexData().data() + (wide ? 4 : 2) * i, wide ? 4 : 2);
            mesh.index.push_back(n);
        }
        engine is = unity;
        is.off_direction = 5e-5;
        is.off_uv = 1e-3;  // half a step of a half from 2 em on
        obeys(mesh, plan, is);
    }
}

TEST_CASE("Unity's arrays that are too small are refused and stay unchanged", "[engines]")
{
    bench b;
    const auto plan = planned(b, engines::unity::options());
    for (const int missing : {0, 1}) {
        MeshData data;
        REQUIRE(data.SetVertexBufferParams(static_cast<int>(plan.size().vertices) - missing, descriptors));
        data.SetIndexBufferParams(static_cast<int>(plan.size().indices()) - (1 - missing), IndexFormat::UInt16);
        const error e = engines::unity::write(plan, pointers(data, false)).error();
        CHECK(e == error::buffer_too_small);
        CHECK(e.count == (missing == 1 ? plan.size().vertices : plan.size().indices()));
        for (const std::byte v : data.GetVertexData(1)) REQUIRE(v == std::byte{0xEE});
    }
}

TEST_CASE("a long text overflows 16-bit indices with a clear error", "[engines]")
{
    bench b;
    std::string lines;
    for (int i = 0; i < 600; ++i) lines += "@&g";
    const auto plan = planned(b, engines::unity::options(), lines);
    REQUIRE(plan.size().vertices > 65535);
    MeshData data;
    REQUIRE(data.SetVertexBufferParams(static_cast<int>(plan.size().vertices), descriptors));
    data.SetIndexBufferParams(static_cast<int>(plan.size().indices()), IndexFormat::UInt16);
    const error e = engines::unity::write(plan, pointers(data, false)).error();
    CHECK(e == error::index_overflow);
    CHECK(e.count == plan.size().vertices);
    for (const std::byte v : data.GetVertexData(0)) REQUIRE(v == std::byte{0xEE});
    data.SetIndexBufferParams(static_cast<int>(plan.size().indices()), IndexFormat::UInt32);
    CHECK(engines::unity::write(plan, pointers(data, true)));
}

TEMPLATE_TEST_CASE(
    "Unreal's buffers contain a mesh in centimetres with z up, whose triangles are wound against their normals",
    "[engines]", bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::unreal::options(100.0));
    FStaticMeshVertexBuffers buffers;
    TArray<std::uint32_t> indices;
    REQUIRE(engines::unreal::write(plan, buffers, indices));
    REQUIRE(buffers.PositionVertexBuffer.GetNumVertices() == plan.size().vertices);
    seen mesh;
    for (std::uint32_t i = 0; i < plan.size().vertices; ++i) {
        const FVector3f p = buffers.PositionVertexBuffer.VertexPosition(i);
        const FVector4f x = buffers.StaticMeshVertexBuffer.VertexTangentX(i),
                        z = buffers.StaticMeshVertexBuffer.VertexTangentZ(i);
        const FVector2f uv = buffers.StaticMeshVertexBuffer.GetVertexUV(i, 0);
        mesh.position.push_back({p.X, p.Y, p.Z});
        mesh.normal.push_back({z.X, z.Y, z.Z});
        mesh.tangent.push_back({x.X, x.Y, x.Z, z.W});
        mesh.uv.push_back({uv.X, uv.Y});
    }
    for (std::int32_t i = 0; i < indices.Num(); ++i) mesh.index.push_back(indices[i]);
    engine is = unreal;
    is.off_direction = 0.01;
    obeys(mesh, plan, is);

    TArray<std::uint16_t> narrow;
    REQUIRE(engines::unreal::write(plan, buffers, narrow));
    CHECK(narrow.Num() == indices.Num());
    for (std::int32_t i = 0; i < indices.Num(); ++i) REQUIRE(narrow[i] == indices[i]);
}

TEMPLATE_TEST_CASE("Godot's arrays contain a right-handed mesh whose front faces are clockwise", "[engines]", bench,
                   bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::godot_mesh::options());
    using namespace ::godot;
    Array arrays;
    REQUIRE(engines::godot_mesh::write(plan, arrays));
    const auto& p = std::get<PackedVector3Array>(arrays[::godot::Mesh::ARRAY_VERTEX]);
    const auto& n = std::get<PackedVector3Array>(arrays[::godot::Mesh::ARRAY_NORMAL]);
    const auto& t = std::get<PackedFloat32Array>(arrays[::godot::Mesh::ARRAY_TANGENT]);
    const auto& uv = std::get<PackedVector2Array>(arrays[::godot::Mesh::ARRAY_TEX_UV]);
    const auto& index = std::get<PackedInt32Array>(arrays[::godot::Mesh::ARRAY_INDEX]);
    seen mesh;
    for (std::int64_t i = 0; i < p.size(); ++i) {
        mesh.position.push_back({p.ptr()[i].x, p.ptr()[i].y, p.ptr()[i].z});
        mesh.normal.push_back({n.ptr()[i].x, n.ptr()[i].y, n.ptr()[i].z});
        mesh.tangent.push_back({t.ptr()[4 * i], t.ptr()[4 * i + 1], t.ptr()[4 * i + 2], t.ptr()[4 * i + 3]});
        mesh.uv.push_back({uv.ptr()[i].x, uv.ptr()[i].y});
    }
    for (std::int64_t i = 0; i < index.size(); ++i) mesh.index.push_back(static_cast<std::uint32_t>(index.ptr()[i]));
    obeys(mesh, plan, recipes::godot);
}

// SPDX-License-Identifier: MIT

#include "engines/stand_in/gl.hpp"

#include "engines/opengl.hpp"
#include "engines/stand_in/vulkan.hpp"

#include "engines/vulkan.hpp"

#include <cstring>

#include "recipe_laws.hpp"
#include "support/guarded_bytes.hpp"

using namespace recipes;
using test::guarded_bytes;

namespace {

engine packed(engine is)
{
    is.off_direction = 0.0025;
    is.off_uv = 1e-3;  // half a step of a half from 2 em on
    return is;
}

}  // namespace

TEMPLATE_TEST_CASE("OpenGL gets interleaved vertices of 24 bytes, counter-clockwise triangles and upward v",
                   "[engines]", bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::opengl::options());
    const guarded_bytes vertices{plan.size().vertices * sizeof(engines::opengl::vertex)},
        indices{plan.size().indices() * 2};
    REQUIRE(plan.write(into(vertices.as<engines::opengl::vertex>(), indices.as<std::uint16_t>())));
    seen mesh = read<engines::opengl::vertex>(vertices.as<engines::opengl::vertex>());
    for (const std::uint16_t i : indices.as<std::uint16_t>()) mesh.index.push_back(i);
    obeys(mesh, plan, packed(opengl));
}

TEST_CASE("OpenGL gets pointers to four attributes, relative to the first vertex", "[engines]")
{
    std::vector<std::size_t> offsets;
    engines::opengl::describe(
        [&](GLuint location, GLint size, GLenum type, GLboolean normalised, GLsizei stride, const void* at) {
            CHECK(location == offsets.size());
            CHECK(stride == 24);
            CHECK((normalised == GL_TRUE) == (type == GL_INT_2_10_10_10_REV));
            CHECK((type != GL_INT_2_10_10_10_REV || size == 4));  // the specification asks for 4 there
            offsets.push_back(reinterpret_cast<std::size_t>(at));
        },
        1000);
    CHECK(offsets == std::vector<std::size_t>{1000, 1012, 1016, 1020});
}

TEMPLATE_TEST_CASE("two texts share Vulkan buffers, and the indices of the second continue after the first",
                   "[engines]", bench, bevelled_bench)
{
    TestType b;
    guarded_bytes vertices{24 * 60'000}, indices{4 * 200'000};
    engines::vulkan::room room{vertices.bytes(), indices.bytes()};
    const auto first = planned(b, engines::vulkan::options(), "first");
    const auto at = room.add(first);
    REQUIRE(at);
    CHECK(at->first_index == 0);
    const auto before = static_cast<std::uint32_t>(first.size().vertices);

    const auto plan = planned(b, engines::vulkan::options());
    const auto here = room.add(plan);
    REQUIRE(here);
    CHECK(here->first_index == at->index_count);
    CHECK(room.vertex_count == before + plan.size().vertices);
    using vertex = engines::vulkan::vertex;
    seen mesh = read<vertex>(vertices.as<vertex>().subspan(before, plan.size().vertices));
    for (const std::uint32_t i : indices.as<std::uint32_t>().subspan(here->first_index, here->index_count)) {
        REQUIRE(i >= before);
        mesh.index.push_back(i - before);
    }
    engine is = packed(gltf);
    is.green_up = false;
    obeys(mesh, plan, is);
    for (const std::byte rest : vertices.bytes().subspan(24 * room.vertex_count)) REQUIRE(rest == std::byte{0xEE});

    engines::vulkan::room full = room;
    full.vertices = full.vertices.first(24 * room.vertex_count);
    CHECK(full.add(plan).error() == error::buffer_too_small);
    CHECK(full.vertex_count == room.vertex_count);
}

TEST_CASE("Vulkan's descriptions have the offsets of the vertex", "[engines]")
{
    using engines::vulkan::attributes;
    using engines::vulkan::vertex;
    CHECK(engines::vulkan::binding.stride == sizeof(vertex));
    CHECK(attributes[1].offset == offsetof(vertex, normal));
    CHECK(attributes[2].offset == offsetof(vertex, tangent));
    CHECK(attributes[3].offset == offsetof(vertex, uv));
}

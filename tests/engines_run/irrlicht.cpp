// SPDX-License-Identifier: MIT
//
// Irrlicht's own eyes on what examples/engines/irrlicht.hpp puts into its buffers.

#include "irrlicht_scene.hpp"

#include <cstddef>
#include <string>

#include "engines/recipe_laws.hpp"

using namespace recipes;

namespace {

const std::string dejavu = "truetype/dejavu/DejaVuSans.ttf";

/// As irrlicht_text.cpp has it.
text_options options()
{
    text_options o;
    o.frame = left_handed_y_up;
    return o;
}

}  // namespace

TEST_CASE("Irrlicht's buffers, of 16 and of 32 bits, hold the mesh: left-handed, clockwise, v downwards", "[engines]")
{
    bench b;
    const auto plan = b.mesher.plan(word, options());
    REQUIRE(plan);
    for (const auto kind : {irrlicht_buffer::small, irrlicht_buffer::dynamic}) {
        const irrlicht_findings found = look_with_irrlicht(font_file(dejavu).c_str(), word, kind);
        REQUIRE(found.failure.empty());
        seen mesh;
        for (std::size_t i = 0; i + 2 < found.positions.size(); i += 3) {
            mesh.position.push_back({found.positions[i], found.positions[i + 1], found.positions[i + 2]});
            mesh.normal.push_back({found.normals[i], found.normals[i + 1], found.normals[i + 2]});
        }
        for (std::size_t i = 0; i + 1 < found.uvs.size(); i += 2) mesh.uv.push_back({found.uvs[i], found.uvs[i + 1]});
        mesh.index.assign(found.indices.begin(), found.indices.end());
        obeys(mesh, *plan, direct3d);
        CHECK(found.colours_wrong == 0);
        CHECK(found.turned == 0);
        CHECK(found.front_hit);
        const bounds3 said = plan->bounds();
        const vec3 low{found.low[0], found.low[1], found.low[2]}, high{found.high[0], found.high[1], found.high[2]};
        CHECK(low == said.low);
        CHECK(high == said.high);
    }
}

TEST_CASE("a text that 16 bits cannot number is refused in a sentence, and 32 bits take it", "[engines]")
{
    std::string lines;
    for (int i = 0; i < 600; ++i) lines += "L@&g";
    const irrlicht_findings refused =
        look_with_irrlicht(font_file(dejavu).c_str(), lines.c_str(), irrlicht_buffer::small);
    CHECK(refused.failure == error{error::index_overflow}.message());
    CHECK(look_with_irrlicht(font_file(dejavu).c_str(), lines.c_str(), irrlicht_buffer::dynamic).failure.empty());
}

TEST_CASE("a font that is not there is refused in a sentence", "[engines]")
{
    CHECK_FALSE(look_with_irrlicht("/no/such/font.ttf", word, irrlicht_buffer::small).failure.empty());
}

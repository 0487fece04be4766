// SPDX-License-Identifier: MIT

// Must not compile: pointers, which know no size, and, each line in the same words, arrays where a sink is wanted.

#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

using namespace typemesh;

void write(text_mesher<>& mesher, d3dx_text<>& maker, std::vector<d3dx_vertex>& vertices,
           std::vector<std::uint32_t>& indices, one_worker& alone)
{
    const auto plan = mesher.plan("o");
    (void)plan->write(into(vertices.data(), indices.data()));
    (void)plan->write(vertices, indices);
    (void)plan->write(std::span{vertices}, std::span{indices});
    (void)plan->write(vertices, indices, alone);
    (void)plan->write(glyph_span{0, 1}, vertices, indices);
    (void)plan->write_meshes(vertices, indices);
    text_chunks chunks;
    (void)chunks.write(*plan, vertices, indices);
    (void)chunks.write(*plan, vertices, indices, alone);
    (void)mesher.build("o", vertices, indices);
    (void)mesher.build("o", vertices, indices, {.merge = true});
    (void)maker.plan("o")->write(vertices, indices);
}

// SPDX-License-Identifier: MIT

// Must not compile, each line in the same words: results where their values are wanted.

#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/text/flipped_triangles.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>

using namespace typemesh;
using test::toy_font;

struct other_font : toy_font {};

void fonts(result<toy_font>& font, result<other_font>& other)
{
    text_mesher mesher{font};
    d3dx_text maker{other};
}

void plans(text_mesher<toy_font>& mesher, std::span<d3dx_vertex> vertices, std::span<std::uint32_t> indices)
{
    auto plan = mesher.plan("o");
    text_chunks chunks;
    (void)chunks.cut(plan);
    (void)chunks.cut(plan, 1000);
    (void)chunks.write(plan, into(vertices, indices));
    (void)flipped_triangles(plan);
}

void teams(text_mesher<toy_font>& mesher, result<glyph_workers<one_worker, toy_font>>& team,
           std::span<d3dx_vertex> vertices, std::span<std::uint32_t> indices)
{
    (void)mesher.plan("o", {}, team);
    (void)mesher.build("o", into(vertices, indices), {}, team);
}

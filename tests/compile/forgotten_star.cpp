// SPDX-License-Identifier: MIT

// Must not compile, each line in the same words: results where their values are wanted.

#include "../support/toy_covering_font.hpp"
#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/flipped_triangles.hpp>
#include <typemesh/text/font_cascade.hpp>
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

struct used_font : toy_font {};

void exchanged(text_mesher<>& mesher, result<used_font>& font) { mesher.use(font); }

struct covering_font : test::toy_covering_font {};
struct foreign_font : test::toy_covering_font {};

void paragraphs(result<test::toy_covering_font>& font, result<covering_font>& other, foreign_font& third,
                result<foreign_font>& fourth)
{
    paragraph words{font};
    font_cascade fonts{other, other};
    font_cascade more{third, fourth};
}

void plans(text_mesher<>& mesher, std::span<d3dx_vertex> vertices, std::span<std::uint32_t> indices)
{
    auto plan = mesher.plan("o");
    text_chunks chunks;
    (void)chunks.cut(plan);
    (void)chunks.cut(plan, 1000);
    (void)chunks.write(plan, into(vertices, indices));
    (void)flipped_triangles(plan);
}

void teams(text_mesher<>& mesher, result<glyph_workers<one_worker, toy_font>>& team, std::span<d3dx_vertex> vertices,
           std::span<std::uint32_t> indices)
{
    (void)mesher.plan("o", {}, team);
    (void)mesher.build("o", into(vertices, indices), {}, team);
}

// SPDX-License-Identifier: MIT

// Must not compile, each with a sentence: options that belong into a member of text_options, or to the solid.

#include "../support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <vector>

using namespace typemesh;

void set(text_mesher<>& mesher, std::vector<vec3>& points, std::vector<std::uint32_t>& indices, const glyph_run& run)
{
    (void)mesher.plan("o", {.align = alignment::centre});
    (void)mesher.plan("o", layout_options{.indent = 1.0});
    (void)mesher.build("o", into(points, indices), {.line_spacing = 2.0});
    (void)mesher.plan("o", {.letter_spacing = 0.1});
    (void)mesher.build("o", into(points, indices), {.language = "tr"});
    (void)mesher.plan("o", {.depth = 0.5f});
    (void)mesher.plan(run, {.depth = 0.5f});
    (void)mesher.build(run, into(points, indices), {.depth = 0.5f});
}

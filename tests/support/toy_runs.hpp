// SPDX-License-Identifier: MIT
#pragma once

// Runs of glyphs that no shaper has made, at 1000 units to the em, and workers that have the toy font.

#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <initializer_list>

namespace test {

/// Glyphs, and the glyph styles to which they refer.
inline typemesh::glyph_run run_of(std::initializer_list<typemesh::placed_glyph> glyphs,
                                  std::initializer_list<typemesh::glyph_style> styles = {})
{
    typemesh::glyph_run run;
    run.units_per_em = 1000.0;
    for (const typemesh::glyph_style& s : styles) REQUIRE(run.glyph_styles.push_back(s));
    for (const typemesh::placed_glyph& g : glyphs) REQUIRE(run.glyphs.push_back(g));
    return run;
}

/// One glyph at several pens on one line.
inline typemesh::glyph_run row_of(typemesh::glyph_id id, std::initializer_list<double> pens)
{
    typemesh::glyph_run run;
    run.units_per_em = 1000.0;
    for (const double x : pens) REQUIRE(run.glyphs.push_back({id, 0, {x, 0.0}}));
    return run;
}

/// A run of these glyphs in these glyph styles.
inline typemesh::glyph_run styled_run(std::initializer_list<typemesh::glyph_style> glyph_styles,
                                      std::initializer_list<typemesh::placed_glyph> glyphs)
{
    typemesh::glyph_run run;
    for (const typemesh::glyph_style& l : glyph_styles) REQUIRE(run.glyph_styles.push_back(l));
    for (const typemesh::placed_glyph& g : glyphs) REQUIRE(run.glyphs.push_back(g));
    return run;
}

/// Workers, each with a toy font of its own.
inline auto toy_team(auto& executor)
{
    using namespace typemesh;
    return required(workers_of(executor, [](std::size_t) noexcept { return result<toy_font>{toy_font{}}; }));
}

}  // namespace test

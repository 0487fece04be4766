// SPDX-License-Identifier: MIT
#pragma once

#include "contour_laws.hpp"
#include "damaged_fonts.hpp"
#include "read_text.hpp"

#include "support/mesh_laws.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Font bytes and a text -> everything: damaged copies of installed fonts, through both libraries.
namespace fuzz {

namespace font_laws {

using namespace typemesh;

inline bool is_an_answer(error e)
{
    return e == error::not_a_font || e == error::no_such_face || e == error::no_outlines ||
           e == error::font_library_failed || e == error::outline_not_finite || e == error::needs_shaping;
}

/// A plan's mesh is closed, and its normals are finite.
template <class Mesher, class Text>
broken_law of_text(Mesher& mesher, const Text& text, const text_options& how)
{
    const auto plan = mesher.plan(text, how);
    if (!plan) return is_an_answer(plan.error()) || plan.error() == error::bad_option ? "" : plan.error().message();
    test::full_mesh m;
    if (plan->write(into(m.vertices, m.indices))) return "write failed";
    if (!(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan->size())) return "another size than planned";
    const auto closed = test::examine(m);
    if (closed.unmatched_edges != 0 || closed.bad_corners != 0) return "the mesh is open";
    for (const auto& v : m.vertices)
        if (!(std::fabs(test::dot(v.normal, v.normal) - 1.0) < 1e-4)) return "a normal is not of unit length";
    return {};
}

/// The glyphs that have been changed, alone and in a row.
template <class Font, class Mesher>
broken_law of_glyphs(Font& font, Mesher& mesher, const std::vector<glyph_id>& glyphs, const text_options& how)
{
    glyph_run run;
    run.units_per_em = font.units_per_em();
    for (const glyph_id id : glyphs) {
        outline o;
        if (const error e = record(font, id, o)) return is_an_answer(e) || e == error::unknown_glyph ? "" : e.message();
        if (broken_law broken = of_contours(o); !broken.empty()) return broken;
        const double pen = 500.0 * static_cast<double>(run.glyphs.size());
        if (!run.glyphs.push_back({id, static_cast<cluster_id>(run.glyphs.size()), {pen, 0.0}})) return "no memory";
    }
    return run.glyphs.empty() ? "" : of_text(mesher, run, how);
}

template <class Font>
broken_law of_font(const damaged_font& given, text_view text, const text_options& how, double width)
{
    auto font = Font::open(std::span{given.bytes}, {});
    if (!font) return is_an_answer(font.error()) ? "" : font.error().message();
    auto mesher = text_mesher{*font}.with(extruded<>{.depth = 0.25f});
    if (broken_law broken = of_glyphs(*font, mesher, given.glyphs, how); !broken.empty()) return broken;
    if constexpr (item_shaper<Font>) {
        paragraph<Font> words{*font};
        glyph_run run;
        error e = words.set(text, how.shape);
        if (!e) e = words.lay_out({.width = width, .align = line_alignment::justify}, run);
        if (e) return is_an_answer(e) ? "" : e.message();
        for (const placed_glyph& g : run.glyphs)
            if (g.cluster >= text.size() && !text.empty()) return "a cluster beyond the text";
        return of_text(mesher, run, how);
    } else {
        return of_text(mesher, text, how);
    }
}

}  // namespace font_laws

inline broken_law fonts(values in)
{
    using namespace typemesh;
    using namespace font_laws;
    const auto& whole = whole_fonts();
    if (whole.empty()) return "no font is installed: see TYPEMESH_FONT_DIR";
    const std::uint32_t bits = in.byte();
    const damaged_font damaged{in, whole[bits % whole.size()]};
    const double width = in.between(0.5, 20.0);
    text_options how;
    how.tolerance = quality::normal;
    how.unit = output_unit::font_units;
    how.most_pieces = 20'000;
    how.merge = in.flag();
    how.draw_missing = in.flag();
    const read_text text{in, 24};
    if (bits >= 128) return of_font<freetype_font>(damaged, text.view(), how, width);
    return of_font<harfbuzz_font>(damaged, text.view(), how, width);
}

}  // namespace fuzz

// SPDX-License-Identifier: MIT
#pragma once

#include "contour_laws.hpp"
#include "damaged_fonts.hpp"
#include "drawn_chords.hpp"
#include "front_cap.hpp"
#include "read_text.hpp"

#include "support/mesh_laws.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

/// Font bytes and a text -> everything: damaged copies of installed fonts, through both libraries.
namespace fuzz {

namespace font_laws {

using namespace typemesh;

inline bool is_an_answer(error e)
{
    return e == error::not_a_font || e == error::no_such_face || e == error::no_outlines ||
           e == error::font_library_failed || e == error::outline_not_finite || e == error::needs_shaping ||
           e == error::unknown_variation;
}

/// A plan's mesh is closed, and its normals are finite.
template <class Mesher, class Text>
broken_law of_text(Mesher& mesher, const Text& text, const text_options& how)
{
    const auto plan = mesher.plan(text, how);
    if (!plan) return is_an_answer(plan.error()) || plan.error() == error::bad_option ? "" : plan.error().message();
    test::full_mesh m;
    if (!plan->write(into(m.vertices, m.indices))) return "write failed";
    if (!(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan->size())) return "another size than planned";
    const auto closed = test::examine(m);
    if (closed.unmatched_edges != 0 || closed.bad_corners != 0) return "the mesh is open";
    for (const auto& v : m.vertices)
        if (!(std::fabs(test::dot(v.normal, v.normal) - 1.0) < 1e-4)) return "a normal is not of unit length";
    return {};
}

/// The front of a glyph is where the font library itself draws it, except within the tolerance of its curves.
template <class Font>
broken_law of_front(Font& font, glyph_id id)
{
    const drawn_chords wanted{font, id};
    const double em = font.units_per_em(), tolerance = quality::normal * em;
    if (wanted.empty() || !wanted.is_whole() || !(wanted.reach() < 0x1p17)) return {};
    glyph_run run;
    run.units_per_em = em;
    if (!run.glyphs.push_back({id, 0, {}})) return "no memory";
    auto mesher = text_mesher{font}.with(flat{});
    const auto plan = mesher.plan(run, {.tolerance = quality::normal, .unit = output_unit::font_units});
    if (!plan) return plan.error().message();
    if (plan->report().refused != 0) return {};
    test::full_mesh m;
    if (!plan->write(into(m.vertices, m.indices))) return "write failed";
    const front_cap front{m, plan->range(part::front)};
    constexpr int rows = 9;
    const double slack = 1.05 * tolerance + 1.0;  // their chords are not curves either
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < rows; ++k) {
            const double x = wanted.left + (wanted.right - wanted.left) * (i + 0.37) / rows;
            const double y = wanted.bottom + (wanted.top - wanted.bottom) * (k + 0.61) / rows;
            const auto place = wanted.at(x, y);
            const int count = place.away > slack ? front.count_at(x, y, 0.05) : -1;
            if (count >= 0 && count != (place.winding != 0 ? 1 : 0))
                return "a place is filled that the font does not fill, or the reverse";
        }
    return {};
}

/// The glyphs that were changed, one by one and in a row.
template <class Font, class Mesher>
broken_law of_glyphs(Font& font, Mesher& mesher, const std::vector<glyph_id>& glyphs, const text_options& how)
{
    glyph_run run;
    run.units_per_em = font.units_per_em();
    for (const glyph_id id : glyphs) {
        outline o;
        if (const auto done = record(font, id, o); !done)
            return is_an_answer(done.error()) || done.error() == error::unknown_glyph ? "" : done.error().message();
        if (broken_law broken = of_contours(o); !broken.empty()) return broken;
        if (broken_law broken = of_front(font, id); !broken.empty()) return broken;
        const double pen = 500.0 * static_cast<double>(run.glyphs.size());
        if (!run.glyphs.push_back({id, static_cast<cluster_id>(run.glyphs.size()), {pen, 0.0}})) return "no memory";
    }
    return run.glyphs.empty() ? "" : of_text(mesher, run, how);
}

/// The options for a font.
struct request {
    text_options how;
    double width = 0.0;
    std::uint32_t bits = 0;

    explicit request(values& in) : width{in.between(0.5, 20.0)}, bits{in.byte()}
    {
        constexpr direction directions[] = {direction::automatic, direction::left_to_right, direction::right_to_left,
                                            direction::top_to_bottom};
        how.tolerance = quality::normal;
        how.unit = output_unit::font_units;
        how.max_pieces = 20'000;
        how.merge = (bits & 1) != 0;
        how.draw_missing = (bits & 2) != 0;
        how.shape.direction = directions[bits >> 2 & 3];
        how.shape.ligatures = (bits & 16) == 0;
    }
    [[nodiscard]] bool is_varied() const { return (bits & 0xE0) == 0xE0; }
};

template <class Font>
broken_law of_font(const damaged_font& given, text_view text, const request& asked)
{
    const variation weight[] = {{"wght", static_cast<float>(50.0 * asked.width)}};
    const auto variations = asked.is_varied() ? std::span<const variation>{weight} : std::span<const variation>{};
    auto font = Font::open(std::span{given.bytes}, {.variations = variations});
    if (!font) return is_an_answer(font.error()) ? "" : font.error().message();
    auto mesher = text_mesher{*font}.with(extruded<>{.depth = 0.25f});
    if (broken_law broken = of_glyphs(*font, mesher, given.glyphs, asked.how); !broken.empty()) return broken;
    if constexpr (shaper<Font>) {
        paragraph<Font> words{*font};
        glyph_run run;
        error e = words.set(text, asked.how.shape).error();
        if (!e) e = words.lay_out({.width = asked.width, .align = alignment::justify}, run).error();
        if (e) return is_an_answer(e) ? "" : e.message();
        for (const placed_glyph& g : run.glyphs)
            if (g.cluster >= text.size() && !text.empty()) return "a cluster beyond the text";
        if (broken_law broken = of_text(mesher, run, asked.how); !broken.empty()) return broken;
    }
    return of_text(mesher, text, asked.how);
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
    const request asked{in};
    const read_text text{in, 24};
    return bits >= 128 ? of_font<freetype_font>(damaged, text.view(), asked)
                       : of_font<harfbuzz_font>(damaged, text.view(), asked);
}

}  // namespace fuzz

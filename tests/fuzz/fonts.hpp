// SPDX-License-Identifier: MIT
#pragma once

#include "read_text.hpp"

#include "support/mesh_laws.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

/// Font bytes and a text -> everything: damaged copies of installed fonts, through both libraries.
namespace fuzz {

namespace font_laws {

using namespace typemesh;

/// Those that are installed, read once: TrueType, CFF, variable, coloured. TYPEMESH_FONT_DIR, or where Debian has them.
inline const std::vector<std::vector<std::byte>>& whole_fonts()
{
    static const std::vector<std::vector<std::byte>> all = [] {
        const char* given = std::getenv("TYPEMESH_FONT_DIR");
        const std::filesystem::path folder = given != nullptr ? given : "/usr/share/fonts";
        std::vector<std::vector<std::byte>> read;
        for (const char* name :
             {"truetype/liberation/LiberationMono-Regular.ttf", "opentype/comic-neue/ComicNeue-Regular.otf",
              "truetype/lohit-devanagari/Lohit-Devanagari.ttf", "truetype/inter-vf/Inter-roman.var.ttf",
              "opentype/fonts-hosny-amiri/AmiriQuranColored.ttf"}) {
            std::ifstream in{folder / name, std::ios::binary};
            const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
            const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
            if (!bytes.empty()) read.emplace_back(first, first + bytes.size());
        }
        return read;
    }();
    return all;
}

/// Where a table begins, by its number in the directory, and how long it is; the directory itself for 255.
struct table_place {
    std::size_t at = 0, size = 0;

    table_place(std::span<const std::byte> font, std::uint32_t number)
    {
        const auto byte = [&](std::size_t i) { return i < font.size() ? std::to_integer<std::size_t>(font[i]) : 0; };
        const auto word = [&](std::size_t i) {
            return byte(i) << 24 | byte(i + 1) << 16 | byte(i + 2) << 8 | byte(i + 3);
        };
        const std::size_t tables = byte(4) << 8 | byte(5), entry = 12 + 16 * (tables == 0 ? 0 : number % tables);
        const bool whole = number == 255 || tables == 0;
        at = whole ? 0 : (std::min)(word(entry + 8), font.size() - 1);
        size = whole ? 12 + 16 * tables : word(entry + 12);
        size = (std::max)(std::size_t{1}, (std::min)(size, font.size() - at));
    }
};

/// Up to 15 places changed: a byte, or two to an extreme number; sometimes cut short.
inline std::vector<std::byte> read_font(values& in, std::span<const std::byte> whole)
{
    std::vector<std::byte> font(whole.begin(), whole.end());
    const std::uint32_t how = in.byte();
    for (std::uint32_t left = how & 15; left > 0; --left) {
        const table_place table{whole, in.byte()};
        const std::size_t i = table.at + in.bits(3) % table.size;
        constexpr std::uint32_t extremes[] = {0x0000, 0xFFFF, 0x7FFF, 0x8000};
        if ((how & 16) != 0 && i + 1 < font.size()) {
            const std::uint32_t number = in.one_of(extremes);
            font[i] = static_cast<std::byte>(number >> 8);
            font[i + 1] = static_cast<std::byte>(number & 0xFF);
        } else {
            font[i] = static_cast<std::byte>(in.byte());
        }
    }
    if ((how & 0xE0) == 0xE0) font.resize(in.bits(3) % font.size());
    font.shrink_to_fit();
    return font;
}

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

template <class Font>
broken_law of_font(std::span<const std::byte> bytes, text_view text, const text_options& how, double width)
{
    auto font = Font::open(bytes, {});
    if (!font) return is_an_answer(font.error()) ? "" : font.error().message();
    auto mesher = text_mesher{*font}.with(extruded<>{.depth = 0.25f});
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
    const std::vector<std::byte> bytes = read_font(in, whole[bits % whole.size()]);
    const double width = in.between(0.5, 20.0);
    text_options how;
    how.tolerance = quality::normal;
    how.unit = output_unit::font_units;
    how.most_pieces = 20'000;
    how.merge = in.flag();
    how.draw_missing = in.flag();
    const read_text text{in, 24};
    if (bits >= 128) return of_font<freetype_font>(bytes, text.view(), how, width);
    return of_font<harfbuzz_font>(bytes, text.view(), how, width);
}

}  // namespace fuzz

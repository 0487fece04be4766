// SPDX-License-Identifier: MIT
#pragma once

#include "read_text.hpp"

#include "support/toy_covering_font.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/outline/bar_face.hpp>
#include <typemesh/paragraph/fit_size.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/unicode/hyphenating.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// A text -> paragraph: lines, glyphs, carets, styles, hyphens, columns, fallback fonts.
namespace fuzz {

namespace paragraph_laws {

using namespace typemesh;

struct settings {
    shape_options how;
    std::vector<style_span> spans, reversed;

    settings(values& in, std::size_t size)
    {
        constexpr direction directions[] = {direction::automatic, direction::left_to_right, direction::right_to_left,
                                            direction::top_to_bottom};
        const std::uint32_t bits = in.byte();
        how.direction = directions[bits & 3];
        how.ligatures = (bits & 4) == 0;
        if (how.direction == direction::top_to_bottom) {
            const std::uint32_t upright = in.byte();
            how.columns.latin = (upright & 1) != 0 ? column_latin::upright : column_latin::sideways;
            how.columns.combined_digits = upright >> 1 & 7;
            how.columns.combined_gap = (upright >> 4) / 30.0;
        }
        if ((bits & 8) != 0) how.letter_spacing = in.between(0.0, 1.5);
        const std::uint32_t most = (bits & 16) != 0 ? in.below(6) : 0;
        for (std::uint32_t k = 0, at = 0; k < most && at < size; ++k) {
            style_span s;
            s.first = (std::min)(static_cast<std::uint32_t>(size), at + in.below(8));
            s.last = (std::min)(static_cast<std::uint32_t>(size), s.first + in.below(12));
            at = s.last - ((bits & 32) != 0 && s.last > s.first && in.byte() == 1 ? 1 : 0);  // may overlap the next
            read(in, s.style);
            spans.push_back(s);
        }
        reversed.assign(spans.rbegin(), spans.rend());
    }

    [[nodiscard]] shape_options with(const std::vector<style_span>& styles) const
    {
        shape_options styled = how;
        styled.styles = styles;
        return styled;
    }

private:
    static void read(values& in, text_style& s)
    {
        const std::uint32_t what = in.byte();
        s.style = style_id{in.below(4)};
        if ((what & 1) != 0) s.size = in.between(0.25, 4.0);
        if ((what & 2) != 0) s.letter_spacing = in.between(0.0, 2.0);
        if ((what & 4) != 0) s.word_spacing = in.between(0.0, 2.0);
        if ((what & 8) != 0) s.rise = in.between(-1.0, 1.0);
        if ((what & 16) != 0) s.position = in.one_of({script_position::superscript, script_position::subscript});
        if ((what & 32) != 0) s.decorations = static_cast<decoration>(in.below(8));
        if ((what & 64) != 0) s.column = static_cast<column_style>(in.below(4));
        if ((what & 128) != 0) s.slant = in.between(-0.5, 0.5);
    }
};

struct layout_settings {
    layout_options options;
    std::vector<double> stops;

    explicit layout_settings(values& in)
    {
        const std::uint32_t what = in.byte(), more = in.byte();
        if ((what & 1) != 0) options.width = in.flag() ? in.between(0.01, 4.0) : in.between(1.0, 40.0);
        options.wrap = static_cast<wrap_mode>(more & 3);
        options.align = static_cast<alignment>((more >> 2) % 6);
        options.anchor = static_cast<vertical_anchor>((more >> 5) % 5);
        options.boxes = static_cast<line_box>(more >> 7);
        if ((what & 2) != 0) options.height = in.between(0.0, 20.0);
        if ((what & 4) != 0) options.max_lines = 1 + in.below(4);
        if ((what & 8) != 0)
            options.ellipsis = text_view{in.one_of({"...", "\xE2\x80\xA6", "a", " ", "\n", "\xD7\x90"})};
        options.elide = static_cast<ellipsis_place>((what >> 4) % 3);
        if ((what & 64) != 0) options.indent = in.between(-2.0, 3.0);
        if ((what & 128) == 0) return;
        options.justify = static_cast<justification>((in.below(4) + 1) % 4);
        options.line_spacing = in.between(1.0, 3.0);
        options.tab_width = in.between(0.0, 8.0);
        for (double at = 0.0; stops.size() < 3 && in.flag();) stops.push_back(at += in.between(0.1, 3.0));
        options.tab_stops = stops;
    }

    /// Everything in the text is drawn, and nothing else except hyphens.
    [[nodiscard]] bool shows_all() const
    {
        const bool strokes = options.align == alignment::justify && options.justify == justification::kashida;
        return options.max_lines > 1'000'000 && options.ellipsis.empty() && !strokes;
    }
};

inline bool equal(const glyph_run& a, const glyph_run& b)
{
    const auto same_glyph = [](const placed_glyph& g, const placed_glyph& h) {
        return g.id == h.id && g.cluster == h.cluster && g.origin == h.origin && g.glyph_style == h.glyph_style &&
               g.missing == h.missing;
    };
    const auto same_line = [](const text_line& k, const text_line& l) {
        return k.first_glyph == l.first_glyph && k.glyph_count == l.glyph_count && k.origin == l.origin &&
               same(k.advance, l.advance);
    };
    return std::equal(a.glyphs.begin(), a.glyphs.end(), b.glyphs.begin(), b.glyphs.end(), same_glyph) &&
           std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(), same_line) &&
           a.glyph_styles.size() == b.glyph_styles.size();
}

/// Lines cover the text without a gap, and everything is finite.
template <class Words>
broken_law of_lines(const Words& words, const layout_settings& how, const glyph_run& run)
{
    const auto lines = words.lines();
    const auto size = static_cast<std::uint32_t>(words.shaped().text().size());
    if (lines.empty() || lines.size() != run.lines.size()) return "lines are miscounted";
    if (lines.size() > how.options.max_lines) return "more lines than allowed";
    std::uint32_t at = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (lines[k].first != at || lines[k].last < at) return "lines leave a gap";
        at = lines[k].last;
        if (lines[k].first == at && k + 1 < lines.size()) return "an empty line within the text";
        if (!is_finite(lines[k].left) || !is_finite(lines[k].width) || !(lines[k].width >= 0.0))
            return "a line's width is no width";
    }
    if (at > size || (at < size && how.options.max_lines > lines.size())) return "lines do not cover the text";
    for (const placed_glyph& g : run.glyphs) {
        if (!is_finite(g.origin.x) || !is_finite(g.origin.y)) return "a glyph stands nowhere";
        if (g.glyph_style >= run.glyph_styles.size() && g.glyph_style != 0) return "a glyph has no glyph style";
    }
    return {};
}

using glyph_places = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // cluster, id

/// The sorted glyphs of a line's text when it is shaped by itself, without hyphens and bars.
template <class Words, class Font>
error shape_line_only(const Words& words, Font& font, const laid_line& line, glyph_places& shaped_glyphs)
{
    buffer<shaped_glyph> glyphs;
    const shaped_text& shaped = words.shaped();
    for (std::uint32_t k = 0; k < shaped.items().size(); ++k) {
        text_item item = shaped.items()[k];
        item.first = (std::max)(item.first, line.first);
        item.last = (std::min)(item.last, line.last);
        if (item.first >= item.last || silent_at(shaped.text(), item.first) != 0) continue;
        const bool one_cluster = item.orientation == glyph_orientation::combined;
        const auto before = glyphs.size();
        if (error e = font.shape(shaped.text(), item, shaped.options_of(k), glyphs)) return e;
        for (const shaped_glyph& g : glyphs.view().subspan(before))
            shaped_glyphs.emplace_back(one_cluster ? item.first : g.cluster, g.id);
    }
    std::sort(shaped_glyphs.begin(), shaped_glyphs.end());
    return {};
}

/// Every cluster is drawn once, in its own line, with the same glyphs as the line's text by itself.
template <class Words, class Font>
broken_law of_glyphs(const Words& words, Font& font, const glyph_run& run)
{
    for (std::size_t k = 0; k < words.lines().size(); ++k) {
        const laid_line& line = words.lines()[k];
        glyph_places drawn, single;
        for (std::uint32_t i = 0; i < run.lines[k].glyph_count; ++i) {
            const placed_glyph& g = run.glyphs[run.lines[k].first_glyph + i];
            if (!run.glyph_styles.empty() && run.glyph_styles[g.glyph_style].face == bar_face) continue;
            if (g.cluster < line.first || g.cluster >= line.last) return "a glyph is in another line";
            drawn.emplace_back(g.cluster, g.id);
        }
        std::sort(drawn.begin(), drawn.end());
        if (shape_line_only(words, font, line, single)) return "a shaped line cannot be shaped again";
        if (drawn != single && !words.shaped().hyphenates(line.last)) return "a line differs from its text by itself";
    }
    return {};
}

struct caret_place {
    std::uint32_t unit;
    affinity side;
    caret at;

    [[nodiscard]] bool is_at(const caret& b) const
    {
        return at.line == b.line && std::fabs(at.at.x - b.at.x) < 1e-6 && std::fabs(at.at.y - b.at.y) < 1e-6;
    }
};

/// Whether a caret is in the box of its own line, and of no other.
template <class Words>
bool stands_in_its_line(const Words& words, const caret& c)
{
    const bool down = words.shaped().in_columns();
    for (std::size_t k = 0; k < words.lines().size(); ++k) {
        const box b = words.laid().line_box(k);
        const bool inside = down ? c.at.x >= b.low.x && c.at.x <= b.high.x : c.at.y >= b.low.y && c.at.y <= b.high.y;
        if (inside != (k == c.line)) return false;
    }
    return true;
}

/// A caret's own point leads back to the caret.
template <class Words>
broken_law of_carets(const Words& words)
{
    const laid_text laid = words.laid();
    const auto& marks = words.shaped().analysis.marks;
    std::vector<caret_place> all;
    for (std::uint32_t unit = 0; unit <= marks.size(); ++unit) {
        if (unit < marks.size() && !has(marks[unit], text_mark::grapheme)) continue;
        for (const affinity side : {affinity::downstream, affinity::upstream})
            all.push_back({unit, side, laid.caret_at(unit, side)});
    }
    for (const caret_place& one : all) {
        if (one.at.line >= words.lines().size() || !is_finite(one.at.at.x) || !is_finite(one.at.at.y))
            return "a caret stands nowhere";
        if (!stands_in_its_line(words, one.at)) continue;
        const text_place found = laid.caret_from(one.at.at);
        if (found.unit > marks.size()) return "a place after the end of the text";
        if (!one.is_at(laid.caret_at(found.unit, found.side))) return "a caret's point leads elsewhere";
        std::size_t others = 0, here = 0;
        for (const caret_place& other : all) {
            if (!other.is_at(one.at)) continue;
            others += other.unit != one.unit ? 1u : 0u;
            ++here;
        }
        if (others == 0 && found.unit != one.unit) return "the point of a single caret leads to another unit";
        if (here == 1 && found.side != one.side) return "the point of a single caret leads to its other side";
    }
    return {};
}

/// Every range of the text has proper boxes.
template <class Words>
broken_law of_boxes(const Words& words, values& in)
{
    broken_law broken;
    const auto size = static_cast<std::uint32_t>(words.shaped().text().size());
    const std::uint32_t a = in.below(size + 2), b = in.below(size + 2);
    words.laid().boxes_of(a, b, [&](const box& found) {
        const bool good = is_finite(found.low.x) && is_finite(found.high.x) && found.low.x <= found.high.x + 1e-9 &&
                          found.low.y <= found.high.y + 1e-9;
        if (!good) broken = "a box is not finite or turned over";
    });
    return broken;
}

/// Lays out a text in two paragraphs: one with other layouts before it, and with its spans in another order.
template <class Words, class Font>
broken_law of_layout(Words& words, Words& fresh, Font& font, const layout_settings& how, values& in)
{
    glyph_run run, again;
    if (const auto done = words.lay_out(how.options, run); !done) return done.error().message();
    if (broken_law broken = of_lines(words, how, run); !broken.empty()) return broken;
    if (how.shows_all())
        if (broken_law broken = of_glyphs(words, font, run); !broken.empty()) return broken;
    if (how.shows_all() && words.shaped().text().size() < 80)
        if (broken_law broken = of_carets(words); !broken.empty()) return broken;
    if (broken_law broken = of_boxes(words, in); !broken.empty()) return broken;
    if (!fresh.lay_out(how.options, again)) return "a laid-out text cannot be laid out afresh";
    if (!equal(run, again)) return "a layout depends on earlier ones, or on the order of the spans";
    const paragraph_widths widths = words.widths();
    if (!(widths.narrowest <= widths.widest)) return "the narrowest width is wider than the widest";
    const auto measured = words.measure(how.options);
    if (!measured || !(measured->width <= widths.widest * 1e9 + 1e9)) return "a laid-out text cannot be measured";
    return words.lines().size() == run.lines.size() ? "" : "measured in other lines than laid out";
}

/// At the size that fit_size() finds, the text fits.
template <class Words>
broken_law of_size(Words& words, const layout_settings& how, values& in)
{
    const double width = in.between(0.1, 40.0), height = in.between(0.1, 20.0);
    const auto size = fit_size(words, width, height, how.options);
    if (!size) return size.error() == error::bad_option ? "" : size.error().message();
    if (!(*size > 0.0) || !is_finite(*size)) return "a size is not positive";
    layout_options options = how.options;
    options.width = width / *size;
    options.ellipsis = {};
    const auto measured = words.measure(options);
    if (!measured) return measured.error().message();
    const bool fits =
        measured->width * *size <= width * (1.0 + 1e-6) && measured->height * *size <= height * (1.0 + 1e-6);
    return fits ? "" : "at the size that was found the text does not fit";
}

using analyser = hyphenating<unicode_analyser, any_hyphens>;

template <class Font, class Breaker>
broken_law of_paragraph(values& in, Font& font, const Breaker& breaker)
{
    const any_hyphens hyphens{in.below(5)};
    const read_text text{in, 300};
    const settings how{in, text.view().size()};
    using words_type = paragraph<Font, analyser, Breaker>;
    const auto make = [&] { return words_type{font, heap(), analyser{unicode_analyser{}, hyphens}, breaker}; };
    words_type words = make();
    const error e = words.set(text.view(), how.with(how.spans)).error();
    for (int k = 0; k < 3; ++k) {
        const layout_settings layout{in};
        words_type fresh = make();
        if (fresh.set(text.view(), how.with(how.reversed)).error().code != e.code)
            return "an error depends on the order of the spans";
        if (e) return e == error::overlapping_spans || e == error::font_library_failed ? "" : e.message();
        if (broken_law broken = of_layout(words, fresh, font, layout, in); !broken.empty()) return broken;
        if (in.byte() == 1)
            if (broken_law broken = of_size(fresh, layout, in); !broken.empty()) return broken;
    }
    return {};
}

/// Each of three fonts draws what it has, and nothing is missing that only one of them has.
template <class Breaker>
broken_law of_cascade(values& in, const Breaker& breaker)
{
    test::toy_covering_font latin{U"abcdefghijklmnop .-\u2026\u0300\u0301\u0640", 1000.0},
        hebrew{U"\u05D0\u05D1\u05BF\u0628\u0627\u0640ab ", 2048.0}, rest{U"\u4E00\u3042\u30FC\u0301\u0E01x", 64.0};
    font_cascade fonts{latin, hebrew, rest};
    values copy = in;
    {
        (void)copy.below(5);
        const read_text text{copy, 300};
        paragraph words{fonts};
        glyph_run run;
        if (!words.set(text.view()) || !words.lay_out({}, run)) return "toy fonts cannot be laid out";
        const test::toy_covering_font* const all[] = {&latin, &hebrew, &rest};
        for (const placed_glyph& g : run.glyphs) {
            const std::uint32_t face = run.glyph_styles.empty() ? 0 : run.glyph_styles[g.glyph_style].face;
            if (g.missing || g.id == 0 || face == bar_face) continue;
            if (is_default_ignorable(g.id)) continue;
            if (face > 2) return "a glyph has a font that does not exist";
            if (!all[face]->covers(g.id)) return "a font draws a glyph that it lacks";
        }
    }
    return of_paragraph(in, fonts, breaker);
}

template <class Breaker>
broken_law of_fonts(values& in, const Breaker& breaker)
{
    const std::uint32_t bits = in.byte();
    if ((bits & 12) == 12) return of_cascade(in, breaker);
    test::toy_shaper font;
    font.all_unsafe = (bits & 1) != 0;
    return of_paragraph(in, font, breaker);
}

}  // namespace paragraph_laws

inline broken_law paragraphs(values in)
{
    using namespace typemesh;
    if (in.byte() % 4 != 0) return paragraph_laws::of_fonts(in, first_fit{});
    total_fit breaker;
    breaker.tolerance = in.between(0.1, 3.0);
    breaker.emergency_stretch = in.between(0.0, 2.0);
    return paragraph_laws::of_fonts(in, breaker);
}

}  // namespace fuzz

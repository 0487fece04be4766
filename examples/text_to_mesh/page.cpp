// SPDX-License-Identifier: MIT
#include "page.hpp"

#include "ink.hpp"
#include "report.hpp"

#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/ruby_writer.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#ifdef TEXT_TO_MESH_ICU
#include <typemesh/adapt/icu.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string_view>
#include <vector>

namespace text_to_mesh {
namespace {

typemesh::shape_options shape_options_of(const options& o)
{
    return {.direction = o.direction,
            .language = o.language,
            .script = o.script,
            .features = o.features,
            .letter_spacing = o.letter_spacing,
            .columns = o.columns};
}

#ifdef TEXT_TO_MESH_ICU
using analyser = typemesh::icu_analyser;  // it finds the words of Thai, Lao, Khmer and Burmese
#else
using analyser = typemesh::unicode_analyser;
#endif

/// Looks for the lines with which a text fills a box at the largest size, by what is seen of it.
///
///     size in em     the smaller of  box width / ink width  and  box height / ink height
///
/// The narrower the lines, the greater the first and the smaller the second: the best lines stand where they cross.
template <class Paragraph>
class box_filling {
public:
    box_filling(const options& o, font_set& font, Paragraph& words, const typemesh::layout_options& lines)
        : o_{o}, words_{words}, lines_{lines}, ink_{font}
    {
        lines_.ellipsis = {};
        if (lines_.wrap == typemesh::wrap_mode::word_or_grapheme) lines_.wrap = typemesh::wrap_mode::word;
    }

    /// Lays the text out. Gives an empty string, or what is wrong; `page` is empty if nothing of the text is seen.
    std::string fill(typemesh::glyph_run& page, double& size)
    {
        const typemesh::paragraph_widths widths = words_.widths();
        const double indent = std::fabs(lines_.indent);
        double high = widths.widest + indent, low = widths.narrowest;
        if (lines_.wrap == typemesh::wrap_mode::grapheme) low = 0.0;
        if (!(high > 0.0)) high = 1.0;
        trial natural = laid_out(high, page);
        if (natural.error) return in_words(natural.error);
        if (!natural.whole) return "--fit: the text needs more lines than --max-lines allows.";
        trial best = natural;
        bool wide = natural.across > natural.along;  // lines are too long for the box
        while (wide && lines_.wrap != typemesh::wrap_mode::none && high > low + 1e-6 * high) {
            const double middle = low + (high - low) / 2;
            const trial t = laid_out(middle, page);
            if (t.error) return in_words(t.error);
            if (t.size() > best.size()) best = t;
            (t.whole && t.across > t.along ? high : low) = middle;
        }
        best = laid_out(best.width, page);
        size = best.size() > 0.0 ? best.size() : 1.0;
        return best.error ? in_words(best.error) : std::string{};
    }

private:
    struct trial {
        double width = 0.0, along = 0.0,
               across = 0.0;  // of lines; sizes at which the text is as long, as high as the box
        bool whole = false;
        typemesh::error error = {};
        [[nodiscard]] double size() const { return whole ? std::min(along, across) : 0.0; }
    };

    trial laid_out(double width, typemesh::glyph_run& page)
    {
        lines_.width = width * (1.0 + 1e-9);
        trial t;
        t.width = width;
        t.error = words_.lay_out(lines_, page).error();
        if (t.error) return t;
        t.whole = words_.lines().empty() || words_.lines().back().last == words_.shaped().text().size();
        const typemesh::box seen = ink_.of(page);
        const double x = o_.fit_width / (seen.width() + 2.0 * o_.growth),
                     y = o_.fit_height / (seen.height() + 2.0 * o_.growth);
        const bool columns = o_.direction == typemesh::direction::top_to_bottom;
        t.along = columns ? y : x;
        t.across = columns ? x : y;
        if (seen.empty()) t.along = t.across = 0.0;
        return t;
    }

    const options& o_;
    Paragraph& words_;
    typemesh::layout_options lines_;
    ink ink_;
};

/// Prints what an ellipsis lacks. Gives whether it lacks something.
bool name_ellipsis_losses(const options& o, font_set& font)
{
    typemesh::glyph_run run;
    if (!typemesh::layout(font, o.ellipsis, shape_options_of(o), {}, run)) return false;  // the page fails likewise
    if (run.invalid_units > 0) std::fprintf(stderr, "%s--ellipsis is not valid UTF-8.\n", o.who.c_str());
    if (run.missing > 0)
        std::fprintf(stderr, "%s--ellipsis: the font has no glyph for it, so three full stops are drawn.\n",
                     o.who.c_str());
    return run.invalid_units > 0 || run.missing > 0;
}

/// What tags put beside the letters of a page: rubies and backgrounds.
class beside_letters {
public:
    beside_letters(const options& o, font_set& font) : font_{font}
    {
        how_.shape.language = o.language;
        how_.shape.direction = o.direction == typemesh::direction::top_to_bottom ? o.direction : how_.shape.direction;
        if (!o.marked) return;
        const marked_text& m = *o.marked;
        m.read.each_ruby([&](std::uint32_t first, std::uint32_t last, std::string_view ruby, std::uint32_t look) {
            rubies_.push_back({first, last, ruby, m.styles.style_of(look)});
        });
        marks_ = m.styles.marks();
    }

    /// Makes room for them.
    typemesh::error prepare(typemesh::text_view text, typemesh::shape_options& how)
    {
        const auto rooms = writer_.rooms(font_, text, rubies_, how_);
        if (rooms) how.rooms = *rooms;
        return rooms.error();
    }

    /// Adds them to a page.
    template <class Paragraph>
    typemesh::error write(const Paragraph& words, typemesh::glyph_run& page)
    {
        if (rubies_.empty() && marks_.empty()) return {};
        typemesh::highlight_writer backgrounds;
        const typemesh::highlight_options round{.pad_along = 0.08, .pad_across = 0.0, .radius = 0.15};
        const auto behind = backgrounds.write(font_, words.laid(), marks_, round, page);
        return behind ? writer_.write(font_, words.laid(), rubies_, how_, page).error() : behind.error();
    }

private:
    font_set& font_;
    std::vector<typemesh::ruby_span> rubies_;
    std::span<const typemesh::text_highlight> marks_;
    typemesh::ruby_options how_{.overhang = 0.25};  // as browsers have it
    typemesh::ruby_writer writer_;
};

template <class Breaker>
std::string lay_out_lines(const options& o, const Breaker& breaker, font_set& font, typemesh::glyph_run& page,
                          double& size)
{
    typemesh::paragraph words{font, typemesh::heap(), analyser{}, breaker};
    typemesh::layout_options lines = o.lines;
    lines.ellipsis = o.ellipsis;
    const std::vector<typemesh::style_span> spans = spans_of(o.styles, o.text);
    typemesh::shape_options how = shape_options_of(o);
    how.styles = spans;
    if (o.marked) how.styles = o.marked->styles.spans();
    if (o.marked) how.boxes = o.marked->read.boxes();
    beside_letters beside{o, font};
    if (const typemesh::error e = beside.prepare(o.text, how)) return in_words(e);
    auto set = words.set(o.text, how);
    if (set && o.fit_width > 0.0) {
        if (std::string trouble = box_filling{o, font, words, lines}.fill(page, size); !trouble.empty()) return trouble;
    } else if (set) {
        set = words.lay_out(lines, page);
    }
    if (!set) return in_words(set.error());
    if (const typemesh::error e = beside.write(words, page)) return in_words(e);
    bool warned = !o.ellipsis.empty() && name_ellipsis_losses(o, font);
    if (const std::uint32_t moved = words.shaped().styles.moved(); moved != 0) {
        std::fprintf(stderr, "%s%s: %u %s inside a character or a combined number, so the whole of it is styled.\n",
                     o.who.c_str(), o.markup ? "--markup" : "--style", moved, moved == 1 ? "end lies" : "ends lie");
        warned = true;
    }
    return warned && o.strict ? "--strict: nothing is written." : std::string{};
}

}  // namespace

std::string lay_out(const options& o, font_set& font, typemesh::glyph_run& page, double& size)
{
    if (!o.even_lines) return lay_out_lines(o, typemesh::first_fit{}, font, page, size);
    const typemesh::total_fit even{.emergency_stretch = 0.5};  // lines of few words have few spaces to stretch
    return lay_out_lines(o, even, font, page, size);
}

}  // namespace text_to_mesh

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/text_lines.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/paragraph/first_fit.hpp>
#include <typemesh/paragraph/impl/elision.hpp>
#include <typemesh/paragraph/impl/line_justifier.hpp>
#include <typemesh/paragraph/impl/line_pieces.hpp>
#include <typemesh/paragraph/impl/text_pieces.hpp>
#include <typemesh/paragraph/laid_text.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The range of widths within which changing the width changes the line breaks, in em.
struct paragraph_widths {
    double narrowest = 0.0;  ///< the width of the longest word: in a narrower line the word is broken, or sticks out
    double widest = 0.0;     ///< the width of the longest line, if lines end only at the text's line breaks
};

/// The size of a text in a layout, in em.
struct paragraph_size {
    double width = 0.0;   ///< the width of the longest line with its indent; if more width is given, only the alignment
                          ///< changes
    double height = 0.0;  ///< the distance from the first line's ascender to the last line's descender
};

/// A text that is shaped once and then laid out at any width, as often as needed, with mixed directions.
///
///     paragraph words{font};
///     if (auto set = words.set(text); !set) puts(set.error().message());
///     auto laid = words.lay_out({.width = 20.0, .align = alignment::justify}, run);
///     auto plan = mesher.plan(run);
///
/// The text, and everything that the options refer to, must stay unchanged until the next set(). Where the end of a
/// line changes glyphs, they are shaped again, together with the text around them. Memory is kept: after warm-up
/// nothing is allocated here. Only one thread at a time may use a paragraph. A moved-from paragraph has no text until
/// its next set().
template <shaper Font, text_analyser Analyser = unicode_analyser, line_breaker Breaker = first_fit>
class paragraph {
public:
    explicit paragraph(Font& font, memory source = heap()) noexcept
        requires std::constructible_from<Analyser, memory>
        : paragraph{font, source, Analyser{source}}
    {
    }
    paragraph(Font& font, memory source, Analyser analyser, Breaker breaker = {}) noexcept
        : font_{&font},
          analyser_{std::move(analyser)},
          breaker_{std::move(breaker)},
          lines_{source},
          pieces_{source},
          elision_{source},
          justifier_{source},
          ends_{source}
    {
    }
    // A paragraph refers to its font. It refuses a temporary font, and a result without its `*`.
    explicit paragraph(const Font&&, memory = heap()) = delete;
    template <std::same_as<Font> Made>
    explicit paragraph(result<Made>& font, memory source = heap()) noexcept : paragraph{refuse_result(font), source}
    {
    }

    /// The policies; you may change their options between texts.
    [[nodiscard]] Analyser& analyser() noexcept { return analyser_; }
    [[nodiscard]] Breaker& breaker() noexcept { return breaker_; }

    /// Analyses and shapes a text. how.direction applies to the whole text; `automatic` takes each paragraph's
    /// direction from its first letter. how.styles gives parts of the text another style; shaped().styles.moved() is
    /// the number of ends of spans that were moved out of a grapheme.
    ///
    ///     words.set("E = mc2", {.styles = spans});      // const style_span spans[] = {{6, 7, {.rise = 0.3}}};
    ///
    /// Fails  error::bad_option: letter_spacing is NaN or infinite; error::too_large; error::out_of_memory; and as the
    ///        analyser, the shaper and style_spans::read() do. A layout then has no lines.
    /// Cost   O(n), plus the shaper's cost; unsafe places where a line may end are shaped twice more
    result<void> set(text_view text, const shape_options& how = {}) noexcept
    {
        lines_.forget();
        error e = lines_.read(*font_, analyser_, text, how);
        if (!e) e = lines_.shaped.shape(*font_);
        if (!e) e = pieces_.find_words(lines_.shaped, *font_);
        if (!e) e = lines_.measure_tabs(*font_);
        own_clusters_ = lines_.shaped.all_clusters();
        own_glyphs_ = lines_.shaped.all_glyphs();
        if (e) clear();
        return e;
    }

    template <dying_text Text>
    result<void> set(Text&&, const shape_options& = {}) = delete;  // a paragraph refers to its text

    /// Lays the text out. `run` is emptied and gets the glyphs and lines, as in layout().
    ///
    /// Fails  error::bad_option: see refused_option(); error::out_of_memory; and, if glyphs are shaped again, as the
    ///        shaper does; `run` is then empty
    /// Cost   O(n)
    result<void> lay_out(const layout_options& options, glyph_run& run) noexcept
    {
        run.clear();
        error e = compose_lines(options);
        if (!e) e = lines_.write(*font_, run);
        if (!e) {
            note_unbroken(options, run);
            return {};
        }
        run.clear();
        lines_.forget();
        return e;
    }

    /// Lays the text out without writing it to a run. lines() and laid() then describe this layout.
    ///
    /// Errors and cost are as for lay_out().
    result<paragraph_size> measure(const layout_options& options) noexcept
    {
        if (error e = compose_lines(options)) {
            lines_.forget();
            return e;
        }
        return paragraph_size{.width = lines_.longest() / em(), .height = lines_.height() / em()};
    }

    /// The range in which a change of the width makes a difference. Indents and tab stops are ignored.
    [[nodiscard]] paragraph_widths widths() const noexcept
    {
        paragraph_widths found;
        double pen = 0.0;
        for (const break_piece& p : pieces_.words().pieces) {
            const bool last = p.ends_line();
            const double alone = (p.begin_change + p.width + p.end_change) / em();
            const double width = (pen + p.width + (last ? p.end_change : 0.0)) / em();
            if (p.width > 0.0 && alone > found.narrowest) found.narrowest = alone;
            if (p.width > 0.0 && width > found.widest) found.widest = width;
            pen = last ? 0.0 : pen + p.width + p.space;
        }
        if (found.narrowest > found.widest) found.narrowest = found.widest;  // only a hyphen is wider
        return found;
    }

    /// The lines of the last layout. There are none after set(), or if the layout failed.
    [[nodiscard]] std::span<const laid_line> lines() const noexcept { return lines_.lines(); }

    /// The last layout, for carets, selections and mouse pointers. It is valid until the next call of set(), lay_out()
    /// or measure().
    [[nodiscard]] laid_text laid() const noexcept
    {
        return {lines_.shaped, lines_.lines(), lines_.placed(), lines_.shaped.units_per_em()};
    }

    /// The text's Unicode properties and its items: for tests and for code that needs the details.
    [[nodiscard]] const shaped_text& shaped() const noexcept { return lines_.shaped; }

private:
    using list = text_pieces::list;

    [[nodiscard]] double em() const noexcept
    {
        const double units = lines_.shaped.units_per_em();
        return units > 0.0 ? units : 1.0;
    }

    void clear() noexcept
    {
        lines_.clear();
        pieces_.clear();
        own_clusters_ = own_glyphs_ = 0;
    }

    /// Finds all lines and the positions in each line.
    error compose_lines(const layout_options& options) noexcept
    {
        lines_.forget();
        if (error e = refused_option(options)) return e;
        lines_.begin(options);
        lines_.shaped.truncate(own_clusters_, own_glyphs_);
        justifier_.clear();
        const auto pieces = break_lines(options);
        own_clusters_ = lines_.shaped.all_clusters();
        own_glyphs_ = lines_.shaped.all_glyphs();
        if (!pieces) return pieces.error();
        for (std::size_t k = 0; k < ends_.size(); ++k)
            if (error e = compose_line(line_of(**pieces, k), options)) return e;
        lines_.stack(*font_, options);
        return {};
    }

    [[nodiscard]] line_source<Font> source(const layout_options& options) noexcept
    {
        return {lines_.shaped, pieces_, *font_, lines_.room(), options};
    }

    /// Finds the ends of lines, and all pieces that they need. Text shaped for them is kept for later layouts.
    result<const list*> break_lines(const layout_options& options) noexcept
    {
        const double narrowest =
            options.indent > 0.0 ? lines_.room().width - lines_.room().indent : lines_.room().width;
        const auto pieces = pieces_.pieces_for(options.wrap, widened(narrowest), lines_.shaped, *font_);
        if (!pieces) return pieces;
        const list& all = **pieces;
        line_room breaking = lines_.room();
        breaking.width = widened(lines_.room().width);
        if (options.wrap == wrap_mode::none) breaking.width = layout_options{}.width;
        ends_.clear();
        if (error e = breaker_.break_lines(all.pieces.view(), breaking, ends_)) return e;
        for (std::size_t k = 0; k < ends_.size() && !options.ellipsis.empty(); ++k) {
            const broken_line line = line_of(all, k);
            if (!elision::is_needed(line, lines_.room(), options)) continue;
            const auto made = elision::graphemes_of(source(options), line);
            if (!made) return made;
        }
        return pieces;
    }

    [[nodiscard]] broken_line line_of(const list& all, std::size_t number) const noexcept
    {
        const std::size_t first = number == 0 ? 0 : ends_[number - 1], last = ends_[number];
        const bool begins = first == 0 || all.pieces[first - 1].end == piece_end::paragraph;
        bool drops = false;  // empty lines do not count
        for (std::size_t k = last; number + 1 == ends_.size() && k < all.pieces.size() && !drops; ++k)
            drops = all.pieces[k].is_visible();
        return {all, first, last, lines_.room().start(begins), drops};
    }

    error compose_line(const broken_line& line, const layout_options& options) noexcept
    {
        const break_piece &first = line.all.pieces[line.first], &last = line.all.pieces[line.last - 1];
        const std::uint8_t level = lines_.level_at(first.first);
        const bool elided = elision::is_needed(line, lines_.room(), options);
        const auto natural = elided ? elision_.compose(source(options), line, level, lines_.slices) : fill(line, level);
        if (!natural) return natural.error();
        double width = *natural;
        const double spare = lines_.room().width - line.pen - width;
        const bool whole = elided || last.ends_line() || line.last == line.all.pieces.size();
        if (options.align == alignment::justify && spare > 0.0 && !whole && is_finite(spare)) {
            const auto grown = justifier_.widen(lines_.slices, lines_.shaped, *font_, options.justify, spare);
            if (!grown) return grown.error();
            width += *grown;
        }
        if (spare < 0.0 && !elided)
            width -= line_justifier::narrow(lines_.slices, lines_.shaped, 0.0 - spare, lines_.room().shrink);
        return lines_.add({first.first, last.last}, level, line.pen, width, options.align);
    }

    /// Makes a line that shows all its pieces. Returns its width.
    result<double> fill(const broken_line& line, std::uint8_t level) noexcept
    {
        lines_.slices.clear();
        if (error e = append_pieces(lines_.slices, pieces_, {line.all, line.first, line.last}, lines_.shaped, *font_))
            return e;
        return lines_.slices.finish(lines_.shaped, level, line.pen, lines_.room());
    }

    /// Reports words that need a dictionary, if lines may end between words.
    void note_unbroken(const layout_options& options, glyph_run& run) const noexcept
    {
        const auto& unbroken = lines_.shaped.analysis.unbroken;
        const bool words = options.wrap == wrap_mode::word || options.wrap == wrap_mode::word_or_grapheme;
        if (!words || !is_finite(options.width) || unbroken.empty()) return;
        run.unbroken = static_cast<std::uint32_t>(unbroken.size());
        run.first_unbroken = unbroken[0].first;
    }

    Font* font_;
    Analyser analyser_;
    Breaker breaker_;
    text_lines lines_;
    text_pieces pieces_;
    elision elision_;
    line_justifier justifier_;
    buffer<std::uint32_t> ends_;                     // the ends of the lines, as indices in the list of pieces
    std::size_t own_clusters_ = 0, own_glyphs_ = 0;  // the numbers of the text's own: later ones belong to one layout
};

template <class Font>
paragraph(Font&) -> paragraph<Font>;
template <class Font>
paragraph(Font&, memory) -> paragraph<Font>;
template <class Font>
paragraph(result<Font>&, memory = heap()) -> paragraph<Font>;

}  // namespace typemesh::inline TYPEMESH_ABI

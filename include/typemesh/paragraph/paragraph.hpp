// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/column_progress.hpp>
#include <typemesh/paragraph/first_fit.hpp>
#include <typemesh/paragraph/impl/bar_writer.hpp>
#include <typemesh/paragraph/impl/elision.hpp>
#include <typemesh/paragraph/impl/line_extent.hpp>
#include <typemesh/paragraph/impl/line_justifier.hpp>
#include <typemesh/paragraph/impl/line_slices.hpp>
#include <typemesh/paragraph/impl/line_writer.hpp>
#include <typemesh/paragraph/impl/stack_lines.hpp>
#include <typemesh/paragraph/impl/text_pieces.hpp>
#include <typemesh/paragraph/impl/whole_syllables.hpp>
#include <typemesh/paragraph/laid_line.hpp>
#include <typemesh/paragraph/laid_text.hpp>
#include <typemesh/paragraph/paragraph_options.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The range of widths within which changing the width changes the line breaks, in em.
struct paragraph_widths {
    double narrowest = 0.0;  ///< of the longest word: with less room it is broken, or sticks out
    double widest = 0.0;     ///< of the longest line, if lines end only at the text's line breaks
};

/// The size of a text in a layout, in em.
struct paragraph_size {
    double width = 0.0;   ///< of the longest line with its indent; with more width, only the alignment changes
    double height = 0.0;  ///< from the first line's ascender to the last line's descender
};

/// A text that is shaped once and then laid out at any width, as often as needed, with mixed directions.
///
///     paragraph words{font};
///     if (auto set = words.set(text); !set) puts(set.error().message());
///     auto laid = words.lay_out({.width = 20.0, .align = line_alignment::justify}, run);
///     auto plan = mesher.plan(run);
///
/// The text, and everything that the options refer to, must stay unchanged until the next set(). If glyphs change at a
/// line's end, they are shaped again, with the text around them. Memory is kept: after warm-up nothing is allocated
/// here. Only one thread at a time may use a paragraph. Once moved from, it has no text until its next set().
template <item_shaper Font, text_analyser Analyser = unicode_analyser, line_breaker Breaker = first_fit>
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
          shaped_{source},
          pieces_{source},
          slices_{source},
          elision_{source},
          justifier_{source},
          ends_{source},
          lines_{source},
          placed_{source}
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
    /// direction from its first letter. letter_spacing is in em, as in layout_options.
    ///
    /// Fails  error::bad_option: letter_spacing is NaN or infinite; error::too_large; error::out_of_memory; and as the
    ///        analyser and the shaper do. A layout then has no lines.
    /// Cost   O(n), plus the shaper's cost; unsafe places where a line may end are shaped twice more
    result<void> set(text_view text, const shape_options& how = {}, double letter_spacing = 0.0) noexcept
    {
        return set(text, how, std::span<const style_span>{}, letter_spacing);
    }

    template <dying_text Text>
    result<void> set(Text&&, const shape_options& = {}, double = 0.0) = delete;  // a paragraph refers to its text

    /// The same with styles for parts of the text. `how` and letter_spacing apply to the whole text. Everything that
    /// the spans refer to must stay unchanged until the next set(). shaped().styles.moved() is the number of their ends
    /// that were moved.
    ///
    ///     words.set("E = mc2", {}, spans);      // const style_span spans[] = {{6, 7, {.rise = 0.3}}};
    ///
    /// Fails  also as style_spans::read() does
    result<void> set(text_view text, const shape_options& how, std::span<const style_span> spans,
                     double letter_spacing = 0.0) noexcept
    {
        forget_lines();
        const error e = set_text(text, how, spans, letter_spacing);
        if (e) clear();
        return e;
    }

    template <dying_text Text>
    result<void> set(Text&&, const shape_options&, std::span<const style_span>, double = 0.0) = delete;

    /// Lays the text out. `run` is emptied and gets the glyphs and lines, as in layout().
    ///
    /// Fails  error::bad_option: see refused_option(); error::out_of_memory; and, if glyphs are shaped again, as the
    ///        shaper does; `run` is then empty
    /// Cost   O(n)
    result<void> lay_out(const paragraph_options& options, glyph_run& run) noexcept
    {
        run.clear();
        error e = compose_lines(options);
        if (!e) e = write_lines(run);
        if (!e) {
            note_unbroken(options, run);
            return {};
        }
        run.clear();
        forget_lines();
        return e;
    }

    /// Lays the text out without writing it to a run. lines() and laid() then describe this layout.
    ///
    /// It fails and costs as lay_out() does.
    result<paragraph_size> measure(const paragraph_options& options) noexcept
    {
        if (error e = compose_lines(options)) {
            forget_lines();
            return e;
        }
        const double em = units_per_em_ > 0.0 ? units_per_em_ : 1.0;
        return paragraph_size{.width = longest_ / em, .height = height_ / em};
    }

    /// The range in which a change of the width makes a difference. Indents and tab stops are ignored.
    [[nodiscard]] paragraph_widths widths() const noexcept
    {
        const double em = units_per_em_ > 0.0 ? units_per_em_ : 1.0;
        paragraph_widths found;
        double pen = 0.0;
        for (const break_piece& p : pieces_.words().pieces) {
            const bool last = p.ends_line();
            const double alone = (p.begin_change + p.width + p.end_change) / em;
            const double width = (pen + p.width + (last ? p.end_change : 0.0)) / em;
            if (p.width > 0.0 && alone > found.narrowest) found.narrowest = alone;
            if (p.width > 0.0 && width > found.widest) found.widest = width;
            pen = last ? 0.0 : pen + p.width + p.space;
        }
        if (found.narrowest > found.widest) found.narrowest = found.widest;  // only a hyphen is wider
        return found;
    }

    /// The lines of the last layout. There are none after set(), or if the layout failed.
    [[nodiscard]] std::span<const laid_line> lines() const noexcept { return lines_.view(); }

    /// The last layout, for carets, selections and mice. It lives until the next call of set(), lay_out()
    /// or measure().
    [[nodiscard]] laid_text laid() const noexcept { return {shaped_, lines_.view(), placed_.view(), units_per_em_}; }

    /// The text's Unicode properties and its items: for tests and for code that needs the details.
    [[nodiscard]] const shaped_text& shaped() const noexcept { return shaped_; }

private:
    using list = text_pieces::list;

    void clear() noexcept
    {
        shaped_.clear();
        pieces_.clear();
        forget_lines();
        own_clusters_ = own_glyphs_ = 0;
    }

    error set_text(text_view text, const shape_options& how, std::span<const style_span> spans,
                   double letter_spacing) noexcept
    {
        if (!is_finite(letter_spacing)) return error::bad("letter_spacing");
        if (const std::uint64_t length = text.size(); length >= 0xFFFF'FFFFu) return error::too_large;
        if (error e = analyser_.analyse(text, analysis_of(how), shaped_.analysis)) return e;
        keep_syllables_whole(text, shaped_.analysis);
        units_per_em_ = font_->units_per_em();
        stack_ = how.direction != direction::top_to_bottom ? line_stack::downwards
                 : columns_go_right(text, how)             ? line_stack::rightwards
                                                           : line_stack::leftwards;
        if (error e = shaped_.styles.read(spans, shaped_.analysis, face_count())) return e;
        if (error e = shaped_.shape(*font_, text, how, letter_spacing * units_per_em_)) return e;
        if (error e = pieces_.find_words(shaped_, *font_)) return e;
        if (error e = measure_tabs()) return e;
        own_clusters_ = shaped_.all_clusters();
        own_glyphs_ = shaped_.all_glyphs();
        return {};
    }

    /// Measures a space, which is the unit of tab stops, and a digit. A text without tabs needs neither.
    error measure_tabs() noexcept
    {
        space_ = digit_ = 0.0;
        bool tabs = false;
        for (const break_piece& p : pieces_.words().pieces) tabs = tabs || p.tab;
        if (!tabs) return {};
        const auto space = shaped_.advance_of(*font_, ' '), digit = shaped_.advance_of(*font_, '0');
        if (!space || !digit) return space ? digit.error() : space.error();
        space_ = *space;
        digit_ = *digit;
        return {};
    }

    [[nodiscard]] std::uint32_t face_count() noexcept
    {
        if constexpr (requires {
                          { font_->face_count() } -> std::convertible_to<std::uint32_t>;
                      })
            return font_->face_count();
        else
            return 1;
    }

    void forget_lines() noexcept
    {
        lines_.clear();
        placed_.clear();
    }

    /// Finds all lines and the positions in each line.
    error compose_lines(const paragraph_options& options) noexcept
    {
        forget_lines();
        if (error e = refused_option(options)) return e;
        const double em = units_per_em_;
        room_ = {.width = options.width * em,
                 .indent = options.indent * em,
                 .shrink = options.align == line_alignment::justify ? 0.25 : 0.0,
                 .tab = options.tab_width * space_,
                 .least_tab = least_tab(digit_),
                 .stops = options.tab_stops,
                 .stop_unit = em,
                 .max_lines = options.max_lines};
        shaped_.truncate(own_clusters_, own_glyphs_);
        justifier_.clear();
        const auto pieces = break_lines(options);
        own_clusters_ = shaped_.all_clusters();
        own_glyphs_ = shaped_.all_glyphs();
        if (!pieces) return pieces.error();

        const line_metrics metrics = line_reach_of(*font_, shaped_.options().direction);
        longest_ = 0.0;
        for (std::size_t k = 0; k < ends_.size(); ++k) {
            if (error e = compose_line(line_of(**pieces, k), options)) return e;
            laid_line& line = lines_.back();
            line.metrics = metrics;
            if (options.boxes == line_box::content)
                line.metrics = extent_of(*font_, shaped_, placed_.view().subspan(line.first_slice), metrics);
        }
        height_ = stack_lines(lines_.view(), em, options, stack_);
        return {};
    }

    [[nodiscard]] line_source<Font> source(const paragraph_options& options) noexcept
    {
        return {shaped_, pieces_, *font_, room_, options};
    }

    /// Finds the ends of lines, and all pieces that they need. Text shaped for them is kept for later layouts.
    result<const list*> break_lines(const paragraph_options& options) noexcept
    {
        const double narrowest = options.indent > 0.0 ? room_.width - room_.indent : room_.width;
        const auto pieces = pieces_.pieces_for(options.wrap, widened(narrowest), shaped_, *font_);
        if (!pieces) return pieces;
        const list& all = **pieces;
        line_room breaking = room_;
        breaking.width = widened(room_.width);
        if (options.wrap == wrap_mode::none) breaking.width = paragraph_options{}.width;
        ends_.clear();
        if (error e = breaker_.break_lines(all.pieces.view(), breaking, ends_)) return e;
        for (std::size_t k = 0; k < ends_.size() && !options.ellipsis.empty(); ++k) {
            const broken_line line = line_of(all, k);
            if (!elision::is_needed(line, room_, options)) continue;
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
        return {all, first, last, room_.start(begins), drops};
    }

    /// The level of the paragraph that contains a unit of the text.
    [[nodiscard]] std::uint8_t level_at(std::uint32_t unit) const noexcept
    {
        if (shaped_.analysis.paragraphs.empty()) return 0;
        return shaped_.analysis.paragraph_of(unit).level;
    }

    error compose_line(const broken_line& line, const paragraph_options& options) noexcept
    {
        const break_piece &first = line.all.pieces[line.first], &last = line.all.pieces[line.last - 1];
        const std::uint8_t level = level_at(first.first);
        const bool elided = elision::is_needed(line, room_, options);
        const auto natural = elided ? elision_.compose(source(options), line, level, slices_) : fill(line, level);
        if (!natural) return natural.error();
        double width = *natural;
        const double spare = room_.width - line.pen - width;
        const bool whole = elided || last.ends_line() || line.last == line.all.pieces.size();
        if (options.align == line_alignment::justify && spare > 0.0 && !whole && is_finite(spare)) {
            const auto grown = justifier_.widen(slices_, shaped_, *font_, options.justify, spare);
            if (!grown) return grown.error();
            width += *grown;
        }
        if (spare < 0.0 && !elided) width -= line_justifier::narrow(slices_, shaped_, 0.0 - spare, room_.shrink);
        if (line.pen + width > longest_) longest_ = line.pen + width;

        const laid_line laid{.first = first.first,
                             .last = last.last,
                             .first_slice = static_cast<std::uint32_t>(placed_.size()),
                             .slices = static_cast<std::uint32_t>(slices_.slices().size()),
                             .level = level,
                             .left = start_of(options.align, level % 2 != 0, line.pen, width),
                             .width = width > 0.0 ? width : 0.0};
        double at = laid.left;
        if (level % 2 != 0)
            for (const line_slice& s : slices_.slices().subspan(slices_.visible())) at -= s.width;
        slices_.find_glyphs(shaped_);
        order_visually(slices_.slices());
        for (line_slice& s : slices_.slices()) {
            s.at = at;
            at += s.width;
        }
        return lines_.push_back(laid) && placed_.append(slices_.slices()) ? error{} : error::out_of_memory;
    }

    /// Makes a line that shows all its pieces. Returns its width.
    result<double> fill(const broken_line& line, std::uint8_t level) noexcept
    {
        slices_.clear();
        if (error e = slices_.add(pieces_, line.all, line.first, line.last, shaped_, *font_)) return e;
        return slices_.finish(shaped_, level, line.pen, room_);
    }

    /// The start of a line, from its width. The line's pen starts at `pen`.
    [[nodiscard]] double start_of(line_alignment align, bool back, double pen, double width) const noexcept
    {
        if (align == line_alignment::start || align == line_alignment::justify)
            align = back ? line_alignment::right : line_alignment::left;
        if (align == line_alignment::end) align = back ? line_alignment::left : line_alignment::right;
        const double indent = back ? 0.0 : pen;
        if (align == line_alignment::left) return indent;
        const bool boxed = is_finite(room_.width);
        const double spare = boxed ? room_.width - pen - width : 0.0 - width - (back ? pen : 0.0);
        if (align == line_alignment::right) return (boxed ? indent : 0.0) + spare;
        return boxed ? indent + spare / 2 : 0.0 - width / 2;
    }

    /// Writes the glyphs of all composed lines.
    error write_lines(glyph_run& run) noexcept
    {
        run.units_per_em = units_per_em_;
        if (shaped_.analysis.invalid_units != 0)
            run.note_invalid_units(shaped_.analysis.first_invalid_unit, shaped_.analysis.invalid_units);
        line_writer writer{shaped_, run};
        bar_writer<Font> bars{*font_, shaped_, run};
        for (const laid_line& line : lines_) {
            const auto first = static_cast<std::uint32_t>(run.glyphs.size());
            const std::span<const line_slice> slices = placed_.view().subspan(line.first_slice, line.slices);
            for (const line_slice& s : slices)
                if (error e = writer.write(s, line.origin, s.at)) return e;
            if (error e = bars.write(line, slices)) return e;
            if (run.glyphs.size() > 0xFFFF'FFFFu) return error::too_large;
            const point along = shaped_.in_columns() ? point{0.0, 0.0 - line.left} : point{line.left, 0.0};
            const auto count = static_cast<std::uint32_t>(run.glyphs.size()) - first;
            if (!run.lines.push_back({first, count, line.origin + along, line.width})) return error::out_of_memory;
        }
        return {};
    }

    /// Reports words that need a dictionary, if lines may end between words.
    void note_unbroken(const paragraph_options& options, glyph_run& run) const noexcept
    {
        const auto& unbroken = shaped_.analysis.unbroken;
        const bool words = options.wrap == wrap_mode::word || options.wrap == wrap_mode::word_or_grapheme;
        if (!words || !is_finite(options.width) || unbroken.empty()) return;
        run.unbroken = static_cast<std::uint32_t>(unbroken.size());
        run.first_unbroken = unbroken[0].first;
    }

    Font* font_;
    Analyser analyser_;
    Breaker breaker_;
    shaped_text shaped_;
    text_pieces pieces_;
    line_slices slices_;
    elision elision_;
    line_justifier justifier_;
    buffer<std::uint32_t> ends_;  // of the lines, as indices in the list of pieces
    buffer<laid_line> lines_;
    buffer<line_slice> placed_;  // of all lines, from left to right
    line_room room_;
    double units_per_em_ = 0.0;
    double space_ = 0.0, digit_ = 0.0;               // their advances
    std::size_t own_clusters_ = 0, own_glyphs_ = 0;  // of the text: later ones belong to one layout
    double longest_ = 0.0, height_ = 0.0;            // of the last layout
    line_stack stack_ = line_stack::downwards;
};

template <class Font>
paragraph(Font&) -> paragraph<Font>;
template <class Font>
paragraph(Font&, memory) -> paragraph<Font>;
template <class Font>
paragraph(result<Font>&, memory = heap()) -> paragraph<Font>;

}  // namespace typemesh::inline TYPEMESH_ABI

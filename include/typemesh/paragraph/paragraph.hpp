// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/paragraph/first_fit.hpp>
#include <typemesh/paragraph/laid_line.hpp>
#include <typemesh/paragraph/laid_text.hpp>
#include <typemesh/paragraph/line_slices.hpp>
#include <typemesh/paragraph/line_stack.hpp>
#include <typemesh/paragraph/line_writer.hpp>
#include <typemesh/paragraph/paragraph_options.hpp>
#include <typemesh/paragraph/text_pieces.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The least and the greatest width that make a difference, in em.
struct paragraph_widths {
    double narrowest = 0.0;  ///< of the longest word: in less it is broken, or sticks out
    double widest = 0.0;     ///< of the longest line, if lines end only where the text demands it
};

/// A text that is shaped once and then laid out at any width, as often as wanted: directions mixed, lines broken.
///
///     paragraph words{font};
///     if (error e = words.set(text)) ...
///     if (error e = words.lay_out({.width = 20.0, .align = line_alignment::justify}, run)) ...
///     auto plan = mesher.plan(run);
///
/// The text, and what the options refer to, must stay as they are until the next set(): where a line's end changes
/// glyphs they are shaped again, with what stands round them. Memory is kept: after warm-up nothing is allocated here.
/// Used by one thread at a time.
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
          ends_{source},
          lines_{source},
          placed_{source}
    {
    }
    explicit paragraph(const Font&&, memory = heap()) = delete;  // it refers to its font

    /// The policies, to change their options between texts.
    [[nodiscard]] Analyser& analyser() noexcept { return analyser_; }
    [[nodiscard]] Breaker& breaker() noexcept { return breaker_; }

    /// Analyses and shapes a text; how.direction is that of the whole: automatic takes each paragraph's from its first
    /// letter. letter_spacing is in em, as in layout_options.
    ///
    /// Fails  error::bad_option: letter_spacing is NaN or infinite; error::too_large; error::out_of_memory; and as the
    ///        analyser and the shaper do. The text is then empty.
    /// Cost   O(n), but for the shaper's; places where a line may end and that are unsafe are shaped twice more
    error set(text_view text, const shape_options& how = {}, double letter_spacing = 0.0) noexcept
    {
        const error e = set_text(text, how, letter_spacing);
        if (e) (void)set_text({}, {}, 0.0);
        return e;
    }

    /// Lays the text out: `run` is emptied and gets its glyphs and lines, as layout() gives them.
    ///
    /// Fails  error::bad_option: see refused_option(); error::out_of_memory; and, where glyphs are shaped again, as the
    ///        shaper does; `run` is then empty
    /// Cost   O(n)
    error lay_out(const paragraph_options& options, glyph_run& run) noexcept
    {
        run.clear();
        const error e = place_lines(options, run);
        if (!e) return {};
        run.clear();
        lines_.clear();
        placed_.clear();
        return e;
    }

    /// Between which widths a width makes a difference. Indents and tab stops do not count.
    [[nodiscard]] paragraph_widths widths() const noexcept
    {
        const double em = units_per_em_ > 0.0 ? units_per_em_ : 1.0;
        paragraph_widths found{pieces_.widest() / em, 0.0};
        double pen = 0.0;
        for (const break_piece& p : pieces_.words().pieces) {
            const bool last = p.ends_line();
            const double width = (pen + p.width + (last ? p.end_change : 0.0)) / em;
            if (p.width > 0.0 && width > found.widest) found.widest = width;
            pen = last ? 0.0 : pen + p.width + p.space;
        }
        return found;
    }

    /// The lines of the last layout.
    [[nodiscard]] std::span<const laid_line> lines() const noexcept { return lines_.view(); }

    /// The last layout, for carets, selections and mice. It lives until the next call of set() or lay_out().
    [[nodiscard]] laid_text laid() const noexcept
    {
        return {shaped_, lines_.view(), placed_.view(), font_->metrics(shaped_.options().direction), units_per_em_};
    }

    /// What Unicode says of the text, and its items: for tests and for whoever looks closer.
    [[nodiscard]] const shaped_text& shaped() const noexcept { return shaped_; }

private:
    using list = text_pieces::list;

    /// A line and its pieces.
    struct line_range {
        std::size_t number, first, last;
    };

    error set_text(text_view text, const shape_options& how, double letter_spacing) noexcept
    {
        if (!is_finite(letter_spacing)) return error::bad("letter_spacing");
        if (static_cast<std::uint64_t>(text.size()) >= 0xFFFF'FFFFu) return error::too_large;
        analysis_options reading{.language = how.language};
        if (how.direction == direction::left_to_right) reading.direction = paragraph_direction::left_to_right;
        if (how.direction == direction::right_to_left) reading.direction = paragraph_direction::right_to_left;
        if (error e = analyser_.analyse(text, reading, shaped_.analysis)) return e;
        units_per_em_ = font_->units_per_em();
        if (error e = shaped_.shape(*font_, text, how, letter_spacing * units_per_em_)) return e;
        if (error e = pieces_.find_words(shaped_, *font_)) return e;
        if (error e = measure_space()) return e;
        own_clusters_ = shaped_.all_clusters();
        own_glyphs_ = shaped_.all_glyphs();
        return {};
    }

    /// The advance of a space, which tab stops count in. A text without tabs does without.
    error measure_space() noexcept
    {
        space_ = 0.0;
        bool tabs = false;
        for (const break_piece& p : pieces_.words().pieces) tabs = tabs || p.tab;
        if (!tabs) return {};
        const std::size_t clusters = shaped_.all_clusters(), glyphs = shaped_.all_glyphs();
        if (error e = shaped_.append_foreign(*font_, 0, 0, text_view{" "}, text_view{" "})) return e;
        space_ = shaped_.cluster(clusters).advance;
        shaped_.truncate(clusters, glyphs);
        return {};
    }

    error place_lines(const paragraph_options& options, glyph_run& run) noexcept
    {
        if (error e = refused_option(options)) return e;
        const double em = units_per_em_;
        room_ = {.width = options.width * em,
                 .indent = options.indent * em,
                 .tab = options.tab_width * space_,
                 .stops = options.tab_stops,
                 .stop_unit = em,
                 .most_lines = options.most_lines};
        shaped_.truncate(own_clusters_, own_glyphs_);
        const double narrowest = options.indent > 0.0 ? room_.width - room_.indent : room_.width;
        const auto pieces = pieces_.pieces_for(options.wrap, narrowest, shaped_, *font_);
        if (!pieces) return pieces.error();
        const list& all = **pieces;
        line_room breaking = room_;
        if (options.wrap == wrap_mode::none) breaking.width = paragraph_options{}.width;
        ends_.clear();
        lines_.clear();
        placed_.clear();
        if (error e = breaker_.break_lines(all.pieces.view(), breaking, ends_)) return e;
        if (error e = find_elided(all, options)) return e;
        own_clusters_ = shaped_.all_clusters();
        own_glyphs_ = shaped_.all_glyphs();

        run.units_per_em = em;
        if (shaped_.analysis.invalid_units != 0)
            run.note_invalid_units(shaped_.analysis.first_invalid_unit, shaped_.analysis.invalid_units);
        const line_stack stack{font_->metrics(shaped_.options().direction), em, options, ends_.size(),
                               shaped_.upright()};
        paragraph_ = 0;
        std::size_t first = 0;
        for (std::size_t k = 0; k < ends_.size(); ++k) {
            if (error e = place_line(all, {k, first, ends_[k]}, options, stack, run)) return e;
            first = ends_[k];
        }
        return run.glyphs.size() > 0xFFFF'FFFFu ? error{error::too_large} : error{};
    }

    [[nodiscard]] bool begins_paragraph(const list& all, std::size_t piece) const noexcept
    {
        return piece == 0 || all.pieces[piece - 1].end == piece_end::paragraph;
    }

    /// Whether a line does not show all that it should: it is wider than there is room, or the last before some that
    /// are dropped.
    [[nodiscard]] bool is_elided(const list& all, const line_range& line,
                                 const paragraph_options& options) const noexcept
    {
        if (options.ellipsis.empty()) return false;
        if (line.number + 1 == ends_.size() && line.last < all.pieces.size()) return true;
        return width_of(all, line) > room_.width;
    }
    [[nodiscard]] double width_of(const list& all, const line_range& line) const noexcept
    {
        double pen = room_.start(begins_paragraph(all, line.first)) + all.pieces[line.first].begin_change, width = 0.0;
        for (std::size_t k = line.first; k < line.last; ++k) {
            const break_piece& p = all.pieces[k];
            if (p.width > 0.0) width = pen + p.width + (k + 1 == line.last ? p.end_change : 0.0);
            pen += p.width + p.space;
            if (p.tab) pen = room_.after_tab(pen);
        }
        return width;
    }

    /// The text that an elided line would show if it had room: to the end of what the text demands to be one line, or,
    /// where only its beginning counts, to where the room ends.
    [[nodiscard]] std::uint32_t end_of_elided(const list& all, std::size_t first, ellipsis_place place) const noexcept
    {
        double pen = 0.0;
        std::size_t k = first;
        for (; k + 1 < all.pieces.size() && !all.pieces[k].ends_line(); ++k) {
            pen += all.pieces[k].width + all.pieces[k].space;
            if (place == ellipsis_place::end && pen > room_.width) break;
        }
        return all.pieces[k].last;
    }

    /// Has the graphemes of all elided lines made, before anything is appended that belongs to one layout only.
    error find_elided(const list& all, const paragraph_options& options) noexcept
    {
        std::size_t first = 0;
        for (std::size_t k = 0; k < ends_.size() && !options.ellipsis.empty(); ++k) {
            if (is_elided(all, {k, first, ends_[k]}, options)) {
                const auto made = pieces_.graphemes_of(all.pieces[first].first,
                                                       end_of_elided(all, first, options.elide), shaped_, *font_);
                if (!made) return made.error();
            }
            first = ends_[k];
        }
        return {};
    }

    error add_elided(const list& all, const line_range& line, double pen, const paragraph_options& options,
                     std::uint8_t level) noexcept
    {
        const std::uint32_t first = all.pieces[line.first].first;
        const auto made = pieces_.graphemes_of(first, end_of_elided(all, line.first, options.elide), shaped_, *font_);
        if (!made) return made.error();
        const list& graphemes = **made;
        const auto dots = static_cast<std::uint32_t>(shaped_.all_clusters());
        const std::uint32_t item = shaped_.item_at(first);
        if (error e = shaped_.append_foreign(*font_, item, first, options.ellipsis, text_view{"..."})) return e;
        double room = room_.width - pen - shaped_.cluster(dots).advance;

        const std::span<const break_piece> p = graphemes.pieces.view();
        std::size_t head = 0, tail = p.size();
        if (options.elide == ellipsis_place::end) head = head_that_fits(p, room);
        if (options.elide == ellipsis_place::middle) head = head_that_fits(p, room / 2);
        for (std::size_t k = 0; k < head; ++k) room -= p[k].width + (k + 1 < head ? p[k].space : p[k].end_change);
        if (options.elide != ellipsis_place::end) tail = tail_that_fits(p, head, room);

        if (error e = slices_.add(pieces_, graphemes, 0, head, shaped_, *font_)) return e;
        slices_.trim(shaped_);
        if (error e = slices_.append(shaped_, dots, 1, level)) return e;
        return slices_.add(pieces_, graphemes, tail, p.size(), shaped_, *font_);
    }

    [[nodiscard]] static std::size_t head_that_fits(std::span<const break_piece> p, double room) noexcept
    {
        std::size_t best = 0;
        double pen = 0.0;
        for (std::size_t k = 0; k < p.size() && pen + p[k].width <= room; ++k) {
            if (pen + p[k].width + p[k].end_change <= room) best = k + 1;
            pen += p[k].width + p[k].space;
        }
        return best;
    }
    [[nodiscard]] static std::size_t tail_that_fits(std::span<const break_piece> p, std::size_t head,
                                                    double room) noexcept
    {
        std::size_t best = p.size();
        double width = 0.0;
        for (std::size_t k = p.size(); k > head; --k) {
            width += p[k - 1].width + (k < p.size() ? p[k - 1].space : p[k - 1].end_change);
            if (width > room) break;
            if (width + p[k - 1].begin_change <= room) best = k - 1;
        }
        return best;
    }

    error place_line(const list& all, const line_range& line, const paragraph_options& options, const line_stack& stack,
                     glyph_run& run) noexcept
    {
        const auto& paragraphs = shaped_.analysis.paragraphs;
        const break_piece& last_piece = all.pieces[line.last - 1];
        while (paragraph_ + 1 < paragraphs.size() && paragraphs[paragraph_].last <= all.pieces[line.first].first)
            ++paragraph_;
        const std::uint8_t level =
            paragraphs.empty() || shaped_.upright() ? std::uint8_t{0} : paragraphs[paragraph_].level;
        const double pen = room_.start(begins_paragraph(all, line.first));
        const bool elided = is_elided(all, line, options);
        slices_.clear();
        if (error e = elided ? add_elided(all, line, pen, options, level)
                             : slices_.add(pieces_, all, line.first, line.last, shaped_, *font_))
            return e;
        const auto natural = slices_.finish(shaped_, level, pen, room_);
        if (!natural) return natural.error();
        double width = *natural;
        const double spare = room_.width - pen - width;
        const bool whole = elided || last_piece.ends_line() || line.last == all.pieces.size();
        if (options.align == line_alignment::justify && !whole && spare > 0.0 && is_finite(spare))
            width += slices_.justify(shaped_, spare);
        if (!lines_.push_back({.first = all.pieces[line.first].first,
                               .last = last_piece.last,
                               .first_slice = static_cast<std::uint32_t>(placed_.size()),
                               .level = level,
                               .left = start_of(options.align, level % 2 != 0, pen, width),
                               .width = width > 0.0 ? width : 0.0}))
            return error::out_of_memory;
        return write_line(lines_.back(), stack, run);
    }

    /// Where a line begins whose pen starts at `pen`, from its width.
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

    error write_line(laid_line& line, const line_stack& stack, glyph_run& run) noexcept
    {
        const std::size_t number = lines_.size() - 1;
        line.origin = stack.at(number, 0.0);
        const auto first_glyph = static_cast<std::uint32_t>(run.glyphs.size());
        double at = line.left;
        if (line.level % 2 != 0)
            for (const line_slice& s : slices_.slices().subspan(slices_.visible())) at -= s.width;
        order_visually(slices_.slices());
        line_writer writer{shaped_, run};
        for (line_slice& s : slices_.slices()) {
            s.at = at;
            if (error e = writer.write(s, line.origin, at)) return e;
            at += s.width;
        }
        line.slices = static_cast<std::uint32_t>(slices_.slices().size());
        if (!placed_.append(slices_.slices())) return error::out_of_memory;
        const auto count = static_cast<std::uint32_t>(run.glyphs.size()) - first_glyph;
        const text_line made{first_glyph, count, stack.at(number, line.left), line.width};
        return run.lines.push_back(made) ? error{} : error::out_of_memory;
    }

    Font* font_;
    [[no_unique_address]] Analyser analyser_;
    [[no_unique_address]] Breaker breaker_;
    shaped_text shaped_;
    text_pieces pieces_;
    line_slices slices_;
    buffer<std::uint32_t> ends_;  // of the lines, in the list of pieces
    buffer<laid_line> lines_;
    buffer<line_slice> placed_;  // of all lines, from left to right
    line_room room_;
    double units_per_em_ = 0.0;
    double space_ = 0.0;                             // its advance
    std::size_t own_clusters_ = 0, own_glyphs_ = 0;  // of the text: what stands behind belongs to one layout
    std::size_t paragraph_ = 0;                      // of the present line
};

template <class Font>
paragraph(Font&) -> paragraph<Font>;
template <class Font>
paragraph(Font&, memory) -> paragraph<Font>;

}  // namespace typemesh::inline TYPEMESH_ABI

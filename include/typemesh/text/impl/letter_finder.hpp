// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/extrude/placed_bounds.hpp>
#include <typemesh/glyph/impl/solid_ref.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/text/box_on_stand.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/impl/word_boundaries.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Divides a text's graphemes into words: the segments of UAX #29, with two exceptions. Text of a script whose words
/// only a dictionary can find is one word up to the next space. Punctuation belongs to the word that it touches, if
/// that is wanted: to the one before it, or, after a space or an opening bracket, to the one after it.
class word_counter {
public:
    word_counter(text_view text, bool attach) noexcept : text_{text}, attach_{attach} {}

    /// Whether a word begins with this character, at `i`. Call it for each character in order.
    [[nodiscard]] bool operator()(const code_point& c, const character& of, word_class word) noexcept
    {
        std::size_t at = c.next;
        const auto next = [&]() noexcept {
            if (at >= text_.size()) return word_class::newline;
            const code_point after = decode(text_, at);
            at = after.next;
            return word_character_of(after.value).word;
        };
        const bool begins = begins_(word, next);
        const side now = side_of(of);
        const bool goes_on = before_ != side::space && now != side::space &&
                             ((before_ == side::dictionary && now == side::dictionary) ||
                              (attach_ && (before_ == side::opening || now == side::closing)));
        if (word == word_class::extend || word == word_class::format || word == word_class::zwj) return false;
        before_ = now;
        return begins && !goes_on;
    }

private:
    enum class side : std::uint8_t { space, plain, opening, closing, dictionary };

    [[nodiscard]] side side_of(const character& c) const noexcept
    {
        using enum line_class;
        constexpr bidi_classes spaces{bidi_class::ws, bidi_class::s, bidi_class::b};
        if (spaces.holds(c.bidi)) return side::space;
        const bool starts = before_ == side::space || before_ == side::opening;
        const auto in_any = [&c](auto... any) noexcept { return ((c.line == any) || ...); };
        if (in_any(op, op_wide, qu_pi, pr, bb)) return side::opening;
        if (in_any(cl, cp, ex, in, is, sy, ns, hy, hh, ba, b2, po, qu_pf)) return side::closing;
        if (in_any(qu)) return starts ? side::opening : side::closing;
        return in_any(sa, sa_mark) ? side::dictionary : side::plain;
    }

    text_view text_;
    bool attach_;
    word_boundaries begins_;
    side before_ = side::space;
};

/// Finds the letters of a planned text: text_letter.hpp says what a letter is.
///
///     read       text      -> graphemes, each with its word and paragraph
///     unite      glyphs    -> graphemes that are one letter: a tree of `same` for each letter
///     number     graphemes -> rows in reading order, words, lines, paragraphs
///     measure    glyphs    -> boxes, and the places about which letters turn
class letter_finder {
public:
    letter_finder(text_glyphs& all, const glyph_run& run, const letter_options& how) noexcept
        : all_{all}, found_{all.letters}, run_{run}, how_{how}
    {
    }

    /// Fails  error::bad_option "text": a glyph of the run has a cluster beyond the text; or "pivot";
    ///        error::too_large; error::out_of_memory
    /// Cost   O(n log n) for n units and glyphs
    error operator()(text_view text, solid_ref solid) noexcept
    {
        found_.found_for = ~std::uint64_t{0};
        if (how_.pivot > letter_pivot::line) return error::bad("pivot");
        if (text.size() > 0xFFFF'FFFEu) return error::too_large;
        size_ = static_cast<std::uint32_t>(text.size());
        error e = read(text);
        if (!e) e = unite();
        if (!e) e = number();
        if (!e) e = number_glyphs();
        if (e) return e;
        measure(solid);
        found_.found_for = all_.generation.number;
        return {};
    }

private:
    using grapheme = text_letters::grapheme;

    error read(text_view text) noexcept
    {
        found_.graphemes.clear();
        grapheme_boundaries begins;
        word_counter words{text, how_.attach_punctuation};
        std::uint32_t word = 0, paragraph = 0;
        bool new_word = false, new_paragraph = false;
        for (std::size_t i = 0; i < text.size();) {
            const code_point c = decode(text, i);
            const character of = character_of(c.value);
            const word_character letter = word_character_of(c.value);
            new_word = words(c, of, letter.word) || new_word;
            if (begins(of.grapheme)) {
                word += new_word ? 1 : 0;
                paragraph += new_paragraph ? 1 : 0;
                new_word = new_paragraph = false;
                const grapheme fresh{.first = static_cast<std::uint32_t>(i),
                                     .word = word,
                                     .paragraph = paragraph,
                                     .same = static_cast<std::uint32_t>(found_.graphemes.size())};
                if (!found_.graphemes.push_back(fresh)) return error::out_of_memory;
            }
            new_paragraph = new_paragraph || of.bidi == bidi_class::b;
            add_to(found_.graphemes.back(), c.value, of, letter.joining);
            i = c.next;
        }
        found_.grapheme_count = static_cast<std::uint32_t>(found_.graphemes.size());
        return {};
    }

    static void add_to(grapheme& g, char32_t c, const character& of, joining_type joins) noexcept
    {
        using enum grapheme_class;
        constexpr bidi_classes spaces{bidi_class::ws, bidi_class::s, bidi_class::b};
        constexpr class_set<grapheme_class> controls{cr, lf, control};
        g.blank = g.blank && (spaces.holds(of.bidi) || controls.holds(of.grapheme) || is_default_ignorable(c));
        if (joins == joining_type::transparent) return;
        if (!g.joins) g.joins_before = joins;
        g.joins_after = joins;
        g.joins = true;
    }

    /// The grapheme at a place of the text.
    [[nodiscard]] std::uint32_t grapheme_at(cluster_id place) const noexcept
    {
        const auto begins_behind = [&](std::size_t k) noexcept { return found_.graphemes[k].first > place; };
        return static_cast<std::uint32_t>(first_where(1, found_.graphemes.size(), begins_behind) - 1);
    }

    /// The first grapheme of a letter. Halves the way to it.
    [[nodiscard]] std::uint32_t first_of(std::uint32_t k) noexcept
    {
        buffer<grapheme>& g = found_.graphemes;
        while (g[k].same != k) k = g[k].same = g[g[k].same].same;
        return k;
    }

    /// Makes one letter of two, and notes why.
    void join(std::uint32_t a, std::uint32_t b, letter_bond why) noexcept
    {
        a = first_of(a);
        b = first_of(b);
        if (a == b) return;
        const std::uint32_t first = a < b ? a : b, other = a < b ? b : a;
        found_.graphemes[other].same = first;
        found_.graphemes[first].bonds = found_.graphemes[first].bonds | why;
    }

    /// Calls use(grapheme) for each glyph of the run that a drawn glyph stands for; bars have none.
    template <class Use>
    void each_member(const drawn_glyph& s, const Use& use) const noexcept
    {
        array_view<const std::uint32_t> members{&s.glyph, 1};
        if (s.merged != drawn_glyph::none) members = all_.merged.members_of(all_.merged.groups[s.merged]);
        for (const std::uint32_t m : members)
            if (run_.glyphs[m].cluster != no_cluster) use(grapheme_at(run_.glyphs[m].cluster));
    }

    error unite() noexcept
    {
        for (const placed_glyph& glyph : run_.glyphs) {
            if (glyph.cluster == no_cluster) continue;
            if (glyph.cluster >= size_) return error::bad("text");
            found_.graphemes[grapheme_at(glyph.cluster)].shown = true;
        }
        for (const drawn_glyph& s : all_.records) {
            std::uint32_t first = not_a_letter;
            each_member(s, [&](std::uint32_t k) noexcept {
                grapheme& g = found_.graphemes[k];
                if (g.drawn) g.bonds = g.bonds | letter_bond::several_glyphs;
                if (!g.drawn || s.line < g.line) g.line = s.line;  // rubies have the last lines
                g.drawn = true;
                if (first == not_a_letter) first = k;
                join(first, k, letter_bond::merged);
            });
        }
        each_box_on_stand(run_, all_.stands.view(), [this](const inline_box_place& b) noexcept {
            grapheme& g = found_.graphemes[grapheme_at(b.unit)];
            g.bonds =
                g.bonds | (g.drawn ? letter_bond::inline_box | letter_bond::several_glyphs : letter_bond::inline_box);
            g.line = b.line;
            g.drawn = true;
        });
        unite_ligatures();
        unite_joined();
        return {};
    }

    /// A cluster shows all graphemes up to the next one, except for invisible ones at its end.
    void unite_ligatures() noexcept
    {
        buffer<grapheme>& g = found_.graphemes;
        for (std::uint32_t k = 0; k < g.size();) {
            const std::uint32_t head = k++;
            std::uint32_t last = head;
            for (; k < g.size() && !g[k].shown && g[k].paragraph == g[head].paragraph; ++k)
                if (!g[k].blank) last = k;
            if (!g[head].drawn) continue;
            for (std::uint32_t i = head + 1; i <= last; ++i) {
                g[i].drawn = true;
                g[i].line = g[head].line;
                join(head, i, letter_bond::ligature);
            }
        }
    }

    /// Neighbours that are written together; see joining_type.
    void unite_joined() noexcept
    {
        buffer<grapheme>& g = found_.graphemes;
        for (std::uint32_t k = 1; k < g.size(); ++k) {
            const bool neighbours = g[k - 1].drawn && g[k].drawn && g[k - 1].line == g[k].line;
            if (!neighbours || !typemesh::join(g[k - 1].joins_after, g[k].joins_before)) continue;
            g[k - 1].bonds = g[k - 1].bonds | letter_bond::joined;
            g[k].bonds = g[k].bonds | letter_bond::joined;
            if (how_.keep_joins) join(k - 1, k, letter_bond::joined);
        }
    }

    error number() noexcept
    {
        buffer<grapheme>& g = found_.graphemes;
        found_.rows.clear();
        found_.words.clear();
        if (error e = clear_groups(found_.lines, run_.lines.empty() ? 1 : run_.lines.size())) return e;
        if (error e = clear_groups(found_.paragraphs, g.empty() ? 0 : g.back().paragraph + std::size_t{1})) return e;
        std::uint32_t word = not_a_letter;
        for (std::uint32_t k = 0; k < g.size(); ++k) {
            if (!g[k].drawn) continue;
            const std::uint32_t first = first_of(k);
            if (first == k) {
                g[k].letter = static_cast<std::uint32_t>(found_.rows.size());
                if (g[k].word != word && !found_.words.push_back(starting_at(g[k].letter))) return error::out_of_memory;
                word = g[k].word;
                if (error e = add_letter(k)) return e;
            }
            text_letter& row = found_.rows[g[first].letter];
            row.text.last = k + 1 < g.size() ? g[k + 1].first : size_;
            row.bonds = row.bonds | g[k].bonds;
            ++row.graphemes;
            row.grapheme_end = k + 1;
        }
        found_.letters = static_cast<std::uint32_t>(found_.rows.size());
        found_.whole = starting_at(0);
        found_.whole.count = found_.letters;
        return {};
    }

    [[nodiscard]] static letter_group starting_at(std::uint32_t letter) noexcept
    {
        letter_group group;
        group.first = letter;
        return group;
    }

    static error clear_groups(buffer<letter_group>& groups, std::size_t count) noexcept
    {
        groups.clear();
        for (std::size_t i = 0; i < count; ++i)
            if (!groups.push_back({})) return error::out_of_memory;
        return {};
    }

    /// Appends the letter that begins with grapheme k.
    error add_letter(std::uint32_t k) noexcept
    {
        const grapheme& g = found_.graphemes[k];
        text_letter row;
        row.text = {g.first, g.first};
        row.first_letter = g.letter;
        row.letters = 1;
        row.grapheme = k;
        row.word = static_cast<std::uint32_t>(found_.words.size() - 1);
        row.line = g.line;
        row.paragraph = g.paragraph;
        row.style = no_style;
        ++found_.words.back().count;
        for (letter_group* group : {&found_.lines[g.line], &found_.paragraphs[g.paragraph]})
            if (group->count++ == 0) group->first = g.letter;
        return found_.rows.push_back(row) ? error{} : error{error::out_of_memory};
    }

    /// Finds the letter of each drawn glyph, and appends a row for each bar.
    error number_glyphs() noexcept
    {
        found_.row_of.clear();
        for (const drawn_glyph& s : all_.records) {
            std::uint32_t head = not_a_letter;
            each_member(s, [&head](std::uint32_t k) noexcept { head = k < head ? k : head; });
            std::uint32_t number = static_cast<std::uint32_t>(found_.rows.size());
            if (head != not_a_letter) {
                number = found_.graphemes[first_of(head)].letter;
                text_letter& row = found_.rows[number];
                if (row.style == no_style || row.grapheme == head) row.style = s.style;
            } else {
                text_letter bar;
                bar.line = s.line;
                bar.style = s.style;
                bar.bonds = letter_bond::bar;
                if (!found_.rows.push_back(bar)) return error::out_of_memory;
            }
            if (!found_.row_of.push_back(number)) return error::out_of_memory;
        }
        return found_.moves.reserve(found_.rows.size()) ? error{} : error{error::out_of_memory};
    }

    void measure(solid_ref solid) noexcept
    {
        letter_box drawn;  // of all letters
        placement at;
        at.unit_per_depth = all_.placed.unit_per_depth;
        for (std::size_t i = 0; i < all_.records.size(); ++i) {
            const drawn_glyph& s = all_.records[i];
            text_letter& row = found_.rows[found_.row_of[i]];
            const height_range heights = solid.heights_of(*s.built);
            const float back = at.height(heights.low), front = at.height(heights.high);
            at.pen = s.built->cells() * (s.origin - all_.placed.centre);
            at.unit_per_cell = all_.placed.unit_per_font_unit * s.built->font_units_per_cell();
            at.frame = all_.placed.frame;
            turn(at, s.right);
            is_off_line_ = is_off_line_ || is_turned(s.right) || !(s.origin == s.flat) || all_.is_warped(s.glyph);
            const vec3 corner = at.position(at.foot(s.built->around().low), back);
            if (row.ink.empty()) row.bounds = {corner, corner};
            add_placed(row.bounds, s.built->around(), back, front, at, at.frame.is_along_axes());
            grow(row, {{}, {}, {}, text_glyphs::ink_of(s), back, front});
            if (!has(row.bonds, letter_bond::bar)) grow(drawn, row);
        }
        measure_boxes(drawn);
        for (std::size_t i = found_.letters; i < found_.rows.size(); ++i) cover(found_.rows[i]);
        for (std::uint32_t i = 0; i < found_.letters; ++i) {
            const text_letter& row = found_.rows[i];
            for (letter_group* group :
                 {&found_.words[row.word], &found_.lines[row.line], &found_.paragraphs[row.paragraph], &found_.whole})
                grow(*group, row);
        }
        for (text_letter& row : found_.rows) finish(row, row.line);
        for (letter_group& group : found_.words) finish_group(group);
        for (letter_group& group : found_.lines) finish_group(group);
        for (letter_group& group : found_.paragraphs) finish_group(group);
        finish_group(found_.whole);
    }

    /// Inline boxes are as deep as all letters.
    void measure_boxes(const letter_box& drawn) noexcept
    {
        const double em = run_.units_per_em > 0.0 ? run_.units_per_em : 1.0;
        placement at;
        at.frame = all_.placed.frame;
        at.unit_per_cell = all_.placed.unit_per_font_unit;
        at.pen = {0.0 - all_.placed.centre.x, 0.0 - all_.placed.centre.y};
        each_box_on_stand(run_, all_.stands.view(), [&](const inline_box_place& b) noexcept {
            text_letter& row = found_.rows[found_.row_at(b.unit)];
            if (row.style == no_style) row.style = run_.glyph_styles[run_.glyphs[b.glyph].glyph_style].style;
            is_off_line_ = is_off_line_ || !all_.stands.empty();
            for (const point corner : {point{0.0, 0.0}, point{1.0, 0.0}, point{0.0, 1.0}, point{1.0, 1.0}}) {
                const point p = em * b.map(corner);
                for (const float height : {drawn.back, drawn.front}) {
                    const vec3 place = at.position(at.foot(p), height);
                    if (row.ink.empty()) row.bounds = {place, place};
                    row.bounds.add(place);
                }
                grow(row, {{}, {}, {}, {p, p}, drawn.back, drawn.front});
            }
        });
    }

    static void grow(letter_box& all, const letter_box& by) noexcept
    {
        const bool first = all.ink.empty();
        all.back = first || by.back < all.back ? by.back : all.back;
        all.front = first || by.front > all.front ? by.front : all.front;
        all.ink.merge(by.ink);
    }

    /// Finds the letters that a bar goes with: the letters of its line that lie beside it.
    void cover(text_letter& bar) noexcept
    {
        const auto apart = [down = how_.down](const box& a, const box& b) noexcept {
            return down ? a.high.y <= b.low.y || b.high.y <= a.low.y : a.high.x <= b.low.x || b.high.x <= a.low.x;
        };
        const letter_group line = bar.line < found_.lines.size() ? found_.lines[bar.line] : letter_group{};
        for (const text_letter& l : found_.rows.view().subspan(line.first, line.count)) {
            if (l.line != bar.line || apart(l.ink, bar.ink)) continue;
            if (bar.letters == 0) {
                bar.grapheme = l.grapheme;
                bar.paragraph = l.paragraph;
                bar.text.first = l.text.first;
                bar.first_letter = l.first_letter;
                bar.word = l.word;
            }
            if (bar.word != l.word) bar.word = not_a_letter;
            bar.letters = l.first_letter + 1 - bar.first_letter;
            bar.text.last = l.text.last;
            bar.grapheme_end = l.grapheme_end;
            bar.graphemes = bar.grapheme_end - bar.grapheme;
        }
    }

    void finish_group(letter_group& group) const noexcept
    {
        if (group.count != 0) finish(group, found_.rows[group.first].line);
    }

    /// Finds pivot, centre and extent of a box in a line.
    void finish(letter_box& b, std::uint32_t line) const noexcept
    {
        const text_placement& placed = all_.placed;
        placement at;
        at.frame = placed.frame;
        at.unit_per_cell = placed.unit_per_font_unit;
        at.pen = {0.0 - placed.centre.x, 0.0 - placed.centre.y};
        const point middle = lerp(b.ink.low, b.ink.high, 0.5);
        b.centre = at.position(at.foot(middle), 0.5f * (b.back + b.front));
        b.extent = {static_cast<float>(b.ink.width() * placed.unit_per_font_unit),
                    static_cast<float>(b.ink.height() * placed.unit_per_font_unit), b.front - b.back};
        b.pivot = b.centre;
        if (all_.in_place || is_off_line_ || how_.pivot == letter_pivot::centre) return;
        point across = line < run_.lines.size() ? run_.lines[line].origin : point{};
        if (how_.pivot == letter_pivot::line && line < found_.lines.size() && !found_.lines[line].ink.empty())
            across = lerp(found_.lines[line].ink.low, found_.lines[line].ink.high, 0.5);
        const point place = how_.down ? point{across.x, middle.y} : point{middle.x, across.y};
        b.pivot = at.position(at.foot(place), b.front);
    }

    text_glyphs& all_;
    text_letters& found_;
    const glyph_run& run_;
    const letter_options& how_;
    std::uint32_t size_ = 0;
    bool is_off_line_ = false;  // whether a path moves letters, away from the origins of their lines
};

}  // namespace typemesh::inline TYPEMESH_ABI

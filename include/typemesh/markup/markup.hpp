// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/value_index.hpp>
#include <typemesh/layout/inline_box.hpp>
#include <typemesh/markup/impl/markup_reader.hpp>
#include <typemesh/markup/markup_look.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// Reads a text with tags: the text without them, and spans that say what the tags around each part of it are.
///
///     [b]bold [colour=#c33]and red[/colour][/b]
///
///     [b] [i] [u] [s] [o]            bold, italic, underline, strike-through, overline
///     [sup] [sub]                    superscript, subscript
///     [size=1.5]                     times the whole text's size; up to 1000
///     [rise=0.2] [spacing=0.05]      em: a higher baseline, more space between letters; -1000 to 1000
///     [depth=0.1] [bevel=0.02]       em: of the solid; 0 to 1000
///     [colour=#c33] [color=#cc3333]  a colour in three or six hexadecimal digits
///     [style=7]                      the caller's number
///     [font=Liberation Serif]        the caller's name of a font
///     [lang=ja]                      the language
///     [mark=#ff0]                    a background of this colour
///     [ruby=Tokyo]                   small text above this one; no ruby stands in another
///     [box=1.2,0.8]                  em: a box of this width and height for an icon, and with a third number of this
///     [box=1.2,0.8,0.2]              depth below the baseline; -1000 to 1000. It has no closing tag; text() has U+FFFC
///     [/b]                           closes the last [b] that is open, whatever is open within it
///     [/]                            closes the last tag that is open
///     [[                             a bracket. ] needs no such sign
///
/// Names are in lower case, without spaces. A number has at most six decimals and no exponent. A value that contains ]
/// or begins with a quotation mark stands between quotation marks of the other kind: [font="a]b"], [ruby='"']. The
/// innermost tag of a kind applies: [size=2][size=3] is three times as large. Tags may cross. Tags that are open at the
/// end of the text end with it. A tag around no text has no effect.
///
/// The source is UTF-8 or UTF-16, also malformed: units that belong to no tag are copied as they are. Offsets in errors
/// count units of the source; offsets in spans count units of text(). Values that are words are views of the source,
/// which must stay unchanged as long as they are used.
template <class Char>
class basic_markup {
public:
    using view = std::basic_string_view<Char>;  ///< a text
    using look_type = basic_markup_look<Char>;  ///< see looks()

    explicit basic_markup(memory source = heap()) noexcept
        : text_{source}, spans_{source}, looks_{source}, rubies_{source}, boxes_{source}, open_{source}, index_{source}
    {
    }

    /// Reads a source, in one pass. After a failure there is no text.
    ///
    /// Fails  error::bad_markup: cluster is the place of the mistake in the source, option says what it is;
    ///        error::too_large: the source has more than 2^32 - 2 units; error::out_of_memory
    /// Cost   O(source), without allocations after the first sources of this size
    result<void> read(view source) noexcept
    {
        clear();
        const error e = source.size() < no_cluster ? read_all(source) : error{error::too_large};
        if (e) clear();
        return e;
    }
    /// Views of a temporary text would outlive it.
    template <dying_text Text>
    void read(Text&& source) = delete;

    /// Removes the text.
    void clear() noexcept
    {
        text_.clear();
        spans_.clear();
        looks_.clear();
        rubies_.clear();
        boxes_.clear();
        open_.clear();
        index_.clear();
        now_ = {};
        for (std::uint32_t& number : last_) number = 0;
        number_ = last_number_ = crossed_ = 0;
        known_ = true;
    }

    /// The text without tags.
    [[nodiscard]] view text() const noexcept { return {text_.data(), text_.size()}; }
    /// In the order of the text; text outside all spans has no tags. Neighbours differ.
    [[nodiscard]] array_view<const markup_span> spans() const noexcept { return spans_.view(); }
    /// Each different look once, in the order in which the text needs them, after the plain look. Empty if there is no
    /// other than the plain look.
    [[nodiscard]] array_view<const look_type> looks() const noexcept { return looks_.view(); }
    /// The texts of [ruby=...], in the order of the text.
    [[nodiscard]] array_view<const view> rubies() const noexcept { return rubies_.view(); }

    /// The boxes of [box=...], in the order of the text, for shape_options::boxes.
    [[nodiscard]] array_view<const inline_box> boxes() const noexcept { return boxes_.view(); }

    /// Calls put(first, last, ruby, look) for each ruby: the range of its text, its own text, and the index of the look
    /// at its beginning.
    template <class Put>
    void each_ruby(const Put& put) const noexcept
    {
        for (std::size_t i = 0, k = 0; i < spans_.size(); i = k) {
            for (k = i + 1; k < spans_.size() && spans_[k].ruby == spans_[i].ruby;) ++k;
            if (spans_[i].ruby != 0)
                put(spans_[i].first, spans_[k - 1].last, rubies_[spans_[i].ruby - 1], spans_[i].look);
        }
    }

private:
    using tag_read = detail::read_markup_tag<Char>;

    /// A tag that is open, or that was closed within one that is open.
    struct opened {
        double value;
        view words;
        std::uint32_t integer;   // these three: see read_markup_tag
        std::uint32_t previous;  // one more than the index of the tag of this kind around it; 0: none
        std::uint32_t crossed;   // how many tags had crossed before
        std::uint32_t number;    // of the look around this tag, if `known`; of a ruby: its own, 0 until it has text
        markup_tag kind;
        bool is_open;
        bool known;
    };

    error read_all(view source) noexcept
    {
        if (!text_.reserve(source.size())) return error::out_of_memory;
        detail::markup_reader<Char> reader{source};
        for (std::size_t at = 0;;) {
            const std::size_t bracket = source.find(static_cast<Char>('['), at);
            if (bracket == view::npos) return put(source.substr(at)) ? error{} : error{error::out_of_memory};
            const bool doubled = bracket + 1 < source.size() && source[bracket + 1] == static_cast<Char>('[');
            if (!put(source.substr(at, bracket - at + (doubled ? 1 : 0)))) return error::out_of_memory;
            at = bracket + 2;
            if (doubled) continue;
            const tag_read& tag = reader.read(bracket);
            at = tag.end;
            if (tag.mistake != nullptr) return mistake(tag.mistake, tag.end);
            if (tag.closes) {
                if (!close(tag)) return mistake("a closing tag without its opening tag", bracket);
            } else if (tag.form->tag == markup_tag::box) {
                const auto unit = static_cast<std::uint32_t>(text_.size());
                const inline_box box{unit, tag.lengths[0], tag.lengths[1], tag.lengths[2]};
                if (!put(detail::object_character<Char>()) || !boxes_.push_back(box)) return error::out_of_memory;
            } else if (tag.form->tag == markup_tag::ruby && top_of(markup_tag::ruby) != 0) {
                return mistake("a ruby within a ruby", bracket);
            } else if (!open(tag)) {
                return error::out_of_memory;
            }
        }
    }

    static error mistake(const char* what, std::size_t place) noexcept
    {
        error e = error::bad_markup;
        e.option = what;
        return e.at(no_glyph, static_cast<cluster_id>(place));
    }

    /// Appends text that is as the open tags say. Returns false when out of memory.
    [[nodiscard]] bool put(view some) noexcept
    {
        if (some.empty()) return true;
        const auto first = static_cast<std::uint32_t>(text_.size());
        Char* const copy = text_.append(some.size());
        if (copy == nullptr || !find_number()) return false;
        std::memcpy(copy, some.data(), some.size() * sizeof(Char));
        std::uint32_t ruby = 0;
        if (!number_ruby(ruby)) return false;
        if (number_ == 0 && ruby == 0) return true;
        const auto last = static_cast<std::uint32_t>(text_.size());
        if (!spans_.empty()) {
            markup_span& s = spans_.back();
            if (s.last == first && s.look == number_ && s.ruby == ruby) {
                s.last = last;
                return true;
            }
        }
        return spans_.push_back({first, last, number_, ruby});
    }

    /// The number of the ruby that is open.
    [[nodiscard]] bool number_ruby(std::uint32_t& number) noexcept
    {
        const std::uint32_t top = top_of(markup_tag::ruby);
        if (top == 0) return true;
        opened& o = open_[top - 1];
        if (o.number == 0) {
            if (!rubies_.push_back(o.words)) return false;
            o.number = static_cast<std::uint32_t>(rubies_.size());
        }
        number = o.number;
        return true;
    }

    /// Makes number_ the number of the look.
    [[nodiscard]] bool find_number() noexcept
    {
        if (known_) return true;
        if (now_.tags == 0 && now_.position == script_position::normal) {  // it is listed only before others
            number_ = 0;
            known_ = true;
            return true;
        }
        std::size_t found = last_number_;  // often the same look again
        if (found >= looks_.size() || !(looks_[found] == now_)) {
            if (looks_.empty() && !looks_.push_back({})) return false;
            if (!index_.read(looks_.view())) return false;
            found = index_.find(looks_.view(), now_);
            if (found == looks_.size() && !looks_.push_back(now_)) return false;
        }
        number_ = last_number_ = static_cast<std::uint32_t>(found);
        known_ = true;
        return true;
    }

    [[nodiscard]] std::uint32_t& top_of(markup_tag t) noexcept { return last_[static_cast<std::size_t>(t)]; }

    [[nodiscard]] bool open(const tag_read& tag) noexcept
    {
        const markup_tag kind = tag.form->tag;
        std::uint32_t& top = top_of(kind);
        const bool is_ruby = kind == markup_tag::ruby;
        opened* const o = open_.append(1);
        if (o == nullptr) return false;
        *o = {tag.number, tag.words, tag.integer, top, crossed_, is_ruby ? 0 : number_, kind, true, known_};
        top = static_cast<std::uint32_t>(open_.size());
        if (!is_ruby) apply(kind, o);
        return true;
    }

    /// Returns false if no such tag is open.
    [[nodiscard]] bool close(const tag_read& tag) noexcept
    {
        const std::size_t closed = tag.form != nullptr ? top_of(tag.form->tag) : open_.size();
        if (closed == 0) return false;
        opened& o = open_[closed - 1];
        const markup_tag kind = o.kind;
        const std::uint32_t around = o.previous;
        top_of(kind) = around;
        o.is_open = false;
        if (kind != markup_tag::ruby) {
            apply(kind, around != 0 ? &open_[around - 1] : nullptr);
            if (closed != open_.size())
                ++crossed_;
            else if (o.crossed == crossed_) {  // else a tag around this one was closed within it
                number_ = o.number;
                known_ = o.known;
            }
        }
        while (!open_.empty() && !open_.back().is_open) open_.truncate(open_.size() - 1);
        return true;
    }

    /// The look changes: the tag of this kind that applies is another, or none.
    void apply(markup_tag kind, const opened* tag) noexcept
    {
        known_ = false;
        if (kind == markup_tag::superscript || kind == markup_tag::subscript) {
            const std::uint32_t above = top_of(markup_tag::superscript), below = top_of(markup_tag::subscript);
            now_.position = above > below   ? script_position::superscript
                            : below > above ? script_position::subscript
                                            : script_position::normal;
            return;
        }
        const std::uint32_t bit = 1u << static_cast<unsigned>(kind);
        now_.tags = tag != nullptr ? now_.tags | bit : now_.tags & ~bit;
        constexpr look_type plain{};
        switch (kind) {
        case markup_tag::size: now_.size = tag != nullptr ? tag->value : plain.size; break;
        case markup_tag::rise: now_.rise = tag != nullptr ? tag->value : plain.rise; break;
        case markup_tag::spacing: now_.spacing = tag != nullptr ? tag->value : plain.spacing; break;
        case markup_tag::depth: now_.depth = tag != nullptr ? tag->value : plain.depth; break;
        case markup_tag::bevel: now_.bevel = tag != nullptr ? tag->value : plain.bevel; break;
        case markup_tag::colour: now_.colour = tag != nullptr ? tag->integer : plain.colour; break;
        case markup_tag::style: now_.style = tag != nullptr ? tag->integer : plain.style; break;
        case markup_tag::mark: now_.mark = tag != nullptr ? tag->integer : plain.mark; break;
        case markup_tag::font: now_.font = tag != nullptr ? tag->words : plain.font; break;
        case markup_tag::language: now_.language = tag != nullptr ? tag->words : plain.language; break;
        case markup_tag::bold:
        case markup_tag::italic:
        case markup_tag::underline:
        case markup_tag::strike:
        case markup_tag::overline:
        case markup_tag::superscript:
        case markup_tag::subscript:
        case markup_tag::ruby:
        case markup_tag::box: break;
        }
    }

    buffer<Char> text_;
    buffer<markup_span> spans_;
    buffer<look_type> looks_;
    buffer<view> rubies_;
    buffer<inline_box> boxes_;
    buffer<opened> open_;
    value_index<look_type> index_;
    look_type now_;                              // the look of the next text
    std::uint32_t last_[markup_tag_count] = {};  // of each kind, one more than the index of the last open tag
    std::uint32_t number_ = 0;                   // of the look of the next text, if known_
    bool known_ = true;
    std::uint32_t last_number_ = 0;  // the last one that was looked for
    std::uint32_t crossed_ = 0;      // tags that were closed while a later one was open
};

using markup = basic_markup<char>;            ///< of UTF-8
using markup_utf16 = basic_markup<char16_t>;  ///< of UTF-16; lengths count 16-bit units

}  // namespace typemesh::inline TYPEMESH_ABI

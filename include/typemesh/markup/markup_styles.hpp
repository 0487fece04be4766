// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/text_highlight.hpp>
#include <typemesh/layout/text_style.hpp>
#include <typemesh/markup/markup.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// What mark-up says of the solids of letters and backgrounds.
struct markup_solid {
    std::uint32_t tags = 0;  ///< a set of markup_tag: bold, depth and bevel; or mark, alone, for all backgrounds
    double depth = 0.0;      ///< em, if there is a [depth=...]
    double bevel = 0.0;      ///< em, if there is a [bevel=...]

    [[nodiscard]] bool has(markup_tag t) const noexcept { return (tags >> static_cast<unsigned>(t) & 1u) != 0; }

    friend bool operator==(const markup_solid& a, const markup_solid& b) noexcept
    {
        return a.tags == b.tags && same(a.depth, b.depth) && same(a.bevel, b.bevel);
    }
    friend std::uint64_t hash_of(const markup_solid& s) noexcept
    {
        return hash_of(basic_markup_look<char>{.tags = s.tags, .depth = s.depth, .bevel = s.bevel});
    }
};

/// The colour of letters, the caller's number, and the index of their solid: all letters of one paint can be one part
/// of a mesh.
struct markup_paint {
    std::uint32_t tags = 0;    ///< a set of markup_tag: colour and style; or mark, alone, for a background
    std::uint32_t colour = 0;  ///< 0xRRGGBB, if there is a [colour=...]; of a background always
    std::uint32_t style = 0;   ///< the caller's number, if there is a [style=...]
    std::uint32_t solid = 0;   ///< the index of its solid

    [[nodiscard]] bool has(markup_tag t) const noexcept { return (tags >> static_cast<unsigned>(t) & 1u) != 0; }

    friend bool operator==(const markup_paint&, const markup_paint&) noexcept = default;
    friend std::uint64_t hash_of(const markup_paint& p) noexcept
    {
        return mixed_key(mixed_key(p.tags, p.solid), std::uint64_t{p.colour} << 32 | p.style);
    }
};

/// Chooses what mark-up cannot know: map(look, style) sets the face of `style`. The look has filled in the other
/// members. The map may change them, but not the number and the language. It returns an error, error::none on success.
template <class Map, class Char>
concept markup_map = requires(const Map& map, const basic_markup_look<Char>& look, text_style& style) {
    { map(look, style) } noexcept -> std::same_as<error>;
};

/// The markup_map for a single font: [b] does not change the letters, and [font=...] is refused.
struct one_font_map {
    template <class Char>
    error operator()(const basic_markup_look<Char>& look, text_style&) const noexcept
    {
        return look.has(markup_tag::font) ? error{error::no_such_face} : error{};
    }
};

/// The styles of a text with mark-up, for shape_options::styles, and their paints:
///
///     markup read;                                              markup_styles styles;
///     read.read("[colour=#c33]red[/] and [depth=0.5]deep");     styles.set(read);
///
///     styles.spans()   0..3 {.style = style_id{1}}      8..12 {.style = style_id{2}}
///     styles.paints()  {}   {.colour = 0xcc3333}              {.solid = 1}
///     styles.solids()  {}   {.depth = 0.5}
///
/// A style's number is the index of its paint, also in the mesh: plan->range(style_id{1}, part::front). Text without
/// tags has paint 0 and solid 0, which say nothing.
///
///     [i]              slant 0.2                      [size] [rise] [sup] [sub]   the members of text_style
///     [u] [s] [o]      decorations                    [spacing]                   letter_spacing
///     [lang]           language                       [font] [b]                  by the caller's map
///     [colour] [style] the paint                      [depth] [bevel] [b]         the paint's solid
///     [mark]           marks(), with paints of their own and one solid for all backgrounds
///
/// A mesher makes one solid. To make several, see select_glyphs.hpp.
class markup_styles {
public:
    explicit markup_styles(memory source = heap()) noexcept
        : spans_{source},
          marks_{source},
          of_looks_{source},
          paints_{source},
          solids_{source},
          languages_{source},
          paint_index_{source},
          solid_index_{source}
    {
    }

    /// Reads the spans of a text, which must stay unchanged only during the call.
    ///
    /// Fails  as `map` does, at the first text of that look (one_font_map: error::no_such_face); error::out_of_memory.
    ///        There are then no spans.
    /// Cost   O(spans + looks), without allocations after the first texts of this size
    template <class Char, markup_map<Char> Map = one_font_map>
    result<void> set(const basic_markup<Char>& read, const Map& map = {}) noexcept
    {
        clear();
        const error e = take(read, map);
        if (e) clear();
        return e;
    }

    void clear() noexcept
    {
        spans_.clear();
        marks_.clear();
        of_looks_.clear();
        paints_.clear();
        solids_.clear();
        languages_.clear();
        paint_index_.clear();
        solid_index_.clear();
    }

    /// The styles, which refer to this object.
    [[nodiscard]] array_view<const style_span> spans() const noexcept { return spans_.view(); }
    /// The backgrounds, for highlight_writer. Text with one colour behind it is one range, whatever else its tags say.
    [[nodiscard]] array_view<const text_highlight> marks() const noexcept { return marks_.view(); }
    /// Each different paint once; paint 0 says nothing. Empty before set().
    [[nodiscard]] array_view<const markup_paint> paints() const noexcept { return paints_.view(); }
    /// Each different solid once; solid 0 says nothing. Empty before set().
    [[nodiscard]] array_view<const markup_solid> solids() const noexcept { return solids_.view(); }
    /// The style's number of a look of the mark-up. Precondition: set() has read this look.
    [[nodiscard]] style_id style_of(std::uint32_t look) const noexcept
    {
        return look == 0 ? style_id{} : of_looks_[look].style;
    }
    /// The index of the solid of a style; 0 for numbers that are none of its styles.
    [[nodiscard]] std::uint32_t solid_of(style_id style) const noexcept
    {
        const auto number = static_cast<std::size_t>(style);
        return number < paints_.size() ? paints_[number].solid : 0;
    }

private:
    template <class Char, class Map>
    error take(const basic_markup<Char>& read, const Map& map) noexcept
    {
        if (!solids_.push_back({}) || !paints_.push_back({})) return error::out_of_memory;
        std::size_t letters = 0;
        for (const basic_markup_look<Char>& look : read.looks()) letters += look.language.size();
        if (!languages_.reserve(letters)) return error::out_of_memory;
        for (const basic_markup_look<Char>& look : read.looks()) {
            text_style style = text_style_of(look);
            error e = map(look, style);
            if (!e) e = number(look, style);
            if (!e && !of_looks_.push_back(style)) e = error::out_of_memory;
            if (e) return e.at(no_glyph, place_of(read, of_looks_.size()));
        }
        std::uint32_t before = 0;  // the look of the last span
        for (const markup_span& s : read.spans()) {
            if (s.look == 0) continue;
            if (s.look == before && spans_.back().last == s.first)  // only their ruby differs
                spans_.back().last = s.last;
            else if (!spans_.push_back({s.first, s.last, of_looks_[s.look]}))
                return error::out_of_memory;
            before = s.look;
        }
        for (const markup_span& s : read.spans())
            if (s.look != 0 && read.looks()[s.look].has(markup_tag::mark) && !mark(s, read.looks()[s.look].mark))
                return error::out_of_memory;
        return {};
    }

    [[nodiscard]] bool mark(const markup_span& s, std::uint32_t colour) noexcept
    {
        constexpr std::uint32_t only = 1u << static_cast<unsigned>(markup_tag::mark);
        markup_paint paint{.tags = only, .colour = colour};
        std::uint32_t number = 0;
        if (!find(solids_, solid_index_, {.tags = only}, paint.solid) || !find(paints_, paint_index_, paint, number))
            return false;
        if (!marks_.empty() && marks_.back().last == s.first && marks_.back().style == style_id{number}) {
            marks_.back().last = s.last;
            return true;
        }
        return marks_.push_back({s.first, s.last, style_id{number}});
    }

    template <class Char>
    text_style text_style_of(const basic_markup_look<Char>& look) noexcept
    {
        text_style style;
        style.size = look.size;
        style.rise = look.rise;
        style.letter_spacing = look.spacing;
        style.position = look.position;
        if (look.has(markup_tag::italic)) style.slant = 0.2;
        if (look.has(markup_tag::underline)) style.decorations = style.decorations | decoration::underline;
        if (look.has(markup_tag::strike)) style.decorations = style.decorations | decoration::strike_through;
        if (look.has(markup_tag::overline)) style.decorations = style.decorations | decoration::overline;
        const std::size_t first = languages_.size();
        for (const Char c : look.language) languages_.push_back_unchecked(static_cast<char>(c));
        if (!look.language.empty()) style.language = {languages_.data() + first, look.language.size()};
        return style;
    }

    /// Gives the style the number of its paint.
    template <class Char>
    error number(const basic_markup_look<Char>& look, text_style& style) noexcept
    {
        const auto of = [&look](std::uint32_t set, markup_tag t) noexcept {
            return set | (look.tags & 1u << static_cast<unsigned>(t));
        };
        markup_solid solid{.depth = look.depth, .bevel = look.bevel};
        for (const markup_tag t : {markup_tag::bold, markup_tag::depth, markup_tag::bevel})
            solid.tags = of(solid.tags, t);
        markup_paint paint{.colour = look.colour, .style = look.style};
        for (const markup_tag t : {markup_tag::colour, markup_tag::style}) paint.tags = of(paint.tags, t);
        std::uint32_t found = 0;
        if (!find(solids_, solid_index_, solid, paint.solid) || !find(paints_, paint_index_, paint, found))
            return error::out_of_memory;
        style.style = style_id{found};
        return {};
    }

    template <class Value>
    [[nodiscard]] static bool find(buffer<Value>& table, value_index<Value>& index, const Value& value,
                                   std::uint32_t& number) noexcept
    {
        if (!index.read(table.view())) return false;
        number = static_cast<std::uint32_t>(index.find(table.view(), value));
        return number < table.size() || table.push_back(value);
    }

    /// Where the text of a look begins.
    template <class Char>
    static cluster_id place_of(const basic_markup<Char>& read, std::size_t look) noexcept
    {
        for (const markup_span& s : read.spans())
            if (s.look == look) return s.first;
        return no_cluster;
    }

    buffer<style_span> spans_;
    buffer<text_highlight> marks_;
    buffer<text_style> of_looks_;
    buffer<markup_paint> paints_;
    buffer<markup_solid> solids_;
    buffer<char> languages_;
    value_index<markup_paint> paint_index_;
    value_index<markup_solid> solid_index_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

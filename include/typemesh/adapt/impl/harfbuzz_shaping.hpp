// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/impl/column_glyphs.hpp>
#include <typemesh/layout/impl/column_runs.hpp>
#include <typemesh/layout/impl/emoji_sequence.hpp>
#include <typemesh/layout/impl/line_break.hpp>
#include <typemesh/layout/impl/long_graphemes.hpp>
#include <typemesh/layout/impl/mixed_line.hpp>
#include <typemesh/layout/impl/reading_order.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/script.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <hb-ot.h>
#include <hb.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Shapes one line with one font through HarfBuzz, piece by piece: see harfbuzz_font::shape(). Move-only. Call open()
/// before anything else.
class harfbuzz_shaping {
public:
    harfbuzz_shaping() noexcept = default;
    harfbuzz_shaping(harfbuzz_shaping&& other) noexcept { *this = std::move(other); }
    harfbuzz_shaping& operator=(harfbuzz_shaping&& other) noexcept
    {
        std::swap(buffer_, other.buffer_);
        std::swap(first_unit_, other.first_unit_);
        std::swap(part_, other.part_);
        features_.swap(other.features_);
        pieces_.swap(other.pieces_);
        items_.swap(other.items_);
        std::swap(mixed_, other.mixed_);
        shaped_.swap(other.shaped_);
        return *this;
    }
    ~harfbuzz_shaping() { hb_buffer_destroy(buffer_); }

    /// Creates HarfBuzz's buffer, once. Fails with error::out_of_memory.
    error open() noexcept
    {
        buffer_ = hb_buffer_create();
        return hb_buffer_allocation_successful(buffer_) ? error{} : error{error::out_of_memory};
    }

    /// `unit`: font units per unit of the HarfBuzz font, x and y.
    result<point> shape(hb_font_t* font, point unit, text_view text, std::size_t first, std::size_t last,
                        const shape_options& options, glyph_run& run) noexcept
    {
        if (last - first >= std::size_t{1} << 28) return error::too_large;

        const line_reading found = read_line(text, first, last);
        hb_script_t script = HB_SCRIPT_INVALID;
        if (error e = take_script(options, script)) return e;
        if (options.direction == direction::top_to_bottom && !stands_upright(text, first, last, options.columns)) {
            const auto has_form = [&](char32_t c) noexcept { return has_vertical_form(font, c); };
            if (error e = mixed_.split_column(text, first, last, options, has_form, items_)) return e;
            if (found.invalid.count != 0) run.note_invalid_units(found.invalid.first, found.invalid.count);
            return shape_items(font, unit, text, options, run);
        }
        const hb_direction_t way = direction_of(found, options.direction, script);
        const bool back = way == HB_DIRECTION_RTL;
        if (way == HB_DIRECTION_INVALID || (back && find_number(text, first, last) != line_reading::nowhere)) {
            shape_options base = options;
            if (back) base.direction = direction::right_to_left;  // the script's, for example in a line of digits
            if (error e = mixed_.split(text, first, last, base, items_)) return e;
            if (found.invalid.count != 0) run.note_invalid_units(found.invalid.first, found.invalid.count);
            return shape_items(font, unit, text, options, run);
        }
        if (error e = take_features(options)) return e;
        if (script == HB_SCRIPT_INVALID && found.only_ascii)
            script = found.to_the_right == line_reading::nowhere ? HB_SCRIPT_COMMON : HB_SCRIPT_LATIN;
        if (error e = cut_into_pieces(text, first, last, script)) return e;

        const hb_language_t language = language_of(options);
        point at;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const piece p = pieces_[back ? pieces_.size() - 1 - k : k];
            fill_buffer(text, p, found.invalid.count != 0, HB_BUFFER_FLAG_DEFAULT);
            if (error e = shape_buffer(font, way, p.script, language)) return e;
            if (error e = take_glyphs(unit, at, run)) return e;
        }
        if (found.invalid.count != 0) run.note_invalid_units(found.invalid.first, found.invalid.count);
        return at;
    }

    /// One item: see item_shaper.
    error shape_item(hb_font_t* font, point unit, text_view text, const text_item& item, const shape_options& options,
                     buffer<shaped_glyph>& glyphs) noexcept
    {
        if (item.last - item.first >= 1u << 28) return error::too_large;
        hb_script_t script = item.script != 0 ? hb_script_from_iso15924_tag(item.script) : HB_SCRIPT_COMMON;
        if (error e = take_script(options, script)) return e;
        if (error e = take_features(options)) return e;

        return append_item(font, unit, text, item, {script, language_of(options), item_flags}, glyphs);
    }

    /// Whether the font has a different glyph for a character in columns.
    bool has_vertical_form(hb_font_t* font, char32_t c) noexcept
    {
        hb_codepoint_t plain = 0;
        if (!hb_font_get_nominal_glyph(font, c, &plain)) return false;
        hb_buffer_clear_contents(buffer_);
        hb_buffer_set_content_type(buffer_, HB_BUFFER_CONTENT_TYPE_UNICODE);
        hb_buffer_add(buffer_, c, 0);
        features_.clear();
        if (shape_buffer(font, HB_DIRECTION_TTB, HB_SCRIPT_COMMON, HB_LANGUAGE_INVALID)) return false;
        unsigned count = 0;
        const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer_, &count);
        return count == 1 && info[0].codepoint != plain;
    }

    static double column_middle(hb_font_t* font, point unit) noexcept
    {
        hb_position_t height = 0;
        hb_ot_layout_get_baseline_with_fallback(font, HB_OT_LAYOUT_BASELINE_TAG_IDEO_EMBOX_CENTRAL, HB_DIRECTION_LTR,
                                                HB_TAG('h', 'a', 'n', 'i'), HB_TAG('d', 'f', 'l', 't'), &height);
        return unit.y * height;
    }

private:
#if HB_VERSION_ATLEAST(5, 1, 0)
    static constexpr int item_flags = HB_BUFFER_FLAG_PRODUCE_SAFE_TO_INSERT_TATWEEL;
#else
    static constexpr int item_flags = HB_BUFFER_FLAG_DEFAULT;
#endif

    /// A run of a line in one script, or a part of it.
    struct piece {
        shaping_part part;
        hb_script_t script;
    };

    /// The way to shape an item.
    struct item_way {
        hb_script_t script;
        hb_language_t language;
        int flags;
    };

    /// The direction of a line that has only one; otherwise HB_DIRECTION_INVALID.
    static hb_direction_t direction_of(const line_reading& found, direction wanted, hb_script_t script) noexcept
    {
        if (wanted == direction::top_to_bottom) return HB_DIRECTION_TTB;
        const bool right = found.to_the_right != line_reading::nowhere,
                   left = found.to_the_left != line_reading::nowhere;
        if ((right && (left || wanted == direction::right_to_left)) || (left && wanted == direction::left_to_right))
            return HB_DIRECTION_INVALID;
        if (left || wanted == direction::right_to_left) return HB_DIRECTION_RTL;
        if (right || wanted == direction::left_to_right || script == HB_SCRIPT_INVALID) return HB_DIRECTION_LTR;
        return hb_script_get_horizontal_direction(script) == HB_DIRECTION_RTL ? HB_DIRECTION_RTL : HB_DIRECTION_LTR;
    }

    static hb_direction_t way_of(const text_item& item) noexcept
    {
        if (item.orientation == glyph_orientation::upright)
            return item.to_the_left() ? HB_DIRECTION_BTT : HB_DIRECTION_TTB;
        return item.to_the_left() ? HB_DIRECTION_RTL : HB_DIRECTION_LTR;
    }

    /// Whether all of text[first, last) stands upright in a column, so that no analysis is needed.
    static bool stands_upright(text_view text, std::size_t first, std::size_t last, const column_options& how) noexcept
    {
        if (how.latin == column_latin::upright && how.combined_digits == 0) return true;
        for (std::size_t i = first; i < last;) {
            const code_point c = decode(text, i, last);
            const vertical_orientation o = character_of(c.value).orientation;
            if (o != vertical_orientation::upright && o != vertical_orientation::transformed_upright) return false;
            i = c.next;
        }
        return true;
    }

    /// Shapes a line's items from left to right, or a column's from top to bottom.
    result<point> shape_items(hb_font_t* font, point unit, text_view text, const shape_options& options,
                              glyph_run& run) noexcept
    {
        if (error e = take_features(options)) return e;
        point at;
        for (const text_item& item : items_) {
            hb_script_t script = hb_script_from_iso15924_tag(item.script);
            if (error e = take_script(options, script)) return e;
            const item_way how{script, language_of(options), HB_BUFFER_FLAG_DEFAULT};
            if (item.orientation != glyph_orientation::horizontal) {
                shaped_.clear();
                if (error e = append_item(font, unit, text, item, how, shaped_)) return e;
                if (error e = place_column(font, unit, item, options.columns, at, run)) return e;
                continue;
            }
            if (error e = cut_item(text, item, script)) return e;
            for (std::size_t k = 0; k < pieces_.size(); ++k) {
                if (error e = shape_piece(font, text, item, how, k)) return e;
                if (error e = take_glyphs(unit, at, run)) return e;
            }
        }
        return at;
    }

    /// Appends a shaped item of a column, starting at `at`, which advances.
    error place_column(hb_font_t* font, point unit, const text_item& item, const column_options& how, point& at,
                       glyph_run& run) noexcept
    {
        const double em = hb_face_get_upem(hb_font_get_face(font));
        return place_item(shaped_.view(), item, {column_middle(font, unit), em, how.combined_gap * em}, at, run);
    }

    /// Shapes an item and appends its glyphs.
    error append_item(hb_font_t* font, point unit, text_view text, const text_item& item, const item_way& how,
                      buffer<shaped_glyph>& glyphs) noexcept
    {
        if (error e = cut_item(text, item, how.script)) return e;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (error e = shape_piece(font, text, item, how, k)) return e;
            if (error e = append_glyphs(unit, item.orientation == glyph_orientation::upright, glyphs)) return e;
        }
        return {};
    }

    /// Cuts an item into pieces that are shaped at once; nearly always one piece.
    error cut_item(text_view text, const text_item& item, hb_script_t script) noexcept
    {
        pieces_.clear();
        return add_pieces(text, item.first, item.last, script);
    }
    error add_pieces(text_view text, std::size_t first, std::size_t last, hb_script_t script) noexcept
    {
        return cut_long_graphemes(text, first, last, [this, script](const shaping_part& part) noexcept {
            return pieces_.push_back({part, script}) ? error{} : error{error::out_of_memory};
        });
    }

    /// Shapes the k-th piece of an item in drawing order with HarfBuzz.
    error shape_piece(hb_font_t* font, text_view text, const text_item& item, const item_way& how,
                      std::size_t k) noexcept
    {
        const piece p = pieces_[item.to_the_left() ? pieces_.size() - 1 - k : k];
        fill_buffer(text, p, !is_valid(text, item), how.flags);
        return shape_buffer(font, way_of(item), how.script, how.language);
    }

    static bool is_valid(text_view text, const text_item& item) noexcept
    {
        for (std::size_t i = item.first; i < item.last;) {
            const code_point c = decode(text, i, item.last);
            if (!c.valid) return false;
            i = c.next;
        }
        return true;
    }

    /// Sets `script` to the script that the options name, if any.
    static error take_script(const shape_options& options, hb_script_t& script) noexcept
    {
        if (options.script.empty()) return {};
        script = hb_script_from_string(options.script.data(), options.script.size() == 4 ? 4 : 0);
        const bool known = script != HB_SCRIPT_INVALID && script != HB_SCRIPT_UNKNOWN;
        return known ? error{} : error::bad("script");
    }

    static hb_language_t language_of(const shape_options& options) noexcept
    {
        return options.language.empty()
                   ? HB_LANGUAGE_INVALID
                   : hb_language_from_string(options.language.data(), static_cast<int>(options.language.size()));
    }

    error take_features(const shape_options& wanted) noexcept
    {
        features_.clear();
        // Features requested by name come later and win.
        for (const feature& f :
             wanted.ligatures ? array_view<const feature>{} : array_view<const feature>{no_ligatures})
            if (error e = take_feature(f)) return e;
        for (const feature& f : wanted.features) {
            for (int i = 0; i < 4; ++i)
                if (f.tag[i] < 0x20 || f.tag[i] > 0x7E) return error::bad_feature;
            if (error e = take_feature(f)) return e;
        }
        return {};
    }
    error take_feature(const feature& f) noexcept
    {
        const hb_feature_t whole{hb_tag_from_string(f.tag, 4), f.value, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
        return features_.push_back(whole) ? error{} : error{error::out_of_memory};
    }

    static hb_script_t script_of(hb_unicode_funcs_t* unicode, char32_t c) noexcept
    {
        if (c < 0x80) return (c | 0x20) >= 'a' && (c | 0x20) <= 'z' ? HB_SCRIPT_LATIN : HB_SCRIPT_COMMON;
        if (c >= 0x4E00 && c <= 0x9FFF) return HB_SCRIPT_HAN;
        return hb_unicode_script(unicode, c);
    }

    /// Cuts where the script changes. Characters without a script of their own (spaces, digits, marks) stay with the
    /// preceding text.
    error cut_into_pieces(text_view text, std::size_t first, std::size_t last, hb_script_t given) noexcept
    {
        pieces_.clear();
        struct {
            std::size_t first;
            hb_script_t script;
        } open{first, given};
        hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
        for (std::size_t i = first; i < last && given == HB_SCRIPT_INVALID;) {
            const code_point c = decode(text, i, last);
            const hb_script_t script = script_of(unicode, c.value);
            if (script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED && script != HB_SCRIPT_UNKNOWN) {
                if (open.script == HB_SCRIPT_INVALID)
                    open.script = script;
                else if (!set_as_one(script, open.script)) {
                    if (error e = add_pieces(text, open.first, i, open.script)) return e;
                    open = {i, script};
                }
            }
            i = c.next;
        }
        if (open.script == HB_SCRIPT_INVALID) open.script = HB_SCRIPT_COMMON;
        return add_pieces(text, open.first, last, open.script);
    }

    /// Passes a piece and its context to HarfBuzz. Valid text is passed unchanged, other text code point by code point,
    /// because HarfBuzz would read a different number of U+FFFD from broken UTF-8 than decode() does.
    void fill_buffer(text_view text, const piece& p, bool decoded, int flags) noexcept
    {
        constexpr std::size_t context = 32;  // units; HarfBuzz looks at five characters
        const shaping_part& own = part_ = p.part;
        std::size_t begin = own.first, end = own.last;
        while (begin > 0 && own.first - begin < context && !breaks_line(text.unit(begin - 1))) --begin;
        while (end < text.size() && end - own.last < context && line_break_at(text, end) == 0) ++end;

        hb_buffer_clear_contents(buffer_);
        hb_buffer_set_content_type(buffer_, HB_BUFFER_CONTENT_TYPE_UNICODE);
        if (begin == own.first) flags |= HB_BUFFER_FLAG_BOT;
        if (end == own.last) flags |= HB_BUFFER_FLAG_EOT;
        if (own.inner_end != 0) flags |= HB_BUFFER_FLAG_DO_NOT_INSERT_DOTTED_CIRCLE;
        hb_buffer_set_flags(buffer_, static_cast<hb_buffer_flags_t>(flags));
        first_unit_ = begin;
        text_ = text;
        last_unit_ = own.last;
        if (!decoded) return add(text, begin, end, own.first, own.last);
        add(text, begin, own.first, own.first, own.first);
        for (std::size_t i = own.first; i < own.last;) {
            const code_point c = decode(text, i, own.last);
            hb_buffer_add(buffer_, c.value, static_cast<unsigned>(i - begin));
            i = c.next;
        }
        add(text, own.last, end, own.last, own.last);
    }

    /// Adds text[first, last), with text[begin, end) around it as context.
    void add(text_view text, std::size_t begin, std::size_t end, std::size_t first, std::size_t last) noexcept
    {
        const auto size = static_cast<int>(end - begin), length = static_cast<int>(last - first);
        const auto offset = static_cast<unsigned>(first - begin);
        if (text.encoding() == encoding::utf8)
            return hb_buffer_add_utf8(buffer_, text.utf8() + begin, size, offset, length);
        const void* units = text.utf16() + begin;
        hb_buffer_add_utf16(buffer_, static_cast<const std::uint16_t*>(units), size, offset, length);
    }

    static bool breaks_line(std::uint32_t unit) noexcept { return unit >= 0x0A && unit <= 0x0D; }

    /// Shapes the contents of HarfBuzz's buffer.
    error shape_buffer(hb_font_t* font, hb_direction_t way, hb_script_t script, hb_language_t language) noexcept
    {
        hb_buffer_set_direction(buffer_, way);
        hb_buffer_set_script(buffer_, script);
        hb_buffer_set_language(buffer_, language);
        const auto shaped =
            hb_shape_full(font, buffer_, features_.data(), static_cast<unsigned>(features_.size()), nullptr);
        font_ = font;
        if (!hb_buffer_allocation_successful(buffer_)) return error::out_of_memory;
        return shaped ? error{} : error::font_library_failed;
    }

    static glyph_flags flags_of(const hb_glyph_info_t& info) noexcept
    {
        const unsigned set = hb_glyph_info_get_glyph_flags(&info);
        glyph_flags flags = glyph_flags::none;
        if ((set & HB_GLYPH_FLAG_UNSAFE_TO_BREAK) != 0) flags = flags | glyph_flags::unsafe_to_break;
#if HB_VERSION_ATLEAST(5, 1, 0)
        if ((set & HB_GLYPH_FLAG_SAFE_TO_INSERT_TATWEEL) != 0) flags = flags | glyph_flags::tatweel;
#endif
        return info.codepoint == 0 ? flags | glyph_flags::missing : flags;
    }

    /// Whether the glyph before i is the first of several that draw an emoji of several code points in parts. HarfBuzz
    /// makes each grapheme one cluster.
    [[nodiscard]] bool begins_parted(array_view<const hb_glyph_info_t> all, std::size_t i) const noexcept
    {
        const unsigned cluster = all[i].cluster;
        if (all[i - 1].cluster != cluster || (i > 1 && all[i - 2].cluster == cluster)) return false;
        const std::size_t first = first_unit_ + cluster;
        if (decode(text_, first, last_unit_).value < 0x203C) return false;  // the first of the emoji beyond Latin-1
        return is_parted(all.subspan(i - 1), first);
    }
    [[nodiscard]] bool is_parted(array_view<const hb_glyph_info_t> glyphs, std::size_t first) const noexcept
    {
        std::size_t count = 0, last = last_unit_;
        while (count < glyphs.size() && glyphs[count].cluster == glyphs[0].cluster) ++count;
        grapheme_boundaries begins;
        for (std::size_t at = first; at < last_unit_ && last == last_unit_;) {
            const code_point c = decode(text_, at, last_unit_);
            if (begins(character_of(c.value).grapheme) && at != first) last = at;
            at = c.next;
        }
        const auto is_drawn = [&](char32_t c) noexcept {
            hb_codepoint_t plain = 0, pictured = 0;
            if (!hb_font_get_nominal_glyph(font_, c, &plain)) return false;
            if (!hb_font_get_variation_glyph(font_, c, 0xFE0F, &pictured)) pictured = plain;
            for (std::size_t k = 0; k < count; ++k)
                if (glyphs[k].codepoint == plain || glyphs[k].codepoint == pictured) return true;
            return false;
        };
        return has_fallen_apart(text_, first, last, is_drawn);
    }
    [[nodiscard]] cluster_id cluster_of(const hb_glyph_info_t& info) const noexcept
    {
        return static_cast<cluster_id>(part_.cluster(first_unit_ + info.cluster));
    }

    /// Appends HarfBuzz's glyphs, with advances along the line.
    error append_glyphs(point unit, bool down, buffer<shaped_glyph>& glyphs) const noexcept
    {
        unsigned count = 0;
        const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer_, &count);
        const hb_glyph_position_t* position = hb_buffer_get_glyph_positions(buffer_, nullptr);
        shaped_glyph* out = glyphs.append(count);
        if (out == nullptr) return count == 0 ? error{} : error{error::out_of_memory};
        for (unsigned i = 0; i < count; ++i)
            out[i] = {info[i].codepoint,
                      cluster_of(info[i]),
                      down ? 0.0 - unit.y * position[i].y_advance : unit.x * position[i].x_advance,
                      {unit.x * position[i].x_offset, unit.y * position[i].y_offset},
                      0,
                      flags_of(info[i])};
        for (unsigned i = 1; i < count; ++i)
            if (begins_parted({info, count}, i)) out[i - 1].flags = out[i - 1].flags | glyph_flags::parted;
        return {};
    }

    /// Appends HarfBuzz's glyphs, starting at `at`, which advances.
    error take_glyphs(point unit, point& at, glyph_run& run) const noexcept
    {
        unsigned count = 0;
        const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer_, &count);
        const hb_glyph_position_t* position = hb_buffer_get_glyph_positions(buffer_, nullptr);
        placed_glyph* out = run.glyphs.append(count);
        if (out == nullptr) return count == 0 ? error{} : error{error::out_of_memory};
        for (unsigned i = 0; i < count; ++i) {
            const cluster_id cluster = cluster_of(info[i]);
            const bool missing = info[i].codepoint == 0;
            out[i] = {info[i].codepoint,
                      cluster,
                      {at.x + unit.x * position[i].x_offset, at.y + unit.y * position[i].y_offset},
                      missing};
            at = {at.x + unit.x * position[i].x_advance, at.y + unit.y * position[i].y_advance};
            if (missing) run.note_missing(cluster);
            if (i > 0 && begins_parted({info, count}, i)) run.note_parted(cluster);
        }
        return {};
    }

    hb_buffer_t* buffer_ = nullptr;
    std::size_t first_unit_ = 0;  // the origin of HarfBuzz's clusters
    std::size_t last_unit_ = 0;   // end of the buffer's text
    text_view text_ = {};         // the buffer's text, until the next call
    hb_font_t* font_ = nullptr;   // the font that shaped it
    shaping_part part_;           // the contents of the buffer
    buffer<hb_feature_t> features_;
    buffer<piece> pieces_;
    buffer<text_item> items_;  // the items of a line with both directions
    mixed_line mixed_;
    buffer<shaped_glyph> shaped_;  // the glyphs of a column's item
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

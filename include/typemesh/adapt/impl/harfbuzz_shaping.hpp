// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/layout/impl/emoji_sequence.hpp>
#include <typemesh/layout/impl/line_break.hpp>
#include <typemesh/layout/impl/long_graphemes.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <hb-ot.h>
#include <hb.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Shapes items with one font through HarfBuzz: see harfbuzz_font::shape(). Move-only. Call open()
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
        return *this;
    }
    ~harfbuzz_shaping() { hb_buffer_destroy(buffer_); }

    /// Creates HarfBuzz's buffer, once. Fails with error::out_of_memory.
    error open() noexcept
    {
        buffer_ = hb_buffer_create();
        return hb_buffer_allocation_successful(buffer_) ? error{} : error{error::out_of_memory};
    }

    /// See shaper. `unit`: font units per unit of the HarfBuzz font, x and y.
    error shape(hb_font_t* font, point unit, text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        if (item.last - item.first >= 1u << 28) return error::too_large;
        hb_script_t script = item.script != 0 ? hb_script_from_iso15924_tag(item.script) : HB_SCRIPT_COMMON;
        if (error e = take_script(options, script)) return e;
        if (error e = take_features(options)) return e;
        pieces_.clear();
        const error cut = cut_long_graphemes(text, item.first, item.last, [this](const shaping_part& part) noexcept {
            return pieces_.push_back(part) ? error{} : error{error::out_of_memory};
        });
        if (cut) return cut;
        const bool valid = is_valid(text, item);
        const hb_language_t language = language_of(options);
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            fill_buffer(text, pieces_[item.to_the_left() ? pieces_.size() - 1 - k : k], !valid);
            if (error e = shape_buffer(font, way_of(item), script, language)) return e;
            if (error e = append_glyphs(unit, item.orientation == glyph_orientation::upright, glyphs)) return e;
        }
        return {};
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

    static hb_direction_t way_of(const text_item& item) noexcept
    {
        if (item.orientation == glyph_orientation::upright)
            return item.to_the_left() ? HB_DIRECTION_BTT : HB_DIRECTION_TTB;
        return item.to_the_left() ? HB_DIRECTION_RTL : HB_DIRECTION_LTR;
    }

    static bool is_valid(text_view text, const text_item& item) noexcept
    {
        for (std::size_t i = item.first; i < item.last;) {
            if (text.unit(i) < 0x80) {
                ++i;
                continue;
            }
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

    /// Passes a piece and its context to HarfBuzz. Valid text is passed unchanged, other text code point by code point,
    /// because HarfBuzz would read a different number of U+FFFD from broken UTF-8 than decode() does.
    void fill_buffer(text_view text, const shaping_part& own, bool decoded) noexcept
    {
        constexpr std::size_t context = 32;  // units; HarfBuzz looks at five characters
        part_ = own;
        std::size_t begin = own.first, end = own.last;
        while (begin > 0 && own.first - begin < context && !breaks_line(text.unit(begin - 1))) --begin;
        while (end < text.size() && end - own.last < context && line_break_at(text, end) == 0) ++end;

        hb_buffer_clear_contents(buffer_);
        hb_buffer_set_content_type(buffer_, HB_BUFFER_CONTENT_TYPE_UNICODE);
        int flags = item_flags;
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

    hb_buffer_t* buffer_ = nullptr;
    std::size_t first_unit_ = 0;  // the origin of HarfBuzz's clusters
    std::size_t last_unit_ = 0;   // end of the buffer's text
    text_view text_ = {};         // the buffer's text, until the next call
    hb_font_t* font_ = nullptr;   // the font that shaped it
    shaping_part part_;           // the contents of the buffer
    buffer<hb_feature_t> features_;
    buffer<shaping_part> pieces_;  // of the item, each shaped at once; nearly always one
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_analysis.hpp>
#include <typemesh/adapt/impl/directwrite_clusters.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/text_view.hpp>
#include <typemesh/unicode/utf.hpp>

#include <dwrite.h>
#include <dwrite_1.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A tag as DirectWrite stores it, the first letter in the lowest byte; short ones are padded with spaces.
[[nodiscard]] inline std::uint32_t directwrite_tag(const char (&tag)[5]) noexcept
{
    std::uint32_t made = 0;
    bool ended = false;
    for (int i = 0; i < 4; ++i) {
        ended = ended || tag[i] == '\0';
        made |= (ended ? std::uint32_t{' '} : std::uint32_t{static_cast<unsigned char>(tag[i])}) << (8 * i);
    }
    return made;
}

/// Shapes items with one face through IDWriteTextAnalyzer: see directwrite_font::shape(). Call open() before anything
/// else.
class directwrite_shaping {
public:
    error open(IDWriteFactory* factory) noexcept
    {
        return directwrite_error(factory->CreateTextAnalyzer(analyser_.put()));
    }

    /// See shaper.
    error shape(IDWriteFontFace* face, double units_per_em, text_view text, const text_item& item,
                const shape_options& options, buffer<shaped_glyph>& glyphs) noexcept
    {
        if (item.last - item.first >= 1u << 28) return error::too_large;
        const setting how{face, units_per_em, item.orientation == glyph_orientation::upright, item.to_the_left()};
        if (error e = take_text(text, item.first, item.last)) return e;
        if (error e = take_language(options.language)) return e;
        if (error e = take_features(options, how.down)) return e;
        if (error e = analyse(options, how.to_the_left)) return e;
        if (error e = cut_into_pieces()) return e;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const piece& p = pieces_[how.to_the_left ? pieces_.size() - 1 - k : k];
            if (error e = shape_piece(how, p)) return e;
            if (error e = append_glyphs(how, p, text, glyphs)) return e;
        }
        return {};
    }

    /// Whether the font has a different glyph for a character in columns.
    bool has_vertical_form(IDWriteFontFace* face, double units_per_em, char32_t c) noexcept
    {
        const UINT32 character = c;
        UINT16 plain = 0;
        if (FAILED(face->GetGlyphIndices(&character, 1, &plain)) || plain == 0) return false;
        const char16_t pair[] = {static_cast<char16_t>(0xD7C0 + (c >> 10)),
                                 static_cast<char16_t>(0xDC00 + (c & 0x3FF))};
        const auto single = static_cast<char16_t>(c);
        const bool one = c < 0x10000;
        const std::u16string_view text{one ? &single : pair, one ? std::size_t{1} : std::size_t{2}};
        const setting how{face, units_per_em, true, false};
        if (take_text(text, 0, text.size()) || take_language({}) || take_features({}, true)) return false;
        if (analyse({}, false) || cut_into_pieces() || pieces_.size() != 1) return false;
        return !shape_piece(how, pieces_[0]) && count_ == 1 && glyphs_[0] != plain;
    }

private:
    /// What is the same for all pieces of an item.
    struct setting {
        IDWriteFontFace* face;
        double units_per_em;
        bool down;  // glyphs stand upright in a column
        bool to_the_left;
    };

    /// A run of the item in one script, by DirectWrite's analysis.
    struct piece {
        std::uint32_t first;
        std::uint32_t last;
        DWRITE_SCRIPT_ANALYSIS script;
    };

    /// The sink for the analyser's results.
    class analysis_sink final : public directwrite_sink {
    public:
        explicit analysis_sink(std::span<DWRITE_SCRIPT_ANALYSIS> units) noexcept : units_{units} {}
        HRESULT STDMETHODCALLTYPE SetScriptAnalysis(UINT32 at, UINT32 count,
                                                    const DWRITE_SCRIPT_ANALYSIS* script) noexcept override
        {
            for (DWRITE_SCRIPT_ANALYSIS& u : clipped(units_, at, count)) u = *script;
            return S_OK;
        }

    private:
        std::span<DWRITE_SCRIPT_ANALYSIS> units_;
    };

    /// Stores the item in UTF-16 and, for each of its units, the position in the caller's text.
    error take_text(text_view text, std::size_t first, std::size_t last) noexcept
    {
        text_.clear();
        clusters_.clear();
        if (!text_.reserve(last - first) || !clusters_.reserve(last - first)) return error::out_of_memory;
        for (std::size_t i = first; i < last;) {
            const code_point c = decode(text, i, last);
            const auto cluster = static_cast<cluster_id>(i);
            // UTF-16 never has more units than UTF-8.
            const bool pair = c.value >= 0x10000;
            text_.push_back_unchecked(static_cast<wchar_t>(pair ? 0xD7C0 + (c.value >> 10) : c.value));
            clusters_.push_back_unchecked(cluster);
            if (pair) {
                text_.push_back_unchecked(static_cast<wchar_t>(0xDC00 + (c.value & 0x3FF)));
                clusters_.push_back_unchecked(cluster);
            }
            i = c.next;
        }
        return {};
    }

    error take_language(std::string_view language) noexcept
    {
        if (language.size() >= sizeof language_ / sizeof language_[0]) return error::bad("language");
        std::size_t n = 0;
        for (const char c : language) language_[n++] = static_cast<wchar_t>(static_cast<unsigned char>(c));
        language_[n] = L'\0';
        return {};
    }

    error take_features(const shape_options& wanted, bool down) noexcept
    {
        features_.clear();
        for (const feature& f : wanted.features) {
            for (int i = 0; i < 4; ++i)
                if (f.tag[i] < 0x20 || f.tag[i] > 0x7E) return error::bad_feature;
            if (error e = take_feature(f)) return e;
        }
        for (const feature& f : no_ligatures)
            if (!wanted.ligatures && !has_feature(f.tag))
                if (error e = take_feature(f)) return e;
        return down ? take_feature({"vert", 1}) : error{};
    }
    error take_feature(const feature& f) noexcept
    {
        const bool taken = features_.push_back({static_cast<DWRITE_FONT_FEATURE_TAG>(directwrite_tag(f.tag)), f.value});
        return taken ? error{} : error{error::out_of_memory};
    }
    bool has_feature(const char (&tag)[5]) const noexcept
    {
        for (const DWRITE_FONT_FEATURE& f : features_)
            if (f.nameTag == static_cast<DWRITE_FONT_FEATURE_TAG>(directwrite_tag(tag))) return true;
        return false;
    }

    /// Finds the script of every unit.
    error analyse(const shape_options& options, bool to_the_left) noexcept
    {
        analysis_.clear();
        const auto count = static_cast<UINT32>(text_.size());
        if (count == 0) return {};
        DWRITE_SCRIPT_ANALYSIS* units = analysis_.append(count);
        if (units == nullptr) return error::out_of_memory;
        for (UINT32 i = 0; i < count; ++i) units[i] = {};

        directwrite_source source{text_.view(), language_, to_the_left};
        analysis_sink sink{analysis_.view()};
        if (error e = directwrite_error(analyser_->AnalyzeScript(&source, 0, count, &sink))) return e;
        if (options.script.empty()) return {};
        if (options.script.size() != 4) return error::bad("script");
        const auto script = script_named(options.script);
        if (!script) return script.error();
        for (UINT32 i = 0; i < count; ++i) units[i].script = *script;
        return {};
    }

    /// DirectWrite's number for a script of ISO 15924 (available from Windows 8).
    [[nodiscard]] result<UINT16> script_named(std::string_view name) const noexcept
    {
        const auto teller = analyser_.as<IDWriteTextAnalyzer1>();
        if (!teller) return error::bad("script");
        char tag[5] = {};
        for (int i = 0; i < 4; ++i) tag[i] = name[static_cast<std::size_t>(i)];
        for (UINT16 i = 0; i < 1024; ++i) {
            DWRITE_SCRIPT_PROPERTIES said = {};
            const DWRITE_SCRIPT_ANALYSIS script = {i, DWRITE_SCRIPT_SHAPES_DEFAULT};
            if (FAILED(teller->GetScriptProperties(script, &said))) break;
            if (said.isoScriptCode == directwrite_tag(tag)) return i;
        }
        return error::bad("script");
    }

    /// Cuts the item where the script changes, and where it is too long.
    error cut_into_pieces() noexcept
    {
        constexpr std::uint32_t longest = 0x4000;  // units; DirectWrite counts glyphs of a piece in 16 bits
        pieces_.clear();
        for (std::uint32_t i = 0, end = 0; i < text_.size(); i = end) {
            const DWRITE_SCRIPT_ANALYSIS& script = analysis_[i];
            for (end = i + 1; end < text_.size(); ++end) {
                const DWRITE_SCRIPT_ANALYSIS& next = analysis_[end];
                if (next.script != script.script || next.shapes != script.shapes) break;
                const bool joint = text_[end - 1] == L' ' || end - i >= longest + 0x1000;
                const bool inside_pair = text_[end] >= 0xDC00 && text_[end] <= 0xDFFF;
                if (end - i >= longest && joint && !inside_pair) break;
            }
            if (!pieces_.push_back({i, end, script})) return error::out_of_memory;
        }
        return {};
    }

    /// Shapes a piece: fills map_, text_properties_, glyphs_, count_, advances_ and offsets_, in DirectWrite's order.
    error shape_piece(const setting& how, const piece& p) noexcept
    {
        const wchar_t* text = text_.data() + p.first;
        const UINT32 length = p.last - p.first;
        const BOOL to_the_left = how.to_the_left ? TRUE : FALSE;
        const wchar_t* language = language_[0] != L'\0' ? language_ : nullptr;
        DWRITE_TYPOGRAPHIC_FEATURES list = {features_.data(), static_cast<UINT32>(features_.size())};
        const DWRITE_TYPOGRAPHIC_FEATURES* lists[] = {&list};
        const UINT32 ranges = features_.empty() ? 0 : 1;
        const DWRITE_TYPOGRAPHIC_FEATURES** given = ranges != 0 ? lists : nullptr;

        map_.clear();
        text_properties_.clear();
        if (map_.append(length) == nullptr || text_properties_.append(length) == nullptr) return error::out_of_memory;
        count_ = 0;
        for (UINT32 room = length + length / 2 + 16;; room = 2 * room < 0xFFFF ? 2 * room : 0xFFFF) {
            glyphs_.clear();
            glyph_properties_.clear();
            if (glyphs_.append(room) == nullptr || glyph_properties_.append(room) == nullptr)
                return error::out_of_memory;
            const HRESULT code = analyser_->GetGlyphs(
                text, length, how.face, FALSE, to_the_left, &p.script, language, nullptr, given, &length, ranges, room,
                map_.data(), text_properties_.data(), glyphs_.data(), glyph_properties_.data(), &count_);
            constexpr auto too_little_room = static_cast<HRESULT>(0x8007'007Au);  // ERROR_INSUFFICIENT_BUFFER
            if (code == too_little_room && room < 0xFFFF) continue;
            if (error e = directwrite_error(code)) return e;
            break;
        }
        advances_.clear();
        offsets_.clear();
        if (count_ == 0) return {};
        if (advances_.append(count_) == nullptr || offsets_.append(count_) == nullptr) return error::out_of_memory;
        return directwrite_error(analyser_->GetGlyphPlacements(
            text, map_.data(), text_properties_.data(), length, glyphs_.data(), glyph_properties_.data(), count_,
            how.face, static_cast<FLOAT>(how.units_per_em), FALSE, to_the_left, &p.script, language, given, &length,
            ranges, advances_.data(), offsets_.data()));
    }

    /// Appends the glyphs of a shaped piece in drawing order: DirectWrite's own, reversed for right-to-left text.
    error append_glyphs(const setting& how, const piece& p, text_view text, buffer<shaped_glyph>& glyphs) noexcept
    {
        if (sources_.size() < count_ && sources_.append(count_ - sources_.size()) == nullptr)
            return error::out_of_memory;
        invert_cluster_map({map_.data(), map_.size()}, {sources_.data(), count_});
        shaped_glyph* out = glyphs.append(count_);
        if (out == nullptr) return count_ == 0 ? error{} : error{error::out_of_memory};
        for (UINT32 k = 0; k < count_; ++k) {
            const UINT32 i = how.to_the_left ? count_ - 1 - k : k;
            const std::uint32_t unit = sources_[i];
            const cluster_id cluster = clusters_[p.first + unit];
            const bool missing = glyphs_[i] == 0;
            if (missing && draws_nothing(decode(text, cluster).value)) continue;
            const double along = double{offsets_[i].advanceOffset};
            shaped_glyph g{glyphs_[i],
                           cluster,
                           double{advances_[i]},
                           {how.to_the_left ? -along : along, double{offsets_[i].ascenderOffset}}};
            if (how.down) {
                DWRITE_GLYPH_METRICS m = {};
                if (error e = directwrite_error(how.face->GetDesignGlyphMetrics(&glyphs_[i], 1, &m, FALSE))) return e;
                const double width = m.advanceWidth, top = m.verticalOriginY;
                g.offset = g.offset - point{width / 2, top};
                g.advance = m.advanceHeight;
            }
            if (missing) g.flags = glyph_flags::missing;
            if (!breaks_safely(p, unit)) g.flags = g.flags | glyph_flags::unsafe_to_break;
            *out++ = g;
        }
        glyphs.truncate(static_cast<std::size_t>(out - glyphs.data()));
        return {};
    }

    /// Whether the piece's glyphs do not change if it is divided before a unit. Pieces are shaped independently, so the
    /// first unit is safe. Wine also says so of places between joined letters.
    [[nodiscard]] bool breaks_safely(const piece& p, std::uint32_t unit) const noexcept
    {
        if (unit == 0) return true;
        const std::uint32_t at = p.first + unit;
        const bool joined = is_written_joined(text_[at - 1]) && is_written_joined(text_[at]);
        return !joined && text_properties_[unit - 1].canBreakShapingAfter != 0;
    }

    com_ptr<IDWriteTextAnalyzer> analyser_;
    wchar_t language_[LOCALE_NAME_MAX_LENGTH] = {};
    buffer<wchar_t> text_;
    buffer<cluster_id> clusters_;
    buffer<DWRITE_SCRIPT_ANALYSIS> analysis_;  // of each unit
    buffer<piece> pieces_;
    buffer<DWRITE_FONT_FEATURE> features_;
    UINT32 count_ = 0;  // of the piece's glyphs
    buffer<UINT16> map_;
    buffer<DWRITE_SHAPING_TEXT_PROPERTIES> text_properties_;
    buffer<UINT16> glyphs_;
    buffer<DWRITE_SHAPING_GLYPH_PROPERTIES> glyph_properties_;
    buffer<FLOAT> advances_;
    buffer<DWRITE_GLYPH_OFFSET> offsets_;
    buffer<std::uint32_t> sources_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

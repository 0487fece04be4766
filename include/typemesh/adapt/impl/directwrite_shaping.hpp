// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_analysis.hpp>
#include <typemesh/adapt/impl/directwrite_clusters.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/impl/reading_order.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/unicode/utf.hpp>

#include <dwrite.h>
#include <dwrite_1.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

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

/// Shapes one line with one face through IDWriteTextAnalyzer: see directwrite_font::shape().
class directwrite_shaping {
public:
    error open(IDWriteFactory* factory) noexcept
    {
        return directwrite_error(factory->CreateTextAnalyzer(analyser_.put()));
    }

    result<point> shape(IDWriteFontFace* face, double units_per_em, text_view text, std::size_t first, std::size_t last,
                        const shape_options& options, glyph_run& run) noexcept
    {
        if (last - first >= std::size_t{1} << 28) return error::too_large;
        const bool vertical = options.direction == direction::top_to_bottom;
        if (error e = take_text(text, first, last, run)) return e;
        if (error e = take_language(options.language)) return e;
        if (error e = take_features(options, vertical)) return e;
        if (error e = analyse(options)) return e;
        if (error e = cut_into_pieces(vertical)) return e;
        point at;
        for (const piece& p : pieces_.view())
            if (error e = shape_piece(face, units_per_em, p, vertical, at, run)) return e;
        return at;
    }

private:
    /// DirectWrite's analysis of one 16-bit unit of the line.
    struct unit_analysis {
        DWRITE_SCRIPT_ANALYSIS script;
        UINT8 level;
    };

    /// A run of the line in one script and of one level.
    struct piece {
        std::uint32_t first;
        std::uint32_t last;
        DWRITE_SCRIPT_ANALYSIS script;
        UINT8 level;
    };

    /// The sink for the analyser's results.
    class analysis_sink final : public directwrite_sink {
    public:
        explicit analysis_sink(std::span<unit_analysis> units) noexcept : units_{units} {}
        HRESULT STDMETHODCALLTYPE SetScriptAnalysis(UINT32 at, UINT32 count,
                                                    const DWRITE_SCRIPT_ANALYSIS* script) noexcept override
        {
            for (unit_analysis& u : clipped(units_, at, count)) u.script = *script;
            return S_OK;
        }
        HRESULT STDMETHODCALLTYPE SetBidiLevel(UINT32 at, UINT32 count, UINT8, UINT8 level) noexcept override
        {
            for (unit_analysis& u : clipped(units_, at, count)) u.level = level;
            return S_OK;
        }

    private:
        std::span<unit_analysis> units_;
    };

    /// Stores the line in UTF-16 and, for each of its units, the position in the caller's text.
    error take_text(text_view text, std::size_t first, std::size_t last, glyph_run& run) noexcept
    {
        text_.clear();
        clusters_.clear();
        if (!text_.reserve(last - first) || !clusters_.reserve(last - first)) return error::out_of_memory;
        to_the_left_ = decided_ = false;
        for (std::size_t i = first; i < last;) {
            const code_point c = decode(text, i, last);
            const auto cluster = static_cast<cluster_id>(i);
            if (!c.valid) run.note_invalid_units(cluster);
            if (!decided_) {
                const reading r = reading_of(c.value);
                to_the_left_ = r == reading::to_the_left;
                decided_ = to_the_left_ || r == reading::to_the_right;
            }
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

    error take_features(const shape_options& wanted, bool vertical) noexcept
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
        return vertical ? take_feature({"vert", 1}) : error{};
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

    /// Finds the script and level of every unit.
    error analyse(const shape_options& options) noexcept
    {
        analysis_.clear();
        const auto count = static_cast<UINT32>(text_.size());
        if (count == 0) return {};
        unit_analysis* units = analysis_.append(count);
        if (units == nullptr) return error::out_of_memory;
        for (UINT32 i = 0; i < count; ++i) units[i] = {};

        const bool to_the_left = options.direction == direction::right_to_left ||
                                 (options.direction == direction::automatic && to_the_left_);
        directwrite_source source{text_.view(), language_, to_the_left};
        analysis_sink sink{analysis_.view()};
        if (error e = directwrite_error(analyser_->AnalyzeScript(&source, 0, count, &sink))) return e;
        if (options.direction != direction::top_to_bottom)
            if (error e = directwrite_error(analyser_->AnalyzeBidi(&source, 0, count, &sink))) return e;
        if (options.script.empty()) return {};
        if (options.script.size() != 4) return error::bad("script");
        const auto script = script_named(options.script);
        if (!script) return script.error();
        for (UINT32 i = 0; i < count; ++i) units[i].script.script = *script;
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

    /// Cuts the line where script or level change, and sorts the pieces into drawing order: for each level from the
    /// highest down to the lowest odd one, every run of at least that level is reversed (UAX #9, L2).
    error cut_into_pieces(bool vertical) noexcept
    {
        constexpr std::uint32_t longest = 0x4000;  // units; DirectWrite counts glyphs of a piece in 16 bits
        pieces_.clear();
        UINT8 highest = 0;
        for (std::uint32_t i = 0, end = 0; i < text_.size(); i = end) {
            const unit_analysis& u = analysis_[i];
            const UINT8 level = vertical ? UINT8{0} : u.level;
            for (end = i + 1; end < text_.size(); ++end) {
                const unit_analysis& next = analysis_[end];
                if (next.script.script != u.script.script || next.script.shapes != u.script.shapes) break;
                if (!vertical && next.level != level) break;
                const bool joint = text_[end - 1] == L' ' || end - i >= longest + 0x1000;
                const bool inside_pair = text_[end] >= 0xDC00 && text_[end] <= 0xDFFF;
                if (end - i >= longest && joint && !inside_pair) break;
            }
            if (!pieces_.push_back({i, end, u.script, level})) return error::out_of_memory;
            if (level > highest) highest = level;
        }
        for (UINT8 level = highest; level >= 1; --level) {
            for (std::size_t i = 0; i < pieces_.size();) {
                std::size_t end = i;
                while (end < pieces_.size() && pieces_[end].level >= level) ++end;
                for (std::size_t a = i, b = end; b > a + 1; ++a, --b) std::swap(pieces_[a], pieces_[b - 1]);
                i = end + 1;
            }
        }
        return {};
    }

    /// Shapes a piece and appends its glyphs, starting at `at`, which advances.
    error shape_piece(IDWriteFontFace* face, double units_per_em, const piece& p, bool vertical, point& at,
                      glyph_run& run) noexcept
    {
        const wchar_t* text = text_.data() + p.first;
        const UINT32 length = p.last - p.first;
        const BOOL to_the_left = (p.level & 1) != 0 ? TRUE : FALSE;
        const wchar_t* language = language_[0] != L'\0' ? language_ : nullptr;
        DWRITE_TYPOGRAPHIC_FEATURES list = {features_.data(), static_cast<UINT32>(features_.size())};
        const DWRITE_TYPOGRAPHIC_FEATURES* lists[] = {&list};
        const UINT32 ranges = features_.empty() ? 0 : 1;
        const DWRITE_TYPOGRAPHIC_FEATURES** given = ranges != 0 ? lists : nullptr;

        map_.clear();
        text_properties_.clear();
        if (map_.append(length) == nullptr || text_properties_.append(length) == nullptr) return error::out_of_memory;
        UINT32 count = 0;
        for (UINT32 room = length + length / 2 + 16;; room = 2 * room < 0xFFFF ? 2 * room : 0xFFFF) {
            glyphs_.clear();
            glyph_properties_.clear();
            if (glyphs_.append(room) == nullptr || glyph_properties_.append(room) == nullptr)
                return error::out_of_memory;
            const HRESULT code = analyser_->GetGlyphs(
                text, length, face, FALSE, to_the_left, &p.script, language, nullptr, given, &length, ranges, room,
                map_.data(), text_properties_.data(), glyphs_.data(), glyph_properties_.data(), &count);
            constexpr auto too_little_room = static_cast<HRESULT>(0x8007'007Au);  // ERROR_INSUFFICIENT_BUFFER
            if (code == too_little_room && room < 0xFFFF) continue;
            if (error e = directwrite_error(code)) return e;
            break;
        }
        advances_.clear();
        offsets_.clear();
        if (count == 0) return {};
        if (advances_.append(count) == nullptr || offsets_.append(count) == nullptr) return error::out_of_memory;
        if (error e = directwrite_error(analyser_->GetGlyphPlacements(
                text, map_.data(), text_properties_.data(), length, glyphs_.data(), glyph_properties_.data(), count,
                face, static_cast<FLOAT>(units_per_em), FALSE, to_the_left, &p.script, language, given, &length, ranges,
                advances_.data(), offsets_.data())))
            return e;
        return take_glyphs(face, p, count, vertical, at, run);
    }

    /// Appends the glyphs of a piece in drawing order: DirectWrite's own, reversed for right-to-left text.
    error take_glyphs(IDWriteFontFace* face, const piece& p, UINT32 count, bool vertical, point& at,
                      glyph_run& run) noexcept
    {
        if (sources_.size() < count && sources_.append(count - sources_.size()) == nullptr) return error::out_of_memory;
        invert_cluster_map({map_.data(), map_.size()}, {sources_.data(), count});
        if (!run.glyphs.reserve(run.glyphs.size() + count)) return error::out_of_memory;
        const bool to_the_left = (p.level & 1) != 0;
        for (UINT32 k = 0; k < count; ++k) {
            const UINT32 i = to_the_left ? count - 1 - k : k;
            const std::uint32_t unit = p.first + sources_[i];
            const cluster_id cluster = clusters_[unit];
            const double advance = double{advances_[i]}, along = double{offsets_[i].advanceOffset};
            point origin{at.x + (to_the_left ? -along : along), at.y + double{offsets_[i].ascenderOffset}};
            if (vertical) {
                DWRITE_GLYPH_METRICS m = {};
                if (error e = directwrite_error(face->GetDesignGlyphMetrics(&glyphs_[i], 1, &m, FALSE))) return e;
                const double width = m.advanceWidth, top = m.verticalOriginY;
                origin = origin - point{width / 2, top};
                at.y -= static_cast<double>(m.advanceHeight);
            } else {
                at.x += advance;
            }
            const bool missing = glyphs_[i] == 0;
            if (missing && draws_nothing(text_[unit])) continue;
            run.glyphs.push_back_unchecked({glyphs_[i], cluster, origin, missing});
            if (missing) run.note_missing(cluster);
        }
        return {};
    }

    com_ptr<IDWriteTextAnalyzer> analyser_;
    bool to_the_left_ = false, decided_ = false;  // from the line's first letter
    wchar_t language_[LOCALE_NAME_MAX_LENGTH] = {};
    buffer<wchar_t> text_;
    buffer<cluster_id> clusters_;
    buffer<unit_analysis> analysis_;
    buffer<piece> pieces_;
    buffer<DWRITE_FONT_FEATURE> features_;
    buffer<UINT16> map_;
    buffer<DWRITE_SHAPING_TEXT_PROPERTIES> text_properties_;
    buffer<UINT16> glyphs_;
    buffer<DWRITE_SHAPING_GLYPH_PROPERTIES> glyph_properties_;
    buffer<FLOAT> advances_;
    buffer<DWRITE_GLYPH_OFFSET> offsets_;
    buffer<std::uint32_t> sources_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/fontconfig.hpp>
#include <typemesh/layout/fallback_provider.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A fallback_provider of the installed fonts, opened when they are first needed:
///
///     fontconfig_fallback<harfbuzz_font> installed{*fonts, "Noto Sans:bold"};
///     font_list list{*font, installed};
///
/// It uses the first font that has the grapheme. fontconfig sorts the fonts for the language, or for a language of the
/// script, and by their resemblance to a family and style. Bitmap and colour fonts are skipped. `Font` has an
/// open(path, font_options) like harfbuzz_font's. Not copyable; used by one thread at a time.
template <class Font>
class fontconfig_fallback {
public:
    /// `like` may be empty. The fonts must outlive this object.
    explicit fontconfig_fallback(fontconfig_fonts& fonts, const char* like = "") noexcept
        : fonts_{&fonts}, like_{FcNameParse(bytes(like))}, nowhere_{FcCharSetCreate()}
    {
    }
    fontconfig_fallback(const fontconfig_fallback&) = delete;
    fontconfig_fallback& operator=(const fontconfig_fallback&) = delete;
    ~fontconfig_fallback()
    {
        while (opened_ != nullptr) delete std::exchange(opened_, opened_->next);
        while (orders_ != nullptr) {
            FcFontSetDestroy(orders_->set);
            delete std::exchange(orders_, orders_->next);
        }
        FcCharSetDestroy(nowhere_);
    }

    /// See fallback_provider. A font that cannot be opened is skipped.
    ///
    /// Fails  error::out_of_memory
    /// Cost   a few milliseconds for the first grapheme of a language, which sorts the fonts; then some nanoseconds for
    ///        each font that lacks it
    result<Font*> font_for(text_view text, text_range grapheme, std::uint32_t script,
                           std::string_view language) noexcept
    {
        if (like_.get() == nullptr || nowhere_ == nullptr) return error::out_of_memory;
        if (!all_in(text, grapheme, nowhere_, false)) return nullptr;
        char tag[24];
        write_language(script, language, tag);
        const order* sorted = order_for(tag);
        if (sorted == nullptr) return error::out_of_memory;
        for (int i = 0; i < sorted->set->nfont; ++i) {
            FcPattern* p = sorted->set->fonts[i];
            FcCharSet* has = nullptr;
            if (FcPatternGetCharSet(p, FC_CHARSET, 0, &has) != FcResultMatch || !all_in(text, grapheme, has, true))
                continue;
            if (!is_usable(p)) continue;
            const result<Font*> found = open(p);
            if (!found || *found != nullptr) return found;
        }
        note_missing(text, grapheme);
        return nullptr;
    }

private:
    /// A font that was opened, or could not be opened.
    struct opened_font {
        const FcPattern* pattern;
        std::optional<Font> font;
        opened_font* next;
    };
    /// All fonts, sorted for a language, the best one first.
    struct order {
        char language[24];
        FcFontSet* set;
        order* next;
    };

    static const FcChar8* bytes(const char* text) noexcept
    {
        return static_cast<const FcChar8*>(static_cast<const void*>(text));
    }

    /// Whether all drawn characters are in the set (`in`), or all are not.
    static bool all_in(text_view text, text_range range, const FcCharSet* set, bool in) noexcept
    {
        for (std::size_t i = range.first; i < range.last;) {
            const code_point c = decode(text, i, range.last);
            if (!is_default_ignorable(c.value) && (FcCharSetHasChar(set, c.value) != FcFalse) != in) return false;
            i = c.next;
        }
        return true;
    }

    /// Remembers a character that no font has, so that its next occurrence costs nothing.
    void note_missing(text_view text, text_range range) noexcept
    {
        const code_point c = decode(text, range.first, range.last);
        if (c.next == range.last)  // of several characters, each may be in some font
            FcCharSetAddChar(nowhere_, c.value);
    }

    static bool is_usable(const FcPattern* p) noexcept
    {
        FcBool scalable = FcFalse, colour = FcFalse;
        int index = 0;
        FcPatternGetBool(p, FC_SCALABLE, 0, &scalable);
        FcPatternGetBool(p, FC_COLOR, 0, &colour);
        FcPatternGetInteger(p, FC_INDEX, 0, &index);
        const int instance = index >> 16;  // the variable font itself gives access to its instances
        return scalable != FcFalse && colour == FcFalse && (instance == 0 || instance == 0x8000);
    }

    /// Null for a font that cannot be opened.
    result<Font*> open(FcPattern* p) noexcept
    {
        for (opened_font* o = opened_; o != nullptr; o = o->next)
            if (o->pattern == p) return o->font ? &*o->font : nullptr;
        installed_font where;
        const detail::fontconfig_pattern match{FcFontRenderPrepare(fonts_->handle(), like_.get(), p)};
        if (match.get() == nullptr) return error::out_of_memory;
        const error e = where.take(match.get());
        if (e == error::out_of_memory) return e;
        std::optional<Font> opened;
        if (!e) {
            auto font = Font::open(where.path(), where.options());
            if (font)
                opened.emplace(std::move(*font));
            else if (font.error() == error::out_of_memory)
                return font.error();  // the next attempt may open it
        }
        auto* made = new (std::nothrow) opened_font{p, std::move(opened), opened_};
        if (made == nullptr) return error::out_of_memory;
        opened_ = made;
        if (!made->font) return nullptr;
        return &*made->font;
    }

    const order* order_for(const char* language) noexcept
    {
        for (const order* o = orders_; o != nullptr; o = o->next)
            if (std::strcmp(o->language, language) == 0) return o;
        const detail::fontconfig_pattern asked{FcPatternDuplicate(like_.get())};
        if (asked.get() == nullptr) return nullptr;
        if (*language != '\0') FcPatternAddString(asked.get(), FC_LANG, bytes(language));
        FcPatternAddBool(asked.get(), FC_SCALABLE, FcTrue);
        FcConfigSubstitute(fonts_->handle(), asked.get(), FcMatchPattern);
        FcDefaultSubstitute(asked.get());
        FcResult result = FcResultNoMatch;
        FcFontSet* set = FcFontSort(fonts_->handle(), asked.get(), FcFalse, nullptr, &result);
        if (set == nullptr) set = FcFontSetCreate();  // there is no font at all
        if (set == nullptr) return nullptr;
        auto* made = new (std::nothrow) order{{}, set, orders_};
        if (made == nullptr) {
            FcFontSetDestroy(set);
            return nullptr;
        }
        std::strcpy(made->language, language);
        return orders_ = made;
    }

    /// The language in fontconfig's notation; if none is given, a language that uses the script.
    static void write_language(std::uint32_t script, std::string_view language, char (&out)[24]) noexcept
    {
        struct script_language {
            std::uint32_t script;
            std::string_view language;
        };
        static constexpr script_language known[] = {
            {script_tag("Arab"), "ar"}, {script_tag("Armn"), "hy"}, {script_tag("Beng"), "bn"},
            {script_tag("Cyrl"), "ru"}, {script_tag("Deva"), "hi"}, {script_tag("Ethi"), "am"},
            {script_tag("Geor"), "ka"}, {script_tag("Grek"), "el"}, {script_tag("Gujr"), "gu"},
            {script_tag("Guru"), "pa"}, {script_tag("Hang"), "ko"}, {script_tag("Hani"), "zh-cn"},
            {script_tag("Hebr"), "he"}, {script_tag("Hira"), "ja"}, {script_tag("Kana"), "ja"},
            {script_tag("Khmr"), "km"}, {script_tag("Knda"), "kn"}, {script_tag("Laoo"), "lo"},
            {script_tag("Mlym"), "ml"}, {script_tag("Mymr"), "my"}, {script_tag("Orya"), "or"},
            {script_tag("Sinh"), "si"}, {script_tag("Taml"), "ta"}, {script_tag("Telu"), "te"},
            {script_tag("Thaa"), "dv"}, {script_tag("Thai"), "th"}, {script_tag("Tibt"), "bo"},
        };
        if (language.empty())
            for (const script_language& k : known)
                if (k.script == script) language = k.language;
        if (language.substr(0, 7) == "zh-Hant") language = "zh-tw";
        if (language.substr(0, 7) == "zh-Hans") language = "zh-cn";
        if (language.size() >= sizeof out) language = {};
        language.copy(out, language.size());
        out[language.size()] = '\0';
    }

    fontconfig_fonts* fonts_;
    detail::fontconfig_pattern like_;
    FcCharSet* nowhere_;  // characters that no font has
    opened_font* opened_ = nullptr;
    order* orders_ = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI

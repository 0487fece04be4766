// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/font_options.hpp>
#include <typemesh/unicode/script.hpp>

#include <fontconfig/fontconfig.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A pattern of fontconfig, which lives as long as this object.
class fontconfig_pattern {
public:
    explicit fontconfig_pattern(FcPattern* owned) noexcept : pattern_{owned} {}
    fontconfig_pattern(const fontconfig_pattern&) = delete;
    fontconfig_pattern& operator=(const fontconfig_pattern&) = delete;
    ~fontconfig_pattern()
    {
        if (pattern_ != nullptr) FcPatternDestroy(pattern_);
    }
    [[nodiscard]] FcPattern* get() const noexcept { return pattern_; }

private:
    FcPattern* pattern_;
};

/// The n-th word of a property, null if there is none.
[[nodiscard]] inline const FcChar8* fontconfig_word(const FcPattern* of, const char* property, int n = 0) noexcept
{
    FcChar8* found = nullptr;
    return FcPatternGetString(of, property, n, &found) == FcResultMatch ? found : nullptr;
}

[[nodiscard]] inline bool fontconfig_has(const FcPattern* of, const char* property, const FcChar8* word) noexcept
{
    for (int n = 0;; ++n) {
        const FcChar8* own = fontconfig_word(of, property, n);
        if (own == nullptr) return false;
        if (FcStrCmpIgnoreCase(own, word) == 0) return true;
    }
}

}  // namespace detail

/// Which families a name may find.
enum class family_names : std::uint8_t {
    own,      ///< only families with this name
    aliases,  ///< also the configuration's replacements for families that are not installed (Liberation Sans for
              ///< Arial), and the generic names: "sans-serif", "monospace"
};

/// The path of an installed font, and the face in the file.
class installed_font {
public:
    explicit installed_font(memory source = heap()) noexcept : path_{source}, family_{source}, variations_{source} {}

    /// Empty before a font has been found.
    [[nodiscard]] const char* path() const noexcept { return path_.empty() ? "" : path_.data(); }
    /// The name of the font's family, as the font gives it.
    [[nodiscard]] const char* family() const noexcept { return family_.empty() ? "" : family_.data(); }
    /// The options for opening the font. They refer to this object.
    [[nodiscard]] font_options options() const noexcept { return {face_, variations_.view()}; }
    /// The number, from 1, of a named instance of a variable font, if fontconfig does not know its axis values;
    /// otherwise 0.
    [[nodiscard]] std::uint32_t named_instance() const noexcept { return instance_; }

    /// Reads a pattern that fontconfig has matched. Fails with error::out_of_memory.
    error take(const FcPattern* match) noexcept
    {
        path_.clear();
        family_.clear();
        variations_.clear();
        const auto* file = static_cast<const char*>(static_cast<const void*>(detail::fontconfig_word(match, FC_FILE)));
        if (file == nullptr) return error::no_such_family;
        if (!path_.append({file, std::strlen(file) + 1})) return error::out_of_memory;
        const void* name = detail::fontconfig_word(match, FC_FAMILY);
        const char* const family = name != nullptr ? static_cast<const char*>(name) : "";
        if (!family_.append({family, std::strlen(family) + 1})) return error::out_of_memory;
        int index = 0;
        FcPatternGetInteger(match, FC_INDEX, 0, &index);
        face_ = static_cast<std::uint32_t>(index) & 0xFFFFu;
        const void* axes = detail::fontconfig_word(match, FC_FONT_VARIATIONS);
        if (error e = take_variations(static_cast<const char*>(axes))) return e;
        instance_ = static_cast<std::uint32_t>(index) >> 16;
        if (!variations_.empty() || instance_ == 0x8000u) instance_ = 0;  // 0x8000: the variable font itself
        return {};
    }

private:
    /// "wght=700,wdth=75"
    error take_variations(const char* written) noexcept
    {
        while (written != nullptr && std::strlen(written) > 5 && written[4] == '=') {
            variation v;
            std::memcpy(v.tag, written, 4);
            v.value = std::strtof(written + 5, nullptr);
            if (!variations_.push_back(v)) return error::out_of_memory;
            written = std::strchr(written, ',');
            if (written != nullptr) ++written;
        }
        return {};
    }

    buffer<char> path_;
    buffer<char> family_;
    buffer<variation> variations_;
    std::uint32_t face_ = 0, instance_ = 0;
};

/// The installed fonts, as fontconfig knows them. It allocates from its own heap.
///
///     auto fonts = fontconfig_fonts::open();
///     installed_font found;
///     if (auto match = fonts->find("Noto Sans:bold", found); !match) ...
///     auto font = harfbuzz_font::open(found.path(), found.options());
///
/// Move-only. Used by one thread at a time.
class fontconfig_fonts {
public:
    /// Reads the configuration and the lists of fonts: tens of milliseconds. Fails with error::font_library_failed:
    /// there is no configuration, or it is out of memory.
    static result<fontconfig_fonts> open() noexcept
    {
        FcConfig* made = FcInitLoadConfigAndFonts();
        if (made == nullptr) return error::font_library_failed;
        return fontconfig_fonts{made};
    }
    fontconfig_fonts(fontconfig_fonts&& other) noexcept : config_{std::exchange(other.config_, nullptr)} {}
    fontconfig_fonts& operator=(fontconfig_fonts&& other) noexcept
    {
        std::swap(config_, other.config_);
        return *this;
    }
    ~fontconfig_fonts()
    {
        if (config_ != nullptr) FcConfigDestroy(config_);
    }

    /// The configuration itself, for your own calls; this object owns it.
    [[nodiscard]] FcConfig* handle() const noexcept { return config_; }

    /// Finds a font by its family and style, in fontconfig's notation: "Noto Sans", "Noto Sans:bold:italic",
    /// "Inter:style=Semi Bold". Only scalable fonts are found, and never a font that is merely similar. `names` says
    /// whether other families may replace the name; installed_font::family() returns the family found.
    ///
    /// Fails  error::no_such_family; error::no_such_style: the family has no font of this style, and `option` names the
    ///        difference: weight, width, slant or style; error::bad_option: the name cannot be read;
    ///        error::out_of_memory
    result<void> find(const char* name, installed_font& out, family_names names = family_names::own) const noexcept
    {
        const void* words = name;
        const detail::fontconfig_pattern asked{FcNameParse(static_cast<const FcChar8*>(words))};
        const FcChar8* family = asked.get() != nullptr ? detail::fontconfig_word(asked.get(), FC_FAMILY) : nullptr;
        if (family == nullptr) return error::bad("name");
        const detail::fontconfig_pattern complete{FcPatternDuplicate(asked.get())};
        if (complete.get() == nullptr) return error::out_of_memory;
        FcPatternAddBool(complete.get(), FC_SCALABLE, FcTrue);
        FcConfigSubstitute(config_, complete.get(), FcMatchPattern);
        FcDefaultSubstitute(complete.get());
        FcResult result = FcResultNoMatch;
        const detail::fontconfig_pattern match{FcFontMatch(config_, complete.get(), &result)};
        if (match.get() == nullptr) return error::no_such_family;
        if (!detail::fontconfig_has(match.get(), FC_FAMILY, family) &&
            (names == family_names::own || !(is_generic(family) || stands_in(complete.get(), match.get()))))
            return error::no_such_family;
        if (const char* lacks = style_not_found(asked.get(), match.get())) {
            error e = error::no_such_style;
            e.option = lacks;
            return e;
        }
        return out.take(match.get());
    }

private:
    explicit fontconfig_fonts(FcConfig* owned) noexcept : config_{owned} {}

    static bool is_generic(const FcChar8* family) noexcept
    {
        for (const char* const name : {"serif", "sans-serif", "sans", "sans serif", "monospace", "mono", "cursive",
                                       "fantasy", "system-ui", "math", "emoji"}) {
            const void* const word = name;
            if (FcStrCmpIgnoreCase(family, static_cast<const FcChar8*>(word)) == 0) return true;
        }
        return false;
    }

    /// Whether the configuration declares the match's family a full substitute for the requested name. A strong or
    /// same binding does that; a weak one, which fallback families have, does not.
    static bool stands_in(FcPattern* complete, const FcPattern* match) noexcept
    {
        FcValue value;
        FcValueBinding binding = FcValueBindingWeak;
        for (int n = 0; FcPatternGetWithBinding(complete, FC_FAMILY, n, &value, &binding) == FcResultMatch; ++n)
            if (binding != FcValueBindingWeak && value.type == FcTypeString &&
                detail::fontconfig_has(match, FC_FAMILY, value.u.s))
                return true;
        return false;
    }

    /// The requested property that the match lacks, because fontconfig returns the nearest font; otherwise null.
    static const char* style_not_found(const FcPattern* asked, const FcPattern* match) noexcept
    {
        if (const FcChar8* style = detail::fontconfig_word(asked, FC_STYLE))
            return detail::fontconfig_has(match, FC_STYLE, style) ? nullptr : FC_STYLE;
        for (const char* what : {FC_WEIGHT, FC_WIDTH, FC_SLANT}) {
            double wanted = 0.0, found = 0.0;
            if (FcPatternGetDouble(asked, what, 0, &wanted) != FcResultMatch ||
                FcPatternGetDouble(match, what, 0, &found) != FcResultMatch)
                continue;
            const bool slant = std::string_view{what} == FC_SLANT;  // oblique counts as italic
            const double apart = wanted < found ? found - wanted : wanted - found;
            if (slant ? (wanted > 0.0) != (found > 0.0) : apart > 5.0) return what;  // book counts as regular
        }
        return nullptr;
    }

    FcConfig* config_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/fallback_provider.hpp>
#include <typemesh/layout/fallback_shaping.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/text/font_faces.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Fonts of one type, which must outlive it, and the provider that finds more.
template <class Font, class Provider>
class listed_fonts {
public:
    /// Adds a font, which must outlive the list, and returns its face number. Fails with error::out_of_memory, or
    /// error::too_large at 65,535 fonts.
    result<std::uint32_t> add(Font& font) noexcept
    {
        if (face_count() >= fallback_shaping::no_face) return error::too_large;
        if (!others_.push_back(&font)) return error::out_of_memory;
        return face_count() - 1;
    }

    [[nodiscard]] std::uint32_t face_count() const noexcept { return static_cast<std::uint32_t>(others_.size()) + 1; }
    /// face < face_count()
    [[nodiscard]] Font& font(std::uint32_t face) const noexcept { return face == 0 ? *first_ : *others_[face - 1]; }

    /// See fallback_shaping: the provider finds a font, which is added to the list.
    result<std::uint32_t> find(text_view text, text_range grapheme, std::uint32_t script,
                               std::string_view language) noexcept
        requires(!std::same_as<Provider, no_fallback<Font>>)
    {
        const result<Font*> found = provider_->font_for(text, grapheme, script, language);
        if (!found) return found.error();
        if (*found == nullptr) return fallback_shaping::no_face;
        for (std::uint32_t face = 0; face < face_count(); ++face)
            if (&font(face) == *found) return face;
        return add(**found);
    }

protected:
    using first_type = Font;

    listed_fonts(Font& first, Provider* provider, memory source) noexcept
        : first_{&first}, provider_{provider}, others_{source}
    {
    }

    [[nodiscard]] Font& first() const noexcept { return *first_; }
    template <class What>
    void call(std::uint32_t face, const What& what) const noexcept
    {
        if (face < face_count()) what(font(face));
    }
    template <class What>
    [[nodiscard]] bool any(const What& what) const noexcept
    {
        for (std::uint32_t face = 0; face < face_count(); ++face)
            if (what(font(face))) return true;
        return false;
    }

private:
    Font* first_;
    Provider* provider_;
    buffer<Font*> others_;
};

}  // namespace detail

/// A font_cascade of fonts of one type, whose number is known only at run time. An optional provider finds fonts for
/// text that none of them supports: see fallback_provider.hpp.
///
///     font_list fonts{latin};                    // or {latin, provider}: both must outlive it
///     if (auto face = fonts.add(arabic); !face) return face.error();
///
/// Fonts that the provider finds are added after the others, in the order in which texts need them, and stay in the
/// list: the next text tries them before it queries the provider. A shaped run must therefore be drawn by the list that
/// shaped it. The lists of glyph_workers have no provider, because each list would number the added fonts differently.
///
/// Move-only. Used by one thread at a time.
template <outline_source Font, fallback_provider<Font> Provider = no_fallback<Font>>
    requires shaper<Font>
class font_list : public detail::numbered_faces<detail::listed_fonts<Font, Provider>> {
    using faces = detail::numbered_faces<detail::listed_fonts<Font, Provider>>;
    static_assert(!face_source<Font>, "typemesh: a font_list needs fonts of one face each");

public:
    explicit font_list(Font& first, memory source = heap()) noexcept
        requires std::same_as<Provider, no_fallback<Font>>
        : faces{first, nullptr, source}, shaping_{source}
    {
    }
    font_list(Font& first, Provider& provider, memory source = heap()) noexcept
        : faces{first, &provider, source}, shaping_{source}
    {
    }

    /// See shaper. Also fails as the provider does.
    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        faces& all = *this;
        return shaping_.shape(all, text, item, options, glyphs);
    }

private:
    fallback_shaping shaping_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

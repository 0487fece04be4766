// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/fallback_provider.hpp>
#include <typemesh/layout/fallback_shaping.hpp>
#include <typemesh/layout/item_shaper.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/text/font_faces.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// A font_cascade of fonts of one type, whose number is known only at run time. What none of them has a provider finds,
/// if there is one: see fallback_provider.hpp.
///
///     font_list fonts{latin};                    // or {latin, provider}: both must outlive it
///     if (auto face = fonts.add(arabic); !face) return face.error();
///
/// Fonts that the provider finds are added behind the others, in the order in which a text asks for them, and stay: the
/// next text is given to them before the provider is asked. So a run that is shaped must be drawn by the list that has
/// shaped it, and glyph_workers, whose lists would number such fonts each in its own way, do without a provider.
///
/// Move-only. Used by one thread at a time.
template <outline_source Font, fallback_provider<Font> Provider = no_fallback<Font>>
    requires item_shaper<Font> && shaper<Font>
class font_list {
    static_assert(!face_source<Font>, "typemesh: a font_list takes fonts of one face each");

public:
    explicit font_list(Font& first, memory source = heap()) noexcept
        requires std::same_as<Provider, no_fallback<Font>>
        : fonts_{first, nullptr, source}, shaping_{source}
    {
    }
    font_list(Font& first, Provider& provider, memory source = heap()) noexcept
        : fonts_{first, &provider, source}, shaping_{source}
    {
    }

    /// Adds a font, which must outlive the list; its number as a face. Fails with error::out_of_memory, or
    /// error::too_large at 65,535 fonts.
    result<std::uint32_t> add(Font& font) noexcept { return fonts_.add(font); }

    [[nodiscard]] std::uint32_t face_count() const noexcept { return fonts_.face_count(); }
    /// face < face_count()
    [[nodiscard]] Font& font(std::uint32_t face) const noexcept { return fonts_.font(face); }

    [[nodiscard]] double units_per_em() const noexcept { return font(0).units_per_em(); }
    [[nodiscard]] double units_per_em(std::uint32_t face) const noexcept { return font(face).units_per_em(); }
    [[nodiscard]] fill_rule fill() const noexcept { return font(0).fill(); }
    [[nodiscard]] fill_rule fill(std::uint32_t face) const noexcept { return font(face).fill(); }
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return variation_of(font(0)); }
    [[nodiscard]] std::uint64_t variation_key(std::uint32_t face) const noexcept { return variation_of(font(face)); }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) const noexcept
    {
        return font(0).outline(id, sink);
    }
    template <outline_sink Sink>
    error outline(std::uint32_t face, glyph_id id, Sink& sink) const noexcept
    {
        return font(face).outline(id, sink);
    }
    [[nodiscard]] line_metrics metrics(direction d) const noexcept { return font(0).metrics(d); }

    /// What one font says of lines, bars and carets, in units of the first: see face_metrics.hpp, ligature_carets.hpp.
    [[nodiscard]] line_metrics metrics(direction d, std::uint32_t face) const noexcept
    {
        return scaled(font(face).metrics(d), units_per_em() / units_per_em(face));
    }
    [[nodiscard]] face_metrics suggested_metrics(std::uint32_t face) const noexcept
    {
        return face_metrics_of(font(face), 0);
    }
    error ligature_carets(std::uint32_t face, glyph_id id, bool down, buffer<double>& carets) const noexcept
        requires knows_ligature_carets<Font>
    {
        const std::size_t before = carets.size();
        const error e = font(face).ligature_carets(0, id, down, carets);
        for (double& place : carets.view().subspan(before)) place *= units_per_em() / units_per_em(face);
        return e;
    }

    /// See shaper and item_shaper. Fails also as the provider does.
    result<point> shape(text_view text, std::size_t first, std::size_t last, const shape_options& options,
                        glyph_run& run) noexcept
    {
        return shaping_.shape(fonts_, text, first, last, options, run);
    }
    error shape_item(text_view text, const text_item& item, const shape_options& options,
                     buffer<shaped_glyph>& glyphs) noexcept
    {
        return shaping_.shape_item(fonts_, text, item, options, glyphs);
    }
    [[nodiscard]] bool has_vertical_form(char32_t c) noexcept { return fonts_.has_vertical_form(c); }
    [[nodiscard]] double column_middle() noexcept { return fonts_.column_middle(); }

private:
    /// What fallback_shaping asks.
    class faces {
    public:
        faces(Font& first, Provider* provider, memory source) noexcept
            : first_{&first}, provider_{provider}, others_{source}
        {
        }

        [[nodiscard]] std::uint32_t face_count() const noexcept
        {
            return static_cast<std::uint32_t>(others_.size()) + 1;
        }
        [[nodiscard]] Font& font(std::uint32_t face) const noexcept { return face == 0 ? *first_ : *others_[face - 1]; }

        result<std::uint32_t> add(Font& font) noexcept
        {
            if (face_count() >= fallback_shaping::no_face) return error::too_large;
            if (!others_.push_back(&font)) return error::out_of_memory;
            return face_count() - 1;
        }

        result<point> shape(text_view text, std::size_t begin, std::size_t end, const shape_options& options,
                            glyph_run& run) noexcept
        {
            return first_->shape(text, begin, end, options, run);
        }
        error shape_item(text_view text, const text_item& item, const shape_options& options,
                         buffer<shaped_glyph>& glyphs) noexcept
        {
            if (item.face >= face_count()) return {error::no_such_face, face_count()};
            const std::size_t before = glyphs.size();
            if (error e = font(item.face).shape_item(text, item, options, glyphs)) return e;
            const double unit = first_->units_per_em() / font(item.face).units_per_em();
            if (item.face != 0) detail::belong_to(glyphs.view().subspan(before), item.face, unit);
            return {};
        }

        [[nodiscard]] double units_per_em() const noexcept { return first_->units_per_em(); }
        [[nodiscard]] double column_middle() noexcept { return column_middle_of(*first_); }
        [[nodiscard]] bool has_vertical_form(char32_t c) noexcept
        {
            for (std::uint32_t face = 0; face < face_count(); ++face)
                if (vertical_form_of(font(face), c)) return true;
            return false;
        }

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

    private:
        Font* first_;
        Provider* provider_;
        buffer<Font*> others_;
    };

    faces fonts_;
    fallback_shaping shaping_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

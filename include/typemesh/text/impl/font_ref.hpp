// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/shaper_ref.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to an outline_source of any type, which must outlive it: to its faces, and to its shaper if it is one. One
/// indirect call records a glyph or shapes a line.
class font_ref {
public:
    font_ref() noexcept = default;  ///< to none
    template <outline_source Font>
    font_ref(Font& font) noexcept : font_{const_cast<std::remove_const_t<Font>*>(&font)}, does_{&table<Font>::of}
    {
    }

    /// Whether it refers to a font; all other functions require this.
    [[nodiscard]] explicit operator bool() const noexcept { return does_ != nullptr; }

    [[nodiscard]] double units_per_em() const noexcept { return does_->units_per_em(font_, bar_face); }

    /// For one face: face < face_count(), or bar_face.
    [[nodiscard]] double units_per_em(std::uint32_t face) const noexcept { return does_->units_per_em(font_, face); }
    [[nodiscard]] std::uint32_t face_count() const noexcept { return does_->face_count(font_); }

    /// Records a glyph of a face, of no more than `most` curves, with its fill rule. Fails as record() does
    error record(std::uint32_t face, glyph_id id, outline& out, std::uint32_t most) const noexcept
    {
        return does_->record(font_, face, id, out, most);
    }

    /// See variation_of().
    [[nodiscard]] std::uint64_t variation() const noexcept { return does_->variation(font_, whole); }
    [[nodiscard]] std::uint64_t variation(std::uint32_t face) const noexcept { return does_->variation(font_, face); }

    [[nodiscard]] bool is_shaper() const noexcept { return does_->shaping != nullptr; }
    /// Needs is_shaper().
    [[nodiscard]] shaper_ref shaper() const noexcept { return {font_, *does_->shaping}; }

    /// Whether both refer to fonts of the same type.
    [[nodiscard]] bool is_like(const font_ref& other) const noexcept { return does_ == other.does_; }

private:
    static constexpr std::uint32_t whole = 0xFFFF'FFFEu;  // the whole source, not one of its faces

    struct calls {
        double (*units_per_em)(void* font, std::uint32_t face) noexcept;
        std::uint32_t (*face_count)(void* font) noexcept;
        error (*record)(void* font, std::uint32_t face, glyph_id id, outline& out, std::uint32_t most) noexcept;
        std::uint64_t (*variation)(const void* font, std::uint32_t face) noexcept;
        const shaper_ref::calls* shaping;
    };
    template <class Font>
    static constexpr const shaper_ref::calls* shaping_of() noexcept
    {
        if constexpr (typemesh::shaper<Font>)
            return &shaper_ref::table<Font>::of;
        else
            return nullptr;
    }
    template <outline_source Font>
    struct table {
        static const calls of;
    };

    void* font_ = nullptr;
    const calls* does_ = nullptr;
};

template <outline_source Font>
constinit const font_ref::calls font_ref::table<Font>::of = {
    [](void* font, std::uint32_t face) noexcept { return units_per_em_of(*static_cast<Font*>(font), face); },
    [](void* font) noexcept { return face_count_of(*static_cast<Font*>(font)); },
    [](void* font, std::uint32_t face, glyph_id id, outline& out, std::uint32_t most) noexcept {
        Font& from = *static_cast<Font*>(font);
        outline_recorder recorder{out, most};
        if (error e = outline_of(from, face, id, recorder)) return e;
        out.rule = fill_of(from, face);
        return recorder.finish();
    },
    [](const void* font, std::uint32_t face) noexcept {
        const Font& from = *static_cast<const Font*>(font);
        return face == whole ? variation_of(from) : variation_of(from, face);
    },
    shaping_of<Font>()};

/// One face of a font, its outlines mapped, in units that the caller chooses. The map must outlive it.
struct drawn_face {
    font_ref font;
    std::uint32_t face = 0;
    const affine* map = nullptr;  ///< null: outlines are not mapped
    double units = 0.0;

    [[nodiscard]] double units_per_em() const noexcept { return units; }
};

/// Records one of its glyphs: outline_source's record(), mapped.
inline result<void> record(drawn_face& from, glyph_id id, outline& out, std::uint32_t most = 0xFFFF'FFFFu) noexcept
{
    if (error e = from.font.record(from.face, id, out, most)) return e;
    return from.map == nullptr ? error{} : map_outline(*from.map, out);
}

}  // namespace typemesh::inline TYPEMESH_ABI

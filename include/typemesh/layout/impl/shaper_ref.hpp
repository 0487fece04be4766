// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/shaper.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to a shaper of any type, which must outlive it. It is itself a shaper of several faces, see face_metrics.hpp.
/// An item costs one indirect call.
class shaper_ref {
public:
    /// One table for each type of shaper.
    struct calls {
        double (*units_per_em)(void* shaper) noexcept;
        std::uint32_t (*face_count)(const void* shaper) noexcept;
        line_metrics (*metrics)(void* shaper, direction d, std::uint32_t face) noexcept;
        face_metrics (*suggested_metrics)(const void* shaper, std::uint32_t face) noexcept;
        bool (*has_vertical_form)(void* shaper, char32_t c) noexcept;
        double (*column_middle)(void* shaper) noexcept;
        error (*shape)(void* shaper, text_view text, const text_item& item, const shape_options& how,
                       buffer<shaped_glyph>& glyphs) noexcept;
    };
    template <shaper Shaper>
    struct table {
        static const calls of;
    };

    shaper_ref(void* shaper, const calls& does) noexcept : shaper_{shaper}, does_{&does} {}

    [[nodiscard]] double units_per_em() const noexcept { return does_->units_per_em(shaper_); }
    [[nodiscard]] std::uint32_t face_count() const noexcept { return does_->face_count(shaper_); }
    [[nodiscard]] line_metrics metrics(direction d, std::uint32_t face = 0) const noexcept
    {
        return does_->metrics(shaper_, d, face);
    }
    [[nodiscard]] face_metrics suggested_metrics(std::uint32_t face) const noexcept
    {
        return does_->suggested_metrics(shaper_, face);
    }
    [[nodiscard]] bool has_vertical_form(char32_t c) const noexcept { return does_->has_vertical_form(shaper_, c); }
    [[nodiscard]] double column_middle() const noexcept { return does_->column_middle(shaper_); }
    error shape(text_view text, const text_item& item, const shape_options& how,
                buffer<shaped_glyph>& glyphs) const noexcept
    {
        return does_->shape(shaper_, text, item, how, glyphs);
    }

private:
    void* shaper_;
    const calls* does_;
};

template <shaper Shaper>
constinit const shaper_ref::calls shaper_ref::table<Shaper>::of = {
    [](void* shaper) noexcept -> double { return static_cast<Shaper*>(shaper)->units_per_em(); },
    [](const void* shaper) noexcept { return shaper_faces(*static_cast<const Shaper*>(shaper)); },
    [](void* shaper, direction d, std::uint32_t face) noexcept {
        return line_metrics_of(*static_cast<Shaper*>(shaper), d, face);
    },
    [](const void* shaper, std::uint32_t face) noexcept {
        return face_metrics_of(*static_cast<const Shaper*>(shaper), face);
    },
    [](void* shaper, char32_t c) noexcept { return vertical_form_of(*static_cast<Shaper*>(shaper), c); },
    [](void* shaper) noexcept { return column_middle_of(*static_cast<Shaper*>(shaper)); },
    [](void* shaper, text_view text, const text_item& item, const shape_options& how,
       buffer<shaped_glyph>& glyphs) noexcept { return static_cast<Shaper*>(shaper)->shape(text, item, how, glyphs); }};
static_assert(shaper<shaper_ref>);

}  // namespace typemesh::inline TYPEMESH_ABI

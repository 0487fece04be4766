// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/face_source.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A shaper and an outline source combined: one library shapes the text, another draws it. Both must outlive this
/// object, and both must have one font, with equal units per em.
template <shaper Shaper, outline_source Source>
class shaped_by {
public:
    shaped_by(Shaper& shapes, Source& draws) noexcept : shapes_{&shapes}, draws_{&draws} {}

    [[nodiscard]] double units_per_em() noexcept { return draws_->units_per_em(); }
    [[nodiscard]] fill_rule fill() noexcept { return draws_->fill(); }
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return variation_of(*draws_); }

    // For sources of several faces.
    [[nodiscard]] std::uint32_t face_count() noexcept { return face_count_of(*draws_); }
    [[nodiscard]] double units_per_em(std::uint32_t face) noexcept { return units_per_em_of(*draws_, face); }
    [[nodiscard]] fill_rule fill(std::uint32_t face) noexcept { return fill_of(*draws_, face); }
    [[nodiscard]] std::uint64_t variation_key(std::uint32_t face) const noexcept { return variation_of(*draws_, face); }
    template <outline_sink Sink>
    error outline(std::uint32_t face, glyph_id id, Sink& sink) noexcept
    {
        return outline_of(*draws_, face, id, sink);
    }

    [[nodiscard]] line_metrics metrics(direction d) noexcept { return shapes_->metrics(d); }

    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        return shapes_->shape(text, item, options, glyphs);
    }
    [[nodiscard]] bool has_vertical_form(char32_t c) noexcept { return vertical_form_of(*shapes_, c); }
    [[nodiscard]] double column_middle() noexcept { return column_middle_of(*shapes_); }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        return draws_->outline(id, sink);
    }

private:
    Shaper* shapes_;
    Source* draws_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

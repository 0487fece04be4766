// SPDX-License-Identifier: MIT
#pragma once

#include "svg/svg_layers.hpp"
#include "text_fonts.hpp"

#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/outline/face_source.hpp>

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text_to_mesh {

struct options;

/// The drawings of --icon, which stand in the boxes of mark-up: an outline source with the faces of the text, and
/// one more for each drawing.
class text_icons {
public:
    explicit text_icons(font_set& fonts) : fonts_{fonts} {}

    /// Reads the files, for boxes with sides of up to this many em. Gives an empty string, or one sentence.
    [[nodiscard]] std::string open(const options& o, double largest_side);

    /// Puts each drawing into its box, as large as fits and in the middle: a glyph for each colour, or its silhouette.
    [[nodiscard]] typemesh::result<void> place(typemesh::glyph_run& page, bool colours);

    [[nodiscard]] bool owns(typemesh::style_id style) const { return number_of(style).has_value(); }
    /// The style of the text in which a drawing's box stands; any other style is its own.
    [[nodiscard]] typemesh::style_id style_of_box(typemesh::style_id style) const;
    /// The colour of one of its styles, or nothing.
    [[nodiscard]] std::optional<rgb_colour> colour_of(typemesh::style_id style) const;

    /// Warns of what is not drawn. True if there is something.
    bool name_losses(const std::string& who) const;

    // ---- an outline source ----

    [[nodiscard]] double units_per_em() noexcept { return fonts_.units_per_em(); }
    [[nodiscard]] typemesh::fill_rule fill() noexcept { return fill(0); }
    [[nodiscard]] std::uint32_t face_count() noexcept
    {
        return fonts_.face_count() + static_cast<std::uint32_t>(icons_.size());
    }
    [[nodiscard]] double units_per_em(std::uint32_t face) noexcept
    {
        return icon(face) != nullptr ? fonts_.units_per_em() : fonts_.units_per_em(face);  // place() scales drawings
    }
    [[nodiscard]] typemesh::fill_rule fill(std::uint32_t face) noexcept
    {
        return icon(face) != nullptr ? typemesh::fill_rule::non_zero : fonts_.fill(face);
    }
    template <typemesh::outline_sink Sink>
    typemesh::error outline(std::uint32_t face, typemesh::glyph_id id, Sink& sink) noexcept
    {
        if (const svg_layers* const drawing = icon(face)) return drawing->outline(id, sink);
        return fonts_.outline(face, id, sink);
    }
    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id id, Sink& sink) noexcept
    {
        return outline(0, id, sink);
    }

private:
    // The styles of one drawing follow the styles of another.
    static constexpr std::uint32_t first_style = 0x2000'0000, styles_each = 0x1'0000;

    [[nodiscard]] const svg_layers* icon(std::uint32_t face) noexcept;
    /// The number of the drawing that a style belongs to, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> number_of(typemesh::style_id style) const;
    [[nodiscard]] const svg_layers& drawing(std::uint32_t number) const;

    font_set& fonts_;
    std::list<svg_layers> icons_;
    std::vector<typemesh::style_id> box_styles_;  // of each drawing's box in the last text
};
static_assert(typemesh::face_source<text_icons>);

/// The largest side, in em, of the first `count` boxes of a text of mark-up; 0 if there are none.
[[nodiscard]] double largest_box(std::string_view source, std::size_t count);

}  // namespace text_to_mesh

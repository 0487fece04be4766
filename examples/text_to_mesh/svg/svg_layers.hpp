// SPDX-License-Identifier: MIT
#pragma once

#include "svg_drawing.hpp"

#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/recorded_outlines.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace text_to_mesh {

/// A drawing as layers of one colour each: an outline source whose glyphs are the layers, from the lowest to the
/// uppermost; the last glyph is all that they cover together. Shapes of one colour that follow each other are one layer.
class svg_layers {
public:
    /// Reads a file and cuts its layers; `tolerance` is in em. Gives an empty string, or one sentence.
    [[nodiscard]] std::string open(const std::string& path, double tolerance, typemesh::layer_cut cut,
                                   const rgb_colour& colour);

    /// The run that shows all layers in their colours, or their silhouette without colours.
    [[nodiscard]] typemesh::result<void> lay_out(typemesh::glyph_run& page, bool colours) const;

    /// The colour of a style of that run.
    [[nodiscard]] std::optional<rgb_colour> colour_of(typemesh::style_id style) const;

    /// The layer of a style, counted from the lowest; `level_count` is at least 1. Each layer has a style of its own if
    /// they are stacked.
    [[nodiscard]] std::uint32_t level_of(typemesh::style_id style) const;
    [[nodiscard]] std::uint32_t level_count() const;

    /// Warns of what is not drawn. True if there is something.
    bool name_losses(const std::string& who) const;

    /// The boundary of a glyph as the curves of the file.
    [[nodiscard]] typemesh::result<void> boundary(typemesh::glyph_id glyph, typemesh::outline& out) const;

    /// The width and the height of what the file shows; its lower left corner is at 0, 0.
    [[nodiscard]] typemesh::point view_size() const noexcept
    {
        const typemesh::box& view = drawing_.view;
        return view.empty() ? typemesh::point{units_per_em(), units_per_em()} : view.high - view.low;
    }

    [[nodiscard]] double units_per_em() const noexcept { return svg_drawing::units_per_em; }
    [[nodiscard]] typemesh::fill_rule fill() const noexcept { return typemesh::fill_rule::non_zero; }
    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id id, Sink& sink) const noexcept
    {
        return glyphs_.outline(id, sink);
    }

private:
    [[nodiscard]] typemesh::result<void> build(double tolerance, typemesh::layer_cut cut);
    [[nodiscard]] typemesh::result<typemesh::region> region_of(typemesh::glyph_id glyph,
                                                               typemesh::contours& loops) const;

    svg_drawing drawing_;
    typemesh::layer_regions regions_;
    typemesh::recorded_outlines glyphs_{svg_drawing::units_per_em};
    std::vector<rgb_colour> layers_;         // their colours
    std::vector<std::uint32_t> styles_;      // of the layers, from 1
    std::vector<rgb_colour> style_colours_;  // by style, from 1
    bool is_stacked_ = false;
};

static_assert(typemesh::outline_source<svg_layers>);

}  // namespace text_to_mesh

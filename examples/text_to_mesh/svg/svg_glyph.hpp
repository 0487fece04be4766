// SPDX-License-Identifier: MIT
#pragma once

#include "svg_drawing.hpp"

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <vector>

namespace text_to_mesh {

/// The shapes of a drawing, each with its own fill rule.
class svg_shape_source {
public:
    explicit svg_shape_source(const std::vector<typemesh::outline>& shapes) : shapes_{shapes} {}

    [[nodiscard]] double units_per_em() const noexcept { return svg_drawing::units_per_em; }
    /// Of the last shape that was drawn.
    [[nodiscard]] typemesh::fill_rule fill() const noexcept { return rule_; }
    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id id, Sink& sink) noexcept
    {
        const typemesh::outline& o = shapes_[id];
        rule_ = o.rule;
        draw_outline(o, sink);
        return {};
    }

private:
    const std::vector<typemesh::outline>& shapes_;
    typemesh::fill_rule rule_ = typemesh::fill_rule::non_zero;
};

[[nodiscard]] bool same_colour(const rgb_colour& a, const rgb_colour& b);

/// Makes the layers of a drawing: a glyph of svg_shape_source's shapes, and the colours of its layers. Shapes of one
/// colour that follow each other are one layer. False: out of memory.
[[nodiscard]] bool write_layers(const svg_drawing& from, typemesh::colour_glyph& to, std::vector<rgb_colour>& colours);

}  // namespace text_to_mesh

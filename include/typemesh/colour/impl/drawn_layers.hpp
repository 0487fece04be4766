// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/colour_style.hpp>
#include <typemesh/colour/impl/tangent_pen.hpp>
#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/value_index.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

// The numbers of layers are glyph ids that no font has: 1 | glyph (16 bits) | layer (15 bits).
[[nodiscard]] constexpr bool is_layer(glyph_id id) noexcept { return (id >> 31) != 0; }
[[nodiscard]] constexpr glyph_id layer_of(glyph_id glyph, std::uint32_t layer) noexcept
{
    return 0x8000'0000u | glyph << 15 | layer;
}
[[nodiscard]] constexpr glyph_id glyph_of_layer(glyph_id id) noexcept { return id >> 15 & 0xFFFF; }
[[nodiscard]] constexpr std::uint32_t number_of_layer(glyph_id id) noexcept { return id & 0x7FFF; }

/// A sink that only notes whether anything is drawn.
struct blank_pen {
    bool is_blank = true;
    void move(point) noexcept {}
    void line(point) noexcept { is_blank = false; }
    void quadratic(point, point) noexcept { is_blank = false; }
    void cubic(point, point, point) noexcept { is_blank = false; }
    void close() noexcept {}
};

/// The built layers of colour glyphs, as curves, and the styles of their paints.
class drawn_layers {
public:
    static constexpr std::size_t none = ~std::size_t{0};
    static constexpr std::uint32_t own_style = 0xFFFF'FFFFu;
    static constexpr int last_mixed_mode = 23;  // multiply; hue and the like are not mixed

    /// One glyph of a face. Equal ones have the same face, number and variation.
    struct glyph {
        std::uint32_t face = 0;
        glyph_id id = 0;
        std::uint64_t variation = 0;  // the key of the face's variation
        std::size_t first = 0;        // of its layers
        std::uint32_t count = 0;
        bool coloured = false, blended = false, translucent = false, unbounded = false;
        error refusal = {};

        friend bool operator==(const glyph& a, const glyph& b) noexcept
        {
            return a.face == b.face && a.id == b.id && a.variation == b.variation;
        }
        friend std::uint64_t hash_of(const glyph& g) noexcept
        {
            return mixed_key(mixed_key(g.variation, g.face), g.id);
        }
    };

    explicit drawn_layers(memory source) noexcept
        : glyphs_{source},
          layers_{source},
          curves_{source},
          starts_{source},
          styles_{source},
          stops_{source},
          scratch_{source},
          loops_{source},
          drawn_{source},
          index_{source}
    {
    }

    void clear() noexcept
    {
        glyphs_.clear();
        layers_.clear();
        curves_.clear();
        starts_.clear();
        styles_.clear();
        stops_.clear();
        index_.clear();
    }

    [[nodiscard]] std::size_t find(const glyph& wanted) const noexcept
    {
        const std::size_t at = index_.find(glyphs_.view(), wanted);
        return at == glyphs_.size() ? none : at;
    }
    [[nodiscard]] const glyph& operator[](std::size_t i) const noexcept { return glyphs_[i]; }
    [[nodiscard]] array_view<const colour_style> styles() const noexcept { return styles_.view(); }
    [[nodiscard]] array_view<const gradient_stop> stops() const noexcept { return stops_.view(); }
    [[nodiscard]] buffer<std::uint32_t>& scratch() noexcept { return scratch_; }

    /// Keeps a glyph, with its layers if it is coloured.
    [[nodiscard]] result<std::size_t> add(glyph g, const colour_glyph& from, const layer_regions& regions,
                                          bool stacked) noexcept
    {
        g.first = layers_.size();
        g.translucent = from.translucent != 0;
        g.unbounded = from.unbounded != 0;
        const std::size_t curves = curves_.size(), starts = starts_.size(), stops = stops_.size();
        error e;
        for (std::size_t i = 0; g.coloured && i < regions.layer_count() && !e; ++i)
            e = add_layer(from, i, regions, stacked);
        for (std::size_t i = 1; g.coloured && i < from.layers.size(); ++i) {
            g.translucent = g.translucent || (!stacked && from.layers[i].paint.colour.alpha < 1.0f);
            g.blended = g.blended || from.layers[i].blend > (stacked ? 0 : last_mixed_mode);
        }
        g.count = static_cast<std::uint32_t>(layers_.size() - g.first);
        if (!e && !(glyphs_.push_back(g) && index_.read(glyphs_.view()))) e = error::out_of_memory;
        if (!e) return glyphs_.size() - 1;
        if (glyphs_.size() != 0 && glyphs_.back() == g) glyphs_.truncate(glyphs_.size() - 1);
        layers_.truncate(g.first);
        curves_.truncate(curves);
        starts_.truncate(starts);
        stops_.truncate(stops);
        return e;
    }

    [[nodiscard]] bool is_empty(std::size_t g, std::uint32_t layer) const noexcept
    {
        return layers_[glyphs_[g].first + layer].starts == 0;
    }

    /// Draws a layer. False if the glyph has no such layer.
    template <outline_sink Sink>
    [[nodiscard]] bool draw(std::size_t g, std::uint32_t number, Sink& sink) const noexcept
    {
        if (number >= glyphs_[g].count) return false;
        const drawn& layer = layers_[glyphs_[g].first + number];
        if (layer.starts != 0)
            draw_outline(curves_.view().subspan(layer.first_curve),
                         starts_.view().subspan(layer.first_start, layer.starts), sink);
        return true;
    }

    /// The number of the style of a layer, for a glyph of style `own`; own_style: that style itself.
    [[nodiscard]] result<std::uint32_t> style(std::size_t g, std::uint32_t number, style_id own) noexcept
    {
        drawn& layer = layers_[glyphs_[g].first + number];
        const bool of_text = layer.paint.is_text_colour();
        if (of_text && layer.level == 0 && !(layer.paint.colour.alpha < 1.0f)) return own_style;
        if (layer.style != own_style && (!of_text || styles_[layer.style].own == own)) return layer.style;
        const colour_style wanted{layer.paint, glyphs_[g].face, of_text ? own : style_id{}, layer.level};
        std::size_t at = styles_.size();
        if (layer.paint.kind == paint_kind::solid)
            for (std::size_t i = 0; i < at; ++i)
                if (are_alike(styles_[i], wanted)) at = i;
        if (at == styles_.size() && !styles_.push_back(wanted)) return error::out_of_memory;
        layer.style = static_cast<std::uint32_t>(at);
        return layer.style;
    }

private:
    struct drawn {
        std::size_t first_curve = 0, first_start = 0;
        std::size_t starts = 0;  // one more than contours; 0: nothing remains of the layer
        glyph_paint paint;
        std::uint32_t level = 0;
        std::uint32_t style = own_style;  // if it is known
    };

    [[nodiscard]] static bool are_alike(const colour_style& a, const colour_style& b) noexcept
    {
        return a.paint.kind == paint_kind::solid && a.paint.entry == b.paint.entry &&
               a.paint.colour == b.paint.colour && a.face == b.face && a.own == b.own && a.level == b.level;
    }

    [[nodiscard]] error add_layer(const colour_glyph& from, std::size_t i, const layer_regions& regions,
                                  bool stacked) noexcept
    {
        drawn layer;
        layer.paint = regions.paint(i, from);
        layer.level = stacked ? static_cast<std::uint32_t>(i) : 0;
        layer.first_curve = curves_.size();
        layer.first_start = starts_.size();
        const auto filled = regions.layer(i, loops_);
        if (!filled) return filled.error();
        outline_recorder recorder{drawn_};
        draw_region(*filled, recorder);
        if (error e = recorder.finish()) return e;
        layer.starts = drawn_.starts.size();
        const array_view<const gradient_stop> stops = from.stops_of(layer.paint);
        layer.paint.first_stop = static_cast<std::uint32_t>(stops_.size());
        const bool ok = curves_.append(drawn_.curves.view()) && starts_.append(drawn_.starts.view()) &&
                        stops_.append(stops) && layers_.push_back(layer);
        return ok ? error{} : error::out_of_memory;
    }

    buffer<glyph> glyphs_;
    buffer<drawn> layers_;
    buffer<curve> curves_;
    buffer<std::uint32_t> starts_;  // the first curve of each contour, from the layer's first
    buffer<colour_style> styles_;
    buffer<gradient_stop> stops_;
    buffer<std::uint32_t> scratch_;
    contours loops_;
    outline drawn_;
    value_index<glyph> index_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/core/affine.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A shape of a colour glyph: an outline of the font, or what two earlier shapes have in common, cover together, or
/// leave of each other.
struct layer_shape {
    /// The ways to make a shape.
    enum class kind : std::uint8_t {
        outline,    ///< the glyph `id`, mapped by `map`
        rectangle,  ///< a clip box: the square from (0, 0) to (1, 1), mapped by `map`
        both,       ///< where the shapes `a` and `b` are
        either,     ///< where `a` or `b` is
        without,    ///< where `a` is and `b` is not
    };
    kind is = kind::outline;
    glyph_id id = 0;
    affine map = {};
    std::uint32_t a = 0, b = 0;  ///< in colour_glyph::shapes, before this shape

    friend constexpr bool operator==(const layer_shape& l, const layer_shape& r) noexcept
    {
        return l.is == r.is && l.id == r.id && l.map == r.map && l.a == r.a && l.b == r.b;
    }
};

/// One layer: a shape with a paint.
struct colour_layer {
    std::uint32_t shape = 0;  ///< in colour_glyph::shapes
    glyph_paint paint;
    std::uint8_t blend = 0;  ///< 0, or the composite mode of COLR (12 to 27) that mixes it with what is below
};

/// A colour glyph as its font describes it: layers, from the lowest to the uppermost.
struct colour_glyph {
    buffer<colour_layer> layers;
    buffer<layer_shape> shapes;
    buffer<gradient_stop> stops;  ///< of all gradients
    box clip;                     ///< nothing is painted outside, in font units; empty: there is no limit

    std::uint32_t blended = 0;      ///< composites whose colours mix (such as multiply): see colour_layer::blend
    std::uint32_t translucent = 0;  ///< composites that a translucent paint cuts, which cuts like an opaque one
    std::uint32_t unbounded = 0;    ///< paints of the whole plane in a glyph without a clip box, which are left out

    explicit colour_glyph(memory source = heap()) noexcept : layers{source}, shapes{source}, stops{source} {}

    void clear() noexcept
    {
        layers.clear();
        shapes.clear();
        stops.clear();
        clip = {};
        blended = translucent = unbounded = 0;
    }

    /// The stops of a gradient of this glyph.
    [[nodiscard]] array_view<const gradient_stop> stops_of(const glyph_paint& paint) const noexcept
    {
        return stops.view().subspan(paint.first_stop, paint.stop_count);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

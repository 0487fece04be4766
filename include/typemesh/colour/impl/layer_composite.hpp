// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/impl/shape_builder.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Applies a composite mode of COLR version 1 to the last layers of a glyph: the backdrop's, then the source's.
///
///      layers   [ ... | backdrop: first ... | source: middle ... ]
///
/// Porter and Duff's modes, for opaque paints, only say which of both remains where: each layer is cut by the area that
/// all layers of the other group cover together.
///
/// From  Porter & Duff, Compositing digital images (1984)
class layer_composite {
public:
    layer_composite(colour_glyph& out, shape_builder& shapes, std::size_t first, std::size_t middle) noexcept
        : out_{out}, shapes_{shapes}, first_{first}, middle_{middle}, end_{out.layers.size()}
    {
    }

    /// False if there is no such mode.
    [[nodiscard]] bool apply(std::uint32_t mode) noexcept
    {
        enum : std::uint32_t {
            clear,
            source,
            backdrop,
            over,
            backdrop_over,
            in,
            backdrop_in,
            out,
            backdrop_out,
            atop,
            backdrop_atop,
            exclusive,
            plus,
            last = 27
        };
        if (mode > last) return false;
        if (mode >= plus) {
            ++out_.blended;
            for (std::size_t i = middle_; i < end_; ++i)
                if (out_.layers[i].blend == 0) out_.layers[i].blend = static_cast<std::uint8_t>(mode);
            mode = over;
        }
        if (mode == over) return true;
        const std::uint32_t of_backdrop = covered(first_, middle_), of_source = covered(middle_, end_);
        const bool cuts_source = mode == in || mode == out || mode == atop || mode == exclusive;
        const bool cuts_backdrop =
            mode == backdrop_in || mode == backdrop_out || mode == backdrop_atop || mode == exclusive;
        if ((cuts_source && is_translucent(first_, middle_)) || (cuts_backdrop && is_translucent(middle_, end_)))
            ++out_.translucent;
        if (mode == in || mode == atop) cut(middle_, end_, of_backdrop, true);
        if (mode == out || mode == exclusive) cut(middle_, end_, of_backdrop, false);
        if (mode == backdrop_in || mode == backdrop_atop) cut(first_, middle_, of_source, true);
        if (mode == backdrop_out || mode == exclusive) cut(first_, middle_, of_source, false);
        if (mode == backdrop_over || mode == backdrop_atop) swap_groups();
        const bool without_backdrop = mode == clear || mode == source || mode == in || mode == out;
        const bool without_source = mode == clear || mode == backdrop || mode == backdrop_in || mode == backdrop_out;
        keep(!without_backdrop, !without_source);
        return true;
    }

private:
    [[nodiscard]] std::uint32_t covered(std::size_t begin, std::size_t end) noexcept
    {
        std::uint32_t shape = shape_builder::nothing;
        for (std::size_t i = begin; i < end; ++i) shape = shapes_.either(shape, out_.layers[i].shape);
        return shape;
    }
    [[nodiscard]] bool is_translucent(std::size_t begin, std::size_t end) const noexcept
    {
        for (std::size_t i = begin; i < end; ++i)
            if (out_.layers[i].paint.colour.alpha < 1.0f) return true;
        return false;
    }
    void cut(std::size_t begin, std::size_t end, std::uint32_t by, bool inside) noexcept
    {
        for (std::size_t i = begin; i < end; ++i) {
            std::uint32_t& shape = out_.layers[i].shape;
            shape = inside ? shapes_.both(shape, by) : shapes_.without(shape, by);
        }
    }

    /// Puts the source below the backdrop.
    void swap_groups() noexcept
    {
        const auto reverse = [this](std::size_t begin, std::size_t end) noexcept {
            while (begin + 1 < end) {
                const colour_layer layer = out_.layers[begin];
                out_.layers[begin++] = out_.layers[--end];
                out_.layers[end] = layer;
            }
        };
        reverse(first_, middle_);
        reverse(middle_, end_);
        reverse(first_, end_);
    }

    /// Removes layers without area, and one group or both.
    void keep(bool backdrop, bool source) noexcept
    {
        std::size_t kept = first_;
        for (std::size_t i = first_; i < end_; ++i) {
            if (!(i < middle_ ? backdrop : source) || out_.layers[i].shape == shape_builder::nothing) continue;
            out_.layers[kept++] = out_.layers[i];
        }
        out_.layers.truncate(kept);
    }

    colour_glyph& out_;
    shape_builder& shapes_;
    std::size_t first_, middle_, end_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

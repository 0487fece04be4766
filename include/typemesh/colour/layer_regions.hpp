// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/impl/region_pool.hpp>
#include <typemesh/colour/impl/tangent_pen.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/fill/cut_where_met.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How the layers of a colour glyph become solids.
///
///     stacked    every layer is whole, and is meant to stand above those before it
///     visible    every layer is what those above it leave of it: together they tile the glyph's silhouette
enum class layer_cut : std::uint8_t { stacked, visible };

/// The regions of all layers of one colour glyph, on one grid. All outlines are cut in the points where they meet,
/// once, before anything else; then shapes and layers are joined and cut without moving a point. So two layers have
/// each stretch of their common boundary in the same points, and the doubled areas of the visible layers add up to the
/// area of the silhouette, as integers.
///
///     auto done = regions.build(font, 0, drawn, quality::normal, layer_cut::visible);
///     contours loops;
///     auto first = regions.layer(0, loops);                   // a proven region
///
/// Memory is kept for the next glyph.
class layer_regions {
public:
    explicit layer_regions(memory source = heap()) noexcept
        : one_{source},
          whole_{source},
          flat_{source},
          pool_{source},
          parts_{source},
          shapes_{source},
          layers_{source},
          space_{source}
    {
    }

    /// Makes the regions of a glyph's layers.
    ///
    ///     face         the face of the source
    ///     tolerance    the largest distance between a curve and its chords, in em
    ///     max_pieces   the greatest number of edges and of crossings
    ///
    /// Fails  as the source, grid::fitting(), discretise(), cut_where_met() and resolve() do; error::bad_tolerance.
    ///        There are then no layers
    /// Cost   one flattening and one cut of all outlines, then O(n log n) for each operation on shapes, and for two
    ///        operations on each layer; n is the number of edges that take part
    template <outline_source Source>
    [[nodiscard]] result<void> build(Source& source, std::uint32_t face, const colour_glyph& glyph, double tolerance,
                                     layer_cut cut, std::uint32_t max_pieces = default_max_pieces) noexcept
    {
        clear();
        if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad_tolerance;
        const double units_per_em = units_per_em_of(source, face);
        error e;
        for (const layer_shape& shape : glyph.shapes) {
            if (!e) e = record_shape(source, face, shape, glyph.clip, max_pieces);
            if (!e) e = keep_shape();
        }
        clipped_ = !glyph.clip.empty() && reaches_out_of(glyph.clip);
        if (clipped_) {
            if (!e) e = record_shape(source, face, {.is = layer_shape::kind::rectangle}, glyph.clip, max_pieces);
            if (!e) e = keep_shape();
        }
        if (!e) e = build_shapes(glyph, tolerance, units_per_em, max_pieces);
        if (!e) e = build_layers(glyph, cut);
        if (e) layers_.clear();
        return e;
    }

    /// The number of layers that were built.
    [[nodiscard]] std::size_t layer_count() const noexcept { return layers_.size(); }

    /// Whether nothing of a layer remains; layer < layer_count().
    [[nodiscard]] bool is_empty(std::size_t layer) const noexcept { return layers_[layer].points == 0; }

    /// The region of a layer, which lies in `loops`. Its curves lie in this object.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] result<region> layer(std::size_t layer, contours& loops) const noexcept
    {
        return pool_.region_of(layers_[layer], whole_.curves.view(), loops);
    }

    /// The region that all layers cover together, after build() with layer_cut::visible; otherwise it is empty.
    [[nodiscard]] result<region> silhouette(contours& loops) const noexcept
    {
        return pool_.region_of(silhouette_, whole_.curves.view(), loops);
    }

    /// Draws a region of this object into an outline sink: each edge is a line, or a cubic that hardly deviates from
    /// its chord and has the tangents of the curve. Every discretiser that keeps the tolerance of build() makes it the
    /// same chord again, so drawn layers still tile; normals follow the curves.
    template <outline_sink Sink>
    static void draw(const region& drawn, Sink& sink) noexcept
    {
        detail::draw_region(drawn, sink);
    }

private:
    /// The outline of a shape within all curves.
    struct part {
        std::uint32_t end = 0;  // of its curves
        fill_rule rule = fill_rule::non_zero;
    };

    void clear() noexcept
    {
        whole_.clear();
        parts_.clear();
        shapes_.clear();
        layers_.clear();
        pool_.clear();
        silhouette_ = {};
    }

    template <outline_source Source>
    [[nodiscard]] error record_shape(Source& source, std::uint32_t face, const layer_shape& shape, const box& clip,
                                     std::uint32_t most) noexcept
    {
        outline_recorder recorder{one_, most};
        one_.rule = fill_rule::non_zero;
        if (shape.is == layer_shape::kind::outline) {
            detail::mapping_sink<outline_recorder> pen{recorder, shape.map};
            if (error e = outline_of(source, face, shape.id, pen)) return e;
            one_.rule = fill_of(source, face);
        } else if (shape.is == layer_shape::kind::rectangle && !clip.empty()) {
            recorder.move(clip.low);
            recorder.line({clip.high.x, clip.low.y});
            recorder.line(clip.high);
            recorder.line({clip.low.x, clip.high.y});
        }
        return recorder.finish();
    }

    [[nodiscard]] bool reaches_out_of(const box& clip) const noexcept
    {
        const box& all = whole_.bounds;
        return all.low.x < clip.low.x || all.low.y < clip.low.y || all.high.x > clip.high.x || all.high.y > clip.high.y;
    }

    /// Appends the recorded outline to all curves.
    [[nodiscard]] error keep_shape() noexcept
    {
        const auto first = static_cast<std::uint32_t>(whole_.curves.size());
        if (one_.curves.size() > 0xFFFF'FFF0u - first) return error::too_large;
        if (whole_.starts.empty() && !whole_.starts.push_back(0)) return error::out_of_memory;
        bool ok = whole_.curves.append(one_.curves.view());
        for (std::size_t c = 1; c < one_.starts.size() && ok; ++c) ok = whole_.starts.push_back(first + one_.starts[c]);
        ok = ok && parts_.push_back({static_cast<std::uint32_t>(whole_.curves.size()), one_.rule});
        whole_.bounds.merge(one_.bounds);
        return ok ? error{} : error::out_of_memory;
    }

    /// Flattens and cuts all outlines, and makes the region of each shape.
    [[nodiscard]] error build_shapes(const colour_glyph& glyph, double tolerance, double units_per_em,
                                     std::uint32_t max_pieces) noexcept
    {
        const auto cells = grid::fitting(units_per_em, whole_.bounds);
        if (!cells) return cells.error();
        flat_.max_points = max_pieces;
        if (const auto done = discretise(whole_, certified{}, tolerance * units_per_em, *cells, flat_); !done)
            return done.error();
        const double reach = flat_.tolerance;
        if (const auto done = cut_where_met(flat_, space_, max_pieces); !done) return done.error();
        pool_.begin(*cells, reach, max_pieces);
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < glyph.shapes.size(); ++i) {
            const layer_shape& s = glyph.shapes[i];
            const std::uint32_t first = next;
            while (next < flat_.contour_count() && flat_.edges[flat_.starts[next]].curve < parts_[i].end) ++next;
            detail::pooled_region made;
            error e;
            switch (s.is) {
            case layer_shape::kind::outline:
            case layer_shape::kind::rectangle:
                e = pool_.fill(flat_, first, next - first, parts_[i].rule, space_, made);
                break;
            case layer_shape::kind::both: e = pool_.both(shapes_[s.a], shapes_[s.b], space_, made); break;
            case layer_shape::kind::either:
                e = pool_.join(shapes_[s.a], shapes_[s.b], fill_rule::non_zero, space_, made);
                break;
            case layer_shape::kind::without: e = pool_.without(shapes_[s.a], shapes_[s.b], space_, made); break;
            }
            if (e) return e;
            if (!shapes_.push_back(made)) return error::out_of_memory;
        }
        if (!clipped_) return {};
        return pool_.fill(flat_, next, flat_.contour_count() - next, fill_rule::non_zero, space_, clip_);
    }

    [[nodiscard]] error build_layers(const colour_glyph& glyph, layer_cut cut) noexcept
    {
        const std::size_t count = glyph.layers.size();
        detail::pooled_region* const made = layers_.append(count);
        if (made == nullptr && count != 0) return error::out_of_memory;
        detail::pooled_region above;  // all that is above the layer
        for (std::size_t i = count; i-- > 0;) {
            made[i] = shapes_[glyph.layers[i].shape];
            if (clipped_)
                if (error e = pool_.both(shapes_[glyph.layers[i].shape], clip_, space_, made[i])) return e;
            if (cut == layer_cut::stacked) continue;
            detail::pooled_region all;
            if (error e = pool_.join(made[i], above, fill_rule::non_zero, space_, all)) return e;
            if (error e = pool_.join(all, above, fill_rule::even_odd, space_, made[i])) return e;
            above = all;
        }
        silhouette_ = above;
        return {};
    }

    outline one_;    // the outline of a shape
    outline whole_;  // the outlines of all shapes
    contours flat_;
    detail::region_pool pool_;
    buffer<part> parts_;
    buffer<detail::pooled_region> shapes_, layers_;
    detail::pooled_region silhouette_, clip_;
    bool clipped_ = false;  // some outline reaches out of the clip box
    workspace space_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

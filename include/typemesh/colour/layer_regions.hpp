// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/colour/impl/mixed_colour.hpp>
#include <typemesh/colour/impl/paint_transform.hpp>
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
///     visible    every layer is what those above it leave of it: together they tile the glyph's silhouette. A layer
///                through which others shine is divided by these, and its parts have mixed colours
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
          made_{source},
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
    ///     max_pieces   the greatest number of curves, of edges, of crossings, and of points of all regions; all
    ///                  operations together may take 64 times as many points
    ///
    /// Fails  as the source, grid::fitting(), discretise(), cut_where_met() and resolve() do; error::bad_tolerance;
    ///        error::bad_colours: more than 32,767 layers. There are then no layers
    /// Cost   one flattening and one cut of all outlines, then O(n log n) for each operation on shapes, and for four on
    ///        each pair of a translucent layer and one that it lies on; n is the number of edges that take part. For
    ///        all l visible layers together O(n log n log^2 l)
    template <outline_source Source>
    [[nodiscard]] result<void> build(Source& source, std::uint32_t face, const colour_glyph& glyph, double tolerance,
                                     layer_cut cut, std::uint32_t max_pieces = default_max_pieces) noexcept
    {
        clear();
        if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad_tolerance;
        const double units_per_em = units_per_em_of(source, face);
        error e;
        for (const layer_shape& shape : glyph.shapes) {
            if (!e) e = record_shape(source, face, shape, max_pieces);
            if (!e) e = keep_shape(max_pieces);
        }
        clipped_ = !glyph.clip.empty() && reaches_out_of(glyph.clip);
        if (clipped_) {
            const layer_shape clip{layer_shape::kind::rectangle, 0, detail::onto(glyph.clip), 0, 0};
            if (!e) e = record_shape(source, face, clip, max_pieces);
            if (!e) e = keep_shape(max_pieces);
        }
        if (!e) e = build_shapes(glyph, tolerance, units_per_em, max_pieces);
        if (!e) e = build_layers(glyph, cut);
        if (e) layers_.clear();
        return e;
    }

    /// The number of layers that were built, from the lowest to the uppermost: as many as the glyph has, or more, if
    /// parts of them have mixed colours.
    [[nodiscard]] std::size_t layer_count() const noexcept { return layers_.size(); }

    /// Whether nothing of a layer remains; layer < layer_count().
    [[nodiscard]] bool is_empty(std::size_t layer) const noexcept { return layers_[layer].made.points == 0; }

    /// The layer of the glyph that a layer is, or is a part of; layer < layer_count().
    [[nodiscard]] std::uint32_t number_in_glyph(std::size_t layer) const noexcept { return layers_[layer].number; }

    /// The paint of a layer: the glyph's own, or a solid one with the entry mixed_colour_entry.
    [[nodiscard]] glyph_paint paint(std::size_t layer, const colour_glyph& glyph) const noexcept
    {
        const built& l = layers_[layer];
        if (!l.mixed) return glyph.layers[l.number].paint;
        glyph_paint made;
        made.entry = mixed_colour_entry;
        made.colour = l.colour;
        return made;
    }

    /// The region of a layer, which lies in `loops`. Its curves lie in this object.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] result<region> layer(std::size_t layer, contours& loops) const noexcept
    {
        return made_.region_of(layers_[layer].made, whole_.curves.view(), loops);
    }

    /// The region that all layers cover together, after build() with layer_cut::visible; otherwise it is empty.
    [[nodiscard]] result<region> silhouette(contours& loops) const noexcept
    {
        return made_.region_of(silhouette_, whole_.curves.view(), loops);
    }

    /// Draws a region of this object into an outline sink: each edge is a line, or a cubic that hardly deviates from
    /// its chord and has the tangents of the curve. With the tolerance of build(), `certified` makes it the
    /// same chord again, so drawn layers still tile; normals follow the curves.
    template <outline_sink Sink>
    static void draw(const region& drawn, Sink& sink) noexcept
    {
        detail::draw_region(drawn, sink);
    }

private:
    /// The outline of a shape within all curves.
    struct outline_part {
        std::uint32_t end = 0;  // of its curves
        fill_rule rule = fill_rule::non_zero;
    };

    struct built {
        detail::pooled_region made;
        std::uint32_t number = 0;  // of the glyph's layer
        bool mixed = false;
        palette_colour colour;  // if it is mixed
    };

    static constexpr std::size_t max_layers = 0x7FFF;
    static constexpr std::size_t max_one_by_one = 128;  // layers; then see_all() is faster
    static constexpr std::size_t max_shining = 16;      // layers on each other through which others shine

    void clear() noexcept
    {
        whole_.clear();
        parts_.clear();
        shapes_.clear();
        layers_.clear();
        pool_.clear();
        made_.clear();
        silhouette_ = {};
    }

    template <outline_source Source>
    [[nodiscard]] error record_shape(Source& source, std::uint32_t face, const layer_shape& shape,
                                     std::uint32_t most) noexcept
    {
        outline_recorder recorder{one_, most};
        detail::mapping_sink<outline_recorder> pen{recorder, shape.map};
        one_.rule = fill_rule::non_zero;
        if (shape.is == layer_shape::kind::outline) {
            if (error e = outline_of(source, face, shape.id, pen)) return e;
            one_.rule = fill_of(source, face);
        } else if (shape.is == layer_shape::kind::rectangle) {
            pen.move({0.0, 0.0});
            pen.line({1.0, 0.0});
            pen.line({1.0, 1.0});
            pen.line({0.0, 1.0});
        }
        return recorder.finish();
    }

    [[nodiscard]] bool reaches_out_of(const box& clip) const noexcept
    {
        const box& all = whole_.bounds;
        return all.low.x < clip.low.x || all.low.y < clip.low.y || all.high.x > clip.high.x || all.high.y > clip.high.y;
    }

    /// Appends the recorded outline to all curves.
    [[nodiscard]] error keep_shape(std::uint32_t most) noexcept
    {
        const auto first = static_cast<std::uint32_t>(whole_.curves.size());
        if (one_.curves.size() > most - first) return {error::too_many_points, most};
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
        made_.begin(*cells, reach, max_pieces);
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
        if (cut == layer_cut::stacked) {
            const detail::region_pool::mark shapes = pool_.here();
            for (std::size_t i = 0; i < count; ++i) {
                detail::pooled_region own = shapes_[glyph.layers[i].shape];
                if (clipped_)
                    if (error e = pool_.both(shapes_[glyph.layers[i].shape], clip_, space_, own)) return e;
                if (error e = keep_layer({own, static_cast<std::uint32_t>(i), false, {}})) return e;
                detail::pooled_region none;
                pool_.rewind(shapes, none);
            }
            return {};
        }
        detail::pooled_region all;
        if (error e = count <= max_one_by_one ? see_one_by_one(glyph, all) : see_all(glyph, all)) return e;
        for (std::size_t i = 0, k = layers_.size(); i + 1 < k; ++i) {  // the lowest first
            const built lower = layers_[--k];
            layers_[k] = layers_[i];
            layers_[i] = lower;
        }
        return made_.copy(pool_, all, silhouette_);
    }

    /// Keeps what is seen of each layer, from the uppermost to the lowest. Fast for few layers: all that is above a
    /// layer takes part in two operations.
    [[nodiscard]] error see_one_by_one(const colour_glyph& glyph, detail::pooled_region& all) noexcept
    {
        const detail::region_pool::mark shapes = pool_.here();
        detail::pooled_region above;  // the only region behind the shapes
        for (std::size_t i = glyph.layers.size(); i-- > 0;) {
            detail::pooled_region own = shapes_[glyph.layers[i].shape], seen;
            if (clipped_)
                if (error e = pool_.both(shapes_[glyph.layers[i].shape], clip_, space_, own)) return e;
            if (error e = pool_.join(own, above, fill_rule::non_zero, space_, all)) return e;
            if (error e = pool_.join(all, above, fill_rule::even_odd, space_, seen)) return e;
            if (error e = keep_seen(glyph, i, seen)) return e;
            above = all;
            pool_.rewind(shapes, above);
        }
        all = above;
        return {};
    }

    /// The same for many layers.
    [[nodiscard]] error see_all(const colour_glyph& glyph, detail::pooled_region& all) noexcept
    {
        if (error e = unite(glyph, 0, glyph.layers.size(), all)) return e;
        if (clipped_) {
            const detail::pooled_region whole = all;
            if (error e = pool_.both(whole, clip_, space_, all)) return e;
        }
        return see(glyph, 0, glyph.layers.size(), all, !clipped_);
    }

    /// Keeps what is seen of a layer, or its parts.
    [[nodiscard]] error keep_seen(const colour_glyph& glyph, std::size_t layer,
                                  const detail::pooled_region& seen) noexcept
    {
        shining_[0] = static_cast<std::uint32_t>(layer);
        if (seen.points == 0 || detail::hides(glyph.layers[layer])) return keep_layer({seen, shining_[0], false, {}});
        return divide(glyph, seen, layer, 1);
    }

    /// What layers first to last - 1 cover together. They are joined in pairs, so that each point takes part in few
    /// joins.
    [[nodiscard]] error unite(const colour_glyph& glyph, std::size_t first, std::size_t last,
                              detail::pooled_region& out) noexcept
    {
        if (last - first == 1) {
            out = shapes_[glyph.layers[first].shape];
            return {};
        }
        const detail::region_pool::mark before = pool_.here();
        const std::size_t middle = first + (last - first) / 2;
        detail::pooled_region lower, upper;
        if (error e = unite(glyph, first, middle, lower)) return e;
        if (error e = unite(glyph, middle, last, upper)) return e;
        if (error e = pool_.join(lower, upper, fill_rule::non_zero, space_, out)) return e;
        pool_.rewind(before, out);
        return {};
    }

    /// Keeps what is seen of layers first to last - 1, from the uppermost to the lowest. It is divided between the
    /// upper half of them and the lower half, and so on: each point takes part in few divisions, however many layers
    /// there are.
    ///
    ///     seen    what is seen of them together
    ///     whole   this is all that they cover
    [[nodiscard]] error see(const colour_glyph& glyph, std::size_t first, std::size_t last,
                            const detail::pooled_region& seen, bool whole) noexcept
    {
        if (seen.points == 0 || last - first == 1) {
            for (std::size_t i = last; i-- > first;)
                if (error e = keep_seen(glyph, i, seen)) return e;
            return {};
        }
        const detail::region_pool::mark before = pool_.here();
        const std::size_t middle = first + (last - first) / 2;
        detail::pooled_region upper, lower, none;
        if (error e = unite(glyph, middle, last, upper)) return e;
        if (!whole) {
            const detail::pooled_region all = upper;
            if (error e = pool_.both(seen, all, space_, upper)) return e;
            pool_.rewind(before, upper);
        }
        if (error e = pool_.join(seen, upper, fill_rule::even_odd, space_, lower)) return e;
        if (error e = see(glyph, middle, last, upper, whole)) return e;
        if (error e = see(glyph, first, middle, lower, false)) return e;
        pool_.rewind(before, none);
        return {};
    }

    /// Divides what is seen of layers through which others shine by the layers below them, the uppermost first.
    ///
    ///     below   the layers of the glyph below this number are left
    ///     depth   how many layers shine, in shining_
    [[nodiscard]] error divide(const colour_glyph& glyph, const detail::pooled_region& seen, std::size_t below,
                               std::size_t depth) noexcept
    {
        const detail::region_pool::mark before = pool_.here();
        detail::pooled_region rest = seen;
        for (std::size_t k = below; k-- > 0 && rest.points != 0;) {
            const detail::pooled_region& other = shapes_[glyph.layers[k].shape];
            if (!rest.meets(other)) continue;
            detail::pooled_region part, left;
            if (error e = pool_.without(rest, other, space_, left)) return e;
            if (error e = pool_.join(rest, left, fill_rule::even_odd, space_, part)) return e;
            if (part.points == 0) {
                pool_.rewind(before, left);
                rest = left;
                continue;
            }
            const bool last = detail::hides(glyph.layers[k]) || depth == max_shining;
            if (!last) shining_[depth] = static_cast<std::uint32_t>(k);
            if (error e = last ? keep_mixed(glyph, part, depth, &glyph.layers[k].paint.colour)
                               : divide(glyph, part, k, depth + 1))
                return e;
            pool_.rewind(before, left);
            rest = left;
        }
        return rest.points == 0 ? error{} : keep_mixed(glyph, rest, depth, nullptr);
    }

    /// Keeps a part of layers that shine, on a colour below them if there is one.
    [[nodiscard]] error keep_mixed(const colour_glyph& glyph, const detail::pooled_region& part, std::size_t depth,
                                   const palette_colour* below) noexcept
    {
        if (depth == 1 && below == nullptr) return keep_layer({part, shining_[0], false, {}});
        palette_colour colour = below != nullptr ? *below : glyph.layers[shining_[--depth]].paint.colour;
        while (depth-- > 0) {
            const colour_layer& layer = glyph.layers[shining_[depth]];
            colour = detail::mixed_colour(colour, layer.paint.colour, layer.blend);
        }
        return keep_layer({part, shining_[0], true, colour});
    }

    [[nodiscard]] error keep_layer(built layer) noexcept
    {
        if (layers_.size() == max_layers) return error::bad_colours;
        if (error e = made_.copy(pool_, layer.made, layer.made)) return e;
        return layers_.push_back(layer) ? error{} : error{error::out_of_memory};
    }

    outline one_;    // the outline of a shape
    outline whole_;  // the outlines of all shapes
    contours flat_;
    detail::region_pool pool_, made_;  // shapes and what is made of them; the layers
    buffer<outline_part> parts_;
    buffer<detail::pooled_region> shapes_;
    buffer<built> layers_;
    std::uint32_t shining_[max_shining] = {};  // of the glyph's layers, from the uppermost, while one is divided
    detail::pooled_region silhouette_, clip_;
    bool clipped_ = false;  // some outline reaches out of the clip box
    workspace space_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/colour_tables.hpp>
#include <typemesh/colour/impl/layer_composite.hpp>
#include <typemesh/colour/impl/paint_transform.hpp>
#include <typemesh/colour/impl/shape_builder.hpp>
#include <typemesh/colour/impl/table_bytes.hpp>
#include <typemesh/colour/impl/variation_deltas.hpp>
#include <typemesh/core/affine.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Walks the paints of one glyph and appends its layers: see read_colour_glyph().
class paint_reader {
public:
    paint_reader(const colour_tables& font, std::uint32_t palette, const palette_colour& foreground,
                 std::uint32_t max_layers, std::uint32_t max_paints, colour_glyph& out) noexcept
        : colr_{font.colr},
          cpal_{font.cpal},
          foreground_{foreground},
          max_layers_{max_layers < 0x7FFF ? max_layers : 0x7FFF},
          paints_left_{max_paints},
          out_{out},
          shapes_{out, max_paints}
    {
        open_palette(palette);
        if (colr_.u16(0) == 0) return;
        base_list_ = colr_.u32(14);
        layer_list_ = colr_.u32(18);
        clip_list_ = colr_.u32(22);
        deltas_.open(colr_, colr_.u32(30), colr_.u32(26), font.axes);
    }

    [[nodiscard]] result<bool> read(glyph_id id) noexcept
    {
        if (colr_.u16(0) > 1) return error::bad_colours;
        bool found = false;
        if (const std::size_t paint = root_of(id); paint != 0) {
            found = true;
            if (const auto clip = clip_of(id)) out_.clip = *clip;
            paint_at(paint, {}, shape_builder::everything, 0);
        } else {
            found = read_flat(id);
        }
        if (shapes_.is_out_of_memory()) failed_ = error::out_of_memory;
        if (!failed_ &&
            (shapes_.is_full() || deltas_.is_exhausted() || (found && (colr_.is_short() || cpal_.is_short()))))
            failed_ = error::bad_colours;
        if (failed_) return failed_;
        return found;
    }

private:
    static constexpr std::uint32_t max_depth = 64;
    static constexpr std::uint32_t not_varied = 0xFFFF'FFFFu;

    // ---- numbers ----------------------------------------------------------------------------------------------------

    [[nodiscard]] double change(std::uint32_t base, std::uint32_t which) const noexcept
    {
        return base == not_varied || base > not_varied - 16 ? 0.0 : deltas_(base + which);
    }
    [[nodiscard]] double unit(std::size_t at, std::uint32_t base, std::uint32_t which) const noexcept
    {
        return colr_.i16(at) + change(base, which);
    }
    [[nodiscard]] double length(std::size_t at, std::uint32_t base, std::uint32_t which) const noexcept
    {
        const double own = colr_.u16(at) + change(base, which);
        return own > 0.0 ? own : 0.0;
    }
    [[nodiscard]] double f2dot14(std::size_t at, std::uint32_t base, std::uint32_t which) const noexcept
    {
        return (colr_.i16(at) + change(base, which)) / 16384.0;
    }
    [[nodiscard]] double alpha(std::size_t at, std::uint32_t base) const noexcept
    {
        const double a = f2dot14(at, base, 0);
        return a < 0.0 ? 0.0 : a > 1.0 ? 1.0 : a;
    }

    // ---- palettes ---------------------------------------------------------------------------------------------------

    void open_palette(std::uint32_t palette) noexcept
    {
        entries_ = cpal_.u16(2);
        const std::uint32_t palettes = cpal_.u16(4), records = cpal_.u16(6);
        if (palettes == 0) entries_ = 0;
        const std::uint32_t first = cpal_.u16(12 + 2 * std::size_t{palette < palettes ? palette : 0});
        if (first > records || entries_ > records - first) entries_ = first > records ? 0 : records - first;
        colours_ = cpal_.u32(8) + 4 * std::size_t{first};
    }

    /// Entries that the palette lacks are black.
    [[nodiscard]] palette_colour colour_of(std::uint32_t entry, double alpha) const noexcept
    {
        palette_colour c = foreground_;
        if (entry != text_colour_entry) {
            c = {};
            if (entry < entries_) {
                const std::size_t at = colours_ + 4 * std::size_t{entry};
                const auto byte = [&](std::size_t i) noexcept { return static_cast<std::uint8_t>(cpal_.u8(at + i)); };
                c = {byte(2), byte(1), byte(0), static_cast<float>(cpal_.u8(at + 3) / 255.0)};
            }
        }
        c.alpha = static_cast<float>(as_double(c.alpha) * alpha);
        return c;
    }

    // ---- version 0 --------------------------------------------------------------------------------------------------

    [[nodiscard]] bool read_flat(glyph_id id) noexcept
    {
        const std::size_t count = colr_.u16(2), bases = colr_.u32(4), layers = colr_.u32(8);
        const std::size_t base = colr_.find(bases, count, 6, id);
        if (base == count) return false;
        const std::size_t at = bases + 6 * base, first = colr_.u16(at + 2), number = colr_.u16(at + 4);
        if (first + number > colr_.u16(12)) failed_ = error::bad_colours;
        for (std::size_t i = first; i < first + number && !failed_; ++i) {
            const std::size_t layer = layers + 4 * i;
            glyph_paint paint;
            paint.entry = static_cast<std::uint16_t>(colr_.u16(layer + 2));
            paint.colour = colour_of(paint.entry, 1.0);
            add_layer(shapes_.outline(colr_.u16(layer), {}), paint);
        }
        return true;
    }

    // ---- version 1 --------------------------------------------------------------------------------------------------

    [[nodiscard]] std::size_t root_of(glyph_id id) const noexcept
    {
        if (base_list_ == 0) return 0;
        const std::size_t count = colr_.u32(base_list_), most = colr_.size() / 6;
        const std::size_t sound = count < most ? count : most;
        const std::size_t i = colr_.find(base_list_ + 4, sound, 6, id);
        return i == sound ? 0 : base_list_ + colr_.u32(base_list_ + 4 + 6 * i + 2);
    }

    /// The clip box of a glyph, if it has one.
    [[nodiscard]] std::optional<box> clip_of(glyph_id id) const noexcept
    {
        if (clip_list_ == 0 || colr_.u8(clip_list_) != 1) return {};
        const std::size_t count = colr_.u32(clip_list_ + 1), most = colr_.size() / 7;
        std::size_t low = 0, high = count < most ? count : most;
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2, at = clip_list_ + 5 + 7 * middle;
            if (id < colr_.u16(at)) {
                high = middle;
            } else if (id > colr_.u16(at + 2)) {
                low = middle + 1;
            } else {
                const std::size_t clip = clip_list_ + colr_.u24(at + 4);
                const std::uint32_t base = colr_.u8(clip) == 2 ? colr_.u32(clip + 9) : not_varied;
                return box{{unit(clip + 1, base, 0), unit(clip + 3, base, 1)},
                           {unit(clip + 5, base, 2), unit(clip + 7, base, 3)}};
            }
        }
        return {};
    }

    void add_layer(std::uint32_t shape, const glyph_paint& paint) noexcept
    {
        if (failed_ || shape == shape_builder::nothing) return;
        if (shape == shape_builder::everything) {
            if (depth_of_groups_ != 0) {
                // a composite may cut it
            } else if (out_.clip.empty()) {
                ++out_.unbounded;
                return;
            } else {
                shape = shapes_.rectangle(out_.clip);
            }
        }
        if (out_.layers.size() >= max_layers_)
            failed_ = error::bad_colours;
        else if (!out_.layers.push_back({shape, paint, 0}))
            failed_ = error::out_of_memory;
    }

    /// Appends the layers of a paint. `clip` is the shape within which it paints.
    void paint_at(std::size_t at, const affine& map, std::uint32_t clip, std::uint32_t depth) noexcept
    {
        if (failed_) return;
        const std::uint32_t format = colr_.u8(at);
        if (depth == max_depth || paints_left_ == 0 || colr_.is_short()) {
            failed_ = error::bad_colours;
            return;
        }
        --paints_left_;
        const auto inner = [&](std::size_t field) noexcept { return at + colr_.u24(field); };
        switch (format) {
        case 1: read_layers(at, map, clip, depth); return;
        case 2:
        case 3: {
            glyph_paint paint;
            paint.entry = static_cast<std::uint16_t>(colr_.u16(at + 1));
            paint.colour = colour_of(paint.entry, alpha(at + 3, format == 3 ? colr_.u32(at + 5) : not_varied));
            add_layer(clip, paint);
            return;
        }
        case 4:
        case 5:
        case 6:
        case 7:
        case 8:
        case 9: read_gradient(at, format, map, clip); return;
        case 10: {
            const std::uint32_t own = shapes_.outline(colr_.u16(at + 4), map);
            paint_at(inner(at + 1), map, shapes_.both(clip, own), depth + 1);
            return;
        }
        case 11: read_glyph(colr_.u16(at + 1), map, clip, depth); return;
        case 32: read_composite(at, map, clip, depth); return;
        default:
            if (format < 12 || format > 31) {
                failed_ = error::bad_colours;
                return;
            }
            paint_at(inner(at + 1), read_transform(at, format, map), clip, depth + 1);
        }
    }

    /// A colour glyph within this one, which its own clip box limits, too.
    void read_glyph(glyph_id id, const affine& map, std::uint32_t clip, std::uint32_t depth) noexcept
    {
        const std::size_t root = root_of(id);
        if (root == 0) {
            failed_ = error::bad_colours;
            return;
        }
        if (const auto own = clip_of(id)) clip = shapes_.both(clip, shapes_.rectangle(*own, map));
        paint_at(root, map, clip, depth + 1);
    }

    void read_layers(std::size_t at, const affine& map, std::uint32_t clip, std::uint32_t depth) noexcept
    {
        const std::size_t count = colr_.u8(at + 1), first = colr_.u32(at + 2), all = colr_.u32(layer_list_);
        if (layer_list_ == 0 || first > all || count > all - first) failed_ = error::bad_colours;
        for (std::size_t i = first; i < first + count && !failed_; ++i)
            paint_at(layer_list_ + colr_.u32(layer_list_ + 4 + 4 * i), map, clip, depth + 1);
    }

    void read_composite(std::size_t at, const affine& map, std::uint32_t clip, std::uint32_t depth) noexcept
    {
        const std::size_t source = at + colr_.u24(at + 1), backdrop = at + colr_.u24(at + 5);
        const std::uint32_t mode = colr_.u8(at + 4);
        const std::size_t first = out_.layers.size();
        ++depth_of_groups_;
        paint_at(backdrop, map, clip, depth + 1);
        const std::size_t middle = out_.layers.size();
        paint_at(source, map, clip, depth + 1);
        --depth_of_groups_;
        if (failed_) return;
        layer_composite group{out_, shapes_, first, middle};
        if (!group.apply(mode))
            failed_ = error::bad_colours;
        else if (depth_of_groups_ == 0)
            settle(first);
    }

    /// Layers of a finished group that still fill the whole plane fill the clip box.
    void settle(std::size_t first) noexcept
    {
        std::size_t kept = first;
        for (std::size_t i = first; i < out_.layers.size(); ++i) {
            colour_layer layer = out_.layers[i];
            if (layer.shape == shape_builder::everything && out_.clip.empty()) {
                ++out_.unbounded;
                continue;
            }
            if (layer.shape == shape_builder::everything) layer.shape = shapes_.rectangle(out_.clip);
            out_.layers[kept++] = layer;
        }
        out_.layers.truncate(kept);
    }

    [[nodiscard]] affine read_transform(std::size_t at, std::uint32_t format, const affine& map) const noexcept
    {
        const bool varies = format % 2 == 1;
        transform_numbers n;
        if (format < 14) {
            const std::size_t matrix = at + colr_.u24(at + 4);
            const std::uint32_t base = varies ? colr_.u32(matrix + 24) : not_varied;
            for (std::uint32_t i = 0; i < 6; ++i)
                n.v[i] = (colr_.i32(matrix + 4 * std::size_t{i}) + change(base, i)) / 65536.0;
            return after(map, {n.v[0], n.v[2], n.v[4], n.v[1], n.v[3], n.v[5]});
        }
        const transform_fields f = fields_of(format);
        const std::uint32_t base = varies ? colr_.u32(at + 4 + 2 * std::size_t{f.count}) : not_varied;
        for (std::uint32_t i = 0; i < f.count; ++i) {
            const std::size_t field = at + 4 + 2 * std::size_t{i};
            n.v[i] = i < f.fractions ? f2dot14(field, base, i) : unit(field, base, i);
        }
        return after(map, transform_of(format, n));
    }

    void read_gradient(std::size_t at, std::uint32_t format, const affine& map, std::uint32_t clip) noexcept
    {
        const bool varies = format % 2 == 1;
        const std::size_t numbers = at + 4;
        glyph_paint p;
        p.placed = map;
        const auto place = [&](std::size_t field, std::uint32_t base, std::uint32_t which) noexcept -> point {
            return {unit(field, base, which), unit(field + 2, base, which + 1)};
        };
        if (format < 6) {
            const std::uint32_t base = varies ? colr_.u32(numbers + 12) : not_varied;
            p.kind = paint_kind::linear;
            p.from = place(numbers, base, 0);
            p.to = place(numbers + 4, base, 2);
            p.across = place(numbers + 8, base, 4);
        } else if (format < 8) {
            const std::uint32_t base = varies ? colr_.u32(numbers + 12) : not_varied;
            p.kind = paint_kind::radial;
            p.from = place(numbers, base, 0);
            p.from_radius = length(numbers + 4, base, 2);
            p.to = place(numbers + 6, base, 3);
            p.to_radius = length(numbers + 10, base, 5);
        } else {
            const std::uint32_t base = varies ? colr_.u32(numbers + 8) : not_varied;
            p.kind = paint_kind::sweep;
            p.from = place(numbers, base, 0);
            p.from_turn = f2dot14(numbers + 4, base, 2) + 1.0;  // stored less one half turn
            p.to_turn = f2dot14(numbers + 6, base, 3) + 1.0;
        }
        if (read_stops(at + colr_.u24(at + 1), varies, p)) add_layer(clip, p);
    }

    [[nodiscard]] bool read_stops(std::size_t line, bool varies, glyph_paint& p) noexcept
    {
        const std::uint32_t extend = colr_.u8(line), count = colr_.u16(line + 1);
        const std::size_t stride = varies ? 10 : 6;
        if (extend == 1) p.extend = gradient_extend::repeat;
        if (extend == 2) p.extend = gradient_extend::reflect;
        if (count == 0 || count > paints_left_ || line + 3 + stride * count > colr_.size()) {
            failed_ = error::bad_colours;
            return false;
        }
        paints_left_ -= count;
        p.first_stop = static_cast<std::uint32_t>(out_.stops.size());
        p.stop_count = count;
        double sum[4] = {};
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = line + 3 + stride * i;
            const std::uint32_t base = varies ? colr_.u32(at + 6) : not_varied;
            const double opacity = (colr_.i16(at + 4) + change(base, 1)) / 16384.0;
            gradient_stop stop{f2dot14(at, base, 0), {}, static_cast<std::uint16_t>(colr_.u16(at + 2))};
            stop.colour = colour_of(stop.entry, opacity < 0.0 ? 0.0 : opacity > 1.0 ? 1.0 : opacity);
            if (!out_.stops.push_back(stop)) {
                failed_ = error::out_of_memory;
                return false;
            }
            // Each stop is put in its place among those before it; stops that descend use up the paints.
            for (std::size_t k = out_.stops.size() - 1; k > p.first_stop && out_.stops[k].at < out_.stops[k - 1].at;
                 --k) {
                if (paints_left_ == 0) {
                    failed_ = error::bad_colours;
                    return false;
                }
                --paints_left_;
                const gradient_stop later = out_.stops[k - 1];
                out_.stops[k - 1] = out_.stops[k];
                out_.stops[k] = later;
            }
            sum[0] += stop.colour.red;
            sum[1] += stop.colour.green;
            sum[2] += stop.colour.blue;
            sum[3] += as_double(stop.colour.alpha);
        }
        const auto mean = [&](double total) noexcept { return static_cast<std::uint8_t>(total / count + 0.5); };
        p.colour = {mean(sum[0]), mean(sum[1]), mean(sum[2]), static_cast<float>(sum[3] / count)};
        return true;
    }

    table_bytes colr_, cpal_;
    palette_colour foreground_;
    std::uint32_t max_layers_, paints_left_;
    colour_glyph& out_;
    shape_builder shapes_;
    variation_deltas deltas_;
    std::size_t base_list_ = 0, layer_list_ = 0, clip_list_ = 0;
    std::uint32_t entries_ = 0;  // of the palette
    std::size_t colours_ = 0;    // the place of its first colour
    std::uint32_t depth_of_groups_ = 0;
    error failed_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

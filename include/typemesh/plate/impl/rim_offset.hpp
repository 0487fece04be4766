// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/bevel_profile.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The section of a rim's strips.
enum class rim_section : std::uint8_t {
    chamfer,  ///< a bevel of 45 degrees, into the region
    round,    ///< a bevel that is a quarter of a circle, into the region
    fillet,   ///< a hollow quarter of a circle, around the region
};

/// An outline and its offset, with the strips between them: what a bevel or a fillet of a layered solid needs. The
/// strips are the front of a bevelled solid, so they share all points with the outline and with its offset.
class rim_offset {
public:
    explicit rim_offset(memory source = heap()) noexcept
        : given_{source}, curves_{source}, triangles_{source}, data_{source}, builder_{source}, further_{source}
    {
    }

    /// Moves the outline of a region by `width` em, at most by 2^24 cells, and for a fillet at most by a quarter of its
    /// distance from the grid's end, less 32 cells. It moves less if the offset is not proven simple.
    ///
    ///     tolerance   the deviation of round corners and sections, in cells
    ///
    /// Returns the width that was reached; 0 if there are no strips. The region is copied: its loops may change
    /// afterwards.
    /// Fails  as the triangulator and bevelled::plan() do
    [[nodiscard]] result<float> plan(const region& r, rim_section section, float width, double tolerance,
                                     triangulator_ref cut) noexcept
    {
        data_.clear();
        triangles_.clear();
        const double em = r.grid().cells * r.grid().units_per_em;
        const auto widest = static_cast<float>(widest_move(r, section) / em);
        if (widest < width) width = widest;
        if (!(width > 0.0f)) return 0.0f;
        if (error e = take(r, tolerance)) return e;
        const region own = region::proven(given_, r.holes(), r.outers(), r.is_touching());
        if (error e = cut.cut(own, builder_.space(), triangles_)) return e;
        region_caps caps{builder_, further_, cut, triangles_.view()};
        bevelled how{.depth = 4.0f * width, .width = width, .bevel_depth = width, .sides = bevel_sides::front};
        how.outward = section == rim_section::fillet;
        if (how.outward) how.mitre_limit = 1.0f;  // a ball that rolls around a corner leaves it round
        how.crease_degrees = 30.0f;
        how.side = false;
        how.profile = section == rim_section::chamfer ? chamfer_profile()
                      : section == rim_section::round ? round_profile()
                                                      : concave_profile();
        const auto made = how.plan(own, data_, caps);
        if (!made) return is_refusal(made.error()) ? result<float>{0.0f} : result<float>{made.error()};
        if (data_.of<bevel_rims>().empty()) return 0.0f;
        const bevel_rims& rims = data_.of<bevel_rims>()[0];
        if (rims.own_cap || rims.outward != how.outward) return 0.0f;
        return rims.width < width ? rims.width : width;
    }

    /// The offset of the outline, as a region's loops, and the triangles of this region.
    [[nodiscard]] array_view<const grid_point> points() noexcept { return data_.of<grid_point>().view(); }
    [[nodiscard]] array_view<const std::uint32_t> starts() noexcept { return data_.of<std::uint32_t>().view(); }
    [[nodiscard]] array_view<const triangle> triangles() noexcept { return data_.of<triangle>().view(); }

    /// Twice the area of this region, in cells; exact.
    [[nodiscard]] std::int64_t doubled_area() noexcept
    {
        std::int64_t sum = 0;
        const auto at = points();
        for (const triangle& t : triangles()) sum += orientation(at[t.a], at[t.b], at[t.c]);
        return sum;
    }

    [[nodiscard]] array_view<const bevel_vertex> strip_vertices() noexcept { return data_.of<bevel_vertex>().view(); }
    [[nodiscard]] array_view<const bevel_triangle> strip_triangles() noexcept
    {
        return data_.of<bevel_triangle>().view();
    }
    [[nodiscard]] array_view<const bevel_strip> strips() noexcept { return data_.of<bevel_strip>().view(); }

    /// Whether an error only says that this width is impossible.
    [[nodiscard]] static bool is_refusal(const error& e) noexcept
    {
        return e == error::crossing_contours || e == error::outline_beyond_grid;
    }

private:
    /// The greatest width that is tried, in cells. surround() needs four times as much room around a fillet's outline.
    [[nodiscard]] static double widest_move(const region& r, rim_section section) noexcept
    {
        constexpr double widest = 0x1p24;
        if (section != rim_section::fillet) return widest;
        double farthest = 0.0;
        for (const grid_point p : r.points())
            for (const double v : {std::fabs(p.x), std::fabs(p.y)}) farthest = v > farthest ? v : farthest;
        const double room = 0.25 * (grid::reach - farthest) - 32.0;
        return room < widest ? room : widest;
    }

    /// Copies a region. Each of its edges becomes a straight curve of its own.
    [[nodiscard]] error take(const region& r, double tolerance) noexcept
    {
        given_.clear();
        curves_.clear();
        given_.grid = r.grid();
        given_.tolerance = tolerance;
        given_.corners = r.is_touching() ? touching::keep : touching::part;
        const auto points = r.points();
        if (!given_.points.append(points) || !given_.starts.append(r.starts()) ||
            !given_.edges.reserve(points.size()) || !curves_.reserve(points.size()))
            return error::out_of_memory;
        const double unit = 1.0 / r.grid().cells;
        const auto in_font_units = [unit](grid_point p) noexcept { return point{unit * p.x, unit * p.y}; };
        for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
            const std::uint32_t begin = r.starts()[k], end = r.starts()[k + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                given_.edges.push_back_unchecked({i, 0.0f, 1.0f});
                curves_.push_back_unchecked(
                    curve::from(in_font_units(points[i]), in_font_units(points[i + 1 == end ? begin : i + 1])));
            }
        }
        given_.curves = curves_.view();
        return {};
    }

    contours given_;
    buffer<curve> curves_;
    triangle_list triangles_;
    bevel_data data_;
    cap_builder builder_, further_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>
#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/impl/edge_normals.hpp>
#include <typemesh/plate/impl/rim_fitting.hpp>
#include <typemesh/plate/impl/rim_offset.hpp>
#include <typemesh/plate/impl/rim_sheets.hpp>
#include <typemesh/plate/impl/slab_walls.hpp>
#include <typemesh/plate/layer_arrangement.hpp>
#include <typemesh/plate/layered_placement.hpp>
#include <typemesh/plate/layered_slab.hpp>
#include <typemesh/plate/plate_part.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>
#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/part.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A solid made of horizontal slabs. In each slab, it fills a set of cells of one arrangement.
///
///                .----.    top of slab 1            solid.plan(cells, bottom, slabs, ...)   makes the caps and counts
///                | A  |                             solid.size(), solid.write(sink, at)     as of a text_plan
///       .--------+----+-------.   top of slab 0
///       |         B           |                     slab 1 fills the cells of A, slab 0 the cells of both
///       '---------------------'   bottom
///
/// Bevels cut the rims of slabs, and fillets surround the feet of slabs that stand within the slab below. Both are the
/// strips of an exact offset (bevelled), and share all points with the walls and floors beside them. Fillets and bevels
/// that would meet others become narrower or are left out: see bevel() and fillet().
///
/// A wall stands on a piece of the arrangement where one side is filled and the other is not. It is one wall through
/// all slabs in which this is so, with a point on its vertical edges at each level at which other edges end there. A
/// cap lies at each level over the cells that only one of the two slabs fills. No solids are intersected or joined.
///
/// Every directed edge is met by its reverse equally often, always. More than two faces meet only
///
///     touching()   above points where the cells of a slab touch each other in a point,
///     hanging()    in edges where a slab fills one side and the next slab only the other side.
///
/// If both are 0, and each slab's cells contain the next slab's cells, or the other way round, the mesh is strictly
/// 2-manifold.
class layered_solid {
public:
    using slab = layered_slab;
    /// The greatest number of slabs.
    static constexpr std::size_t max_slabs = detail::slab_walls::max_slabs;

    explicit layered_solid(memory source = heap()) noexcept
        : loops_{source},
          caps_{source},
          points_{source},
          triangles_{source},
          levels_{source},
          normals_{source},
          rims_{source},
          sheets_{source}
    {
    }

    /// Plans a solid. `cells` must not change as long as the solid is used.
    ///
    ///     base         the lower side of the first slab, and how rims are made; or only its height
    ///     rim_sources  walls on sources with lower numbers belong to plate_part::rim, all others to plate_part::wall
    ///
    /// Fails  error::bad_option: no slab or more than max_slabs, where a level with a bevel or a fillet counts as one
    ///        more ("slabs"); a lower side that is not at a finite height ("height"); upper sides that do not ascend
    ///        or are not finite ("top"); a bevel or a fillet that is not
    ///        finite or is negative ("bevel"); a rim of another slab than the last, or one that does not contain the
    ///        slab's cells ("rim"); an unbounded set ("cells"); a scale that is not positive ("unit_per_em"); a
    ///        tolerance that is negative ("tolerance"); a bevel or a fillet on a grid without units ("units_per_em").
    ///        error::too_large, error::out_of_memory, and errors of the triangulator. The solid is then empty
    /// Cost   one triangulation per level, and O(pieces * slabs). A level with a bevel or a fillet is offset and swept
    ///        once more for each, up to 32 times if they do not fit
    [[nodiscard]] result<void> plan(layer_arrangement& cells, const layered_base& base, array_view<const slab> slabs,
                                    std::uint32_t rim_sources, triangulator_ref cut, workspace& space) noexcept
    {
        clear();
        const error e = try_to_plan(cells, base, slabs, rim_sources, cut, space);
        if (e) clear();
        return e;
    }

    [[nodiscard]] result<void> plan(layer_arrangement& cells, float bottom, array_view<const slab> slabs,
                                    std::uint32_t rim_sources, triangulator_ref cut, workspace& space) noexcept
    {
        return plan(cells, layered_base{.height = bottom}, slabs, rim_sources, cut, space);
    }

    /// Makes the solid empty.
    void clear() noexcept
    {
        caps_.clear();
        points_.clear();
        triangles_.clear();
        levels_.clear();
        sheets_.clear();
        walls_ = {};
        lower_ = 0.0f;
        for (detail::rim_widths& w : widths_) w = {};
        of_rims_ = 0.0;
        touching_ = hanging_ = 0;
        for (mesh_size& s : sizes_) s = {};
        cells_ = nullptr;
    }

    /// The exact numbers of vertices and triangles that write() will emit.
    [[nodiscard]] mesh_size size() const noexcept
    {
        mesh_size all;
        for (const mesh_size& s : sizes_) all = all + s;
        return all;
    }
    [[nodiscard]] mesh_size size(plate_part p) const noexcept { return sizes_[static_cast<std::size_t>(p)]; }

    /// The range of a part in the output.
    [[nodiscard]] mesh_range range(plate_part p) const noexcept
    {
        mesh_size before;
        for (const plate_part k : all_plate_parts)
            if (k < p) before = before + size(k);
        return {static_cast<std::uint32_t>(before.vertices), static_cast<std::uint32_t>(size(p).vertices),
                static_cast<std::uint32_t>(before.indices()), static_cast<std::uint32_t>(size(p).indices())};
    }

    /// The number of points at which the cells of a slab touch each other, counted once for each slab.
    [[nodiscard]] std::uint32_t touching() const noexcept { return touching_; }
    /// The number of pieces above which one side is filled and below which only the other side is.
    [[nodiscard]] std::uint32_t hanging() const noexcept { return hanging_; }

    /// The width that the bevel of slab k has reached, in em: less than requested if it had to fit. k < max_slabs.
    [[nodiscard]] float bevel(std::size_t k) const noexcept { return widths_[k].bevel; }
    /// The radius that the fillet at the foot of slab k has reached, likewise.
    [[nodiscard]] float fillet(std::size_t k) const noexcept { return widths_[k].fillet; }
    /// The width that the bevel of the lower rim has reached, likewise.
    [[nodiscard]] float lower_bevel() const noexcept { return lower_; }

    /// The volume, in grid cells times output units: the areas of the slabs are exact.
    [[nodiscard]] double volume() const noexcept
    {
        double sum = of_rims_;
        for (std::uint32_t k = 0; k < walls_.slab_count; ++k)
            sum += 0.5 * static_cast<double>(cells_->doubled_area(walls_.filled[k])) *
                   (as_double(walls_.height[k + 1]) - as_double(walls_.height[k]));
        return sum;
    }

    /// Emits every vertex and every triangle once, in ascending order, part by part. Of a surface point's attributes,
    /// position, normal, tangent, part and uv are set; the others say that they are unknown. uv are everywhere as on
    /// caps in em mapping (texture.hpp). On walls they do not change from bottom to top, so the tangent there is the
    /// one of box mapping (texture_tangent.hpp).
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink, const layered_placement& to) const noexcept
    {
        if (!size().fits_32_bits()) return error::too_large;
        if (error e = sink.begin(size())) return e;
        for (const plate_part p : all_plate_parts) write_vertices(p, sink, to);
        std::uint32_t first = 0;
        for (const plate_part p : all_plate_parts) write_triangles(p, sink, to, first);
        return end_of(sink);
    }

private:
    /// A cap of one level: a region with its triangles.
    struct level_cap {
        plate_part of;
        bool up;
        float height;
        std::uint32_t first_point, point_count, first_triangle, triangle_count;
    };

    [[nodiscard]] error try_to_plan(layer_arrangement& cells, const layered_base& base, array_view<const slab> slabs,
                                    std::uint32_t rim_sources, triangulator_ref cut, workspace& space) noexcept
    {
        if (slabs.empty() || slabs.size() > max_slabs) return error::bad("slabs");
        if (!is_finite(as_double(base.height))) return error::bad("height");
        cells_ = &cells;
        rim_sources_ = rim_sources;
        if (error e = detail::settle_widths(base, slabs, lower_, widths_)) return e;
        least_width_ = static_cast<float>(detail::least_rim_width(base, slabs));
        for (const slab& s : slabs) {
            if (s.filled.is_unbounded()) return error::bad("cells");
            if (cells.doubled_area(s.filled & ~s.outline()) != 0) return error::bad("rim");
            cells.each_touching(s.filled, [this](grid_point) noexcept { ++touching_; });
        }
        if (error e = make_lower_side(cells, base, slabs[0].filled, cut, space)) return e;
        std::size_t highest = slabs.size();  // the slab with the highest cap; later slabs may be empty
        while (highest > 1 && cells.doubled_area(slabs[highest - 1].filled) == 0) --highest;
        for (std::size_t k = 0; k < slabs.size(); ++k) {
            const plate_part of = k + 1 == highest ? plate_part::front : plate_part::floor;
            if (error e = make_level(cells, base, {slabs, k, of}, cut, space)) return e;
        }
        if (error e = stack(base, slabs)) return e;
        return count_walls(cells);
    }

    /// The upper side of slab k.
    struct upper_side {
        array_view<const slab> slabs;
        std::size_t k;
        plate_part of;  // of its cap
    };

    /// Makes the caps at the upper side of a slab, with its bevel and the next slab's fillet.
    [[nodiscard]] error make_level(layer_arrangement& cells, const layered_base& base, const upper_side& at,
                                   triangulator_ref cut, workspace& space) noexcept
    {
        const slab& own = at.slabs[at.k];
        const bool has_next = at.k + 1 < at.slabs.size();
        const cell_set over = has_next ? at.slabs[at.k + 1].filled : own.pockets();
        detail::rim_widths widths{widths_[at.k].bevel, has_next ? widths_[at.k + 1].fillet : 0.0f};
        if (widths.bevel > 0.0f || widths.fillet > 0.0f) {
            if (error e = rims_.fit(cells, own.outline(), over, widths, shape_of(base), cut)) return e;
            widths_[at.k].bevel = widths.bevel;
            if (has_next) widths_[at.k + 1].fillet = widths.fillet;
        }
        if (!(widths.bevel > 0.0f) && !(widths.fillet > 0.0f)) {
            const level_cap up{at.of, true, own.top, 0, 0, 0, 0}, down{plate_part::back, false, own.top, 0, 0, 0, 0};
            if (error e = make_cap(cells, own.filled & ~over, up, cut, space)) return e;
            if (!has_next) return {};
            return make_cap(cells, over & ~own.filled, down, cut, space);
        }
        if (error e = keep_cap({at.of, true, own.top, 0, 0, 0, 0})) return e;
        const bool is_front = at.of == plate_part::front;
        if (widths.bevel > 0.0f)
            if (error e = keep_bevel(is_front ? plate_part::front_bevel : plate_part::floor_bevel, own.top,
                                     base.depth(widths.bevel), base))
                return e;
        if (!(widths.fillet > 0.0f)) return {};
        const float rise = base.depth(widths.fillet);
        of_rims_ += as_double(rise) * 0.5 * static_cast<double>(cells.doubled_area(over));
        return keep_sheet(rims_.outer(), {static_cast<std::uint32_t>(plate_part::floor_bevel),
                                          detail::rim_section::fillet, true, own.top, own.top + rise});
    }

    /// Makes the cap at the lower side of the first slab, with its bevel.
    [[nodiscard]] error make_lower_side(layer_arrangement& cells, const layered_base& base, cell_set filled,
                                        triangulator_ref cut, workspace& space) noexcept
    {
        const level_cap down{plate_part::back, false, base.height, 0, 0, 0, 0};
        if (lower_ > 0.0f)
            if (error e = rims_.fit_lower(cells, filled, lower_, shape_of(base), cut)) return e;
        if (!(lower_ > 0.0f)) return make_cap(cells, filled, down, cut, space);
        if (error e = keep_cap(down)) return e;
        return keep_bevel(plate_part::back_bevel, base.height, -base.depth(lower_), base);
    }

    [[nodiscard]] detail::rim_fitting::shape shape_of(const layered_base& base) const noexcept
    {
        return {base.round ? detail::rim_section::round : detail::rim_section::chamfer, base.tolerance, least_width_};
    }

    /// Keeps the strips of the bevel around a cap at a height, from the wall's end `deep` below it. Negative: above it.
    [[nodiscard]] error keep_bevel(plate_part of, float height, float deep, const layered_base& base) noexcept
    {
        of_rims_ += std::fabs(as_double(deep)) * 0.5 * static_cast<double>(rims_.inner().doubled_area());
        return keep_sheet(rims_.inner(),
                          {static_cast<std::uint32_t>(of), shape_of(base).section, deep > 0.0f, height - deep, height});
    }
    [[nodiscard]] error keep_sheet(detail::rim_offset& made, const detail::rim_sheets::sheet& how) noexcept
    {
        if (error e = sheets_.add(made, how)) return e;
        const detail::rim_sheets::sheet& s = sheets_.all().back();
        of_rims_ += std::fabs(as_double(s.to) - as_double(s.from)) * sheets_.volume(s);
        mesh_size& size = sizes_[s.of];
        size = size + mesh_size{s.vertex_count, s.triangle_count};
        return {};
    }
    /// Keeps the floor that the rims have left.
    [[nodiscard]] error keep_cap(level_cap made) noexcept
    {
        const auto points = rims_.points();
        const auto triangles = rims_.triangles();
        if (points.empty()) return {};
        if (!fits(points.size(), triangles.size())) return error::too_large;
        made.first_triangle = static_cast<std::uint32_t>(triangles_.size());
        if (!triangles_.append(triangles)) return error::out_of_memory;
        return add_cap(made, points);
    }

    /// The levels of the walls. Where a level has a bevel or a fillet, an empty slab lies between two walls; where the
    /// walls of pockets go on, a slab that fills all but the pockets.
    [[nodiscard]] error stack(const layered_base& base, array_view<const slab> slabs) noexcept
    {
        walls_.height[0] = lower_ > 0.0f ? base.height + base.depth(lower_) : base.height;
        for (std::size_t k = 0; k < slabs.size(); ++k) {
            const float bevel = widths_[k].bevel, fillet = k + 1 < slabs.size() ? widths_[k + 1].fillet : 0.0f;
            if (error e = add_walls(slabs[k].filled, bevel > 0.0f ? slabs[k].top - base.depth(bevel) : slabs[k].top))
                return e;
            const cell_set open = slabs[k].pockets();  // its walls go on beside the bevel
            if (!(bevel > 0.0f || fillet > 0.0f) || (k + 1 == slabs.size() && open.labels == 0)) continue;
            if (error e = add_walls(open.labels != 0 ? ~open : cell_set{},
                                    fillet > 0.0f ? slabs[k].top + base.depth(fillet) : slabs[k].top))
                return e;
        }
        return {};
    }
    [[nodiscard]] error add_walls(cell_set filled, float top) noexcept
    {
        if (walls_.slab_count == max_slabs) return error::bad("slabs");
        if (!(top > walls_.height[walls_.slab_count])) return error::bad("top");
        walls_.filled[walls_.slab_count++] = filled;
        walls_.height[walls_.slab_count] = top;
        return {};
    }

    [[nodiscard]] error make_cap(layer_arrangement& cells, cell_set facing, level_cap made, triangulator_ref cut,
                                 workspace& space) noexcept
    {
        const auto r = cells.trace(facing, space, loops_);
        if (!r) return r.error();
        if (r->points().empty()) return {};
        if (!fits(r->points().size(), r->triangle_count())) return error::too_large;
        made.first_triangle = static_cast<std::uint32_t>(triangles_.size());
        if (error e = cut.cut(*r, space, triangles_)) return e;
        return add_cap(made, r->points());
    }
    /// Whether so many more points and triangles have numbers.
    [[nodiscard]] bool fits(std::size_t points, std::size_t triangles) const noexcept
    {
        return points_.size() + points <= 0xFFFF'FFFFu && triangles_.size() + triangles <= 0xFFFF'FFFFu;
    }
    /// Adds the points of a cap whose triangles are the last ones.
    [[nodiscard]] error add_cap(level_cap made, array_view<const grid_point> points) noexcept
    {
        made.first_point = static_cast<std::uint32_t>(points_.size());
        made.point_count = static_cast<std::uint32_t>(points.size());
        made.triangle_count = static_cast<std::uint32_t>(triangles_.size()) - made.first_triangle;
        if (!points_.append(points) || !caps_.push_back(made)) return error::out_of_memory;
        mesh_size& s = sizes_[static_cast<std::size_t>(made.of)];
        s = s + mesh_size{made.point_count, made.triangle_count};
        return {};
    }

    [[nodiscard]] error count_walls(const layer_arrangement& cells) noexcept
    {
        std::uint32_t* const levels = levels_.append(cells.point_count());
        if (levels == nullptr && cells.point_count() != 0) return error::out_of_memory;
        for (std::size_t p = 0; p < cells.point_count(); ++p) levels[p] = 0;
        for (std::size_t i = 0; i < cells.piece_count(); ++i) {
            const auto s = cells[i];
            const std::uint32_t own = walls_.levels_of(s, hanging_);
            levels[s.start] |= own;
            levels[s.end] |= own;
        }
        if (error e = normals_.find(cells)) return e;
        each_wall([this](const auto& s, const detail::slab_walls::wall& w) noexcept {
            mesh_size& size = sizes_[static_cast<std::size_t>(part_of(s))];
            size = size + mesh_size{w.vertex_count(), w.triangle_count()};
        });
        return {};
    }

    [[nodiscard]] plate_part part_of(const layer_arrangement::piece& s) const noexcept
    {
        return s.source.curve < rim_sources_ ? plate_part::rim : plate_part::wall;
    }

    template <class Put>
    void each_wall(Put&& put) const noexcept
    {
        if (cells_ == nullptr) return;
        for (std::size_t i = 0; i < cells_->piece_count(); ++i) {
            const auto s = (*cells_)[i];
            walls_.each(s, levels_[s.start], levels_[s.end],
                        [&](const detail::slab_walls::wall& w) noexcept { put(s, w); });
        }
    }

    template <class Sink>
    void write_vertices(plate_part p, Sink& sink, const layered_placement& to) const noexcept
    {
        constexpr attribute wants = std::remove_reference_t<Sink>::wants;
        const planar_texture uv{texture_mapping::em, to.at};
        const texture_tangent tangents{to.at.frame};
        const auto put = [&](grid_point at, float height, vec3 normal, const auto& tangent) noexcept {
            const grid_point placed = to.place(at);
            surface_point<wants> v;
            if constexpr (has(wants, attribute::position)) v.position = to.at.position(placed, height);
            if constexpr (has(wants, attribute::normal)) v.normal = normal;
            if constexpr (has(wants, attribute::tangent)) v.tangent = tangent();
            if constexpr (has(wants, attribute::part)) v.part = static_cast<part>(p);
            if constexpr (has(wants, attribute::uv)) v.uv = uv(placed);
            sink.vertex(v);
        };
        for (const level_cap& c : caps_) {
            if (c.of != p) continue;
            const float facing = c.up ? 1.0f : -1.0f;
            const vec3 normal = to.at.direction(0.0f, 0.0f, facing);
            for (std::uint32_t i = 0; i < c.point_count; ++i)
                put(points_[c.first_point + i], c.height, normal,
                    [&]() noexcept { return tangents.on_cap(to.at, facing); });
        }
        for (const detail::rim_sheets::sheet& s : sheets_.all()) {
            if (s.of != static_cast<std::uint32_t>(p)) continue;
            const float facing = s.up ? 1.0f : -1.0f;
            for (const detail::rim_sheets::vertex& v : sheets_.vertices(s)) {
                const vec2 outward = to.turn(v.outward);
                const vec3 n{v.out * outward.x, v.out * outward.y, facing * v.up};
                put(v.at, detail::rim_sheets::height(s, v), to.at.direction(n),
                    [&]() noexcept { return tangents.on_rim(to.at, n, facing); });
            }
        }
        if (p != plate_part::rim && p != plate_part::wall) return;
        each_wall([&](const layer_arrangement::piece& s, const detail::slab_walls::wall& w) noexcept {
            if (part_of(s) != p) return;
            const auto put_column = [&](grid_point at, std::uint32_t levels, float t) noexcept {
                const vec2 n = to.turn(normals_.at(s, t, w.side));
                w.each_height(levels, [&, normal = to.at.normal(n)](std::uint32_t level) noexcept {
                    put(at, walls_.height[level], normal, [&]() noexcept { return tangents.on_wall(to.at, n); });
                });
            };
            put_column(s.from, w.at_from, s.source.t0);
            put_column(s.to, w.at_to, s.source.t1);
        });
    }

    template <class Sink>
    void write_triangles(plate_part p, Sink& sink, const layered_placement& to, std::uint32_t& first) const noexcept
    {
        const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) noexcept {
            if (turned != to.turns_triangles())
                sink.triangle(a, c, b);
            else
                sink.triangle(a, b, c);
        };
        for (const level_cap& c : caps_) {
            if (c.of != p) continue;
            for (std::uint32_t i = 0; i < c.triangle_count; ++i) {
                const triangle& t = triangles_[c.first_triangle + i];
                put(first + t.a, first + t.b, first + t.c, !c.up);
            }
            first += c.point_count;
        }
        for (const detail::rim_sheets::sheet& s : sheets_.all()) {
            if (s.of != static_cast<std::uint32_t>(p)) continue;
            for (const triangle& t : sheets_.triangles(s)) put(first + t.a, first + t.b, first + t.c, !s.up);
            first += s.vertex_count;
        }
        if (p != plate_part::rim && p != plate_part::wall) return;
        each_wall([&](const layer_arrangement::piece& s, const detail::slab_walls::wall& w) noexcept {
            if (part_of(s) != p) return;
            w.each_triangle([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
                put(first + a, first + b, first + c, w.side < 0);
            });
            first += w.vertex_count();
        });
    }

    contours loops_;
    buffer<level_cap> caps_;
    buffer<grid_point> points_;
    triangle_list triangles_;
    buffer<std::uint32_t> levels_;  // for each point: the levels at which edges of the mesh end there
    detail::edge_normals normals_;
    detail::slab_walls walls_;
    detail::rim_fitting rims_;
    detail::rim_sheets sheets_;
    detail::rim_widths widths_[max_slabs];  // of each slab's upper rim and of its foot
    float lower_ = 0.0f, least_width_ = 0.0f;
    double of_rims_ = 0.0;  // the volume beside the walls' slabs
    const layer_arrangement* cells_ = nullptr;
    std::uint32_t rim_sources_ = 0, touching_ = 0, hanging_ = 0;
    mesh_size sizes_[sizeof all_plate_parts];  // by the part's number
};

}  // namespace typemesh::inline TYPEMESH_ABI

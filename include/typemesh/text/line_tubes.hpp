// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/discretise/quality.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/tube_clearance.hpp>
#include <typemesh/extrude/impl/tube_fitting.hpp>
#include <typemesh/extrude/impl/tube_surface.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/side_point.hpp>
#include <typemesh/text/cells_told_apart.hpp>
#include <typemesh/text/impl/line_points.hpp>
#include <typemesh/vertex/frame.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The shape of tubes along lines.
struct tube_style {
    float radius = 0.02f;            ///< in em; positive
    std::uint32_t sides = 16;        ///< of the section, 3 to 128
    tube_end end = tube_end::round;  ///< the ends of open lines
    float crease_degrees = 15.0f;    ///< corners sharper than this are hard, 0 to 180
    texture_mapping texture = texture_mapping::em;
    float corner_cut = 0.5f;  ///< how far tubes may leave curves beside sharp corners, 0 to 1: see tubed

    /// The error for options out of range, or none.
    [[nodiscard]] error refused() const noexcept { return detail::tube_section::refused(*this); }
};

/// The result of planning tubes along lines.
struct tube_report {
    std::uint32_t lines = 0;       ///< the number of lines that are longer than a point
    std::uint32_t narrowed = 0;    ///< the number of lines whose tube is thinner than wanted
    std::uint32_t lost = 0;        ///< among them, the number of lines without a tube
    std::uint32_t meeting = 0;     ///< the number of lines that cross or touch another one or themselves
    float smallest_radius = 0.0f;  ///< of all tubes, in em; 0 without a tube
};

/// Round tubes along lines, open and closed: neon letters of single-line fonts, wires, pipes.
///
///     .---------------.          line_tubes tubes;
///    (_________________)         tubes.begin(source.units_per_em());
///                                for (...) { tubes.put_at(pen); source.outline(glyph, tubes); }
///                                if (auto done = tubes.plan({.radius = 0.03f}); !done) ...
///                                tubes.write(into(vertices, indices), tubes.placed(size));
///
/// It is an outline_sink. A line is closed if close() ends it; all others are open, and get an end at both sides. Each
/// line is one closed solid: a ring or a rod. See tubed, whose rules for corners, radii, normals and texture
/// coordinates are the same, for the outlines of letters. texture_mapping::box spans all tubes. An open
/// line needs room for its round end, also where the end is flat.
///
/// A tube is lost, too, where 32-bit floats do not tell the corners of its sections apart: with 16 sides, beyond
/// 2^22 / 7 radii from the origin. In frames that are not parallel to the axes this is guaranteed up to an eighth of
/// that only.
///
/// Lines that cross or touch, as many in single-line fonts do, are counted (tube_report::meeting). Two lines that meet
/// are not kept apart from each other, and a line that meets itself not from itself: their solids overlap. All other
/// pairs of lines are kept apart, so a line that ends just short of another one has a thin tube. A line that returns on
/// itself at a point has no tube (tube_report::lost).
///
/// Memory is kept for the next lines; it is O(n) for n points, and 8 bytes for each pair of lines that meet.
class line_tubes {
public:
    explicit line_tubes(memory source = heap()) noexcept
        : lines_{source},
          points_{source},
          starts_{source},
          open_{source},
          sides_{source},
          joints_{source},
          paths_{source},
          fitting_{source}
    {
    }

    /// Begins a new drawing, whose em has so many units. `tolerance` is the distance between lines and their chords, in
    /// em.
    void begin(double units_per_em, double tolerance = quality::high) noexcept
    {
        lines_.clear();
        clear_plan();
        units_per_em_ = units_per_em;
        tolerance_ = tolerance;
        lines_.tolerance = tolerance > 0.0 && units_per_em > 0.0 ? tolerance * units_per_em : 1.0;
    }
    /// Moves the lines that follow, in units: the origin of the next glyph.
    void put_at(point pen) noexcept { lines_.pen = pen; }

    // See outline_sink.
    void move(point p) noexcept { lines_.move(p); }
    void line(point p) noexcept { lines_.line(p); }
    void quadratic(point control, point p) noexcept { lines_.quadratic(control, p); }
    void cubic(point a, point b, point p) noexcept { lines_.cubic(a, b, p); }
    void close() noexcept { lines_.close(); }

    /// Plans the tubes along all lines so far.
    ///
    /// Fails  error::bad_option: "radius", "sides", "crease_degrees", "corner_cut", "units_per_em", "tolerance"
    ///        error::bad_outline: a line did not begin with move(); error::outline_not_finite,
    ///        error::outline_beyond_grid, error::too_large, error::out_of_memory. There are then no tubes
    /// Cost   as tubed
    [[nodiscard]] result<tube_report> plan(const tube_style& style) noexcept
    {
        clear_plan();
        const error e = try_to_plan(style);
        if (e) {
            clear_plan();
            return e;
        }
        return report_;
    }

    /// The exact numbers of vertices and triangles that write() makes.
    [[nodiscard]] mesh_size size() const noexcept { return size_; }

    /// The position of the drawing in the output: an em is `size` units long, the origin is at 0.
    [[nodiscard]] placement placed(double size = 1.0, const frame& f = right_handed_y_up) const noexcept
    {
        placement at;
        at.frame = f;
        at.unit_per_depth = size;
        at.em_per_cell = 1.0 / em_;
        at.unit_per_cell = size / em_;
        at.texture_pen = -1.0 * box_.low;
        at.texture_per_cell = {box_.width() > 0.0 ? 1.0 / box_.width() : 0.0,
                               box_.height() > 0.0 ? 1.0 / box_.height() : 0.0};
        return at;
    }

    /// Writes the tubes, line by line. Attributes of glyphs and letters keep their defaults; all vertices belong to
    /// part::side.
    ///
    /// Fails  error::bad_option: an em of `at` is not 2^-100 to 2^30 output units long, or not every position fits into
    ///        a float ("size"); the smallest radius does not ("radius"); error::too_large. The sink is then untouched.
    ///        Besides as the sink does
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink, const placement& at) const noexcept
    {
        if (!size_.fits_32_bits()) return error::too_large;
        if (error e = refused(at)) return e;
        if (error e = sink.begin(size_)) return e;
        constexpr attribute wants = std::remove_reference_t<Sink>::wants;
        const auto vertex = [&sink](surface_point<wants> v) noexcept {
            if constexpr (has(wants, attribute::part)) v.part = part::side;
            sink.vertex(v);
        };
        const detail::tube_surface all = surface();
        with_axes(at, [&](const auto& axes) noexcept { all.template vertices<wants>(axes, at, vertex); });
        const bool turned = at.frame.turns_triangles();
        const auto triangle = [&sink, turned](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
            if (turned)
                sink.triangle(a, c, b);
            else
                sink.triangle(a, b, c);
        };
        all.triangles(0, triangle);
        return end_of(sink);
    }

private:
    void clear_plan() noexcept
    {
        points_.clear();
        starts_.clear();
        open_.clear();
        sides_.clear();
        joints_.clear();
        paths_.clear();
        size_ = {};
        report_ = {};
        box_ = {};
        em_ = 1.0;
    }

    /// The error for a placement whose output would not fit into 32-bit floats, or none; as refuse_extremes().
    [[nodiscard]] error refused(const placement& at) const noexcept
    {
        const double em = at.unit_per_cell * em_;
        if (!is_finite(em) || !(em >= 0x1p-100 && em <= 0x1p30) || !is_finite(at.unit_per_depth))
            return error::bad("size");
        if (box_.empty()) return {};
        if (!(as_double(report_.smallest_radius) * at.unit_per_depth >= 0x1p-126)) return error::bad("radius");
        for (const double x : {box_.low.x, box_.high.x})
            for (const double y : {box_.low.y, box_.high.y}) {
                const vec3 corner = at.position({x, y, as_double(style_.radius)});
                for (const float v : {corner.x, corner.y, corner.z})
                    if (!is_finite(as_double(v))) return error::bad("size");
            }
        return {};
    }

    [[nodiscard]] detail::tube_surface surface() const noexcept
    {
        detail::tube_surface all{starts_.view(), sides_.view(), joints_.view(), paths_.view()};
        all.sides_around = style_.sides;
        all.end = style_.end;
        all.texture = style_.texture;
        return all;
    }

    [[nodiscard]] error try_to_plan(const tube_style& style) noexcept
    {
        if (error e = style.refused()) return e;
        if (!is_finite(tolerance_) || !(tolerance_ > 0.0)) return error::bad("tolerance");
        if (lines_.failed) return lines_.failed;
        style_ = style;
        box around;
        for (const detail::line_point& p : lines_.points) around.add(p.at);
        auto fitting = grid::fitting(units_per_em_, around);
        if (!fitting) return fitting.error();
        // Floats tell all points apart, as in letters.
        fitting->coarsen(cells_told_apart(typemesh::reach_of(around, units_per_em_), true));
        em_ = fitting->cells * fitting->units_per_em;
        if (!(as_double(style.radius) * em_ < grid::reach)) return error::bad("radius");
        const double crease = crease_cosine(style.crease_degrees);
        if (!starts_.push_back(0)) return error::out_of_memory;
        for (std::size_t k = 0; k < lines_.starts.size(); ++k)
            if (!add_line(k, *fitting, crease)) return error::out_of_memory;
        const detail::tube_paths drawn{points_.view(), starts_.view(), open_.view()};
        if (error e = fitting_.fit(drawn, sides_, as_double(style.radius) * em_, as_double(style.corner_cut), crease))
            return e;
        return add_tubes({fitting_.points(), fitting_.starts(), open_.view()});
    }

    /// The points of a line on the grid, and their normals. Points that fall together become one.
    [[nodiscard]] bool add_line(std::size_t k, const grid& cells, double crease) noexcept
    {
        const std::size_t first = lines_.starts[k],
                          end = k + 1 < lines_.starts.size() ? lines_.starts[k + 1] : lines_.points.size();
        const std::size_t own = points_.size();
        bool closed = lines_.closed[k] != 0;
        for (std::size_t i = first; i < end; ++i) {
            const detail::line_point& p = lines_.points[i];
            const grid_point at = cells.snap(p.at);
            if (points_.size() != own && points_.back() == at) {
                sides_.back().after = rounded(p.after);
                continue;
            }
            side_point s{};  // directions, until the line is complete
            s.before = rounded(p.before);
            s.after = rounded(p.after);
            if (!points_.push_back(at) || !sides_.push_back(s)) return false;
        }
        if (closed && points_.size() - own > 1 && points_.back() == points_[own]) {
            sides_[own].before = sides_.back().before;
            points_.truncate(points_.size() - 1);
            sides_.truncate(points_.size());
        }
        const std::size_t count = points_.size() - own;
        closed = closed && count > 2;
        if (count < 2) {
            points_.truncate(own);
            sides_.truncate(own);
            return true;
        }
        ++report_.lines;
        light(own, count, closed, crease);
        return open_.push_back(closed ? 0 : 1) && starts_.push_back(static_cast<std::uint32_t>(points_.size()));
    }

    /// Turns the directions at the points of a line into normals, and measures its length.
    void light(std::size_t own, std::size_t count, bool closed, double crease) noexcept
    {
        const auto next = [&](std::size_t i) noexcept { return i + 1 == count ? 0 : i + 1; };
        double along = 0.0;
        point last = closed ? unit(delta(points_[own + count - 1], points_[own])) : point{};
        for (std::size_t i = 0; i < count; ++i) {
            side_point& s = sides_[own + i];
            const bool is_end = !closed && i + 1 == count, is_start = !closed && i == 0;
            const point edge = delta(points_[own + i], points_[own + next(i)]);
            const point leaving = is_end ? last : unit(edge);
            const point before = normal(s.before, is_start ? leaving : last), after = normal(s.after, leaving);
            s.along = static_cast<float>(along);
            s.doubled = !is_start && !is_end && dot(before, after) < crease;
            const point one = is_start ? unit(outward(leaving)) : is_end ? unit(outward(last)) : before + after;
            s.before = rounded(s.doubled ? before : unit(one));
            s.after = s.doubled ? rounded(after) : s.before;
            if (!is_end) along += length(edge);
            last = leaving;
        }
        if (closed) {
            sides_[own].along = static_cast<float>(along);  // the seam
            sides_[own].doubled = sides_[own].seam = true;
        }
        if (style_.texture != texture_mapping::cylindrical) return;
        for (std::size_t i = 0; i < count; ++i) sides_[own + i].along /= static_cast<float>(along);
    }

    /// The normal of a curve's direction; of the edge's if the curve has none there, or leads elsewhere.
    [[nodiscard]] static point normal(vec2 direction, point edge) noexcept
    {
        const point d{as_double(direction.x), as_double(direction.y)};
        const bool leads = dot(d, edge) > std::fabs(cross(d, edge));
        return unit(outward(leads ? d : edge));
    }

    [[nodiscard]] error add_tubes(const detail::tube_paths& paths) noexcept
    {
        const detail::tube_clearance& clear = fitting_.clearance();
        report_.smallest_radius = style_.radius;
        for (std::size_t k = 0; k < paths.count(); ++k) {
            detail::tube_path path{detail::tube_radius(clear.radii()[k], em_, style_.radius)};
            if (as_double(path.radius) * detail::tube_section::least_step(style_.sides) * 0x1p22 < reach_of(paths, k))
                path.radius = 0.0f;
            path.open = paths.is_open(k) ? 1 : 0;
            report_.narrowed += path.radius < style_.radius;
            report_.lost += !(path.radius > 0.0f);
            report_.meeting += clear.meets(k);
            if (path.radius > 0.0f && path.radius < report_.smallest_radius) report_.smallest_radius = path.radius;
            for (std::uint32_t i = paths.starts[k]; i < paths.starts[k + 1]; ++i) {
                path.doubled += sides_[i].doubled ? 1u : 0u;
                const vec2 lean = rounded((as_double(path.radius) * em_) * clear.leans()[i]);
                if (!joints_.push_back({paths.points[i], lean})) return error::out_of_memory;
                if (path.radius > 0.0f) add_to_box(paths, k, i, lean);
            }
            if (!paths_.push_back(path)) return error::out_of_memory;
        }
        starts_.clear();
        if (!starts_.append(paths.starts)) return error::out_of_memory;
        const detail::tube_surface all = surface();
        for (std::size_t k = 0; k < paths.count(); ++k)
            size_ = size_ + mesh_size{all.vertex_count(k), all.triangle_count(k)};
        if (report_.lost == report_.lines) report_.smallest_radius = 0.0f;
        return size_.vertices > 0x3FFF'FFFFu || size_.triangles > 0x3FFF'FFFFu ? error{error::too_large} : error{};
    }

    /// The greatest coordinate of a path, in em.
    [[nodiscard]] double reach_of(const detail::tube_paths& paths, std::size_t k) const noexcept
    {
        box own;
        for (std::uint32_t i = paths.starts[k]; i < paths.starts[k + 1]; ++i)
            own.add(placement::exact(paths.points[i]));
        return typemesh::reach_of(own, em_);
    }

    /// Enlarges the box by the corners of a mitre, and by the half ball at an end.
    void add_to_box(const detail::tube_paths& paths, std::size_t k, std::uint32_t i, vec2 lean) noexcept
    {
        const point p = placement::exact(paths.points[i]), right{as_double(lean.x), as_double(lean.y)};
        box_.add(p + right);
        box_.add(p - right);
        const bool is_start = i == paths.starts[k], is_end = i + 1 == paths.starts[k + 1];
        if (style_.end != tube_end::round || !paths.is_open(k) || !(is_start || is_end)) return;
        const double r = length(right);
        const point away = (is_start ? 1.0 : -1.0) * point{right.y, -right.x};
        box_.add(p + point{away.x < 0.0 ? -r : r, away.y < 0.0 ? -r : r});
    }

    detail::line_points lines_;
    double units_per_em_ = 0.0, tolerance_ = quality::high, em_ = 1.0;
    buffer<grid_point> points_;
    buffer<std::uint32_t> starts_;
    buffer<std::uint8_t> open_;
    buffer<side_point> sides_;
    buffer<detail::tube_joint> joints_;
    buffer<detail::tube_path> paths_;
    detail::tube_fitting fitting_;
    tube_style style_;
    mesh_size size_;
    tube_report report_;
    box box_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

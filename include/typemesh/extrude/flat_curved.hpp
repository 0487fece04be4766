// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/curved_boundary.hpp>
#include <typemesh/extrude/impl/exact_fill.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/extrude/texture.hpp>
#include <typemesh/extrude/texture_tangent.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A triangle in which a shader draws the arc of a conic, counter-clockwise.
struct curve_triangle {
    grid_point corners[3];      ///< convex: start, control point, end; concave: start, end, control point
    float weight = 1.0f;        ///< of the conic; 1 for a quadratic curve
    std::uint32_t concave = 0;  ///< 1 if the inside lies between the arc and the control point
};

/// The plan data of flat_curved: the inner polygon and its triangles, and the triangles of curves.
class flat_curved_data : public plan_arrays<grid_point, triangle, curve_triangle> {
public:
    detail::curved_boundary boundary;  ///< the memory of plan(), which is not stored with the glyph
    contours inner;

    explicit flat_curved_data(memory source = heap()) noexcept : plan_arrays{source}, boundary{source}, inner{source} {}
    void clear() noexcept
    {
        plan_arrays::clear();
        boundary.clear();
        inner.clear();
    }
};

/// An extruder that makes only the front, at z = 0, and leaves the curves to a shader: each curve is one triangle or a
/// few, at every size on the screen.
///
///         c                 convex: the triangle start, c, end lies outside of the inner polygon, which has the edge
///       /...\               from start to end. Inside is the side of the chord.
///      /.---.\     .
///     s-------e             concave: the inner polygon has the edges from start to c and from c to end. Inside is the
///     | inner |             side of c.
///
/// The vertices' attribute `curve` is a vec3 that the shader interpolates. A fragment is inside if
///
///     f = x * |x| - y * z < 0
///
/// At the vertices of the inner polygon it is (-1, 0, 0). In a triangle of a convex curve it is (0, 2w, 0) at the
/// start, (1, 0, 0) at the control point and (0, 0, 2w) at the end; x and y are negated if the curve is concave. w is
/// the weight of a conic. For quadratic curves w is 1, and f is 4 times the u * u - v of Loop and Blinn. Cubic curves
/// become arcs of conics, which are as simple to draw. docs/curves.md has shaders.
///
/// Triangles do not overlap, because control triangles that meet are divided. If the text's tolerance is at most 2
/// cells, the mesh is right wherever the distance to all curves is more than 3 cells (1/170 font unit), and 1.5 cells
/// more where contours cross. A larger tolerance saves time, and moves curves by at most that tolerance where they
/// cross others at a small angle or nearly touch. The number of triangles hardly depends on it.
///
/// If the inner polygon is not proven simple, the glyph gets the region's own straight edges. That happens only where
/// contours are about as thin as a cell.
///
/// There are no walls and no bevels.
///
/// Fails  error::too_large: 2^30 vertices or more; error::out_of_memory
///
/// From  C. Loop and J. Blinn, Resolution independent curve rendering using programmable graphics hardware (2005)
struct flat_curved {
    texture_mapping texture = texture_mapping::em;

    using plan_data = flat_curved_data;

    /// See option_bits. The source of texture coordinates matters only for writing.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        solid_plan made;
        if (filled.points().empty()) return made;
        auto& triangles = data.of<triangle>();
        auto inner = make_inner(filled, true, data, caps);
        // A small loop may have turned over when its crossings were moved.
        if (!inner && inner.error().code == error::crossing_contours && data.boundary.moved() != 0)
            inner = make_inner(filled, false, data, caps);
        if (!inner && inner.error().code != error::crossing_contours) return inner.error();
        auto& points = data.of<grid_point>();
        if (inner) {
            if (!points.append(inner->points())) return error::out_of_memory;
        } else {  // a contour thinner than a few cells has turned over
            data.of<curve_triangle>().clear();
            if (!points.append(filled.points()) || !triangles.append(caps.triangles())) return error::out_of_memory;
        }
        const std::size_t curves = data.of<curve_triangle>().size();
        if (points.size() + 3 * curves > 0x3FFF'FFFFu) return error::too_large;
        made.sizes.vertices[part::front] = static_cast<std::uint32_t>(points.size() + 3 * curves);
        made.sizes.triangles[part::front] = static_cast<std::uint32_t>(triangles.size() + curves);
        for (const grid_point p : points) made.around.add(placement::exact(p));
        for (const curve_triangle& t : data.of<curve_triangle>())
            for (const grid_point p : t.corners) made.around.add(placement::exact(p));
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept { return {}; }

    /// All triangles, whole: what the shader discards of them is not taken away.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        const auto points = s.data.of<grid_point>();
        for (const triangle t : s.data.of<triangle>()) put(points[t.a], points[t.b], points[t.c]);
        for (const curve_triangle& t : s.data.of<curve_triangle>()) put(t.corners[0], t.corners[1], t.corners[2]);
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        if (p != part::front) return;
        const planar_texture uv{texture, at};
        with_axes(at, [&](const auto& axes) noexcept {
            surface_point<Wants> v;
            if constexpr (has(Wants, attribute::normal)) v.normal = axes.direction(0.0f, 0.0f, 1.0f);
            if constexpr (has(Wants, attribute::tangent)) v.tangent = texture_tangent{at.frame}.on_cap(axes, 1.0f);
            const auto put_at = [&](grid_point g) noexcept {
                if constexpr (has(Wants, attribute::position)) v.position = axes.position(axes.foot(g), 0.0f);
                if constexpr (has(Wants, attribute::uv)) v.uv = uv(g);
                put(v);
            };
            for (const grid_point g : s.data.of<grid_point>()) put_at(g);
            for (const curve_triangle& t : s.data.of<curve_triangle>())
                for (int k = 0; k < 3; ++k) {
                    if constexpr (has(Wants, attribute::curve)) v.curve = place_of(t, k);
                    put_at(t.corners[k]);
                }
        });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p != part::front) return;
        const std::uint32_t base = first[part::front];
        for (const triangle t : s.data.of<triangle>()) put(base + t.a, base + t.b, base + t.c);
        auto next = base + static_cast<std::uint32_t>(s.data.of<grid_point>().size());
        for (std::size_t i = s.data.of<curve_triangle>().size(); i > 0; --i, next += 3) put(next, next + 1, next + 2);
    }

private:
    /// The attribute `curve` of a corner.
    [[nodiscard]] static vec3 place_of(const curve_triangle& t, int corner) noexcept
    {
        const float sign = t.concave != 0 ? -1.0f : 1.0f;
        if (corner == 0) return {0.0f, sign * 2.0f * t.weight, 0.0f};
        const bool is_control = (corner == 1) == (t.concave == 0);
        return is_control ? vec3{sign, 0.0f, 0.0f} : vec3{0.0f, 0.0f, 2.0f * t.weight};
    }

    /// The inner polygon, with its triangles in `data`.
    template <cap_maker Caps>
    [[nodiscard]] static result<region> make_inner(const region& filled, bool with_crossings, plan_data& data,
                                                   Caps& caps) noexcept
    {
        data.inner.clear();
        data.of<curve_triangle>().clear();
        if (error e = data.boundary.find(filled, with_crossings)) return e;
        if (!gather(filled, data)) return error::out_of_memory;
        return fill_exactly(data.inner, caps, data.of<triangle>());
    }

    /// Lists the loops of the inner polygon and the curves' triangles. False if out of memory.
    [[nodiscard]] static bool gather(const region& filled, plan_data& data) noexcept
    {
        contours& inner = data.inner;
        const auto push = [&inner](grid_point p, const contour_edge& e) noexcept {
            return inner.points.push_back(p) && inner.edges.push_back(e);
        };
        const auto pieces = data.boundary.pieces();
        for (const detail::curve_piece& p : pieces) {
            if (p.begins_loop && !inner.starts.push_back(static_cast<std::uint32_t>(inner.points.size()))) return false;
            if (!push(p.start, {0, p.t0, p.t1})) return false;
            if (p.is_straight()) continue;
            if (p.doubled_area() > 0) {
                if (!data.of<curve_triangle>().push_back({{p.start, p.control, p.end}, p.weight, 0})) return false;
            } else {
                if (!push(p.control, {0, p.t0, p.t1})) return false;
                if (!data.of<curve_triangle>().push_back({{p.start, p.end, p.control}, p.weight, 1})) return false;
            }
        }
        if (!inner.starts.push_back(static_cast<std::uint32_t>(inner.points.size()))) return false;
        inner.grid = filled.grid();
        inner.tolerance = filled.tolerance();
        inner.curves = filled.curves();
        return true;
    }
};
static_assert(extruder<flat_curved>);

}  // namespace typemesh::inline TYPEMESH_ABI

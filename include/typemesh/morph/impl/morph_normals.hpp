// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/morph/impl/keyed_outlines.hpp>
#include <typemesh/morph/impl/morph_points.hpp>
#include <typemesh/morph/impl/morph_store.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The normals of morphed walls: the curves' own normals, at each key, and how far normals between two keys are wrong.
///
/// A tangent moves evenly like the control points. A mixture of unit normals has another direction than the normal of
/// the mixed tangent if the tangents at the two keys differ in length. With an angle a between them, and lengths in the
/// ratio r, the directions differ by at most 2 atan2(sqrt(r) sin a, 1 + sqrt(r) cos a) - a: a vector (1, q) in the
/// basis of the two units turns fastest with log q at q = 1, so the largest turn by a factor r lies between 1/sqrt(r)
/// and sqrt(r).
///
/// At each key, normals point out of their walls, by the rules of curve_normals. A tangent that points against its edge
/// (the polygon omits a whole hook of the curve there) is replaced by the edge's direction. A soft normal that would
/// point into a wall is replaced by the normalised sum of the walls' own normals. Whether a point is hard depends on
/// the curves alone.
class morph_normals {
public:
    morph_normals(const keyed_outlines& outlines, const morph_points& points, double crease_degrees) noexcept
        : outlines_{outlines}, points_{points}, crease_{std::cos(crease_degrees * 0.017453292519943295)}
    {
    }

    /// Appends the corners and normals of the glyph, and fills in its numbers.
    error append(morph_store& out, morph_glyph& glyph) noexcept
    {
        const std::uint32_t n = points_.count();
        const std::size_t keys = outlines_.keys();
        morph_corner* const corners = out.corners.append(n);
        vec2* const normals = out.normals.append(2 * std::size_t{n} * keys);
        if (corners == nullptr || normals == nullptr) return error::out_of_memory;
        next_ = corners;
        for (std::uint32_t c = 0; c < points_.contours(); ++c)
            for (std::uint32_t i = points_.starts[c]; i < points_.starts[c + 1]; ++i)
                corners[i] = {i + 1 == points_.starts[c + 1] ? points_.starts[c] : i + 1};
        for (std::uint32_t c = 0; c < points_.contours(); ++c) {
            const std::uint32_t first = points_.starts[c], last = points_.starts[c + 1];
            for (std::uint32_t i = first; i < last; ++i) {
                const std::uint32_t before = i == first ? last - 1 : i - 1;
                corners[i].hard = is_hard(before, i);
                glyph.hard += corners[i].hard ? 1u : 0u;
                for (std::size_t k = 0; k < keys; ++k) {
                    point a = normal_of(before, true, k), b = normal_of(i, false, k);
                    if (!corners[i].hard) a = b = soft({place(before, k), place(i, k), place(next_[i].next, k)}, a, b);
                    normals[2 * (k * n + i)] = {static_cast<float>(a.x), static_cast<float>(a.y)};
                    normals[2 * (k * n + i) + 1] = {static_cast<float>(b.x), static_cast<float>(b.y)};
                }
                note_error(before, true, glyph);
                note_error(i, false, glyph);
            }
        }
        return {};
    }

private:
    /// Three consecutive points of a contour.
    struct corner {
        grid_point a, b, c;
    };

    [[nodiscard]] grid_point place(std::uint32_t at, std::size_t key) const noexcept
    {
        return points_.places[key * points_.count() + at];
    }

    /// The way along an edge at a key, in cells; 0 if its ends meet there.
    [[nodiscard]] point direction_of(std::uint32_t edge, std::size_t key) const noexcept
    {
        return delta(place(edge, key), place(next_[edge].next, key));
    }

    /// The direction in which an edge arrives at its end or leaves its start at a key, not of unit length. If its curve
    /// is a point there, the direction at the nearest key where it is none is the limit.
    [[nodiscard]] point tangent_of(std::uint32_t edge, bool arrives, std::size_t key) const noexcept
    {
        for (std::size_t steps = 0; steps < outlines_.keys(); ++steps) {
            for (const bool ahead : {true, false}) {
                const std::size_t k = ahead ? key + steps : key - steps;
                if (k >= outlines_.keys()) continue;
                const point t = tangent_at(edge, arrives, k);
                if (dot(t, t) > 0.0) return t;
            }
        }
        return {0.0, 1.0};
    }
    [[nodiscard]] point tangent_at(std::uint32_t edge, bool arrives, std::size_t key) const noexcept
    {
        const contour_edge& e = points_.edges[edge];
        if (points_.is_chord(edge)) return direction_of(edge, key);
        const bool forth = e.t0 <= e.t1;
        const hodograph h{outlines_.curves(key)[e.curve], forth ? 1.0 : -1.0};
        const tangents t = h.at(as_double(arrives ? e.t1 : e.t0));
        return arrives == forth ? t.before : t.after;
    }
    /// The unit normal of the wall over an edge, at its end or start.
    [[nodiscard]] point normal_of(std::uint32_t edge, bool arrives, std::size_t key) const noexcept
    {
        const point along = direction_of(edge, key), t = tangent_of(edge, arrives, key);
        return unit(outward(along == point{} || dot(t, along) > 0.0 ? t : along));
    }

    /// The single normal of a soft point. A wall whose ends meet does not count.
    [[nodiscard]] static point soft(const corner& at, point before, point after) noexcept
    {
        const point sum = before + after;
        const point in = outward(delta(at.a, at.b)), out = outward(delta(at.b, at.c));
        const bool has_in = !(at.a == at.b), has_out = !(at.b == at.c);
        const bool out_of_both = (!has_in || dot(sum, in) > 0.0) && (!has_out || dot(sum, out) > 0.0);
        if (out_of_both && dot(sum, sum) > 0.0) return unit(sum);
        if (has_in && has_out) return joint_normal(at.a, at.b, at.c, unit(in), unit(out));
        return has_in ? unit(in) : has_out ? unit(out) : after;
    }

    /// Whether the curves meet at an angle above the crease angle, at any key.
    [[nodiscard]] bool is_hard(std::uint32_t before, std::uint32_t at) const noexcept
    {
        for (std::size_t k = 0; k < outlines_.keys(); ++k) {
            const point a = unit(tangent_of(before, true, k)), b = unit(tangent_of(at, false, k));
            if (dot(a, b) < crease_) return true;
        }
        return false;
    }

    void note_error(std::uint32_t edge, bool arrives, morph_glyph& glyph) const noexcept
    {
        for (std::size_t k = 0; k + 1 < outlines_.keys(); ++k) {
            const point a = tangent_at(edge, arrives, k), b = tangent_at(edge, arrives, k + 1);
            if (points_.is_chord(edge) || !(dot(a, a) > 0.0) || !(dot(b, b) > 0.0)) continue;
            const double angle = std::fabs(std::atan2(cross(a, b), dot(a, b)));
            double root = std::sqrt(length(b) / length(a));
            if (root < 1.0) root = 1.0 / root;
            const double wrong = 2.0 * std::atan2(root * std::sin(angle), 1.0 + root * std::cos(angle)) - angle;
            if (wrong > glyph.normal_error) glyph.normal_error = wrong;
        }
    }

    const keyed_outlines& outlines_;
    const morph_points& points_;
    double crease_;
    const morph_corner* next_ = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Turns the normals of a bevel out of the triangles that they light.
///
///         n            A curve may turn by nearly 90 degrees more than its chord does, and nodes are rounded to the
///     n'  ^  / face    grid. So the angle of a normal to its edge's normal may be just less than 90 degrees, but
///      \  | /          larger for a triangle of the edge's face. That triangle gets its own vertex, whose normal n'
///       \ |/           is turned as far as necessary, to an angle of 89 degrees.
///     ____o____
///
/// A triangle's direction is its own slope as written; a riser's direction is the normal of its edge. Triangles up to
/// three cells high in the plane, and risers on edges up to three cells long, are unchanged, because rounding may turn
/// them in any direction.
///
/// Cost   O(n); scratch memory, four bytes per vertex, only if a normal is turned
class bevel_facing {
public:
    bevel_facing(bevel_data& data, workspace::scope& scratch) noexcept
        : vertices_{data.of<bevel_vertex>()},
          triangles_{data.of<bevel_triangle>()},
          strips_{data.of<bevel_strip>()},
          normals_{data.normals},
          scratch_{scratch}
    {
    }

    /// For the triangles from `first` on, which share no vertices with others. False if out of memory.
    [[nodiscard]] bool turn_out(std::size_t first) noexcept
    {
        const std::size_t count = triangles_.size();
        for (std::size_t i = first; i < count; ++i) {
            const triangle& t = triangles_[i].corners;
            const facing out = facing_of(t);
            if (lights(t.a, out) && lights(t.b, out) && lights(t.c, out)) continue;
            if (is_narrow(t)) continue;
            if (uses_ == nullptr && !count_uses(first)) return false;
            triangle& mine = triangles_[i].corners;
            for (std::uint32_t* corner : {&mine.a, &mine.b, &mine.c})
                if (!lights(*corner, out) && !take_own(*corner, out)) return false;
        }
        return true;
    }

private:
    static constexpr double narrow = 3.0;     ///< cells
    static constexpr double least = 0x1p-8;   ///< a normal with a smaller cosine is turned
    static constexpr double turned = 0x1p-6;  ///< the approximate cosine after turning

    /// The direction that a triangle faces in the plane.
    struct facing {
        point away;    ///< of any length
        double least;  ///< the square of the least permitted product with a unit normal
    };

    [[nodiscard]] facing facing_of(const triangle& t) const noexcept
    {
        const bevel_vertex &a = vertices_[t.a], &b = vertices_[t.b], &c = vertices_[t.c];
        const point ab = delta(a.at, b.at);
        point away = outward(ab);
        if (!is_riser(a)) {  // against the gradient across the profile
            const double to_b = station(b) - station(a), to_c = station(c) - station(a);
            away = -1.0 * outward(to_b * delta(a.at, c.at) - to_c * ab);
        }
        return {away, least * least * dot(away, away)};
    }

    [[nodiscard]] bool lights(std::uint32_t vertex, const facing& f) const noexcept
    {
        const vec2 n = vertices_[vertex].outward;
        const double across = dot({as_double(n.x), as_double(n.y)}, f.away);
        return across > 0.0 && across * across > f.least;
    }

    /// Whether rounding may have turned it to any direction, or it is level and has no direction in the plane.
    [[nodiscard]] bool is_narrow(const triangle& t) const noexcept
    {
        const bevel_vertex &a = vertices_[t.a], &b = vertices_[t.b], &c = vertices_[t.c];
        const point ab = delta(a.at, b.at), ac = delta(a.at, c.at), bc = delta(b.at, c.at);
        if (is_riser(a)) return dot(ab, ab) <= narrow * narrow;
        if (same(station(a), station(b)) && same(station(a), station(c))) return true;
        double longest = dot(ab, ab);
        for (const double square : {dot(ac, ac), dot(bc, bc)}) longest = square > longest ? square : longest;
        const double area = cross(ab, ac);
        return area * area <= narrow * narrow * longest;
    }

    [[nodiscard]] bool is_riser(const bevel_vertex& v) const noexcept { return is_zero(strips_[v.strip].run); }

    /// The position across the profile, in strips. A vertex that two strips share is at the end of one and the start of
    /// the next.
    [[nodiscard]] static double station(const bevel_vertex& v) noexcept { return v.strip + as_double(v.share); }

    /// Counts, for each vertex, the corners of triangles that use it.
    [[nodiscard]] bool count_uses(std::size_t first) noexcept
    {
        const std::size_t n = vertices_.size();
        uses_ = scratch_.take<std::uint32_t>(n);
        if (uses_ == nullptr) return false;
        for (std::size_t i = 0; i < n; ++i) uses_[i] = 0;
        for (std::size_t i = first; i < triangles_.size(); ++i)
            for (const std::uint32_t v : {triangles_[i].corners.a, triangles_[i].corners.b, triangles_[i].corners.c})
                ++uses_[v];
        return true;
    }

    /// Gives a corner a vertex that lights its triangle: the replacement that a previous triangle got for the same
    /// vertex, or a new one; a pair for risers. A vertex with no other user is turned itself.
    [[nodiscard]] bool take_own(std::uint32_t& corner, const facing& f) noexcept
    {
        const bool riser = is_riser(vertices_[corner]);
        const std::uint32_t first = riser && vertices_[corner].share > 0.0f ? corner - 1 : corner;
        const std::uint32_t pair = riser ? 1 : 0;
        const std::uint32_t upper = corner - first;
        constexpr std::uint32_t of_quad = 3;  // corners of a riser's two triangles at one of its ends
        const bool alone = riser ? uses_[first] + uses_[first + 1] == of_quad : uses_[first] == 1;
        if (!alone && first == last_.from && lights(last_.to, f)) {
            --uses_[corner];
            corner = last_.to + upper;
            return true;
        }
        const vec2 out = turned_out(vertices_[first].outward, f);
        if (alone) {
            for (std::uint32_t k = 0; k <= pair; ++k) vertices_[first + k].outward = out;
            return true;
        }
        last_ = {first, static_cast<std::uint32_t>(vertices_.size())};
        for (std::uint32_t k = 0; k <= pair; ++k) {
            bevel_vertex made = vertices_[first + k];
            const bevel_data::corner_normals normals = normals_[first + k];
            made.outward = out;
            if (!vertices_.push_back(made) || !normals_.push_back(normals)) return false;
        }
        --uses_[corner];
        corner = last_.to + upper;
        return true;
    }

    [[nodiscard]] static vec2 turned_out(vec2 normal, const facing& f) noexcept
    {
        const point n{as_double(normal.x), as_double(normal.y)}, away = unit(f.away);
        return rounded(unit(n + (turned - dot(n, away)) * away));
    }

    /// The vertex that was replaced last.
    struct replaced {
        std::uint32_t from = ~std::uint32_t{0}, to = 0;
    };

    buffer<bevel_vertex>& vertices_;
    buffer<bevel_triangle>& triangles_;
    buffer<bevel_strip>& strips_;
    buffer<bevel_data::corner_normals>& normals_;
    workspace::scope& scratch_;
    std::uint32_t* uses_ = nullptr;
    replaced last_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

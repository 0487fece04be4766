// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/inflated_surface.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/inflate/membrane.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Keeps the normals of an inflated letter on the fronts of its triangles.
///
/// On the outline a normal lies in the plane. It is on the front of a triangle if the point's slope, which points into
/// the letter, has a positive product with the direction in which the triangle rises, however high the letter is. Where
/// it has not, the slope turns a little farther than needed to suit all triangles of the point:
///
///       two triangles rise here, one there       If no slope suits all, the triangles that the old one does not suit
///                  ^  ^   .>                     get points of their own, in the same place.
///     -------------- o --------------  outline
///
/// Inside, (0, 0, 1) suits all triangles, and the height decides how far a normal may lean. So this only finds the
/// least product of a point's slope and the slopes of its triangles; inflated_surface raises the normal when it writes.
class inflated_normals {
public:
    explicit inflated_normals(memory source = heap()) noexcept : nodes_{source}, turns_{source} {}

    /// All points have a membrane_point; those on the outline have the height 0. The new points follow. `leans` gets a
    /// value for each point.
    ///
    ///     cells_per_em   of the grid
    ///     flatness       `height / limit` of inflated; 0: no limit
    ///
    /// False if out of memory
    /// Cost   O(n)
    [[nodiscard]] bool operator()(contours& loops, triangle_list& triangles, buffer<membrane_point>& membrane,
                                  buffer<membrane_lean>& leans, double cells_per_em, float flatness) noexcept
    {
        if (!prepare(loops.points.view(), membrane.view(), as_double(flatness))) return false;
        for (const triangle& t : triangles)
            if (!measure(t)) return false;
        if (!turns_.empty()) {
            for (const triangle& t : triangles) narrow(t);
            if (!split(loops, triangles, membrane)) return false;
            for (const turned& k : turns_) turn(k, membrane[k.number].slope);
        }
        const std::size_t n = loops.points.size();
        membrane_lean* const out = leans.append(n);
        if (out == nullptr) return n == 0;
        for (std::size_t i = 0; i < n; ++i)
            out[i].least = i < nodes_.size() ? static_cast<float>(cells_per_em * nodes_[i].lean) : 0.0f;
        return true;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    static constexpr double one = 0x1p20;  // directions are rounded to integers, so that their products are exact

    struct node {
        point place, slope;
        double height;
        double lean;         // inside: the least product of slopes, in em per cell; at most 0
        std::uint32_t turn;  // its turn, or none
    };

    /// A point on the outline or of a pinched edge whose slope changes, or a new point in the same place. The
    /// directions in which its triangles rise lie between two, counter-clockwise from the first to the last.
    struct turned {
        std::uint32_t number;       // of the point
        std::uint32_t next = none;  // the turn of another point in its place
        bool has_right = false;     // whether the old slope suits a triangle
        bool fails = false;         // whether no slope suits all triangles
        bool is_flat = false;       // whether its triangles do not rise
        point first = {}, last = {};
    };

    [[nodiscard]] bool prepare(array_view<const grid_point> points, array_view<const membrane_point> membrane,
                               double flatness) noexcept
    {
        nodes_.clear();
        turns_.clear();
        node* const out = nodes_.append(points.size());
        if (out == nullptr) return points.empty();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const membrane_point& m = membrane[i];
            double z = as_double(m.height);
            if (flatness > 0.0) {
                const double share = flatness * z;
                z /= std::sqrt(1.0 + share * share);
            }
            out[i] = {placement::exact(points[i]), {as_double(m.slope.x), as_double(m.slope.y)}, z, 0.0, none};
        }
        return true;
    }

    /// The slope of a triangle times twice its area, from two edges and the rises along them: exact for letters of
    /// about an em, without a limit.
    [[nodiscard]] static point rise(point u, point v, double along_u, double along_v) noexcept
    {
        return {along_u * v.y - along_v * u.y, along_v * u.x - along_u * v.x};
    }
    [[nodiscard]] point rise(const triangle& t) const noexcept
    {
        const node &a = nodes_[t.a], &b = nodes_[t.b], &c = nodes_[t.c];
        return rise(b.place - a.place, c.place - a.place, b.height - a.height, c.height - a.height);
    }
    [[nodiscard]] double twice_area(const triangle& t) const noexcept
    {
        const point a = nodes_[t.a].place;
        return cross(nodes_[t.b].place - a, nodes_[t.c].place - a);
    }

    /// 0 for a triangle that does not rise.
    [[nodiscard]] static point direction(point rise) noexcept
    {
        const double length = typemesh::length(rise);
        if (!(length > 0.0)) return {};
        return {std::floor(rise.x * (one / length) + 0.5), std::floor(rise.y * (one / length) + 0.5)};
    }

    /// Whether a unit slope points up a triangle, and not along it: normals are rounded to floats.
    [[nodiscard]] static bool points_up(point slope, point up) noexcept { return dot(slope, up) > margin(up); }
    [[nodiscard]] static double margin(point up) noexcept { return 0x1p-20 * (std::fabs(up.x) + std::fabs(up.y)); }

    /// Compares the corners' slopes with a triangle's. False if out of memory.
    [[nodiscard]] bool measure(const triangle& t) noexcept
    {
        node *const all = nodes_.data(), &a = all[t.a], &b = all[t.b], &c = all[t.c];
        const point u = b.place - a.place, v = c.place - a.place,
                    up = rise(u, v, b.height - a.height, c.height - a.height);
        const double area = cross(u, v);
        const double enough = margin(up);
        const auto compare = [&](node& n, std::uint32_t i) noexcept {
            const double product = dot(n.slope, up);
            if (product > enough) return true;
            if (n.height > 0.0 && area > 0.0) {
                if (product < n.lean * area) n.lean = product / area;
                return true;
            }
            return n.turn != none || will_turn(n, i);
        };
        return compare(a, t.a) && compare(b, t.b) && compare(c, t.c);
    }

    /// Lists a point whose slope does not suit a triangle. Inside, these are points of pinched edges, whose slope is 0:
    /// their upright triangles get another point. False if out of memory.
    [[nodiscard]] bool will_turn(node& n, std::uint32_t i) noexcept
    {
        n.turn = static_cast<std::uint32_t>(turns_.size());
        return turns_.push_back({.number = i, .fails = n.height > 0.0});
    }

    /// Whether a point keeps its slope on a triangle.
    [[nodiscard]] bool keeps(const node& n, const triangle& t) const noexcept
    {
        return (n.height > 0.0 && twice_area(t) > 0.0) || points_up(n.slope, rise(t));
    }

    /// Narrows the turns of a triangle's corners to those that suit it.
    void narrow(const triangle& t) noexcept
    {
        for (const std::uint32_t i : {t.a, t.b, t.c}) {
            if (nodes_[i].turn == none) continue;
            turned& k = turns_[nodes_[i].turn];
            k.has_right = k.has_right || keeps(nodes_[i], t);
            k.fails = !widen(k, direction(rise(t))) || k.fails;
        }
    }

    /// Adds a triangle's direction to a turn. False if no slope suits all: they span more than 165 degrees, or some
    /// triangles rise and others do not.
    [[nodiscard]] static bool widen(turned& k, point up) noexcept
    {
        const bool is_flat = up == point{}, has_first = !(k.first == point{});
        if (is_flat || k.is_flat) {
            k.is_flat = k.is_flat || !has_first;
            return is_flat && !has_first;
        }
        if (!has_first) {
            k.first = k.last = up;
            return true;
        }
        const bool is_before = cross(k.first, up) < 0.0, is_after = cross(up, k.last) < 0.0;
        if (!is_before && !is_after) return dot(k.first + k.last, up) > 0.0;
        const point first = is_before ? up : k.first, last = is_before ? k.last : up;
        const double across = cross(first, last);
        if ((is_before && is_after) || across < 0.0 || (across < 0.25 * one * one && dot(first, last) < 0.0))
            return false;
        k.first = first;
        k.last = last;
        return true;
    }

    /// Where a turn fails, gives the triangles that the old slope does not suit another point. False if out of memory.
    [[nodiscard]] bool split(contours& loops, triangle_list& triangles, buffer<membrane_point>& membrane) noexcept
    {
        for (triangle& t : triangles) {
            const triangle old = t;
            for (std::uint32_t* const corner : {&t.a, &t.b, &t.c}) {
                const node& n = nodes_[*corner];
                if (n.turn == none || !turns_[n.turn].fails || keeps(n, old)) continue;
                const point up = direction(rise(old));
                std::uint32_t k = turns_[n.turn].next;
                while (k != none && !widen(turns_[k], up)) k = turns_[k].next;
                if (k == none) {
                    k = static_cast<std::uint32_t>(turns_.size());
                    if (!divide(n.turn, loops, membrane)) return false;
                    (void)widen(turns_[k], up);
                }
                *corner = turns_[k].number;
            }
        }
        return true;
    }

    /// Adds a turn for another point in the place of one; for this one itself, if no other triangle keeps it. False if
    /// out of memory.
    [[nodiscard]] bool divide(std::uint32_t from, contours& loops, buffer<membrane_point>& membrane) noexcept
    {
        const turned old = turns_[from];
        turned added{old.number, old.next};
        turns_[from].next = static_cast<std::uint32_t>(turns_.size());
        if (old.has_right || old.next != none) {
            added.number = static_cast<std::uint32_t>(loops.points.size());
            const grid_point place = loops.points[old.number];
            const membrane_point same = membrane[old.number];
            if (!loops.points.push_back(place) || !membrane.push_back(same)) return false;
        }
        return turns_.push_back(added);
    }

    /// Turns a slope that does not suit all of a turn's triangles to the nearest that does, and a little farther.
    static void turn(const turned& k, vec2& slope) noexcept
    {
        if (k.fails) return;
        const point old = {as_double(slope.x), as_double(slope.y)}, middle = k.first + k.last;
        if (k.is_flat) {
            slope = {};
        } else if (!points_up(old, k.first) || !points_up(old, k.last)) {
            const point nearest = cross(old, middle) > 0.0 ? outward(k.last) : -1.0 * outward(k.first);
            slope = rounded(unit(old == point{} ? middle : nearest + 0.25 * one * unit(middle)));
        }
    }

    buffer<node> nodes_;
    buffer<turned> turns_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

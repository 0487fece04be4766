// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/impl/half_turn_tangent.hpp>
#include <typemesh/extrude/impl/tube_clearance.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/side_point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Leaves out points of paths beside sharp corners, where short edges have no room for the mitre of a thick tube.
///
///         a            The edge from the corner a to p is too short: only length / tan(turn / 2) fits. Without p the
///        /.\           next edge is longer, so a thicker tube fits. A point is left out if this raises the smallest
///       / . p          radius for the edges around it, as long as that is below the path's; and if the new edge is not
///      /   . \         farther than `cut` radii from any point that was left out between its ends.
///     /     . b
///
/// Seams and the ends of open paths stay, and at least three points of a closed path. An edge replaces at most 64
/// points.
///
/// Cost   O(64 n) for each round, at most 16 rounds
class tube_thinning {
public:
    explicit tube_thinning(memory source = heap()) noexcept
        : before_{source}, after_{source}, kept_{source}, starts_{source}
    {
    }

    /// `radii` are the paths', in cells. Fails with error::out_of_memory.
    [[nodiscard]] error find(const tube_paths& paths, array_view<const side_point> sides,
                             array_view<const double> radii, double cut) noexcept
    {
        paths_ = paths;
        points_ = paths.points.data();
        sides_ = sides.data();
        const std::size_t n = paths.points.size();
        before_.clear();
        after_.clear();
        kept_.clear();
        starts_.clear();
        if (n != 0 && (before_.append(n) == nullptr || after_.append(n) == nullptr)) return error::out_of_memory;
        if (!kept_.reserve(n) || !starts_.reserve(paths.count() + 1)) return error::out_of_memory;
        for (std::size_t k = 0; k < paths.count(); ++k) {
            starts_.push_back_unchecked(static_cast<std::uint32_t>(kept_.size()));
            radius_ = radii[k];
            deviation_ = cut * radii[k];
            thin(paths.starts[k], paths.starts[k + 1], paths.is_open(k));
        }
        starts_.push_back_unchecked(static_cast<std::uint32_t>(kept_.size()));
        return {};
    }

    /// The numbers of the points that stay.
    [[nodiscard]] array_view<const std::uint32_t> kept() const noexcept { return kept_.view(); }
    /// Where the paths begin in kept().
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return starts_.view(); }

    /// Lights the edges that are new: their ends get the edge's own normal where the curve's is more than 26 degrees
    /// from it, and at the ends of open paths.
    ///
    ///     points, sides   of the points that stay
    ///     crease          the cosine of the crease angle
    void light(array_view<const grid_point> points, array_view<side_point> sides, double crease) const noexcept
    {
        constexpr double near_by = 0.9;  // the cosine of 26 degrees
        for (std::size_t k = 0; k + 1 < starts_.size(); ++k) {
            const std::uint32_t end = starts_[k + 1];
            for (std::uint32_t i = starts_[k]; i < end; ++i) {
                const std::uint32_t next = i + 1 < end ? i + 1 : starts_[k];
                if ((i + 1 == end && paths_.is_open(k)) || !is_new(k, kept_[i], kept_[next])) continue;
                const point n = wall_normal(points[i], points[next]);
                if (paths_.is_open(k) && i == starts_[k]) sides[i].before = sides[i].after = rounded(n);
                if (paths_.is_open(k) && next + 1 == end) sides[next].before = sides[next].after = rounded(n);
                const auto strays = [&n](vec2 v) noexcept {
                    return as_double(v.x) * n.x + as_double(v.y) * n.y < near_by;
                };
                if (strays(sides[i].after)) set(sides[i], sides[i].before, rounded(n), crease);
                if (strays(sides[next].before)) set(sides[next], rounded(n), sides[next].after, crease);
            }
        }
    }

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;
    static constexpr std::uint32_t max_absorbed = 64;  // points between the ends of a new edge

    /// Whether points were left out between two that stay.
    [[nodiscard]] bool is_new(std::size_t path, std::uint32_t a, std::uint32_t b) const noexcept
    {
        return b != (a + 1 < paths_.starts[path + 1] ? a + 1 : paths_.starts[path]);
    }

    static void set(side_point& s, vec2 before, vec2 after, double crease) noexcept
    {
        const point a{as_double(before.x), as_double(before.y)}, b{as_double(after.x), as_double(after.y)};
        if (!s.doubled && dot(a, b) >= crease) before = after = rounded(unit(a + b));
        s.doubled = s.doubled || !(before == after);
        s.before = before;
        s.after = after;
    }

    void thin(std::uint32_t first, std::uint32_t end, bool open) noexcept
    {
        first_ = first;
        end_ = end;
        for (std::uint32_t i = first; i < end; ++i) {
            before_[i] = i > first ? i - 1 : open ? none : end - 1;
            after_[i] = i + 1 < end ? i + 1 : open ? none : first;
        }
        std::uint32_t left = end - first;
        bool changed = deviation_ > 0.0;
        for (int round = 0; changed && round < 16; ++round) {
            changed = false;
            for (std::uint32_t i = first; i < end; ++i) {
                if (before_[i] == i || left <= 3 || !may_go(i)) continue;
                const std::uint32_t a = before_[i], b = after_[i];
                after_[a] = b;
                before_[b] = a;
                before_[i] = after_[i] = i;  // left out
                --left;
                changed = true;
            }
        }
        for (std::uint32_t i = first; i < end; ++i)
            if (before_[i] != i) kept_.push_back_unchecked(i);
    }

    [[nodiscard]] bool may_go(std::uint32_t p) const noexcept
    {
        const std::uint32_t a = before_[p], b = after_[p];
        if (sides_[p].seam || a == none || b == none || points_[a] == points_[b]) return false;
        const std::uint32_t around[] = {before_[a], a, p, b, after_[b]};
        const double now = least_radius(around, 5);
        if (!(now < radius_)) return false;
        const std::uint32_t without[] = {before_[a], a, b, after_[b]};
        return least_radius(without, 4) > now && is_close(a, b);
    }

    /// The half_turn_tangent() at q; 0 at an end.
    [[nodiscard]] double turn_at(std::uint32_t p, std::uint32_t q, std::uint32_t r) const noexcept
    {
        return p == none || r == none ? 0.0 : half_turn_tangent(points_[p], points_[q], points_[r]);
    }

    /// The largest radius for the edges between consecutive points; the outer points may be none.
    [[nodiscard]] double least_radius(const std::uint32_t* at, int count) const noexcept
    {
        double smallest = 0x1p60;
        for (int i = 0; i + 1 < count; ++i) {
            if (at[i] == none || at[i + 1] == none) continue;
            const std::uint32_t previous = i > 0 ? at[i - 1] : before_[at[i]],
                                next = i + 2 < count ? at[i + 2] : after_[at[i + 1]];
            const double a = turn_at(previous, at[i], at[i + 1]), b = turn_at(at[i], at[i + 1], next);
            double largest = std::fabs(a) > std::fabs(b) ? std::fabs(a) : std::fabs(b);
            largest = std::fabs(a + b) > largest ? std::fabs(a + b) : largest;
            const double l = length(delta(points_[at[i]], points_[at[i + 1]]));
            if (largest * smallest > l) smallest = l / largest;
        }
        return smallest;
    }

    /// Whether all points between a and b are close enough to their chord, and not too many.
    [[nodiscard]] bool is_close(std::uint32_t a, std::uint32_t b) const noexcept
    {
        const point along = delta(points_[a], points_[b]);
        const double square = dot(along, along);
        std::uint32_t absorbed = 0;
        for (std::uint32_t i = a + 1 == end_ ? first_ : a + 1; i != b; i = i + 1 == end_ ? first_ : i + 1) {
            if (++absorbed > max_absorbed) return false;
            const point p = delta(points_[a], points_[i]);
            const double on = dot(p, along), off = cross(along, p);
            if (on < 0.0 || on > square || off * off > deviation_ * deviation_ * square) return false;
        }
        return true;
    }

    buffer<std::uint32_t> before_, after_, kept_, starts_;
    tube_paths paths_;
    const grid_point* points_ = nullptr;
    const side_point* sides_ = nullptr;
    double radius_ = 0.0, deviation_ = 0.0;
    std::uint32_t first_ = 0, end_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/offset/impl/moving_point.hpp>
#include <typemesh/offset/impl/wavefront.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The rule that decides which reflex corners get joins, and how many.
struct join_rule {
    double mitre_limit = 2.0;  ///< a corner may move at most this many distances; 0: 2^18
    double width = 0.0;        ///< the last level, in cells, or sweep_options::joins_at
    double tolerance = 0.0;    ///< in cells; 0: unknown
    bool round = true;         ///< joins stay within the tolerance of an arc at the width; otherwise as few as possible

    /// The limit for corners. A limit near 1 would need more joins than anyone can see, so it is raised: a corner may
    /// end a tolerance beyond the arc at the width, up to the limit that a single join always keeps.
    [[nodiscard]] double kept() const noexcept
    {
        constexpr double of_one_join = 1.41421356237309504880;  // if the boundary turns back: 1 / cos 45 degrees
        if (!(mitre_limit > 0.0)) return 0x1p18;                // beyond that, speeds overflow
        const double seen = width > 0.0 ? 1.0 + tolerance / width : 1.0, least = std::fmin(seen, of_one_join);
        return std::fmax(mitre_limit, least);
    }
};

/// Inserts edges of zero length into the reflex corners that would grow spikes. They turn the corner in equal steps and
/// grow as the boundary moves.
///
///              _____                     _____
///     --------'  ^           --------.  ^  mitre       interior above; a corner that turns right by an angle moves
///     join: o    |                    \ |              1 / cos(angle / 2) distances
///         \      + mitre      join     v
///
/// Each join becomes a segment with its own triangle, whose apex is the end of a diagonal in front of it. A corner that
/// turns right has such a diagonal, because its interior angle is wider than any triangle's.
class reflex_joins {
public:
    explicit reflex_joins(wavefront& of) noexcept : of_{of}, mesh_{of.mesh} {}

    /// Calls `take(vertex, inward)` for each join, in the order of the lines added for them.
    template <class Take>
    [[nodiscard]] error add(const join_rule& rule, Take take) noexcept
    {
        const auto corners = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (std::uint32_t v = 0; v < corners; ++v) {
            const int depth = halvings(rule, v);
            if (depth == 0) continue;
            steps_ = 0;
            const moving_line before = line_of(mesh_.vertices[v].before), after = line_of(mesh_.vertices[v].after);
            turn(before.along, after.along, depth);
            for (std::uint32_t m = 0; m < steps_; ++m)
                if (error e = take(v, moving_line{along_[m]}.inward())) return e;
            if (!put_in(v)) return error::out_of_memory;
        }
        return error::none;
    }

private:
    static constexpr int max_halvings = 5;

    [[nodiscard]] const moving_line& line_of(std::uint32_t s) const noexcept
    {
        return mesh_.lines[mesh_.segments[s].line];
    }

    /// Decides by the corner's points: the directions along the sides of a needle may be opposite after rounding.
    [[nodiscard]] bool is_convex(std::uint32_t v) const noexcept
    {
        const auto& corner = mesh_.vertices[v];
        const fixed_vector at = corner.moves.start;
        const fixed_vector from = mesh_.vertices[mesh_.segments[corner.before].from].moves.start,
                           to = mesh_.vertices[mesh_.segments[corner.after].to].moves.start;
        return cross(at - from, to - at) > 0;
    }

    /// How often a corner's turn must be halved so that each step is within the rule.
    [[nodiscard]] int halvings(const join_rule& rule, std::uint32_t v) const noexcept
    {
        const moving_line &before = line_of(mesh_.vertices[v].before), &after = line_of(mesh_.vertices[v].after);
        const auto cosine = static_cast<double>(dot(before.along, after.along)) * 0x1p-60;
        if (turns_left(before, after) || cosine > 0.999 || is_convex(v)) return 0;
        const auto of_half = [](double c) noexcept { return std::sqrt(c > -1.0 ? (1.0 + c) / 2.0 : 0.0); };
        constexpr double enough = 1.0 - 0x1p-20;  // corners exactly at the limit are within it on every compiler
        const double limit = rule.kept(), tolerance = rule.round ? rule.tolerance : 0.0;
        double step = of_half(cosine);  // the cosine of half the turn, then of half a step
        if (step * limit >= enough) return 0;
        int count = 0;
        do {
            step = of_half(step);
            ++count;
        } while (count < max_halvings &&
                 (step * limit < enough || (tolerance > 0.0 && rule.width * (1.0 - step) > tolerance)));
        return count;
    }

    /// Finds the directions between two, which turn right. Halves the turn until `depth` is used up.
    void turn(fixed_vector from, fixed_vector to, int depth) noexcept
    {
        if (depth == 0) return;
        fixed_vector between = from + to;
        if (dot(from, to) < 0) {  // the sum cancels
            const fixed_vector across = from - to;
            between = {across.y, -across.x};
        }
        const fixed_vector direction = unit_along(between);
        turn(from, direction, depth - 1);
        along_[steps_++] = direction;
        turn(direction, to, depth - 1);
    }

    /// Vertex v stays the corner before the first join; each join brings one more.
    ///
    ///     before -> v -join 0-> first -join 1-> first + 1 ... -> after
    bool put_in(std::uint32_t v) noexcept
    {
        const std::uint32_t before = mesh_.vertices[v].before, after = mesh_.vertices[v].after;
        const auto first_vertex = static_cast<std::uint32_t>(mesh_.vertices.size());
        const auto first_segment = static_cast<std::uint32_t>(mesh_.segments.size());
        const std::uint32_t component = mesh_.segments[before].component;
        for (std::uint32_t m = 0; m < steps_; ++m) {
            const auto line = static_cast<std::uint32_t>(mesh_.lines.size());
            const std::uint32_t s = first_segment + m, from = m == 0 ? v : first_vertex + m - 1;
            auto corner = mesh_.vertices[v];
            corner.before = s;
            corner.after = m + 1 == steps_ ? after : s + 1;
            const std::uint32_t node = of_.node_of[v];
            if (!mesh_.lines.push_back({along_[m]}) || !mesh_.vertices.push_back(corner) ||
                !mesh_.segments.push_back({line, from, first_vertex + m, 0, component, true}) ||
                !of_.node_of.push_back(node))
                return false;
        }
        of_.live[component] += steps_;
        mesh_.vertices[v].after = first_segment;
        mesh_.segments[after].from = first_vertex + steps_ - 1;
        set_speed(v);
        for (std::uint32_t m = 0; m < steps_; ++m) set_speed(first_vertex + m);
        return open_fan(v, after, first_vertex, first_segment);
    }
    void set_speed(std::uint32_t v) noexcept
    {
        auto& corner = mesh_.vertices[v];
        corner.moves.speed = speed_of(line_of(corner.before), line_of(corner.after), false);
    }

    /// Goes through the triangles around the corner from `after` to `before` and inserts the triangles of the joins.
    bool open_fan(std::uint32_t v, std::uint32_t after, std::uint32_t first_vertex,
                  std::uint32_t first_segment) noexcept
    {
        std::uint32_t h = mesh_.segments[after].half;
        for (std::uint32_t m = steps_; m-- != 0;) {
            const fixed_vector inward = line_of(first_segment + m).inward();
            const std::uint32_t upper = first_vertex + m, lower = m == 0 ? v : first_vertex + m - 1;
            for (;; h = mesh_.link(kinetic_triangles::previous(h))) {
                mesh_.triangles[h / 3].corner[h % 3] = upper;
                if (is_before(h, inward)) break;
            }
            const std::uint32_t edge = kinetic_triangles::previous(h), across = mesh_.link(edge);
            const auto t = static_cast<std::uint32_t>(mesh_.triangles.size());
            if (!mesh_.triangles.push_back({{lower, upper, mesh_.origin(edge)}})) return false;
            mesh_.connect(3 * t, kinetic_triangles::to_segment(first_segment + m));
            mesh_.connect(3 * t + 1, edge);
            mesh_.connect(3 * t + 2, across);
            h = 3 * t;
        }
        for (;; h = mesh_.link(kinetic_triangles::previous(h))) {
            mesh_.triangles[h / 3].corner[h % 3] = v;
            if (kinetic_triangles::is_segment(mesh_.link(kinetic_triangles::previous(h)))) return true;
        }
    }

    /// Whether the join that moves `inward` belongs between the triangle of h and the next one: their diagonal lies in
    /// front of the join, and is the last such diagonal before it or the first one after it.
    [[nodiscard]] bool is_before(std::uint32_t h, fixed_vector inward) const noexcept
    {
        const std::uint32_t next = mesh_.link(kinetic_triangles::previous(h));
        const fixed_vector diagonal = direction(next);
        if (cross(diagonal, inward) <= 0) return true;
        if (dot(diagonal, inward) <= 0) return false;
        const std::uint32_t further = mesh_.link(kinetic_triangles::previous(next));
        return kinetic_triangles::is_segment(further) || cross(direction(further), inward) <= 0;
    }
    [[nodiscard]] fixed_vector direction(std::uint32_t h) const noexcept
    {
        return mesh_.vertices[mesh_.origin(kinetic_triangles::next(h))].moves.start -
               mesh_.vertices[mesh_.origin(h)].moves.start;
    }

    wavefront& of_;
    kinetic_triangles& mesh_;
    fixed_vector along_[1 << max_halvings];
    std::uint32_t steps_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/offset/impl/collapse.hpp>
#include <typemesh/offset/impl/int128.hpp>
#include <typemesh/offset/impl/kinetic_triangles.hpp>
#include <typemesh/offset/impl/moving_point.hpp>
#include <typemesh/offset/impl/scaled_number.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds when triangles become flat, from now to a limit. Times and rates are rounded identically on every compiler.
class collapse_times {
public:
    std::int64_t now = 0;
    std::int64_t limit = 0;  ///< later events are ignored

    explicit collapse_times(const kinetic_triangles& of) noexcept : of_{of} {}

    /// The next collapse of a triangle; false if there is none up to the limit. A collapse in which no length vanishes
    /// (meet, turn) comes at `calm` at the earliest.
    [[nodiscard]] bool find(std::uint32_t t, collapse& found, std::int64_t calm = 0) const noexcept
    {
        const kinetic_triangles::triangle& tri = of_.triangles[t];
        found = {limit + 1, t, tri.stamp, collapse::kind::turn, 0, 0};
        int segments = 0;
        for (const std::uint32_t link : tri.link) segments += kinetic_triangles::is_segment(link);
        if (segments == 0) found.time = later(turns_at(tri), calm);
        if (segments >= 2 && is_inside_out(tri, found)) return true;
        for (std::uint8_t k = 0; k < 3 && segments != 0; ++k) {
            if (!kinetic_triangles::is_segment(tri.link[k])) continue;
            const auto& s = of_.segments[kinetic_triangles::segment_in(tri.link[k])];
            if (of_.vertices[s.from].moves.instant() || of_.vertices[s.to].moves.instant()) {
                found = {now, t, tri.stamp, collapse::kind::close_up, k, 0};
                return true;
            }
            const std::int64_t shrinks = shrinks_at(s);
            if (shrinks < found.time) found = {shrinks, t, tri.stamp, collapse::kind::shrink, k, 0};
            if (segments != 1) continue;  // between two segments the angle is constant
            const std::int64_t meets = later(meets_at(s, tri.corner[(k + 2) % 3]), calm);
            if (meets < found.time) found = {meets, t, tri.stamp, collapse::kind::meet, k, 0};
            if (meets == now && length(s) <= no_length()) found = {now, t, tri.stamp, collapse::kind::shrink, k, 0};
        }
        if (found.time > limit) return false;
        if (found.what >= collapse::kind::meet) found.reach = reach(tri, found.time);
        return true;
    }

    /// The current place of a vertex.
    [[nodiscard]] fixed_vector place(std::uint32_t v) const noexcept { return of_.vertices[v].moves.place(now); }

private:
    using segment = kinetic_triangles::segment;
    [[nodiscard]] static std::int64_t later(std::int64_t a, std::int64_t b) noexcept { return a > b ? a : b; }

    /// Between two segments a triangle's angle is below 180 degrees. If it is not (for example in the bits that are
    /// left when several strokes close at once), the triangle has no area, and the shorter of the two segments vanishes
    /// now.
    [[nodiscard]] bool is_inside_out(const kinetic_triangles::triangle& tri, collapse& found) const noexcept
    {
        for (std::uint8_t k = 0; k < 3; ++k) {
            const auto after = static_cast<std::uint8_t>((k + 1) % 3);
            if (!kinetic_triangles::is_segment(tri.link[k]) || !kinetic_triangles::is_segment(tri.link[after]))
                continue;
            const segment &a = of_.segments[kinetic_triangles::segment_in(tri.link[k])],
                          &b = of_.segments[kinetic_triangles::segment_in(tri.link[after])];
            if (of_.vertices[a.to].moves.instant() || cross(of_.lines[a.line].along, of_.lines[b.line].along) >= 0)
                continue;
            const fixed_vector first = place(a.to) - place(a.from), second = place(b.to) - place(b.from);
            const bool first_is_shorter = dot(first, first) <= dot(second, second);
            const fixed_vector shorter = first_is_shorter ? first : second;
            constexpr std::int64_t few_cells = 4 * place_one;
            if (dot(shorter, shorter) > static_cast<int128>(few_cells) * few_cells) continue;
            found.time = now;
            found.what = collapse::kind::shrink;
            found.k = first_is_shorter ? k : after;
            return true;
        }
        return false;
    }

    /// The time at which a length becomes 0. It is `size` now, in 2^-46 cells, and grows by `rate`, in 2^-62.
    [[nodiscard]] std::int64_t zero_of(int128 size, int128 rate) const noexcept
    {
        if (rate >= 0) return limit + 1;
        if (size <= 0) return now;
        rate = -rate;
        const int128 left = limit - now;
        if ((size >> 14) > ((((rate >> 30) + 1) * left) >> 32) + 1) return limit + 1;  // the division would not fit
        int shift = 0;
        while ((rate >> shift) > (static_cast<int128>(1) << 62)) ++shift;
        const int128 passed = (size << (48 - shift)) / static_cast<std::int64_t>(rate >> shift);
        return passed > left ? limit + 1 : now + static_cast<std::int64_t>(passed);
    }

    /// A segment without length that does not grow is already gone: for example, between two lines that have met. So is
    /// one whose corner has just been born and leaves it no length: edges begin only at the start.
    [[nodiscard]] std::int64_t shrinks_at(const segment& s) const noexcept
    {
        constexpr int128 no_gain = static_cast<int128>(1) << 42;  // 2^-20 of the distance swept
        const moving_point &from = of_.vertices[s.from].moves, &to = of_.vertices[s.to].moves;
        const int128 size = length(s), rate = dot(of_.lines[s.line].along, to.speed.of - from.speed.of);
        const bool cut_short = now != 0 && (from.since == now || to.since == now);
        if (size <= no_length() && (rate <= no_gain || cut_short)) return now;
        return zero_of(size, rate);
    }

    /// The greatest length that counts as zero: the slip, but early on less than the length of a join of a quarter
    /// degree. Otherwise a corner that meets round joins would consume all of them at once, and a hole of a few cells
    /// with them.
    [[nodiscard]] int128 no_length() const noexcept
    {
        const std::int64_t early = now >> (16 + 8);  // a 256th of the distance, in places
        return static_cast<int128>(unit_one) * (early < slip ? early : slip);
    }

    /// In 2^-46 cells; negative if the segment has been turned over.
    [[nodiscard]] int128 length(const segment& s) const noexcept
    {
        return dot(of_.lines[s.line].along, place(s.to) - place(s.from));
    }

    [[nodiscard]] std::int64_t meets_at(const segment& s, std::uint32_t apex) const noexcept
    {
        const moving_point& w = of_.vertices[apex].moves;
        if (w.instant()) return limit + 1;
        const fixed_vector inward = of_.lines[s.line].inward();
        constexpr int128 line_speed = static_cast<int128>(time_one) * unit_one;
        return zero_of(dot(inward, w.place(now) - of_.vertices[s.from].moves.place(now)),
                       dot(inward, w.speed.of) - line_speed);
    }

    /// The first root of the area, a quadratic polynomial c + b t + a t^2, with t = 1 at the limit.
    [[nodiscard]] std::int64_t turns_at(const kinetic_triangles::triangle& tri) const noexcept
    {
        const moving_point &u = of_.vertices[tri.corner[0]].moves, &v = of_.vertices[tri.corner[1]].moves,
                           &w = of_.vertices[tri.corner[2]].moves;
        if (u.instant() || v.instant() || w.instant()) return limit + 1;
        const fixed_vector p = v.place(now) - u.place(now), q = w.place(now) - u.place(now);
        const fixed_vector p_speed = v.speed.of - u.speed.of, q_speed = w.speed.of - u.speed.of;
        const scaled_number left{limit - now, -32};
        const scaled_number in_c = scaled_number::of(cross(p, q), -32);
        const scaled_number in_b = scaled_number::of(cross(p, q_speed) + cross(p_speed, q), -48) * left;
        const scaled_number in_a = scaled_number::of(cross(p_speed, q_speed), -64) * left * left;
        int unit = in_c.top() > in_b.top() ? in_c.top() : in_b.top();
        unit = (in_a.top() > unit ? in_a.top() : unit) - 59;
        const std::int64_t a = in_a.in(unit), b = in_b.in(unit), c = in_c.in(unit);

        if (c < 0 || (c == 0 && (b < 0 || (b == 0 && a < 0)))) return now;
        if (a >= 0 && b >= 0) return limit + 1;
        const int128 inner = static_cast<int128>(b) * b - 4 * (static_cast<int128>(a) * c);
        if (inner < 0) return limit + 1;
        const std::int64_t root = square_root(inner);
        const std::int64_t above = b < 0 ? 2 * c : b + root, below = b < 0 ? root - b : -2 * a;
        if (below <= 0 || above >= below) return limit + 1;
        return now + static_cast<std::int64_t>(static_cast<int128>(limit - now) * above / below);
    }

    [[nodiscard]] std::int64_t reach(const kinetic_triangles::triangle& tri, std::int64_t time) const noexcept
    {
        fixed_vector low = of_.vertices[tri.corner[0]].moves.place(time), high = low;
        for (int k = 1; k < 3; ++k) {
            const fixed_vector p = of_.vertices[tri.corner[k]].moves.place(time);
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
        }
        return high.x - low.x > high.y - low.y ? high.x - low.x : high.y - low.y;
    }

    const kinetic_triangles& of_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

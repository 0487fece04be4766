// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/outline.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Warps curves one by one, and appends the cubics that follow their images.
///
/// A piece of a curve becomes the cubic with the same ends and the same derivatives there, H. The image is f = w(B(t)).
/// Let A be the warp's affine map in the middle of the piece. Then f - H = (w - A)(B) - (H - A(B)). The second
/// derivatives of both terms have bounds, D together: the first from w.bend(), the second because that term is a
/// cubic. The distance |f - H| is measured at n - 1 places, and between them it is at most D / 8n^2 larger, and J / 4n
/// if the derivative of f jumps by J in between. So the proof needs no derivative of the warp beyond the second. Curves
/// are divided into 2, 4, ... pieces until it holds, so there are at most about twice as many as cubics with these ends
/// and derivatives need.
template <plane_warp W>
class curve_warper {
public:
    /// `allowed` is the largest distance, in em.
    curve_warper(const W& w, const drawn_place& at, double allowed, std::uint32_t most, outline& out) noexcept
        : warps_{w}, at_{at}, allowed_{allowed}, most_{most}, out_{out}
    {
    }

    /// Whether all cubics so far are exact.
    [[nodiscard]] bool is_exact() const noexcept { return exact_; }

    error operator()(const curve& c) noexcept
    {
        curve own = c;
        for (std::uint32_t i = 0; i <= c.degree; ++i) own.p[i] = in_text(c.p[i]);
        const bend_bounds by = warps_.bend(box_of(own.p, c.degree));
        const bool straight = c.degree == 1 && stays_line(own, by);
        if (straight || (is_zero(by.xx) && is_zero(by.xy) && is_zero(by.yy) && is_zero(by.x_jump))) {
            for (std::uint32_t i = 0; i <= c.degree; ++i) own.p[i] = drawn(warps_(own.p[i]).at);
            return keep(own);
        }
        exact_ = false;
        const cubic b = c.degree == 1   ? cubic{own.p[0], lerp(own.p[0], own.p[1], 1.0 / 3.0),
                                              lerp(own.p[0], own.p[1], 2.0 / 3.0), own.p[1]}
                        : c.degree == 2 ? raised(own.as_quadratic())
                                        : own.as_cubic();
        return add(b, at(b, 0.0), at(b, 1.0), 0);
    }

private:
    static constexpr int deepest = 12;                   // divisions within divisions, each in two parts or more
    static constexpr double max_bound = 0x1p100;         // of a derivative, in em: beyond, nothing could be proven
    static constexpr double max_samples = 128.0;         // of a piece; one that needs more is divided untried
    static constexpr int parts_untried = 8;              // then. Powers of two: halvings of parameters are exact
    static constexpr int max_parts = 64;                 // of a piece that was tried
    static constexpr double gain = 16.0;                 // of two halves: the error is of fourth order
    static constexpr double rounded_up = 1.0 + 0x1p-30;  // more than all roundings together

    /// A place on a curve and its image, with the derivatives by t.
    struct station {
        double t;
        point place, along;
        point image, image_along;
    };

    [[nodiscard]] point in_text(point p) const noexcept { return at_.em_per_unit * p + at_.origin; }
    [[nodiscard]] point drawn(point image) const noexcept { return (1.0 / at_.em_per_unit) * (image - at_.origin); }

    [[nodiscard]] static box box_of(const point* p, std::uint32_t degree) noexcept
    {
        box around;
        for (std::uint32_t i = 0; i <= degree; ++i) around.add(p[i]);
        return around;
    }

    /// Whether a line's image is close to a line, in its place and in its direction.
    [[nodiscard]] bool stays_line(const curve& line, const bend_bounds& by) noexcept
    {
        if constexpr (keeps_lines<W>()) return true;
        const point v = line.p[1] - line.p[0];
        const double x = std::fabs(v.x), y = std::fabs(v.y), bent = by.xx * x * x + 2.0 * by.xy * x * y + by.yy * y * y;
        if (by.x_jump > 0.0) return false;
        if (is_zero(bent)) return true;
        constexpr double share = 0x1p-6;        // of the allowed distance: a chord is at most bent / 8 from its arc
        constexpr double least_turn = 0x1p-10;  // of its direction, in radians
        const bool close =
            bent <= 8.0 * share * allowed_ && bent <= least_turn * length(warps_(line.p[1]).at - warps_(line.p[0]).at);
        if (close) exact_ = false;
        return close;
    }

    [[nodiscard]] station at(const cubic& b, double t) const noexcept
    {
        station s{t, is_zero(t) ? b.p0 : same(t, 1.0) ? b.p3 : b.at(t), {}, {}, {}};
        const point d0 = b.p1 - b.p0, d1 = b.p2 - b.p1, d2 = b.p3 - b.p2;
        s.along = 3.0 * lerp(lerp(d0, d1, t), lerp(d1, d2, t), t);
        const warped_point w = warps_(s.place);
        s.image = w.at;
        s.image_along = s.along.x * w.x + s.along.y * w.y;
        return s;
    }

    /// The cubic with these ends and these derivatives.
    [[nodiscard]] static cubic between(point from, point leaving, point to, point arriving, double step) noexcept
    {
        return {from, from + (step / 3.0) * leaving, to - (step / 3.0) * arriving, to};
    }

    /// Appends the image of the piece between two stations.
    error add(const cubic& b, const station& from, const station& to, int depth) noexcept
    {
        const double step = to.t - from.t;
        const cubic own = between(from.place, from.along, to.place, to.along, step),
                    image = between(from.image, from.image_along, to.image, to.image_along, step);
        const auto [bound, jump] = bound_of(own, image);
        const double half = 0.5 * allowed_, share = jump > 0.0 ? 0.5 : 1.0;  // of the half, for each of the two
        if (!(bound + jump < max_bound) || depth == deepest) return error::bad_tolerance;
        const double samples = std::ceil(std::fmax(std::sqrt(bound / (8.0 * share * half)), jump / (2.0 * half)));
        int parts = parts_untried;
        if (samples <= max_samples) {
            const double farthest = farthest_of(b, from, step, image, static_cast<int>(samples));
            if (farthest <= half)
                return keep(curve::from(cubic{drawn(image.p0), drawn(image.p1), drawn(image.p2), drawn(image.p3)}));
            parts = 2;
            for (double left = farthest / gain; left > half && parts < max_parts; left /= gain) parts *= 2;
        }
        station last = from;
        for (int i = 1; i <= parts; ++i) {
            const station next = i == parts ? to : at(b, from.t + step * (static_cast<double>(i) / parts));
            if (error e = add(b, last, next, depth + 1)) return e;
            last = next;
        }
        return {};
    }

    /// Bounds for a parameter from 0 to 1.
    struct bounds {
        double second = 0.0;  // of the second derivative of f - H
        double jump = 0.0;    // of the jumps of its first derivative
    };

    [[nodiscard]] bounds bound_of(const cubic& own, const cubic& image) const noexcept
    {
        const point p[] = {own.p0, own.p1, own.p2, own.p3};
        const box around = box_of(p, 3);
        const bend_bounds by = warps_.bend(around);
        const point middle = lerp(around.low, around.high, 0.5), half = around.high - middle;
        const warped_point w = warps_(middle);
        point slope, bend;
        for (int i = 0; i < 3; ++i) slope = greater(slope, p[i + 1] - p[i]);
        const point bends[] = {own.p0 - 2.0 * own.p1 + own.p2, own.p1 - 2.0 * own.p2 + own.p3},
                    images[] = {image.p0 - 2.0 * image.p1 + image.p2, image.p1 - 2.0 * image.p2 + image.p3};
        double rest = 0.0;  // of H - A(B)
        for (int i = 0; i < 2; ++i) {
            bend = greater(bend, bends[i]);
            const double left = length(images[i] - bends[i].x * w.x - bends[i].y * w.y);
            rest = left > rest ? left : rest;
        }
        const double curved = 9.0 *
                              (by.xx * slope.x * slope.x + 2.0 * by.xy * slope.x * slope.y + by.yy * slope.y * slope.y),
                     turned = 6.0 * ((by.xx * half.x + by.xy * half.y + by.x_jump) * bend.x +
                                     (by.xy * half.x + by.yy * half.y) * bend.y);
        return {rounded_up * (curved + turned + 6.0 * rest), 3.0 * by.x_jump * slope.x};
    }

    /// The greatest distance at places that divide the piece into so many parts.
    [[nodiscard]] double farthest_of(const cubic& b, const station& from, double step, const cubic& image,
                                     int parts) const noexcept
    {
        double greatest = 0.0;
        for (int i = 1; i < parts; ++i) {
            const double u = static_cast<double>(i) / parts,
                         off = length(warps_(b.at(from.t + step * u)).at - image.at(u));
            greatest = off > greatest ? off : greatest;
        }
        return greatest;
    }

    /// The greater size in each coordinate.
    [[nodiscard]] static point greater(point size, point v) noexcept
    {
        const double x = std::fabs(v.x), y = std::fabs(v.y);
        return {x > size.x ? x : size.x, y > size.y ? y : size.y};
    }

    error keep(const curve& c) noexcept
    {
        if (out_.curves.size() >= most_) return {error::too_many_points, most_};
        for (std::uint32_t i = 0; i <= c.degree; ++i) {
            if (!is_finite(c.p[i].x) || !is_finite(c.p[i].y)) return error::outline_not_finite;
            out_.bounds.add(c.p[i]);
        }
        return out_.curves.push_back(c) ? error{} : error{error::out_of_memory};
    }

    const W& warps_;
    const drawn_place& at_;
    double allowed_;
    std::uint32_t most_;
    outline& out_;
    bool exact_ = true;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/impl/path_piece.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// A path in the text's plane, for letters that stand on it (text/on_path.hpp): lines, arcs of circles, quadratic and
/// cubic Bezier curves, one after the other, in em. Its sibling in space is text_path.
///
///     plane_path way;                          way.circle({0, 0}, 2.0);
///     way.move({0, 0});
///     way.line({3, 0});                                 .---.       A path has a direction. Letters stand on its left:
///     way.arc({3, -1}, -90.0);                  ------>-'    '.     outside on a circle that runs clockwise.
///     way.cubic({4, -2}, {5, -2}, {6, -1});                    v
///
/// An outline source can draw into it (outline_sink), and follow() takes a contour of an outline. close() leads back
/// to the start. Pieces of at most 2^-200 em are left out. Where a Bezier curve stands still, at a handle without a
/// length, the tangent is its limit. Calls that fail leave the reason in failure(), and a path with a failure is
/// refused where it is used.
///
/// The length of a Bezier curve is certain to 2^-48 of itself, except within 2^-40 of its parameters around a cusp
/// (impl/path_piece.hpp). A place is then found to some roundings of doubles.
///
/// Fails  error::bad_option "path": a number is not finite or above 2^20, a radius or an angle is 0, a call before
///        move() or after close(), a second move(), more than 2^20 pieces; error::out_of_memory
/// Cost   a Bezier curve is divided into some 4 to 16 pieces; a cusp takes 80 more
class plane_path {
public:
    using place = detail::path_place;    ///< a place: a point, its distance, the tangent, the curvature
    using bounds = detail::path_bounds;  ///< bounds of the curvature and of its changes

    explicit plane_path(memory source = heap()) noexcept : pieces_{source} {}

    /// Begins again, without pieces.
    void clear() noexcept
    {
        pieces_.clear();
        length_ = 0.0;
        begun_ = closed_ = false;
        failure_ = {};
    }

    /// Where the path begins.
    void move(point to) noexcept
    {
        if (begun_) return fail();
        begun_ = is_in_range(to);
        if (!begun_) return fail();
        first_ = now_ = to;
    }
    /// A line.
    void line(point to) noexcept
    {
        if (may_draw({to})) add(detail::path_piece::line(now_, to), to);
    }
    /// A quadratic Bezier curve.
    void quadratic(point control, point to) noexcept
    {
        if (may_draw({control, to})) divide(raised(quadratic_curve{now_, control, to}), 0);
    }
    /// A cubic Bezier curve.
    void cubic(point control, point control_2, point to) noexcept
    {
        if (may_draw({control, control_2, to})) divide({now_, control, control_2, to}, 0);
    }
    /// An arc around a centre, counter-clockwise if the angle is positive. More than a full turn is allowed.
    void arc(point centre, double degrees) noexcept
    {
        if (!may_draw({centre})) return;
        if (!is_finite(degrees) || is_zero(degrees) || std::fabs(degrees) > 0x1p20) return fail();
        if (!(typemesh::length(now_ - centre) > 0x1p-20)) return fail();
        const auto made = detail::path_piece::arc(now_, centre, degrees * 0.017453292519943295);
        const bool full = is_zero(std::fmod(degrees, 360.0));
        const detail::path_place end = made.at(made.size);
        add(made, full ? now_ : end.at);
    }
    /// Leads back to the start, by a line if the start is not within 2^-30 (1 + |x| + |y|) of the path's end; x and y
    /// are the start's. A shorter gap stays, so draw near 0 if letters must be placed exactly: at 2^20 em, where the
    /// range ends, it may be 0.002 em wide.
    void close() noexcept
    {
        if (!may_draw({})) return;
        // Arcs that lead back to the start miss it by a rounding, which has no direction.
        const double far_out = 1.0 + std::fabs(first_.x) + std::fabs(first_.y);
        if (typemesh::length(first_ - now_) > 0x1p-30 * far_out) line(first_);
        closed_ = true;
        if (!pieces_.empty()) join(pieces_.back(), pieces_[0]);
    }

    /// A closed circle. It runs clockwise from its lowest point, so its middle is on top, and letters stand outside.
    void circle(point centre, double radius) noexcept
    {
        if (!(radius > 0.0)) return fail();
        move(centre - point{0.0, radius});
        arc(centre, -360.0);
        close();
    }

    /// A contour of an outline, which is closed. `em_per_unit` makes its units em.
    void follow(const outline& drawn, std::uint32_t contour, double em_per_unit) noexcept
    {
        if (contour >= drawn.contour_count()) return fail();
        const std::uint32_t from = drawn.starts[contour], to = drawn.starts[contour + 1];
        for (std::uint32_t i = from; i < to; ++i) {
            const curve& c = drawn.curves[i];
            if (i == from) move(em_per_unit * c.p[0]);
            switch (c.degree) {
            case 1: line(em_per_unit * c.p[1]); break;
            case 2: quadratic(em_per_unit * c.p[1], em_per_unit * c.p[2]); break;
            default: cubic(em_per_unit * c.p[1], em_per_unit * c.p[2], em_per_unit * c.p[3]); break;
            }
        }
        close();
    }

    /// The first failure since clear(), or none.
    [[nodiscard]] error failure() const noexcept { return failure_; }
    /// In em; 0 if the path is empty.
    [[nodiscard]] double length() const noexcept { return length_; }
    /// Whether it has no piece.
    [[nodiscard]] bool empty() const noexcept { return pieces_.empty(); }
    /// Whether it leads back to its start.
    [[nodiscard]] bool is_closed() const noexcept { return closed_; }
    /// Whether it is one line.
    [[nodiscard]] bool is_straight() const noexcept
    {
        return pieces_.size() == 1 && pieces_[0].is == detail::path_piece::form::line;
    }

    /// The place at a distance from the start. Beyond its ends an open path goes on straight; a closed one goes around
    /// again. Precondition: not empty. Cost: O(log pieces), and a few evaluations of Gauss's rule on a Bezier curve
    [[nodiscard]] place at(double distance) const noexcept
    {
        TYPEMESH_ASSERT(!empty(), "a plane_path has no pieces: draw it first");
        const double rounds = rounds_before(distance), along = distance - rounds;
        place p;
        if (along < 0.0 || along > length_) {
            p = along < 0.0 ? pieces_[0].at(0.0) : pieces_.back().at(pieces_.back().size);
            p.curvature = 0.0;
        } else {
            const detail::path_piece& own = pieces_[piece_at(along)];
            const double rest = along - own.start;
            p = own.at(rest < 0.0 ? 0.0 : rest < own.size ? rest : own.size);
        }
        p.from += rounds;
        return p;
    }

    /// Bounds of the curvature between two distances; endless if there is a corner or a cusp. Cost: O(pieces between)
    [[nodiscard]] bounds between(double low, double high) const noexcept
    {
        TYPEMESH_ASSERT(!empty(), "a plane_path has no pieces: draw it first");
        bounds all;
        if (high - low >= length_ && closed_) {
            for (std::size_t i = 0; i < pieces_.size(); ++i) include(i, true, all);
            return all;
        }
        const double rounds = rounds_before(low), from = low - rounds, to = high - rounds;
        include_between(from, to, all);
        if (!closed_ && to >= length_) all.jump += std::fabs(pieces_.back().at(pieces_.back().size).curvature);
        if (closed_ && to >= length_) include_between(0.0, to - length_, all);
        return all;
    }

private:
    using quadratic_curve = typemesh::quadratic;

    static constexpr std::size_t max_pieces = 0x10'0000;
    static constexpr int deepest = 40;
    static constexpr double least_size = 0x1p-200;  // the squares of shorter lengths lose their digits

    void fail(error e = error::bad("path")) noexcept
    {
        if (!failure_) failure_ = e;
    }

    [[nodiscard]] static bool is_in_range(point p) noexcept
    {
        return is_finite(p.x) && is_finite(p.y) && std::fabs(p.x) <= 0x1p20 && std::fabs(p.y) <= 0x1p20;
    }
    [[nodiscard]] bool may_draw(std::initializer_list<point> points) noexcept
    {
        bool may = begun_ && !closed_ && !failure_;
        for (const point p : points) may = may && is_in_range(p);
        if (!may) fail();
        return may;
    }

    /// Finds what happens between the end of one piece and the start of the next one.
    static void join(const detail::path_piece& from, detail::path_piece& to) noexcept
    {
        const place a = from.at(from.size), b = to.at(0.0);
        const bool turns = std::fabs(cross(a.tangent, b.tangent)) > 0x1p-20 || dot(a.tangent, b.tangent) < 0.0;
        to.corner = !from.even || !to.even || turns;  // more than roundings
        to.jump = std::fabs(b.curvature - a.curvature);
    }

    void add(detail::path_piece made, point to) noexcept
    {
        now_ = to;
        if (!(made.size > least_size)) return;
        if (pieces_.size() >= max_pieces) return fail();
        made.start = length_;
        if (pieces_.empty())
            made.jump = std::fabs(made.at(0.0).curvature);  // before its start, the path is straight
        else
            join(pieces_.back(), made);
        length_ += made.size;
        if (!pieces_.push_back(made)) fail(error::out_of_memory);
    }

    void divide(const typemesh::cubic& c, int depth) noexcept
    {
        detail::path_piece made;
        if (detail::path_piece::read(c, made) || depth == deepest || !(made.size > 0.0)) return add(made, c.p3);
        const point a = lerp(c.p0, c.p1, 0.5), b = lerp(c.p1, c.p2, 0.5), d = lerp(c.p2, c.p3, 0.5),
                    ab = lerp(a, b, 0.5), bd = lerp(b, d, 0.5), middle = lerp(ab, bd, 0.5);
        divide({c.p0, a, ab, middle}, depth + 1);
        divide({middle, bd, d, c.p3}, depth + 1);
    }

    /// The length of the full rounds of a closed path before a distance.
    [[nodiscard]] double rounds_before(double distance) const noexcept
    {
        if (!closed_ || (distance >= 0.0 && distance <= length_)) return 0.0;
        return std::floor(distance / length_) * length_;
    }

    /// The last piece that begins at or before a distance; the first one for negative distances.
    [[nodiscard]] std::size_t piece_at(double along) const noexcept
    {
        return first_where(1, pieces_.size(), [&](std::size_t i) noexcept { return pieces_[i].start > along; }) - 1;
    }

    void include(std::size_t i, bool with_start, bounds& all) const noexcept
    {
        if (with_start && pieces_[i].corner) all.merge({-bounds::endless, bounds::endless, bounds::endless});
        if (with_start) all.jump += pieces_[i].jump;
        all.merge(pieces_[i].bounds);
    }
    void include_between(double low, double high, bounds& all) const noexcept
    {
        const std::size_t first = piece_at(low), last = piece_at(high);
        for (std::size_t i = first; i <= last; ++i)
            if (pieces_[i].start + pieces_[i].size >= low) include(i, pieces_[i].start >= low, all);
    }

    buffer<detail::path_piece> pieces_;
    double length_ = 0.0;
    point first_, now_;
    bool begun_ = false, closed_ = false;
    error failure_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/variation_axis.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The outline of one glyph at several coordinates of an axis: at each of them the same contours with the same curves,
/// also with those that have no length there.
class keyed_outlines {
public:
    explicit keyed_outlines(memory source = heap()) noexcept
        : coordinates_{source}, raw_{source}, raw_starts_{source}, recorded_{source}, curves_{source}, starts_{source}
    {
    }

    /// Records the glyph at these coordinates, which ascend.
    ///
    /// Fails  error::bad_outline: the outlines do not have the same contours and curves
    ///        error::outline_not_finite; error::too_many_points: more curves at all coordinates together than
    ///        max_curves; error::out_of_memory, and the errors of the font
    template <variation_axis Axis>
    error record(Axis& axis, glyph_id id, array_view<const axis_coordinate> at) noexcept
    {
        clear();
        for (const axis_coordinate c : at)
            if (error e = draw(axis, id, c)) return e;
        if (error e = find_contours()) return e;
        for (std::size_t k = 0; k < recorded_.size(); ++k)
            if (error e = take(k, curves_.size())) return e;
        return {};
    }

    /// Records the glyph at one more coordinate, and returns the number of its key.
    ///
    /// Fails  as record()
    template <variation_axis Axis>
    result<std::size_t> insert(Axis& axis, glyph_id id, axis_coordinate at) noexcept
    {
        if (error e = draw(axis, id, at)) return e;
        std::size_t key = keys() - 1;
        for (; key > 0 && coordinates_[key - 1] > at; --key) coordinates_[key] = coordinates_[key - 1];
        coordinates_[key] = at;
        if (error e = take(recorded_.size() - 1, key * count_)) return e;
        const recording done = recorded_.back();  // its curves have been copied
        raw_.truncate(done.first);
        raw_starts_.truncate(done.first_end);
        recorded_.truncate(recorded_.size() - 1);
        return key;
    }

    /// Forgets keys at which the outline does not stop moving evenly: whose bend_at() is at most `limit`, one after the
    /// other. O(curves at all keys).
    void forget_unbent(double limit) noexcept
    {
        std::size_t kept = 1;
        for (std::size_t k = 1; k < keys(); ++k) {
            if (k + 1 < keys() && bend(kept - 1, curves(k), coordinates_[k], k + 1) <= limit) continue;
            coordinates_[kept] = coordinates_[k];
            for (std::size_t i = 0; i < count_ && kept != k; ++i) curves_[kept * count_ + i] = curves_[k * count_ + i];
            ++kept;
        }
        if (kept >= keys()) return;
        coordinates_.truncate(kept);
        curves_.truncate(kept * count_);
    }

    /// Forgets a key.
    void remove(std::size_t key) noexcept
    {
        for (std::size_t i = key; i + 1 < keys(); ++i) coordinates_[i] = coordinates_[i + 1];
        coordinates_.truncate(keys() - 1);
        for (std::size_t i = key * count_; i + count_ < curves_.size(); ++i) curves_[i] = curves_[i + count_];
        curves_.truncate(curves_.size() - count_);
    }

    [[nodiscard]] std::size_t keys() const noexcept { return coordinates_.size(); }
    [[nodiscard]] array_view<const axis_coordinate> coordinates() const noexcept { return coordinates_.view(); }
    /// The curves at a key.
    [[nodiscard]] array_view<const curve> curves(std::size_t key) const noexcept
    {
        return curves_.view().subspan(key * count_, count_);
    }
    /// The first curve of each contour, and the end.
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return starts_.view(); }
    [[nodiscard]] const box& bounds() const noexcept { return bounds_; }

    /// How far the control points at a key are from the straight ways between its neighbours; in font units, by the
    /// larger of the two axes. 0 at the ends.
    [[nodiscard]] double bend_at(std::size_t key) const noexcept
    {
        return key == 0 || key + 1 == keys() ? 0.0 : bend(key - 1, curves(key), coordinates_[key], key + 1);
    }

    /// Likewise for curves at a coordinate between two keys.
    [[nodiscard]] double bend(std::size_t before, array_view<const curve> at, axis_coordinate c,
                              std::size_t after) const noexcept
    {
        const double s = static_cast<double>(c - coordinates_[before]) /
                         static_cast<double>(coordinates_[after] - coordinates_[before]);
        double largest = 0.0;
        for (std::size_t i = 0; i < count_; ++i)
            for (std::uint32_t k = 0; k <= at[i].degree; ++k) {
                const point way = at[i].p[k] - lerp(curves(before)[i].p[k], curves(after)[i].p[k], s);
                for (const double d : {way.x, way.y}) largest = d > largest ? d : -d > largest ? -d : largest;
            }
        return largest;
    }

    static constexpr std::size_t max_curves = 1u << 18;

private:
    /// Keeps all curves. A line that returns to the contour's start may be missing where it has no length.
    struct recorder {
        keyed_outlines& to;
        point start = {}, current = {};
        bool open = false;
        error failed = {};

        void move(point p) noexcept
        {
            close();
            start = current = p;
        }
        void line(point p) noexcept { keep(curve::from(current, p), p); }
        void quadratic(point c, point p) noexcept { keep(curve::from(typemesh::quadratic{current, c, p}), p); }
        void cubic(point c1, point c2, point p) noexcept { keep(curve::from(typemesh::cubic{current, c1, c2, p}), p); }
        void close() noexcept
        {
            if (!open) return;
            if (!(current == start)) line(start);
            open = false;
            if (!to.raw_starts_.push_back(static_cast<std::uint32_t>(to.raw_.size()))) failed = error::out_of_memory;
        }
        void keep(const curve& c, point p) noexcept
        {
            for (std::uint32_t k = 0; k <= c.degree; ++k) {
                if (!is_finite(c.p[k].x) || !is_finite(c.p[k].y)) failed = error::outline_not_finite;
                to.bounds_.add(c.p[k]);
            }
            current = p;
            open = true;
            if (!to.raw_.push_back(c)) failed = error::out_of_memory;
        }
    };

    /// One recording: its first curve and its ends of contours.
    struct recording {
        std::size_t first, first_end, ends;
    };

    void clear() noexcept
    {
        coordinates_.clear();
        raw_.clear();
        raw_starts_.clear();
        recorded_.clear();
        curves_.clear();
        starts_.clear();
        bounds_ = {};
        count_ = 0;
    }

    template <variation_axis Axis>
    error draw(Axis& axis, glyph_id id, axis_coordinate c) noexcept
    {
        const recording r{raw_.size(), raw_starts_.size(), 0};
        if (error e = axis.move_to(c)) return e;
        recorder pen{*this};
        if (error e = axis.font().outline(id, pen)) return e;
        pen.close();
        if (pen.failed) return pen.failed;
        if (raw_.size() > max_curves) return {error::too_many_points, max_curves};
        if (!recorded_.push_back({r.first, r.first_end, raw_starts_.size() - r.first_end}) ||
            !coordinates_.push_back(c))
            return error::out_of_memory;
        return {};
    }

    [[nodiscard]] std::size_t contour_begin(const recording& r, std::size_t contour) const noexcept
    {
        return contour == 0 ? r.first : raw_starts_[r.first_end + contour - 1];
    }
    [[nodiscard]] std::size_t contour_size(const recording& r, std::size_t contour) const noexcept
    {
        return raw_starts_[r.first_end + contour] - contour_begin(r, contour);
    }

    /// The contours that all recordings have, each with as many curves as anywhere.
    error find_contours() noexcept
    {
        if (!starts_.push_back(0)) return error::out_of_memory;
        const std::size_t contours = recorded_.empty() ? 0 : recorded_[0].ends;
        for (const recording& r : recorded_)
            if (r.ends != contours) return error::bad_outline;
        for (std::size_t c = 0; c < contours; ++c) {
            std::size_t largest = 0;
            for (const recording& r : recorded_) largest = contour_size(r, c) > largest ? contour_size(r, c) : largest;
            if (!starts_.push_back(starts_.back() + static_cast<std::uint32_t>(largest))) return error::out_of_memory;
        }
        count_ = starts_.back();
        return {};
    }

    /// Inserts the curves of a recording at `place`, with the lines that are missing.
    error take(std::size_t index, std::size_t place) noexcept
    {
        const recording r = recorded_[index];
        if (r.ends + 1 != starts_.size()) return error::bad_outline;
        const std::size_t moved = curves_.size() - place;
        if (curves_.append(count_) == nullptr && count_ != 0) return error::out_of_memory;
        for (std::size_t i = moved; i-- > 0;) curves_[place + count_ + i] = curves_[place + i];
        for (std::size_t c = 0; c < r.ends; ++c) {
            const std::size_t wanted = starts_[c + 1] - starts_[c], given = contour_size(r, c);
            if (given > wanted || given + 1 < wanted) return error::bad_outline;
            for (std::size_t i = 0; i < given; ++i) curves_[place + starts_[c] + i] = raw_[contour_begin(r, c) + i];
            if (given < wanted) {
                const point start = raw_[contour_begin(r, c)].start();
                curves_[place + starts_[c] + given] = curve::from(start, start);
            }
        }
        for (std::size_t i = 0; i < count_; ++i)
            if (curves_[place + i].degree != curves_[place < count_ ? (moved != 0 ? count_ : 0) + i : i].degree)
                return error::bad_outline;
        return {};
    }

    buffer<axis_coordinate> coordinates_;
    buffer<curve> raw_;
    buffer<std::uint32_t> raw_starts_;  // the ends of contours in raw_
    buffer<recording> recorded_;
    buffer<curve> curves_;
    buffer<std::uint32_t> starts_;
    box bounds_;
    std::size_t count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI

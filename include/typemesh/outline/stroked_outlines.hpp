// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/outline/impl/stroker.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/stroke_style.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Collects each path of a drawing, and strokes it when it ends. A path that close() does not end is open.
template <outline_sink Sink>
class stroking_sink {
public:
    stroking_sink(const stroker<Sink>& draw, std::uint32_t max_points, buffer<curve>& path) noexcept
        : draw_{draw}, max_points_{max_points}, path_{path}
    {
    }

    void move(point p) noexcept
    {
        end(false);
        note(p);
        start_ = current_ = p;
        begun_ = true;
    }
    void line(point p) noexcept
    {
        if (!(p == current_)) keep(curve::from(current_, p));
        go(p);
    }
    void quadratic(point control, point p) noexcept
    {
        note(control);
        if (!(control == current_ && p == current_)) keep(curve::from(typemesh::quadratic{current_, control, p}));
        go(p);
    }
    void cubic(point a, point b, point p) noexcept
    {
        note(a);
        note(b);
        if (!(a == current_ && b == current_ && p == current_)) keep(curve::from(typemesh::cubic{current_, a, b, p}));
        go(p);
    }
    void close() noexcept
    {
        if (!begun_) return;
        drawn_ = true;
        if (!(current_ == start_)) keep(curve::from(current_, start_));
        end(true);
    }

    /// Strokes the last path. Returns the first error.
    [[nodiscard]] error finish() noexcept
    {
        end(false);
        return error_;
    }

private:
    void refuse(const error& e) noexcept
    {
        if (!error_) error_ = e;
    }
    void note(point p) noexcept
    {
        if (!is_finite(p.x) || !is_finite(p.y)) refuse(error::outline_not_finite);
    }
    void go(point p) noexcept
    {
        note(p);
        drawn_ = true;
        current_ = p;
    }
    void keep(const curve& c) noexcept
    {
        if (!begun_)
            refuse(error::bad_outline);
        else if (path_.size() >= max_points_)
            refuse({error::too_many_points, max_points_});
        else if (!error_ && !path_.push_back(c))
            refuse(error::out_of_memory);
    }
    void end(bool closed) noexcept
    {
        if (!error_ && begun_) {
            if (!path_.empty())
                error_ = draw_.stroke(path_.view(), closed);
            else if (drawn_)
                draw_.dot_at(start_);
        }
        path_.clear();
        begun_ = drawn_ = false;
    }

    stroker<Sink> draw_;
    std::uint32_t max_points_;
    buffer<curve>& path_;
    point start_, current_;
    bool begun_ = false, drawn_ = false;
    error error_;
};

}  // namespace detail

/// A source that strokes the paths of another source: single-line fonts, drawings of open lines. The other source must
/// outlive it.
///
///     svg_path tick{"M4 12l5 5L20 6"};
///     stroked_outlines lines{tick, {.width = 0.1, .cap = stroke_cap::round}};
///     text_mesher mesher{lines};
///
/// A path is closed if its source calls close(), and open otherwise. A path that is only a point becomes a disc or a
/// square, if its caps are. The strokes overlap; the fill rule is non_zero.
///
/// Fails  in outline(): as the other source does; error::bad_option: "width", "mitre_limit", "dashes",
///        "dash_offset", "tolerance";
///        error::outline_not_finite, error::bad_outline, error::out_of_memory; error::outline_beyond_grid: a coordinate
///        is more than 2^40 tolerances from 0; error::too_many_points: one path has more than max_curves
template <outline_source Source>
class stroked_outlines {
public:
    static constexpr std::uint32_t max_curves = 1u << 20;  ///< of one path, which is kept until it ends

    /// `tolerance` is the distance between the sides of a stroke and their cubics, in em.
    explicit stroked_outlines(Source& source, const stroke_style& style = {}, double tolerance = 1e-4,
                              memory from = heap()) noexcept
        : source_{&source}, style_{style}, tolerance_{tolerance}, path_{from}
    {
    }

    [[nodiscard]] double units_per_em() const noexcept { return source_->units_per_em(); }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }

    /// See outline_source. Covers the other source, the style with its dashes, and the tolerance.
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        const auto kinds = static_cast<std::uint64_t>(style_.cap) << 8 | static_cast<std::uint64_t>(style_.join);
        std::uint64_t key = mixed_key(variation_of(*source_), kinds);
        for (const double number : {style_.width, style_.mitre_limit, style_.dash_offset, tolerance_})
            key = mixed_key(key, detail::bits_of(number));
        for (const double length : style_.dashes) key = mixed_key(key, detail::bits_of(length));
        return key;
    }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        if (error e = style_.refused()) return e;
        if (!is_finite(tolerance_) || !(tolerance_ > 0.0)) return error::bad("tolerance");
        path_.clear();
        const double em = source_->units_per_em();
        const detail::stroker<Sink> draw{style_, em, tolerance_ * em, sink};
        detail::stroking_sink<Sink> through{draw, max_curves, path_};
        if (error e = source_->outline(id, through)) return e;
        return through.finish();
    }

private:
    Source* source_;
    stroke_style style_;
    double tolerance_;
    buffer<curve> path_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <d2d1.h>
#include <dwrite.h>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Finds the quadratic of the font's own outline from DirectWrite's cubic: with control point q, c1 = p0 + 2/3 (q - p0)
/// and c2 = p3 + 2/3 (q - p3). DirectWrite returns c1 and c2 in single precision; Wine rounds them down to 1/64 unit,
/// twice. So q explains both if its error is at most 2.5/64 along each axis for both. A TrueType control point is
/// nearly always an integer point: the nearest one is used if it explains both, otherwise the mean of the estimates
/// from c1 and c2 if it does.
///
///     q   the control point; unchanged if there is none
[[nodiscard]] inline bool lower(point p0, point c1, point c2, point p3, point& q) noexcept
{
    const auto explains = [&](point c) noexcept {
        constexpr double most = 2.5 / 64;
        const point d1 = p0 + (2.0 / 3.0) * (c - p0) - c1, d2 = p3 + (2.0 / 3.0) * (c - p3) - c2;
        return std::fabs(d1.x) <= most && std::fabs(d1.y) <= most && std::fabs(d2.x) <= most && std::fabs(d2.y) <= most;
    };
    const point mean = 0.25 * (3.0 * (c1 + c2) - p0 - p3);
    const point whole{std::floor(mean.x + 0.5), std::floor(mean.y + 0.5)};
    if (explains(whole))
        q = whole;
    else if (explains(mean))
        q = mean;
    else
        return false;
    return true;
}

/// Passes the figures of a geometry to an outline_sink: y up, scaled, elevated quadratics lowered again, every figure
/// closed, hollow figures (which Direct2D does not fill) omitted. After the first error, all calls are ignored.
template <outline_sink Sink>
class geometry_pen final : public stack_object<ID2D1SimplifiedGeometrySink> {
public:
    geometry_pen(Sink& sink, double scale, bool lowers) noexcept : sink_{sink}, scale_{scale}, lowers_{lowers} {}

    [[nodiscard]] fill_rule fill() const noexcept { return fill_; }
    [[nodiscard]] error first_error() const noexcept { return first_error_; }

    void STDMETHODCALLTYPE SetFillMode(D2D1_FILL_MODE mode) noexcept override
    {
        fill_ = mode == D2D1_FILL_MODE_ALTERNATE ? fill_rule::even_odd : fill_rule::non_zero;
    }
    void STDMETHODCALLTYPE SetSegmentFlags(D2D1_PATH_SEGMENT) noexcept override {}
    void STDMETHODCALLTYPE BeginFigure(D2D1_POINT_2F start, D2D1_FIGURE_BEGIN begin) noexcept override
    {
        hollow_ = begin == D2D1_FIGURE_BEGIN_HOLLOW;
        open_ = true;
        at_ = unscaled(start);
        if (is_drawn(at_)) sink_.move(scale_ * at_);
    }
    void STDMETHODCALLTYPE AddLines(const D2D1_POINT_2F* points, UINT32 count) noexcept override
    {
        for (UINT32 i = 0; i < count; ++i) {
            at_ = unscaled(points[i]);
            if (is_drawn(at_)) sink_.line(scale_ * at_);
        }
    }
    void STDMETHODCALLTYPE AddBeziers(const D2D1_BEZIER_SEGMENT* curves, UINT32 count) noexcept override
    {
        for (UINT32 i = 0; i < count; ++i) {
            const point from = at_, c1 = unscaled(curves[i].point1), c2 = unscaled(curves[i].point2);
            at_ = unscaled(curves[i].point3);
            if (!is_drawn(c1) || !is_drawn(c2) || !is_drawn(at_)) continue;
            point q;
            if (lowers_ && lower(from, c1, c2, at_, q))
                sink_.quadratic(scale_ * q, scale_ * at_);
            else
                sink_.cubic(scale_ * c1, scale_ * c2, scale_ * at_);
        }
    }
    void STDMETHODCALLTYPE EndFigure(D2D1_FIGURE_END) noexcept override
    {
        if (is_drawn(at_)) sink_.close();
        open_ = false;
    }
    HRESULT STDMETHODCALLTYPE Close() noexcept override { return S_OK; }

private:
    static point unscaled(D2D1_POINT_2F p) noexcept { return {double{p.x}, 0.0 - double{p.y}}; }

    bool is_drawn(point p) noexcept
    {
        if (first_error_) return false;
        if (!open_)
            first_error_ = error::bad_outline;
        else if (!is_finite(p.x) || !is_finite(p.y))
            first_error_ = error::outline_not_finite;
        return !first_error_ && !hollow_;
    }

    Sink& sink_;
    double scale_;
    bool lowers_;
    bool hollow_ = false;
    bool open_ = false;
    point at_;  // in font units
    fill_rule fill_ = fill_rule::non_zero;
    error first_error_;
};

/// Whether a face has a table; with a 'glyf' table its outlines are made of quadratics.
[[nodiscard]] inline bool has_table(IDWriteFontFace* face, const char (&tag)[5]) noexcept
{
    const auto letter = [&](int i) noexcept { return std::uint32_t{static_cast<unsigned char>(tag[i])}; };
    const void* data = nullptr;
    void* context = nullptr;
    UINT32 size = 0;
    BOOL exists = FALSE;
    const std::uint32_t name = letter(0) | letter(1) << 8 | letter(2) << 16 | letter(3) << 24;
    if (FAILED(face->TryGetFontTable(name, &data, &size, &context, &exists)) || exists == FALSE) return false;
    if (context != nullptr) face->ReleaseFontTable(context);
    return size != 0;
}

/// Draws one glyph of a face, requested at one unit per font unit; `rule` becomes its fill rule.
template <outline_sink Sink>
error draw_glyph(IDWriteFontFace* face, double units_per_em, double scale, bool lowers, bool sideways, glyph_id id,
                 Sink& sink, fill_rule& rule) noexcept
{
    geometry_pen<Sink> pen{sink, scale, lowers};
    const auto index = static_cast<UINT16>(id);
    const HRESULT code = face->GetGlyphRunOutline(static_cast<FLOAT>(units_per_em), &index, nullptr, nullptr, 1,
                                                  sideways ? TRUE : FALSE, FALSE, &pen);
    rule = pen.fill();
    const error e = FAILED(code) ? directwrite_error(code) : pen.first_error();
    return e ? e.at(id, no_cluster) : e;
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI

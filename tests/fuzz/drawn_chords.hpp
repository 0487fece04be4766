// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <hb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fuzz {

/// What a font library itself draws for a glyph, without the adapters: short chords, in font units.
class drawn_chords {
public:
    drawn_chords(const typemesh::freetype_font& font, unsigned glyph)
    {
        FT_Face face = font.handle();  // a font unit is a pixel
        if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_IGNORE_TRANSFORM)) return;
        FT_Outline_Funcs calls{};
        calls.move_to = [](const FT_Vector* p, void* to) { return of(to).move(units(p->x), units(p->y)); };
        calls.line_to = [](const FT_Vector* p, void* to) { return of(to).line(units(p->x), units(p->y)); };
        calls.conic_to = [](const FT_Vector* c, const FT_Vector* p, void* to) {
            return of(to).quadratic(units(c->x), units(c->y), units(p->x), units(p->y));
        };
        calls.cubic_to = [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* p, void* to) {
            return of(to).cubic(units(c->x), units(c->y), units(d->x), units(d->y), units(p->x), units(p->y));
        };
        FT_Outline_Decompose(&face->glyph->outline, &calls, this);
        close();
    }

    drawn_chords(const typemesh::harfbuzz_font& font, unsigned glyph)
    {
        int scale = 0, same = 0;
        hb_font_get_scale(font.handle(), &scale, &same);
        unit_ = font.units_per_em() / scale;
        hb_draw_funcs_t* calls = hb_draw_funcs_create();
        hb_draw_funcs_set_move_to_func(
            calls, [](hb_draw_funcs_t*, void* to, hb_draw_state_t*, float x, float y, void*) { of(to).move(x, y); },
            nullptr, nullptr);
        hb_draw_funcs_set_line_to_func(
            calls, [](hb_draw_funcs_t*, void* to, hb_draw_state_t*, float x, float y, void*) { of(to).line(x, y); },
            nullptr, nullptr);
        hb_draw_funcs_set_quadratic_to_func(
            calls,
            [](hb_draw_funcs_t*, void* to, hb_draw_state_t*, float a, float b, float x, float y, void*) {
                of(to).quadratic(a, b, x, y);
            },
            nullptr, nullptr);
        hb_draw_funcs_set_cubic_to_func(
            calls,
            [](hb_draw_funcs_t*, void* to, hb_draw_state_t*, float a, float b, float c, float d, float x, float y,
               void*) { of(to).cubic(a, b, c, d, x, y); },
            nullptr, nullptr);
#if HB_VERSION_ATLEAST(7, 0, 0)
        hb_font_draw_glyph(font.handle(), glyph, calls, this);
#else
        hb_font_get_glyph_shape(font.handle(), glyph, calls, this);
#endif
        hb_draw_funcs_destroy(calls);
        close();
    }

    static constexpr std::size_t most = 5000;  ///< only the beginning of a longer outline is kept

    [[nodiscard]] bool empty() const noexcept { return chords_.empty(); }
    [[nodiscard]] bool is_whole() const noexcept { return chords_.size() < most; }
    /// The farthest coordinate.
    [[nodiscard]] double reach() const noexcept
    {
        return (std::max)({std::fabs(left), std::fabs(right), std::fabs(bottom), std::fabs(top)});
    }

    struct place {
        int winding = 0;
        double away = 1e300;  ///< from the nearest chord
    };
    [[nodiscard]] place at(double x, double y) const noexcept
    {
        place found;
        for (const chord& c : chords_) {
            const double dx = c.x1 - c.x0, dy = c.y1 - c.y0, px = x - c.x0, py = y - c.y0, square = dx * dx + dy * dy;
            const double t = square > 0.0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
            found.away = (std::min)(found.away, std::hypot(px - t * dx, py - t * dy));
            const double left_of = dx * py - dy * px;
            if (c.y0 <= y && c.y1 > y && left_of > 0.0) ++found.winding;
            if (c.y1 <= y && c.y0 > y && left_of < 0.0) --found.winding;
        }
        return found;
    }

    double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;

private:
    struct chord {
        double x0, y0, x1, y1;
    };
    static double units(FT_Pos v) noexcept { return static_cast<double>(v) / 64.0; }
    static drawn_chords& of(void* data) noexcept { return *static_cast<drawn_chords*>(data); }

    int move(double x, double y)
    {
        close();
        x_ = first_x_ = unit_ * x;
        y_ = first_y_ = unit_ * y;
        return 0;
    }
    int line(double x, double y) { return add(unit_ * x, unit_ * y); }
    int quadratic(double a, double b, double x, double y)
    {
        return curve(unit_ * (x_ / unit_ + 2.0 * a) / 3.0, unit_ * (y_ / unit_ + 2.0 * b) / 3.0,
                     unit_ * (x + 2.0 * a) / 3.0, unit_ * (y + 2.0 * b) / 3.0, unit_ * x, unit_ * y);
    }
    int cubic(double a, double b, double c, double d, double x, double y)
    {
        return curve(unit_ * a, unit_ * b, unit_ * c, unit_ * d, unit_ * x, unit_ * y);
    }
    /// So many chords that they stay within a quarter of a unit, by Wang's bound.
    int curve(double a, double b, double c, double d, double x, double y)
    {
        const double x0 = x_, y0 = y_;
        const double bend =
            (std::max)(std::hypot(x0 - 2.0 * a + c, y0 - 2.0 * b + d), std::hypot(a - 2.0 * c + x, b - 2.0 * d + y));
        const double steps = (std::max)(1.0, std::ceil(std::sqrt(0.75 * bend / 0.25)));
        for (double i = 1.0; i <= steps && chords_.size() <= most; ++i) {
            const double t = i / steps, s = 1.0 - t;
            add(s * s * s * x0 + 3.0 * s * s * t * a + 3.0 * s * t * t * c + t * t * t * x,
                s * s * s * y0 + 3.0 * s * s * t * b + 3.0 * s * t * t * d + t * t * t * y);
        }
        return 0;
    }
    int add(double x, double y)
    {
        chords_.push_back({x_, y_, x, y});
        for (const double v : {x_, x}) left = (std::min)(left, v), right = (std::max)(right, v);
        for (const double v : {y_, y}) bottom = (std::min)(bottom, v), top = (std::max)(top, v);
        x_ = x;
        y_ = y;
        return 0;
    }
    void close()
    {
        if (x_ < first_x_ || x_ > first_x_ || y_ < first_y_ || y_ > first_y_) add(first_x_, first_y_);
    }

    std::vector<chord> chords_;
    double unit_ = 1.0, x_ = 0.0, y_ = 0.0, first_x_ = 0.0, first_y_ = 0.0;
};

}  // namespace fuzz

// SPDX-License-Identifier: MIT
#pragma once

// Which pixels a text covers, told from its outlines alone: HarfBuzz's glyphs and places, a winding number a pixel. It
// shares nothing with the library.

#include <hb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace coverage {

struct segment {
    double x0, y0, x1, y1;
};

/// The segments of one glyph, in em, the pen's place added.
struct glyph_outline {
    std::vector<segment> segments;
    double scale, dx, dy;
    double x = 0.0, y = 0.0;

    void line(double to_x, double to_y)
    {
        segments.push_back({x * scale + dx, y * scale + dy, to_x * scale + dx, to_y * scale + dy});
        x = to_x, y = to_y;
    }
    void cubic(double ax, double ay, double bx, double by, double to_x, double to_y)
    {
        const double from_x = x, from_y = y;
        constexpr int steps = 64;
        for (int i = 1; i < steps; ++i) {
            const double t = double(i) / steps, s = 1.0 - t;
            line(s * s * s * from_x + 3 * s * s * t * ax + 3 * s * t * t * bx + t * t * t * to_x,
                 s * s * s * from_y + 3 * s * s * t * ay + 3 * s * t * t * by + t * t * t * to_y);
        }
        line(to_x, to_y);
    }
};

inline hb_draw_funcs_t* recorder()
{
    hb_draw_funcs_t* f = hb_draw_funcs_create();
    hb_draw_funcs_set_move_to_func(
        f,
        [](hb_draw_funcs_t*, void* o, hb_draw_state_t*, float x, float y, void*) {
            static_cast<glyph_outline*>(o)->x = x, static_cast<glyph_outline*>(o)->y = y;
        },
        nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(
        f,
        [](hb_draw_funcs_t*, void* o, hb_draw_state_t*, float x, float y, void*) {
            static_cast<glyph_outline*>(o)->line(x, y);
        },
        nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(  // quadratics come as cubics
        f,
        [](hb_draw_funcs_t*, void* o, hb_draw_state_t*, float ax, float ay, float bx, float by, float x, float y,
           void*) { static_cast<glyph_outline*>(o)->cubic(ax, ay, bx, by, x, y); },
        nullptr, nullptr);
    return f;
}

/// One outline a glyph, the text's begin at the origin, an em as 1.
inline std::vector<glyph_outline> outlines(const char* font_file, const char* text)
{
    hb_blob_t* blob = hb_blob_create_from_file(font_file);
    hb_face_t* face = hb_face_create(blob, 0);
    hb_font_t* font = hb_font_create(face);
    hb_buffer_t* buffer = hb_buffer_create();
    hb_buffer_add_utf8(buffer, text, -1, 0, -1);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(font, buffer, nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer, &count);
    hb_draw_funcs_t* record = recorder();
    const double em = 1.0 / hb_face_get_upem(face);
    double pen_x = 0.0, pen_y = 0.0;
    std::vector<glyph_outline> made;
    for (unsigned i = 0; i < count; ++i) {
        glyph_outline o{{}, em, (pen_x + places[i].x_offset) * em, (pen_y + places[i].y_offset) * em};
        hb_font_get_glyph_shape(font, infos[i].codepoint, record, &o);
        made.push_back(std::move(o));
        pen_x += places[i].x_advance, pen_y += places[i].y_advance;
    }
    hb_draw_funcs_destroy(record);
    hb_buffer_destroy(buffer);
    hb_font_destroy(font);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return made;
}

/// The picture of an orthographic camera: the middle of pixel (i, j), counted from below, is at left + (i + 0.5) / scale.
struct raster {
    int width, height;
    double left, bottom, scale;  ///< em, pixels an em
};

enum class seen : unsigned char { outside, inside, near_a_curve };

/// What each pixel's middle is, those nearer than `margin` (em) to a curve apart.
inline std::vector<seen> cover(const std::vector<glyph_outline>& glyphs, const raster& r, double margin)
{
    std::vector<seen> pixels(static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height), seen::outside);
    const auto at = [&](int i, int j) -> seen& {
        return pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(r.width) + static_cast<std::size_t>(i)];
    };
    std::vector<std::pair<double, int>> crossings;
    for (const glyph_outline& g : glyphs) {
        for (int j = 0; j < r.height; ++j) {
            const double y = r.bottom + (j + 0.5) / r.scale;
            crossings.clear();
            for (const segment& s : g.segments)
                if ((s.y0 <= y) != (s.y1 <= y))
                    crossings.emplace_back(s.x0 + (y - s.y0) / (s.y1 - s.y0) * (s.x1 - s.x0), s.y0 <= y ? 1 : -1);
            std::sort(crossings.begin(), crossings.end());
            int winding = 0;
            std::size_t next = 0;
            for (int i = 0; i < r.width; ++i) {
                for (; next < crossings.size() && crossings[next].first <= r.left + (i + 0.5) / r.scale; ++next)
                    winding += crossings[next].second;
                if (winding != 0) at(i, j) = seen::inside;
            }
        }
    }
    for (const glyph_outline& g : glyphs) {
        for (const segment& s : g.segments) {
            const auto pixel = [&](double v, double from) {
                return static_cast<int>(std::floor((v - from) * r.scale));
            };
            const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, length = dx * dx + dy * dy;
            for (int j = (std::max)(0, pixel((std::min)(s.y0, s.y1) - margin, r.bottom) - 1);
                 j <= (std::min)(r.height - 1, pixel((std::max)(s.y0, s.y1) + margin, r.bottom) + 1); ++j)
                for (int i = (std::max)(0, pixel((std::min)(s.x0, s.x1) - margin, r.left) - 1);
                     i <= (std::min)(r.width - 1, pixel((std::max)(s.x0, s.x1) + margin, r.left) + 1); ++i) {
                    const double x = r.left + (i + 0.5) / r.scale - s.x0, y = r.bottom + (j + 0.5) / r.scale - s.y0;
                    const double t = length > 0 ? std::clamp((x * dx + y * dy) / length, 0.0, 1.0) : 0.0;
                    if (std::hypot(x - t * dx, y - t * dy) <= margin) at(i, j) = seen::near_a_curve;
                }
        }
    }
    return pixels;
}

}  // namespace coverage

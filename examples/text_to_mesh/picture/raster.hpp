// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace text_to_mesh {

/// Pixels are divided into 256 steps per side, so that "which side of this edge?" is an exact integer question.
inline constexpr std::int32_t pixel_steps = 256;

/// Sixteen samples per pixel. Each of the 16 rows and columns of the pixel holds exactly one (the standard Direct3D
/// pattern), so that nearly vertical and nearly horizontal edges get 16 grey steps too.
inline constexpr int samples_per_pixel = 16;
inline constexpr std::int32_t sample_x[samples_per_pixel] = {152, 120, 88, 200, 56, 168, 216, 184,
                                                             104, 136, 72, 40,  8,  248, 232, 24};
inline constexpr std::int32_t sample_y[samples_per_pixel] = {152, 88, 168, 120, 104, 216, 184, 56,
                                                             232, 24, 40,  200, 136, 72,  248, 8};

/// A corner on the picture in steps, x to the right, y down. At most 2^24 either way.
struct raster_point {
    std::int32_t x, y;
};

/// Pixels left <= x < right, top <= y < bottom.
struct raster_window {
    int left, top, right, bottom;
};

/// The line from a to b; value() is positive to one side, and an edge of the neighbour, which runs from b to a, gives
/// the negative.
///
/// A sample on the line itself belongs to exactly one of the two: to the one whose edge runs down, or level to the
/// left.
struct raster_edge {
    std::int64_t dx, dy, constant;

    constexpr raster_edge() : dx(0), dy(0), constant(0) {}
    constexpr raster_edge(raster_point a, raster_point b) : dx(b.x - a.x), dy(b.y - a.y), constant(dy * a.x - dx * a.y)
    {
        if (dy > 0 || (dy == 0 && dx < 0)) constant += 1;  // "> 0" below then means ">= 0"
    }

    [[nodiscard]] constexpr std::int64_t value(std::int64_t x, std::int64_t y) const
    {
        return dx * y - dy * x + constant;
    }
};

/// Visits each pixel of `window` in which the triangle covers a sample: visit(x, y, mask), bit i for sample i.
///
/// Triangles that share edges cover every sample inside their union exactly once: no crack, no overlap. The orientation
/// of the triangle does not matter; one without area covers nothing.
template <class Visit>
void each_covered_pixel(raster_point a, raster_point b, raster_point c, raster_window window, Visit&& visit)
{
    const std::int64_t area = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
    if (area == 0) return;
    const raster_edge edges[3] = {area > 0 ? raster_edge(a, b) : raster_edge(b, a),
                                  area > 0 ? raster_edge(b, c) : raster_edge(c, b),
                                  area > 0 ? raster_edge(c, a) : raster_edge(a, c)};

    const auto low = [](std::int32_t p, std::int32_t q, std::int32_t r) {
        return p < q ? (p < r ? p : r) : (q < r ? q : r);
    };
    const auto high = [](std::int32_t p, std::int32_t q, std::int32_t r) {
        return p > q ? (p > r ? p : r) : (q > r ? q : r);
    };
    const int left = low(a.x, b.x, c.x) >> 8, right = (high(a.x, b.x, c.x) >> 8) + 1;
    const int top = low(a.y, b.y, c.y) >> 8, bottom = (high(a.y, b.y, c.y) >> 8) + 1;
    if (window.left < left) window.left = left;
    if (window.right > right) window.right = right;
    if (window.top < top) window.top = top;
    if (window.bottom > bottom) window.bottom = bottom;
    if (window.left >= window.right) return;

    // What a sample adds to an edge's value at its pixel's corner, and the range of that.
    std::int64_t offset[3][samples_per_pixel], lowest[3], highest[3];
    for (int e = 0; e < 3; ++e) {
        for (int s = 0; s < samples_per_pixel; ++s) {
            offset[e][s] = edges[e].dx * sample_y[s] - edges[e].dy * sample_x[s];
            if (s == 0 || offset[e][s] < lowest[e]) lowest[e] = offset[e][s];
            if (s == 0 || offset[e][s] > highest[e]) highest[e] = offset[e][s];
        }
    }

    for (int y = window.top; y < window.bottom; ++y) {
        std::int64_t value[3];
        for (int e = 0; e < 3; ++e)
            value[e] = edges[e].value(std::int64_t{window.left} * pixel_steps, std::int64_t{y} * pixel_steps);
        bool been_inside = false;
        for (int x = window.left; x < window.right; ++x) {
            const bool outside = value[0] + highest[0] <= 0 || value[1] + highest[1] <= 0 || value[2] + highest[2] <= 0;
            if (!outside) {
                been_inside = true;
                unsigned mask = 0xFFFFu;
                if (value[0] + lowest[0] <= 0 || value[1] + lowest[1] <= 0 || value[2] + lowest[2] <= 0) {
                    mask = 0;
                    for (int s = 0; s < samples_per_pixel; ++s) {
                        const bool in =
                            value[0] + offset[0][s] > 0 && value[1] + offset[1][s] > 0 && value[2] + offset[2][s] > 0;
                        mask |= unsigned{in} << s;
                    }
                }
                if (mask != 0) visit(x, y, mask);
            } else if (been_inside) {
                break;  // a triangle is convex: the row is done
            }
            for (int e = 0; e < 3; ++e) value[e] -= edges[e].dy * pixel_steps;
        }
    }
}

}  // namespace text_to_mesh

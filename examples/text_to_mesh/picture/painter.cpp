// SPDX-License-Identifier: MIT
#include "painter.hpp"

#include "srgb.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace text_to_mesh {
namespace {

constexpr std::uint32_t nothing = 0xFFFFFFFFu;

}  // namespace

painter::painter(const model& mesh, const overlay& over, const picture_options& options)
    : seen_(view_of(mesh, over, options)),
      backdrop_(mesh, options, seen_),
      scene_(mesh, over, options, seen_),
      surface_(mesh, options, seen_.from),
      depth_(static_cast<std::size_t>(tile_side) * tile_side * samples_per_pixel),
      owner_(depth_.size()),
      colour_(static_cast<std::size_t>(tile_side) * tile_side)
{
}

std::vector<unsigned char> painter::paint()
{
    std::vector<unsigned char> rgb(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 3);
    for (int row = 0; row < scene_.rows(); ++row)
        for (int column = 0; column < scene_.columns(); ++column) paint_tile(column, row, rgb);
    return rgb;
}

void painter::paint_tile(int column, int row, std::vector<unsigned char>& rgb)
{
    const scene::tile& in = scene_.at(column, row);
    const raster_window window{column * tile_side, row * tile_side, (std::min)((column + 1) * tile_side, seen_.width),
                               (std::min)((row + 1) * tile_side, seen_.height)};
    const auto place = [&](int x, int y) {
        return static_cast<std::size_t>((y - window.top) * tile_side + (x - window.left));
    };
    if (!in.triangles.empty() || !in.lines.empty()) {
        std::fill(depth_.begin(), depth_.end(), 0.0F);
        std::fill(owner_.begin(), owner_.end(), nothing);
    }
    for (const std::uint32_t number : in.triangles) {
        const flat_triangle& t = scene_.triangle(number);
        each_covered_pixel(t.at[0], t.at[1], t.at[2], window, [&](int x, int y, unsigned mask) {
            cover(t, number, x, y, mask, place(x, y) * samples_per_pixel);
        });
    }
    for (int y = window.top; y < window.bottom; ++y)
        for (int x = window.left; x < window.right; ++x)
            colour_[place(x, y)] =
                in.triangles.empty() ? backdrop_.at(x, y) : resolve(x, y, place(x, y) * samples_per_pixel);
    for (const std::uint32_t number : in.lines) paint_line(scene_.line(number), window);
    for (int y = window.top; y < window.bottom; ++y) {
        unsigned char* out = rgb.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(seen_.width) +
                                           static_cast<std::size_t>(window.left)) *
                                              3;
        for (int x = window.left; x < window.right; ++x) {
            const vec3 c = colour_[place(x, y)];
            *out++ = to_srgb(c.x);
            *out++ = to_srgb(c.y);
            *out++ = to_srgb(c.z);
        }
    }
}

void painter::cover(const flat_triangle& t, std::uint32_t number, int x, int y, unsigned mask, std::size_t first_sample)
{
    const double corner =
        t.plane[0] + t.plane[1] * (x * pixel_steps - t.at[0].x) + t.plane[2] * (y * pixel_steps - t.at[0].y);
    for (; mask != 0; mask &= mask - 1) {
        const auto s = static_cast<std::size_t>(std::countr_zero(mask));
        const double inverse =
            (std::min)(t.highest, (std::max)(t.lowest, corner + t.plane[1] * sample_x[s] + t.plane[2] * sample_y[s]));
        if (static_cast<float>(inverse) <= depth_[first_sample + s]) continue;
        depth_[first_sample + s] = static_cast<float>(inverse);
        owner_[first_sample + s] = number;
    }
}

vec3 painter::resolve(int x, int y, std::size_t first_sample) const
{
    vec3 sum;
    unsigned left = 0xFFFFu;
    while (left != 0) {
        const std::uint32_t owner = owner_[first_sample + static_cast<std::size_t>(std::countr_zero(left))];
        unsigned mine = 0;
        std::int32_t sx = 0, sy = 0;
        for (unsigned s = 0; s < samples_per_pixel; ++s) {
            if (owner_[first_sample + s] != owner) continue;
            mine |= 1u << s;
            sx += sample_x[s];
            sy += sample_y[s];
        }
        left &= ~mine;
        const int count = std::popcount(mine);
        const vec3 colour = owner == nothing
                                ? backdrop_.at(x, y)
                                : surface_.shade(scene_.triangle(owner), double(x) * pixel_steps + double(sx) / count,
                                                 double(y) * pixel_steps + double(sy) / count, x, y, mine);
        sum = sum + (double(count) / samples_per_pixel) * colour;
    }
    return sum;
}

void painter::paint_line(const flat_line& line, raster_window window)
{
    const double reach = line.radius + 1.0;
    const auto within = [](double v, int low, int high) {
        return v < low ? low : (v > high ? high : static_cast<int>(v));
    };
    const int left = within(std::floor((std::min)(line.x[0], line.x[1]) - reach), window.left, window.right);
    const int right = within(std::ceil((std::max)(line.x[0], line.x[1]) + reach), window.left, window.right);
    const int top = within(std::floor((std::min)(line.y[0], line.y[1]) - reach), window.top, window.bottom);
    const int bottom = within(std::ceil((std::max)(line.y[0], line.y[1]) + reach), window.top, window.bottom);
    const double dx = line.x[1] - line.x[0], dy = line.y[1] - line.y[0];
    const double length2 = dx * dx + dy * dy;
    const double closer = 1.0 + (line.radius + 2.0) / seen_.from.pixels;  // lifts the line off the surface it lies on
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            const double ox = x + 0.5 - line.x[0], oy = y + 0.5 - line.y[0];
            const double along = length2 > 0.0 ? clamp01((ox * dx + oy * dy) / length2) : 0.0;
            const double ex = ox - along * dx, ey = oy - along * dy;
            const double covered = clamp01(line.radius + 0.5 - std::sqrt(ex * ex + ey * ey));
            if (covered <= 0.0) continue;
            const double inverse = (line.inverse[0] + along * (line.inverse[1] - line.inverse[0])) * closer;
            const std::size_t pixel = static_cast<std::size_t>((y - window.top) * tile_side + (x - window.left));
            int seen = 0;
            for (std::size_t s = 0; s < samples_per_pixel; ++s)
                seen += double{depth_[pixel * samples_per_pixel + s]} <= inverse ? 1 : 0;
            colour_[pixel] = mix(colour_[pixel], line.colour, covered * line.opacity * seen / samples_per_pixel);
        }
    }
}

}  // namespace text_to_mesh

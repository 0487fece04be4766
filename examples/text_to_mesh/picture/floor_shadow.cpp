// SPDX-License-Identifier: MIT
#include "floor_shadow.hpp"

#include "raster.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace text_to_mesh {
namespace {

/// Three passes of a running mean come near a bell curve. `stride` steps along a line, `lines` of them `next` apart.
void blur(std::vector<float>& map, std::size_t count, std::size_t stride, std::size_t lines, std::size_t next,
          int radius)
{
    std::vector<float> line(count);
    const auto n = static_cast<std::ptrdiff_t>(count);
    for (std::size_t l = 0; l < lines; ++l) {
        float* const start = map.data() + l * next;
        for (int pass = 0; pass < 3; ++pass) {
            for (std::size_t i = 0; i < count; ++i) line[i] = start[i * stride];
            double sum = 0.0;
            for (std::ptrdiff_t i = -radius; i < n + radius; ++i) {
                if (i + radius < n && i + radius >= 0) sum += double{line[static_cast<std::size_t>(i + radius)]};
                if (i - radius - 1 >= 0 && i - radius - 1 < n)
                    sum -= double{line[static_cast<std::size_t>(i - radius - 1)]};
                if (i >= 0 && i < n)
                    start[static_cast<std::size_t>(i) * stride] = static_cast<float>(sum / (2 * radius + 1));
            }
        }
    }
}

}  // namespace

floor_shadow::floor_shadow(const model& mesh)
{
    if (mesh.indices.empty()) return;
    vec3 low = to_vec3(mesh.vertices[mesh.indices[0]].position), high = low;
    for (const std::uint32_t i : mesh.indices) {
        const vec3 p = to_vec3(mesh.vertices[i].position);
        if (!std::isfinite(p.x + p.y + p.z)) return;
        low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
        high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    }
    const double depth = high.z - low.z;
    const double border = 2.5 * depth;
    const double width = high.x - low.x + 2.0 * border;
    if (!(depth > 0.0) || !(width < 1e30)) return;

    cell_ = (std::max)(depth / 24.0, width / 4096.0);
    left_ = low.x - border;
    back_ = low.z - border;
    floor_ = low.y;
    columns_ = static_cast<int>(width / cell_) + 1;
    rows_ = static_cast<int>((depth + 2.0 * border) / cell_) + 1;
    const auto columns = static_cast<std::size_t>(columns_), rows = static_cast<std::size_t>(rows_);
    shade_.assign(columns * rows, 0.0F);

    const auto on_map = [&](vec3 p) {
        return raster_point{static_cast<std::int32_t>((p.x - left_) / cell_ * pixel_steps),
                            static_cast<std::int32_t>((p.z - back_) / cell_ * pixel_steps)};
    };
    constexpr double highest_seen = 20.0;  // in depths: what is higher darkens the floor by less than 1/1000
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        vec3 p[3];
        for (std::size_t i = 0; i < 3; ++i) p[i] = to_vec3(mesh.vertices[mesh.indices[t + i]].position);
        const double height = ((p[0].y + p[1].y + p[2].y) / 3.0 - floor_) / depth;
        if (height > highest_seen) continue;  // of a long text that is all but the last lines
        const auto darkness = static_cast<float>(1.0 / (1.0 + 2.5 * height * height));
        each_covered_pixel(
            on_map(p[0]), on_map(p[1]), on_map(p[2]), {0, 0, columns_, rows_}, [&](int x, int y, unsigned mask) {
                float& cell = shade_[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
                cell = (std::max)(cell, darkness * static_cast<float>(std::popcount(mask)) / float{samples_per_pixel});
            });
    }

    std::vector<float> wide = shade_;
    const auto radius = [&](double of_depth) { return (std::max)(1, static_cast<int>(of_depth * depth / cell_)); };
    for (const auto& [map, r] : {std::pair{&shade_, radius(0.05)}, std::pair{&wide, radius(0.45)}}) {
        blur(*map, columns, 1, rows, columns, r);
        blur(*map, rows, columns, columns, 1, r);
    }
    for (std::size_t i = 0; i < shade_.size(); ++i) shade_[i] = 0.38F * shade_[i] + 0.45F * wide[i];
}

double floor_shadow::light_along(vec3 eye, vec3 ray) const
{
    if (shade_.empty() || !(ray.y < 0.0) || !(eye.y > floor_)) return 1.0;
    const vec3 at = eye + ((floor_ - eye.y) / ray.y) * ray;
    const double x = (at.x - left_) / cell_ - 0.5, z = (at.z - back_) / cell_ - 0.5;
    if (!(x > 0.0 && z > 0.0 && x < columns_ - 1 && z < rows_ - 1)) return 1.0;
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(z);
    const double fx = x - double(column), fz = z - double(row);
    const float* cell = shade_.data() + row * static_cast<std::size_t>(columns_) + column;
    const double upper = double{cell[0]} * (1.0 - fx) + double{cell[1]} * fx;
    const double lower = double{cell[columns_]} * (1.0 - fx) + double{cell[columns_ + 1]} * fx;
    return 1.0 - (upper * (1.0 - fz) + lower * fz);
}

}  // namespace text_to_mesh

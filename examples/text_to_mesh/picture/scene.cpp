// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include "raster.hpp"
#include "srgb.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <unordered_map>
#include <utility>

namespace text_to_mesh {
namespace {

/// False for what no picture can hold: infinite or absurd places.
[[nodiscard]] bool drawable(const camera::projected& p)
{
    return p.x > -16000.0 && p.x < 16000.0 && p.y > -16000.0 && p.y < 16000.0 && p.inverse > 0.0 && p.inverse < 1e30;
}

/// For each vertex the first at its place, bit by bit: texture seams and hard corners double vertices, not edges.
std::vector<std::uint32_t> welded(const model& mesh)
{
    std::unordered_map<std::string, std::uint32_t> seen;
    std::vector<std::uint32_t> first(mesh.vertices.size());
    seen.reserve(mesh.vertices.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        std::string key(sizeof(float) * 3, '\0');
        std::memcpy(key.data(), mesh.vertices[i].position, key.size());
        first[i] = seen.emplace(std::move(key), static_cast<std::uint32_t>(i)).first->second;
    }
    return first;
}

}  // namespace

scene::scene(const model& mesh, const overlay& over, const picture_options& options, const view& seen)
    : from_(seen.from),
      columns_((seen.width + tile_side - 1) / tile_side),
      rows_((seen.height + tile_side - 1) / tile_side),
      tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_))
{
    add_triangles(mesh);
    const double width = double{options.line_px};
    if (options.wireframe) add_wireframe(mesh, width / 2.0);
    add_overlay(over, width * 0.75);
}

template <class Add>
void scene::each_tile(double left, double top, double right, double bottom, Add&& add)
{
    const int first_column = (std::max)(0, static_cast<int>(left) / tile_side),
              last_column = (std::min)(columns_ - 1, static_cast<int>(right) / tile_side);
    const int first_row = (std::max)(0, static_cast<int>(top) / tile_side),
              last_row = (std::min)(rows_ - 1, static_cast<int>(bottom) / tile_side);
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column)
            add(tiles_[static_cast<std::size_t>(row * columns_ + column)]);
}

void scene::add_triangles(const model& mesh)
{
    std::vector<model::part> parts = mesh.parts;
    if (parts.empty()) parts.push_back({"", 0, mesh.indices.size()});
    triangles_.reserve(mesh.indices.size() / 3);
    for (std::size_t part = 0; part < parts.size(); ++part)
        for (std::size_t i = 0; i + 2 < parts[part].index_count; i += 3)
            add_triangle(mesh, static_cast<std::uint32_t>(parts[part].first_index + i),
                         static_cast<std::uint32_t>(part));
}

void scene::add_triangle(const model& mesh, std::uint32_t first, std::uint32_t part)
{
    flat_triangle t{};
    t.first = first;
    t.part = part;
    double x[3], y[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const camera::projected p = from_.project(to_vec3(mesh.vertices[mesh.indices[first + i]].position));
        if (!drawable(p)) return;
        t.at[i] = {static_cast<std::int32_t>(std::lround(p.x * pixel_steps)),
                   static_cast<std::int32_t>(std::lround(p.y * pixel_steps))};
        t.inverse[i] = p.inverse;
        x[i] = t.at[i].x;
        y[i] = t.at[i].y;
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    if (area == 0.0) return;
    t.turned_away = area > 0.0;  // y runs down here
    // What is turned away sits a hair farther back, so that it never shines through at the outline.
    const double shift = t.turned_away ? 1.0 - 1e-5 : 1.0;
    const double a = t.inverse[1] - t.inverse[0], b = t.inverse[2] - t.inverse[0];
    t.plane[0] = t.inverse[0] * shift;
    t.plane[1] = (a * (y[2] - y[0]) - b * (y[1] - y[0])) / area * shift;
    t.plane[2] = (b * (x[1] - x[0]) - a * (x[2] - x[0])) / area * shift;
    t.lowest = (std::min)({t.inverse[0], t.inverse[1], t.inverse[2]}) * shift;
    t.highest = (std::max)({t.inverse[0], t.inverse[1], t.inverse[2]}) * shift;
    const auto number = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(t);
    const auto [left, right] = std::minmax({x[0], x[1], x[2]});
    const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
    each_tile(left / pixel_steps, top / pixel_steps, right / pixel_steps, bottom / pixel_steps,
              [&](tile& in) { in.triangles.push_back(number); });
}

/// Each edge once, however many triangles and doubled vertices share it.
void scene::add_wireframe(const model& mesh, double radius)
{
    const std::vector<std::uint32_t> place = welded(mesh);
    std::vector<std::uint64_t> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        bool drawn = true;
        for (std::size_t i = 0; i < 3; ++i)
            drawn = drawn && drawable(from_.project(to_vec3(mesh.vertices[mesh.indices[t + i]].position)));
        for (std::size_t i = 0; drawn && i < 3; ++i) {
            const std::uint64_t a = place[mesh.indices[t + i]], b = place[mesh.indices[t + (i + 1) % 3]];
            if (a != b) edges.push_back((std::min)(a, b) << 32 | (std::max)(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    static const unsigned char ink[3] = {28, 30, 38};
    for (const std::uint64_t edge : edges)
        add_line(mesh.vertices[edge >> 32].position, mesh.vertices[edge & 0xFFFFFFFFu].position, ink, radius, 0.6);
}

void scene::add_overlay(const overlay& over, double radius)
{
    for (const overlay::segment& s : over.segments) add_line(s.a, s.b, s.rgb, radius, 1.0);
    static const unsigned char white[3] = {255, 255, 255};
    for (const overlay::dot& d : over.dots) {
        add_line(d.p, d.p, white, double{d.radius_px} + 1.0, 0.85);
        add_line(d.p, d.p, d.rgb, double{d.radius_px}, 1.0);
    }
}

void scene::add_line(const float (&a)[3], const float (&b)[3], const unsigned char (&rgb)[3], double radius,
                     double opacity)
{
    const camera::projected p = from_.project(to_vec3(a)), q = from_.project(to_vec3(b));
    if (!drawable(p) || !drawable(q)) return;
    const auto number = static_cast<std::uint32_t>(lines_.size());
    lines_.push_back({{p.x, q.x}, {p.y, q.y}, {p.inverse, q.inverse}, radius, opacity, to_linear(rgb)});
    const double reach = radius + 1.0;
    each_tile((std::min)(p.x, q.x) - reach, (std::min)(p.y, q.y) - reach, (std::max)(p.x, q.x) + reach,
              (std::max)(p.y, q.y) + reach, [&](tile& in) { in.lines.push_back(number); });
}

}  // namespace text_to_mesh

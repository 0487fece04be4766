// SPDX-License-Identifier: MIT
//
// Draws letters as flat_curved's triangles, and beside them what a shader draws of these, as a PPM file on the standard
// output: see make.sh. The inner polygon is blue, convex curves are yellow, concave ones green.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace typemesh;

struct curved_vertex {
    vec3 position, curve;
};
template <>
struct typemesh::vertex_traits<curved_vertex> {
    static constexpr auto wants = attribute::position | attribute::curve;
    curved_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.curve}; }
};

namespace {

constexpr int height = 600, margin = 16;
constexpr double pixels = 560.0;  // per em

struct colour {
    double r, g, b;
};

/// One sample of a picture: the triangle under q, and its edges.
colour seen(const std::vector<curved_vertex>& v, const std::vector<std::uint32_t>& index, vec2 q, bool shaded)
{
    colour found{255, 255, 255};
    for (std::size_t t = 0; t < index.size(); t += 3) {
        const curved_vertex &a = v[index[t]], &b = v[index[t + 1]], &c = v[index[t + 2]];
        const auto beside = [q](vec3 from, vec3 to) {  // the distance from an edge, inwards
            const float x = to.x - from.x, y = to.y - from.y;
            return (x * (q.y - from.y) - y * (q.x - from.x)) / std::hypot(x, y);
        };
        const float of_c = beside(a.position, b.position), of_a = beside(b.position, c.position),
                    of_b = beside(c.position, a.position), nearest = std::min({of_a, of_b, of_c});
        if (nearest < 0.0f) continue;
        const auto whole = [](float part, float all) { return part / all; };
        const auto height_of = [](vec3 p, vec3 from, vec3 to) {
            const float x = to.x - from.x, y = to.y - from.y;
            return (x * (p.y - from.y) - y * (p.x - from.x)) / std::hypot(x, y);
        };
        const float wa = whole(of_a, height_of(a.position, b.position, c.position)),
                    wb = whole(of_b, height_of(b.position, c.position, a.position)), wc = 1.0f - wa - wb;
        const vec3 k{wa * a.curve.x + wb * b.curve.x + wc * c.curve.x, wa * a.curve.y + wb * b.curve.y + wc * c.curve.y,
                     wa * a.curve.z + wb * b.curve.z + wc * c.curve.z};
        const bool inside = k.x * std::abs(k.x) - k.y * k.z < 0.0f;
        if (shaded) return inside ? colour{30, 30, 30} : found;
        const bool inner = a.curve == vec3{-1, 0, 0}, concave = a.curve.y < 0.0f;
        found = inner ? colour{170, 195, 225} : concave ? colour{160, 215, 150} : colour{250, 205, 120};
        if (!inner && inside) found = {0.8 * found.r, 0.8 * found.g, 0.8 * found.b};
        if (static_cast<double>(nearest) * pixels < 0.6) found = {40, 40, 40};
        return found;
    }
    return found;
}

}  // namespace

int main(int, char** argv)
{
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    text_mesher mesher{*font, flat_curved{}};
    std::vector<curved_vertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto made = mesher.build(argv[2], into(vertices, indices));
    if (!made) return std::puts(made.error().message()), 1;
    bounds3 all;
    for (const curved_vertex& v : vertices) all.add(v.position);
    const int width = static_cast<int>(static_cast<double>(all.high.x - all.low.x) * pixels) + 2 * margin;
    std::printf("P6\n%d %d\n255\n", 2 * width, height);
    constexpr int finer = 4;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * width; ++x) {
            colour sum{0, 0, 0};
            for (int i = 0; i < finer * finer; ++i) {
                const double right = x % width - margin + (i % finer + 0.5) / finer,
                             up = height - margin - y - (i / finer + 0.5) / finer;
                const vec2 q{all.low.x + static_cast<float>(right / pixels),
                             all.low.y + static_cast<float>(up / pixels)};
                const colour c = seen(vertices, indices, q, x >= width);
                sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
            }
            for (const double v : {sum.r, sum.g, sum.b}) std::putchar(static_cast<int>(v / (finer * finer)));
        }
    return 0;
}

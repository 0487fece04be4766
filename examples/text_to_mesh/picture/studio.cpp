// SPDX-License-Identifier: MIT
#include "studio.hpp"

#include "srgb.hpp"

#include <algorithm>
#include <cmath>

namespace text_to_mesh {
namespace {

double power_of_two(double x, int doublings)
{
    for (int i = 0; i < doublings; ++i) x *= x;
    return x;
}

double smooth(double from, double to, double x)
{
    const double t = clamp01((x - from) / (to - from));
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

light studio_light(vec3 n, vec3 seen)
{
    static const vec3 key = normalised({0.22, 0.52, 0.82});
    static const vec3 fill = normalised({-0.90, 0.25, 0.35});
    static const vec3 other = normalised({0.95, 0.10, 0.10});
    const auto lambert = [&](vec3 l) { return (std::max)(0.0, dot(n, l)); };

    light out;
    const vec3 sky{0.46, 0.48, 0.52}, floor{0.24, 0.22, 0.21};
    out.diffuse = mix(floor, sky, 0.5 + 0.5 * n.y) + (0.66 * lambert(key)) * vec3{1.0, 0.985, 0.96} +
                  (0.42 * lambert(fill)) * vec3{0.93, 0.97, 1.0} + (0.18 * lambert(other)) * vec3{1.0, 0.97, 0.93};

    // Gloss: a tall soft box mirrored in rounded walls, more of it where the wall is seen edge on, and the lamp's own
    // highlight.
    const double edge = 1.0 - clamp01(seen.z);
    const double fresnel = 0.035 + 0.35 * edge * edge * edge * edge * edge;
    const vec3 mirrored{2.0 * seen.z * seen.x, 2.0 * seen.z * seen.y, 2.0 * seen.z * seen.z - 1.0};
    const double box = smooth(0.45, 0.80, mirrored.y) +
                       0.5 * smooth(0.55, 0.90, std::fabs(mirrored.x)) * smooth(-0.5, 0.2, mirrored.y);
    static const vec3 half = normalised({-0.25, 0.72, 0.65});
    const double highlight = 0.10 * power_of_two((std::max)(0.0, dot(seen, half)), 5);
    out.gloss = (highlight + fresnel * box) * vec3{1.0, 0.99, 0.97};
    return out;
}

vec3 studio_backdrop(double height)
{
    static const unsigned char top[3] = {247, 248, 250}, bottom[3] = {222, 226, 231};
    return mix(to_linear(top), to_linear(bottom), smooth(0.0, 1.0, height));
}

}  // namespace text_to_mesh

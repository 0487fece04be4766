// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace text_to_mesh {

/// A point, a direction or a colour (linear light) of the picture.
struct vec3 {
    double x = 0.0, y = 0.0, z = 0.0;

    friend constexpr vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr vec3 operator*(double s, vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    /// Channel by channel.
    friend constexpr vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
};

constexpr double dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
constexpr vec3 mix(vec3 a, vec3 b, double t) { return a + t * (b - a); }
constexpr double clamp01(double x) { return x < 0.0 ? 0.0 : (x > 1.0 ? 1.0 : x); }
constexpr vec3 to_vec3(const float (&p)[3]) { return {double{p[0]}, double{p[1]}, double{p[2]}}; }

/// The vector itself where it has no length.
inline vec3 normalised(vec3 a)
{
    const double length = std::sqrt(dot(a, a));
    return length > 0.0 ? (1.0 / length) * a : a;
}

}  // namespace text_to_mesh

// SPDX-License-Identifier: MIT
#pragma once

#include "vec3.hpp"

namespace text_to_mesh {

/// A pinhole camera. Its own axes: x right, y up, z towards the viewer.
struct camera {
    vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
    vec3 eye;
    double pixels = 1.0;  ///< what one unit at distance one measures on the picture
    double centre_x = 0.0, centre_y = 0.0;

    struct projected {
        double x, y;     ///< in pixels from the picture's top left corner
        double inverse;  ///< 1 / distance along the view: greater is nearer, and linear across a flat triangle
    };

    /// A camera turned to the side and raised; angles in degrees, positive yaw shows the solid's right side, positive
    /// pitch its top.
    static camera turned(double yaw, double pitch)
    {
        constexpr double degree = 3.14159265358979323846 / 180.0;
        const double cy = std::cos(yaw * degree), sy = std::sin(yaw * degree);
        const double cp = std::cos(pitch * degree), sp = std::sin(pitch * degree);
        camera c;
        c.right = {cy, 0, -sy};
        c.back = {sy * cp, sp, cy * cp};
        c.up = cross(c.back, c.right);
        return c;
    }

    [[nodiscard]] vec3 in_camera_axes(vec3 v) const { return {dot(v, right), dot(v, up), dot(v, back)}; }

    [[nodiscard]] projected project(vec3 p) const
    {
        const vec3 q = in_camera_axes(p - eye);
        const double inverse = -1.0 / q.z;
        return {centre_x + q.x * pixels * inverse, centre_y - q.y * pixels * inverse, inverse};
    }

    /// The direction of view through a place of the picture; one unit of it is one unit of distance along the view.
    [[nodiscard]] vec3 ray(double x, double y) const
    {
        return ((x - centre_x) / pixels) * right + ((centre_y - y) / pixels) * up - back;
    }
};

}  // namespace text_to_mesh

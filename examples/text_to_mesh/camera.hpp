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
        double x, y;      ///< in pixels from the picture's top left corner
        double inverse;   ///< 1 / distance along the view: greater is nearer, and linear across a flat triangle
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

/// The smallest pyramid of view around some points, seen from one direction: as far away as they ask, and no farther.
///
/// A point (x, y, z) in the camera's axes is inside a pyramid of half width t (at distance one) from eye (ex, ey, ez)
/// when |x - ex| <= t (ez - z), which is linear in the eye: the four greatest values of +-x + t z and +-y + t z hold
/// all there is to know.
class view_fit {
public:
    view_fit(const camera& direction, double half_width, double half_height)
        : direction_(direction), width_(half_width), height_(half_height)
    {
    }

    void add(vec3 point)
    {
        const vec3 p = direction_.in_camera_axes(point);
        const double values[4] = {p.x + width_ * p.z, -p.x + width_ * p.z, p.y + height_ * p.z, -p.y + height_ * p.z};
        for (int i = 0; i < 4; ++i)
            if (empty_ || values[i] > most_[i]) most_[i] = values[i];
        if (empty_ || p.z > nearest_) nearest_ = p.z;
        empty_ = false;
    }

    [[nodiscard]] bool empty() const { return empty_; }

    /// The eye in the model's own axes.
    [[nodiscard]] vec3 eye() const
    {
        const double x = (most_[0] - most_[1]) / 2.0, y = (most_[2] - most_[3]) / 2.0;
        const double across = (most_[0] + most_[1]) / (2.0 * width_), upright = (most_[2] + most_[3]) / (2.0 * height_);
        double z = across > upright ? across : upright;
        const double size = z - nearest_;
        if (!(size > 1e-6)) z = nearest_ + 1e-6;  // a single point
        return x * direction_.right + y * direction_.up + z * direction_.back;
    }

private:
    camera direction_;
    double width_, height_;
    double most_[4] = {0, 0, 0, 0};
    double nearest_ = 0;
    bool empty_ = true;
};

}  // namespace text_to_mesh

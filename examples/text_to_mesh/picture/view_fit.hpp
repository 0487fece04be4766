// SPDX-License-Identifier: MIT
#pragma once

#include "camera.hpp"

namespace text_to_mesh {

/// The smallest pyramid of view around some points, seen from one direction: as far away as necessary, and no farther.
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

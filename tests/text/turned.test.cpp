// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/text/impl/turned.hpp>

#include <cmath>

using namespace typemesh;

TEST_CASE("a turned placement turns about its pen, and its axes stay at right angles", "[text][path]")
{
    for (const frame& axes : {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up})
        for (const double degrees : {0.0, 30.0, 90.0, 200.0, -179.0}) {
            const double angle = degrees * 0.017453292519943295;
            const point right{std::cos(angle), std::sin(angle)};
            placement flat;
            flat.frame = axes;
            flat.pen = {5000.0, -300.0};
            flat.unit_per_cell = 0x1p-10;
            placement at = flat;
            turn(at, right);
            CHECK(at.frame.is_orthonormal());
            CHECK(at.frame.mirrors() == axes.mirrors());
            if (degrees == 0.0) CHECK((at.pen == flat.pen && at.frame.right == axes.right && at.frame.up == axes.up));
            const auto off = [](vec3 a, vec3 b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); };
            CHECK(off(at.position(grid_point{0, 0}, 0.0f), flat.position(grid_point{0, 0}, 0.0f)) < 1e-6f);
            // A place beside the pen: the same as the turned place of the flat placement.
            const point cell{700.0, 200.0},
                image{right.x * cell.x - right.y * cell.y, right.y * cell.x + right.x * cell.y};
            CHECK(off(at.position(at.foot(cell), 0.25f), flat.position(flat.foot(image), 0.25f)) < 2e-6f);
            const box around = turned_box({{0.0, 0.0}, cell}, right);
            CHECK((around.low.x <= image.x && image.x <= around.high.x));
            CHECK((around.low.y <= image.y && image.y <= around.high.y));

            glyph_instance instance;
            turn(instance, right, axes);
            const vec3 p = flat.direction({0.3f, 0.7f, -0.2f}), q = at.direction({0.3f, 0.7f, -0.2f});
            const auto sum = [&](float x, float y, float z) { return p.x * x + p.y * y + p.z * z; };
            CHECK(off({sum(instance.x.x, instance.y.x, instance.z.x), sum(instance.x.y, instance.y.y, instance.z.y),
                       sum(instance.x.z, instance.y.z, instance.z.z)},
                      q) < 1e-6f);
        }
}

// SPDX-License-Identifier: MIT

#include <typemesh/vertex/frame.hpp>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The winding of the text's own counter-clockwise triangle once it is written, corners exchanged where the frame says so.
float written_winding(const frame& f)
{
    const vec3 a = f(0, 0, 0), b = f.turns_triangles() ? f(0, 1, 0) : f(1, 0, 0),
               c = f.turns_triangles() ? f(1, 0, 0) : f(0, 1, 0);
    const vec3 ab{b.x - a.x, b.y - a.y, b.z - a.z}, ac{c.x - a.x, c.y - a.y, c.z - a.z};
    return dot(cross(ab, ac), f.toward);
}

}  // namespace

TEST_CASE("triangles are written with the requested winding in every frame", "[vertex]")
{
    for (frame f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up})
        for (const int winding : {1, -1}) {
            f.winding = static_cast<std::int8_t>(winding);
            CHECK(written_winding(f) == static_cast<float>(winding));
        }
}

TEST_CASE("the named frames put text where their systems expect it", "[vertex]")
{
    CHECK(right_handed_y_up(1, 2, 3) == vec3{1, 2, 3});
    CHECK(left_handed_y_up(1, 2, 3) == vec3{1, 2, -3});
    CHECK(right_handed_z_up(1, 2, 3) == vec3{1, -3, 2});
    CHECK(left_handed_z_up(1, 2, 3) == vec3{-3, 1, 2});
    CHECK(dot(cross(right_handed_y_up.right, right_handed_y_up.up), right_handed_y_up.toward) == 1.0f);
    CHECK(dot(cross(right_handed_z_up.right, right_handed_z_up.up), right_handed_z_up.toward) == 1.0f);
    CHECK(dot(cross(left_handed_y_up.right, left_handed_y_up.up), left_handed_y_up.toward) == -1.0f);
    CHECK(dot(cross(left_handed_z_up.right, left_handed_z_up.up), left_handed_z_up.toward) == -1.0f);
}

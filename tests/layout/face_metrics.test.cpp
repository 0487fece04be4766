// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/face_metrics.hpp>

using namespace typemesh;

namespace {

struct silent_face {
    line_metrics metrics(direction) const noexcept { return {800.0, -200.0, 0.0}; }
};
struct one_face : silent_face {
    face_metrics suggested_metrics() const noexcept { return {.underline = {-0.3, 0.2}}; }
};
struct several_faces {
    face_metrics suggested_metrics(std::uint32_t face) const noexcept { return {.underline = {-0.1 * face, 0.2}}; }
    line_metrics metrics(direction) const noexcept { return {800.0, -200.0, 0.0}; }
    line_metrics metrics(direction, std::uint32_t face) const noexcept { return {100.0 * face, -200.0, 0.0}; }
};

}  // namespace

TEST_CASE("a font's own metrics are taken, by face, else some that suit most fonts", "[layout]")
{
    CHECK(face_metrics_of(silent_face{}, 0).underline.top < 0.0);
    CHECK(face_metrics_of(silent_face{}, 0).strike_through.top > 0.0);
    CHECK(face_metrics_of(silent_face{}, 0).superscript.rise > 0.0);
    CHECK(face_metrics_of(silent_face{}, 0).subscript.rise < 0.0);
    CHECK(face_metrics_of(one_face{}, 3).underline.top == -0.3);
    CHECK(face_metrics_of(several_faces{}, 3).underline.top == -0.1 * 3);

    silent_face silent;
    several_faces several;
    CHECK(line_metrics_of(silent, direction::automatic, 4).ascender == 800.0);
    CHECK(line_metrics_of(several, direction::automatic, 4).ascender == 400.0);
}

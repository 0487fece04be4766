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

/// An ideograph's column is an em wide; lines are higher than that.
struct narrow_columns {
    line_metrics column{500.0, -500.0, 0.0};
    line_metrics metrics(direction d) const noexcept
    {
        return d == direction::top_to_bottom ? column : line_metrics{1150.0, -290.0, 10.0};
    }
    line_metrics metrics(direction d, std::uint32_t face) const noexcept
    {
        return face == 0 || d == direction::top_to_bottom ? metrics(d) : line_metrics{900.0, -900.0, 0.0};
    }
    double column_middle() const noexcept { return 380.0; }
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

TEST_CASE("a column reaches as far as letters that lie on their side in it, a line as its metrics say", "[layout]")
{
    const auto is = [](const line_metrics& m, double ascender, double descender, double gap) {
        return m.ascender == ascender && m.descender == descender && m.gap == gap;
    };
    narrow_columns font;
    CHECK(is(line_reach_of(font, direction::automatic), 1150.0, -290.0, 10.0));
    CHECK(is(line_reach_of(font, direction::top_to_bottom), 1150.0 - 380.0, -290.0 - 380.0, 10.0));
    CHECK(is(line_reach_of(font, direction::top_to_bottom, 1), 900.0 - 380.0, -900.0 - 380.0, 0.0));
    font.column = {2000.0, -1000.0, 30.0};
    CHECK(is(line_reach_of(font, direction::top_to_bottom), 2000.0, -1000.0, 30.0));
    silent_face silent;  // with a middle of its own half-way between ascender and descender
    CHECK(is(line_reach_of(silent, direction::top_to_bottom), 800.0, -500.0, 0.0));
}

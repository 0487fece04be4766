// SPDX-License-Identifier: MIT

// What warped refuses.

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

/// A map that turns letters inside out.
struct mirroring {
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;

    [[nodiscard]] error refused_options() const noexcept { return {}; }
    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        return {{xx * p.x + xy * p.y, yx * p.x + yy * p.y}, {xx, yx}, {xy, yy}};
    }
    [[nodiscard]] bend_bounds bend(const box&) const noexcept { return {}; }
};

}  // namespace

TEST_CASE("outlines that fold, and more curves than allowed, are refused", "[bend][warp]")
{
    test::toy_font font;
    const box wide{{-2.0, 0.0}, {4.0, 0.0}};
    outline drawn, out;
    REQUIRE(record(font, 1, drawn));
    const drawn_place at{{}, 1e-3, wide};
    CHECK(warped{arc{.degrees = -350, .width = 1.0}}(drawn, at, 0.01, 1000, out).error() == error::folds_over);
    CHECK(warped{arch{.rise = 0.0, .baseline = 0.8, .width = 1.0}}(drawn, at, 0.01, 1000, out).error() ==
          error::folds_over);
    CHECK(warped{mirroring{.xx = -1.0}}(drawn, at, 0.01, 1000, out).error() == error::folds_over);
    CHECK(warped{arc{.degrees = 40}}(drawn, at, 0.01, 7, out).error() == error::too_many_points);
    REQUIRE(warped{arc{.degrees = 40}}(drawn, at, 0.01, 8, out));
    CHECK(warped{arc{.degrees = 40}}.refused({{0.0, 0.0}, {9.0, 0.0}}) == error::none);
    CHECK(warped{arc{.degrees = 40, .width = 1.0}}.refused({{0.0, 0.0}, {9.1, 0.0}}) == error::goes_around);
    CHECK(warped{arc{.degrees = 40, .width = 1.0}}.refused({{0.0, 0.0}, {9.0, 0.0}}) == error::none);
    CHECK(warped{arc{.degrees = -361}}.refused(wide) == error::goes_around);
}

namespace {

/// Two affine halves that meet at x = 0, where the derivative jumps.
struct hinged {
    double before = 1.0, after = 1.0;

    [[nodiscard]] error refused_options() const noexcept { return {}; }
    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        const double factor = p.x < 0.0 ? before : after;
        return {{factor * p.x, p.y}, {factor, 0.0}, {0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box& b) const noexcept
    {
        return {.x_jump = b.low.x < 0.0 && b.high.x > 0.0 ? std::fabs(after - before) : 0.0};
    }
};

}  // namespace

TEST_CASE("a jump of a warp's derivative counts for its proofs", "[bend][warp]")
{
    test::toy_font font;
    outline drawn, out;
    REQUIRE(record(font, 1, drawn));  // from x = 100 to 500
    const drawn_place across{{-0.3, 0.0}, 1e-3, {{-1.0, 0.0}, {1.0, 1.0}}};
    CHECK(warped{hinged{1.0, -0.5}}(drawn, across, 0.01, 1000, out).error() == error::folds_over);
    const auto left = warped{hinged{1.0, 1.5}}(drawn, across, 0.01, 1000, out);
    REQUIRE(left);
    CHECK(*left < 0.01);  // it is not exact
    CHECK(out.curves.size() > drawn.curves.size());
}

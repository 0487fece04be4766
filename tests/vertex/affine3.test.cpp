// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/vertex/affine3.hpp>

using namespace typemesh;

namespace {

void check_close(vec3 is, vec3 wanted)
{
    CHECK(is.x == Catch::Approx(wanted.x).margin(1e-6));
    CHECK(is.y == Catch::Approx(wanted.y).margin(1e-6));
    CHECK(is.z == Catch::Approx(wanted.z).margin(1e-6));
}

}  // namespace

TEST_CASE("a turn is counter-clockwise around its axis and keeps lengths", "[vertex]")
{
    constexpr double quarter = 1.5707963267948966;
    check_close(turned({0, 0, 1}, quarter)({1, 2, 3}), {-2, 1, 3});
    check_close(turned({1, 0, 0}, quarter)({1, 2, 3}), {1, -3, 2});
    check_close(turned({0, 1, 0}, quarter)({1, 2, 3}), {3, 2, -1});
    const affine3 askew = turned({0.6f, 0.0f, 0.8f}, 0.7);
    check_close(askew({0.6f, 0.0f, 0.8f}), {0.6f, 0.0f, 0.8f});
    const vec3 image = askew({1, 2, 3});
    CHECK(double(image.x) * image.x + double(image.y) * image.y + double(image.z) * image.z ==
          Catch::Approx(14.0).epsilon(1e-6));
}

TEST_CASE("a product of maps applies the right one first", "[vertex]")
{
    const affine3 turn = turned({0, 0, 1}, 0.5), move = shifted({1, 2, 3});
    const vec3 p{4, -5, 6};
    check_close((turn * move)(p), turn(move(p)));
    check_close((move * turn)(p), move(turn(p)));
    CHECK((move * shifted({-1, -2, -3}))(p) == p);
    CHECK(turn * affine3{} == turn);
}

TEST_CASE("a map about a place leaves the place where it is, apart from its own shift", "[vertex]")
{
    const vec3 pivot{7, -8, 9};
    check_close(turned({0, 1, 0}, 2.0).about(pivot)(pivot), pivot);
    CHECK(scaled(0.0f).about(pivot)({1, 2, 3}) == pivot);
    check_close((shifted({1, 0, 0}) * scaled(3.0f)).about(pivot)(pivot), {8, -8, 9});
    CHECK(scaled(2.0f).about(pivot).direction({1, 2, 3}) == vec3{2, 4, 6});
}

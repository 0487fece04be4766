// SPDX-License-Identifier: MIT

#include <typemesh/bend/impl/uniform_spline.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <vector>

using namespace typemesh;
using typemesh::detail::chord_spline;
using typemesh::detail::spline_value;
using typemesh::detail::uniform_spline;

namespace {

/// A spline through the values of a function with a second derivative of 0 at both ends.
uniform_spline spline_of_sine(std::size_t pieces, double length)
{
    uniform_spline s;
    double3* const values = s.begin(pieces, length);
    REQUIRE(values != nullptr);
    for (std::size_t i = 0; i <= pieces; ++i) {
        const double x = length * static_cast<double>(i) / static_cast<double>(pieces);
        values[i] = {x, std::sin(x), 2.0 * x - 1.0};
    }
    REQUIRE(s.fit());
    return s;
}

}  // namespace

TEST_CASE("a spline goes through its values and has two continuous derivatives", "[bend][uniform_spline]")
{
    const double length_of = 6.283185307179586;
    const uniform_spline s = spline_of_sine(16, length_of);
    for (std::size_t i = 1; i < 16; ++i) {
        const double x = s.step() * static_cast<double>(i);
        CHECK(length(s.at_knot(i).at - double3{x, std::sin(x), 2.0 * x - 1.0}) < 1e-12);
        const spline_value before = s.at(x - 1e-9), after = s.at(x + 1e-9);
        CHECK(length(before.at - after.at) < 1e-8);
        CHECK(length(before.first - after.first) < 1e-8);
        CHECK(length(before.second - after.second) < 1e-7);
    }
    CHECK(length(s.at_knot(0).second) < 1e-12);
    CHECK(length(s.at_knot(16).second) < 1e-12);
}

TEST_CASE("a spline's derivatives are those of its values, and a straight line is one", "[bend][uniform_spline]")
{
    const uniform_spline s = spline_of_sine(40, 3.141592653589793);
    for (double x = 0.05; x < 3.1; x += 0.0317) {
        const spline_value v = s.at(x);
        CHECK(length((0.5 / 1e-5) * (s.at(x + 1e-5).at - s.at(x - 1e-5).at) - v.first) < 1e-6);
        CHECK(std::abs(v.at.y - std::sin(x)) < 1e-5);
        CHECK(std::abs(v.first.y - std::cos(x)) < 1e-3);
        CHECK(std::abs(v.at.z - (2.0 * x - 1.0)) < 1e-12);
        CHECK(std::abs(v.second.x) < 1e-9);
        CHECK(length(s.third(s.piece_at(x)) - (1.0 / s.step()) * (s.at_knot(s.piece_at(x) + 1).second -
                                                                  s.at_knot(s.piece_at(x)).second)) < 1e-9);
    }
    CHECK(s.piece_at(-1.0) == 0);
    CHECK(s.piece_at(100.0) == 39);
}

TEST_CASE("a walk along a spline makes equal steps", "[bend][uniform_spline]")
{
    const std::vector<double3> points{{0, 0, 0}, {1, 2, 0}, {4, 2, 1}, {5, 0, 0}, {9, 0, 0}};
    chord_spline s;
    double at = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) at += length(points[i] - points[i - 1]);
        REQUIRE(s.knots().push_back(at));
    }
    REQUIRE(s.fit(points));
    CHECK(s.arc_length() > at);
    std::vector<double3> out(2001);
    s.walk(2000, out.data());
    CHECK(length(out.front() - points.front()) < 1e-12);
    CHECK(length(out.back() - points.back()) < 1e-12);
    const double step = s.arc_length() / 2000.0;
    for (std::size_t i = 0; i + 1 < out.size(); ++i)
        CHECK(length(out[i + 1] - out[i]) == Catch::Approx(step).epsilon(1e-3));
}

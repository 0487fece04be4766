// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/moving_point.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>
#include <cstdint>

using namespace typemesh;
using detail::crossing_speed;
using detail::fixed_vector;
using detail::moving_line;
using detail::unit_along;
using detail::unit_one;

namespace {

/// Vectors of all sizes below 2^32, some along an axis.
fixed_vector roll_vector(test::dice& d)
{
    const int less = 31 + d.roll(32);
    const fixed_vector v{static_cast<std::int64_t>(d.bits()) >> less, static_cast<std::int64_t>(d.bits()) >> less};
    if (v.x == 0 && v.y == 0) return {1, 0};
    return d.roll(16) == 0 ? fixed_vector{v.x, 0} : v;
}
moving_line towards(double angle)
{
    return {unit_along({std::llround(0x1p31 * std::cos(angle)), std::llround(0x1p31 * std::sin(angle))})};
}
fixed_vector roll_direction(test::dice& d) { return towards(test::turn_once * d.fraction()).along; }

struct real_vector {
    long double x, y;
};
real_vector real(fixed_vector v, long double unit)
{
    return {static_cast<long double>(v.x) * unit, static_cast<long double>(v.y) * unit};
}
bool equal(fixed_vector a, fixed_vector b) { return a.x == b.x && a.y == b.y; }

/// The distance of v * inward from 1.
double error_of(const crossing_speed& v, const moving_line& line)
{
    constexpr detail::int128 unit = static_cast<detail::int128>(1) << 62;
    return std::fabs(static_cast<double>(detail::dot(v.of, line.inward()) - unit) * 0x1p-62);
}

}  // namespace

TEST_CASE("unit_along() has the length 1 and the direction of its vector", "[offset][moving_point]")
{
    test::dice d{1};
    for (int i = 0; i < 100'000; ++i) {
        fixed_vector v = roll_vector(d);
        if (v.x == 0 && v.y == 0) v.y = 1;
        const real_vector unit = real(unit_along(v), 0x1p-30L), to = real(v, 1.0L);
        const long double off = std::hypot(to.x, to.y);
        CHECK_QUICKLY(std::fabs(std::hypot(unit.x, unit.y) - 1.0L) < 0x1p-29L);
        CHECK_QUICKLY(std::fabs(unit.x * to.y - unit.y * to.x) < 0x1p-30L * off && unit.x * to.x + unit.y * to.y > 0);
    }
}

TEST_CASE("unit_along() turns and mirrors with its vector", "[offset][moving_point]")
{
    test::dice d{2};
    for (int i = 0; i < 10'000; ++i) {
        fixed_vector v = roll_vector(d);
        if (v.x == 0 && v.y == 0) v.y = 1;
        const fixed_vector unit = unit_along(v);
        CHECK_QUICKLY(equal(unit_along({-v.y, v.x}), {-unit.y, unit.x}) &&
                      equal(unit_along({-v.x, v.y}), {-unit.x, unit.y}));
    }
    for (const std::int64_t size : {std::int64_t{1}, std::int64_t{3}, (std::int64_t{1} << 32) - 1})
        CHECK(equal(unit_along({size, 0}), {unit_one, 0}));
    CHECK(equal(unit_along({3, 4}), {unit_one * 3 / 5, unit_one * 4 / 5}));
}

TEST_CASE("the common point of two moving lines stays on both, at any angle", "[offset][moving_point]")
{
    test::dice d{3};
    int wide = 0, narrow = 0, instant = 0;
    for (int i = 0; i < 200'000; ++i) {
        const double angle = test::turn_once * d.fraction();
        const double needle = test::turn_once / 2 - std::ldexp(d.fraction(), -d.roll(24));
        const double turn = i % 2 == 0 ? test::turn_once * d.fraction() : i % 4 == 1 ? needle : -needle;
        const moving_line before = towards(angle), after = towards(angle + turn);
        const crossing_speed v = detail::speed_of(before, after, false);
        if (v.instant) {
            CHECK_QUICKLY(std::fabs(std::sin(turn)) < 0x1.01p-20 && std::cos(turn) < 0.0);
            ++instant;
            continue;
        }
        // Below a right angle the error of a unit vector's length counts; above it cancels.
        const bool sharp = detail::dot(before.along, after.along) < 0;
        const double allowed = sharp ? 0x1p-32 : 0x1p-28;
        const bool on_both = error_of(v, before) < allowed && error_of(v, after) < allowed;
        if (!on_both) {
            CAPTURE(turn, error_of(v, before), error_of(v, after));
            CHECK(on_both);
        }
        ++(sharp ? narrow : wide);
    }
    CHECK(wide > 1000);
    CHECK(narrow > 1000);
    CHECK(instant > 1000);
}

TEST_CASE("two formulas for a corner's speed agree", "[offset][moving_point]")
{
    test::dice d{4};
    for (int i = 0; i < 100'000; ++i) {
        const double angle = test::turn_once * d.fraction(),
                     turn = (d.roll(2) == 0 ? 1 : -1) * (0.1 + 2.9 * d.fraction());
        const moving_line before = towards(angle), after = towards(angle + turn);
        const crossing_speed v = detail::speed_of(before, after, false);
        REQUIRE(!v.instant);
        const real_vector a = real(before.along, 0x1p-30L), b = real(after.along, 0x1p-30L);
        const long double cosine = a.x * b.x + a.y * b.y, sine = a.x * b.y - a.y * b.x;
        const real_vector other = cosine < 0 ? real_vector{-(a.y + b.y) / (1 + cosine), (a.x + b.x) / (1 + cosine)}
                                             : real_vector{(b.x - a.x) / sine, (b.y - a.y) / sine};
        const real_vector found = real(v.of, 0x1p-32L);
        const long double gap = std::hypot(found.x - other.x, found.y - other.y);
        const long double size = std::hypot(other.x, other.y),
                          grown = cosine < 0 ? size * size * size : 1 / std::fabs(sine);
        const bool agree = gap < 0x1p-28L * grown;
        if (!agree) {
            CAPTURE(turn, gap, grown);
            CHECK(agree);
        }
    }
}

TEST_CASE("a corner's movement turns and mirrors with the corner", "[offset][moving_point]")
{
    test::dice d{5};
    for (int i = 0; i < 100'000; ++i) {
        const moving_line before{roll_direction(d)}, after{i % 8 == 0 ? before.along : roll_direction(d)};
        const bool born = d.roll(2) == 0;
        const crossing_speed v = detail::speed_of(before, after, born);
        const auto mirrored = [](const moving_line& l) { return moving_line{{l.along.x, -l.along.y}}; };
        const auto turned = [](const moving_line& l) { return moving_line{l.inward()}; };
        const crossing_speed m = detail::speed_of(mirrored(after), mirrored(before), born),
                             t = detail::speed_of(turned(before), turned(after), born);
        CHECK_QUICKLY(v.instant == m.instant && v.instant == t.instant && equal(m.of, {-v.of.x, v.of.y}) &&
                      equal(t.of, {-v.of.y, v.of.x}));
    }
}

TEST_CASE("only half turns are instant, and near half turns to the right at new corners", "[offset][moving_point]")
{
    const double half = test::turn_once / 2;
    const auto is_instant = [](double turn, bool born) {
        return detail::speed_of(towards(0.3), towards(0.3 + turn), born).instant;
    };
    for (const bool born : {false, true}) {
        CHECK(is_instant(half, born));
        CHECK(is_instant(half - 1e-7, born));
        CHECK(is_instant(half + 1e-7, born));
        CHECK_FALSE(is_instant(0.0, born));
        CHECK_FALSE(is_instant(half / 2, born));
        CHECK_FALSE(is_instant(-half / 2, born));
        CHECK_FALSE(is_instant(half - 1e-5, born));  // a left turn: the corner of a needle of the outline
        CHECK_FALSE(is_instant(0.1 - half, born));
        CHECK(is_instant(0.001 - half, born) == born);
        CHECK(is_instant(0.04 - half, born) == born);
    }
    CHECK(detail::turns_left(towards(0.0), towards(3.0)));
    CHECK_FALSE(detail::turns_left(towards(0.0), towards(-3.0)));
    CHECK_FALSE(detail::turns_left(towards(1.0), towards(1.0)));
}

TEST_CASE("a moving point starts at its place and moves by speed times time, rounded down", "[offset][moving_point]")
{
    test::dice d{6};
    for (int i = 0; i < 100'000; ++i) {
        const auto roll = [&](int bits) { return static_cast<std::int64_t>(d.bits()) >> (64 - bits); };
        const detail::moving_point p{{roll(45), roll(45)}, roll(50), {{roll(40), roll(40)}, false}};
        CHECK_QUICKLY(equal(p.place(p.since), p.start));
        const std::int64_t passed = roll(50);
        const fixed_vector way = p.place(p.since + passed) - p.start;
        const real_vector speed = real(p.speed.of, 0x1p-48L);
        const long double x = speed.x * static_cast<long double>(passed) - static_cast<long double>(way.x),
                          y = speed.y * static_cast<long double>(passed) - static_cast<long double>(way.y);
        CHECK_QUICKLY(-0x1p-10L < x && x < 1.0L + 0x1p-10L && -0x1p-10L < y && y < 1.0L + 0x1p-10L);
    }
    const detail::moving_point p{{0, 0}, 5 * detail::time_one, {{detail::time_one, -2 * detail::time_one}, false}};
    CHECK(equal(p.place(8 * detail::time_one), {3 * detail::place_one, -6 * detail::place_one}));
}

TEST_CASE("nearest_cell() of a cell's place is that cell, up to half a cell away", "[offset][moving_point]")
{
    constexpr std::int64_t half = detail::place_one / 2;
    for (const grid_point p : {grid_point{0, 0}, {-1, 1}, {1 << 28, -(1 << 28)}, {-12345, 54321}}) {
        const fixed_vector at = detail::place_of(p);
        CHECK(detail::nearest_cell(at) == p);
        CHECK(detail::nearest_cell({at.x - half, at.y + half - 1}) == p);
        CHECK(detail::nearest_cell({at.x - half - 1, at.y + half}) == grid_point{p.x - 1, p.y + 1});
    }
    CHECK(equal(detail::middle({-3, 4}, {5, -8}), {1, -2}));
}

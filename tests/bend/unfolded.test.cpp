// SPDX-License-Identifier: MIT

#include <typemesh/bend/unfolded.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// A fold of one's own: x becomes x + a x^2 / 2, so the determinant is 1 + a x, which is 0 at x = -1 / a.
struct creased_paper {
    double a = 1.0;
    double lift = 0.0;  ///< added to the determinant everywhere

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        return {{(1.0 + lift) * p.x + 0.5 * a * p.x * p.x, p.y, p.z},
                {1.0 + lift + a * p.x, 0.0, 0.0},
                {0.0, 1.0, 0.0},
                {0.0, 0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept { return {.xx = std::fabs(a)}; }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

/// x^3 / 3 + lift x: the determinant is x^2 + lift, so it only touches 0 if lift is 0.
struct flat_spot {
    double lift = 0.0;

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        return {{p.x * p.x * p.x / 3.0 + lift * p.x, p.y, p.z},
                {p.x * p.x + lift, 0.0, 0.0},
                {0.0, 1.0, 0.0},
                {0.0, 0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        return {.xx = 2.0 * (std::max)(std::fabs(b.low.x), std::fabs(b.high.x))};
    }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

/// Numbers that are none.
struct broken_map {
    bool in_bounds = false;

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        return {p, {1.0, 0.0, 0.0}, {0.0, in_bounds ? 1.0 : std::nan(""), 0.0}, {0.0, 0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept { return {.yz = in_bounds ? std::nan("") : 0.0}; }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

/// Changes nothing, but claims that it bends; counts its calls.
struct cautious_paper {
    double claimed = 0.0;
    int* calls = nullptr;

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        ++*calls;
        return {p, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept { return {.xx = claimed, .yy = claimed}; }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

template <deformation D>
double least_determinant(const D& d, const box3& b, int n = 12)
{
    double least = HUGE_VAL;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            for (int k = 0; k <= n; ++k) {
                const auto at = [&](double low, double high, int of) { return low + (high - low) * of / n; };
                least = (std::min)(least, bending::determinant(d({at(b.low.x, b.high.x, i), at(b.low.y, b.high.y, j),
                                                                  at(b.low.z, b.high.z, k)})));
            }
    return least;
}

}  // namespace

TEST_CASE("no determinant in a box is below the bound", "[bend]")
{
    test::dice dice{41};
    bending::each_ready([&](const auto& d, const box3& all) {
        for (int round = 0; round < 40; ++round) {
            const box3 b = bending::box_within(dice, all, 1e-3, round % 2 == 0 ? 1.0 : 0.1);
            const auto bound = detail::bound_determinant(d, b);
            CHECK_QUICKLY(bound.middle == Approx(bending::determinant(d(0.5 * (b.low + b.high)))).margin(1e-12));
            for (int k = 0; k < 20; ++k)
                CHECK_QUICKLY(bending::determinant(d(bending::within(dice, b))) >= bound.lowest - 1e-12);
            // Where any cut helps, the one along the axis that is named does.
            double best = -HUGE_VAL, named = -HUGE_VAL;
            for (int axis = 0; axis < 3; ++axis) {
                const double3 quarter = bending::step_along(axis, 0.25), size = b.high - b.low;
                const double3 off{quarter.x * size.x, quarter.y * size.y, quarter.z * size.z};
                const double3 middle = 0.5 * (b.low + b.high);
                const double3 half{size.x * (axis == 0 ? 0.25 : 0.5), size.y * (axis == 1 ? 0.25 : 0.5),
                                   size.z * (axis == 2 ? 0.25 : 0.5)};
                const double lowest =
                    (std::min)(detail::bound_determinant(d, {middle - off - half, middle - off + half}).lowest,
                               detail::bound_determinant(d, {middle + off - half, middle + off + half}).lowest);
                best = (std::max)(best, lowest);
                if (axis == bound.cut_axis) named = lowest;
            }
            if (bound.lowest < bound.middle - 1e-6 && best > bound.lowest) CHECK_QUICKLY(named > bound.lowest);
        }
    });
}

TEST_CASE("what is called unfolded has a positive determinant everywhere", "[bend]")
{
    test::dice dice{42};
    std::size_t unfolded = 0, folded = 0, unproven = 0;
    const auto compare = [&](const auto& d, const box3& b) {
        const double least = least_determinant(d, b);
        const bool proven = is_unfolded(d, b);
        CHECK_QUICKLY(!proven || least > 0.0);
        ++(proven ? unfolded : least > 0.01 ? unproven : folded);  // a square may touch 0 between the samples
    };
    bending::each_ready([&](const auto& d, const box3& all) {
        for (int round = 0; round < 6; ++round) {
            box3 b = bending::box_within(dice, all, 0.05, 0.5);
            if (round % 2 == 0) b.low.z *= 2.0;  // some are deeper than radii
            compare(d, b);
        }
    });
    for (int round = 0; round < 100; ++round) {
        const box3 b = bending::box_within(dice, {{-2.0, -1.0, -1.0}, {2.0, 1.0, 1.0}}, 0.05, 0.7);
        compare(creased_paper{.a = bending::within(dice, -1.0, 1.0)}, b);
        compare(flat_spot{.lift = dice.roll(2) == 0 ? 0.0 : 0.1}, b);
    }
    CAPTURE(unfolded, folded, unproven);
    CHECK(unfolded > 200);
    CHECK(folded > 40);
    CHECK(unproven * 20 < unfolded);
}

TEST_CASE("letters on cups and balls, in waves and twists, are proven to be unfolded", "[bend]")
{
    const box3 letter{{-0.1, -0.25, -0.2}, {0.9, 0.8, 0.0}};
    for (const text_axis axis : {text_axis::up, text_axis::along}) {
        for (const double radius : {0.25, 0.5, 2.0, 100.0, -0.5, -2.0})
            CHECK(is_unfolded(on_cylinder{.radius = radius, .axis = axis}, letter));
        for (const double turn : {20.0, 90.0, -360.0})
            CHECK(is_unfolded(twist{.degrees_per_em = turn, .axis = axis, .across = 0.35}, letter));
        for (const double growth : {-0.1, 0.3, -0.9}) CHECK(is_unfolded(taper{.growth = growth, .axis = axis}, letter));
    }
    for (const double radius : {0.6, 1.0, 3.0, -0.6, -3.0}) CHECK(is_unfolded(on_sphere{.radius = radius}, letter));
    for (const double height : {0.1, 0.5, 1.0})
        for (const double size : {2.0, 0.5, 0.2})
            for (const double direction : {0.0, 45.0, 90.0}) {
                CAPTURE(height, size, direction);
                CHECK(is_unfolded(displaced<wave>{{.height = height, .length = size, .direction = direction}}, letter));
            }
    // Seventy such letters in one box, on a cylinder that they go around once.
    CHECK(is_unfolded(on_cylinder{.radius = 11.0}, {{-35.0, -0.25, -0.2}, {35.0, 0.8, 0.0}}));
}

TEST_CASE("folds are seen: a cylinder's axis, a sphere's pole, a taper's end and a fold of one's own", "[bend]")
{
    const auto letter = [](double depth) { return box3{{-0.1, -0.25, -depth}, {0.9, 0.8, 0.0}}; };
    for (const double radius : {0.3, 1.0}) {
        CHECK(is_unfolded(on_cylinder{.radius = radius}, letter(0.99 * radius)));
        CHECK_FALSE(is_unfolded(on_cylinder{.radius = radius}, letter(radius)));
        CHECK_FALSE(is_unfolded(on_cylinder{.radius = radius}, letter(1.01 * radius)));
        CHECK(is_unfolded(on_cylinder{.radius = -radius}, letter(5.0 * radius)));  // in a room, walls are endless
        const box3 raised{{0.0, 0.0, 0.0}, {0.1, 0.1, 1.01 * radius}};
        CHECK_FALSE(is_unfolded(on_cylinder{.radius = -radius}, raised));
    }
    const double pole = 0.25 * test::turn_once;
    for (const double radius : {1.0, -1.0}) {
        CHECK(is_unfolded(on_sphere{.radius = radius}, {{0.0, -0.9 * pole, -0.1}, {1.0, 0.9 * pole, 0.0}}));
        CHECK_FALSE(is_unfolded(on_sphere{.radius = radius}, {{0.0, 0.0, -0.1}, {1.0, 1.0001 * pole, 0.0}}));
        CHECK_FALSE(is_unfolded(on_sphere{.radius = radius}, {{0.0, -1.0001 * pole, 0.0}, {1.0, 0.0, 0.0}}));
    }
    // Its determinant is positive again beyond the centre, so the middle of the box alone would not say it.
    CHECK_FALSE(is_unfolded(on_sphere{.radius = 1.0}, {{0.0, 0.0, -9.0}, {0.1, 0.1, 0.0}}));
    CHECK(is_unfolded(taper{.growth = -1.0}, {{0.0, 0.0, 0.0}, {0.99, 1.0, 0.1}}));
    CHECK_FALSE(is_unfolded(taper{.growth = -1.0}, {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.1}}));
    CHECK_FALSE(is_unfolded(taper{.growth = -1.0}, {{0.0, 0.0, 0.0}, {3.0, 1.0, 0.1}}));  // likewise
    for (const double a : {1.0, -3.0, 0.01}) {
        const creased_paper d{.a = a};
        const double fold = -1.0 / a, low = (std::min)(fold, 0.0), high = (std::max)(fold, 0.0);
        CHECK_FALSE(is_unfolded(d, {{low, 0.0, 0.0}, {high, 1.0, 1.0}}));  // the fold is the end of the box
        CHECK_FALSE(is_unfolded(d, {{low - 1e-6, 0.0, 0.0}, {high + 1e-6, 1.0, 1.0}}));
        CHECK(is_unfolded(d, {{0.999 * low, 0.0, 0.0}, {0.999 * high, 1.0, 1.0}}));
    }
}

TEST_CASE("determinants of 0 or almost 0 are never proven to be positive", "[bend]")
{
    // Ends of boxes on and a little beyond folds, at places where no coordinate is round.
    test::dice dice{43};
    for (int round = 0; round < 400; ++round) {
        const double a = bending::within(dice, 0.1, 3.0), fold = -1.0 / a, past = std::ldexp(1.0, -30 - dice.roll(20)),
                     end = round % 2 == 0 ? fold : fold - past, high = fold + bending::within(dice, 0.1, 3.0);
        CHECK_QUICKLY(!is_unfolded(creased_paper{.a = a}, {{end, 0.0, 0.0}, {high, 0.0, 0.0}}));
        const double radius = bending::within(dice, 0.1, 3.0);
        CHECK_QUICKLY(!is_unfolded(on_cylinder{.radius = radius},
                                   {{0.0, 0.0, round % 2 == 0 ? -radius : -radius - past}, {0.0, 0.5, 0.0}}));
        CHECK_QUICKLY(
            !is_unfolded(taper{.growth = -a}, {{0.0, 0.0, 0.0}, {1.0 / a + (round % 2 == 0 ? 0.0 : past), 0.1, 0.0}}));
    }
    CHECK_FALSE(is_unfolded(flat_spot{}, {{-1.0, 0.0, 0.0}, {0.7, 1.0, 1.0}}));
    CHECK_FALSE(is_unfolded(flat_spot{}, {{0.0, 0.0, 0.0}, {0.7, 1.0, 1.0}}));
    CHECK_FALSE(is_unfolded(flat_spot{}, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}));
    CHECK(is_unfolded(flat_spot{.lift = 1e-3}, {{-1.0, 0.0, 0.0}, {0.7, 1.0, 1.0}}));
    CHECK_FALSE(
        is_unfolded(creased_paper{.lift = -2.0}, {{-0.1, 0.0, 0.0}, {0.1, 1.0, 1.0}}));  // inside out everywhere
}

TEST_CASE("a proof ends after 4096 pieces, whatever it finds in the last one", "[bend]")
{
    int ended = 0;
    for (double claimed = 0.5; claimed < 400.0; claimed *= 1.3) {
        int calls = 0;
        const bool proven = is_unfolded(cautious_paper{.claimed = claimed, .calls = &calls}, {{0, 0, 0}, {1, 1, 0}});
        CAPTURE(claimed, calls);
        CHECK(calls <= 4097 + 48);  // the pieces that wait may still be proven
        CHECK((proven || calls > 4096));
        ended += !proven;
    }
    CHECK(ended > 4);
    CHECK(ended < 20);
}

TEST_CASE("numbers that are none prove nothing", "[bend]")
{
    const box3 b{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.1}};
    CHECK_FALSE(is_unfolded(broken_map{}, b));
    CHECK_FALSE(is_unfolded(broken_map{.in_bounds = true}, b));
    CHECK_FALSE(is_unfolded(displaced<wave>{{.height = 1e300, .length = 1e-5}}, b));
    CHECK_FALSE(is_unfolded(taper{}, {{0.0, 0.0, 0.0}, {std::nan(""), 1.0, 0.0}}));
    CHECK_FALSE(is_unfolded(on_cylinder{}, {{0.0, 0.0, -HUGE_VAL}, {1.0, 1.0, 0.0}}));
}

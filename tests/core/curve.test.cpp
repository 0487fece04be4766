// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/box.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/finite.hpp>

#include <limits>

using namespace typemesh;

TEST_CASE("curves run from their first point to their last, exactly", "[core][curve]")
{
    const point a{0.1, 0.2}, b{1e6, -3.7}, c{-7.3, 1e-9}, d{12.25, 99.5};
    for (const curve& k : {curve::from(a, b), curve::from(quadratic{a, b, c}), curve::from(cubic{a, b, c, d})}) {
        CHECK(k.at(0.0) == k.start());
        CHECK(k.at(1.0) == k.end());
        CHECK(k.start() == a);
    }
}

TEST_CASE("a quadratic raised to a cubic is the same curve", "[core][curve]")
{
    const quadratic q{{0, 0}, {300, 900}, {1000, -200}};
    const cubic c = raised(q);
    for (int i = 0; i <= 100; ++i) CHECK(length(q.at(i / 100.0) - c.at(i / 100.0)) < 1e-9);
}

TEST_CASE("a box is empty until a point comes, and then holds all of them tightly", "[core][box]")
{
    box b;
    CHECK(b.empty());
    CHECK(b.width() == 0.0);
    b.merge(box{});
    CHECK(b.empty());
    b.add(point{2, 3});
    CHECK(!b.empty());
    CHECK(b.width() == 0.0);
    b.add(point{-1, 5});
    box other;
    other.add(point{0, -4});
    b.merge(other);
    CHECK(b.low == point{-1, -4});
    CHECK(b.high == point{2, 5});
    CHECK(b.height() == 9.0);
}

TEST_CASE("only NaN and the infinities are not finite", "[core][finite]")
{
    using limits = std::numeric_limits<double>;
    for (const double v : {0.0, -0.0, 1.0, limits::denorm_min(), (limits::max)(), limits::lowest()})
        CHECK(is_finite(v));
    volatile double zero = 0.0;
    for (const double v : {limits::infinity(), -limits::infinity(), limits::quiet_NaN(), -limits::quiet_NaN(),
                           limits::signaling_NaN(), 1.0 / zero, zero / zero})
        CHECK(!is_finite(v));
}

TEST_CASE("non-zero fills all that is wound round, even-odd every second time", "[core][fill_rule]")
{
    for (std::int32_t w = -5; w <= 5; ++w) {
        CHECK(is_filled(fill_rule::non_zero, w) == (w != 0));
        CHECK(is_filled(fill_rule::even_odd, w) == (w % 2 != 0));
    }
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/curve.hpp>

using namespace typemesh;

TEST_CASE("a curve runs from its first point to its last, exactly", "[core][curve]")
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

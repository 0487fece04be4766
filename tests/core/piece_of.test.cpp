// SPDX-License-Identifier: MIT

#include <typemesh/core/impl/piece_of.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a piece of a curve runs along it, from the one parameter to the other", "[core]")
{
    const curve all[] = {curve::from({1, 2}, {7, -3}), curve::from(quadratic{{0, 0}, {5, 9}, {10, 1}}),
                         curve::from(cubic{{0, 0}, {9, 1}, {-4, 7}, {6, 6}})};
    for (const curve& c : all)
        for (const double from : {0.0, 0.2, 0.9, 1.0})
            for (const double to : {0.0, 0.4, 1.0}) {
                const curve piece = detail::piece_of(c, from, to);
                CHECK(piece.degree == c.degree);
                for (int k = 0; k <= 8; ++k) {
                    const double u = k / 8.0;
                    CHECK(length(piece.at(u) - c.at(from + (to - from) * u)) < 1e-12);
                }
            }
}

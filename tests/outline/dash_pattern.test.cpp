// SPDX-License-Identifier: MIT

#include <typemesh/outline/impl/dash_pattern.hpp>

#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("lengths of curves are those of fine chords", "[outline][stroke]")
{
    const curve all[] = {curve::from({1, 2}, {7, -3}), curve::from(quadratic{{0, 0}, {5, 9}, {10, 1}}),
                         curve::from(cubic{{0, 0}, {9, 1}, {-4, 7}, {6, 6}})};
    for (const curve& c : all) {
        double sum = 0.0;
        constexpr int n = 20000;
        for (int i = 0; i < n; ++i) sum += length(c.at(0.1 + 0.8 * (i + 1) / n) - c.at(0.1 + 0.8 * i / n));
        CHECK(detail::length_between(c, 0.1, 0.9) == Approx(sum).epsilon(1e-5));
    }
}

TEST_CASE("dashes and gaps add up to the path", "[outline][stroke]")
{
    const curve path[] = {curve::from({0, 0}, {30, 0}), curve::from(quadratic{{30, 0}, {45, 0}, {45, 20}}),
                          curve::from({45, 20}, {45, 61})};
    double all = 0.0;
    for (const curve& c : path) all += detail::length_between(c, 0.0, 1.0);
    const double lengths[] = {0.7, 0.3, 0.2, 0.1};
    for (const double offset : {0.0, 0.5, 0.75, -2.1}) {
        detail::dash_pattern pattern{lengths, offset, 10.0};
        CHECK(pattern.has_gaps());
        CHECK(pattern.is_possible(path));
        double on = 0.0;
        int dashes = 0, whole = 0;
        pattern.each_dash(path, [&](const detail::stretch& dash) noexcept {
            double own = 0.0;
            for (std::size_t i = 0; i < dash.curves.size(); ++i) own += detail::length_between(dash.nth(i), 0.0, 1.0);
            on += own;
            ++dashes;
            whole += own > 6.99 && own < 7.01;
        });
        // In each 13 units 9 are on; the ends add at most one period.
        CHECK(on > all / 13.0 * 9.0 - 9.0);
        CHECK(on < all / 13.0 * 9.0 + 9.0);
        CHECK(dashes >= 2 * static_cast<int>(all / 13.0) - 1);
        CHECK(whole >= static_cast<int>(all / 13.0) - 1);
    }
    const double many[] = {1e-4};
    CHECK_FALSE(detail::dash_pattern(many, 0.0, 10.0).is_possible(path));
    const double none[] = {0.0, 0.0};
    CHECK_FALSE(detail::dash_pattern(none, 0.0, 10.0).has_gaps());
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/tab_stop.hpp>

using namespace typemesh;

TEST_CASE("a tab leads to the next stop, but not to one that is nearer than half a digit", "[layout][tab]")
{
    const double least = least_tab(500.0);
    CHECK(least == 250.0);
    for (double pen = -3000.0; pen < 3000.0; pen += 10.0) {
        const double stop = tab_stop_behind(pen, 1000.0, least);
        CHECK(std::fmod(stop, 1000.0) == 0.0);
        CHECK(stop - pen >= least);
        CHECK(stop - pen < 1000.0 + least);
        CHECK(tab_stop_behind(pen, 1000.0, 0.0) > pen);
        CHECK(tab_stop_behind(pen, 1000.0, 0.0) <= pen + 1000.0);
    }
}

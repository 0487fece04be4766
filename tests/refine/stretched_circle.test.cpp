// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/stretched_circle.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;
using detail::extents;

TEST_CASE("stretched circles decide as circles do after a stretch that is large enough", "[refine]")
{
    // With coordinates up to 16, a factor of 2^16 outweighs everything that the other coordinate contributes.
    const auto wide = [](grid_point p) { return grid_point{p.x * 65536, p.y}; };
    const auto tall = [](grid_point p) { return grid_point{p.x, p.y * 65536}; };
    test::dice d{97};
    int flips = 0, ties = 0;
    for (int round = 0; round < 200'000; ++round) {
        grid_point a, b, c, e;
        for (grid_point* p : {&a, &b, &c, &e}) *p = {d.roll(17) - 8, d.roll(17) - 8};
        if (orientation(a, b, c) <= 0 || orientation(b, a, e) <= 0) continue;  // a b is an edge between c and e
        const bool narrow = detail::prefers_other_diagonal(extents::widths, a, b, c, e),
                   low = detail::prefers_other_diagonal(extents::heights, a, b, c, e);
        CHECK_QUICKLY(narrow == prefers_other_diagonal(wide(a), wide(b), wide(c), wide(e)));
        CHECK_QUICKLY(low == prefers_other_diagonal(tall(a), tall(b), tall(c), tall(e)));
        CHECK_QUICKLY(detail::prefers_other_diagonal(extents::both, a, b, c, e) == prefers_other_diagonal(a, b, c, e));
        if (narrow || low)  // only diagonals of convex quadrilaterals are exchanged
            CHECK_QUICKLY((orientation(c, a, e) > 0 && orientation(e, b, c) > 0));
        flips += narrow + low;
        ties += in_circle(wide(a), wide(b), wide(c), wide(e)) == 0;
    }
    CHECK(flips > 10'000);
    CHECK(ties > 10);
}

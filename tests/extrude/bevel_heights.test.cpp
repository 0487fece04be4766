// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_heights.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a bevel's shares lie between the caps and the walls, on both sides alike", "[bevel_heights]")
{
    for (const bool centred : {false, true}) {
        const bevel_heights h{0.5f, 0.125f, bevel_sides::both, centred};
        CHECK(h.high() == (centred ? 0.25 : 0.0));
        CHECK(h.high() - h.low() == 0.5);
        for (const float share : {0.0f, 0.25f, 1.0f}) {
            CHECK(h.high() - h.at_share(true, share) == 0.125 * (1.0 - static_cast<double>(share)));
            CHECK(h.at_share(false, share) - h.low() == h.high() - h.at_share(true, share));
            CHECK(h.rim(true, share) == h.at_share(true, share));
        }
    }
}

TEST_CASE("walls reach a side that has no bevel, and there are none where the bevels meet", "[bevel_heights]")
{
    const bevel_heights front{0.25f, 0.25f, bevel_sides::front};
    CHECK(front.is_bevelled(true));
    CHECK_FALSE(front.is_bevelled(false));
    CHECK(front.rim(false, 0.5f) == front.low());
    CHECK_FALSE(front.has_walls(0.0f));
    CHECK(front.has_walls(0.5f));
    const bevel_heights back{0.25f, 0.125f, bevel_sides::back};
    CHECK_FALSE(back.is_bevelled(true));
    CHECK(back.rim(true, 0.0f) == back.high());
    CHECK(back.has_walls(0.0f));
    CHECK_FALSE(bevel_heights{0.25f, 0.125f, bevel_sides::both}.has_walls(0.0f));
}

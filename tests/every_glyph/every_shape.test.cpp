// SPDX-License-Identifier: MIT
//
// A few of the random outlines; the program every_shape takes as many as you like.

#include "shape_laws.hpp"
#include "support/catch.hpp"

#include <cstdint>

TEST_CASE("random outlines that are hard on moved edges are bevelled, bolder and hollow, and hardly ever narrowed",
          "[every_glyph][every_shape]")
{
    test::shape_findings all;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const test::shape_laws laws{seed};
        INFO("seed " << seed);
        CHECK(laws.found().wrong == "");
        all.add(laws.found());
    }
    CHECK(all.shapes > 350);
    CHECK(all.solids == 5 * all.shapes);
    CHECK(all.to_nothing == 0);
    CHECK(all.refused == 0);
    CHECK(all.narrowed <= 2);
}

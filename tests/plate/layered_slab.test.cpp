// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/plate/layered_slab.hpp>

#include "support/catch.hpp"

#include <cstddef>

using namespace typemesh;

TEST_CASE("the rims of a slab share its height, and a sixteenth of it stays a wall", "[layered_slab]")
{
    constexpr cell_set whole = cells_of_layer(0);
    const layered_base base{.height = 1.0f, .bevel = 0.1f, .unit_per_em = 2.0};
    // The first slab is 2 / 2 em high, the second 0.32 / 2 em.
    const layered_slab slabs[] = {{whole, 3.0f, 0.2f, 9.0f}, {whole, 3.32f, 0.1f, 0.2f}};
    float lower = 0.0f;
    detail::rim_widths widths[2];
    CHECK_FALSE(detail::settle_widths(base, {slabs, 2}, lower, widths));
    CHECK(same(lower, 0.1f));
    CHECK(same(widths[0].bevel, 0.2f));
    CHECK(widths[0].fillet == 0.0f);                 // nothing is below it
    CHECK(widths[1].bevel == Catch::Approx(0.075));  // each wants more than half of 0.15
    CHECK(widths[1].fillet == Catch::Approx(0.075));
    CHECK(same(base.depth(0.25f), 0.5f));
}

TEST_CASE("rims that floats cannot tell from nothing are left out", "[layered_slab]")
{
    constexpr cell_set whole = cells_of_layer(0);
    const layered_slab slabs[] = {{whole, 1000.0f, 1e-5f}, {whole, 1000.001f, 0.01f, 0.01f}, {whole, 1001.0f, 0.01f}};
    float lower = 0.0f;
    detail::rim_widths widths[3];
    CHECK_FALSE(detail::settle_widths({}, {slabs, 3}, lower, widths));
    CHECK(widths[0].bevel == 0.0f);
    CHECK(widths[1].bevel == 0.0f);
    CHECK(widths[1].fillet == 0.0f);
    CHECK(same(widths[2].bevel, 0.01f));
    CHECK(1000.0f - static_cast<float>(detail::least_rim_width({}, {slabs, 3})) < 1000.0f);
}

TEST_CASE("a slab's pockets are what its rim surrounds and it does not fill", "[layered_slab]")
{
    constexpr cell_set a = cells_of_layer(0), b = cells_of_layer(1);
    const layered_slab plain{b, 1.0f}, inlaid{b & ~a, 1.0f, 0.1f, 0.0f, b};
    CHECK(plain.outline() == b);
    CHECK(plain.pockets() == cell_set{});
    CHECK(inlaid.outline() == b);
    CHECK(inlaid.pockets() == (a & b));
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/regions.hpp"
#include "support/unproving.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>
#include <typemesh/triangulate/monotone.hpp>

using namespace typemesh;

TEMPLATE_TEST_CASE("a triangulator cuts and proves the same through its reference", "[triangulate]", monotone,
                   constrained_delaunay)
{
    contours loops = test::contours_of({{{0, 0}, {4000, 0}, {4000, 3000}, {1000, 1000}}});
    workspace space;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    REQUIRE(filled);
    const TestType how;
    const triangulator_ref refers{how};
    triangle_list own, by_ref;
    REQUIRE(cut_region(*filled, how, space, own));
    REQUIRE_FALSE(refers.cut(*filled, space, by_ref));
    CHECK(std::ranges::equal(own, by_ref));
    CHECK(refers.proves() == proving_triangulator<TestType>);
    CHECK(refers.proves_touching() == touching_triangulator<TestType>);
    CHECK(refers.has_final_diagonals() == has_final_diagonals<TestType>);
    CHECK(refers.key() == key_of(how));
}

// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/appended_triangles.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <vector>

using namespace typemesh;
using typemesh::detail::appended_triangles;

TEST_CASE("appended triangles are compared with what a triangulator promises", "[triangulate]")
{
    const contours square = test::contours_of({test::square(0, 0, 10)});
    const region r = region::proven(square, 0, 1);
    const auto of = [&](const std::vector<triangle>& all) {
        const appended_triangles t{r, all};
        const bool readable = t.are_over_its_points();
        return std::vector<bool>{t.are_as_many_as_promised(), readable, readable && t.turn_left(),
                                 readable && t.have_its_area()};
    };
    using kept = std::vector<bool>;
    CHECK(of({{0, 1, 2}, {0, 2, 3}}) == kept{true, true, true, true});
    CHECK(of({{0, 1, 2}}) == kept{false, true, true, false});
    CHECK(of({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}) == kept{false, true, true, false});
    CHECK(of({{0, 1, 2}, {0, 2, 4}}) == kept{true, false, false, false});
    CHECK(of({{0, 1, 2}, {0, 3, 2}}) == kept{true, true, false, false});
    CHECK(of({{0, 1, 1}, {0, 2, 3}}) == kept{true, true, false, false});
    CHECK(of({{0, 1, 2}, {0, 1, 2}}) == kept{true, true, true, true});  // overlap: inspect/cap_check.hpp finds it
}

// SPDX-License-Identifier: MIT

#include <typemesh/inspect/boundary_check.hpp>
#include <typemesh/inspect/simplicity.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <string>

using namespace typemesh::inspect;

namespace {

std::string broken(const std::vector<test::polyline>& loops)
{
    return check_boundary({loops.begin(), loops.end()}).broken();
}

}  // namespace

TEST_CASE("boundary cycles that stay in their sectors pass, and each planted fault is found", "[inspect]")
{
    const test::polyline box = test::square(0, 0, 10), beside = test::square(10, 10, 10);
    CHECK(broken({box, beside}) == "");  // a common corner
    CHECK(broken({box, {{20, 0}, {30, 0}}}) == "a loop has fewer than three points");
    CHECK(broken({box, {{20, 0}, {30, 0}, {30, 0}, {25, 9}}}) == "a point is repeated");
    CHECK(broken({box, {{20, 0}, {30, 0}, {25, 0}, {25, 9}}}) == "a spike");
    CHECK(broken({box, {{5, 5}, {15, 5}, {15, 8}}}) == "two edges cross, or touch elsewhere than in a common end");
    CHECK(broken({box, {{10, 5}, {15, 5}, {15, 8}}}) == "two edges cross, or touch elsewhere than in a common end");
    CHECK(broken({box, test::square(10, 0, 10)}) == "two edges overlap");
    const test::polyline on_a_corner = test::square(0, 0, 5);
    CHECK(check_boundary({box, on_a_corner}).overlaps == 2);

    // A hole that touches its outer loop joins it; two squares that touch in a corner stay apart.
    CHECK(broken({{{0, 0}, {5, 0}, {3, 4}, {7, 4}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}}) == "");
    CHECK(broken({{{0, 0}, {5, 0}, {7, 4}, {3, 4}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}}) ==
          "a boundary cycle leaves its sector");
    CHECK(broken({{{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}, {0, 10}}}) ==
          "a boundary cycle leaves its sector");
    const test::polyline across{{5, 5}, {15, 5}, {15, 8}};
    CHECK(check_boundary({across, box}).crossings == 2);
}

TEST_CASE("loops that do not meet are boundary cycles", "[inspect]")
{
    int regions = 0;
    for (const test::shape& s : test::generated_regions()) {
        INFO(s.name);
        const bool apart = !is_crossing(test::loops_of(s));
        regions += apart;
        CHECK((std::string{check_boundary(test::loops_of(s)).broken()} == "") == apart);
    }
    CHECK(regions > 10);
}

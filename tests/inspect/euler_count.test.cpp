// SPDX-License-Identifier: MIT

#include <typemesh/inspect/euler_count.hpp>

#include "solids.hpp"

using namespace typemesh::inspect;

TEST_CASE("Euler's formula counts a text's solids and the holes through them", "[inspect]")
{
    const struct {
        const char* text;
        std::size_t solids;
        std::int64_t holes;
    } cases[] = {{"i", 1, 0}, {"o", 1, 1}, {"oo", 2, 2}, {"oE i", 3, 1}, {" ", 0, 0}};
    for (const auto& c : cases) {
        const test::full_mesh m = solids::of(c.text);
        const euler_count e = count_euler(solids::seen(m));
        INFO(c.text);
        CHECK(e.solids == c.solids);
        CHECK(e.holes() == c.holes);
        CHECK(2 * e.edges == 3 * e.triangles);
        CHECK(e.characteristic() == 2 * static_cast<std::int64_t>(c.solids) - 2 * c.holes);
        if (m.indices.empty()) continue;
        CHECK(count_euler(solids::seen(solids::without(m, 0))).characteristic() == e.characteristic() - 1);
    }
}

// SPDX-License-Identifier: MIT
#include <typemesh/plate/cell_set.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("sets of cells follow the algebra of their layers, label by label", "[cell_set]")
{
    for (std::uint32_t label = 0; label < 32; ++label)
        for (std::uint32_t a = 0; a < max_layers; ++a)
            for (std::uint32_t b = 0; b < max_layers; ++b) {
                const bool in_a = (label >> a & 1u) != 0, in_b = (label >> b & 1u) != 0;
                const cell_set first = cells_of_layer(a), second = cells_of_layer(b);
                CHECK(first.contains(label) == in_a);
                CHECK((first & second).contains(label) == (in_a && in_b));
                CHECK((first | second).contains(label) == (in_a || in_b));
                CHECK((first & ~second).contains(label) == (in_a && !in_b));
            }
    CHECK_FALSE((cells_of_layer(0) | cells_of_layer(4)).is_unbounded());
    CHECK((~cells_of_layer(3)).is_unbounded());
}

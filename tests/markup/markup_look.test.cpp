// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/markup/markup_look.hpp>

#include <vector>

using namespace typemesh;

TEST_CASE("looks that differ in one member differ, also in their hashes", "[markup]")
{
    using look = basic_markup_look<char>;
    const std::vector<look> looks{{},
                                  {.tags = 1},
                                  {.position = script_position::superscript},
                                  {.position = script_position::subscript},
                                  {.size = 2.0},
                                  {.rise = 2.0},
                                  {.spacing = 2.0},
                                  {.depth = 2.0},
                                  {.bevel = 2.0},
                                  {.colour = 2},
                                  {.style = 2},
                                  {.font = "a"},
                                  {.language = "a"}};
    for (std::size_t i = 0; i < looks.size(); ++i) {
        for (std::size_t k = 0; k < looks.size(); ++k) {
            CHECK((looks[i] == looks[k]) == (i == k));
            const bool words = i >= 11 && k >= 11;  // one hash may do for the same words in different places
            if (!words) CHECK((hash_of(looks[i]) == hash_of(looks[k])) == (i == k));
        }
    }
    CHECK(hash_of(look{.rise = -0.0}) == hash_of(look{.rise = 0.0}));
    CHECK(look{.tags = 1u << 9}.has(markup_tag::spacing));
    CHECK_FALSE(look{.tags = 1u << 9}.has(markup_tag::depth));
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/markup/markup_look.hpp>

#include <vector>

using namespace typemesh;

TEST_CASE("looks that differ in one member differ, also in their hashes", "[markup]")
{
    using look = basic_markup_look<char>;
    const std::uint32_t all = (1u << markup_tag_count) - 1;
    const std::vector<look> looks{{.tags = all},
                                  {},
                                  {.tags = all, .position = script_position::superscript},
                                  {.tags = all, .position = script_position::subscript},
                                  {.tags = all, .size = 2.0},
                                  {.tags = all, .rise = 2.0},
                                  {.tags = all, .spacing = 2.0},
                                  {.tags = all, .depth = 2.0},
                                  {.tags = all, .bevel = 2.0},
                                  {.tags = all, .colour = 2},
                                  {.tags = all, .style = 2},
                                  {.tags = all, .font = "a"},
                                  {.tags = all, .language = "a"}};
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

// SPDX-License-Identifier: MIT

#include <typemesh/vertex/colour.hpp>

#include <cstring>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("colours are stored in the order of their names", "[vertex]")
{
    const rgba8 orange{1.0f, 0.5f, 0.0f};
    unsigned char bytes[4];
    std::memcpy(bytes, &orange, 4);
    CHECK(bytes[0] == 255);
    CHECK(bytes[1] == 128);
    CHECK(bytes[2] == 0);
    CHECK(bytes[3] == 255);
    const bgra8 turned = orange;
    std::memcpy(bytes, &turned, 4);
    CHECK(bytes[0] == 0);
    CHECK(bytes[2] == 255);
}

TEST_CASE("each part has its colour", "[vertex]")
{
    constexpr part_colours<> colours{{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    static_assert(colours(part::front).r.bits == 255 && colours(part::back).g.bits == 255 &&
                  colours(part::side).b.bits == 255);
    CHECK(part_colours<int>{1, 2, 3}(part::back) == 2);
    for (const part p : {part::front_bevel, part::back_bevel}) CHECK(part_colours<int>{1, 2, 3}(p) == 3);
    CHECK(part_colours<int>{1, 2, 3, 4}(part::front_bevel) == 4);
    CHECK(part_colours<int>{1, 2, 3, 4}(part::back_bevel) == 3);
    CHECK(part_colours<int>{1, 2, 3, 4, 5}(part::back_bevel) == 5);
}

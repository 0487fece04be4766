// SPDX-License-Identifier: MIT

#include <typemesh/outline/impl/variation_key.hpp>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct font_without_key {};
struct font_with_key {
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return 42; }
};

}  // namespace

TEST_CASE("a font without a variation key has key 0", "[outline][variation_key]")
{
    CHECK(variation_of(font_without_key{}) == 0);
    CHECK(variation_of(font_with_key{}) == 42);
}

TEST_CASE("each number of a map changes the key", "[outline][variation_key]")
{
    const affine plain;
    const affine others[] = {{.xx = 2.0}, {.xy = 2.0}, {.dx = 2.0}, {.yx = 2.0}, {.yy = 2.0}, {.dy = 2.0}};
    for (const affine& map : others) {
        CHECK(mixed_key(7, map) != mixed_key(7, plain));
        CHECK(mixed_key(7, map) != mixed_key(8, map));
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/outline/impl/variation_key.hpp>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct silent_font {};
struct telling_font {
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return 42; }
};

}  // namespace

TEST_CASE("a font that tells no variation has 0", "[outline][variation_key]")
{
    CHECK(variation_of(silent_font{}) == 0);
    CHECK(variation_of(telling_font{}) == 42);
}

TEST_CASE("each number of a map has its share in the key", "[outline][variation_key]")
{
    const affine plain;
    const affine others[] = {{.xx = 2.0}, {.xy = 2.0}, {.dx = 2.0}, {.yx = 2.0}, {.yy = 2.0}, {.dy = 2.0}};
    for (const affine& map : others) {
        CHECK(mixed_key(7, map) != mixed_key(7, plain));
        CHECK(mixed_key(7, map) != mixed_key(8, map));
    }
}

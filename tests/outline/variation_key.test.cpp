// SPDX-License-Identifier: MIT

#include <typemesh/outline/variation_key.hpp>

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

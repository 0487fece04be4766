// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/laid_line.hpp>

using namespace typemesh;

TEST_CASE("a line ends its width to the right of where it begins", "[paragraph]")
{
    CHECK(laid_line{.left = -3.0, .width = 5.0}.right() == 2.0);
}

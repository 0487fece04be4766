// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"

namespace test {

/// What was made, if it was; otherwise the test ends, and names the line of the call.
template <class Result>
[[nodiscard]] Result required(Result made, int line = __builtin_LINE())
{
    INFO("in line " << line);
    REQUIRE(made);
    return made;
}

}  // namespace test

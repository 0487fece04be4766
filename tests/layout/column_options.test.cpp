// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/shape_options.hpp>

using namespace typemesh;

TEST_CASE("by default Latin lies on its side, and no number is combined", "[layout][columns]")
{
    CHECK(shape_options{}.columns.latin == column_latin::sideways);
    CHECK(shape_options{}.columns.combined_digits == 0);
}

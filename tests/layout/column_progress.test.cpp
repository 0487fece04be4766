// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/column_progress.hpp>

using namespace typemesh;

TEST_CASE("columns go to the right where the option, the script or the first letter says so", "[layout][columns]")
{
    const std::u16string mongolian = u"12 \u182E\u1823\u1829", chinese = u"\u6F22\u182E";
    shape_options how;
    CHECK_FALSE(columns_go_right(mongolian, how));  // lines
    how.direction = direction::top_to_bottom;
    CHECK(columns_go_right(mongolian, how));
    CHECK_FALSE(columns_go_right(chinese, how));
    CHECK_FALSE(columns_go_right(u"", how));
    CHECK_FALSE(columns_go_right(u"12", how));
    CHECK(columns_go_right(u"\uA840", how));  // Phags-pa
    how.script = "Mong";
    CHECK(columns_go_right(chinese, how));
    how.script = "Hani";
    CHECK_FALSE(columns_go_right(mongolian, how));
    how.columns.progress = column_progress::rightwards;
    CHECK(columns_go_right(mongolian, how));
    how.script = {};
    how.columns.progress = column_progress::leftwards;
    CHECK_FALSE(columns_go_right(mongolian, how));
}

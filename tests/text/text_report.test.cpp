// SPDX-License-Identifier: MIT

#include <typemesh/text/text_report.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a report is complete unless a glyph was refused, was missing, or some of the text was no UTF", "[text]")
{
    text_report r;
    r.glyphs = 9;
    r.blank = 4;
    r.narrowed = 2;
    r.unbroken = 1;
    CHECK(r.complete());
    for (std::uint32_t text_report::* const lost :
         {&text_report::refused, &text_report::missing, &text_report::invalid_units}) {
        text_report s = r;
        s.*lost = 1;
        CHECK_FALSE(s.complete());
    }
}

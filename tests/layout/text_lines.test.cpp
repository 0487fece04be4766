// SPDX-License-Identifier: MIT
#include "support/plain_text_law.hpp"
#include "support/toy_covering_font.hpp"

#include <typemesh/layout/impl/text_lines.hpp>

TEST_CASE("Plain text and a paragraph without a width are laid out alike by any shaper", "[layout][paragraph]")
{
    test::toy_covering_font font{U"abc 0123456789\u05D0\u05D1\u0628\u4E00"};
    test::random_text random{7};
    test::check_plain_text(font, random, 2000);
}

// SPDX-License-Identifier: MIT
#include "support/shaped_paragraph.hpp"

#include <typemesh/layout/impl/ideograph_gaps.hpp>

using namespace typemesh;

TEST_CASE("a gap is at each space and beside each ideograph, but not before a space or at the text's end",
          "[paragraph]")
{
    const test::shaped_paragraph p{u"\u6F22\u5B57ab c\u6F22 d\u6F22"};
    std::string gaps;
    for (std::uint32_t c = 0; c < p.shaped.cluster_count(); ++c)
        gaps += has_ideograph_gap(p.shaped, p.shaped.cluster(c)) ? '|' : '.';
    CHECK(gaps ==
          "||.."
          "||.||.");
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/paragraph/broken_line.hpp>

#include <vector>

using namespace typemesh;

namespace broken_line_test {

double least_end(const std::vector<break_piece>& pieces, const line_room& room, double pen = 0.0, std::size_t first = 0)
{
    text_pieces::list all{heap()};
    for (const break_piece& p : pieces) REQUIRE(all.push_back(p, {}));
    return broken_line{.all = all, .first = first, .last = pieces.size(), .pen = pen}.least_end(room);
}

}  // namespace broken_line_test

using broken_line_test::least_end;

TEST_CASE("a broken line ends with what is visible, its spaces as narrow as they may be", "[paragraph]")
{
    const break_piece word{.width = 500.0, .space = 100.0, .stretch = 100.0}, blank{.space = 100.0};
    CHECK(least_end({word, word, word}, {}) == 1700.0);
    CHECK(least_end({word, word, word}, {.shrink = 0.25}) == 1650.0);
    CHECK(least_end({word, word, word}, {}, 30.0) == 1730.0);
    CHECK(least_end({word, word, word}, {}, 0.0, 1) == 1100.0);
    CHECK(least_end({word, blank}, {}) == 500.0);
    CHECK(least_end({blank}, {}) == 0.0);
}

TEST_CASE("at its ends a broken line is as wide as its pieces are there", "[paragraph]")
{
    const break_piece parted{.width = 500.0, .begin_change = 20.0, .end_change = 7.0};
    CHECK(least_end({parted, parted}, {}) == 1027.0);
    CHECK(least_end({parted, {.end_change = 300.0}}, {}) == 820.0);  // a soft hyphen alone
}

TEST_CASE("only the spaces after a broken line's last tab shrink", "[paragraph]")
{
    const break_piece word{.width = 500.0, .space = 100.0, .stretch = 100.0}, tab{.width = 500.0, .tab = true};
    CHECK(least_end({word, tab, word, word}, {.shrink = 0.25, .tab = 400.0}) == 1200.0 + 1100.0 - 25.0);
}

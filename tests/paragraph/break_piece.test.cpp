// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/paragraph/break_piece.hpp>

using namespace typemesh;

TEST_CASE("a line must end with what the text demands, and with nothing else", "[paragraph]")
{
    for (const piece_end end : {piece_end::never, piece_end::in_need, piece_end::allowed})
        CHECK_FALSE(break_piece{.end = end}.ends_line());
    for (const piece_end end : {piece_end::line, piece_end::paragraph}) CHECK(break_piece{.end = end}.ends_line());
}

TEST_CASE("a piece needs its width and what its ends may add, mere white space nothing", "[paragraph]")
{
    CHECK(break_piece{.width = 5.0, .space = 2.0}.room() == 5.0);
    CHECK(break_piece{.width = 5.0, .begin_change = 1.0, .end_change = 2.0}.room() == 8.0);
    CHECK(break_piece{.width = 5.0, .begin_change = -1.0, .end_change = -2.0}.room() == 5.0);
    CHECK(break_piece{.space = 2.0, .end_change = -1.0}.room() == 0.0);
    CHECK(break_piece{.end_change = 1.0}.room() == 1.0);  // a soft hyphen alone
    CHECK_FALSE(break_piece{.space = 2.0}.is_visible());
    CHECK(break_piece{.end_change = 1.0}.is_visible());
    CHECK(break_piece{.width = 1.0}.is_visible());
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/paragraph/paragraph.hpp>

using namespace typemesh;

namespace {

/// Every piece that may end a line does.
struct narrowest {
    error break_lines(std::span<const break_piece> pieces, const line_room&, buffer<std::uint32_t>& ends) noexcept
    {
        for (std::uint32_t k = 0; k < pieces.size(); ++k)
            if (pieces[k].end != piece_end::never && !ends.push_back(k + 1)) return error::out_of_memory;
        return {};
    }
};
static_assert(line_breaker<narrowest>);
static_assert(!line_breaker<int>);

}  // namespace

TEST_CASE("a paragraph takes any breaker", "[paragraph]")
{
    test::toy_shaper font;
    paragraph<test::toy_shaper, unicode_analyser, narrowest> words{font};
    glyph_run run;
    REQUIRE(words.set("one two\tthree"));
    REQUIRE(words.lay_out({}, run));
    REQUIRE(run.lines.size() == 3);
    CHECK(run.lines[2].glyph_count == 5);
}

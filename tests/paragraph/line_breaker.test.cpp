// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <string>
#include <vector>

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
    const test::laid_paragraph<test::toy_shaper, narrowest> p{"one two\tthree"};
    CHECK(p.lines() == std::vector<std::u16string>{u"one ", u"two", u"three"});
}

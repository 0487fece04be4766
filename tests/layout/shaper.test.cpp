// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/layout/shaper.hpp>

#include <utility>

using namespace typemesh;

namespace {

/// Shapes without saying which units its advances have.
struct without_units {
    line_metrics metrics(direction) const noexcept { return {}; }
    error shape(text_view, const text_item&, const shape_options&, buffer<shaped_glyph>&) noexcept { return {}; }
};

static_assert(shaper<test::toy_shaper> && shaper<test::toy_font> && !shaper<without_units>);

}  // namespace

TEST_CASE("A shaper appends glyphs, counts clusters from the text's start, and follows the item's level", "[layout]")
{
    test::toy_shaper font;
    buffer<shaped_glyph> glyphs;
    REQUIRE_FALSE(font.shape("xAVi", {.first = 1, .last = 3}, {}, glyphs));
    REQUIRE_FALSE(font.shape("xAVi", {.first = 1, .last = 4, .level = 1}, {}, glyphs));
    REQUIRE(glyphs.size() == 5);
    for (const auto& [at, cluster] : {std::pair{0, 1u}, {1, 2u}, {2, 3u}, {3, 2u}, {4, 1u}})
        CHECK(glyphs[static_cast<std::size_t>(at)].cluster == cluster);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/text_highlight.hpp>
#include <typemesh/markup/markup_styles.hpp>

using namespace typemesh;

TEST_CASE("mark-up gives one background for a colour, whatever else changes in it", "[layout][markup]")
{
    markup read;
    REQUIRE(read.read("a[mark=#ff0]b[b]c[/b][colour=#00f]d[/colour]e[mark=#0f0]f[/mark]g[/mark]h[mark=#ff0]i"));
    markup_styles styles;
    REQUIRE(styles.set(read));
    REQUIRE(styles.marks().size() == 4);
    const std::uint32_t ends[][2] = {{1, 5}, {5, 6}, {6, 7}, {8, 9}};
    const std::uint32_t colours[] = {0xFFFF00, 0x00FF00, 0xFFFF00, 0xFFFF00};
    for (std::size_t i = 0; i < 4; ++i) {
        const text_highlight& m = styles.marks()[i];
        CHECK(m.first == ends[i][0]);
        CHECK(m.last == ends[i][1]);
        const markup_paint& paint = styles.paints()[static_cast<std::size_t>(m.style)];
        CHECK(paint.colour == colours[i]);
        CHECK(paint.has(markup_tag::mark));
        CHECK(styles.solids()[paint.solid].has(markup_tag::mark));
        CHECK(styles.solid_of(m.style) == styles.solid_of(styles.marks()[0].style));
    }
    CHECK(styles.marks()[0].style == styles.marks()[2].style);
    for (const style_span& s : styles.spans())
        CHECK_FALSE(styles.paints()[static_cast<std::size_t>(s.style.style)].has(markup_tag::mark));
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/laid_paragraph.hpp"

#include <typemesh/paragraph/ruby_writer.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

using ruby_page = test::laid_paragraph<>;

ruby_span ruby_on(std::uint32_t first, std::uint32_t last, text_view text) { return {first, last, text, style_id{3}}; }

}  // namespace

TEST_CASE("a ruby is centred above its text, and ideographs and kana are spread", "[paragraph][ruby]")
{
    ruby_page page{u"abcdef"};  // every letter is 500 wide, in a ruby 250
    const std::size_t glyphs = page.run.glyphs.size();
    ruby_writer rubies;
    const ruby_span spans[] = {ruby_on(1, 3, u"xy"), ruby_on(3, 6, u"\u3042\u3044")};
    REQUIRE(rubies.write(page.font, page.laid(), spans, {.gap = 0.1}, page.run));
    REQUIRE(page.run.glyphs.size() == glyphs + 4);
    REQUIRE(page.run.lines.size() == 3);
    CHECK(page.run.lines[1].glyph_count == 2);
    CHECK(page.run.lines[2].first_glyph == glyphs + 2);
    const double x[] = {750.0, 1000.0,    // above 500 to 1500: 250, 250, 250, 250
                        1750.0, 2500.0};  // above 1500 to 3000: 250, 250, 500, 250, 250
    for (std::size_t i = glyphs; i < glyphs + 4; ++i) {
        CHECK(page.run.glyphs[i].origin.x == Approx(x[i - glyphs]));
        CHECK(page.run.glyphs[i].origin.y == Approx(700.0 + 100.0 + 0.5 * 200.0));  // its descender is on the gap
        CHECK(page.style(i).map.xx == Approx(0.5));
        CHECK(page.style(i).style == style_id{3});
        CHECK(page.run.glyphs[i].cluster == (i < glyphs + 2 ? 1 : 3));
    }
    CHECK(rubies.overhanging == 0);
    CHECK(rubies.divided == 0);
}

TEST_CASE("a ruby that is too wide is counted and stays centred, and what has no box has no ruby", "[paragraph][ruby]")
{
    ruby_page page{u"ab cd"};
    const std::size_t glyphs = page.run.glyphs.size();
    ruby_writer rubies;
    const ruby_span wide[] = {ruby_on(1, 2, u"xyzw"), ruby_on(2, 2, u"q")};
    REQUIRE(rubies.write(page.font, page.laid(), wide, {}, page.run));
    CHECK(rubies.overhanging == 1);
    REQUIRE(page.run.glyphs.size() == glyphs + 4);
    CHECK(page.run.glyphs[glyphs].origin.x == Approx(500.0 + 250.0 - 500.0));
    page.again({.width = 1.3});
    REQUIRE(page.lines().size() == 2);
    const ruby_span over_both[] = {ruby_on(1, 4, u"x")};
    REQUIRE(rubies.write(page.font, page.laid(), over_both, {}, page.run));
    CHECK(rubies.divided == 1);
    CHECK(page.run.glyphs.back().origin.y > 0.0);  // above the first line
}

TEST_CASE("a ruby that cannot be set leaves the run as it was", "[paragraph][ruby]")
{
    ruby_page page{u"abc"};
    const std::size_t glyphs = page.run.glyphs.size(), lines = page.run.lines.size();
    const ruby_span bad[] = {ruby_on(0, 1, u"\uFFFF"), ruby_on(1, 2, u"x!")};
    {
        ruby_writer rubies;
        const auto done = rubies.write(page.font, page.laid(), bad, {}, page.run);
        CHECK(done == error::font_library_failed);
        CHECK(done.error().cluster == 1);
    }
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 60; ++n) {
        test::counting_memory failing{.fail_at = n};
        ruby_writer poor{failing.source()};
        const auto done = poor.write(page.font, page.laid(), {bad, 1}, {}, page.run);
        if (done) break;
        ++failures;
        CHECK(done == error::out_of_memory);
        CHECK(page.run.glyphs.size() == glyphs);
        CHECK(page.run.lines.size() == lines);
        CHECK(page.run.missing == 0);
    }
    CHECK(failures > 5);
    CHECK(page.run.missing == 1);
    ruby_writer rubies;
    for (const double size : {0.0, -1.0, 1.5})
        CHECK(rubies.write(page.font, page.laid(), bad, {.size = size}, page.run) == error::bad_option);
    test::counting_memory counted;
    ruby_writer warm{counted.source()};
    REQUIRE(warm.write(page.font, page.laid(), {bad, 1}, {}, page.run));
    const std::size_t before = counted.requests;
    REQUIRE(warm.write(page.font, page.laid(), {bad, 1}, {}, page.run));
    CHECK(counted.requests == before);

}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/layout/select_glyphs.hpp>

#include <algorithm>
#include <cstdint>

using namespace typemesh;

namespace {

/// Three lines of glyphs 0 to 8, in styles 0, 1, 2, 0, 1, 2, ...; the fifth glyph is missing.
void fill_three_lines(glyph_run& run)
{
    run.units_per_em = 1000.0;
    for (std::uint32_t i = 0; i < 3; ++i) REQUIRE(run.glyph_styles.push_back({.style = style_id{i}}));
    for (std::uint32_t i = 0; i < 9; ++i) REQUIRE(run.glyphs.push_back({i, i, {double(i), 0.0}, i == 4, i % 3}));
    for (std::uint32_t i = 0; i < 3; ++i)
        REQUIRE(run.lines.push_back({i == 0 ? 0u : i == 1 ? 2u : 7u, i == 0 ? 2u : i == 1 ? 5u : 2u}));
    run.note_missing(4);
}

}  // namespace

TEST_CASE("the selections of all styles together are the run", "[layout]")
{
    glyph_run run;
    fill_three_lines(run);
    std::uint32_t glyphs = 0, missing = 0, of_line[3] = {};
    for (std::uint32_t style = 0; style < 3; ++style) {
        glyph_run part;
        REQUIRE(select_glyphs(run, [&](style_id s) noexcept { return s == style_id{style}; }, part));
        CHECK(part.units_per_em >= 1000.0);
        REQUIRE(part.lines.size() == 3);
        std::uint32_t at = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(part.lines[k].first_glyph == at);
            at += part.lines[k].glyph_count;
            of_line[k] += part.lines[k].glyph_count;
            for (std::uint32_t i = part.lines[k].first_glyph; i < at; ++i) {
                const std::uint32_t id = part.glyphs[i].id;
                CHECK(id % 3 == style);
                CHECK(part.glyphs[i].origin.x >= double(id));
                CHECK((id >= run.lines[k].first_glyph && id < run.lines[k].first_glyph + run.lines[k].glyph_count));
            }
        }
        CHECK(at == part.glyphs.size());
        glyphs += at;
        missing += part.missing;
        CHECK(part.first_missing == (style == 1 ? 4 : no_cluster));
    }
    CHECK(glyphs == 9);
    CHECK(missing == 1);
    for (std::size_t k = 0; k < 3; ++k) CHECK(of_line[k] == run.lines[k].glyph_count);
}

TEST_CASE("a run without glyph styles has style 0, and an unknown glyph style is refused", "[layout]")
{
    glyph_run run, out;
    REQUIRE(run.glyphs.push_back({.id = 7}));
    REQUIRE(select_glyphs(run, [](style_id s) noexcept { return s == style_id{}; }, out));
    CHECK(out.glyphs.size() == 1);
    REQUIRE(select_glyphs(run, [](style_id s) noexcept { return s != style_id{}; }, out));
    CHECK(out.glyphs.empty());
    fill_three_lines(run);
    run.glyphs[3].glyph_style = 3;
    const auto done = select_glyphs(run, [](style_id) noexcept { return true; }, out);
    CHECK(done == error::no_such_glyph_style);
    CHECK(done.error().count == 3);
}

TEST_CASE("a selection tells when memory fails, and allocates nothing after warm-up", "[layout]")
{
    glyph_run run;
    fill_three_lines(run);
    const auto all = [](style_id) noexcept { return true; };
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 20; ++n) {
        test::counting_memory counted{.fail_at = n};
        glyph_run out{counted.source()};
        const auto done = select_glyphs(run, all, out);
        if (!done) {
            ++failures;
            CHECK(done == error::out_of_memory);
            CHECK(out.glyphs.empty());
            continue;
        }
        const std::size_t before = counted.requests;
        REQUIRE(select_glyphs(run, all, out));
        CHECK(counted.requests == before);
    }
    CHECK(failures == 3);
}

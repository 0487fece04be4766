// SPDX-License-Identifier: MIT

#include <typemesh/glyph/built_glyph.hpp>

#include "draft.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cstring>

using namespace typemesh;

TEST_CASE("a built glyph is a copy of its draft in one block, and independent of the draft", "[glyph][built_glyph]")
{
    test::dice d{12};
    for (int round = 0; round < 300; ++round) {
        test::draft given{d};
        const test::draft same = given;
        const std::size_t bytes = built_glyph::bytes_for(given.parts());
        std::vector<std::uint64_t> block(bytes / 8 + 2, 0xA5A5'A5A5'A5A5'A5A5u);
        built_glyph* const made = built_glyph::make(block.data(), given.parts());
        given.overwrite();
        CHECK(same.is(*made));
        const auto* const raw = reinterpret_cast<const unsigned char*>(block.data());
        CHECK(std::all_of(raw + bytes, raw + 8 * block.size(), [](unsigned char c) { return c == 0xA5; }));
    }
}

TEST_CASE("a built glyph's box is the box of its points, in cells and in font units", "[glyph][built_glyph]")
{
    test::dice d{13};
    for (int round = 0; round < 300; ++round) {
        const test::draft given{d};
        if (given.points.empty()) continue;
        std::vector<std::uint64_t> block(built_glyph::bytes_for(given.parts()) / 8 + 1);
        const built_glyph& made = *built_glyph::make(block.data(), given.parts());
        const auto by_x = [](grid_point a, grid_point b) { return a.x < b.x; };
        const auto by_y = [](grid_point a, grid_point b) { return a.y < b.y; };
        const auto [left, right] = std::minmax_element(given.points.begin(), given.points.end(), by_x);
        const auto [bottom, top] = std::minmax_element(given.points.begin(), given.points.end(), by_y);
        CHECK(made.low() == grid_point{left->x, bottom->y});
        CHECK(made.high() == grid_point{right->x, top->y});
        CHECK(made.ink().low == point{left->x / given.cells, bottom->y / given.cells});
        CHECK(made.ink().high == point{right->x / given.cells, top->y / given.cells});
        CHECK(made.font_units_per_cell() * made.cells() == Catch::Approx(1.0));
    }
}

TEST_CASE("a glyph without points is blank, unless it was refused", "[glyph][built_glyph]")
{
    std::vector<std::uint64_t> block(64);
    glyph_draft draft;
    CHECK(built_glyph::make(block.data(), draft)->is_blank());
    draft.refusal = error::outline_not_finite;
    const built_glyph& refused = *built_glyph::make(block.data(), draft);
    CHECK_FALSE(refused.is_blank());
    CHECK(refused.refusal() == error::outline_not_finite);
    CHECK(refused.form().points.empty());
}

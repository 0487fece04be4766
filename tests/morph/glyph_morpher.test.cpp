// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/glyph_morpher.hpp>

#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

TEST_CASE("a glyph keeps the keys at which it bends, and sections cover the stretch or are told to be missing",
          "[morph]")
{
    test::toy_axis axis;
    glyph_morpher morpher;
    morph_store store;
    const std::vector<axis_coordinate> masters = {-16384, 0, 16384};
    for (const char id : {'o', 'x', '8', 'w', 'p', 'q', 's', ' '})
        REQUIRE_FALSE(morpher.append(axis, static_cast<glyph_id>(id), masters, 1.0, 15.0, store));
    const auto& g = store.glyphs;
    REQUIRE(g.size() == 8);
    CHECK(g[0].keys == 3);
    CHECK(g[1].keys == 2);  // its outline does not bend at 0
    CHECK_FALSE((g[0].overlapping || g[0].refused || g[0].pinched));
    CHECK(g[1].overlapping);
    CHECK_FALSE(g[1].refused);
    CHECK(g[2].overlapping);
    CHECK_FALSE(g[2].refused);
    CHECK(g[3].refused);
    CHECK(g[3].sections > 0);
    CHECK(g[4].pinched);
    CHECK_FALSE(g[4].refused);
    CHECK_FALSE(g[5].pinched == g[4].refused);
    CHECK(g[6].sections == 1);
    CHECK(g[7].points == 0);
    CHECK(store.section_over(g[0], -16384, 16384) != nullptr);
    CHECK(store.section_over(g[3], -16384, 16384) == nullptr);
    CHECK(store.section_over(g[3], -16384, -16000) != nullptr);
    for (const morph_glyph& glyph : g)
        for (const glyph_section& s : store.sections_of(glyph)) {
            const moving_points moving{
                store.points.view().subspan(glyph.first_point, glyph.points * glyph.keys), glyph.points, {}};
            for (const triangle& t : store.triangles_of(s))
                for (std::size_t k = s.first_key; k < s.last_key; ++k) CHECK(moving.area(k, t).is_positive());
        }
    // The hole of 'w' leaves its box at 0.5, where its sections end, up to the shortest section.
    const auto keys = store.keys_of(g[3]);
    axis_coordinate end = -16384;
    for (const glyph_section& s : store.sections_of(g[3]))
        if (keys[s.first_key] == end) end = keys[s.last_key];
    CHECK(end <= 8192);
    CHECK(end > 8192 - 512);
}

TEST_CASE("an outline that does not vary as its masters say gets more keys or is refused", "[morph]")
{
    test::toy_axis axis;
    glyph_morpher morpher;
    morph_store store;
    const std::vector<axis_coordinate> ends = {-16384, 16384};  // the master at 0 is not told
    REQUIRE_FALSE(morpher.append(axis, 'o', ends, 1.0, 15.0, store));
    CHECK(store.glyphs[0].keys == 3);
    CHECK_FALSE(store.glyphs[0].refused);
    CHECK(store.keys[1] == 0);
}

TEST_CASE("an outline that is too large for proofs between its masters is refused", "[morph]")
{
    test::toy_axis axis;
    glyph_morpher morpher;
    morph_store store;
    const std::vector<axis_coordinate> ends = {-16384, 16384};
    REQUIRE_FALSE(morpher.append(axis, 'l', ends, 1.0, 15.0, store));
    CHECK(store.glyphs[0].refused);
    CHECK(store.glyphs[0].reason == error::outline_beyond_grid);
    CHECK(store.glyphs[0].sections == 0);
}

TEST_CASE("each hole goes with the contour around it, however many there are", "[morph]")
{
    test::toy_axis axis;
    glyph_morpher morpher;
    morph_store store;
    const std::vector<axis_coordinate> ends = {-16384, 16384};
    REQUIRE_FALSE(morpher.append(axis, '#', ends, 1.0, 15.0, store));
    const morph_glyph& g = store.glyphs[0];
    CHECK(g.overlapping);
    CHECK_FALSE(g.refused);
    CHECK(g.points == 144 * 8 + 8);
    REQUIRE(g.sections == 1);
    CHECK(store.sections[0].triangle_count == 144 * 8 + 4);
}

TEST_CASE("masters at which an outline moves on evenly cost little", "[morph]")
{
    test::toy_axis axis;
    glyph_morpher morpher;
    morph_store store;
    std::vector<axis_coordinate> many;
    for (axis_coordinate c = -16384; c <= 16384; c += 32) many.push_back(c);
    REQUIRE_FALSE(morpher.append(axis, 'o', many, 1.0, 15.0, store));
    CHECK(store.glyphs[0].keys == 3);
    CHECK_FALSE(store.glyphs[0].refused);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <vector>

using namespace typemesh;

namespace {

/// What a builder answers, kept.
struct kept_parts {
    std::vector<grid_point> points;
    std::vector<std::uint32_t> starts, corners;

    explicit kept_parts(const solid& form)
        : points(form.points.begin(), form.points.end()), starts(form.starts.begin(), form.starts.end())
    {
        for (const triangle t : form.triangles) corners.insert(corners.end(), {t.a, t.b, t.c});
    }
    friend bool operator==(const kept_parts&, const kept_parts&) = default;
};

}  // namespace

TEST_CASE("a trimmed builder holds nothing, and builds the same glyph again", "[glyph]")
{
    test::toy_font font;
    test::counting_memory memory;
    glyph_builder builder{memory.source()};
    no_observer nobody;
    const auto built = [&](glyph_id id) {
        const auto parts = builder.build(font, id, {.tolerance = quality::best},
                                         policies{certified{}, monotone{}, extruded<>{}, nobody});
        REQUIRE(parts);
        REQUIRE_FALSE(parts->refusal);
        return kept_parts{parts->form};
    };
    for (const glyph_id id : {1u, 3u, 5u}) {  // round, crossing, a box
        const kept_parts before = built(id);
        CHECK_FALSE(before.points.empty());
        CHECK(memory.bytes_held > 0);
        builder.trim();
        CHECK(memory.bytes_held == 0);
        CHECK(built(id) == before);
        const std::size_t warm = memory.requests;
        CHECK(built(id) == before);
        CHECK(memory.requests == warm);
    }
}

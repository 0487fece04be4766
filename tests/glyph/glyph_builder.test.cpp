// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
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

TEST_CASE("a trimmed builder holds no memory, and builds the same glyph again", "[glyph]")
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

TEST_CASE("the tolerance of a glyph is a share of the em", "[glyph]")
{
    test::toy_font font;
    no_observer nobody;
    glyph_builder builder;
    const auto points_at = [&](double tolerance) {
        const auto filled = builder.build_region(font, test::toy_font::glyph_of(U'o'), {.tolerance = tolerance},
                                                 policies{certified{}, monotone{}, flat{}, nobody});
        REQUIRE(filled);
        return filled->points().size();
    };
    // Circles of 1/4 and 3/20 em. Of a quarter, n chords of equal length are off by up to pi^2 / 32 * radius / n^2.
    for (const double tolerance : {0.1, 0.01, 0.001, 0.0001}) {
        double expected = 0.0;
        for (const double radius : {0.25, 0.15}) expected += 4 * std::ceil(std::sqrt(0.3084 * radius / tolerance));
        INFO(tolerance << " em");
        CHECK(static_cast<double>(points_at(tolerance)) >= expected);
        CHECK(static_cast<double>(points_at(tolerance)) <= 1.25 * expected);
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/glyph/coarsened.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/inspect/euler_count.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <type_traits>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

using lit_place = std::array<float, 6>;

/// The different places of a mesh's vertices with their normals.
std::set<lit_place> lit_places(const test::lit_mesh& m)
{
    std::set<lit_place> all;
    for (const test::lit_vertex& v : m.vertices)
        all.insert({v.place.x, v.place.y, v.place.z, v.normal.x, v.normal.y, v.normal.z});
    return all;
}

constexpr coarsened four_levels{.tolerances = {0.002, 0.01, 0.04, 0.2}};
constexpr text_options finest{.tolerance = 0.0005};

template <class Solid>
void check_levels(const Solid& solid, const text_options& how)
{
    test::toy_font font;
    text_mesher mesher{font, solid, four_levels};
    const auto fine = mesher.plan("oEoo", how);
    REQUIRE(fine);
    test::lit_mesh finer = test::written(*fine);
    const inspect::euler_count before = inspect::count_euler(finer.view());
    for (std::uint32_t level = 1; level <= 4; ++level) {
        INFO("level " << level);
        mesher.template policy<coarsened>()->level = level;
        const auto plan = mesher.plan("oEoo", how);
        REQUIRE(plan);
        CHECK(plan->report().complete());
        const test::lit_mesh made = test::written(*plan);
        CHECK(inspect::check_closedness(made.view(), 2).is_closed());
        const inspect::euler_count now = inspect::count_euler(made.view());
        CHECK(now.solids == before.solids);
        CHECK(now.holes() == before.holes());
        CHECK(made.vertices.size() < finer.vertices.size());
        const auto some = lit_places(made), all = lit_places(finer);
        if constexpr (std::is_same_v<Solid, extruded<>>)
            CHECK(std::includes(all.begin(), all.end(), some.begin(), some.end()));
        finer = made;
    }
}

}  // namespace

TEST_CASE("every level of a text is closed, with the same holes, and with vertices of the finer level",
          "[glyph][levels]")
{
    check_levels(extruded<>{}, finest);
    text_options merged = finest;
    merged.merge = true;
    merged.shape.letter_spacing = -0.3;
    check_levels(extruded<>{}, merged);
    check_levels(bevelled{.width = 0.01f}, finest);
}

TEST_CASE("level 0 is the text as it is", "[glyph][levels]")
{
    test::toy_font font;
    text_mesher plain{font}, levels{font, four_levels};
    const auto expected = plain.plan("oEx", finest), made = levels.plan("oEx", finest);
    REQUIRE((expected && made));
    CHECK(test::written(*made) == test::written(*expected));
}

TEST_CASE("levels of a cache are told apart by the tolerances that they use", "[glyph][levels]")
{
    coarsened a = four_levels, b = four_levels;
    b.tolerances[1] = 0.02;
    CHECK(a.cache_key() == b.cache_key());
    a.level = b.level = 1;
    CHECK(a.cache_key() == b.cache_key());
    CHECK_FALSE(a.cache_key() == four_levels.cache_key());
    a.level = b.level = 2;
    CHECK_FALSE(a.cache_key() == b.cache_key());

    test::toy_font font;
    glyph_cache<> cache;
    text_mesher cached{font, four_levels, cached_in{cache, 1}}, plain{font, four_levels};
    for (const std::uint32_t level : {0u, 3u, 1u, 3u, 0u}) {
        cached.policy<coarsened>()->level = plain.policy<coarsened>()->level = level;
        const auto made = cached.plan("oE", finest), expected = plain.plan("oE", finest);
        REQUIRE((made && expected));
        CHECK(test::written(*made) == test::written(*expected));
    }
    CHECK(cache.statistics().hits == 4);
}

TEST_CASE("options that make no levels are refused by name", "[glyph][levels]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto refusal = [&](const coarsened& how) {
        mesher.use(how);
        const error e = mesher.plan("o").error();
        return e == error::bad_option ? std::string{e.option} : std::string{e ? "another" : "none"};
    };
    CHECK(refusal({.tolerances = {0.01, 0.02}, .level = 2}) == "none");
    CHECK(refusal({.tolerances = {0.01, 0.01}, .level = 2}) == "none");
    CHECK(refusal({.tolerances = {0.01, 0.005}, .level = 1}) == "none");
    CHECK(refusal({.tolerances = {0.01, 0.005}, .level = 2}) == "coarsened::tolerances");
    CHECK(refusal({.tolerances = {0.01}, .level = 2}) == "coarsened::tolerances");
    CHECK(refusal({.tolerances = {-1.0}, .level = 1}) == "coarsened::tolerances");
    CHECK(refusal({.tolerances = {std::numeric_limits<double>::infinity()}, .level = 1}) == "coarsened::tolerances");
    CHECK(refusal({.tolerances = {std::numeric_limits<double>::quiet_NaN()}, .level = 1}) == "coarsened::tolerances");
    CHECK(refusal({.tolerances = {1, 2, 3, 4, 5, 6}, .level = 7}) == "coarsened::level");
}

TEST_CASE("a level allocates nothing after warm-up, and fails as memory does", "[glyph][levels]")
{
    test::toy_font font;
    coarsened third = four_levels;
    third.level = 3;
    test::counting_memory counted;
    text_mesher mesher{font, third, counted.source()};
    for (int again = 0; again < 4; ++again) {
        const std::size_t before = counted.requests;
        REQUIRE(mesher.plan("oEx", finest));
        if (again == 3) CHECK(counted.requests == before);
    }
    CHECK(test::check_each_failure([&](memory source) {
              text_mesher failing{font, third, source};
              return failing.plan("o", finest).error();
          }) > 10);
}

// SPDX-License-Identifier: MIT

#include <typemesh/text/level_mesher.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/euler_count.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

constexpr text_options finest{.tolerance = 0.0005};
constexpr double tolerances[] = {0.002, 0.01, 0.04};

using lit_place = std::array<float, 6>;

/// The different places of a mesh's vertices with their normals.
std::set<lit_place> lit_places(const test::lit_mesh& m)
{
    std::set<lit_place> all;
    for (const test::lit_vertex& v : m.vertices)
        all.insert({v.place.x, v.place.y, v.place.z, v.normal.x, v.normal.y, v.normal.z});
    return all;
}

/// Checks the levels of a mesher; returns the vertices of the coarsest.
template <class Solid>
std::size_t check_levels(text_mesher<Solid>& mesher, text_mesher<Solid>& plain, bool points_stay,
                         const text_options& how = finest)
{
    const auto expected = plain.plan("oEx~o", how);
    REQUIRE(expected);
    level_mesher levels{mesher};
    auto plan = levels.plan("oEx~o", how);
    REQUIRE(plan);
    CHECK(levels.number() == 0);
    CHECK(plan->report().refused == expected->report().refused);
    test::lit_mesh finer = test::written(*plan);
    CHECK(finer == test::written(*expected));
    const inspect::euler_count before = inspect::count_euler(finer.view());
    for (const double tolerance : tolerances) {
        plan = levels.coarser(tolerance);
        REQUIRE(plan);
        INFO("level " << levels.number());
        CHECK(plan->report().refused == expected->report().refused);
        const test::lit_mesh made = test::written(*plan);
        CHECK(inspect::check_closedness(made.view(), 2).is_closed());
        const inspect::euler_count now = inspect::count_euler(made.view());
        CHECK(now.solids == before.solids);
        CHECK(now.holes() == before.holes());
        CHECK(made.vertices.size() < finer.vertices.size());
        const auto some = lit_places(made), all = lit_places(finer);
        if (points_stay) CHECK(std::includes(all.begin(), all.end(), some.begin(), some.end()));
        finer = made;
    }
    CHECK(levels.number() == 3);
    return finer.vertices.size();
}

}  // namespace

TEST_CASE(
    "levels are closed, with the same holes and with vertices of the finer level, and the first is the text itself",
    "[text][levels]")
{
    test::toy_font font;
    text_mesher mesher{font}, plain{font};
    check_levels(mesher, plain, true);
    text_options parted = finest;
    parted.corners = touching::part;
    check_levels(mesher, plain, true, parted);
}

TEST_CASE("levels take every step and solid of the mesher: bold letters, and bevels that become narrower to fit",
          "[text][levels]")
{
    test::toy_font font;
    const embolden bold{.by = 0.01f};
    text_mesher mesher{font, bold}, plain{font, bold};
    check_levels(mesher, plain, false);
    const bevelled fitting{.width = 0.06f, .mode = bevel_mode::fit_text};
    text_mesher bevels{font, fitting}, plain_bevels{font, fitting};
    check_levels(bevels, plain_bevels, false);
}

TEST_CASE("levels are those of the step coarsened, wherever the triangulator proves them", "[text][levels]")
{
    test::toy_font font;
    text_mesher mesher{font}, stepped{font, coarsened{.tolerances = {0.002, 0.01, 0.04}}};
    level_mesher levels{mesher};
    REQUIRE(levels.plan("oEo", finest));
    for (std::uint32_t level = 1; level <= 3; ++level) {
        stepped.policy<coarsened>()->level = level;
        const auto expected = stepped.plan("oEo", finest), made = levels.coarser(tolerances[level - 1]);
        REQUIRE((expected && made));
        CHECK(test::written(*made) == test::written(*expected));
    }
}

TEST_CASE("a mesher's cache is not used for levels, and works afterwards", "[text][levels]")
{
    test::toy_font font;
    glyph_cache<> cache;
    text_mesher mesher{font, cached_in{cache, 1}}, plain{font};
    REQUIRE(mesher.plan("oE", finest));
    const auto before = cache.statistics();
    level_mesher levels{mesher};
    REQUIRE(levels.plan("oE", finest));
    REQUIRE(levels.coarser(0.01));
    CHECK(cache.statistics().hits == before.hits);
    const auto again = mesher.plan("oE", finest), expected = plain.plan("oE", finest);
    REQUIRE((again && expected));
    CHECK(cache.statistics().hits == before.hits + 2);
    CHECK(test::written(*again) == test::written(*expected));
}

TEST_CASE("levels out of turn are refused by name", "[text][levels]")
{
    test::toy_font font;
    text_mesher mesher{font};
    level_mesher levels{mesher};
    const auto option = [](const auto& made) {
        return made.error() == error::bad_option ? std::string{made.error().option} : std::string{"another"};
    };
    CHECK(option(levels.coarser(0.01)) == "level_mesher::plan");
    text_options merged = finest;
    merged.merge = true;
    CHECK(option(levels.plan("o", merged)) == "merge");
    REQUIRE(levels.plan("o", finest));
    CHECK(option(levels.coarser(0.0001)) == "tolerance");
    CHECK(option(levels.coarser(std::numeric_limits<double>::quiet_NaN())) == "tolerance");
    CHECK(option(levels.coarser(std::numeric_limits<double>::infinity())) == "tolerance");
    REQUIRE(levels.coarser(0.01));
    CHECK(option(levels.coarser(0.005)) == "tolerance");
    REQUIRE(mesher.plan("x", finest));
    CHECK(option(levels.coarser(0.02)) == "level_mesher::plan");
    CHECK(levels.plan("o", {.tolerance = -1.0}).error() == error::bad_tolerance);
    CHECK(option(levels.coarser(0.02)) == "level_mesher::plan");
}

template <class Levels>
concept plans_a_temporary = requires(Levels levels) { levels.plan(glyph_run{}); };
static_assert(!plans_a_temporary<level_mesher<extruded<>>>);

TEST_CASE("levels of a run are those of its text, and a blank text has blank levels", "[text][levels]")
{
    test::toy_font font;
    text_mesher mesher{font}, other{font};
    glyph_run run;
    REQUIRE(other.plan("oE", finest, [&](glyph_run& made) noexcept {
        run.units_per_em = made.units_per_em;
        for (const placed_glyph& g : made.glyphs) (void)run.glyphs.push_back(g);
    }));
    level_mesher levels{mesher}, of_text{other};
    REQUIRE((levels.plan(run, finest) && of_text.plan("oE", finest)));
    const auto made = levels.coarser(0.01), expected = of_text.coarser(0.01);
    REQUIRE((made && expected));
    CHECK(test::written(*made).vertices == test::written(*expected).vertices);

    REQUIRE(levels.plan("  ", finest));
    const auto blank = levels.coarser(0.01);
    REQUIRE(blank);
    CHECK(blank->glyphs().empty());
}

TEST_CASE("levels allocate nothing after warm-up, and fail as memory does", "[text][levels]")
{
    test::toy_font font;
    const auto run = [](auto& levels) -> error {
        if (const auto made = levels.plan("oEx", finest); !made) return made.error();
        for (const double tolerance : tolerances)
            if (const auto made = levels.coarser(tolerance); !made) return made.error();
        return {};
    };
    test::counting_memory counted;
    text_mesher mesher{font, counted.source()};
    level_mesher levels{mesher, counted.source()};
    for (int again = 0; again < 4; ++again) {
        const std::size_t before = counted.requests;
        REQUIRE_FALSE(run(levels));
        if (again == 3) CHECK(counted.requests == before);
    }
    CHECK(test::check_each_failure([&](memory source) {
              text_mesher failing{font, source};
              level_mesher of_failing{failing, source};
              return run(of_failing);
          }) > 10);
}

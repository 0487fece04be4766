// SPDX-License-Identifier: MIT

#include <typemesh/glyph/glyph_levels.hpp>

#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/level_laws.hpp"
#include "support/toy_font.hpp"
#include "support/unproving.hpp"

using namespace typemesh;

namespace {

/// A circle of eight quadratics.
template <class Pen>
void disc(Pen& pen, point at, double r, bool counter_clockwise)
{
    const double s = counter_clockwise ? 1.0 : -1.0, k = std::sqrt(0.5) * r, c = (std::sqrt(2.0) - 1.0) * r;
    const auto place = [&](double x, double y) { return point{at.x + x, at.y + s * y}; };
    pen.move(place(r, 0));
    pen.quadratic(place(r, c), place(k, k)), pen.quadratic(place(c, r), place(0, r));
    pen.quadratic(place(-c, r), place(-k, k)), pen.quadratic(place(-r, c), place(-r, 0));
    pen.quadratic(place(-r, -c), place(-k, -k)), pen.quadratic(place(-c, -r), place(0, -r));
    pen.quadratic(place(c, -r), place(k, -k)), pen.quadratic(place(r, -c), place(r, 0));
    pen.close();
}

/// Thin rings, with dots that are nearer to them than coarse tolerances.
recorded_outlines dotted_rings(std::uint32_t count)
{
    std::mt19937 random{7};
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 100001) / 100000.0;
    };
    recorded_outlines font{1000.0};
    for (std::uint32_t k = 0; k < count; ++k)
        REQUIRE(font.add([&](auto& pen) {
            const double stroke = between(0.5, 8.0);
            disc(pen, {0, 0}, 300.0, true), disc(pen, {0, 0}, 300.0 - stroke, false);
            for (int dot = 0; dot < 6; ++dot) {
                const double angle = dot + between(0.0, 0.8), r = between(0.5, 1.5),
                             way = k % 2 == 0 ? 300.0 - stroke - r - between(0.3, 12.0) : 300.0 + r + between(0.3, 4.0);
                disc(pen, {way * std::cos(angle), way * std::sin(angle)}, r, true);
            }
        }));
    return font;
}

/// Whether a loop is around a place, by exact crossings of a ray.
bool is_around(const std::vector<grid_point>& loop, grid_point p)
{
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const grid_point a = loop[i], b = loop[(i + 1) % loop.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        inside ^= (a.y < b.y) == (orientation(a, b, p) > 0);
    }
    return inside;
}

/// For each loop, the number of other loops around its first point.
std::multiset<std::size_t> depths(const test::loop_points& loops)
{
    std::multiset<std::size_t> all;
    for (const auto& own : loops) {
        std::size_t around = 0;
        for (const auto& other : loops) around += &own != &other && is_around(other, own.front());
        all.insert(around);
    }
    return all;
}

template <class Triangulator>
void check_rings(const Triangulator& cut)
{
    recorded_outlines font = dotted_rings(60);
    const certified flatten;
    no_observer nobody;
    glyph_builder builder;
    glyph_levels levels;
    std::vector<test::loop_points> finer;
    for (std::uint32_t id = 0; id < 60; ++id) {
        const auto filled = builder.build_region(font, id, {.tolerance = 0.0005}, cap_policies{flatten, cut, nobody});
        REQUIRE(filled);
        REQUIRE_FALSE(levels.keep(*filled));
        finer.push_back(test::loops_with(filled->points(), filled->starts()));
    }
    std::size_t before = 0, after = 0;
    for (const double tolerance : {0.002, 0.01, 0.04})
        for (std::uint32_t id = 0; id < 60; ++id) {
            INFO("ring " << id << " within " << tolerance);
            const auto made = levels.coarser(id, tolerance, cut);
            REQUIRE(made);
            const test::loop_points level = test::loops_with(made->points(), made->starts());
            CHECK(test::is_nested_in(level, finer[id]));
            CHECK(test::bound_a_region(level));
            CHECK(depths(level) == depths(finer[id]));
            CHECK(levels.triangles().size() == made->triangle_count());
            for (const auto& loop : finer[id]) before += loop.size();
            after += made->points().size();
            finer[id] = level;
        }
    CHECK(after < before);
}

}  // namespace

TEST_CASE("levels of thin rings with dots keep their loops where they are, however coarse", "[glyph][levels]")
{
    check_rings(monotone{});
    check_rings(test::unproving{});
}

TEST_CASE("levels of kept glyphs have the points of the step that tests them one by one, or a few less",
          "[glyph][levels]")
{
    test::toy_font font;
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    glyph_builder builder;
    glyph_levels levels;
    cap_builder own, further;
    coarsened::scratch scratch;
    for (const glyph_id id : {0u, 1u, 2u, 3u, 4u, 5u}) {
        INFO("glyph " << id);
        levels.clear();
        const auto filled = builder.build_region(font, id, {.tolerance = 0.0005}, cap_policies{flatten, cut, nobody});
        REQUIRE(filled);
        REQUIRE_FALSE(levels.keep(*filled));
        coarsened step{.tolerances = {0.002, 0.01}, .level = 2};
        REQUIRE(levels.coarser(0, 0.002, cut));
        const auto made = levels.coarser(0, 0.01, cut);
        REQUIRE(made);
        if (filled->points().empty()) {
            CHECK(made->points().empty());
            continue;
        }
        scratch.clear();
        region_caps caps{own, further, cut, {}};
        const auto expected = step(*filled, scratch, caps);
        REQUIRE(expected);
        CHECK(test::loops_with(made->points(), made->starts()) ==
              test::loops_with(expected->filled.points(), expected->filled.starts()));
        CHECK(made->holes() == expected->filled.holes());
        CHECK(made->is_touching() == expected->filled.is_touching());
        const auto again = levels.coarser(0, 0.0, cut);
        REQUIRE(again);
        CHECK(test::loops_with(again->points(), again->starts()) ==
              test::loops_with(expected->filled.points(), expected->filled.starts()));
    }
}

TEST_CASE("a tolerance that is none is refused and changes nothing", "[glyph][levels]")
{
    test::toy_font font;
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    glyph_builder builder;
    glyph_levels levels;
    const auto filled = builder.build_region(font, 1, {.tolerance = 0.0005}, cap_policies{flatten, cut, nobody});
    REQUIRE(filled);
    REQUIRE_FALSE(levels.keep(*filled));
    for (const double wrong :
         {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const auto made = levels.coarser(0, wrong, cut);
        REQUIRE(made.error() == error::bad_option);
        CHECK(std::string{made.error().option} == "tolerance");
    }
    const auto same = levels.coarser(0, 0.0, cut);
    REQUIRE(same);
    CHECK(same->points().size() == filled->points().size());
}

TEST_CASE("kept glyphs allocate nothing after warm-up, and fail as memory does", "[glyph][levels]")
{
    recorded_outlines font = dotted_rings(4);
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    glyph_builder builder;
    const auto filled = builder.build_region(font, 1, {.tolerance = 0.0005}, cap_policies{flatten, cut, nobody});
    REQUIRE(filled);
    const auto run = [&](glyph_levels& levels) -> error {
        levels.clear();
        if (error e = levels.keep(*filled)) return e;
        for (const double tolerance : {0.002, 0.04})
            if (const auto made = levels.coarser(0, tolerance, cut); !made) return made.error();
        return {};
    };
    test::counting_memory counted;
    glyph_levels levels{counted.source()};
    for (int again = 0; again < 4; ++again) {
        const std::size_t before = counted.requests;
        REQUIRE_FALSE(run(levels));
        if (again == 3) CHECK(counted.requests == before);
    }
    CHECK(test::check_each_failure([&](memory source) {
              glyph_levels failing{source};
              return run(failing);
          }) > 10);
}

TEST_CASE("a glyph that memory does not suffice to keep leaves all others as they are", "[glyph][levels]")
{
    recorded_outlines font = dotted_rings(2);
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    glyph_builder builders[2];
    std::vector<region> filled;
    for (std::uint32_t id = 0; id < 2; ++id)
        filled.push_back(
            *builders[id].build_region(font, id, {.tolerance = 0.0005}, cap_policies{flatten, cut, nobody}));
    constexpr std::size_t count = 5;
    std::size_t failures = 0;
    for (std::size_t at = 1;; ++at) {
        test::counting_memory failing{.fail_at = at, .fail_once = true};
        glyph_levels levels{failing.source()};
        for (std::size_t k = 0; k < count; ++k) {
            const error e = levels.keep(filled[k % 2]);
            if (!e) continue;
            CHECK(e == error::out_of_memory);
            CHECK(levels.size() == k);
            REQUIRE_FALSE(levels.keep(filled[k % 2]));
            ++failures;
        }
        if (failing.requests < at) break;
        for (std::size_t k = 0; k < count; ++k) {
            const auto made = levels.coarser(k, 0.0, cut);
            REQUIRE(made);
            const region& given = filled[k % 2];
            CHECK(test::loops_with(made->points(), made->starts()) == test::loops_with(given.points(), given.starts()));
            bool has_edges = made->edges().size() == given.edges().size();
            for (std::size_t i = 0; has_edges && i < given.edges().size(); ++i)
                has_edges = made->edges()[i].curve == given.edges()[i].curve;
            CHECK(has_edges);
        }
    }
    CHECK(failures > 10);
}

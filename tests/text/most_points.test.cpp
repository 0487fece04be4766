// SPDX-License-Identifier: MIT
//
// A font must not be able to ask for any number of points: glyphs with more than max_points are refused alone.

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdint>

using namespace typemesh;

namespace max_points_test {

/// Glyph 0 is a square, glyph 1 has four large arcs, glyph 2 never stops drawing small squares, nearly.
struct boundless_font {
    std::uint32_t drawn = 0;  ///< squares of glyph 2

    [[nodiscard]] static double units_per_em() noexcept { return 1000.0; }
    [[nodiscard]] static fill_rule fill() noexcept { return fill_rule::non_zero; }
    template <class Sink>
    [[nodiscard]] error outline(glyph_id id, Sink& sink) noexcept
    {
        if (id > 2) return error::unknown_glyph;
        if (id == 0) square(sink, {0, 0}, 500);
        if (id == 1) {
            constexpr double r = 250'000, k = 138'071;
            sink.move({r, 0});
            sink.cubic({r, k}, {k, r}, {0, r});
            sink.cubic({-k, r}, {-r, k}, {-r, 0});
            sink.cubic({-r, -k}, {-k, -r}, {0, -r});
            sink.cubic({k, -r}, {r, -k}, {r, 0});
            sink.close();
        }
        if (id == 2)
            for (drawn = 0; drawn < 2'000'000; ++drawn) square(sink, {3.0 * (drawn % 1000), 3.0 * (drawn / 1000.0)}, 1);
        return {};
    }

private:
    template <class Sink>
    static void square(Sink& sink, point at, double side) noexcept
    {
        sink.move(at);
        sink.line({at.x + side, at.y});
        sink.line({at.x + side, at.y + side});
        sink.line({at.x, at.y + side});
        sink.close();
    }
};

glyph_run all_three()
{
    glyph_run run;
    run.units_per_em = 1000.0;
    for (glyph_id id = 0; id < 3; ++id) REQUIRE(run.glyphs.push_back({id, 10 + id, {600.0 * id, 0}}));
    return run;
}

}  // namespace max_points_test

using namespace max_points_test;

TEST_CASE("a glyph with more points than allowed is refused alone, and the rest is built", "[text]")
{
    boundless_font font;
    test::counting_memory counted;
    text_mesher mesher{font, counted.source()};
    const text_options limited{.tolerance = 1.0 / 16'000, .max_points = 400};
    const glyph_run run = all_three();
    const auto plan = test::required(mesher.plan(run, limited));
    CHECK(plan->glyphs().size() == 1);
    CHECK(plan->report().refused == 2);
    CHECK(plan->report().first_refusal == error::too_many_points);
    CHECK(plan->report().first_refusal.count == 400);
    CHECK(plan->report().first_refusal.glyph == 1);
    CHECK(counted.peak < 400 * 1024);
    const test::full_mesh m = test::written<full_mesh>(*plan);
    CHECK(m.indices.size() == 3 * 12);  // the square alone
}

TEST_CASE("what is refused for its points is built where more are allowed", "[text]")
{
    boundless_font font;
    text_mesher mesher{font};
    const glyph_run run = all_three();
    const auto plan = test::required(mesher.plan(run, {.tolerance = 1.0 / 16'000}));
    CHECK(plan->glyphs().size() == 2);  // the default holds glyph 2 back: 8 million curves
    CHECK(plan->report().refused == 1);
    CHECK(plan->report().first_refusal.glyph == 2);
    CHECK(plan->report().first_refusal.count == default_max_points);
    CHECK(plan->contour_points() > 404);
}

// SPDX-License-Identifier: MIT

#include <typemesh/glyph/policies.hpp>
#include <typemesh/glyph/region_caps.hpp>

#include <typemesh/inspect/cap_check.hpp>
#include <typemesh/typemesh.hpp>

#include <string>

#include "stranger/flared.hpp"
#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

TEMPLATE_TEST_CASE("an extruder's caps are cut by the glyph's own triangulator", "[glyph]", monotone,
                   constrained_delaunay)
{
    test::toy_font font;
    no_observer nobody;
    const stranger::flared raise;
    const certified flatten;
    const TestType cut;
    const policies with{flatten, cut, raise, nobody};
    cap_builder caps, further;
    outline drawn;
    REQUIRE(record(font, 1, drawn));  // a ring
    const auto cells = grid::fitting(1000.0, drawn.bounds);
    REQUIRE(cells);
    const auto filled = caps.build(drawn, 1.0, *cells, {}, with);
    REQUIRE(filled);
    plan_scratch data;
    const auto plan = with.raise.plan(*filled, data, {caps, further, with.cut});
    REQUIRE(plan);
    CHECK(plan->sizes.triangles[part::front] == filled->triangle_count());
    CHECK(plan->around.width() == 2.0 * 500.0 * cells->cells);

    // The same triangles as of the letter itself, for its cap is the letter enlarged.
    std::vector<std::uint64_t> block(data.bytes() / 8);
    data.copy_to(reinterpret_cast<std::byte*>(block.data()));
    const auto kept = stranger::flared::plan_data::read_from(reinterpret_cast<const std::byte*>(block.data()));
    const auto made = kept.of<triangle>();
    CHECK(std::string{inspect::check_cap(*filled, made).broken()} == "");
    REQUIRE(made.size() == caps.triangles().size());
    for (std::size_t i = 0; i < made.size(); ++i) CHECK(made[i] == caps.triangles()[i]);
}

TEST_CASE("a cap of a region beyond the grid is refused", "[glyph]")
{
    no_observer nobody;
    const stranger::flared raise;  // asks for the cap of the region at twice its size
    const certified flatten;
    const monotone cut;
    const policies with{flatten, cut, raise, nobody};
    cap_builder caps, further;
    const auto planned = [&](grid_point low, grid_point high) {
        contours& loops = caps.loops();
        loops.clear();
        for (const grid_point p : {low, {high.x, low.y}, high, {low.x, high.y}}) REQUIRE(loops.points.push_back(p));
        for (const std::uint32_t start : {0u, 4u}) REQUIRE(loops.starts.push_back(start));
        REQUIRE(loops.edges.append(4) != nullptr);
        const auto filled = caps.fill({}, monotone{});
        REQUIRE(filled);
        plan_scratch data;
        return with.raise.plan(*filled, data, {caps, further, with.cut}).error();
    };
    constexpr std::int32_t half = 1 << 27;
    CHECK_FALSE(planned({-half, -half}, {half, half}));
    CHECK(planned({-half - 1, -half}, {half, half}) == error::outline_beyond_grid);
    CHECK(planned({-half, -half - 1}, {half, half}) == error::outline_beyond_grid);
    CHECK(planned({-half, -half}, {half + 1, half}) == error::outline_beyond_grid);
    CHECK(planned({-half, -half}, {half, half + 1}) == error::outline_beyond_grid);
}

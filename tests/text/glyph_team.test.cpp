// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/text/glyph_workers.hpp>

using namespace typemesh;

TEST_CASE("of several errors the lowest glyph's is returned", "[text][workers]")
{
    test::scrambled_workers several{3};
    auto workers = test::toy_team(several);
    glyph_team& team = workers->team();
    CHECK(team.members.size() == 3);
    const error e = team.each(100, [](std::size_t k, font_ref, glyph_builder&, glyph_store&) noexcept {
        return k % 10 == 7 ? error{error::bad_option, k} : error{};
    });
    CHECK(e == error::bad_option);
    CHECK(e.count == 7);
    CHECK_FALSE(team.each(
        0, [](std::size_t, font_ref, glyph_builder&, glyph_store&) noexcept { return error{error::out_of_memory}; }));
}

TEST_CASE("each plan has a number of its own, at a place that stays when the workers move", "[text][workers]")
{
    one_worker alone;
    auto made = test::toy_team(alone);
    const std::uint64_t* number = &made->team().plans;
    made->team().begin_plan();
    const std::uint64_t first = *number;
    auto moved = std::move(*made);
    CHECK(&moved.team().plans == number);
    moved.team().begin_plan();
    CHECK(*number != first);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/toy_font.hpp"

#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/text/glyph_workers.hpp>
#include <typemesh/text/lone_worker.hpp>
#include <typemesh/text/plan_workers.hpp>

using namespace typemesh;

namespace {

using alone = lone_worker<test::toy_font, no_observer>;
using team = glyph_workers<one_worker, test::toy_font>;

struct without_each : alone {
    void each(std::size_t) noexcept {}
};
struct without_layout {
    static constexpr bool is_alone = true;
    double units_per_em() noexcept { return 1000.0; }
    const std::uint64_t* begin_plan() noexcept { return nullptr; }
    template <class Task>
    error each(std::size_t, const Task&) noexcept
    {
        return {};
    }
};

}  // namespace

TEST_CASE("both kinds of workers keep one contract, and what falls short of it does not", "[text][workers]")
{
    STATIC_REQUIRE(plan_workers<alone, test::toy_font>);
    STATIC_REQUIRE(plan_workers<team, test::toy_font>);
    STATIC_REQUIRE(plan_workers<lone_worker<recorded_outlines, no_observer>, recorded_outlines>);
    STATIC_REQUIRE(plan_workers<team, recorded_outlines>);
    STATIC_REQUIRE(!plan_workers<without_each, test::toy_font>);
    STATIC_REQUIRE(!plan_workers<without_layout, test::toy_font>);
    STATIC_REQUIRE(plan_workers<without_layout, recorded_outlines>);  // no shaper: nothing to lay out
}

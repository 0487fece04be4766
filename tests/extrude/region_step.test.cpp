// SPDX-License-Identifier: MIT

#include <typemesh/extrude/region_step.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/inner_region.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

/// A stranger's step: the box around each glyph.
struct boxes {
    std::int32_t margin = 0;  ///< in cells

    struct scratch : inner_region {
        buffer<curve> curves;  // that walls are lit by

        explicit scratch(memory source = heap()) noexcept : inner_region{source}, curves{source} {}
    };

    [[nodiscard]] option_bits cache_key() const noexcept { return {margin}; }
    [[nodiscard]] error refused_options() const noexcept { return margin < 0 ? error::bad("margin") : error{}; }

    template <cap_maker Caps>
    [[nodiscard]] result<stepped_region> operator()(const region& drawn, scratch& made, Caps& caps) const noexcept
    {
        grid_point low = drawn.points()[0], high = low;
        for (const grid_point p : drawn.points()) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        low = {low.x - margin, low.y - margin}, high = {high.x + margin, high.y + margin};
        made.loops.grid = drawn.grid();
        made.loops.tolerance = drawn.tolerance();
        made.curves.clear();
        const grid_point corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
        for (std::uint32_t i = 0; i < 4; ++i) {
            const point from = placement::exact(corners[i]), to = placement::exact(corners[(i + 1) % 4]);
            if (!made.loops.points.push_back(corners[i]) || !made.loops.edges.push_back({i, 0.0f, 1.0f}) ||
                !made.curves.push_back(curve::from(from, to)))
                return error::out_of_memory;
        }
        made.loops.curves = made.curves.view();
        if (!made.loops.starts.push_back(0) || !made.loops.starts.push_back(4)) return error::out_of_memory;
        const auto filled = made.fill(caps);
        if (!filled) return filled.error();
        stepped_region all{*filled, made.triangles.view()};
        all.grown = true;
        return all;
    }
};

}  // namespace

static_assert(region_step<embolden> && region_step<boxes> && !region_step<no_step> && !region_step<bevelled>);

TEST_CASE("a user's own step works before any solid", "[extrude][region_step]")
{
    test::toy_font font;
    text_mesher mesher{font, boxes{}, flat{}};
    const auto plan = mesher.plan("oE", {.reuse = false});
    REQUIRE(plan);
    CHECK(plan->size().triangles == 2 * 2);
    mesher.policy<boxes>()->margin = -1;
    CHECK(mesher.plan("oE").error() == error::bad_option);

    text_mesher solid{font, boxes{}, bevelled{.width = 0.01f}};
    const auto bevels = solid.plan("oE");
    REQUIRE(bevels);
    CHECK(inspect::check_closedness(test::written(*bevels).view()).is_closed());

    glyph_cache<> cache;
    text_mesher cached{font, boxes{}, flat{}, cached_in{cache, 1}};
    const auto first = cached.plan("o");
    REQUIRE(first);
    const auto low = first->bounds().low.x;
    cached.policy<boxes>()->margin = 1 << 12;
    CHECK(cached.plan("o")->bounds().low.x < low);
}

// SPDX-License-Identifier: MIT
#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/boundary_check.hpp>
#include <typemesh/inspect/simplicity.hpp>
#include <typemesh/plate/layer_arrangement.hpp>

#include "support/catch.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

using polygon = std::vector<grid_point>;

std::uint32_t number(std::size_t n) { return static_cast<std::uint32_t>(n); }

void add(layer_arrangement& cells, const polygon& p, std::uint32_t layer)
{
    const std::array<std::uint32_t, 2> starts{0, number(p.size())};
    REQUIRE(cells.add({p.data(), p.size()}, {starts.data(), 2}, layer));
}

polygon square(std::int32_t x, std::int32_t y, std::int32_t size)
{
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

std::int64_t doubled_area(const region& r)
{
    std::int64_t sum = 0;
    for (std::uint32_t k = 0; k < r.loop_count(); ++k)
        for (std::uint32_t i = r.starts()[k]; i < r.starts()[k + 1]; ++i) {
            const grid_point p = r.points()[i], q = r.points()[i + 1 < r.starts()[k + 1] ? i + 1 : r.starts()[k]];
            sum += std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x;
        }
    return sum;
}

void check_region(const region& r)
{
    std::vector<polygon> polygons;
    for (std::uint32_t k = 0; k < r.loop_count(); ++k)
        polygons.emplace_back(r.points().begin() + r.starts()[k], r.points().begin() + r.starts()[k + 1]);
    const std::vector<inspect::loop> loops(polygons.begin(), polygons.end());
    CHECK(std::string{inspect::check_boundary(loops).broken()}.empty());
    if (!r.is_touching()) CHECK(inspect::is_region(loops));
}

}  // namespace

TEST_CASE("two squares make three kinds of cells with the areas worked out by hand", "[layer_arrangement]")
{
    constexpr cell_set a = cells_of_layer(0), b = cells_of_layer(1);
    layer_arrangement cells;
    workspace space;
    contours loops;
    for (int turn = 0; turn < 2; ++turn) {  // also with the layers swapped
        cells.begin({});
        add(cells, square(0, 0, 100), turn == 0 ? 0u : 1u);
        add(cells, square(50, 50, 100), turn == 0 ? 1u : 0u);
        REQUIRE(cells.cut(space));
        CHECK(cells.doubled_area(a) == 20000);
        CHECK(cells.doubled_area(b) == 20000);
        CHECK(cells.doubled_area(a & b) == 5000);
        CHECK(cells.doubled_area(a & ~b) == 15000);
        CHECK(cells.doubled_area(a | b) == 35000);
        CHECK(cells.piece_count() == 12);
        const auto both = cells.trace(a & b, space, loops);
        REQUIRE(both);
        CHECK(both->points().size() == 4);
        const auto ring = cells.trace((a | b) & ~(a & b), space, loops);
        REQUIRE(ring);
        CHECK(ring->is_touching());
        CHECK(ring->outers() == 2);
        int touching = 0;
        cells.each_touching((a | b) & ~(a & b), [&](grid_point) { ++touching; });
        CHECK(touching == 2);
        CHECK(cells.trace(~a, space, loops).error() == error::bad_option);
    }
}

TEST_CASE("regions of any layers are proven regions, and their areas add up exactly", "[layer_arrangement]")
{
    std::mt19937 random{5};
    layer_arrangement cells;
    workspace space;
    for (int run = 0; run < 60; ++run) {
        const std::int32_t size = run % 2 == 0 ? 40 : 30000;  // small ones have many roundings
        std::uniform_int_distribution<std::int32_t> place{-size, size};
        cells.begin({});
        std::vector<std::int64_t> alone;
        for (std::uint32_t layer = 0; layer < max_layers; ++layer) {
            contours drawn;
            REQUIRE(drawn.starts.push_back(0));
            for (int k = 0; k < 7; ++k)
                REQUIRE((drawn.points.push_back({place(random), place(random)}) && drawn.edges.push_back({})));
            REQUIRE(drawn.starts.push_back(7));
            const auto filled = resolve(drawn, fill_rule::even_odd, space);
            REQUIRE(filled);
            alone.push_back(doubled_area(*filled));
            REQUIRE(cells.add(*filled, layer));
        }
        REQUIRE(cells.cut(space));
        for (std::size_t i = 0; i < cells.piece_count(); ++i) CHECK((cells[i].below < 32 && cells[i].above < 32));
        contours loops;
        std::int64_t sum = 0;
        for (std::uint32_t label = 1; label < 32; ++label) {
            const auto one = cells.trace({1u << label}, space, loops);
            REQUIRE(one);
            CHECK(doubled_area(*one) == cells.doubled_area({1u << label}));
            CHECK(cells.doubled_area({1u << label}) >= 0);
            CHECK(cells.doubled_area({~(1u << label)}) == -cells.doubled_area({1u << label}));  // of the whole plane
            sum += doubled_area(*one);
            check_region(*one);
        }
        CHECK(sum == cells.doubled_area({~1u}));
        for (std::uint32_t layer = 0; layer < max_layers; ++layer) {
            const auto whole = cells.trace(cells_of_layer(layer), space, loops);
            REQUIRE(whole);
            check_region(*whole);
            // Crossings are rounded: each of the layer's edges moves by less than two cells.
            const std::int64_t length = 7 * 4 * std::int64_t{size} * 2 * 2;
            CHECK(std::abs(doubled_area(*whole) - alone[layer]) <= 2 * length);
        }
    }
}

TEST_CASE("an edge that several sources share names the lowest of them", "[layer_arrangement]")
{
    layer_arrangement cells;
    workspace space;
    cells.begin({});
    add(cells, square(0, 0, 100), 1);
    add(cells, square(0, 0, 50), 0);
    CHECK(cells.source_count() == 8);
    REQUIRE(cells.cut(space));
    for (std::size_t i = 0; i < cells.piece_count(); ++i) {
        const auto s = cells[i];
        const bool on_rim =
            (s.from.x == 0 && s.to.x == 0) || (s.from.y == 0 && s.to.y == 0) || s.to.x > 50 || s.to.y > 50;
        CHECK((s.source.curve < 4) == on_rim);
    }
    std::vector<std::uint32_t> firsts;
    cells.each_source_loop([&](std::uint32_t first, array_view<const grid_point> loop) {
        firsts.push_back(first);
        CHECK(loop.size() == 4);
    });
    CHECK(firsts == std::vector<std::uint32_t>{0, 4});
}

// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/inspect/simplicity.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

using polygon = std::vector<grid_point>;

/// Polygons as one contours object, each edge on a curve of its own.
struct drawn_polygons {
    contours loops;
    buffer<curve> curves;
    workspace space;
    corner_parting parting;

    explicit drawn_polygons(touching corners, memory source = heap()) : loops{source}, curves{source}, space{source}
    {
        loops.grid.units_per_em = 2048.0;
        loops.corners = corners;
    }

    bool add(const polygon& p)
    {
        bool ok = !loops.starts.empty() || loops.starts.push_back(0);
        for (std::size_t i = 0; i < p.size() && ok; ++i) {
            const auto number = static_cast<std::uint32_t>(curves.size());
            ok = loops.points.push_back(p[i]) && loops.edges.push_back({number, 0.0f, 1.0f}) &&
                 curves.push_back(curve::from(loops.grid.place(p[i]), loops.grid.place(p[(i + 1) % p.size()])));
        }
        ok = ok && loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()));
        loops.curves = curves.view();
        loops.forget_order();
        return ok;
    }

    void add_squares(const std::vector<std::array<std::int32_t, 3>>& squares)  // x, y, size
    {
        for (const auto& [x, y, size] : squares)
            REQUIRE(add({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}));
    }

    [[nodiscard]] region fill()
    {
        const auto made = resolve(loops, fill_rule::non_zero, space);
        REQUIRE(made);
        return *made;
    }
    [[nodiscard]] result<region> try_to_part() { return parting(loops, curves, space); }
    [[nodiscard]] region part()
    {
        const auto made = try_to_part();
        REQUIRE(made);
        return *made;
    }
};

std::vector<polygon> loops_of(const region& r)
{
    std::vector<polygon> all;
    for (std::uint32_t k = 0; k < r.loop_count(); ++k)
        all.emplace_back(r.points().begin() + r.starts()[k], r.points().begin() + r.starts()[k + 1]);
    return all;
}

double area(const region& r)
{
    double twice = 0.0;
    for (const polygon& p : loops_of(r)) twice += static_cast<double>(inspect::doubled_area(inspect::loop{p}));
    return 0.5 * twice;
}

/// What must be true of a region without touching corners, found by brute force.
void check_parted(const region& r)
{
    const auto polygons = loops_of(r);
    const std::vector<inspect::loop> loops(polygons.begin(), polygons.end());
    CHECK(inspect::is_region(loops));
    CHECK_FALSE(r.is_touching());
    std::set<std::pair<std::int32_t, std::int32_t>> places;
    for (const grid_point p : r.points()) places.insert({p.x, p.y});
    CHECK(places.size() == r.points().size());
    std::uint32_t holes = 0;
    for (const inspect::loop l : loops) holes += inspect::doubled_area(l) < 0;
    CHECK(r.holes() == holes);
    CHECK(r.outers() == loops.size() - holes);
    for (const contour_edge& e : r.edges()) {
        CHECK(e.curve < r.curves().size());
        CHECK_FALSE(same(e.t0, e.t1));
    }
}

}  // namespace

TEST_CASE("two squares that touch in a corner are parted, or joined", "[corner_parting]")
{
    for (const touching way : {touching::part, touching::join}) {
        drawn_polygons d{way};
        d.add_squares({{0, 0, 1000}, {1000, 1000, 1000}});
        const region before = d.fill();
        REQUIRE(before.is_touching());
        const double drawn = area(before);
        const region after = d.part();
        check_parted(after);
        CHECK(d.parting.corners == 1);
        CHECK_FALSE(d.parting.still_touching);
        // 2^-15 em are 32 cells: each of the two corners loses, or each of the two gaps gains, half of 32 x 32.
        CHECK(same(area(after), drawn + (way == touching::part ? -1024.0 : 1024.0)));
        CHECK(after.outers() == (way == touching::part ? 2u : 1u));
        CHECK(after.points().size() == 10);
    }
}

TEST_CASE("a hole that touches the outer loop opens, or is closed off", "[corner_parting]")
{
    for (const touching way : {touching::part, touching::join}) {
        drawn_polygons d{way};
        REQUIRE(d.add({{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}, {0, 1000}}));
        REQUIRE(d.add({{0, 1000}, {1000, 2000}, {1000, 1000}}));  // clockwise
        const region before = d.fill();
        REQUIRE((before.is_touching() && before.holes() == 0));  // the cycle passes twice
        const region after = d.part();
        check_parted(after);
        CHECK(after.outers() == 1);
        CHECK(after.holes() == (way == touching::part ? 0u : 1u));
    }
}

TEST_CASE("parting keeps contours that do not touch, or that are to be kept", "[corner_parting]")
{
    drawn_polygons apart{touching::part};
    apart.add_squares({{0, 0, 100}, {200, 0, 100}});
    (void)apart.fill();
    const region same_squares = apart.part();
    CHECK(same_squares.points().size() == 8);
    CHECK(same_squares.outers() == 2);
    CHECK(apart.parting.corners == 0);

    drawn_polygons kept{touching::keep};
    kept.add_squares({{0, 0, 100}, {100, 100, 100}});
    (void)kept.fill();
    const region as_drawn = kept.part();
    CHECK(as_drawn.points().size() == 8);
    CHECK(as_drawn.is_touching());
}

TEST_CASE("specks vanish, so that a region may lose all points", "[corner_parting]")
{
    drawn_polygons d{touching::part};
    d.add_squares({{0, 0, 1}, {1, 1, 1}});
    (void)d.fill();
    const region nothing = d.part();
    CHECK(nothing.points().empty());
    CHECK(d.parting.corners == 1);
}

TEST_CASE("a slit that closes between the cells is opened, or filled", "[corner_parting]")
{
    // Two wedges with a slit between them that is one cell wide at its end.
    for (const std::int32_t length : {10, 100, 1000, 30000, 300000, 1 << 26})
        for (const std::int32_t width : {1, 2, 7})
            for (const touching way : {touching::part, touching::join}) {
                drawn_polygons d{way};
                REQUIRE(d.add({{0, 0}, {length, -length / 2}, {length, 0}}));
                REQUIRE(d.add({{0, 0}, {length, width}, {length, length / 2 + width}}));
                const region before = d.fill();
                REQUIRE(before.is_touching());
                const region after = d.part();
                INFO(length << " " << width);
                CHECK_FALSE(d.parting.still_touching);
                if (!d.parting.still_touching) check_parted(after);
            }
}

TEST_CASE("larger diamonds open a slit that is narrow for a thousand cells", "[corner_parting]")
{
    // Its sides meet again where it is half a cell wide: 250, 500, 750 cells from the corner.
    for (const std::int32_t length : {50000, 100000, 150000}) {
        drawn_polygons d{touching::part};
        REQUIRE(d.add({{0, 0}, {length, -length / 2}, {length, 0}}));
        REQUIRE(d.add({{0, 0}, {length, 100}, {length, length / 2}}));
        (void)d.fill();
        const region after = d.part();
        check_parted(after);
        CHECK(after.outers() == 2);  // a filled slit would make it one
        CHECK(after.holes() == 0);
    }
}

TEST_CASE("a corner at the end of the grid stays, and is reported", "[corner_parting]")
{
    constexpr std::int32_t end = (1 << 28) - 1;
    drawn_polygons d{touching::part};
    d.add_squares({{end - 20, 0, 10}, {end - 10, 10, 10}});
    (void)d.fill();
    const region left = d.part();
    CHECK(d.parting.still_touching);
    CHECK(left.is_touching());
    CHECK(same(area(left), 200.0));

    drawn_polygons beyond{touching::part};
    beyond.add_squares({{end - 19, 0, 10}, {end - 9, 10, 10}});
    (void)beyond.fill();
    (void)beyond.part();
    CHECK(beyond.parting.still_touching);
}

TEST_CASE("random grids of squares and triangles touch nowhere after parting", "[corner_parting]")
{
    std::mt19937 random{7};
    int touched = 0;
    for (int run = 0; run < 1500; ++run) {
        const touching way = run % 2 == 0 ? touching::part : touching::join;
        drawn_polygons d{way};
        const std::int32_t across = 2 + static_cast<std::int32_t>(random() % 6);
        const std::int32_t unit = run % 3 == 0   ? 20000
                                  : run % 3 == 1 ? 50
                                                 : 3 + static_cast<std::int32_t>(random() % 9);
        const auto turn = random() % 4;
        const auto at = [&](std::int32_t x, std::int32_t y) {
            x *= unit;
            y *= unit;
            return turn == 0   ? grid_point{x, y}
                   : turn == 1 ? grid_point{x - y, x + y}
                   : turn == 2 ? grid_point{3 * x - y, x + 2 * y}
                               : grid_point{-x, y};
        };
        for (std::int32_t y = 0; y < across; ++y)
            for (std::int32_t x = 0; x < across; ++x) {
                const grid_point a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), e = at(x, y + 1);
                const auto kind = random() % 6;
                if (kind == 0) REQUIRE(d.add({a, b, c, e}));
                if (kind == 1) REQUIRE(d.add({a, b, c}));
                if (kind == 2) REQUIRE(d.add({a, c, e}));
            }
        const region before = d.fill();
        if (!before.is_touching()) continue;
        ++touched;
        const double drawn = area(before);
        const region after = d.part();
        CHECK_FALSE(d.parting.still_touching);
        CHECK(d.parting.corners > 0);
        check_parted(after);
        if (unit == 20000 && turn != 2) {  // edges are cut at whole cells: each corner changes by a diamond
            const double changed = way == touching::part ? drawn - area(after) : area(after) - drawn;
            CHECK(changed > 0.0);
            CHECK(changed <= 2.0 * 32.0 * 32.0 * d.parting.corners);
        }
    }
    CHECK(touched > 900);
}

TEST_CASE("parting survives memory that fails at every request", "[corner_parting]")
{
    for (const touching way : {touching::part, touching::join}) {
        bool done = false;
        for (std::size_t allowed = 0; !done; ++allowed) {
            REQUIRE(allowed < 200);
            test::counting_memory counted;
            drawn_polygons d{way, counted.source()};
            d.add_squares({{0, 0, 1000}, {1000, 1000, 1000}, {2000, 2000, 1000}});
            (void)d.fill();
            d.space.trim();
            counted.fail_at = counted.requests + allowed + 1;
            const auto made = d.try_to_part();
            done = static_cast<bool>(made);
            if (!done) CHECK(made.error() == error::out_of_memory);
            if (done) check_parted(*made);
        }
    }
}

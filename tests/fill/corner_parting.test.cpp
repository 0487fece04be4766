// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/inspect/simplicity.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

using polygon = std::vector<grid_point>;

/// Polygons as one contours, each edge on a curve of its own.
struct drawn_polygons {
    contours loops;
    buffer<curve> curves;
    workspace space;

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

    [[nodiscard]] result<region> fill() { return resolve(loops, fill_rule::non_zero, space); }
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

/// What must hold of a region without corners that touch, found by brute force.
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

polygon square(std::int32_t x, std::int32_t y, std::int32_t size)
{
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

}  // namespace

TEST_CASE("two squares that touch in a corner are parted, or joined", "[corner_parting]")
{
    for (const touching way : {touching::part, touching::join}) {
        drawn_polygons d{way};
        REQUIRE((d.add(square(0, 0, 1000)) && d.add(square(1000, 1000, 1000))));
        const auto before = d.fill();
        REQUIRE(before);
        REQUIRE(before->is_touching());
        const double drawn = area(*before);
        corner_parting parting;
        const auto after = parting(d.loops, d.curves, d.space);
        REQUIRE(after);
        check_parted(*after);
        CHECK(parting.corners == 1);
        CHECK_FALSE(parting.still_touching);
        // 2^-15 em are 32 cells: each of the two corners loses, or each of the two gaps gains, half of 32 x 32.
        CHECK(same(area(*after), drawn + (way == touching::part ? -1024.0 : 1024.0)));
        CHECK(after->outers() == (way == touching::part ? 2u : 1u));
        CHECK(after->points().size() == 10);
    }
}

TEST_CASE("a hole that touches the outer loop opens, or is closed off", "[corner_parting]")
{
    for (const touching way : {touching::part, touching::join}) {
        drawn_polygons d{way};
        REQUIRE(d.add({{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}, {0, 1000}}));
        REQUIRE(d.add({{0, 1000}, {1000, 2000}, {1000, 1000}}));  // clockwise
        const auto before = d.fill();
        REQUIRE((before && before->is_touching() && before->holes() == 0));  // the cycle passes twice
        corner_parting parting;
        const auto after = parting(d.loops, d.curves, d.space);
        REQUIRE(after);
        check_parted(*after);
        CHECK(after->outers() == 1);
        CHECK(after->holes() == (way == touching::part ? 0u : 1u));
    }
}

TEST_CASE("what touches nowhere, and what is to be kept, stays as it is", "[corner_parting]")
{
    drawn_polygons apart{touching::part};
    REQUIRE((apart.add(square(0, 0, 100)) && apart.add(square(200, 0, 100))));
    REQUIRE(apart.fill());
    corner_parting parting;
    const auto same_squares = parting(apart.loops, apart.curves, apart.space);
    REQUIRE(same_squares);
    CHECK(same_squares->points().size() == 8);
    CHECK(same_squares->outers() == 2);
    CHECK(parting.corners == 0);

    drawn_polygons kept{touching::keep};
    REQUIRE((kept.add(square(0, 0, 100)) && kept.add(square(100, 100, 100))));
    REQUIRE(kept.fill());
    const auto as_drawn = parting(kept.loops, kept.curves, kept.space);
    REQUIRE(as_drawn);
    CHECK(as_drawn->points().size() == 8);
    CHECK(as_drawn->is_touching());
}

TEST_CASE("specks vanish, and a region may lose all of its points", "[corner_parting]")
{
    drawn_polygons d{touching::part};
    REQUIRE((d.add(square(0, 0, 1)) && d.add(square(1, 1, 1))));
    REQUIRE(d.fill());
    corner_parting parting;
    const auto nothing = parting(d.loops, d.curves, d.space);
    REQUIRE(nothing);
    CHECK(nothing->points().empty());
    CHECK(parting.corners == 1);
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
                const auto before = d.fill();
                REQUIRE((before && before->is_touching()));
                corner_parting parting;
                const auto after = parting(d.loops, d.curves, d.space);
                REQUIRE(after);
                INFO(length << " " << width);
                CHECK_FALSE(parting.still_touching);
                if (!parting.still_touching) check_parted(*after);
            }
}

TEST_CASE("a slit that is narrow for a thousand cells is opened by larger diamonds", "[corner_parting]")
{
    // Its sides meet again where it is half a cell wide: 250, 500, 750 cells from the corner.
    for (const std::int32_t length : {50000, 100000, 150000}) {
        drawn_polygons d{touching::part};
        REQUIRE(d.add({{0, 0}, {length, -length / 2}, {length, 0}}));
        REQUIRE(d.add({{0, 0}, {length, 100}, {length, length / 2}}));
        REQUIRE(d.fill());
        corner_parting parting;
        const auto after = parting(d.loops, d.curves, d.space);
        REQUIRE(after);
        check_parted(*after);
        CHECK(after->outers() == 2);  // filled, it would be one
        CHECK(after->holes() == 0);
    }
}

TEST_CASE("a corner at the end of the grid is left, and said to be", "[corner_parting]")
{
    constexpr std::int32_t end = (1 << 28) - 1;
    drawn_polygons d{touching::part};
    REQUIRE((d.add(square(end - 20, 0, 10)) && d.add(square(end - 10, 10, 10))));
    REQUIRE(d.fill());
    corner_parting parting;
    const auto left = parting(d.loops, d.curves, d.space);
    REQUIRE(left);
    CHECK(parting.still_touching);
    CHECK(left->is_touching());
    CHECK(same(area(*left), 200.0));

    drawn_polygons beyond{touching::part};
    REQUIRE((beyond.add(square(end - 19, 0, 10)) && beyond.add(square(end - 9, 10, 10))));
    REQUIRE(beyond.fill());
    REQUIRE(parting(beyond.loops, beyond.curves, beyond.space));
    CHECK(parting.still_touching);
}

TEST_CASE("random grids of squares and triangles, turned and sheared, touch nowhere afterwards", "[corner_parting]")
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
        const auto before = d.fill();
        REQUIRE(before);
        if (!before->is_touching()) continue;
        ++touched;
        const double drawn = area(*before);
        corner_parting parting;
        const auto after = parting(d.loops, d.curves, d.space);
        REQUIRE(after);
        CHECK_FALSE(parting.still_touching);
        CHECK(parting.corners > 0);
        check_parted(*after);
        if (unit == 20000 && turn != 2) {  // where edges are cut in cells: what a diamond holds, at each corner
            const double changed = way == touching::part ? drawn - area(*after) : area(*after) - drawn;
            CHECK(changed > 0.0);
            CHECK(changed <= 2.0 * 32.0 * 32.0 * parting.corners);
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
            REQUIRE((d.add(square(0, 0, 1000)) && d.add(square(1000, 1000, 1000)) && d.add(square(2000, 2000, 1000))));
            REQUIRE(d.fill());
            d.space.trim();
            counted.fail_at = counted.requests + allowed + 1;
            corner_parting parting;
            const auto made = parting(d.loops, d.curves, d.space);
            done = static_cast<bool>(made);
            if (!done) CHECK(made.error() == error::out_of_memory);
            if (done) check_parted(*made);
        }
    }
}

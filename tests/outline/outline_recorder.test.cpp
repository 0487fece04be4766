// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/core/grid.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <limits>
#include <vector>

using namespace typemesh;

namespace {

/// Laws of every outline: contours lie one after the other, and each is a closed chain of curves with a length, inside
/// the bounds.
void check_laws(const outline& o)
{
    if (o.curves.empty()) {
        CHECK(o.contour_count() == 0);
        return;
    }
    REQUIRE(o.starts.size() >= 2);
    CHECK(o.starts[0] == 0);
    CHECK(o.starts.back() == o.curves.size());
    for (std::uint32_t k = 0; k < o.contour_count(); ++k) {
        const std::uint32_t first = o.starts[k], end = o.starts[k + 1];
        REQUIRE(first < end);
        for (std::uint32_t i = first; i < end; ++i)
            CHECK(o.curves[i].end() == o.curves[i + 1 < end ? i + 1 : first].start());
    }
    for (const curve& c : o.curves) {
        bool moves = false;
        for (std::uint32_t i = 1; i <= c.degree; ++i) moves = moves || !(c.p[i] == c.p[0]);
        CHECK(moves);
        for (std::uint32_t i = 0; i <= c.degree; ++i) {
            CHECK((c.p[i].x >= o.bounds.low.x && c.p[i].x <= o.bounds.high.x));
            CHECK((c.p[i].y >= o.bounds.low.y && c.p[i].y <= o.bounds.high.y));
        }
    }
}

}  // namespace

TEST_CASE("an outline consists of closed chains of curves", "[outline][outline_recorder]")
{
    outline o;
    outline_recorder pen{o};
    pen.move({0, 0}), pen.line({10, 0}), pen.quadratic({10, 10}, {0, 10}), pen.cubic({-5, 8}, {-5, 2}, {0, 0});
    pen.close();
    pen.move({1, 1}), pen.line({2, 1}), pen.line({2, 2}), pen.close();
    REQUIRE(!pen.finish());
    check_laws(o);
    CHECK(o.contour_count() == 2);
    CHECK(o.curves.size() == 6);  // the second contour got its closing line
    CHECK(o.curves[1].degree == 2);
    CHECK(o.curves[2].degree == 3);
    CHECK(o.bounds.low == point{-5, 0});
    CHECK(o.bounds.high == point{10, 10});
}

TEST_CASE("every curve is kept point for point as drawn", "[outline][outline_recorder]")
{
    outline o;
    outline_recorder pen{o};
    pen.move({0, 0});
    pen.line({10, 1});
    pen.quadratic({12, 5}, {9, 11});
    pen.cubic({7, 13}, {-3, 17}, {-2, 6});  // no two of the four points share a coordinate
    pen.cubic({-2, 6}, {-7, 3}, {-2, 6});   // only the second control point is elsewhere
    REQUIRE(!pen.finish());
    const std::vector<std::vector<point>> drawn = {{{0, 0}, {10, 1}},
                                                   {{10, 1}, {12, 5}, {9, 11}},
                                                   {{9, 11}, {7, 13}, {-3, 17}, {-2, 6}},
                                                   {{-2, 6}, {-2, 6}, {-7, 3}, {-2, 6}},
                                                   {{-2, 6}, {0, 0}}};
    REQUIRE(o.curves.size() == drawn.size());
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        const curve& kept = o.curves[k];
        INFO("curve " << k);
        REQUIRE(kept.degree + 1u == drawn[k].size());
        CHECK((std::vector<point>(kept.p, kept.p + kept.degree + 1) == drawn[k]));
    }
    CHECK(o.bounds.low == point{-7, 0});
    CHECK(o.bounds.high == point{12, 17});
}

TEST_CASE("contours end with close, with the next move, or with the outline", "[outline][outline_recorder]")
{
    outline o;
    outline_recorder pen{o};
    for (int k = 0; k < 3; ++k) {
        pen.move({0, 10.0 * k});
        pen.line({5, 10.0 * k});
        pen.line({5, 10.0 * k + 5});
        if (k == 0) pen.close();
    }
    REQUIRE(!pen.finish());
    check_laws(o);
    CHECK(o.contour_count() == 3);
    CHECK(o.curves.size() == 9);
}

TEST_CASE("curves without length and contours without curves leave nothing", "[outline][outline_recorder]")
{
    outline o;
    outline_recorder pen{o};
    pen.move({0, 0}), pen.close();
    pen.move({1, 1}), pen.line({1, 1}), pen.quadratic({1, 1}, {1, 1}), pen.cubic({1, 1}, {1, 1}, {1, 1}), pen.close();
    pen.close();
    pen.move({2, 2});
    pen.quadratic({3, 3}, {2, 2});  // a loop has a length
    REQUIRE(!pen.finish());
    check_laws(o);
    CHECK(o.contour_count() == 1);
    CHECK(o.curves.size() == 1);
}

TEST_CASE("bounds and grid depend only on curves, not on contours without any", "[outline][outline_recorder]")
{
    const auto drawn = [](auto&& beside) {
        outline o;
        outline_recorder pen{o};
        beside(pen);
        pen.move({0, 0}), pen.line({10, 0}), pen.quadratic({12, 5}, {10, 10});
        beside(pen);
        pen.move({-3, 2}), pen.cubic({-3, 4}, {-4, 4}, {-4, 2}), pen.close();
        beside(pen);
        REQUIRE(!pen.finish());
        check_laws(o);
        CHECK(o.contour_count() == 2);
        CHECK(o.bounds.low == point{-4, 0});
        CHECK(o.bounds.high == point{12, 10});
        const auto fitting = grid::fitting(1000.0, o.bounds);
        REQUIRE(fitting);
        CHECK(fitting->cells == 512.0);
    };
    for (const point far : {point{1e9, 0}, point{-1e22, 1e22}, point{5, -1e300}}) {
        drawn([&](outline_recorder& pen) { pen.move(far); });
        drawn([&](outline_recorder& pen) { pen.move(far), pen.close(); });
        drawn([&](outline_recorder& pen) { pen.move(far), pen.line(far), pen.cubic(far, far, far), pen.close(); });
    }
}

TEST_CASE("a recorder first empties its outline", "[outline][outline_recorder]")
{
    outline o;
    for (int round = 0; round < 2; ++round) {
        outline_recorder pen{o};
        pen.move({0, 0}), pen.line({1, 0}), pen.line({0, 1});
        REQUIRE(!pen.finish());
        CHECK(o.curves.size() == 3);
    }
    outline_recorder nothing{o};
    CHECK(!nothing.finish());
    CHECK(o.curves.empty());
    CHECK(o.bounds.empty());
}

TEST_CASE("a segment without a contour is a bad outline", "[outline][outline_recorder]")
{
    outline o;
    outline_recorder early{o};
    early.line({1, 1}), early.move({0, 0});
    CHECK(early.finish() == error::bad_outline);
    outline_recorder late{o};
    late.move({0, 0}), late.line({1, 0}), late.close(), late.quadratic({1, 1}, {0, 0});
    CHECK(late.finish() == error::bad_outline);
}

TEST_CASE("a recorder reports any coordinate that is not finite", "[outline][outline_recorder]")
{
    const double bad = GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity());
    for (int where = 0; where < 14; ++where) {
        double v[14] = {0, 0, 10, 0, 10, 5, 5, 5, 4, 4, 3, 3, 0, 3};
        v[where] = bad;
        outline o;
        outline_recorder pen{o};
        pen.move({v[0], v[1]}), pen.line({v[2], v[3]}), pen.quadratic({v[4], v[5]}, {v[6], v[7]});
        pen.cubic({v[8], v[9]}, {v[10], v[11]}, {v[12], v[13]}), pen.close();
        CHECK(pen.finish() == error::outline_not_finite);
    }
}

TEST_CASE("a recorder takes at most as many curves as allowed", "[outline][outline_recorder]")
{
    for (std::uint32_t most = 0; most <= 8; ++most) {
        outline o;
        outline_recorder pen{o, most};
        for (double x = 0.0; x < 2.0; ++x) pen.move({x, 0}), pen.line({x + 1, 0}), pen.line({x, 1}), pen.close();
        const error e = pen.finish();
        INFO(most << " of 6 curves allowed");
        CHECK(bool(e) == (most < 6));
        CHECK(o.curves.size() == (most < 6 ? most : 6));
        if (e) CHECK((e == error::too_many_points && e.count == most));
    }
}

TEST_CASE("a recorder reports that memory ran out", "[outline][outline_recorder]")
{
    for (std::size_t at = 1; at <= 3; ++at) {
        test::counting_memory failing{.fail_at = at};
        {
            outline o{failing.source()};
            outline_recorder pen{o};
            for (double y = 0.0; y < 400.0; y += 10.0)
                pen.move({0, y}), pen.line({5, y}), pen.line({5, y + 5}), pen.close();
            CHECK(pen.finish() == error::out_of_memory);
        }
        CHECK(failing.bytes_held == 0);
    }
}

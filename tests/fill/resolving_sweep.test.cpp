// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/resolving_sweep.hpp>

#include "fill/taken_apart.hpp"

#include <map>

using namespace typemesh;

namespace {

/// What is wrong with an arrangement that a sweep trusts, or nothing.
///
/// No two segments may share more than an end, the turns must be the turns of closed contours, and the winding number
/// below each must equal the count along a ray just below its middle.
std::string mistake_in(const detail::arrangement& a)
{
    std::vector<detail::segment> all;
    for (std::uint32_t i = 0; i < a.count; ++i)
        if (a.segments[i].winding_delta != 0) all.push_back(a.segments[i]);
    std::map<std::int64_t, int> closed;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const detail::segment& s = all[i];
        if (!lexicographic_less(s.from, s.to)) return "a segment runs to the left";
        closed[detail::sweep_place(s.from)] += s.winding_delta;
        closed[detail::sweep_place(s.to)] -= s.winding_delta;
        for (std::size_t k = i + 1; k < all.size(); ++k) {
            const detail::segment& o = all[k];
            if (!test::oracle::meet(s.from, s.to, o.from, o.to)) continue;
            const bool aa = s.from == o.from, ab = s.from == o.to, ba = s.to == o.from, bb = s.to == o.to;
            if (aa + ab + ba + bb != 1) return "two segments meet";
            const grid_point p = aa || ab ? s.from : s.to, q = aa || ab ? s.to : s.from, r = aa || ba ? o.to : o.from;
            if (test::oracle::lies_on(q, p, r) || test::oracle::lies_on(r, p, q)) return "two segments overlap";
        }
        if (s.from.x == s.to.x) continue;  // below an upright one is right of it
        // Straight down from its middle (doubled coordinates): every segment below it counts.
        const grid_point middle{s.from.x + s.to.x, s.from.y + s.to.y};
        std::int32_t winding = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const grid_point from{2 * all[k].from.x, 2 * all[k].from.y}, to{2 * all[k].to.x, 2 * all[k].to.y};
            if (k != i && from.x <= middle.x && middle.x < to.x && test::oracle::side(from, to, middle) > 0)
                winding += all[k].winding_delta;
        }
        if (winding != s.below) return "a winding number is wrong";
    }
    for (const auto& [place, turns] : closed)
        if (turns != 0) return "contours are open";
    return {};
}

}  // namespace

TEST_CASE("A sweep trusts only closed contours that meet at their ends, and finds their winding numbers",
          "[fill][resolving_sweep]")
{
    test::dice d{91};
    int believed = 0, bent = 0;
    for (int i = 0; i < 40'000; ++i) {
        const int kind = d.roll(4), width = 4 + d.roll(60), length = 20 + d.roll(2000);
        const test::shape s = test::random_polylines(d, 1 + d.roll(2), 3, 5, [&](const test::polyline&, int n) {
            if (kind == 2) return grid_point{(n % 2) * length + d.roll(4), d.roll(9)};
            const std::int32_t x = d.roll(kind < 2 ? width : 3);
            return grid_point{x, d.roll(kind < 2 ? width : length)};
        });
        taken_apart apart{s.loops, 500};
        detail::arrangement& a = apart.a;
        for (int round = 0; round < 4; ++round) {
            detail::resolving_sweep sweep{a, d.roll(2) == 0 ? fill_rule::non_zero : fill_rule::even_odd};
            REQUIRE(sweep.run(apart.space));
            if (sweep.again) continue;
            ++believed;
            for (std::uint32_t k = 0; k < a.count; ++k) bent += a.segments[k].bent != 0 && round == 0;
            INFO(s);
            CHECK(mistake_in(a) == "");
            break;
        }
    }
    CHECK(believed > 10'000);
    CHECK(bent > 2000);  // in those that needed one sweep: the shortcut is taken
}

TEST_CASE("Contours of ordinary size nearly always need one sweep, with every crossing bent", "[fill][resolving_sweep]")
{
    test::dice d{92};
    int once = 0;
    for (int i = 0; i < 500; ++i) {
        std::vector<test::polyline> given;
        for (int c = 0; c < 4; ++c)
            given.push_back(test::circle(20 + d.roll(40), 100'000 + d.roll(200'000), d.roll(300'000), d.roll(300'000)));
        taken_apart apart{given, 2000};
        detail::resolving_sweep sweep{apart.a, fill_rule::non_zero};
        REQUIRE(sweep.run(apart.space));
        once += !sweep.again;
    }
    CHECK(once >= 450);
}

TEST_CASE("A sweep without capacity reports it and leaves closed contours", "[fill][resolving_sweep]")
{
    test::polyline star;
    for (int i = 0; i < 31; ++i) star.push_back(test::on_circle(0, 0, 10'000, test::turn_once * i * 13 / 31));
    for (std::uint32_t room = 31; room < 200; room += 13) {
        taken_apart apart{{star}, room};
        detail::arrangement& a = apart.a;
        detail::resolving_sweep sweep{a, fill_rule::non_zero};
        REQUIRE(sweep.run(apart.space));
        CHECK(sweep.full);
        CHECK(sweep.again);
        CHECK(a.count <= room);
        std::map<std::int64_t, int> closed;
        for (std::uint32_t i = 0; i < a.count; ++i) {
            closed[detail::sweep_place(a.segments[i].from)] += a.segments[i].winding_delta;
            closed[detail::sweep_place(a.segments[i].to)] -= a.segments[i].winding_delta;
        }
        for (const auto& [place, turns] : closed) CHECK(turns == 0);
    }
}

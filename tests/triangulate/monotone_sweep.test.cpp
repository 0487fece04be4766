// SPDX-License-Identifier: MIT

// What the sweep proves of loops that may pass through a point more than once.

#include <typemesh/fill/resolve.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

constexpr int fine = 1024;  // so that a place right beside the middle of an edge is a grid point

/// Whether loops of small coordinates are boundary cycles with the interior on the left, by brute force.
bool is_touching_region(const std::vector<test::oracle::loop>& loops)
{
    if (!test::oracle::broken_cycle(loops).empty()) return false;
    std::vector<test::polyline> large;
    for (const auto l : loops) {
        large.emplace_back();
        for (const grid_point p : l) large.back().push_back({p.x * fine, p.y * fine});
    }
    const std::vector<test::oracle::loop> views{large.begin(), large.end()};
    for (const auto l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            const grid_point middle{(a.x + b.x) * fine / 2, (a.y + b.y) * fine / 2};
            const grid_point aside{a.y - b.y, b.x - a.x};
            if (test::oracle::winding(views, {middle.x + aside.x, middle.y + aside.y}) != 1) return false;
            if (test::oracle::winding(views, {middle.x - aside.x, middle.y - aside.y}) != 0) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("prove_touching() accepts the same random polylines as the oracle", "[triangulate][monotone_sweep]")
{
    test::dice d{411};
    int accepted = 0, touching = 0;
    for (int i = 0; i < 400'000; ++i) {
        const int width = 3 + d.roll(4), count = 1 + d.roll(3), most = count == 1 ? 10 : 5;
        const test::shape s = test::random_polylines(d, count, 3, most - 2, width);
        const contours loops = test::contours_of(s);
        workspace space;
        triangle_list out;
        const auto proven = monotone{}.prove_touching(loops, space, out);
        INFO(s);
        REQUIRE(bool(proven) == is_touching_region(test::loops_of(s)));
        if (!proven) {
            REQUIRE(proven.error() == error::crossing_contours);
            REQUIRE(out.empty());
            continue;
        }
        ++accepted;
        touching += proven->is_touching();
        REQUIRE(test::oracle::broken_law(*proven, out.view()) == "");
        REQUIRE(proven->is_touching() != bool(monotone{}.prove(loops, space, out)));
    }
    CHECK(accepted > 1000);
    CHECK(touching > 100);
}

TEST_CASE("prove_touching() accepts what resolve() makes, and cuts it as without a proof",
          "[triangulate][monotone_sweep]")
{
    test::dice d{412};
    int touching = 0;
    for (int i = 0; i < 10'000; ++i) {
        const int width = 3 + d.roll(8), scale = 1 << d.roll(10), count = 1 + d.roll(4);
        const test::shape s = test::random_polylines(d, count, 3, 12, width, scale);
        contours loops = test::contours_of(s);
        workspace space;
        const auto made = resolve(loops, fill_rule::even_odd, space);
        INFO(s);
        REQUIRE(made);
        triangle_list proving, trusting, delaunay;
        const auto proven = monotone{}.prove_touching(loops, space, proving);
        REQUIRE(proven);
        CHECK(proven->holes() == made->holes());
        CHECK(proven->outers() == made->outers());
        CHECK(proven->is_touching() == made->is_touching());
        touching += made->is_touching();
        REQUIRE_FALSE(monotone{}(*made, space, trusting));
        CHECK(std::ranges::equal(proving, trusting));
        CHECK(constrained_delaunay{}.prove_touching(loops, space, delaunay));
        CHECK(delaunay.size() == trusting.size());
    }
    CHECK(touching > 2000);
}

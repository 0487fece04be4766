// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/ray.hpp>
#include <typemesh/fill/impl/swept_edge.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

TEST_CASE("A swept edge holds the points of its box, in every direction", "[fill][swept_edge]")
{
    test::dice d{51};
    for (int i = 0; i < 3000; ++i) {
        grid_point a{d.roll(9), d.roll(9)}, b{d.roll(9), d.roll(9)};
        if (lexicographic_less(b, a)) std::swap(a, b);
        const detail::swept_edge e{a, b, 3, 7};
        CHECK(e.segment == 3);
        CHECK(e.above == 7);
        CHECK_FALSE(e.is_bent);
        const grid_point p{d.roll(9), d.roll(9)};
        CHECK(e.holds(p) == ((std::min)(a.x, b.x) <= p.x && p.x <= (std::max)(a.x, b.x) &&
                             (std::min)(a.y, b.y) <= p.y && p.y <= (std::max)(a.y, b.y)));
    }
}

TEST_CASE("reach() is the orientation of a point one cell off, and a bend within it changes no side",
          "[fill][swept_edge]")
{
    test::dice d{52};
    int bent = 0;
    for (int i = 0; i < 200'000; ++i) {
        const grid_point a{0, 0}, b{1 + d.roll(40), d.roll(81) - 40};
        const detail::swept_edge e{a, b, 0, 0};
        CHECK(e.reach() == std::abs(orientation(a, b, {a.x + 1, a.y + (b.y < 0 ? 1 : -1)})));
        const grid_point x{d.roll(b.x + 1), (b.y < 0 ? b.y : 0) + d.roll(std::abs(b.y) + 1)};
        const grid_point p{d.roll(b.x + 1), d.roll(121) - 60};
        const std::int64_t off = orientation(a, b, x), side = orientation(a, b, p);
        if (std::abs(off) > e.reach() || std::abs(side) <= e.reach()) continue;
        if (!lexicographic_less(a, p) || !lexicographic_less(p, x))
            continue;  // the sweep passed it before it reached x
        ++bent;
        CHECK((orientation(a, x, p) > 0) == (side > 0));
        CHECK(orientation(a, x, p) != 0);
    }
    CHECK(bent > 2000);
}

TEST_CASE("Rays are sorted from below to above, and equal ones by number", "[fill][ray]")
{
    test::dice d{53};
    for (const int count : {1, 2, 5, 16, 17, 100}) {
        for (int run = 0; run < 50; ++run) {
            std::vector<detail::ray> rays;
            for (int i = 0; i < count; ++i) {
                const std::int32_t x = d.roll(6), y = x == 0 ? 1 + d.roll(3) : d.roll(11) - 5;
                rays.push_back({x, y, static_cast<std::uint32_t>(i)});
            }
            detail::sort_rays(rays.data(), static_cast<std::uint32_t>(rays.size()));
            for (std::size_t i = 1; i < rays.size(); ++i) {
                const double below = std::atan2(rays[i - 1].y, rays[i - 1].x), above = std::atan2(rays[i].y, rays[i].x);
                if (std::fabs(below - above) < 1e-12)
                    CHECK(rays[i - 1].segment < rays[i].segment);
                else
                    CHECK(below < above);
            }
        }
    }
}

TEST_CASE("An edge is far from its neighbour if the whole cell round the neighbour's end lies on one side",
          "[fill][swept_edge]")
{
    test::dice d{53};
    int far_off = 0, near_by = 0;
    for (int i = 0; i < 20'000; ++i) {
        const detail::swept_edge low{{0, d.roll(9)}, {10 + d.roll(20), d.roll(60) - 30}, 0, 0};
        const detail::swept_edge high{{d.roll(9), 5 + d.roll(9)}, {10 + d.roll(20), d.roll(60) - 30}, 0, 0};
        const bool low_first = lexicographic_less(low.to, high.to);
        const detail::swept_edge& longer = low_first ? high : low;
        const grid_point end = low_first ? low.to : high.to;
        bool apart = true;
        for (const int x : {-1, 1})
            for (const int y : {-1, 1}) {
                const std::int64_t side = orientation(longer.from, longer.to, {end.x + x, end.y + y});
                apart = apart && (low_first ? side < 0 : side > 0);
            }
        CHECK(detail::is_far(low, high) == apart);
        ++(apart ? far_off : near_by);
    }
    CHECK((far_off > 4000 && near_by > 4000));
}

// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/ring_cutter.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <cstdint>
#include <set>
#include <utility>

using namespace typemesh;

namespace {

struct cut {
    buffer<std::uint32_t> ring;
    buffer<swept_node> nodes;
    triangle_list triangles;
    error failed;

    explicit cut(const test::polyline& polygon, memory source = heap()) : triangles{source}
    {
        constexpr std::uint32_t elsewhere = 5;  // nodes outside the ring
        for (std::uint32_t i = 0; i < elsewhere; ++i) REQUIRE(nodes.push_back({polygon[0]}));
        for (const grid_point p : polygon) {
            REQUIRE(ring.push_back(static_cast<std::uint32_t>(nodes.size())));
            REQUIRE(nodes.push_back({p}));
        }
        detail::ring_cutter cutter{source};
        failed = cutter(ring, nodes, triangles);
    }
};

std::int64_t doubled_area(const test::polyline& l)
{
    std::int64_t sum = 0;
    for (std::size_t i = 2; i < l.size(); ++i) sum += orientation(l[0], l[i - 1], l[i]);
    return sum;
}

/// All triangles are counter-clockwise, and their common boundary is the ring.
void check_cut(const test::polyline& polygon)
{
    const cut c{polygon};
    REQUIRE(!c.failed);
    REQUIRE(c.triangles.size() == polygon.size() - 2);
    std::int64_t area = 0;
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> open;
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
        const auto reverse = open.find({b, a});
        if (reverse != open.end())
            open.erase(reverse);
        else
            open.emplace(a, b);
    };
    for (const triangle t : c.triangles) {
        const std::int64_t size = orientation(c.nodes[t.a].at, c.nodes[t.b].at, c.nodes[t.c].at);
        if (size <= 0) CHECK(size > 0);
        area += size;
        add(t.a, t.b);
        add(t.b, t.c);
        add(t.c, t.a);
    }
    CHECK(area == doubled_area(polygon));
    for (std::size_t i = 0; i < c.ring.size(); ++i) add(c.ring[i + 1 == c.ring.size() ? 0 : i + 1], c.ring[i]);
    CHECK(open.empty());
}

/// Whether a ring is refused and leaves no triangles.
bool is_refused(const test::polyline& polygon)
{
    const cut c{polygon};
    return c.failed == error::crossing_contours && c.triangles.empty();
}

/// A mountain of n + 1 corners over an edge: an arch, or one that rises and falls at random.
test::polyline mountain(int n, bool round, std::uint64_t seed)
{
    test::dice d{seed};
    test::polyline l{{0, 0}, {4 * n, 0}};
    for (int i = n - 1; i > 0; --i) {
        const std::int64_t bow = std::int64_t{i} * (n - i) / n;
        l.push_back({4 * i, static_cast<std::int32_t>(round ? 1 + bow : 1 + d.roll(i % 2 == 0 ? n : 8))});
    }
    return l;
}

}  // namespace

TEST_CASE("simple rings are cut into counter-clockwise triangles that cover them once", "[offset][ring_cutter]")
{
    for (int n = 3; n < 12; ++n) check_cut(test::circle(n, 1000));
    check_cut(test::comb(40));
    check_cut(test::staircase(30));
    check_cut(test::spiral(200, 3.3, 1000));
    for (std::uint64_t seed = 1; seed < 20; ++seed) check_cut(test::star(200, 1'000'000, seed));
    check_cut(test::square(-(1 << 28), -(1 << 28), 1 << 29));

    test::dice d{1};
    int simple = 0;
    for (int i = 0; i < 4000; ++i) {
        const int width = 3 + d.roll(40);
        test::polyline l = test::random_polygon(3 + d.roll(20), width, d);
        if (test::oracle::is_crossing({l})) continue;
        if (doubled_area(l) < 0) l = test::reversed(l);
        check_cut(l);
        ++simple;
    }
    CHECK(simple > 1000);
}

TEST_CASE("points on a straight edge stay corners of triangles that are not flat", "[offset][ring_cutter]")
{
    check_cut({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {0, 3}});
    check_cut({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 1}});
    check_cut({{2, 0}, {3, 0}, {4, 0}, {2, 1}, {0, 0}, {1, 0}});
}

TEST_CASE("mountains of a hundred thousand corners are cut in one pass", "[offset][ring_cutter]")
{
    // A search for ears would take 10^10 steps.
    for (const bool round : {false, true}) check_cut(mountain(100'000, round, 2));
}

TEST_CASE("rings that are not simple and counter-clockwise are refused, and add no triangles", "[offset][ring_cutter]")
{
    CHECK(is_refused({{0, 0}, {0, 4}, {4, 0}}));                            // clockwise
    CHECK(is_refused(test::reversed(test::star(50, 10'000, 3))));           //
    CHECK(is_refused({{0, 0}, {1, 1}, {2, 2}}));                            // flat
    CHECK(is_refused({{0, 0}, {2, 0}, {4, 0}, {1, 0}}));                    //
    CHECK(is_refused({{0, 0}, {4, 4}, {4, 0}, {0, 4}}));                    // crosses itself
    CHECK(is_refused({{0, 0}, {9, 0}, {9, 9}, {4, -3}, {2, -3}, {0, 9}}));  // dips through its base
    test::dice d{4};
    int crossing = 0;
    for (int i = 0; i < 4000; ++i) {
        test::polyline l;
        for (int n = 4 + d.roll(8); n > 0; --n) l.push_back({d.roll(30), d.roll(30)});
        if (doubled_area(l) > 0) continue;  // counter-clockwise triangles have more
        CHECK(is_refused(l));
        ++crossing;
    }
    CHECK(crossing > 1000);
}

TEST_CASE("a ring cutter keeps the triangles of earlier rings", "[offset][ring_cutter]")
{
    cut c{test::square(0, 0, 9)};
    const triangle first = c.triangles[0];
    detail::ring_cutter cutter{heap()};
    buffer<std::uint32_t> turned;
    for (std::size_t i = c.ring.size(); i-- != 0;) REQUIRE(turned.push_back(c.ring[i]));
    CHECK(cutter(turned, c.nodes, c.triangles) == error::crossing_contours);
    CHECK(c.triangles.size() == 2);
    REQUIRE(!cutter(c.ring, c.nodes, c.triangles));
    CHECK(c.triangles.size() == 4);
    CHECK((c.triangles[0].a == first.a && c.triangles[0].b == first.b && c.triangles[0].c == first.c));
}

TEST_CASE("a ring cutter reports that memory ran out", "[offset][ring_cutter]")
{
    for (std::size_t fail_at = 1; fail_at <= 2; ++fail_at) {
        test::counting_memory limited{.fail_at = fail_at};
        CHECK(cut{test::circle(100, 1000), limited.source()}.failed == error::out_of_memory);
    }
}

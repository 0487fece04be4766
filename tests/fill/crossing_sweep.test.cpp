// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/crossing_sweep.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <array>
#include <vector>

using namespace typemesh;
using detail::net_edge;

namespace {

__extension__ using int128 = __int128;

struct met {
    grid_point nearest;
    bool is_exact;
    friend bool operator<(const met& a, const met& b)
    {
        return std::array{a.nearest.x, a.nearest.y, std::int32_t{a.is_exact}} <
               std::array{b.nearest.x, b.nearest.y, std::int32_t{b.is_exact}};
    }
    friend bool operator==(const met& a, const met& b) { return a.nearest == b.nearest && a.is_exact == b.is_exact; }
};

/// from + part / whole * step, rounded to the nearest; halves go up, as pixels are half open.
std::int32_t rounded(std::int32_t from, int128 part, int128 whole, std::int64_t step, bool& exact)
{
    if (whole < 0) whole = -whole, part = -part;
    const int128 twice = 2 * part * step + whole;  // (2 part step / whole + 1) / 2, rounded down
    int128 q = twice / (2 * whole);
    if (twice % (2 * whole) < 0) --q;
    exact = exact && part * step % whole == 0;
    return static_cast<std::int32_t>(from + static_cast<std::int64_t>(q));
}

/// Every two edges that cross between their ends, found by a trial of all pairs.
std::vector<met> all_pairs(const std::vector<net_edge>& edges)
{
    std::vector<met> all;
    const auto sign = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const net_edge &e = edges[i], &f = edges[k];
            const std::int64_t a = orientation(f.from, f.to, e.from), b = orientation(f.from, f.to, e.to);
            if (sign(a) * sign(b) >= 0 ||
                sign(orientation(e.from, e.to, f.from)) * sign(orientation(e.from, e.to, f.to)) >= 0)
                continue;
            bool exact = true;
            const grid_point at{rounded(e.from.x, a, int128{a} - b, std::int64_t{e.to.x} - e.from.x, exact),
                                rounded(e.from.y, a, int128{a} - b, std::int64_t{e.to.y} - e.from.y, exact)};
            all.push_back({at, exact});
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Edges as net_edges makes them: directed, all different, in the order of their starts.
std::vector<net_edge> random_edges(test::dice& d, int n, std::int32_t width)
{
    std::vector<net_edge> edges;
    for (int i = 0; i < n; ++i) {
        grid_point p{d.roll(width) - width / 2, d.roll(width) - width / 2},
            q{d.roll(width) - width / 2, d.roll(width) - width / 2};
        if (p == q) continue;
        if (lexicographic_less(q, p)) std::swap(p, q);
        const bool twice =
            std::any_of(edges.begin(), edges.end(), [&](const net_edge& e) { return e.from == p && e.to == q; });
        if (!twice) edges.push_back({p, q, 0, 0, 1});
    }
    std::sort(edges.begin(), edges.end(),
              [](const net_edge& a, const net_edge& b) { return lexicographic_less(a.from, b.from); });
    return edges;
}

std::vector<met> swept(const std::vector<net_edge>& edges)
{
    std::vector<met> all;
    workspace space, other;
    workspace::scope scratch{space};
    REQUIRE(detail::crossing_sweep::run(edges, scratch, other, [&](grid_point x, bool is_exact) {
        all.push_back({x, is_exact});
        return true;
    }));
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("a crossing sweep finds every crossing once, with its nearest grid point", "[fill][crossing_sweep]")
{
    test::dice d{41};
    std::size_t crossings = 0;
    for (int round = 0; round < 4000; ++round) {
        const std::int32_t widths[] = {4, 8, 30, 1000, 1 << 29};
        const std::vector<net_edge> edges = random_edges(d, 1 + d.roll(25), widths[d.roll(5)]);
        const std::vector<met> wanted = all_pairs(edges);
        REQUIRE((swept(edges) == wanted));
        crossings += wanted.size();
    }
    CHECK(crossings > 50'000);
}

TEST_CASE("a crossing sweep stops when its callback does, and reports that memory ran out", "[fill][crossing_sweep]")
{
    test::dice d{42};
    const std::vector<net_edge> edges = random_edges(d, 30, 1000);
    REQUIRE(all_pairs(edges).size() > 10);
    workspace space, other;
    workspace::scope scratch{space};
    int calls = 0;
    CHECK_FALSE(detail::crossing_sweep::run(edges, scratch, other, [&](grid_point, bool) { return ++calls < 4; }));
    CHECK(calls == 4);

    test::counting_memory failing{.fail_at = 1};
    workspace nothing{failing.source()};
    workspace::scope none{nothing};
    CHECK_FALSE(detail::crossing_sweep::run(edges, none, other, [](grid_point, bool) { return true; }));
}

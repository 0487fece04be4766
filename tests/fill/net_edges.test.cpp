// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/net_edges.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

using namespace typemesh;

namespace {

using ends = std::array<std::int32_t, 4>;

struct both_ends {
    std::int32_t winding_delta = 0;
    std::uint32_t lowest_curve = ~0u;
};

/// Random closed polylines on a tiny grid, with many edges on each other.
test::shape random_loops(test::dice& d)
{
    test::shape s{"random", {}};
    for (int c = 1 + d.roll(4); c > 0; --c) {
        test::polyline l;
        for (int n = 3 + d.roll(7); n > 0; --n) {
            const grid_point p{d.roll(4), d.roll(4)};
            if (l.empty() || !(l.back() == p)) l.push_back(p);
        }
        if (l.size() >= 3) s.loops.push_back(l);
    }
    return s;
}

/// The contours' edges counted between the same two points, except for those that a rule ignores.
std::map<ends, both_ends> counted(const contours& c, fill_rule rule)
{
    std::map<ends, both_ends> all;
    for (std::uint32_t l = 0; l < c.contour_count(); ++l) {
        for (std::uint32_t v = c.starts[l]; v < c.starts[l + 1]; ++v) {
            grid_point p = c.points[v], q = c.points[v + 1 == c.starts[l + 1] ? c.starts[l] : v + 1];
            if (p == q) continue;
            const bool along = lexicographic_less(p, q);
            if (!along) std::swap(p, q);
            both_ends& e = all[{p.x, p.y, q.x, q.y}];
            e.winding_delta += along ? 1 : -1;
            e.lowest_curve = (std::min)(e.lowest_curve, c.edges[v].curve);
        }
    }
    std::erase_if(all, [&](const auto& e) {
        return rule == fill_rule::even_odd ? e.second.winding_delta % 2 == 0 : e.second.winding_delta == 0;
    });
    return all;
}

}  // namespace

TEST_CASE("net edges are the contours' edges counted between the same two points", "[fill][net_edges]")
{
    test::dice d{51};
    for (int round = 0; round < 5000; ++round) {
        const test::shape s = random_loops(d);
        contours c = test::contours_of(s);
        workspace space;
        REQUIRE(sort_points(c, space));
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            const auto wanted = counted(c, rule);
            std::vector<detail::net_edge> edges(c.points.size());
            std::uint32_t count = 0;
            REQUIRE(make_net_edges(c, rule, space, edges.data(), count));
            INFO(s);
            REQUIRE(count == wanted.size());
            for (std::uint32_t i = 0; i < count; ++i) {
                const detail::net_edge& e = edges[i];
                if (i > 0) REQUIRE_FALSE(lexicographic_less(e.from, edges[i - 1].from));
                const auto found = wanted.find({e.from.x, e.from.y, e.to.x, e.to.y});
                REQUIRE(found != wanted.end());
                REQUIRE(e.winding_delta == found->second.winding_delta);
                REQUIRE(c.edges[e.origin].curve == found->second.lowest_curve);
                const grid_point p = c.points[e.origin], q = c.points[e.target];
                REQUIRE(((p == e.from && q == e.to) || (p == e.to && q == e.from)));
            }
        }
    }
}

TEST_CASE("a winding mask keeps the winding numbers that a rule fills", "[fill][net_edges]")
{
    for (std::int32_t w = -5; w <= 5; ++w)
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd})
            CHECK(((w & detail::winding_mask(rule)) != 0) == is_filled(rule, w));
}

TEST_CASE("net edges report that memory ran out", "[fill][net_edges]")
{
    contours c = test::contours_of(test::generated_regions().back());
    workspace sorting;
    REQUIRE(sort_points(c, sorting));
    test::counting_memory failing{.fail_at = 1};
    workspace space{failing.source()};
    std::vector<detail::net_edge> edges(c.points.size());
    std::uint32_t count = 7;
    CHECK_FALSE(make_net_edges(c, fill_rule::non_zero, space, edges.data(), count));
    CHECK(count == 0);
}

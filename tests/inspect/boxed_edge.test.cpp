// SPDX-License-Identifier: MIT

#include <typemesh/inspect/impl/boxed_edge.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <set>
#include <utility>

using namespace typemesh;
using namespace typemesh::inspect;

TEST_CASE("the close pairs of edges are the pairs whose boxes have a common point, each once", "[inspect][boxed_edge]")
{
    test::dice d{15};
    for (int round = 0; round < 300; ++round) {
        std::vector<test::polyline> lines;
        for (int n = 1 + d.roll(3); n > 0; --n) {
            lines.emplace_back();
            for (int k = 1 + d.roll(12); k > 0; --k) lines.back().push_back({d.roll(20), d.roll(20)});
        }
        const std::vector<loop> loops{lines.begin(), lines.end()};
        const std::vector<boxed_edge> edges = boxed_edges(loops);
        std::set<std::pair<std::size_t, std::size_t>> wanted, met;
        std::size_t points = 0;
        for (const loop l : loops) points += l.size();
        REQUIRE(edges.size() == points);
        for (const boxed_edge& p : edges) {
            REQUIRE(p.a == loops[p.loop][p.index]);
            REQUIRE(p.b == loops[p.loop][(p.index + 1) % loops[p.loop].size()]);
            for (const boxed_edge& q : edges) {
                bool common = false;
                for (std::int32_t x = 0; x < 20; ++x)
                    for (std::int32_t y = 0; y < 20; ++y) {
                        const auto holds = [&](const boxed_edge& e) {
                            return x >= (std::min)(e.a.x, e.b.x) && x <= (std::max)(e.a.x, e.b.x) &&
                                   y >= (std::min)(e.a.y, e.b.y) && y <= (std::max)(e.a.y, e.b.y);
                        };
                        common = common || (holds(p) && holds(q));
                    }
                if (p.number < q.number && common) wanted.insert({p.number, q.number});
            }
        }
        REQUIRE(each_close_pair(edges, [&](const boxed_edge& p, const boxed_edge& q) {
            REQUIRE(met.insert({(std::min)(p.number, q.number), (std::max)(p.number, q.number)}).second);
            return true;
        }));
        REQUIRE(met == wanted);
        if (wanted.empty()) continue;
        int calls = 0;
        CHECK_FALSE(each_close_pair(edges, [&](const boxed_edge&, const boxed_edge&) { return ++calls, false; }));
        CHECK(calls == 1);
    }
}

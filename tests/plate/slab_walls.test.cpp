// SPDX-License-Identifier: MIT
#include <typemesh/plate/impl/slab_walls.hpp>

#include "support/catch.hpp"

#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

using namespace typemesh;
using detail::slab_walls;

TEST_CASE("the triangles between any two columns are a disc whose border is the wall's", "[slab_walls]")
{
    for (std::uint32_t from = 0; from < 32; ++from)
        for (std::uint32_t to = 0; to < 32; ++to) {
            const slab_walls::wall w{1, from << 1 | 65u, to << 1 | 65u};  // levels 0 and 6 are in both
            std::vector<std::uint32_t> height;
            w.each_height(w.at_from, [&](std::uint32_t level) { height.push_back(level); });
            const std::uint32_t second = static_cast<std::uint32_t>(height.size());
            w.each_height(w.at_to, [&](std::uint32_t level) { height.push_back(level); });
            CHECK(w.vertex_count() == height.size());
            std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
            std::uint32_t triangles = 0;
            std::int64_t doubled = 0;
            w.each_triangle([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                ++triangles;
                const std::array<std::uint32_t, 3> t{a, b, c};
                const auto x = [&](std::uint32_t v) { return std::int64_t{v >= second}; };
                const auto y = [&](std::uint32_t v) { return std::int64_t{height[v]}; };
                const std::int64_t own = (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
                CHECK(own > 0);
                doubled += own;
                for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
            });
            CHECK(triangles == w.triangle_count());
            CHECK(doubled == 2 * 6);
            std::size_t open = 0;
            for (const auto& [p, q] : edges) {
                CHECK(edges.count({p, q}) == 1);
                open += edges.count({q, p}) == 0;
            }
            CHECK(open == height.size());
        }
}

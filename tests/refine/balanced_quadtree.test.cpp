// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/balanced_quadtree.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::balanced_quadtree;

namespace {

/// Lists a region's edges.
void add_outline(balanced_quadtree& tree, const region& r)
{
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
        const std::uint32_t begin = r.starts()[loop], end = r.starts()[loop + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t next = i + 1 < end ? i + 1 : begin;
            REQUIRE(tree.add_edge(r.points()[i], r.points()[next], i, next));
        }
    }
}

std::vector<std::uint32_t> stored_leaves(const balanced_quadtree& tree)
{
    std::vector<std::uint32_t> all;
    for (std::uint32_t n = 0; n < tree.square_count(); ++n)
        if (tree.is_leaf(n)) all.push_back(n);
    return all;
}

/// The number of sides on whose other side lies a leaf of more than twice the width.
std::size_t unbalanced_sides(const balanced_quadtree& tree)
{
    std::size_t count = 0;
    for (const std::uint32_t n : stored_leaves(tree)) {
        const auto [x, y] = tree.corner(n);
        const std::int32_t width = tree.width(tree.at(n).level);
        for (const auto& [beyond_x, beyond_y] : {std::pair{x - 1, y}, {x + width, y}, {x, y - 1}, {x, y + width}})
            count += tree.level_at(beyond_x, beyond_y) + 1 < tree.at(n).level;
    }
    return count;
}

double distance_to(grid_point p, grid_point a, grid_point b)
{
    const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, px = double(p.x) - a.x, py = double(p.y) - a.y;
    const double share = (std::min)(1.0, (std::max)(0.0, (dx * px + dy * py) / (dx * dx + dy * dy)));
    return std::hypot(px - share * dx, py - share * dy);
}

}  // namespace

TEST_CASE("leaves that share a side differ at most by a factor of two, around every shape", "[refine]")
{
    balanced_quadtree tree;
    std::size_t leaves = 0, deep = 0;
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s))) continue;
        for (const test::shape& position : test::in_positions(s, {0.0, 33.0})) {
            if (!inspect::is_region(test::loops_of(position))) continue;
            INFO(position.name);
            const test::filled_shape shape{position};
            std::int32_t size = 0;
            for (const grid_point p : shape.filled.points()) size = (std::max)({size, std::abs(p.x), std::abs(p.y)});
            tree.open((std::max)(16, size / 5));
            add_outline(tree, shape.filled);
            REQUIRE(tree.split_crowded(1'000'000));
            CHECK(unbalanced_sides(tree) == 0);
            for (const std::uint32_t n : stored_leaves(tree)) deep += tree.at(n).level > 2;
            leaves += stored_leaves(tree).size();
        }
    }
    CHECK(leaves > 10'000);
    CHECK(deep > 1000);
}

TEST_CASE("splitting any leaf keeps the balance", "[refine]")
{
    balanced_quadtree tree;
    test::dice d{14};
    for (int round = 0; round < 30; ++round) {
        tree.open(16 << (2 + round % 4));
        CHECK(tree.deepest() == std::uint32_t(2 + round % 4));
        for (int k = 0; k < 60; ++k) {
            const grid_point p{d.roll(1000) - 500, d.roll(1000) - 500};
            if (tree.leaf_at(p.x, p.y) == balanced_quadtree::none) {
                const std::uint32_t root = tree.root_at(p);
                REQUIRE(root != balanced_quadtree::none);
                CHECK(tree.leaf_at(p.x, p.y) == root);
            }
            const std::uint32_t leaf = tree.leaf_at(p.x, p.y);
            const auto [x, y] = tree.corner(leaf);
            const std::int32_t width = tree.width(tree.at(leaf).level);
            CHECK((p.x >= x && p.x < x + width && p.y >= y && p.y < y + width));
            if (tree.at(leaf).level < tree.deepest()) REQUIRE(tree.split(leaf));
        }
        CHECK(unbalanced_sides(tree) == 0);
    }
}

TEST_CASE("between two long edges, leaves are as wide as three times their distance, or just below", "[refine]")
{
    balanced_quadtree tree;
    for (const int distance : {50, 100, 200, 341, 700, 1500, 20'000}) {
        for (const bool inside : {true, false}) {
            CAPTURE(distance, inside);
            tree.open(4096);
            // The left sides of both edges are inside: of the lower one, which runs to the right, above it.
            const std::int32_t from = inside ? -50'000 : 50'000;
            REQUIRE(tree.add_edge({from, 77}, {-from, 83}, 0, 1));
            REQUIRE(tree.add_edge({-from, 83 + distance}, {from, 77 + distance}, 2, 3));
            REQUIRE(tree.split_crowded(1'000'000));
            std::int32_t wanted = 4096;
            while (inside && wanted > 3 * distance && wanted > tree.width(tree.deepest())) wanted /= 2;
            std::int32_t widest = 0, narrowest = 1 << 20;
            for (std::int32_t x = -40'000; x < 40'000; x += 10) {
                const std::int32_t width = tree.width(tree.level_at(x, 80 + distance / 2));
                widest = (std::max)(widest, width);
                narrowest = (std::min)(narrowest, width);
            }
            CHECK(widest == wanted);
            CHECK(narrowest == wanted);
        }
    }
}

TEST_CASE("the corners in triangles that share sides are the corners of all leaves, once inside each", "[refine]")
{
    balanced_quadtree tree;
    test::dice d{3};
    for (int round = 0; round < 40; ++round) {
        tree.open(400);
        for (int k = 0; k < 12; ++k) {
            const std::uint32_t root = tree.root_at({d.roll(4000) - 2000, d.roll(4000) - 2000});
            if (tree.is_leaf(root)) REQUIRE(tree.split(root));
            const std::uint32_t leaf = tree.leaf_at(d.roll(4000) - 2000, d.roll(4000) - 2000);
            if (leaf != balanced_quadtree::none && tree.at(leaf).level < tree.deepest()) REQUIRE(tree.split(leaf));
        }
        std::set<std::pair<std::int32_t, std::int32_t>> wanted;
        for (std::int32_t x = -4000; x <= 4000; x += tree.width(0))
            for (std::int32_t y = -4000; y <= 4000; y += tree.width(0)) wanted.insert({x, y});
        for (const std::uint32_t n : stored_leaves(tree)) {
            const auto [x, y] = tree.corner(n);
            const std::int32_t width = tree.width(tree.at(n).level);
            for (const auto& [dx, dy] : {std::pair{0, 0}, {width, 0}, {0, width}, {width, width}})
                wanted.insert({x + dx, y + dy});
        }
        const grid_point p{d.roll(6000) - 3000, d.roll(6000) - 3000}, q{d.roll(6000) - 3000, d.roll(6000) - 3000},
            r{d.roll(6000) - 3000, d.roll(6000) - 3000};
        const std::int64_t turn = orientation(p, q, r);
        if (turn == 0) continue;
        const grid_point in[] = {p, turn > 0 ? q : r, turn > 0 ? r : q};
        std::vector<std::pair<std::int32_t, std::int32_t>> found;
        CHECK(tree.each_corner(in, 0, [&](grid_point c) noexcept {
            found.push_back({c.x, c.y});
            return true;
        }));
        std::erase_if(wanted, [&](const auto& c) {
            const grid_point at{c.first, c.second};
            return orientation(in[0], in[1], at) < 0 || orientation(in[1], in[2], at) < 0 ||
                   orientation(in[2], in[0], at) < 0;
        });
        std::sort(found.begin(), found.end());
        CHECK(found == std::vector(wanted.begin(), wanted.end()));
    }
}

TEST_CASE("a corner is close to an edge exactly within two fifths of the smallest leaf around it", "[refine]")
{
    balanced_quadtree tree;
    test::dice d{29};
    std::size_t close = 0, apart = 0;
    for (int round = 0; round < 60; ++round) {
        tree.open(640);
        std::vector<std::pair<grid_point, grid_point>> edges;
        for (std::uint32_t k = 0; k < 6; ++k) {
            edges.push_back({{d.roll(6000) - 3000, d.roll(6000) - 3000}, {d.roll(6000) - 3000, d.roll(6000) - 3000}});
            REQUIRE(tree.add_edge(edges.back().first, edges.back().second, 2 * k, 2 * k + 1));
        }
        REQUIRE(tree.split_crowded(1'000'000));
        for (const std::uint32_t n : stored_leaves(tree)) {
            const grid_point p = tree.corner(n);
            std::uint32_t level = 0;
            for (const int k : {0, 1, 2, 3}) level = (std::max)(level, tree.level_at(p.x - (k & 1), p.y - (k >> 1)));
            double nearest = 1e9;
            for (const auto& [a, b] : edges) nearest = (std::min)(nearest, distance_to(p, a, b));
            if (std::abs(nearest - 2 * tree.width(level) / 5) < 1e-6) continue;
            CHECK(tree.is_close(p) == (nearest < 2 * tree.width(level) / 5));
            ++(tree.is_close(p) ? close : apart);
        }
        tree.forget_edges();
        CHECK_FALSE(tree.is_close(tree.corner(0)));
    }
    CHECK(close > 1000);
    CHECK(apart > 1000);
}

TEST_CASE("squares without memory, or beyond their number, say so", "[refine]")
{
    const test::filled_shape shape{test::circle_with_holes(60, 3)};
    bool done = false;
    for (std::size_t nth = 1; !done && nth < 60; ++nth) {
        test::counting_memory memory{.fail_at = nth};
        balanced_quadtree tree{memory.source()};
        tree.open(300'000);
        done = true;
        for (std::uint32_t i = 0; done && i < shape.filled.points().size(); ++i)
            done = tree.add_edge(shape.filled.points()[i], shape.filled.points()[i], i, i);
        done = done && tree.split_crowded(1'000'000);
        CHECK(done == (memory.requests < nth));
    }
    CHECK(done);
    balanced_quadtree tree;
    tree.open(300'000);
    add_outline(tree, shape.filled);
    CHECK_FALSE(tree.split_crowded(100));
    CHECK(tree.square_count() > 100);
}

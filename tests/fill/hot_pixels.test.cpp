// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/hot_pixels.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <set>
#include <vector>

using namespace typemesh;
using detail::hot_pixels;

namespace {

__extension__ using int128 = __int128;

/// A place along a segment, in parts of a whole.
struct share {
    int128 part, whole;  // whole > 0
    friend bool operator<(share a, share b) { return a.part * b.whole < b.part * a.whole; }
    friend bool operator==(share a, share b) { return a.part * b.whole == b.part * a.whole; }
};

/// The part of a segment in the half-open pixel of a point, clipped along one axis after the other.
struct clipped {
    share first{0, 1}, last{1, 1};
    bool without_first = false, without_last = false, empty = false;

    clipped(grid_point from, grid_point to, grid_point p)
    {
        clip(2 * (std::int64_t{from.x} - p.x), 2 * (std::int64_t{to.x} - from.x));
        clip(2 * (std::int64_t{from.y} - p.y), 2 * (std::int64_t{to.y} - from.y));
        empty = empty || last < first || (first == last && (without_first || without_last));
    }

    /// -1 <= at + t step < 1
    void clip(std::int64_t at, std::int64_t step)
    {
        if (step == 0) {
            empty = empty || at < -1 || at >= 1;
            return;
        }
        share in{-1 - at, step}, out{1 - at, step};  // where it reaches the closed side and the open one
        if (step < 0) in = {1 + at, -step}, out = {at - 1, -step};
        const bool rising = step > 0;
        begin_at(rising ? in : out, !rising);
        end_at(rising ? out : in, rising);
    }
    void begin_at(share s, bool without)
    {
        if (first < s)
            first = s, without_first = without;
        else if (first == s)
            without_first = without_first || without;
    }
    void end_at(share s, bool without)
    {
        if (s < last)
            last = s, without_last = without;
        else if (last == s)
            without_last = without_last || without;
    }
};

struct met {
    std::vector<std::uint32_t> numbers;
    std::vector<bool> exact;
};

met along(hot_pixels& pixels, grid_point from, grid_point to)
{
    met m;
    CHECK(pixels.along(from, to, [&](hot_pixels::hit h) {
        m.numbers.push_back(h.number);
        m.exact.push_back(h.is_exact);
        return true;
    }));
    return m;
}

/// Compares with the clipping of every point: each point is met once, except for the ends.
void check_segment(hot_pixels& pixels, const std::vector<grid_point>& points, grid_point from, grid_point to)
{
    std::set<std::uint32_t> wanted;
    for (std::uint32_t i = 0; i < points.size(); ++i)
        if (!(points[i] == from) && !(points[i] == to) && !clipped(from, to, points[i]).empty) wanted.insert(i);
    const met m = along(pixels, from, to);
    INFO("from " << from.x << ' ' << from.y << " to " << to.x << ' ' << to.y);
    REQUIRE(std::set<std::uint32_t>(m.numbers.begin(), m.numbers.end()) == wanted);
    REQUIRE(m.numbers.size() == wanted.size());
    for (std::size_t k = 0; k < m.numbers.size(); ++k) {
        const grid_point p = points[m.numbers[k]];
        REQUIRE(m.exact[k] == (orientation(from, to, p) == 0));
        if (k == 0) continue;
        const clipped before{from, to, points[m.numbers[k - 1]]}, here{from, to, p};
        REQUIRE_FALSE(here.first < before.first);
    }
}

std::vector<grid_point> random_points(test::dice& d, int n, grid_point size, grid_point corner)
{
    std::vector<grid_point> points;
    for (int i = 0; i < n; ++i) {
        const grid_point p{corner.x + d.roll(size.x), corner.y + d.roll(size.y)};
        if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    return points;
}

void check_points(test::dice& d, const std::vector<grid_point>& points, grid_point size, grid_point corner)
{
    workspace space, sorting;
    workspace::scope scratch{space};
    hot_pixels pixels;
    REQUIRE(pixels.open(points, scratch, sorting));
    for (int k = 0; k < 20; ++k) {
        grid_point from{corner.x + d.roll(size.x), corner.y + d.roll(size.y)},
            to{corner.x + d.roll(size.x), corner.y + d.roll(size.y)};
        if (k % 4 == 0) from = points[static_cast<std::size_t>(d.roll(static_cast<std::int32_t>(points.size())))];
        if (from == to) continue;
        if (lexicographic_less(to, from)) std::swap(from, to);
        check_segment(pixels, points, from, to);
    }
}

}  // namespace

TEST_CASE("a segment meets the points whose pixels it passes through, in order", "[fill][hot_pixels]")
{
    test::dice d{21};
    for (int round = 0; round < 2000; ++round) {
        const grid_point size{2 + d.roll(12), 2 + d.roll(12)};
        check_points(d, random_points(d, 1 + d.roll(30), size, {0, 0}), size, {0, 0});
    }
}

TEST_CASE("hot pixels work for long flat shapes and at the ends of the grid", "[fill][hot_pixels]")
{
    test::dice d{22};
    constexpr std::int32_t reach = 1 << 28;
    const grid_point sizes[] = {{100'000, 3}, {3, 100'000}, {2 * reach, 2 * reach}, {2 * reach, 2}, {2, 2 * reach}};
    for (const grid_point size : sizes) {
        for (int round = 0; round < 40; ++round) {
            const grid_point corner{-(size.x / 2), -(size.y / 2)};
            check_points(d, random_points(d, 300, size, corner), size, corner);
        }
    }
}

TEST_CASE("a long segment meets points within half a cell beside it", "[fill][hot_pixels]")
{
    test::dice d{23};
    for (int round = 0; round < 300; ++round) {
        grid_point from{d.roll(1 << 28), d.roll(1 << 28)}, to{-d.roll(1 << 28), -d.roll(1 << 28)};
        if (lexicographic_less(to, from)) std::swap(from, to);
        std::vector<grid_point> points;
        for (int k = 0; k < 50; ++k) {  // rounded onto it, or one cell beside it
            const double t = d.fraction();
            const grid_point p{
                static_cast<std::int32_t>(std::lround(from.x + t * (double(to.x) - from.x))) + d.roll(3) - 1,
                static_cast<std::int32_t>(std::lround(from.y + t * (double(to.y) - from.y))) + d.roll(3) - 1};
            if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
        }
        workspace space, sorting;
        workspace::scope scratch{space};
        hot_pixels pixels;
        REQUIRE(pixels.open(points, scratch, sorting));
        check_segment(pixels, points, from, to);
    }
}

TEST_CASE("no points are never met, and along() stops when its callback does", "[fill][hot_pixels]")
{
    workspace space, sorting;
    workspace::scope scratch{space};
    hot_pixels none;
    REQUIRE(none.open({}, scratch, sorting));
    CHECK(along(none, {0, 0}, {5, 5}).numbers.empty());

    const std::vector<grid_point> line{{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}};
    hot_pixels pixels;
    REQUIRE(pixels.open(line, scratch, sorting));
    int calls = 0;
    CHECK_FALSE(pixels.along({0, 0}, {9, 9}, [&](hot_pixels::hit) { return ++calls < 3; }));
    CHECK(calls == 3);
}

TEST_CASE("hot pixels report that memory ran out", "[fill][hot_pixels]")
{
    const std::vector<grid_point> line{{1, 1}, {2, 2}, {3, 3}};
    test::counting_memory failing{.fail_at = 1};
    workspace space{failing.source()}, sorting;
    workspace::scope scratch{space};
    hot_pixels pixels;
    CHECK_FALSE(pixels.open(line, scratch, sorting));
}

// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/group_intersection.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <vector>

using namespace typemesh;

namespace {

/// Squares of one size, and their places.
struct tiles {
    contours tile;
    std::vector<placed_loops> all;

    explicit tiles(std::int32_t size) : tile{test::contours_of({"tile", {test::square(0, 0, size)}})} {}
    void add(std::int64_t x, std::int64_t y) { all.push_back({tile.points.view(), tile.starts.view(), x, y}); }
    [[nodiscard]] std::vector<std::uint32_t> groups(memory source = heap()) const
    {
        std::vector<std::uint32_t> group(all.size(), 99);
        workspace space{source};
        REQUIRE_FALSE(group_intersection(all, group, space));
        return group;
    }
};

}  // namespace

TEST_CASE("a group contains all regions that meet directly or through others", "[fill][group_intersection]")
{
    test::dice d{31};
    for (int round = 0; round < 300; ++round) {
        tiles t{10};
        const int n = 1 + d.roll(40), wide = 1 + d.roll(200), high = 1 + d.roll(200);
        for (int i = 0; i < n; ++i) t.add(d.roll(wide), d.roll(high));
        if (d.roll(4) == 0) t.all[0].points = {}, t.all[0].starts = {};

        std::vector<std::uint32_t> expected(t.all.size());
        for (std::uint32_t i = 0; i < expected.size(); ++i) expected[i] = i;
        for (bool changed = true; changed;) {  // the lowest number spreads until nothing moves
            changed = false;
            for (std::size_t i = 0; i < t.all.size(); ++i) {
                for (std::size_t k = 0; k < t.all.size(); ++k) {
                    if (t.all[i].points.empty() || t.all[k].points.empty()) continue;
                    const auto apart = [](std::int64_t a, std::int64_t b) { return a - b > 10 || b - a > 10; };
                    if (apart(t.all[i].x, t.all[k].x) || apart(t.all[i].y, t.all[k].y)) continue;
                    if (expected[k] < expected[i]) expected[i] = expected[k], changed = true;
                }
            }
        }
        CHECK(t.groups() == expected);
    }
}

TEST_CASE("a chain over many lines is one group, upward and across", "[fill][group_intersection]")
{
    for (const bool upward : {false, true}) {
        tiles t{10};
        for (int i = 0; i < 5000; ++i) t.add(upward ? i % 2 * 10 : i * 10, upward ? i * 10 : i % 2 * 10);
        for (const std::uint32_t g : t.groups()) REQUIRE(g == 0);
    }
}

TEST_CASE("group_intersection() reports that memory ran out, at every request", "[fill][group_intersection]")
{
    tiles t{10};
    for (int i = 0; i < 2000; ++i) t.add(i * 10, 0);
    std::vector<std::uint32_t> group(t.all.size());
    int failures = 0;
    for (std::size_t fail_at = 1;; ++fail_at) {
        test::counting_memory counted{.fail_at = fail_at};
        workspace space{counted.source()};
        const error e = group_intersection(t.all, group, space);
        if (!e) break;
        CHECK(e.code == error::out_of_memory);
        ++failures;
    }
    CHECK(failures >= 2);
}

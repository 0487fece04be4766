// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/unicode/visual_order.hpp>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// The order of a line's characters by rule L2: reversed again and again.
std::vector<std::uint32_t> reversed_by_rule(const std::vector<std::uint8_t>& levels)
{
    std::vector<std::uint32_t> order(levels.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    for (int level = 127; level > 0; --level)
        for (std::size_t i = 0, end = 0; i < levels.size(); i = end + 1) {
            for (end = i; end < levels.size() && levels[end] >= level;) ++end;
            std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                         order.begin() + static_cast<std::ptrdiff_t>(end));
        }
    return order;
}

std::vector<std::uint32_t> order_of(const buffer<visual_run>& runs)
{
    std::vector<std::uint32_t> order;
    for (const visual_run& run : runs)
        for (std::uint32_t i = 0; i < run.last - run.first; ++i)
            order.push_back(run.level % 2 == 0 ? run.first + i : run.last - 1 - i);
    return order;
}

result<void> order(const std::vector<std::uint8_t>& levels, const std::vector<text_mark>& marks, std::uint8_t paragraph,
                   buffer<visual_run>& runs)
{
    return visual_runs(levels.data(), marks.data(), paragraph, {0, static_cast<std::uint32_t>(levels.size())}, runs);
}

}  // namespace

TEST_CASE("visual_runs() orders a line like reversals level by level", "[bidi]")
{
    std::mt19937 random{1};
    buffer<visual_run> runs;
    for (const unsigned most : {1u, 2u, 3u, 9u, 126u})
        for (int repeat = 0; repeat < 400; ++repeat) {
            std::vector<std::uint8_t> levels(random() % 60);
            for (auto& level : levels) level = static_cast<std::uint8_t>(random() % (most + 1));
            const std::vector<text_mark> marks(levels.size(), text_mark::none);
            REQUIRE(order(levels, marks, 0, runs));
            REQUIRE(order_of(runs) == reversed_by_rule(levels));
        }
}

TEST_CASE("white space at a line's end and before a tab has the paragraph's level", "[bidi]")
{
    constexpr auto o = text_mark::none, w = text_mark::trailing, t = text_mark::separator;
    buffer<visual_run> runs;
    REQUIRE(order(std::vector<std::uint8_t>(7, 1), {o, w, t, o, w, o, w}, 0, runs));
    const visual_run expected[] = {{0, 1, 1}, {1, 3, 0}, {3, 6, 1}, {6, 7, 0}};
    CHECK(std::ranges::equal(runs, expected, [](const visual_run& a, const visual_run& b) {
        return a.first == b.first && a.last == b.last && a.level == b.level;
    }));
}

TEST_CASE("visual_runs() of an empty line is empty, and reports that memory ran out", "[bidi]")
{
    test::counting_memory heap;
    buffer<visual_run> runs{heap.source()};
    CHECK(order({}, {}, 1, runs));
    CHECK(runs.empty());
    const std::vector<std::uint8_t> levels{0, 1, 2};
    const std::vector<text_mark> marks(3, text_mark::none);
    heap.fail_at = heap.requests + 1;
    CHECK(order(levels, marks, 0, runs) == error::out_of_memory);
    CHECK(runs.empty());
    heap.fail_at = 0;
    CHECK(order(levels, marks, 0, runs));
    const std::size_t warm = heap.requests;
    CHECK(order(levels, marks, 0, runs));
    CHECK(heap.requests == warm);
}

TEST_CASE("order_visually() reverses runs level by level, from the highest down", "[bidi]")
{
    using runs = std::vector<std::uint32_t>;
    for (const auto& [levels, expected] : {std::pair<std::vector<unsigned>, runs>{{}, {}},
                                           {{0, 0, 0}, {0, 1, 2}},
                                           {{1, 1, 1}, {2, 1, 0}},
                                           {{0, 1, 2, 1, 0}, {0, 3, 2, 1, 4}},
                                           {{1, 2, 3, 2, 1}, {4, 1, 2, 3, 0}},
                                           {{2, 1, 2}, {2, 1, 0}},
                                           {{1, 2, 2, 1}, {3, 1, 2, 0}}}) {
        std::vector<visual_run> line;
        for (std::uint32_t i = 0; i < levels.size(); ++i)
            line.push_back({i, i + 1, static_cast<std::uint8_t>(levels[i])});
        order_visually(std::span{line});
        runs order;
        for (const visual_run& run : line) order.push_back(run.first);
        CHECK(order == expected);
    }
}

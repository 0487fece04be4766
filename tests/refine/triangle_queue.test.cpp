// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/triangle_queue.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <utility>
#include <vector>

using namespace typemesh;
using detail::triangle_queue;

TEST_CASE("a queue gives the lowest rank first, and of one rank the last triangle first", "[refine]")
{
    triangle_queue queue;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted;  // a stack for each rank, by a stable search
    test::dice d{4};
    std::uint32_t number = 0;
    for (int round = 0; round < 5000; ++round) {
        if (d.roll(5) < 3) {
            const auto rank = static_cast<std::uint32_t>(d.roll(256));
            REQUIRE(queue.push(rank, {number, 1, 2, 3}));
            wanted.emplace_back(rank, number++);
        } else if (!wanted.empty()) {
            std::size_t first = 0;
            for (std::size_t i = 1; i < wanted.size(); ++i)
                if (wanted[i].first <= wanted[first].first) first = i;
            REQUIRE(queue.has_more());
            REQUIRE(queue.pop().t == wanted[first].second);
            wanted.erase(wanted.begin() + static_cast<std::ptrdiff_t>(first));
        }
        REQUIRE(queue.has_more() == !wanted.empty());
    }
    queue.clear();
    CHECK_FALSE(queue.has_more());
}

TEST_CASE("ranks grow with the length, twice for each doubling of its square", "[refine]")
{
    std::uint32_t last = 0;
    for (std::int64_t square = 1; square < std::int64_t{1} << 59; square += (square + 3) / 4) {
        const std::uint32_t rank = triangle_queue::rank_of(square);
        CHECK(rank >= last);
        CHECK(rank < 128);
        if (square > 1) CHECK(triangle_queue::rank_of(2 * square) == rank + 2);
        last = rank;
    }
    CHECK(triangle_queue::rank_of(0) == 0);
    CHECK(last > 110);
}

TEST_CASE("a queue without memory says so", "[refine]")
{
    test::counting_memory memory{.fail_at = 1};
    triangle_queue queue{memory.source()};
    CHECK_FALSE(queue.push(0, {}));
    CHECK_FALSE(queue.has_more());
}

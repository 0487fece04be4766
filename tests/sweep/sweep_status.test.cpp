// SPDX-License-Identifier: MIT

#include <typemesh/sweep/impl/sweep_status.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace typemesh;

TEST_CASE("a sweep status keeps its order through thousands of changes", "[core][sweep_status]")
{
    for (const std::size_t most : {1u, 10u, 17u, 60u, 3000u}) {
        workspace space;
        workspace::scope scratch{space};
        sweep_status status;
        REQUIRE(status.open(scratch, most));
        std::vector<std::uint32_t> expected, height(most + 1, 0), unused;  // heights make the order
        for (std::uint32_t item = 1; item <= most; ++item) unused.push_back(item);
        std::uint64_t seed = most;
        const auto random = [&] {
            return static_cast<std::uint32_t>((seed = seed * 6'364'136'223'846'793'005u + 1'442'695'040'888'963'407u) >>
                                              33);
        };
        std::size_t max_steps = 0;
        for (int i = 0; i < 20'000; ++i) {
            const bool grow = i % 8000 < 5000 ? random() % 4 != 0 : random() % 4 == 0;
            if (grow && !unused.empty()) {
                const std::uint32_t item = unused.back();
                unused.pop_back();
                height[item] = random();
                std::size_t steps = 0;
                const std::uint32_t under = status.last_below([&](std::uint32_t other) {
                    ++steps;
                    return other != 0 && height[other] < height[item];
                });
                max_steps = (std::max)(max_steps, steps);
                const auto at = std::lower_bound(expected.begin(), expected.end(), height[item],
                                                 [&](std::uint32_t a, std::uint32_t h) { return height[a] < h; });
                REQUIRE(under == (at == expected.begin() ? 0 : *(at - 1)));
                status.insert_above(under, item);
                expected.insert(at, item);
            } else if (!expected.empty()) {
                const auto at = expected.begin() + random() % static_cast<std::uint32_t>(expected.size());
                status.erase(*at);
                unused.push_back(*at);
                expected.erase(at);
            }
        }
        std::uint32_t item = 0;
        for (const std::uint32_t e : expected) {
            CHECK(status.below(e) == item);
            item = status.above(item);
            CHECK(item == e);
        }
        CHECK(status.above(item) == 0);
        CHECK(max_steps < 150);  // of up to 3000
    }
}

TEST_CASE("two items may follow one search", "[core][sweep_status]")
{
    workspace space;
    workspace::scope scratch{space};
    sweep_status status;
    REQUIRE(status.open(scratch, 2000));
    for (std::uint32_t item = 1; item < 2000; item += 2) {
        const std::uint32_t under =
            status.last_below([&](std::uint32_t other) { return other != 0 && (other | 1) < item && other % 5 != 0; });
        status.insert_above(under, item);
        status.insert_above(item, item + 1);
        REQUIRE(status.above(under) == item);
        REQUIRE(status.above(item) == item + 1);
        REQUIRE(status.below(item + 1) == item);
    }
    std::uint32_t count = 0;
    for (std::uint32_t item = status.above(0); item != 0; item = status.above(item)) ++count;
    CHECK(count == 2000);
}

TEST_CASE("a sweep status reports that memory ran out", "[core][sweep_status]")
{
    test::counting_memory memory{.fail_at = 1};
    workspace space{memory.source()};
    workspace::scope scratch{space};
    sweep_status status;
    CHECK_FALSE(status.open(scratch, 100));
}

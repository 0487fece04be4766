// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/collapse_queue.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <vector>

using namespace typemesh;
using detail::collapse;
using detail::collapse_queue;

namespace {

collapse roll(test::dice& d)
{
    return {std::int64_t{d.roll(50)} << 18,  // four count as one time
            static_cast<std::uint32_t>(d.roll(20)),
            static_cast<std::uint32_t>(d.roll(4)),
            static_cast<collapse::kind>(d.roll(4)),
            static_cast<std::uint8_t>(d.roll(3)),
            d.roll(3)};
}
bool is_equal(const collapse& a, const collapse& b) { return !(a < b) && !(b < a); }

}  // namespace

TEST_CASE("collapses leave their queue in order while pushes and pops alternate", "[offset][collapse_queue]")
{
    test::dice d{1};
    for (int round = 0; round < 300; ++round) {
        collapse_queue queue{heap()};
        std::vector<collapse> held;
        for (int i = 0; i < 200; ++i) {
            if (held.empty() || d.roll(5) > 1) {
                held.push_back(roll(d));
                REQUIRE(queue.push(held.back()));
            } else {
                const auto first = std::min_element(held.begin(), held.end());
                REQUIRE(is_equal(queue.first(), *first));
                REQUIRE(is_equal(queue.pop(), *first));
                held.erase(first);
            }
            REQUIRE(queue.empty() == held.empty());
        }
        std::sort(held.begin(), held.end());
        for (const collapse& c : held) REQUIRE(is_equal(queue.pop(), c));
        CHECK(queue.empty());
    }
}

TEST_CASE("every pushed collapse is popped once", "[offset][collapse_queue]")
{
    test::dice d{2};
    collapse_queue queue{heap()};
    constexpr std::uint32_t count = 5000;
    for (std::uint32_t i = 0; i < count; ++i)
        REQUIRE(queue.push({std::int64_t{d.roll(100)} << 20, d.roll(2) == 0 ? i : 7, i, collapse::kind::turn, 0, 0}));
    std::vector<bool> seen(count);
    while (!queue.empty()) {
        const std::uint32_t stamp = queue.pop().stamp;
        CHECK_FALSE(seen[stamp]);
        seen[stamp] = true;
    }
    CHECK(std::count(seen.begin(), seen.end(), true) == count);
}

TEST_CASE("a queue of collapses without memory keeps its contents", "[offset][collapse_queue]")
{
    test::counting_memory limited{.fail_at = 2};
    collapse_queue queue{limited.source()};
    constexpr std::uint32_t most = 1000;
    std::uint32_t taken = 0;
    while (taken < most && queue.push({0, most - taken, 0, collapse::kind::turn, 0, 0})) ++taken;
    REQUIRE(taken > 0);
    REQUIRE(taken < most);
    for (std::uint32_t t = most + 1 - taken; t <= most; ++t) CHECK(queue.pop().triangle == t);
    CHECK(queue.empty());
}

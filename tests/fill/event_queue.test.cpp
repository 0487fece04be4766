// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/event_queue.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

TEST_CASE("Events leave their queue by place, and none is lost", "[fill][event_queue]")
{
    test::dice d{41};
    for (int run = 0; run < 300; ++run) {
        workspace space;
        workspace::scope scratch{space};
        constexpr std::uint32_t room = 200;
        detail::event_queue queue;
        REQUIRE(queue.open(scratch, room));
        std::vector<std::int64_t> waiting;
        std::vector<bool> is_waiting(2000, false);
        const int kinds = 1 + d.roll(50);
        std::uint32_t next = 0;
        for (int step = 0; step < 1000; ++step) {
            CHECK(queue.empty() == waiting.empty());
            CHECK((queue.first_place() == (std::numeric_limits<std::int64_t>::max)()) == waiting.empty());
            REQUIRE(queue.room() == room - waiting.size());
            if (queue.room() != 0 && (waiting.empty() || d.roll(2) == 0)) {
                const auto place = -(std::int64_t{1} << 60) + d.roll(kinds);
                is_waiting[next] = true;
                queue.push({place, next++, static_cast<std::uint32_t>(place & 0xFF)});
                waiting.push_back(place);
            } else {
                const detail::event e = queue.top();
                const auto first = std::min_element(waiting.begin(), waiting.end());
                REQUIRE(e.place == *first);
                CHECK(e.slot == static_cast<std::uint32_t>(e.place & 0xFF));
                REQUIRE(is_waiting[e.segment]);
                is_waiting[e.segment] = false;
                waiting.erase(first);
                queue.pop();
            }
        }
    }
}

TEST_CASE("An event queue without memory does not open", "[fill][event_queue]")
{
    test::counting_memory memory{.fail_at = 1};
    workspace space{memory.source()};
    workspace::scope scratch{space};
    detail::event_queue queue;
    CHECK_FALSE(queue.open(scratch, 10));
}

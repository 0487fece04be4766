// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/adapt/threads.hpp>

#include <atomic>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

using namespace typemesh;

static_assert(executor<thread_pool>);
static_assert(noexcept(std::declval<mutex_lock&>().lock()) && noexcept(std::declval<mutex_lock&>().unlock()));

TEST_CASE("a pool does every task once, each by a worker that does nothing else meanwhile", "[adapt][threads]")
{
    const std::size_t workers = GENERATE(1u, 2u, 3u, 8u);
    thread_pool pool{workers};
    REQUIRE(pool.workers() >= 1);
    REQUIRE(pool.workers() <= workers);
    for (const std::size_t n : {0u, 1u, 2u, 3u, 100u, 5000u}) {
        std::vector<std::uint8_t> times(n, 0);                   // each written by one task alone
        std::vector<std::uint64_t> work(pool.workers() + 1, 0);  // plain: the sanitizer sees an overlap
        pool.run(n, [&](std::size_t i, std::size_t worker) noexcept {
            ++times[i];
            ++work[worker < pool.workers() ? worker : pool.workers()];
        });
        std::uint64_t sum = 0;
        for (const std::uint64_t w : work) sum += w;
        CHECK(work.back() == 0);
        CHECK(sum == n);
        CHECK(times == std::vector<std::uint8_t>(n, 1));
    }
}

TEST_CASE("workers really work side by side", "[adapt][threads]")
{
    thread_pool pool{2};
    REQUIRE(pool.workers() == 2);
    // Each of the two tasks waits for the other: one worker alone would never end.
    std::atomic<int> there{0};
    pool.run(2, [&](std::size_t, std::size_t) noexcept {
        ++there;
        while (there.load() < 2) std::this_thread::yield();
    });
    CHECK(there == 2);
}

TEST_CASE("what one run wrote is seen by the next, and by the caller", "[adapt][threads]")
{
    thread_pool pool{3};
    std::vector<std::uint32_t> a(64, 1), b(64, 0);
    for (int round = 0; round < 500; ++round) {
        pool.run(64, [&](std::size_t i, std::size_t) noexcept { b[i] = a[(i + 1) % 64] + 1; });
        std::swap(a, b);
    }
    CHECK(a == std::vector<std::uint32_t>(64, 501));
}

TEST_CASE("several threads may run tasks on one pool", "[adapt][threads]")
{
    thread_pool pool{2};
    std::uint64_t sums[3] = {};
    const auto add_up = [&pool](std::uint64_t& sum) {
        for (int round = 0; round < 100; ++round) {
            std::uint64_t parts[2] = {};
            pool.run(50, [&](std::size_t i, std::size_t worker) noexcept { parts[worker] += i; });
            sum += parts[0] + parts[1];
        }
    };
    std::thread first{[&] { add_up(sums[0]); }}, second{[&] { add_up(sums[1]); }};
    add_up(sums[2]);
    first.join();
    second.join();
    for (const std::uint64_t s : sums) CHECK(s == 100u * 1225u);
}

TEST_CASE("a pool that had nothing to do ends", "[adapt][threads]")
{
    for (int i = 0; i < 100; ++i) {
        const thread_pool pool{4};
        CHECK(pool.workers() >= 1);
    }
    CHECK(thread_pool{}.workers() >= 1);
    CHECK(thread_pool{1}.workers() == 1);
}

TEST_CASE("a mutex_lock lets one thread in at a time", "[adapt][threads]")
{
    thread_pool pool{4};
    mutex_lock lock;
    std::uint64_t sum = 0;
    pool.run(1000, [&](std::size_t i, std::size_t) noexcept {
        lock.lock();
        sum += i;
        lock.unlock();
    });
    CHECK(sum == 499'500u);
}

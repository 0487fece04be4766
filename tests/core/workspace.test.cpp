// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/core/workspace.hpp>

#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

using namespace typemesh;

TEST_CASE("blocks of a scope are aligned, do not overlap, and last until it ends", "[core][workspace]")
{
    workspace space;
    workspace::scope scratch{space};
    std::vector<std::pair<unsigned char*, std::size_t>> taken;
    for (std::size_t i = 1; i < 200; ++i) {
        const std::size_t n = i * i % 5000 + 1;
        auto* block = scratch.take<unsigned char>(n);
        REQUIRE(block != nullptr);
        REQUIRE(reinterpret_cast<std::uintptr_t>(block) % 64 == 0);
        std::memset(block, static_cast<int>(i), n);
        taken.emplace_back(block, n);
    }
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < taken.size(); ++i)
        for (std::size_t k = 0; k < taken[i].second; ++k)
            wrong += taken[i].first[k] != static_cast<unsigned char>(i + 1);
    CHECK(wrong == 0);
}

TEST_CASE("an inner scope gives its blocks back, and the outer one keeps its own", "[core][workspace]")
{
    workspace space;
    workspace::scope outer{space};
    int* kept = outer.take<int>(10);
    kept[9] = 99;
    int* first = nullptr;
    for (int round = 0; round < 5; ++round) {
        workspace::scope inner{space};
        int* block = inner.take<int>(100);
        if (round == 0) first = block;
        CHECK(block == first);
        std::memset(block, 0, 100 * sizeof(int));
        (void)inner.take<int>(1000000);  // more than a block holds
    }
    CHECK(kept[9] == 99);
}

TEST_CASE("after warm-up the same work allocates nothing", "[core][workspace]")
{
    test::counting_memory counted;
    {
        workspace space{counted.source()};
        CHECK(counted.requests == 0);
        const auto work = [&] {
            workspace::scope a{space};
            for (int i = 0; i < 30; ++i) {
                if (a.take<double>(2000) == nullptr) std::abort();
                workspace::scope b{space};
                if (b.take<char>(70000) == nullptr) std::abort();
            }
        };
        work();
        const std::size_t before = counted.requests;
        for (int i = 0; i < 10; ++i) work();
        CHECK(counted.requests == before);
        CHECK(space.capacity() > 0);
        CHECK(space.capacity() < 4000000);
    }
    CHECK(counted.bytes_held == 0);
}

TEST_CASE("a workspace without memory returns null and stays usable", "[core][workspace]")
{
    for (std::size_t at = 1; at <= 4; ++at) {
        test::counting_memory failing{.fail_at = at, .fail_once = true};
        {
            workspace space{failing.source()};
            std::size_t refused = 0;
            for (int round = 0; round < 3; ++round) {
                workspace::scope a{space};
                for (std::size_t n : {1000u, 100000u, 1000000u}) {
                    auto* block = a.take<char>(n);
                    if (block == nullptr)
                        ++refused;
                    else
                        std::memset(block, 1, n);
                }
            }
            CHECK(refused <= 1);
            workspace::scope again{space};
            CHECK(again.take<char>(1000000) != nullptr);
        }
        CHECK(failing.bytes_held == 0);
    }
}

TEST_CASE("a workspace refuses absurd sizes, but not zero", "[core][workspace]")
{
    workspace space;
    workspace::scope a{space};
    CHECK(a.take<double>(~std::size_t{0}) == nullptr);
    CHECK(a.take<double>(~std::size_t{0} / sizeof(double)) == nullptr);
    CHECK(a.take<double>(0) != nullptr);
}

TEST_CASE("a workspace can be moved between its scopes", "[core][workspace]")
{
    test::counting_memory counted;
    {
        workspace first{counted.source()};
        {
            workspace::scope a{first};
            CHECK(a.take<int>(10) != nullptr);
        }
        workspace second = std::move(first);
        {
            workspace::scope a{second};
            CHECK(a.take<int>(10) != nullptr);
        }
        CHECK(counted.requests == 1);
        workspace third;
        third = std::move(second);
        workspace::scope a{third};
        CHECK(a.take<int>(10) != nullptr);
        CHECK(counted.requests == 1);
    }
    CHECK(counted.bytes_held == 0);
}

TEST_CASE("a scope keeps the blocks that keep() names and gives back the rest", "[core][workspace]")
{
    test::counting_memory memory;
    workspace space{memory.source()};
    workspace::scope scratch{space};
    auto* const first = scratch.take<std::uint32_t>(1000);
    array_view<std::uint32_t> a{scratch.take<std::uint32_t>(30'000), 30'000};
    (void)scratch.take<std::uint64_t>(50'000);
    array_view<std::uint64_t> b{scratch.take<std::uint64_t>(40'000), 40'000};
    for (std::uint32_t i = 0; i < a.size(); ++i) a[i] = i;
    for (std::uint32_t i = 0; i < b.size(); ++i) b[i] = std::uint64_t{i} << 32;
    const std::size_t requests = memory.requests;
    scratch.keep(a, b);
    CHECK(memory.requests == requests);
    CHECK(a.data() != first + 1000);
    bool same = true;
    for (std::uint32_t i = 0; i < a.size(); ++i) same = same && a[i] == i;
    for (std::uint32_t i = 0; i < b.size(); ++i) same = same && b[i] == std::uint64_t{i} << 32;
    CHECK(same);
}

TEST_CASE("reserved memory lies in the rest of one block and in one more, cold and warm", "[core][workspace]")
{
    test::counting_memory counted;
    workspace space{counted.source()};
    for (int round = 0; round < 2; ++round) {
        workspace::scope a{space};
        REQUIRE(a.take<char>(1000) != nullptr);
        REQUIRE(a.reserve(64 * 2000));
        const std::size_t before = counted.requests;
        const char* last = nullptr;
        std::size_t apart = 0;
        for (int i = 0; i < 2000; ++i) {
            const char* const next = a.take<char>(33);
            REQUIRE(next != nullptr);
            apart += last != nullptr && next != last + 64;
            last = next;
        }
        CHECK(apart <= 1);  // where what was left of the first block ends
        CHECK(counted.requests == before);
        CHECK_FALSE(a.reserve(~std::size_t{0}));
    }
}

TEST_CASE("a trimmed workspace is empty, and takes anew what it needs", "[core][workspace]")
{
    test::counting_memory counted;
    workspace space{counted.source()};
    const auto work = [&] {
        workspace::scope a{space};
        for (const std::size_t n : {100u, 100'000u, 1'000'000u}) {
            auto* const block = a.take<char>(n);
            REQUIRE(block != nullptr);
            std::memset(block, 1, n);
        }
    };
    for (int round = 0; round < 3; ++round) {
        work();
        CHECK(space.capacity() > 1'000'000);
        space.trim();
        CHECK(space.capacity() == 0);
        CHECK(counted.bytes_held == 0);
        {
            workspace::scope little{space};
            CHECK(little.take<char>(100) != nullptr);
        }
        CHECK(space.capacity() < 100'000);  // what was needed once is forgotten
    }
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/core/workspace.hpp>

#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

using namespace typemesh;

TEST_CASE("blocks of a scope do not overlap, are aligned, and hold until it ends", "[core][workspace]")
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

TEST_CASE("what an inner scope took is given back, what the outer took stays", "[core][workspace]")
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

TEST_CASE("a workspace without memory gives null and stays usable", "[core][workspace]")
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

TEST_CASE("absurd sizes are refused, zero is not", "[core][workspace]")
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

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/core/buffer.hpp>

#include <cstdint>
#include <cstring>
#include <new>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

std::vector<int> values(const buffer<int>& b) { return {b.begin(), b.end()}; }

}  // namespace

TEST_CASE("a buffer keeps what was put into it, in order, while it grows", "[core][buffer]")
{
    buffer<int> b;
    std::vector<int> expected;
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(b.push_back(i));
        expected.push_back(i);
        if (i % 7 == 0) {
            const int more[] = {-i, -i - 1, -i - 2};
            REQUIRE(b.append(more));
            expected.insert(expected.end(), more, more + 3);
        }
        if (i % 11 == 0) {
            int* raw = b.append(2);
            REQUIRE(raw != nullptr);
            raw[0] = raw[1] = i;
            expected.insert(expected.end(), 2, i);
        }
    }
    CHECK(values(b) == expected);
    CHECK(b.size() == expected.size());
    CHECK(b.back() == expected.back());
    CHECK(b.view().size() == expected.size());
}

TEST_CASE("a value of the buffer itself can be appended while it grows", "[core][buffer]")
{
    buffer<int> b;
    REQUIRE(b.push_back(42));
    for (int i = 0; i < 100; ++i) REQUIRE(b.push_back(b[0]));
    CHECK(values(b) == std::vector<int>(101, 42));
}

TEST_CASE("a subrange of the buffer itself can be appended while it grows", "[core][buffer]")
{
    buffer<int> b;
    REQUIRE(b.append(std::span<const int>{}));
    for (int i = 0; i < 20; ++i) REQUIRE(b.push_back(i));
    std::vector<int> expected = values(b);
    while (b.size() < 5000) {
        const std::size_t from = b.size() / 3, count = b.size() / 2;
        for (std::size_t i = 0; i < count; ++i) expected.push_back(expected[from + i]);
        REQUIRE(b.append(b.view().subspan(from, count)));
    }
    CHECK(values(b) == expected);
}

TEST_CASE("a buffer that grows reads appended values before it frees them", "[core][buffer]")
{
    const memory overwriting{
        nullptr,
        [](void*, std::size_t bytes, std::size_t) noexcept -> void* { return ::operator new(bytes, std::nothrow); },
        [](void*, void* block, std::size_t bytes, std::size_t) noexcept {
            std::memset(block, 0x5A, bytes);
            ::operator delete(block);
        }};
    buffer<int> b{overwriting};
    std::vector<int> expected;
    for (int round = 0; round < 6; ++round) {
        std::vector<int> more(b.capacity() - b.size() + 1);  // so that it grows
        std::iota(more.begin(), more.end(), round);
        REQUIRE(b.append(std::span<const int>{more}));
        expected.insert(expected.end(), more.begin(), more.end());
        const std::vector<int> twice = expected;
        REQUIRE(b.append(b.view()));
        REQUIRE(b.append(b.view()));
        for (int i = 0; i < 3; ++i) expected.insert(expected.end(), twice.begin(), twice.end());
        CHECK(values(b) == expected);
    }
}

TEST_CASE("clear and truncate keep the storage", "[core][buffer]")
{
    test::counting_memory counted;
    {
        buffer<int> b{counted.source()};
        CHECK(counted.requests == 0);  // an empty buffer asks for nothing
        REQUIRE(b.reserve(100));
        for (int round = 0; round < 3; ++round) {
            for (int i = 0; i < 100; ++i) b.push_back_unchecked(i);
            b.truncate(10);
            CHECK(b.size() == 10);
            CHECK(b.back() == 9);
            b.clear();
            CHECK(b.empty());
        }
        CHECK(counted.requests == 1);
        CHECK(b.capacity() == 100);
    }
    CHECK(counted.bytes_held == 0);
}

TEST_CASE("a buffer grows geometrically: n values take O(log n) requests", "[core][buffer]")
{
    test::counting_memory counted;
    buffer<std::uint64_t> b{counted.source()};
    for (std::uint64_t i = 0; i < 100000; ++i) REQUIRE(b.push_back(i));
    CHECK(counted.requests < 20);
    CHECK(std::accumulate(b.begin(), b.end(), std::uint64_t{0}) == std::uint64_t{99999} * 50000);
}

TEST_CASE("a buffer that cannot grow reports it and keeps its values", "[core][buffer]")
{
    test::counting_memory failing{.fail_at = 2};
    {
        buffer<int> b{failing.source()};
        REQUIRE(b.push_back(1));
        const std::size_t capacity = b.capacity();
        while (b.size() < capacity) REQUIRE(b.push_back(2));
        CHECK(!b.push_back(3));
        CHECK(b.append(1) == nullptr);
        const int more[] = {4, 5};
        CHECK(!b.append(more));
        CHECK(!b.reserve(capacity + 1));
        CHECK(b.size() == capacity);
        CHECK(b[0] == 1);
        CHECK(b.append(std::span<const int>{}));  // nothing needs no memory
    }
    CHECK(failing.bytes_held == 0);
}

TEST_CASE("a buffer refuses absurd sizes without a request for memory", "[core][buffer]")
{
    test::counting_memory counted;
    buffer<std::uint64_t> b{counted.source()};
    CHECK(!b.reserve(~std::size_t{0}));
    CHECK(!b.reserve(~std::size_t{0} / sizeof(std::uint64_t)));
    CHECK(b.append(~std::size_t{0} - 1) == nullptr);
    CHECK(counted.requests == 0);
}

TEST_CASE("moving a buffer moves its storage with its memory", "[core][buffer]")
{
    test::counting_memory one, two;
    {
        buffer<int> a{one.source()}, b{two.source()};
        REQUIRE(a.push_back(1));
        REQUIRE(b.push_back(2));
        buffer<int> c = std::move(a);
        CHECK(values(c) == std::vector<int>{1});
        REQUIRE(a.push_back(7));  // the emptied one is still good
        b = std::move(c);
        CHECK(values(b) == std::vector<int>{1});
        a.swap(b);
        CHECK(values(a) == std::vector<int>{1});
        CHECK(values(b) == std::vector<int>{7});
    }
    CHECK(one.bytes_held == 0);
    CHECK(two.bytes_held == 0);
}

TEST_CASE("a buffer's storage is aligned for its type", "[core][buffer]")
{
    struct alignas(64) line {
        char bytes[64];
    };
    buffer<line> b;
    REQUIRE(b.append(3) != nullptr);
    CHECK(reinterpret_cast<std::uintptr_t>(b.data()) % 64 == 0);
}

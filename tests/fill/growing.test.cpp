// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/growing.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

TEST_CASE("a growing array keeps its values however often it moves", "[fill][growing]")
{
    workspace space;
    workspace::scope scratch{space};
    detail::growing<std::uint32_t> numbers{scratch};
    for (std::uint32_t i = 0; i < 5000; ++i) {
        REQUIRE(numbers.add(i * i));
        REQUIRE(numbers.count == i + 1);
        REQUIRE(numbers.room >= numbers.count);
    }
    for (std::uint32_t i = 0; i < 5000; ++i) REQUIRE(numbers.values[i] == i * i);
    REQUIRE(numbers.reserve(20'000));
    CHECK(numbers.room == 20'000);
    CHECK(numbers.values[4999] == 4999u * 4999u);
}

TEST_CASE("a growing array without memory keeps its values", "[fill][growing]")
{
    test::counting_memory failing{.fail_at = 2};
    workspace space{failing.source()};
    workspace::scope scratch{space};
    detail::growing<std::uint32_t> numbers{scratch};
    std::uint32_t added = 0;
    while (added < 1'000'000 && numbers.add(added)) ++added;
    REQUIRE(added < 1'000'000);
    CHECK(numbers.count == added);
    for (std::uint32_t i = 0; i < added; ++i) REQUIRE(numbers.values[i] == i);
    CHECK_FALSE(numbers.reserve(1'000'000));
    CHECK(numbers.count == added);
}

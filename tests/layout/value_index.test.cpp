// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/layout/impl/value_index.hpp>

#include <vector>

using namespace typemesh;

namespace {

/// A number that counts how often it is compared. Its hash has few values if wanted.
struct indexed_number {
    std::uint64_t number = 0;
    std::size_t* comparisons = nullptr;
    std::uint64_t hashes = 0xFFFF'FFFFu;

    friend bool operator==(const indexed_number& a, const indexed_number& b) noexcept
    {
        if (a.comparisons != nullptr) ++*a.comparisons;
        return a.number == b.number;
    }
    friend std::uint64_t hash_of(const indexed_number& c) noexcept
    {
        return (c.number * 0x9E37'79B9'7F4A'7C15u >> 32) % c.hashes;
    }
};

}  // namespace

TEST_CASE("values of a growing table are found, each with a few comparisons", "[layout]")
{
    for (const std::size_t count : {100u, 1'000u, 10'000u, 100'000u}) {
        std::size_t comparisons = 0;
        std::vector<indexed_number> table;
        value_index<indexed_number> index;
        for (std::size_t i = 0; i < 2 * count; ++i) {
            const indexed_number value{i / 2 * 7919, &comparisons};
            REQUIRE(index.read(table));
            const std::size_t found = index.find(table, value);
            REQUIRE(found == (i % 2 != 0 ? i / 2 : table.size()));
            if (found == table.size()) table.push_back(value);
        }
        CHECK(comparisons >= count);
        CHECK(comparisons <= 4 * count);
    }
}

TEST_CASE("values of one hash are found, even in a table that has lost some", "[layout]")
{
    std::vector<indexed_number> table;
    value_index<indexed_number> index;
    CHECK(index.find(table, {}) == 0);
    for (std::uint64_t round = 0; round < 50; ++round) {
        for (std::uint64_t i = 0; i < 20; ++i) {
            const indexed_number value{1'000 * round + i, nullptr, 3};
            REQUIRE(index.read(table));
            CHECK(index.find(table, value) == table.size());
            table.push_back(value);
        }
        REQUIRE(index.read(table));
        for (std::size_t i = 0; i < table.size(); ++i) CHECK(index.find(table, table[i]) == i);
        table.resize(5);
        REQUIRE(index.read(table));
        CHECK(index.find(table, {1'000 * round + 7, nullptr, 3}) == 5);
    }
    index.clear();
    CHECK(index.find(table, table[0]) == 5);
}

TEST_CASE("an index without memory knows nothing, and a warm one needs none", "[layout]")
{
    const std::vector<indexed_number> table(100);
    test::counting_memory failing{.fail_at = 1};
    value_index<indexed_number> poor{failing.source()};
    CHECK_FALSE(poor.read(table));
    CHECK(poor.find(table, {}) == 100);
    test::counting_memory counting;
    value_index<indexed_number> index{counting.source()};
    REQUIRE(index.read(table));
    const std::size_t warm = counting.requests;
    index.clear();
    REQUIRE(index.read(table));
    CHECK(counting.requests == warm);
}

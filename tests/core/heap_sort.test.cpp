// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/impl/heap_sort.hpp>

#include <algorithm>
#include <random>
#include <vector>

TEST_CASE("heap_sort() orders any values, by a comparison or by their own before()", "[core]")
{
    struct key {
        int value;
        bool before(const key& other) const noexcept { return value < other.value; }
    };
    std::mt19937 random{5};
    for (std::size_t n = 0; n < 200; ++n) {
        std::vector<int> values, expected;
        std::vector<key> keys;
        for (std::size_t i = 0; i < n; ++i) {
            values.push_back(static_cast<int>(random() % 50));
            keys.push_back({values.back()});
        }
        expected = values;
        std::sort(expected.begin(), expected.end());
        typemesh::detail::heap_sort(values.data(), n, [](int a, int b) noexcept { return a < b; });
        typemesh::detail::heap_sort(keys.data(), n);
        CHECK(values == expected);
        for (std::size_t i = 0; i < n; ++i) REQUIRE(keys[i].value == expected[i]);
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/core/impl/mixed_key.hpp>

#include "support/catch.hpp"

#include <bit>
#include <set>
#include <vector>

using namespace typemesh;

TEST_CASE("mixed keys depend on the values, the order and the count of their numbers", "[mixed_key]")
{
    std::set<std::uint64_t> keys;
    std::size_t made = 0;
    const std::uint64_t one = 1;
    const std::vector<std::uint64_t> numbers{
        0, 1, 2, 3, one << 32, one << 63, std::bit_cast<std::uint64_t>(400.0), std::bit_cast<std::uint64_t>(401.0)};
    for (const std::uint64_t a : numbers) {
        if (a == 0) continue;  // 0 mixed into 0 stays 0
        keys.insert(mixed_key(0, a));
        ++made;
        for (const std::uint64_t b : numbers) {
            keys.insert(mixed_key(mixed_key(0, a), b));
            ++made;
            for (const std::uint64_t c : numbers) {
                keys.insert(mixed_key(mixed_key(mixed_key(0, a), b), c));
                ++made;
            }
        }
    }
    CHECK(keys.size() == made);
}

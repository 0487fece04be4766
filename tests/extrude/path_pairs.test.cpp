// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/path_pairs.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <random>
#include <set>
#include <utility>

using namespace typemesh;

TEST_CASE("a set of pairs has what was added, in both orders, once each and in little memory", "[extrude]")
{
    std::mt19937 random{5};
    test::counting_memory counted;
    detail::path_pairs pairs{counted.source()};
    for (const std::uint32_t paths : {1u, 3u, 40u}) {
        pairs.clear();
        std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
        for (int i = 0; i < 3000; ++i) {
            const auto a = static_cast<std::uint32_t>(random() % paths), b = static_cast<std::uint32_t>(random() % 7);
            REQUIRE(pairs.add(a, b));
            wanted.insert({(std::min)(a, b), (std::max)(a, b)});
        }
        pairs.close();
        std::set<std::pair<std::uint32_t, std::uint32_t>> got;
        pairs.each([&](std::uint32_t a, std::uint32_t b) noexcept { got.insert({a, b}); });
        CHECK(got == wanted);
        CHECK(pairs.size() == wanted.size());
        for (std::uint32_t a = 0; a < 42; ++a)
            for (std::uint32_t b = 0; b < 42; ++b)
                CHECK(pairs.has(a, b) == (wanted.count({(std::min)(a, b), (std::max)(a, b)}) == 1));
    }
    CHECK(counted.requests < 10);
    detail::path_pairs copy;
    REQUIRE(copy.assign(pairs));
    CHECK(copy.size() == pairs.size());
    pairs.clear();
    CHECK(pairs.empty());
    test::counting_memory failing{.fail_at = 1};
    detail::path_pairs poor{failing.source()};
    CHECK_FALSE(poor.add(0, 1));
    CHECK_FALSE(detail::path_pairs{test::counting_memory{.fail_at = 1}.source()}.assign(copy));
}

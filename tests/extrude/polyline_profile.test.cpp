// SPDX-License-Identifier: MIT

#include <typemesh/extrude/polyline_profile.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a polyline profile gives its points back", "[polyline_profile]")
{
    const polyline_profile p{{{0, 0}, {0.25f, 0.5f}, {0.25f, 0.75f}, {1, 1}}};
    profile_points out;
    p({}, out);
    REQUIRE(out.view().size() == 4);
    CHECK(same(out.view()[2].t, 0.25f));
    CHECK(same(out.view()[2].h, 0.75f));

    const std::vector<profile_point> mine{{0, 0}, {0.5f, 0.1f}, {1, 1}};
    polyline_profile{profile_points{std::span<const profile_point>{mine}}}({}, out);
    CHECK(out.view().size() == 3);
}

TEST_CASE("polyline profiles of different points have different keys", "[polyline_profile]")
{
    const auto words = [](const polyline_profile& p) {
        const option_bits bits = p.cache_key();
        return std::array{bits.words[0], bits.words[1], bits.words[2], bits.words[3]};
    };
    std::set<std::array<std::uint64_t, 4>> keys;
    std::set<std::uint64_t> first, second;  // either hash alone
    std::size_t made = 0;
    const float numbers[] = {0.0f, 1.0f, 0.5f, 0.25f, 0.75f, 1e-8f, 0x1p-120f, 0.1f, 0.3f, 0.99999994f};
    for (const float a : numbers)
        for (const float b : numbers)
            for (const float c : numbers)
                for (const float d : numbers) {
                    const auto key = words({{{0, 0}, {a, b}, {c, d}, {1, 1}}});
                    keys.insert(key);
                    first.insert(key[2]);
                    second.insert(key[3]);
                    ++made;
                }
    CHECK(keys.size() == made);
    CHECK(first.size() == made);
    CHECK(second.size() == made);
    CHECK(words({{{0, 0}, {1, 1}}}) == words({{{0, 0}, {1, 1}}}));
    CHECK(words({{{0, 0}, {1, 1}}}) != words({{{0, 0}, {0, 0}, {1, 1}}}));
}

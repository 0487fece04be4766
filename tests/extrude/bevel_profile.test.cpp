// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevel_profile.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

const profile_scale any_scale{10000.0, 10000.0, 0.0};

bool same_points(const profile_points& a, const profile_points& b)
{
    return std::equal(a.view().begin(), a.view().end(), b.view().begin(), b.view().end(),
                      [](profile_point p, profile_point q) { return same(p.t, q.t) && same(p.h, q.h); });
}

}  // namespace

TEST_CASE("every ready profile is valid at every scale", "[bevel_profile]")
{
    for (const bevel_profile& p : {bevel_profile{}, chamfer_profile(), round_profile(), concave_profile(),
                                   stepped_profile(), engraved_profile(), bezier_profile({})})
        for (const double width : {0.0, 1.0, 100.0, 1e6, 1e9})
            for (const double depth : {0.0, 1.0, 5000.0, 1e9})
                for (const double tolerance : {0.0, 1e-9, 1.0, 300.0, 1e9})
                    CHECK(p.at({width, depth, tolerance}).is_valid());
}

TEST_CASE("two steps rise half the depth each, and an engraving is highest at half the width", "[bevel_profile]")
{
    CHECK(same_points(bevel_profile{}.at(any_scale), {{0, 0}, {1, 1}}));
    CHECK(same_points(chamfer_profile().at(any_scale), {{0, 0}, {1, 1}}));
    CHECK(same_points(stepped_profile().at(any_scale), {{0, 0}, {0.5f, 0}, {0.5f, 0.5f}, {1, 0.5f}, {1, 1}}));
    CHECK(same_points(engraved_profile().at(any_scale), {{0, 0}, {0.5f, 1}, {1, 0}}));
}

TEST_CASE("a profile of points returns its points", "[bevel_profile]")
{
    const bevel_profile p{{0, 0}, {0.25f, 0.5f}, {0.25f, 0.75f}, {1, 1}};
    CHECK(same_points(p.at(any_scale), {{0, 0}, {0.25f, 0.5f}, {0.25f, 0.75f}, {1, 1}}));

    const std::vector<profile_point> mine{{0, 0}, {0.5f, 0.1f}, {1, 1}};
    const bevel_profile of_span{profile_points{std::span<const profile_point>{mine}}};
    CHECK(same_points(of_span.at(any_scale), {{0, 0}, {0.5f, 0.1f}, {1, 1}}));
}

TEST_CASE("a sampled profile calls its function once per point, when it is made", "[bevel_profile]")
{
    float exponent = 2.0f;
    int calls = 0;
    const auto height = [&](float t) noexcept { return ++calls, exponent == 2.0f ? t * t : t; };  // NOLINT: exact
    const bevel_profile squared = sampled_profile(height, 4);
    CHECK(calls == 5);
    exponent = 1.0f;
    CHECK(same_points(squared.at(any_scale), {{0, 0}, {0.25f, 0.0625f}, {0.5f, 0.25f}, {0.75f, 0.5625f}, {1, 1}}));
    CHECK(calls == 5);
    CHECK_FALSE(squared.cache_key() == sampled_profile(height, 4).cache_key());
    CHECK(sampled_profile(height, 4).cache_key() == sampled_profile(height, 4).cache_key());
    CHECK(sampled_profile(height, 63).at(any_scale).is_valid());
    CHECK_FALSE(sampled_profile(height, 64).at(any_scale).is_valid());
    CHECK_FALSE(sampled_profile(height, 0).at(any_scale).is_valid());
    CHECK_FALSE(
        sampled_profile([](float t) noexcept { return 1.0f - t; }).at(any_scale).is_valid());  // not 0 at the wall
}

TEST_CASE("profiles that differ have different keys", "[bevel_profile]")
{
    const auto words = [](const bevel_profile& p) {
        const option_bits bits = p.cache_key();
        return std::array{bits.words[0], bits.words[1]};
    };
    std::set<std::array<std::uint64_t, 2>> keys;
    std::set<std::uint64_t> first, second;  // each hash by itself
    std::size_t made = 0;
    const auto add = [&](const bevel_profile& p) {
        const auto key = words(p);
        keys.insert(key);
        first.insert(key[0]);
        second.insert(key[1]);
        ++made;
    };
    const float numbers[] = {0.0f, 1.0f, 0.5f, 0.25f, 0.75f, 1e-8f, 0x1p-120f, 0.1f, 0.3f, 0.99999994f};
    for (const float a : numbers)
        for (const float b : numbers)
            for (const float c : numbers)
                for (const float d : numbers) {
                    add({{0, 0}, {a, b}, {c, d}, {1, 1}});
                    add(bezier_profile({{a, b}, {c, d}, 0.7f}, 6));
                }
    for (std::uint32_t steps = 0; steps < 64; ++steps) {
        add(round_profile(steps));
        add(concave_profile(steps));
        add(bezier_profile({}, steps));
    }
    add(bezier_profile({.end = 0.5f}));
    CHECK(keys.size() == made);
    CHECK(first.size() == made);
    CHECK(second.size() == made);
    CHECK(words({{0, 0}, {1, 1}}) == words(chamfer_profile()));
    CHECK(words({{0, 0}, {1, 1}}) != words({{0, 0}, {0, 0}, {1, 1}}));
}

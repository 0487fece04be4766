// SPDX-License-Identifier: MIT

#include <typemesh/extrude/profile_points.hpp>

#include <limits>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("a valid profile runs from (0, 0) to t = 1 within the bevel's depth, and never back", "[profile_points]")
{
    const profile_points good[] = {{{0, 0}, {1, 1}},
                                   {{0, 0}, {1, 0}},
                                   {{0, 0}, {0, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.2f}, {1, 1}},
                                   {{-0.0f, -0.0f}, {1, 1}, {1, 0}}};
    for (const auto& p : good) CHECK(p.is_valid());

    const profile_points bad[] = {{},
                                  {{0, 0}},
                                  {{1, 1}},
                                  {{0, 0.1f}, {1, 1}},
                                  {{0.1f, 0}, {1, 1}},
                                  {{0, 0}, {0.9f, 1}},
                                  {{0, 0}, {0.6f, 1}, {0.5f, 1}, {1, 1}},
                                  {{0, 0}, {1.1f, 1}, {1, 1}},
                                  {{0, 0}, {0.5f, 1.1f}, {1, 1}},
                                  {{0, 0}, {0.5f, -0.1f}, {1, 1}},
                                  {{0, 0}, {no_number, 0.5f}, {1, 1}},
                                  {{0, 0}, {0.5f, no_number}, {1, 1}},
                                  {{0, 0}, {0.5f, infinite}, {1, 1}},
                                  {{0, no_number}, {1, 1}},
                                  {{0, 0}, {1, no_number}}};
    for (const auto& p : bad) {
        INFO(&p - bad);
        CHECK_FALSE(p.is_valid());
    }
}

TEST_CASE("a profile of more than 64 points is not valid", "[profile_points]")
{
    std::vector<profile_point> many(profile_points::most, profile_point{0.5f, 0.5f});
    many.front() = {0.0f, 0.0f};
    many.back() = {1.0f, 1.0f};
    CHECK(profile_points{std::span<const profile_point>{many}}.is_valid());
    many.push_back({1.0f, 0.5f});
    const profile_points more{std::span<const profile_point>{many}};
    CHECK(more.view().size() == profile_points::most);
    CHECK_FALSE(more.is_valid());
}

// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/profile_levels.hpp>

#include <typemesh/extrude/bevel_profile.hpp>

#include <cstdint>
#include <random>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct expected_level {
    double distance;
    float arrives, leaves;
};

void check_levels(const profile_points& points, const profile_scale& scale,
                  std::initializer_list<expected_level> expected)
{
    const profile_levels made{points, scale};
    REQUIRE(made.view().size() == expected.size());
    std::size_t i = 0;
    for (const auto& e : expected) {
        INFO("level " << i);
        CHECK(made.view()[i].distance == Catch::Approx(e.distance));
        CHECK(made.view()[i].arrives == Catch::Approx(e.arrives));
        CHECK(made.view()[i].leaves == Catch::Approx(e.leaves));
        ++i;
    }
}

}  // namespace

TEST_CASE("a profile's points become levels, and equal distances become risers", "[profile_levels]")
{
    const profile_scale large{10000.0, 10000.0};
    check_levels({{0, 0}, {1, 1}}, large, {{0, 0, 0}, {10000, 1, 1}});
    check_levels({{0, 0}, {0.5f, 0}, {0.5f, 0.5f}, {1, 0.5f}, {1, 1}}, large,
                 {{0, 0, 0}, {5000, 0, 0.5f}, {10000, 0.5f, 1}});
    check_levels({{0, 0}, {0, 0.5f}, {0.25f, 1}, {0.25f, 0.75f}, {0.25f, 0.25f}, {1, 0.5f}}, large,
                 {{0, 0, 0.5f}, {2500, 1, 0.25f}, {10000, 0.5f, 0.5f}});
}

TEST_CASE("levels closer than four cells are merged, into a riser where they differ in height", "[profile_levels]")
{
    // 100 cells wide and deep: 0.03 are three cells
    const profile_scale small{100.0, 100.0};
    check_levels({{0, 0}, {0.5f, 0.5f}, {0.53f, 0.53f}, {1, 1}}, small, {{0, 0, 0}, {50, 0.515f, 0.515f}, {100, 1, 1}});
    check_levels({{0, 0}, {0.5f, 0.25f}, {0.53f, 0.75f}, {1, 1}}, small, {{0, 0, 0}, {50, 0.25f, 0.75f}, {100, 1, 1}});
    check_levels({{0, 0}, {0.03f, 0.03f}, {0.98f, 0.97f}, {1, 1}}, small, {{0, 0, 0}, {100, 1, 1}});
    check_levels({{0, 0}, {0.03f, 0.5f}, {0.98f, 0.5f}, {1, 1}}, small, {{0, 0, 0.5f}, {100, 0.5f, 1}});
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 1}}, {3.0, 100.0}, {{0, 0, 1}});  // narrow
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 1}}, {0.0, 100.0}, {{0, 0, 1}});
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 0}}, {3.0, 100.0}, {{0, 0, 0}});
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 0.03f}}, {3.0, 100.0}, {{0, 0.03f, 0.03f}});
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 0.05f}}, {3.0, 100.0}, {{0, 0, 0.05f}});
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 1}}, {100.0, 3.0}, {{0, 1, 1}, {100, 1, 1}});  // low
    check_levels({{0, 0}, {0.5f, 0.5f}, {1, 1}}, {3.0, 3.0}, {{0, 1, 1}});
}

TEST_CASE("levels of any profile rise by four cells or more and keep the profile's ends", "[profile_levels]")
{
    std::mt19937 random{7};
    std::uniform_int_distribution<int> step{0, 4};
    for (int run = 0; run < 2000; ++run) {
        float t[16] = {}, sum = 0.0f;
        for (int i = 1; i < 16; ++i) t[i] = sum += static_cast<float>(step(random));
        if (!(sum > 0.0f)) continue;
        profile_points points{{0, 0}};
        for (int i = 1; i < 16; ++i) points.add({i == 15 ? 1.0f : t[i] / sum, static_cast<float>(step(random)) / 4.0f});
        const profile_scale scale{static_cast<double>(10 * step(random)) + 3.0, 60.0 * step(random)};
        INFO(run << ": " << scale.width << " x " << scale.depth);
        REQUIRE(points.is_valid());

        const profile_levels made{points, scale};
        const auto levels = made.view();
        REQUIRE_FALSE(levels.empty());
        CHECK(is_zero(levels.front().distance));
        if (scale.width >= 4.0)
            CHECK(same(levels.back().distance, scale.width));
        else
            CHECK(levels.size() == 1);
        if (scale.depth >= 4.0) {
            CHECK(is_zero(levels.front().arrives));
            CHECK(same(levels.back().leaves, points.view().back().h));
        }
        for (std::size_t i = 0; i < levels.size(); ++i) {
            if (i != 0) CHECK(levels[i].distance - levels[i - 1].distance >= 4.0);
            const double riser = std::abs(double(levels[i].leaves) - levels[i].arrives) * scale.depth;
            if (levels[i].has_riser()) CHECK(riser >= 4.0);
        }
    }
}

TEST_CASE("leaning risers are four cells wide, before or after, where there is room", "[profile_levels]")
{
    const profile_scale leaning{1000.0, 1000.0, 0.0, true};
    check_levels({{0, 0}, {0.5f, 0.25f}, {0.5f, 0.75f}, {1, 1}}, leaning,
                 {{0, 0, 0}, {500, 0.25f, 0.25f}, {504, 0.75f, 0.75f}, {1000, 1, 1}});
    check_levels({{0, 0}, {1, 0.25f}, {1, 1}}, leaning, {{0, 0, 0}, {996, 0.25f, 0.25f}, {1000, 1, 1}});
    check_levels({{0, 0}, {0.995f, 0.25f}, {0.995f, 0.75f}, {1, 1}}, leaning,
                 {{0, 0, 0}, {991, 0.25f, 0.25f}, {995, 0.75f, 0.75f}, {1000, 1, 1}});
    check_levels({{0, 0}, {0, 0.5f}, {1, 1}}, leaning, {{0, 0, 0.5f}, {1000, 1, 1}});  // at the wall it goes on upright
    check_levels({{0, 0}, {0.005f, 0.2f}, {0.005f, 0.6f}, {0.01f, 1}, {1, 1}}, leaning,  // no room on either side
                 {{0, 0, 0}, {5, 0.4f, 0.4f}, {10, 1, 1}, {1000, 1, 1}});
}

TEST_CASE("leaning levels are four cells apart and have no risers, and their ends stay the same", "[profile_levels]")
{
    std::mt19937 random{5};
    for (int run = 0; run < 20000; ++run) {
        profile_points points;
        points.add({0, 0});
        float t = 0.0f;
        const auto share = [&] { return static_cast<float>(random() % 1001) / 1000.0f; };
        for (auto n = random() % 62; n > 0; --n) {
            if (random() % 2 == 0) t += (1.0f - t) * share() * share();
            points.add({t, share()});
        }
        points.add({1, share()});
        const double width = 1.0 + 3000.0 * static_cast<double>(share());
        const profile_scale upright{width, 500.0}, leaning{width, 500.0, 0.0, true};
        const profile_levels plain{points, upright}, made{points, leaning};
        const auto levels = made.view();
        REQUIRE(levels.size() <= profile_points::most);
        CHECK(levels.front().distance == 0.0);
        CHECK(levels.front().arrives == plain.view().front().arrives);
        CHECK(levels.back().distance == plain.view().back().distance);
        CHECK(levels.back().leaves == plain.view().back().leaves);
        for (std::size_t i = 1; i < levels.size(); ++i) {
            CHECK_FALSE(levels[i].has_riser());
            CHECK(levels[i].distance - levels[i - 1].distance >= profile_levels::finest - 1e-9);  // of rounding
        }
        bool had_risers = false;
        for (const profile_level& l : plain.view().subspan(1)) had_risers = had_risers || l.has_riser();
        CHECK((had_risers || levels.size() == plain.view().size()));
    }
}

// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_carver.hpp>

#include <typemesh/extrude/bevel_profile.hpp>

#include <vector>

#include "shapes.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct outcome {
    error failure;
    double width;  ///< as a share of the bar's
    bool narrowed;
    int caps;
};

/// Carves a bar with a bevel as wide as a share of the bar; its cap is refused with these errors, one after the other.
outcome carved(double share, bool fits, const std::vector<error>& refusals = {})
{
    const auto bar = shapes::rectangle();
    const double all = 400.0 * bar.loops.grid.cells;
    bevel_carver carve{.sweep = {}, .fits = fits, .narrowed = true};
    profile_scale scale{share * all, 4096.0, 0.0};
    const auto points = [](const profile_scale& at) noexcept { return chamfer_profile().at(at); };
    workspace space;
    swept_region out;
    outcome found{};
    const auto make = [&](const swept_region& swept) noexcept {
        if (swept.levels.size() > 1) CHECK(same(swept.levels.back(), scale.width));
        const auto k = static_cast<std::size_t>(found.caps++);
        return k < refusals.size() ? refusals[k] : error{};
    };
    found.failure = carve({bar.made(), bar.cap}, points, scale, space, out, make);
    found.width = scale.width / all;
    found.narrowed = carve.narrowed;
    return found;
}

}  // namespace

TEST_CASE("a carver keeps the width, or makes it fit, and reports only refused caps as narrowed", "[bevel_carver]")
{
    const auto whole = carved(0.4, false);
    CHECK_FALSE(whole.failure);
    CHECK(whole.width == Catch::Approx(0.4));
    CHECK_FALSE(whole.narrowed);
    CHECK(whole.caps == 1);
    CHECK_FALSE(carved(3.0, false).narrowed);

    const auto fitted = carved(3.0, true);
    CHECK(fitted.width == Catch::Approx(0.45));
    CHECK_FALSE(fitted.narrowed);
    CHECK(fitted.caps == 1);
}

TEST_CASE("a carver halves the width each time the cap is refused, and reports it", "[bevel_carver]")
{
    constexpr error::kind refusal = error::crossing_contours;
    const auto once = carved(0.4, false, {refusal});
    CHECK_FALSE(once.failure);
    CHECK(once.width == Catch::Approx(0.2));
    CHECK(once.narrowed);
    const auto twice = carved(0.4, false, {refusal, refusal});
    CHECK(twice.width == Catch::Approx(0.1));
    CHECK(twice.narrowed);
    const auto fitted = carved(3.0, true, {refusal});
    CHECK(fitted.width == Catch::Approx(0.225));
    CHECK(fitted.narrowed);

    const auto ended = carved(0.4, false, {refusal, error::out_of_memory});
    CHECK(ended.failure == error::out_of_memory);
    CHECK(ended.caps == 2);
}

TEST_CASE("a carver gives up when every cap is refused", "[bevel_carver]")
{
    std::vector<error> refusals(100, error{error::crossing_contours});
    const auto never = carved(0.4, false, refusals);
    CHECK(never.failure == error::crossing_contours);
    CHECK(never.caps < 40);
}

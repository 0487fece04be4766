// SPDX-License-Identifier: MIT
#include <typemesh/discretise/adaptive_subdivision.hpp>

#include "support/catch.hpp"

#include "discretise/curves.hpp"

#include <type_traits>

using namespace typemesh;
using namespace test;

namespace {

using list = std::vector<double>;

// Its left half is (0,0) (0,2) (2,3) (4,3): its segments are 1.2 apart, and the lines through its midpoint (1.25, 2.25)
// turn by 0.7974 rad. The segments of that half's halves are 0.41279 and 0.28504 apart.
const curve cubic_arch = curve::from(cubic{{0, 0}, {0, 4}, {8, 4}, {8, 0}});

// Its left half is (0,0) (1,2) (2,-2) (3,0): an S whose segments cross.
const curve wave = curve::from(cubic{{0, 0}, {2, 4}, {4, -16}, {6, 36}});

}  // namespace

// What suits one em does not suit another, so there is no default distance.
static_assert(!std::is_default_constructible_v<adaptive_subdivision>);

TEST_CASE("adaptive_subdivision halves even a straight curve once", "[adaptive_subdivision]")
{
    const adaptive_subdivision how = GENERATE(adaptive_subdivision{.distance = 0.5}, adaptive_subdivision{0, 1e9, 4.0},
                                              adaptive_subdivision{15, 1e9, 4.0});
    CHECK(ts_of(how, curve::from(cubic{{0, 0}, {1, 0}, {2, 0}, {3, 0}})) == list{0.5, 1.0});
    CHECK(ts_of(how, curve::from(quadratic{{0, 0}, {1, 0}, {3, 0}})) == list{0.5, 1.0});
    CHECK(ts_of(how, curve::from(quadratic{{1, 1}, {1, 1}, {1, 1}})) == list{0.5, 1.0});
}

TEST_CASE("adaptive_subdivision makes a half one line if its segments are closer than the distance",
          "[adaptive_subdivision]")
{
    CHECK(ts_of(adaptive_subdivision{15, 1.201, 0.0}, cubic_arch) == list{0.5, 1.0});
    CHECK(ts_of(adaptive_subdivision{15, 1.199, 0.0}, cubic_arch) == list{0.25, 0.5, 0.75, 1.0});
    CHECK(ts_of(adaptive_subdivision{15, 0.4129, 0.0}, cubic_arch) == list{0.25, 0.5, 0.75, 1.0});
    CHECK(ts_of(adaptive_subdivision{3, 0.4127, 0.0}, cubic_arch) == list{0.125, 0.25, 0.5, 0.75, 0.875, 1.0});
}

TEST_CASE("adaptive_subdivision makes a half one line if it turns by less than the angle", "[adaptive_subdivision]")
{
    CHECK(ts_of(adaptive_subdivision{15, 0.0, 0.798}, cubic_arch) == list{0.5, 1.0});
    CHECK(ts_of(adaptive_subdivision{2, 0.0, 0.797}, cubic_arch) == list{0.25, 0.5, 0.75, 1.0});
}

TEST_CASE("adaptive_subdivision stops after r levels, at multiples of t = 2^-r", "[adaptive_subdivision]")
{
    const std::uint32_t levels = GENERATE(1u, 2u, 5u, 9u);
    const auto points = points_of(adaptive_subdivision{levels, 0.0, 0.0}, cubic_arch, 1.0);
    REQUIRE(points.size() == std::size_t{1} << levels);
    for (std::size_t i = 0; i < points.size(); ++i) {
        REQUIRE(points[i].t == static_cast<double>(i + 1) / static_cast<double>(points.size()));
        REQUIRE(length(points[i].p - cubic_arch.at(points[i].t)) < 1e-14);
    }
    CHECK(points.back().p == cubic_arch.end());
}

TEST_CASE("adaptive_subdivision treats more than 20 levels as 20", "[adaptive_subdivision]")
{
    std::size_t count = 0;
    adaptive_subdivision{1000, 0.0, 0.0}(cubic_arch.as_cubic(), 1.0, [&](point, double) noexcept { ++count; });
    CHECK(count <= std::size_t{1} << 20);
    CHECK(count > std::size_t{1} << 19);
}

TEST_CASE("adaptive_subdivision makes an S with crossing segments one line, as the thesis does",
          "[adaptive_subdivision]")
{
    const auto ts = ts_of(adaptive_subdivision{15, 1e-9, 0.0}, wave);
    REQUIRE(ts.front() == 0.5);
    CHECK(chord_error(wave, 0.0, 0.5) > 0.5);
}

TEST_CASE("adaptive_subdivision raises quadratics to cubics and ignores the tolerance", "[adaptive_subdivision]")
{
    const quadratic q{{0, 0}, {50, 100}, {90, 0}};
    const auto how = adaptive_subdivision::high(64.0);
    CHECK(ts_of(how, curve::from(q), 1e-9) == ts_of(how, curve::from(raised(q)), 1e9));
}

TEST_CASE("adaptive_subdivision's presets are the thesis' at 64 units per em, and scale", "[adaptive_subdivision]")
{
    const auto same = [](const adaptive_subdivision& a, std::uint32_t levels, double distance, double angle) {
        return a.levels == levels && a.distance == Approx(distance) && a.angle == angle;
    };
    CHECK(same(adaptive_subdivision::normal(64.0), 5, 0.5, 0.01));
    CHECK(same(adaptive_subdivision::high(64.0), 15, 0.1, 0.01));
    CHECK(same(adaptive_subdivision::best(64.0), 15, 0.005, 0.01));
    CHECK(same(adaptive_subdivision::best(2048.0), 15, 0.16, 0.01));
}

TEST_CASE("adaptive_subdivision makes the recorded number of chords for real fonts", "[adaptive_subdivision]")
{
    struct record {
        std::uint32_t degree;
        std::size_t normal, high, best;
    };
    const record r = GENERATE(record{2, 537, 723, 3023}, record{3, 660, 1342, 5956});
    std::size_t normal = 0, high = 0, best = 0;
    for (const font_curve& f : font_curves(r.degree)) {
        normal += ts_of(adaptive_subdivision::normal(f.units_per_em), f.c).size();
        high += ts_of(adaptive_subdivision::high(f.units_per_em), f.c).size();
        best += ts_of(adaptive_subdivision::best(f.units_per_em), f.c).size();
    }
    CHECK(normal == r.normal);
    CHECK(high == r.high);
    CHECK(best == r.best);
}

// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/ray.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace typemesh;
using detail::ray;

namespace {

/// To the right, or straight up.
ray random_ray(test::dice& d, std::int32_t reach, std::uint32_t number)
{
    const std::int32_t x = d.roll(reach);
    return {x, x == 0 ? 1 + d.roll(reach) : d.roll(2 * reach) - reach, number};
}

}  // namespace

TEST_CASE("rays are sorted by angle, and equal ones by number", "[fill][ray]")
{
    test::dice d{14};
    for (const std::int32_t reach : {3, 1000}) {
        for (std::uint32_t n = 1; n < 60; ++n) {
            std::vector<ray> rays;
            for (std::uint32_t i = 0; i < n; ++i) rays.push_back(random_ray(d, reach, n - i));
            std::vector<ray> wanted = rays;
            std::sort(wanted.begin(), wanted.end(), [](const ray& a, const ray& b) {
                const double p = std::atan2(a.y, a.x), q = std::atan2(b.y, b.x);  // of such small numbers: exact enough
                return std::abs(p - q) > 1e-12 ? p < q : a.segment < b.segment;
            });
            sort_rays(rays.data(), n);
            for (std::uint32_t i = 0; i < n; ++i) REQUIRE(rays[i].segment == wanted[i].segment);
        }
    }
}

TEST_CASE("the order of rays is exact up to the largest differences on the grid", "[fill][ray]")
{
    constexpr std::int32_t most = 1 << 29;
    const ray a{most, most - 1, 0}, b{most - 1, most - 2, 1};  // cross = most (most - 2) - (most - 1)^2 = -1
    CHECK(a.cross(b) == -1);
    CHECK(b.before(a));
    CHECK_FALSE(a.before(b));
    CHECK(ray{most, -most, 0}.cross({most, most, 1}) == std::int64_t{1} << 59);
    CHECK(ray{2, 4, 5}.cross({1, 2, 3}) == 0);
    CHECK(ray{1, 2, 3}.before({2, 4, 5}));
}

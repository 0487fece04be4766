// SPDX-License-Identifier: MIT

#include <typemesh/inflate/impl/slope_fit.hpp>

#include "inflated_shape.hpp"

using namespace typemesh;

TEST_CASE("the slope of a polynomial of degree 2 with -Laplace = 1 is found around a point", "[inflate]")
{
    // A point in the middle of a hexagon on the boundary: the heights there are 0, so the polynomial has to vanish on it.
    for (const double turned : {0.0, 0.2, 0.4}) {
        test::refined_result cap;
        std::vector<grid_point> ring;
        constexpr double radius = 10000.0;
        const point off{2000.0, -1500.0};  // the centre of the circle that the ring lies on
        for (int i = 0; i < 9; ++i) {
            const double turn = turned + 2.0 * 3.14159265358979 * i / 9;
            REQUIRE(cap.loops.points.push_back({std::int32_t(std::lround(off.x + radius * std::cos(turn))),
                                                std::int32_t(std::lround(off.y + radius * std::sin(turn)))}));
        }
        REQUIRE(cap.inner.push_back({0, 0}));
        for (std::uint32_t i = 0; i < 9; ++i) REQUIRE(cap.triangles.push_back({i, (i + 1) % 9, 9}));
        const detail::membrane_mesh m{cap.loops.points.view(), cap.inner.view(), cap.triangles.view()};
        // u = (R^2 - |p - off|^2) / 4, a disc's
        const double u[] = {0.25 * (radius * radius - off.x * off.x - off.y * off.y)};
        detail::slope_fit fit;
        buffer<point> slopes;
        REQUIRE(fit(m, u, 8000.0, slopes));
        REQUIRE(slopes.size() == 1);
        CHECK(std::abs(slopes[0].x - 0.5 * off.x) < 2.0);
        CHECK(std::abs(slopes[0].y - 0.5 * off.y) < 2.0);
    }
}

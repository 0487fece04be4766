// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/morph_points.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

namespace {

double doubled_area(const morph_points& p, std::size_t key)
{
    double sum = 0.0;
    for (std::uint32_t c = 0; c < p.contours(); ++c)
        for (std::uint32_t i = p.starts[c], b = p.starts[c + 1] - 1; i < p.starts[c + 1]; b = i++) {
            const grid_point u = p.places[key * p.count() + b], v = p.places[key * p.count() + i];
            sum += static_cast<double>(u.x) * v.y - static_cast<double>(u.y) * v.x;
        }
    return sum;
}

}  // namespace

TEST_CASE("chords of moving points keep the tolerance at every place", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    REQUIRE_FALSE(outlines.record(axis, 'o', std::vector<axis_coordinate>{-16384, 0, 16384}));
    const grid g = *grid::fitting(1000.0, outlines.bounds());
    for (const double tolerance : {10.0, 1.0, 0.05}) {
        morph_points points;
        REQUIRE_FALSE(points.divide(outlines, tolerance, g));
        double most = 0.0;
        for (std::size_t k = 0; k < 2; ++k)
            for (int place = 0; place <= 8; ++place) {
                const double s = place / 8.0;
                for (std::uint32_t i = 0; i < points.count(); ++i) {
                    const contour_edge& e = points.edges[i];
                    std::uint32_t next = i + 1;
                    for (std::uint32_t c = 0; c < points.contours(); ++c)
                        if (next == points.starts[c + 1]) next = points.starts[c];
                    const auto at = [&](std::uint32_t p) {
                        return lerp(g.place(points.places[k * points.count() + p]),
                                    g.place(points.places[(k + 1) * points.count() + p]), s);
                    };
                    for (int j = 0; j <= 8; ++j) {
                        const double u = j / 8.0, t = as_double(e.t0) + u * (as_double(e.t1) - as_double(e.t0));
                        const point on =
                            lerp(outlines.curves(k)[e.curve].at(t), outlines.curves(k + 1)[e.curve].at(t), s);
                        most = std::max(most, length(on - lerp(at(i), at(next), u)));
                    }
                }
            }
        CHECK(most <= tolerance);
        CHECK(most > 0.2 * tolerance);  // no more points than needed
    }
}

TEST_CASE("reversed points and points divided by a chord enclose the same area", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    REQUIRE_FALSE(outlines.record(axis, '8', std::vector<axis_coordinate>{-16384, 16384}));
    const grid g = *grid::fitting(1000.0, outlines.bounds());
    morph_points points;
    REQUIRE_FALSE(points.divide(outlines, 1.0, g));
    const std::uint32_t n = points.count();
    const double before[] = {doubled_area(points, 0), doubled_area(points, 1)};
    points.reverse();
    for (std::size_t k = 0; k < 2; ++k) CHECK(doubled_area(points, k) == -before[k]);
    const std::vector<grid_point> places(points.places.begin(), points.places.end());
    REQUIRE_FALSE(points.place_all(outlines, g));
    CHECK(std::equal(places.begin(), places.end(), points.places.begin()));

    for (std::uint32_t u = 0; u < n; ++u)
        for (std::uint32_t v = u + 2; v < n && v - u < n - 1; ++v) {
            morph_points divided;
            REQUIRE_FALSE(divided.divide(outlines, 1.0, g));
            REQUIRE_FALSE(divided.split(0, u, v));
            REQUIRE_FALSE(divided.place_all(outlines, g));
            CHECK(divided.contours() == 2);
            CHECK(divided.count() == n + 2);
            CHECK(divided.is_chord(v - u));
            CHECK(divided.is_chord(n + 1));
            for (std::size_t k = 0; k < 2; ++k) CHECK(doubled_area(divided, k) == before[k]);
        }
}

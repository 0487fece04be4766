// SPDX-License-Identifier: MIT

// The ridges of generated and random shapes, turned and mirrored, against distances by brute force.

#include <typemesh/offset/find_ridges.hpp>
#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/filled_shape.hpp"
#include "support/letters.hpp"
#include "support/regions.hpp"
#include "support/ridge_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace ridge_shapes {

/// The ridges of a shape that is swept to a width.
struct found_ridges {
    test::filled_shape made;
    swept_region swept;
    buffer<ridge_point> all;
    double tolerance;

    found_ridges(const test::shape& s, double width, double degrees, double tolerance_of = 200.0)
        : made{s}, tolerance{tolerance_of}
    {
        CAPTURE(s);
        workspace space;
        triangle_list cut;
        REQUIRE_FALSE(constrained_delaunay{}(made.filled, space, cut));
        workspace::scope scratch{space};
        const double levels[] = {0.0, width};
        sweep_options how;
        how.levels = levels;
        how.mitre_limit = 1.0;
        how.tolerance = tolerance;
        REQUIRE_FALSE(sweep_inwards(made.filled, cut.view(), how, scratch, swept));
        const double crease = std::cos(degrees * test::turn_once / 360);
        const auto turns = [&](std::uint32_t i) noexcept { return turn_at(i) > degrees; };
        REQUIRE_FALSE(find_ridges(made.filled, swept, crease, turns, scratch, all));
    }
    /// The angle by which the outline turns at a point, in degrees.
    [[nodiscard]] double turn_at(std::uint32_t i) const
    {
        const auto points = made.filled.points();
        std::size_t k = 0;
        while (i >= made.filled.starts()[k + 1]) ++k;
        const std::uint32_t first = made.filled.starts()[k], end = made.filled.starts()[k + 1];
        const grid_point a = points[i == first ? end - 1 : i - 1], b = points[i],
                         c = points[i + 1 == end ? first : i + 1];
        const double x = double(b.x) - a.x, y = double(b.y) - a.y, u = double(c.x) - b.x, v = double(c.y) - b.y;
        return std::atan2(std::fabs(x * v - y * u), x * u + y * v) * 360 / test::turn_once;
    }
    /// With the outlines of the floor.
    [[nodiscard]] test::ridge_laws laws()
    {
        const contours& floor = swept.cap;
        const auto at = static_cast<float>(swept.levels.back());
        for (std::uint32_t k = 0; k < floor.contour_count(); ++k)
            for (std::uint32_t i = floor.starts[k]; i <= floor.starts[k + 1]; ++i)
                REQUIRE(all.push_back({floor.points[i == floor.starts[k + 1] ? floor.starts[k] : i], at,
                                       i == floor.starts[k] ? ridge_step::floor : ridge_step::on}));
        return {made.filled, all.view(), tolerance, floor.points.empty() ? 0.0 : swept.levels.back()};
    }
    [[nodiscard]] std::size_t count() const
    {
        std::size_t n = 0;
        for (const ridge_point& p : all) n += p.step != ridge_step::on;
        return n;
    }
};

/// A width at which nothing of a shape is left.
double all_of(const test::shape& s)
{
    box around;
    for (const auto& l : s.loops)
        for (const grid_point p : l) around.add({double(p.x), double(p.y)});
    return 0.5 * (std::min)(around.width(), around.height()) + 16.0;
}

std::vector<test::shape> ridge_lawful_shapes()
{
    std::vector<test::shape> all{
        {"square", {test::square(0, 0, 300'000)}},  {"T", {test::letter_tee(100'000)}},
        {"H", {test::letter_aitch(100'000)}},       {"disc", {test::circle(64, 200'000)}},
        {"star", {test::star(14, 400'000, 5)}},     {"wild star", {test::star(40, 900'000, 8)}},
        {"spiral", {test::spiral(60, 2.3, 60'000)}}};
    all.push_back(test::square_with_holes(2, 12, 200'000));
    all.push_back({"frame", {test::square(0, 0, 300'000), test::reversed(test::square(90'000, 80'000, 100'000))}});
    all.push_back({"two", {test::square(0, 0, 300'000), test::circle(20, 90'000, 600'000, 0)}});
    return all;
}

}  // namespace ridge_shapes

TEST_CASE("ridges of simple shapes are the known ones", "[offset][ridges]")
{
    using namespace ridge_shapes;
    const auto lines_of = [](const test::polyline& l, double width) {
        return found_ridges{{"shape", {l}}, width, 0.0}.count();
    };
    CHECK(lines_of(test::square(0, 0, 300'000), 150'016) == 4);                               // to its middle
    CHECK(lines_of({{0, 0}, {500'000, 0}, {500'000, 300'000}, {0, 300'000}}, 150'016) == 5);  // a roof
    CHECK(lines_of({{0, 0}, {500'000, 0}, {100'000, 400'000}}, 200'016) == 3);                // a triangle
    CHECK(lines_of({{0, 0}, {500'000, 0}, {500'000, 300'000}, {0, 300'000}}, 50'000) == 4);   // up to the floor
    // An L as wide as high: two strokes, which meet in the ridge from the outer corner, with two corners at each end.
    CHECK(lines_of({{0, 0}, {400'000, 0}, {400'000, 100'000}, {100'000, 100'000}, {100'000, 400'000}, {0, 400'000}},
                   50'016) == 7);
    // The middle of a square is at half its size.
    const found_ridges square{{"square", {test::square(0, 0, 300'000)}}, 150'016, 0.0};
    float deepest = 0.0f;
    for (const ridge_point& p : square.all) {
        CHECK((p.distance > 0.0f || p.at.x == 0 || p.at.x == 300'000));
        if (p.distance > deepest) deepest = p.distance;
    }
    CHECK(std::fabs(double(deepest) - 150'000.0) <= 1.0);
    // A hole gives a ring: a square frame has 8 corners, of which 4 are convex. Its ring bends at their ridges.
    const found_ridges frame{
        {"frame", {test::square(0, 0, 300'000), test::reversed(test::square(100'000, 100'000, 100'000))}},
        150'016,
        0.0};
    CHECK(frame.count() == 8);
    // A smooth ring has its ring alone, closed.
    const test::shape ring{"ring", {test::circle(90, 300'000), test::reversed(test::circle(90, 200'000))}};
    found_ridges smooth{ring, 300'016, 15.0};
    CHECK(smooth.count() == 1);
    CHECK(smooth.laws().closed == 1);
    // All corners of a disc of 64 corners are softer than 15 degrees: its middle is left.
    const found_ridges disc{{"disc", {test::circle(64, 200'000)}}, 200'016, 15.0};
    REQUIRE_FALSE(disc.all.empty());
    for (const ridge_point& p : disc.all) {
        CHECK(std::hypot(double(p.at.x), double(p.at.y)) < 64.0);
        CHECK(double(p.distance) > 199'000.0);
    }
}

TEST_CASE("ridges are as deep as they are far from the outline, and connected as the shape is", "[offset][ridges]")
{
    using namespace ridge_shapes;
    double too_deep = 0.0, too_shallow = 0.0;
    std::size_t lines = 0, valleys = 0, points = 0;
    for (const test::shape& s : ridge_lawful_shapes())
        for (const double degrees : {0.0, 90.0, 30.0})
            for (const test::shape& turned : {test::turned(s, degrees), test::mirrored(test::turned(s, degrees))})
                for (const double share : {1.0, 0.05})
                    for (const double crease : {0.0, 20.0}) {
                        CAPTURE(turned, share, crease);
                        found_ridges found{turned, share * all_of(turned), crease};
                        const test::ridge_laws laws = found.laws();
                        CHECK(laws.broken() == "");
                        if (crease <= 0.0) CHECK(laws.soft_ends == 0);
                        too_deep = (std::max)(too_deep, laws.too_deep);
                        too_shallow = (std::max)(too_shallow, laws.too_shallow);
                        lines += laws.lines;
                        valleys += laws.valleys;
                        points += laws.points;
                    }
    CAPTURE(too_deep, too_shallow, lines, valleys, points);
    CHECK(too_deep < 2.0);
    CHECK(too_shallow <= 0.0);
    CHECK(lines > 1000);
    CHECK(100 * valleys < points);
}

TEST_CASE("a mirrored shape has mirrored ridges", "[offset][ridges]")
{
    using namespace ridge_shapes;
    // Both sweeps round each node by up to a cell, so points are compared within three.
    const auto ends_of = [](const found_ridges& f, bool mirror) {
        std::vector<std::pair<int, int>> all;
        for (std::size_t i = 0; i < f.all.size(); ++i) {
            const bool last = i + 1 == f.all.size() || f.all[i + 1].step != ridge_step::on;
            if (f.all[i].step == ridge_step::on && !last) continue;
            all.push_back(mirror ? std::pair{f.all[i].at.y, f.all[i].at.x} : std::pair{f.all[i].at.x, f.all[i].at.y});
        }
        return all;
    };
    for (const test::shape& s : ridge_lawful_shapes()) {
        CAPTURE(s.name);
        const double width = all_of(s);
        const found_ridges one{s, width, 20.0}, other{test::mirrored(s), width, 20.0};
        CHECK(one.count() == other.count());
        const auto here = ends_of(one, false), there = ends_of(other, true);
        CHECK(here.size() == there.size());
        std::size_t lost = 0;
        for (const auto& p : here)
            lost += std::none_of(there.begin(), there.end(), [&](const auto& q) {
                return std::abs(p.first - q.first) <= 3 && std::abs(p.second - q.second) <= 3;
            });
        CHECK(lost == 0);
    }
}

TEST_CASE("ridges of random polygons obey the laws", "[offset][ridges]")
{
    using namespace ridge_shapes;
    std::size_t shapes = 0, valleys = 0, points = 0;
    for (int i = 0; i < 120; ++i) {
        test::dice d{static_cast<std::uint64_t>(7000 + i)};
        test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(6 + i / 4, 40, d)}};
        for (auto& l : s.loops) l = test::scaled(l, 20'000);
        const double width = (i % 3 == 0 ? 0.02 : 1.0) * all_of(s);
        CAPTURE(s, width);
        const test::filled_shape whole{s};
        if (whole.filled.is_touching() || whole.filled.loop_count() != 1) continue;
        found_ridges found{s, width, i % 2 == 0 ? 0.0 : 15.0};
        const test::ridge_laws laws = found.laws();
        CHECK(laws.broken() == "");
        ++shapes;
        valleys += laws.valleys;
        points += laws.points;
    }
    CAPTURE(shapes, valleys, points);
    CHECK(shapes > 60);
    CHECK(50 * valleys < points);
}

TEST_CASE("ridges without memory say so, and a region swept nowhere has none", "[offset][ridges]")
{
    using namespace ridge_shapes;
    found_ridges letter{{"H", {test::letter_aitch(100'000)}}, 60'000, 0.0};
    const auto every = [](std::uint32_t) noexcept { return true; };
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        workspace space{memory.source()};
        buffer<ridge_point> all{memory.source()};
        error e;
        {
            workspace::scope scratch{space};
            e = find_ridges(letter.made.filled, letter.swept, 1.0, every, scratch, all);
        }
        was_asked = memory.requests >= nth && e;
        if (was_asked) CHECK(e == error::out_of_memory);
    }
    workspace space;
    workspace::scope scratch{space};
    buffer<ridge_point> none;
    swept_region nowhere;
    CHECK_FALSE(find_ridges(letter.made.filled, nowhere, 1.0, every, scratch, none));
    CHECK(none.empty());
}

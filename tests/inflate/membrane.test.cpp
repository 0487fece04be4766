// SPDX-License-Identifier: MIT

#include <typemesh/inflate/membrane.hpp>

#include "inflated_shape.hpp"
#include "support/counting_memory.hpp"

#include <limits>

using namespace typemesh;
using namespace inflating;

namespace {

/// The worst errors at the inner points that a test looks at: of heights, by the unit given, and of normals, in degrees.
struct worst_errors {
    double height = 0.0, degrees = 0.0, all_degrees = 0.0;
    std::size_t points = 0;

    void look(const membrane_point& m, double height_there, double slope_x, double slope_y)
    {
        const double a[] = {-double{m.slope.x}, -double{m.slope.y}, double{m.height}},
                     b[] = {-slope_x, -slope_y, height_there};
        double aa = 0.0, bb = 0.0, ab = 0.0;
        for (int k = 0; k < 3; ++k) {
            aa += a[k] * a[k];
            bb += b[k] * b[k];
            ab += a[k] * b[k];
        }
        height = (std::max)(height, std::abs(double{m.height} - height_there));
        const double here = 57.29577951 * std::acos((std::min)(1.0, ab / std::sqrt(aa * bb)));
        degrees = (std::max)(degrees, here);
        all_degrees += here;
        ++points;
    }
};

}  // namespace

TEST_CASE("a straight stroke becomes half a cylinder, and a disc an ellipsoid, in all positions", "[inflate]")
{
    for (const double degrees : {0.0, 17.0, 45.0, 90.0}) {
        for (const double width : {0.02, 0.06, 0.15, 0.4}) {
            CAPTURE(degrees, width);
            const double c = std::cos(degrees / 57.29577951), s = std::sin(degrees / 57.29577951), half = 0.5 * width,
                         end = 0.5 + 2.0 * width;
            const inflated_shape stroke{
                {{at(-end * c + half * s, -end * s - half * c), at(end * c + half * s, end * s - half * c),
                  at(end * c - half * s, end * s + half * c), at(-end * c - half * s, -end * s + half * c)}}};
            worst_errors stroke_errors;
            stroke.each_inner([&](point p, const membrane_point& m) {
                const double along = p.x * c + p.y * s, across = p.y * c - p.x * s;
                if (std::abs(along) > 0.5) return;  // near the ends it is round
                stroke_errors.look(m, std::sqrt(half * half - across * across), across * s, -across * c);
            });
            CHECK(stroke_errors.points > 30);
            CHECK(stroke_errors.height < 0.036 * half);
            CHECK(stroke_errors.degrees < 12.0);
            CHECK(stroke_errors.all_degrees < 1.3 * double(stroke_errors.points));
            if (degrees > 50.0) continue;
            std::vector<grid_point> round;
            for (int i = 0; i < 180; ++i) {
                const double turn = (2.0 * i + degrees) / 57.29577951;
                round.push_back(at(half * std::cos(turn), half * std::sin(turn)));
            }
            const inflated_shape disc{{round}};
            worst_errors disc_errors;
            disc.each_inner([&](point p, const membrane_point& m) {
                const double inside = half * half - p.x * p.x - p.y * p.y;
                disc_errors.look(m, std::sqrt(0.5 * inside), -0.5 * p.x, -0.5 * p.y);
            });
            CHECK(disc_errors.points > 30);
            CHECK(disc_errors.height < 0.036 * half);
            CHECK(disc_errors.degrees < 12.0);
            CHECK(disc_errors.all_degrees < 1.3 * double(disc_errors.points));
        }
    }
}

TEST_CASE("an inflated cap is a Delaunay mesh of its region, positive inside, without flat triangles", "[inflate]")
{
    for (const auto& [name, loops] : inflatable_shapes()) {
        for (const float edge : {0.03f, 0.1f}) {
            CAPTURE(name, edge);
            inflated_shape shape{loops, edge};
            CHECK(test::broken_refinement(shape.filled.filled, shape.cap) == "");
            CHECK(test::is_delaunay(shape.cap));
            // Its heights are those of the solution on the same mesh, whose residual is small.
            detail::membrane_system system;
            REQUIRE(system.solve(mesh_of(shape.cap)));
            CHECK(residual_of(mesh_of(shape.cap), system.u()) < 1e-9);
            double farthest = 0.0;
            for (std::size_t i = 0; i < system.size(); ++i)
                farthest = (std::max)(
                    farthest, std::abs(double{shape.sheet.points()[i].height} - std::sqrt(2.0 * system.u()[i]) / em));
            CHECK(farthest < 0x1p-22);
            std::size_t not_positive = 0, flat = 0;
            for (const membrane_point& m : shape.sheet.points()) not_positive += !(m.height > 0.0f);
            const std::size_t rim = shape.cap.loops.points.size();
            for (const triangle t : shape.cap.triangles) flat += t.a < rim && t.b < rim && t.c < rim;
            CHECK(not_positive == 0);
            CHECK(flat == 0);
            const std::vector<grid_point> points = shape.cap.points();
            double longest = 0.0;
            for (const triangle t : shape.cap.triangles)
                for (const auto& [i, j] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}})
                    longest = (std::max)(longest, double(squared_distance(points[i], points[j])));
            CHECK(std::sqrt(longest) <= double{edge} * em);
            CHECK(shape.sheet.points().size() == shape.cap.inner.size());
        }
    }
}

TEST_CASE("finite differences give the same heights and volumes of an inflated shape, in all positions", "[inflate]")
{
    for (const auto& [name, loops] : inflatable_shapes()) {
        CAPTURE(name);
        const by_differences expected{loops};
        double smallest = 1e300, greatest = 0.0;  // of the volumes in all positions
        for (int position = 0; position < 8; ++position) {
            CAPTURE(position);
            const auto turned = [position](auto p) {
                if ((position & 1) != 0) p.x = -p.x;
                if ((position & 2) != 0) p.y = -p.y;
                if ((position & 4) != 0) p = {p.y, p.x};
                return p;
            };
            const auto turned_back = [position](auto p) {
                if ((position & 4) != 0) p = {p.y, p.x};
                if ((position & 1) != 0) p.x = -p.x;
                if ((position & 2) != 0) p.y = -p.y;
                return p;
            };
            auto moved = loops;
            for (auto& loop : moved) {
                for (grid_point& p : loop) p = turned(p);
                if (position == 1 || position == 2 || position == 4 || position == 7)
                    std::reverse(loop.begin(), loop.end());
            }
            const inflated_shape shape{moved};
            double highest = 0.0, farthest = 0.0, squares = 0.0;
            std::size_t points = 0;
            shape.each_inner([&](point p, const membrane_point& m) {
                const double height = expected.height(turned_back(p));
                if (height < 0.0) return;
                highest = (std::max)(highest, height);
                farthest = (std::max)(farthest, std::abs(double{m.height} - height));
                squares += (double{m.height} - height) * (double{m.height} - height);
                ++points;
            });
            CHECK(highest > 0.01);
            CHECK(farthest < 0.12 * highest);  // at reflex corners, where the slope has no limit
            CHECK(std::sqrt(squares / double(points)) < 0.015 * highest);
            // The triangles lie below the surface: the section of a stroke is a polygon.
            const double share = shape.volume() / expected.volume();
            CHECK(share > 0.94);
            CHECK(share < 1.01);
            smallest = (std::min)(smallest, share);
            greatest = (std::max)(greatest, share);
        }
        CHECK(greatest - smallest < 0.01);  // mirrored and turned shapes are alike, although their triangles differ
    }
}

TEST_CASE("a membrane refuses edges that are out of range, by name", "[inflate]")
{
    inflated_shape square{{{at(0, 0), at(0.5, 0), at(0.5, 0.5), at(0, 0.5)}}};
    for (const float edge :
         {0.0f, -0.1f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e-5f}) {
        CAPTURE(edge);
        const error e = square.inflate(edge);
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option == nullptr ? "" : e.option} == "edge");
    }
    CHECK(square.inflate(0.05f) == error::none);
    CHECK(membrane_options{.edge = 0.05f}.refused() == error::none);
    CHECK(membrane_options{.max_points = 0x2000'0000u}.refused() == error::bad_option);
}

TEST_CASE("a membrane has at most max_points points, or says so", "[inflate]")
{
    inflated_shape letter{inflatable_shapes()[0].second};
    const auto needed = static_cast<std::uint32_t>(letter.cap.points().size());
    for (const std::uint32_t limit : {0u, 10u, needed / 2, needed - 1, needed, needed + 1}) {
        CAPTURE(limit, needed);
        const error e =
            letter.sheet.inflate(letter.filled.filled, letter.given.view(), {.max_points = limit}, letter.cap.out());
        CHECK((e == error::none) == (limit >= needed));
        if (e) CHECK((e == error::too_many_points && e.count == limit));
        if (e) CHECK(letter.sheet.points().empty());
    }
}

TEST_CASE("a membrane without memory says so, and asks for none once it is warm", "[inflate]")
{
    inflated_shape letter{inflatable_shapes()[0].second};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        membrane sheet{memory.source()};
        test::refined_result cap{memory.source()};
        const error e = sheet.inflate(letter.filled.filled, letter.given.view(), {.edge = 0.05f}, cap.out());
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
        memory.fail_at = 0;
        REQUIRE(sheet.inflate(letter.filled.filled, letter.given.view(), {.edge = 0.05f}, cap.out()) == error::none);
        const std::size_t warm = memory.requests;
        REQUIRE(sheet.inflate(letter.filled.filled, letter.given.view(), {.edge = 0.05f}, cap.out()) == error::none);
        CHECK(memory.requests == warm);
    }
}

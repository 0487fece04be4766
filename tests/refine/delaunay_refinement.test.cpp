// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/delaunay_refinement.hpp>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::delaunay_refinement;
using detail::refinement_limits;

namespace {

refinement_limits limits_for(double degrees, std::int64_t longest = 0)
{
    const double angle = degrees * test::turn_once / 360.0, cosine = std::cos(angle);
    return {std::tan(angle), 0.475 * std::sqrt((1.0 + cosine) / (1.0 - cosine)), longest * longest, 100'000};
}

/// Refines a shape, and checks what holds for every shape.
void refine(delaunay_refinement& refinement, const test::filled_shape& shape, const refinement_limits& limits,
            test::refined_result& out)
{
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits));
    REQUIRE_FALSE(refinement.write(out.out()));
    CHECK(test::broken_refinement(shape.filled, out) == "");
    CHECK(test::is_delaunay(out));
}

/// The smallest inner angle of a region's corners, in degrees.
double sharpest_corner(const region& r)
{
    double least = 360.0;
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
        const std::uint32_t begin = r.starts()[loop], end = r.starts()[loop + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const grid_point at = r.points()[i], next = r.points()[i + 1 < end ? i + 1 : begin],
                             last = r.points()[i > begin ? i - 1 : end - 1];
            const double sine = double(orientation(at, next, last)),
                         cosine = (double(next.x) - at.x) * (double(last.x) - at.x) +
                                  (double(next.y) - at.y) * (double(last.y) - at.y);
            const double angle = std::atan2(sine, cosine) * 360.0 / test::turn_once;
            least = (std::min)(least, angle < 0.0 ? angle + 360.0 : angle);
        }
    }
    return least;
}

/// A few cells wide, and at least a hundred thousand cells long.
bool has_long_gap(const test::shape& s)
{
    return s.name == "largest square with a hole up to its edges" || s.name == "comb of 700 teeth";
}

/// The number of boundary edges whose diametral circle holds the corner opposite.
std::size_t encroached_edges(const test::refined_result& cap)
{
    const std::vector<grid_point> p = cap.points();
    const test::cap_edges edges = test::edges_of(cap);
    std::size_t count = 0;
    for (const auto& [edge, apex] : edges) {
        if (edges.count({edge.second, edge.first}) != 0) continue;
        const grid_point a = p[edge.first], b = p[edge.second], c = p[apex];
        count += squared_distance(a, b) > squared_distance(a, c) + squared_distance(b, c);
    }
    return count;
}

test::shape enlarged(test::shape s, std::int32_t factor)
{
    for (test::polyline& l : s.loops)
        for (grid_point& p : l) p = {factor * p.x, factor * p.y};
    return s;
}

}  // namespace

TEST_CASE("refinement keeps every law, in all positions and at all sizes of a shape", "[refine]")
{
    delaunay_refinement refinement;
    test::refined_result out;
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s)) || s.loops[0].size() > 1000 || s.name == "comb" || has_long_gap(s))
            continue;
        for (const test::shape& position : test::in_positions(s, {0.0, 33.0})) {
            if (!inspect::is_region(test::loops_of(position))) continue;
            INFO(position.name);
            const test::filled_shape shape{position};
            for (const double degrees : {0.0, 20.0, 30.0}) {
                CAPTURE(degrees);
                refine(refinement, shape, degrees == 0.0 ? refinement_limits{} : limits_for(degrees), out);
            }
        }
    }
}

TEST_CASE("without sharp corners, every angle reaches the aim", "[refine]")
{
    delaunay_refinement refinement;
    test::refined_result out;
    std::size_t triangles = 0;
    for (const test::shape& s :
         {test::shape{"square", {test::square(0, 0, 1 << 20)}}, test::shape{"circle", {test::circle(300, 1e6)}},
          enlarged(test::square_with_holes(5, 16), 100), enlarged({"long staircase", {test::staircase(40)}}, 10'000),
          test::shape{"thin", {{{0, 0}, {1 << 22, 0}, {1 << 22, 2000}, {0, 2000}}}}}) {
        INFO(s.name);
        const test::filled_shape shape{s};
        REQUIRE(sharpest_corner(shape.filled) >= 60.0);
        for (const double degrees : {10.0, 20.0, 25.0, 30.0}) {
            CAPTURE(degrees);
            refine(refinement, shape, limits_for(degrees), out);
            CHECK(test::corners_below(out, degrees) == 0);
            CHECK(refinement.kept() == 0);
            CHECK(encroached_edges(out) == 0);
            triangles += out.triangles.size();
        }
    }
    CHECK(triangles > 10'000);
}

TEST_CASE("at a sharp corner, no angle is below arctan(sin c / (2 - cos c))", "[refine]")
{
    delaunay_refinement refinement;
    test::refined_result out;
    for (const double corner : {1.0, 3.0, 7.0, 15.0, 30.0, 45.0, 59.0}) {
        struct sides {
            double length, ratio;
        };
        for (const auto [length, ratio] :
             {sides{0x1p24, 1.0}, {0x1p24, 0.61}, {0x1p24, 0.05}, {1.2 * 0x1p20, 1.0}, {1.9 * 0x1p20, 0.7}}) {
            const double angle = corner * test::turn_once / 360.0;
            const test::shape s{
                "needle", {{{0, 0}, test::on_circle(0, 0, length, 0.0), test::on_circle(0, 0, ratio * length, angle)}}};
            CAPTURE(corner, length, ratio);
            const test::filled_shape shape{s};
            const double sharpest = sharpest_corner(shape.filled) * test::turn_once / 360.0;
            refine(refinement, shape, limits_for(25.0), out);
            const double proven = std::atan(std::sin(sharpest) / (2.0 - std::cos(sharpest))) * 360.0 / test::turn_once;
            CHECK(test::corners_below(out, (std::min)(25.0, 0.98 * proven) - 0.01) == 0);
            CAPTURE(out.triangles.size());
            CHECK(double(out.triangles.size()) < 12.0 + 1.25 / (sharpest * ratio));  // as many as the shape is long
        }
    }
}

TEST_CASE("a shape that needs too many points is refused", "[refine]")
{
    delaunay_refinement refinement;
    {  // The square needs no other points than its own.
        const test::filled_shape square{{"square", {{{0, 0}, {400, 0}, {400, 400}, {0, 400}}}}};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(square.filled, space, given));
        auto limits = limits_for(20.0);
        limits.max_points = 4;
        CHECK_FALSE(refinement.run(square.filled, given.view(), limits));
        limits.max_points = 3;
        const error e = refinement.run(square.filled, given.view(), limits);
        CHECK(e == error::too_many_points);
        CHECK(e.count == 3);
    }
    for (const test::shape& s : test::generated_regions()) {
        if (!has_long_gap(s)) continue;
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(shape.filled, space, given));
        CHECK(refinement.run(shape.filled, given.view(), limits_for(20.0)) == error::too_many_points);
        CHECK(refinement.mesh().vertex_count() == 100'001);
    }
}

TEST_CASE("no edge is longer than the longest that is allowed", "[refine]")
{
    delaunay_refinement refinement;
    test::refined_result out;
    for (const std::int64_t longest : {200'000, 50'000, 20'000}) {
        const test::filled_shape shape{test::circle_with_holes(60, 3)};
        refine(refinement, shape, limits_for(25.0, longest), out);
        const std::vector<grid_point> p = out.points();
        std::int64_t found = 0;
        for (const triangle t : out.triangles)
            for (const std::int64_t square :
                 {squared_distance(p[t.a], p[t.b]), squared_distance(p[t.b], p[t.c]), squared_distance(p[t.c], p[t.a])})
                found = (std::max)(found, square);
        CHECK(found <= longest * longest);
        CHECK(found > longest * longest / 4);
    }
}

TEST_CASE("random polygons end, however narrow they are", "[refine]")
{
    delaunay_refinement refinement;
    test::refined_result out;
    test::dice d{9};
    for (int round = 0; round < 150; ++round) {
        const int width = 5 + d.roll(60);
        test::shape s{"random polygon",
                      {test::random_polygon(6 + d.roll((std::min)(width * width / 4, 200)), width, d)}};
        s = enlarged(s, 1 + d.roll(3) * d.roll(5000));
        if (!inspect::is_region(test::loops_of(s))) continue;
        INFO(s);
        refine(refinement, test::filled_shape{s}, limits_for(d.roll(2) == 0 ? 20.0 : 33.0), out);
        // A point inside is four cells or more away from every other point.
        const std::vector<grid_point> p = out.points();
        std::int64_t nearest = 16;
        for (const auto& [edge, apex] : test::edges_of(out))
            if (edge.first >= out.loops.points.size())
                nearest = (std::min)(nearest, squared_distance(p[edge.first], p[edge.second]));
        CHECK(nearest >= 16);
    }
}

TEST_CASE("the number of points grows with the outline's, if its shape repeats", "[refine]")
{
    delaunay_refinement refinement;
    std::vector<double> per_point;
    for (const int steps : {30, 300, 3000}) {
        const test::filled_shape shape{enlarged({"staircase", {test::staircase(steps)}}, 1000)};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits_for(25.0)));
        per_point.push_back(double(refinement.mesh().vertex_count()) / double(shape.filled.points().size()));
    }
    CAPTURE(per_point);
    CHECK(per_point[2] < 1.1 * per_point[1]);
    CHECK(per_point[2] < 4.0);
}

TEST_CASE("refinement without memory says so, and asks for none once it is warm", "[refine]")
{
    const test::filled_shape shape{test::circle_with_holes(60, 3)};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        delaunay_refinement refinement{memory.source()};
        test::refined_result out{memory.source()};
        error e = refinement.run(shape.filled, given.view(), limits_for(25.0));
        if (!e) e = refinement.write(out.out());
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
        memory.fail_at = 0;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits_for(25.0)));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        const std::size_t warm = memory.requests;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits_for(25.0)));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(memory.requests == warm);
    }
}

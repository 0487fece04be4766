// SPDX-License-Identifier: MIT

#include <typemesh/extrude/curve_normals.hpp>

#include <limits>
#include <random>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

template <class Shape>
std::vector<side_point> sides_of(const Shape& s, const curve_normals& how = {})
{
    std::vector<side_point> sides(s.loops.points.size());
    REQUIRE_FALSE(how(s.made(), sides));
    return sides;
}

/// The derivative, by the textbook's polynomial.
point derivative(const curve& c, double t)
{
    const auto at = [&](auto coordinate) {
        const double a = coordinate(c.p[0]), b = coordinate(c.p[1]), d = coordinate(c.p[2]), e = coordinate(c.p[3]);
        if (c.degree == 1) return b - a;
        if (c.degree == 2) return 2.0 * ((1.0 - t) * (b - a) + t * (d - b));
        return 3.0 * ((1.0 - t) * (1.0 - t) * (b - a) + 2.0 * (1.0 - t) * t * (d - b) + t * t * (e - d));
    };
    return {at([](point p) { return p.x; }), at([](point p) { return p.y; })};
}

double degrees_between(point a, point b)
{
    return std::atan2(std::abs(cross(a, b)), typemesh::dot(a, b)) * 180.0 / 3.14159265358979323846;
}
point wide(vec2 v) { return {v.x, v.y}; }
bool hard(const side_point& s) { return s.doubled; }

/// The largest angle between a wall longer than 16 tolerances and one of its end normals, in degrees.
double max_aside(const region& r, const std::vector<side_point>& sides)
{
    double most = 0.0;
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
        const std::uint32_t begin = r.starts()[loop], end = r.starts()[loop + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t next = i + 1 < end ? i + 1 : begin;
            const point along = delta(r.points()[i], r.points()[next]);
            const double longest = 16.0 * r.tolerance();
            if (dot(along, along) <= longest * longest) continue;
            for (const vec2 n : {sides[i].after, sides[next].before})
                most = (std::max)(most, degrees_between(wide(n), outward(along)));
        }
    }
    return most;
}

/// A contour of these curves, each of them one edge.
shapes::shape whole_curves(std::vector<curve> c) { return {"whole curves", {std::move(c)}, {}, 1}; }

/// A closed polygon with its edges' curves given one by one, whatever they are.
struct loose_shape {
    std::vector<curve> curves;
    contours loops;

    loose_shape(const std::vector<grid_point>& points, const std::vector<contour_edge>& edges, std::vector<curve> c)
        : curves{std::move(c)}
    {
        if (!loops.points.append(std::span{points}) || !loops.edges.append(std::span{edges}) ||
            !loops.starts.push_back(0) || !loops.starts.push_back(static_cast<std::uint32_t>(points.size())))
            std::abort();
        loops.curves = curves;
    }
    region made() const { return region::proven(loops, 0, 1); }
};

}  // namespace

TEST_CASE("normals inside curves are within 0.01 degrees of the curve's, even on a coarse polygon", "[extrude]")
{
    for (const int pieces : {2, 3, 8}) {
        const shapes::shape round[] = {shapes::ring(pieces), shapes::letter_d(pieces), shapes::ribbon(pieces + 2),
                                       shapes::drop(pieces + 2)};
        for (const auto& s : round) {
            INFO(s.name << " in " << pieces << " pieces");
            const auto sides = sides_of(s);
            for (std::uint32_t i = 0; i < s.points(); ++i) {
                const contour_edge out = s.loops.edges[i], in = s.loops.edges[s.previous(i)];
                const point leaves = (out.t0 < out.t1 ? 1.0 : -1.0) * derivative(s.curves[out.curve], out.t0);
                const point arrives = (in.t0 < in.t1 ? 1.0 : -1.0) * derivative(s.curves[in.curve], in.t1);
                CHECK(degrees_between(wide(sides[i].after), outward(leaves)) < 0.01);
                CHECK(degrees_between(wide(sides[i].before), outward(arrives)) < 0.01);
                CHECK(hard(sides[i]) == (degrees_between(leaves, arrives) > 15.0));
            }
        }
    }
}

TEST_CASE("the normals of a circle point away from its centre, and a hole's towards it", "[extrude]")
{
    const auto s = shapes::ring(2);
    const auto sides = sides_of(s);
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        const point from_centre = s.loops.grid.place(s.loops.points[i]) - point{400, 300};
        const double sign = i < s.loops.starts[1] ? 1.0 : -1.0;
        CHECK(degrees_between(wide(sides[i].before), sign * from_centre) < (i < s.loops.starts[1] ? 0.1 : 3.0));
        CHECK_FALSE(hard(sides[i]));
    }
}

TEST_CASE("at a hard corner each wall has exactly its line's normal", "[extrude]")
{
    const auto s = shapes::rectangle();
    const auto sides = sides_of(s);
    const vec2 right{1, 0}, left{-1, 0}, up{0, 1}, down{0, -1};
    const vec2 expected[4][2] = {{left, down}, {down, right}, {right, up}, {up, left}};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(hard(sides[i]));
        CHECK(sides[i].before == expected[i][0]);
        CHECK(sides[i].after == expected[i][1]);
    }
}

TEST_CASE("a wall between two hard corners of a line has one normal, to the bit", "[extrude]")
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> where{0.1, 1.0};
    for (int round = 0; round < 200; ++round) {
        std::vector<point> star;
        for (int k = 0; k < 7; ++k) {
            const double angle = k * 0.897597901, r = 400.0 * where(random);
            star.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
        const shapes::shape s{"star", {shapes::polygon(star)}};
        const auto sides = sides_of(s);
        for (std::uint32_t i = 0; i < s.points(); ++i) {
            if (hard(sides[i]) && hard(sides[s.next(i)])) CHECK(sides[i].after == sides[s.next(i)].before);
        }
    }
}

TEST_CASE("a line that runs smoothly into a curve keeps its normal there", "[extrude]")
{
    const auto s = shapes::letter_d();
    const auto sides = sides_of(s);
    std::uint32_t corners = 0, on_lines = 0;
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        corners += hard(sides[i]);
        if (s.curves[s.loops.edges[i].curve].degree != 1) continue;
        ++on_lines;
        CHECK(sides[i].after == sides[s.next(i)].before);
    }
    CHECK(corners == 4);
    CHECK(on_lines == 6);
}

TEST_CASE("the direction in which an outline is given does not matter", "[extrude]")
{
    const point a{0, 0}, b{300, 0}, c{500, 200}, d{500, 500}, e{0, 500};
    const std::vector<curve> forth = {curve::from(a, b), curve::from(quadratic{b, {500, 0}, c}), curve::from(c, d),
                                      curve::from(cubic{d, {400, 700}, {200, 300}, e}), curve::from(e, a)};
    std::vector<curve> back;
    for (std::size_t i = forth.size(); i-- > 0;) {
        curve turned = forth[i];
        for (std::uint32_t k = 0; k <= turned.degree; ++k) turned.p[k] = forth[i].p[turned.degree - k];
        back.push_back(turned);
    }
    const shapes::shape one{"forth", {forth}}, two{"back", {back}};
    const auto first = sides_of(one), second = sides_of(two);
    REQUIRE(one.points() == two.points());
    for (std::uint32_t i = 0; i < one.points(); ++i) {
        std::uint32_t j = 0;
        while (!(two.loops.points[j] == one.loops.points[i])) REQUIRE(++j < two.points());
        CHECK(first[i].doubled == second[j].doubled);
        CHECK(degrees_between(wide(first[i].before), wide(second[j].before)) < 1e-5);
        CHECK(degrees_between(wide(first[i].after), wide(second[j].after)) < 1e-5);
    }
}

TEST_CASE("a cusp inside a curve is hard, and each side has its own normal", "[extrude]")
{
    const auto s = shapes::cusp();
    for (const float crease : {15.0f, 180.0f}) {
        const auto sides = sides_of(s, {crease});
        std::uint32_t tip = 0;
        for (std::uint32_t i = 0; i < s.points(); ++i) {
            if (s.loops.points[i].y > s.loops.points[tip].y) tip = i;
        }
        CHECK(s.loops.edges[tip].t0 == 0.5f);
        CHECK(hard(sides[tip]));
        CHECK(wide(sides[tip].before).x == Approx(1.0).margin(1e-6));
        CHECK(wide(sides[tip].after).x == Approx(-1.0).margin(1e-6));
    }
    const auto sides = sides_of(s);
    CHECK(std::count_if(sides.begin(), sides.end(), hard) == 3);
}

TEST_CASE("a joint is hard when its tangents differ by more than the crease angle", "[extrude]")
{
    for (const double degrees : {0.0, 5.0, 14.9, 15.1, 30.0, 89.9, 150.0}) {
        const double turn = degrees * 3.14159265358979323846 / 180.0;
        const point joint{0, 0}, next{500 * std::cos(turn), 500 * std::sin(turn)};
        const shapes::shape s{"bent",
                              {{curve::from(point{-500, 0}, joint), curve::from(joint, next),
                                curve::from(next, point{-600, 900}), curve::from(point{-600, 900}, point{-500, 0})}}};
        for (const float crease : {1.0f, 15.0f, 60.0f, 120.0f, 180.0f}) {
            INFO(degrees << " degrees, crease at " << crease);
            const auto sides = sides_of(s, {crease});
            REQUIRE(s.loops.points[1] == grid_point{0, 0});
            CHECK(hard(sides[1]) == (degrees > static_cast<double>(crease)));
            if (hard(sides[1])) continue;
            CHECK(sides[1].before == sides[1].after);
            CHECK(degrees_between(wide(sides[1].before), {std::sin(turn / 2), -std::cos(turn / 2)}) < 1e-4);
        }
    }
}

TEST_CASE("a joint at exactly the crease angle is soft", "[extrude]")
{
    for (const auto& side : sides_of(shapes::rectangle(), {90.0f})) CHECK_FALSE(hard(side));
    for (const auto& side : sides_of(shapes::rectangle(), {89.99f})) CHECK(hard(side));
    const auto d = sides_of(shapes::letter_d(), {0.0f});
    CHECK(std::count_if(d.begin(), d.end(), hard) == 4);
}

TEST_CASE("handles of no length and curves that are a point still give unit normals", "[extrude]")
{
    const point a{0, 0}, b{400, 0}, c{400, 400};
    const shapes::shape s{
        "handles",
        {{curve::from(cubic{a, a, {200, -100}, b}), curve::from(quadratic{b, b, c}), curve::from(cubic{c, c, a, a})}}};
    const auto sides = sides_of(s);
    CHECK(degrees_between(wide(sides[0].after), outward({200, -100})) < 0.01);
    for (const auto& side : sides) CHECK(typemesh::length(wide(side.after)) == Approx(1.0).margin(1e-6));

    const curve nothing = curve::from(cubic{a, a, a, a});
    const loose_shape odd{{{0, 0}, {100, 0}, {0, 100}}, {{0, 0.0f, 1.0f}, {0, 0.0f, 0.5f}, {0, 0.5f, 1.0f}}, {nothing}};
    const auto found = sides_of(odd);
    CHECK(found[0].after == vec2{0.0f, -1.0f});
    CHECK(found[1].before == vec2{0.0f, -1.0f});
}

TEST_CASE("a point inside a curve is soft even where the polygon leaves the curve", "[extrude]")
{
    // At t = 1/2 the curve runs to the left, against the first edge: that wall falls back on its own direction.
    const curve hook = curve::from(quadratic{{0, 0}, {200, 25}, {-100, 50}});
    const curve rest = curve::from(point{0, 1}, point{0, 0});
    const loose_shape s{{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                        {{0, 0.0f, 0.5f}, {0, 0.5f, 1.0f}, {1, 0.0f, 0.5f}, {1, 0.5f, 1.0f}},
                        {hook, rest}};
    const auto sides = sides_of(s);
    CHECK_FALSE(hard(sides[1]));
    CHECK(sides[1].before == sides[1].after);
    CHECK(sides[1].after.x > 0.0f);
    CHECK(sides[1].after.y < 0.0f);
}

TEST_CASE("normals have unit length and point out of their walls, even if the curves do not fit the polygon",
          "[extrude]")
{
    std::mt19937 random{11};
    std::uniform_real_distribution<double> anywhere{-1000.0, 1000.0};
    std::uniform_int_distribution<int> coarse{-2, 2};
    for (int round = 0; round < 4000; ++round) {
        const std::size_t n = 3 + static_cast<std::size_t>(round % 9);
        std::vector<grid_point> points;
        std::vector<contour_edge> edges;
        std::vector<curve> curves;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = 6.283185307 * static_cast<double>(i) / static_cast<double>(n),
                         r = 300.0 + 0.25 * anywhere(random);
            points.push_back(grid{}.snap({r * std::cos(angle), r * std::sin(angle)}));
        }
        // some edges share a curve, forth or back; some curves are small integers, with all their coincidences
        for (std::size_t i = 0; i < n;) {
            const auto p = [&]() -> point {
                return round % 2 == 0 ? point{anywhere(random), anywhere(random)}
                                      : point{static_cast<double>(coarse(random)), static_cast<double>(coarse(random))};
            };
            const auto degree = static_cast<std::uint32_t>(1 + random() % 3);
            const std::size_t pieces = (std::min)(n - i, 1 + std::size_t{random() % 4});
            const bool forth = random() % 2 == 0;
            for (std::size_t k = 0; k < pieces; ++k) {
                const float t0 = static_cast<float>(k) / static_cast<float>(pieces),
                            t1 = static_cast<float>(k + 1) / static_cast<float>(pieces);
                edges.push_back(
                    {static_cast<std::uint32_t>(curves.size()), forth ? t0 : 1.0f - t0, forth ? t1 : 1.0f - t1});
            }
            curves.push_back({degree, {p(), p(), p(), p()}});
            i += pieces;
        }
        const loose_shape s{points, edges, curves};
        const float crease = round % 3 == 0 ? 0.0f : round % 3 == 1 ? 15.0f : 180.0f;
        const auto sides = sides_of(s, {crease});
        for (std::size_t i = 0; i < n; ++i) {
            INFO("round " << round << ", point " << i);
            const point in = delta(points[(i + n - 1) % n], points[i]), out = delta(points[i], points[(i + 1) % n]);
            REQUIRE(typemesh::length(wide(sides[i].before)) == Approx(1.0).margin(1e-6));
            REQUIRE(typemesh::length(wide(sides[i].after)) == Approx(1.0).margin(1e-6));
            REQUIRE(typemesh::dot(wide(sides[i].before), outward(in)) > -1e-6 * typemesh::length(in));
            REQUIRE(typemesh::dot(wide(sides[i].after), outward(out)) > -1e-6 * typemesh::length(out));
            REQUIRE((sides[i].doubled || sides[i].before == sides[i].after));
        }
    }
}

namespace {

/// A needle whose tip, at (0, 1), is the tip of a hairpin: the curve comes from the right, turns within no room at all,
/// and goes back. Its walls are straight to one unit; at the tip the curve runs down. The points lie at the given t,
/// and `forth` says whether the curve runs that way or is to be run backwards.
loose_shape needle(double tolerance, bool forth, const std::vector<float>& inner = {0.5f})
{
    const quadratic q{{1000, 2}, {-1000, 1}, {1000, 0}};
    const curve hairpin = curve::from(forth ? q : quadratic{q.p2, q.p1, q.p0});
    std::vector<grid_point> points{grid{}.snap(q.p0)};
    std::vector<contour_edge> edges;
    float from = 0.0f;
    const auto side = [forth](float t) { return forth ? t : 1.0f - t; };
    for (const float t : inner) {
        points.push_back(grid{}.snap(q.at(static_cast<double>(t))));
        edges.push_back({0, side(from), side(t)});
        from = t;
    }
    points.push_back(grid{}.snap(q.p2));
    edges.push_back({0, side(from), side(1.0f)});
    edges.push_back({1, 0.0f, 1.0f});
    loose_shape s{points, edges, {hairpin, curve::from(q.p2, q.p0)}};
    s.loops.tolerance = tolerance * s.loops.grid.cells;
    return s;
}

}  // namespace

TEST_CASE("the tip of a hairpin is hard where its normal would light a long wall from the side", "[extrude]")
{
    for (const bool forth : {true, false}) {
        const auto coarse = needle(1.0, forth);  // both walls are long
        const auto sharp = sides_of(coarse);
        CHECK(max_aside(coarse.made(), sharp) < 0.1);
        CHECK(hard(sharp[1]));
        CHECK(sharp[1].before == rounded(wall_normal(coarse.loops.points[0], coarse.loops.points[1])));
        CHECK(sharp[1].after == rounded(wall_normal(coarse.loops.points[1], coarse.loops.points[2])));

        const auto round = needle(1.0, forth, {0.5f, 0.52f});  // the second is 1.6 long, and keeps the curve's normal
        const auto tip = sides_of(round);
        CHECK(max_aside(round.made(), tip) < 45.0);
        CHECK(hard(tip[1]));
        CHECK(tip[1].before == rounded(wall_normal(round.loops.points[0], round.loops.points[1])));
        CHECK(tip[1].after == vec2{-1.0f, 0.0f});

        for (const double tolerance : {0.0, 100.0}) {  // not known, or so coarse that no wall is long
            const auto soft = sides_of(needle(tolerance, forth));
            CHECK_FALSE(hard(soft[1]));
            CHECK(soft[1].before == vec2{-1.0f, 0.0f});
        }
        CHECK(hard(sides_of(needle(1.0, forth), {89.9f})[1]));
        CHECK_FALSE(hard(sides_of(needle(1.0, forth), {90.0f})[1]));  // the caller wants it so
    }
}

TEST_CASE("a soft joint becomes hard where its normal would light a long wall from the side", "[extrude]")
{
    // The same needle of two curves. Their tangents break by 0 or about 6 degrees in the tip.
    for (const double aside : {0.0, 0.05}) {
        auto s = whole_curves({shapes::quad({1000, 2}, {0, 1.5}, {0, 1}), shapes::quad({0, 1}, {aside, 0.5}, {1000, 0}),
                               shapes::line({1000, 0}, {1000, 2})});
        CHECK_FALSE(hard(sides_of(s)[1]));
        s.loops.tolerance = 512.0;
        const auto sides = sides_of(s);
        CHECK(hard(sides[1]));
        CHECK(max_aside(s.made(), sides) < 0.1);
    }
}

TEST_CASE("a corner that is hard already does not light a long wall from the side", "[extrude]")
{
    // The lower wall's curve bends down in its last unit; the right wall is a line.
    auto s = whole_curves({shapes::quad({0, 0}, {1000, 0}, {1000, -1}), shapes::line({1000, -1}, {1000, 500}),
                           shapes::line({1000, 500}, {0, 500}), shapes::line({0, 500}, {0, 0})});
    CHECK(sides_of(s)[1].before == vec2{-1.0f, 0.0f});  // as long as the tolerance is not known
    s.loops.tolerance = 512.0;
    const auto sides = sides_of(s);
    CHECK(hard(sides[1]));
    CHECK(sides[1].before == rounded(wall_normal(s.loops.points[0], s.loops.points[1])));
    CHECK(sides[1].after == vec2{1.0f, 0.0f});
}

TEST_CASE("a normal up to 45 degrees off a long wall stays the curve's, and no normal farther off", "[extrude]")
{
    for (const double more : {0.0, 0.001}) {  // the curve starts upwards, the chord runs to the upper right
        auto s = whole_curves({shapes::quad({0, 0}, {-more, 1000}, {1000, 1000}),
                               shapes::line({1000, 1000}, {-1000, 1000}), shapes::line({-1000, 1000}, {0, 0})});
        s.loops.tolerance = 512.0;
        const auto sides = sides_of(s);
        const double off = degrees_between(wide(sides[0].after), outward({1000, 1000}));
        CHECK(off == Approx(more == 0.0 ? 45.0 : 0.0).margin(1e-4));
        CHECK(sides[1].before == vec2{0.0f, -1.0f});  // 45 degrees off, either way
    }
}

TEST_CASE("a wall is long if it is longer than 16 tolerances", "[extrude]")
{
    // The curve starts 73 degrees off its chord, which is 512,000 cells long.
    auto s = whole_curves({shapes::quad({0, 0}, {300, -1000}, {1000, 0}), shapes::line({1000, 0}, {0, 1000}),
                           shapes::line({0, 1000}, {0, 0})});
    const vec2 own{0.0f, -1.0f};
    s.loops.tolerance = 32'000.0;
    CHECK(degrees_between(wide(sides_of(s)[0].after), wide(own)) > 70.0);
    s.loops.tolerance = std::nextafter(32'000.0, 0.0);
    CHECK(sides_of(s)[0].after == own);
}

TEST_CASE("an edge with equal parameters at both ends follows its curve in the direction that it runs", "[extrude]")
{
    // A bowl, run against its curve; beside t = 1/2 there is an edge of one cell, so short that both its ends have that t.
    const quadratic bowl{{1000, 0}, {0, -1000}, {-1000, 0}};
    const grid_point low = grid{}.snap(bowl.at(0.5)), beside{low.x + 1, low.y};
    const loose_shape s{{grid{}.snap(bowl.p2), low, beside, grid{}.snap(bowl.p0)},
                        {{0, 1.0f, 0.5f}, {0, 0.5f, 0.5f}, {0, 0.5f, 0.0f}, {1, 0.0f, 1.0f}},
                        {curve::from(bowl), curve::from(bowl.p0, bowl.p2)}};
    const auto sides = sides_of(s);
    for (const std::size_t i : {1u, 2u}) {
        CHECK_FALSE(hard(sides[i]));
        CHECK(sides[i].before == vec2{0.0f, -1.0f});
    }
}

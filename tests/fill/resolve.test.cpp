// SPDX-License-Identifier: MIT

#include <typemesh/fill/resolve.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

std::uint32_t max_sweeps = 0, rounded_shapes = 0, all_shapes = 0;

/// Whether contours of small coordinates cross in grid points only, so that nothing needs to be bent.
bool is_exact(const std::vector<test::oracle::loop>& loops)
{
    std::vector<std::pair<grid_point, grid_point>> edges;
    for (const auto l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) edges.emplace_back(l[i], l[(i + 1) % l.size()]);
    for (const auto& [a, b] : edges) {
        if (std::abs(a.x) > 5000 || std::abs(a.y) > 5000) return false;
        for (const auto& [c, d] : edges) {
            grid_point x;
            if (crossing_of(a, b, c, d, x) && test::oracle::side(a, b, x) != 0) return false;
        }
    }
    return true;
}

/// Whether every edge knows its direction along the contour edge that it comes from. That edge has its number as its
/// curve, and t from 0.25 to 0.75: t grows the one way and falls the other. Contours of more than 2^20 cells have more
/// cells than there are floats for t: their t may stand still, but it does not turn back.
bool knows_its_way(const region& made, const contours& given)
{
    bool is_large = false;
    for (const grid_point p : given.points) is_large = is_large || std::abs(p.x) > 1 << 20 || std::abs(p.y) > 1 << 20;
    for (std::uint32_t l = 0; l < made.loop_count(); ++l) {
        const std::uint32_t begin = made.starts()[l], end = made.starts()[l + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const contour_edge e = made.edges()[i];
            if ((e.t0 == e.t1 && !is_large) || !(0.25f <= e.t0 && e.t0 <= 0.75f && 0.25f <= e.t1 && e.t1 <= 0.75f))
                return false;
            std::uint32_t c = 0;
            while (given.starts[c + 1] <= e.curve) ++c;
            const grid_point from = given.points[e.curve],
                             to = given.points[e.curve + 1 < given.starts[c + 1] ? e.curve + 1 : given.starts[c]],
                             a = made.points()[i], b = made.points()[i + 1 < end ? i + 1 : begin];
            const double x = double(b.x) - a.x, y = double(b.y) - a.y;
            const double along = x * (double(to.x) - from.x) + y * (double(to.y) - from.y);
            if (x * x + y * y > 25.0 && (along > 0 ? e.t0 > e.t1 : e.t0 < e.t1)) return false;  // too long to be bent
        }
    }
    return true;
}

/// What is wrong with resolve()'s result for a shape under a rule, or nothing.
///
/// The cycles must be proper cycles, and fill what the contours fill at every grid point (of `samples` by `samples` round
/// the shape) farther than a cell or so from all contours. If nothing was bent, the areas are equal.
std::string mistake_on(const test::shape& s, fill_rule rule, int samples = 12)
{
    contours loops = test::contours_of(s);
    workspace space;
    resolve_effort effort;
    const result<region> made = resolve(loops, rule, space, {.effort = &effort});
    max_sweeps = (std::max)(max_sweeps, effort.sweeps);
    rounded_shapes += effort.rounds != 0;
    ++all_shapes;
    if (!made) return made.error().message();
    const auto given = test::loops_of(s), kept = test::oracle::loops_of(*made);
    if (std::string broken = test::oracle::broken_cycle(kept); !broken.empty()) return broken;
    std::uint32_t holes = 0, outers = 0;
    for (const auto l : kept) ++(test::oracle::doubled_area(l) > 0 ? outers : holes);
    if (holes != made->holes() || outers != made->outers()) return "holes and outer loops are miscounted";
    if (made->edges().size() != made->points().size()) return "the numbers of edges and points differ";
    if (!knows_its_way(*made, test::contours_of(s))) return "an edge does not know its direction along its curve";

    std::vector<std::int64_t> places;
    for (const grid_point p : made->points()) places.push_back(detail::sweep_place(p));
    std::sort(places.begin(), places.end());
    if ((std::adjacent_find(places.begin(), places.end()) != places.end()) != made->is_touching())
        return "is_touching() is wrong";

    triangle_list triangles;
    if (const error e = monotone{}(*made, space, triangles)) return e.message();
    if (std::string law = test::oracle::broken_law(*made, triangles.view()); !law.empty()) return law;

    const double area = test::oracle::doubled_filled_area(given, rule),
                 mine = static_cast<double>(test::oracle::doubled_area(kept));
    double length = 0;
    for (const auto& l : s.loops)
        for (std::size_t i = 0; i < l.size(); ++i)
            length += std::hypot(double(l[i].x) - l[(i + 1) % l.size()].x, double(l[i].y) - l[(i + 1) % l.size()].y);
    const bool exact = is_exact(given);
    if (exact ? std::fabs(area - mine) > 1e-9 * (area + 1) : std::fabs(area - mine) > 2 * length + 4)
        return "the area is not what the contours fill";
    if (test::oracle::check_fill(given, rule, kept, samples, exact ? 0.0 : 1.5).wrong != 0)
        return "a place is filled wrongly";
    return {};
}

std::string mistake_on(const test::shape& s)
{
    const std::string m = mistake_on(s, fill_rule::non_zero);
    return m.empty() ? mistake_on(s, fill_rule::even_odd) : "even_odd: " + m;
}

}  // namespace

TEST_CASE("resolve() makes regions of random polylines on tiny grids", "[fill][resolve]")
{
    test::dice d{21};
    for (int i = 0; i < 20'000; ++i) {
        const int width = 2 + d.roll(8), scale = 1 << d.roll(7), count = 1 + d.roll(4);
        const test::shape s = test::random_polylines(d, count, 1, count == 1 ? 16 : 8, width, scale);
        INFO(s);
        REQUIRE(mistake_on(s) == "");
    }
    CHECK(max_sweeps <= 12);
}

TEST_CASE("resolve() makes regions of random polylines of all sizes and slants", "[fill][resolve]")
{
    test::dice d{22};
    for (int i = 0; i < 1500; ++i) {
        const int wide = d.roll(29), high = d.roll(29), count = 1 + d.roll(3);
        const test::shape s = test::random_polylines(d, count, 1, 40, [&](const test::polyline& l, int) {
            const bool is_back = l.size() > 3 && d.roll(4) == 0;  // almost at the point before the last one
            const grid_point at = is_back ? l[l.size() - 3] : grid_point{-(1 << wide) / 2, -(1 << high) / 2};
            const std::int32_t x = is_back ? d.roll(3) - 1 : d.roll(1 << wide);
            return grid_point{at.x + x, at.y + (is_back ? d.roll(3) - 1 : d.roll(1 << high))};
        });
        INFO(s);
        REQUIRE(mistake_on(s) == "");
    }
    CHECK(max_sweeps <= 12);
}

TEST_CASE("resolve() makes regions of the corpus in every position", "[fill][resolve]")
{
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        for (const test::shape& s : test::in_positions(c.shape, {0.0, 90.0, 180.0, 270.0, 33.0}))
            CHECK(mistake_on(s) == "");
    }
}

namespace {

test::shape doubled(test::shape s, grid_point by, bool turned_round)
{
    s.name += ", doubled";
    const std::size_t n = s.loops.size();
    for (std::size_t i = 0; i < n; ++i) {
        test::polyline l = s.loops[i];
        for (grid_point& p : l) p = {p.x + by.x, p.y + by.y};
        if (turned_round) std::reverse(l.begin(), l.end());
        s.loops.push_back(l);
    }
    return s;
}

/// A star drawn in one stroke: every point is joined with the one `skip` further on.
test::polyline pentagram(int n, int skip, double radius)
{
    test::polyline l;
    for (int i = 0; i < n; ++i) l.push_back(test::on_circle(0, 0, radius, test::turn_once * i * skip / n));
    return l;
}

}  // namespace

TEST_CASE("resolve() makes regions of doubled, shifted and wound-up shapes", "[fill][resolve]")
{
    for (const test::shape& s : test::generated_regions()) {
        if (s.loops.size() > 30 || s.loops[0].size() > 300 || s.name.find("largest") == 0) continue;
        INFO(s.name);
        for (const bool round : {false, true}) {
            for (const grid_point by :
                 {grid_point{0, 0}, grid_point{1, 0}, grid_point{0, -1}, grid_point{3, 7}, grid_point{1234, 567}}) {
                CHECK(mistake_on(doubled(s, by, round)) == "");
                CHECK(mistake_on(test::turned(doubled(s, by, round), 90.0)) == "");
            }
        }
        CHECK(mistake_on(doubled(doubled(doubled(s, {5, 5}, false), {5, 5}, false), {-30, 2}, false)) == "");
    }
    for (const int n : {5, 7, 11, 31, 101}) {
        for (int skip = 2; skip < n / 2; skip += 1 + n / 10) {
            for (const double radius : {3.0, 20.0, 1000.0, 2e8}) {
                const test::shape s{"pentagram " + std::to_string(n) + " by " + std::to_string(skip),
                                    {pentagram(n, skip, radius)}};
                INFO(s);
                CHECK(mistake_on(s, fill_rule::non_zero, n > 50 ? 4 : 12) == "");
                CHECK(mistake_on(s, fill_rule::even_odd, n > 50 ? 4 : 12) == "");
            }
        }
    }
    for (int depth = 1; depth < 12; ++depth) {
        CHECK(mistake_on(test::nested_squares(depth, false)) == "");
        CHECK(mistake_on(test::nested_squares(depth, true)) == "");
    }
}

TEST_CASE("loops that touch in a point stay in their sector of interior", "[fill][resolve]")
{
    struct touching {
        const char* name;
        std::vector<test::polyline> loops;
        std::uint32_t points, holes, outers;
    };
    const test::polyline around{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    const touching all[] = {
        {"two outer loops stay two", {test::square(0, 0, 4), test::square(4, 4, 4)}, 8, 0, 2},
        {"a hole that touches its outer loop with a corner joins it", {around, {{0, 0}, {2, 4}, {4, 2}}}, 7, 0, 1},
        {"a hole that touches an edge joins too, and cuts it", {around, {{4, 0}, {2, 4}, {6, 4}}}, 8, 0, 1},
        {"holes that touch become one", {around, {{2, 2}, {2, 4}, {4, 4}}, {{4, 4}, {4, 6}, {6, 6}}}, 10, 1, 1},
        {"a hole that touches in two points parts the shape", {around, {{0, 0}, {2, 4}, {8, 8}, {4, 2}}}, 8, 0, 2},
        {"a figure of eight is two", {{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, 6, 0, 2},
        {"a spike vanishes", {{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 20}, {4, 8}, {0, 8}}}, 5, 0, 1},
        {"a contour and its reverse cancel", {around, test::reversed(around)}, 0, 0, 0},
        {"a doubled contour is one", {around, around}, 4, 0, 1},
        {"a bridge traversed both ways leaves a hole",
         {{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 4}, {4, 2}, {2, 2}}},
         7,
         1,
         1},
        {"squares that share an edge are one", {test::square(0, 0, 4), test::square(4, 0, 4)}, 6, 0, 1},
    };
    for (const touching& t : all) {
        INFO(t.name);
        for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
            const test::shape s = test::turned({t.name, t.loops}, degrees);
            CHECK(mistake_on(s) == "");
            CHECK(mistake_on(test::mirrored(s)) == "");
            contours loops = test::contours_of(s);
            workspace space;
            const auto made = resolve(loops, fill_rule::non_zero, space);
            REQUIRE(made);
            CHECK(made->holes() == t.holes);
            CHECK(made->outers() == t.outers);
            CHECK(made->points().size() == t.points);
        }
    }
}

TEST_CASE("edges keep their curve and t through resolve()", "[fill][resolve]")
{
    contours loops = test::contours_of({test::square(0, 0, 8), test::square(4, 4, 8)});
    for (contour_edge& e : loops.edges) e.t0 = 0.0f, e.t1 = 1.0f;
    workspace space;
    const auto made = resolve(loops, fill_rule::non_zero, space);
    REQUIRE(made);
    REQUIRE(made->points().size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        const grid_point a = made->points()[i], b = made->points()[(i + 1) % 8];
        const contour_edge e = made->edges()[i];
        const test::polyline drawn = e.curve < 4 ? test::square(0, 0, 8) : test::square(4, 4, 8);
        const grid_point from = drawn[e.curve % 4], to = drawn[(e.curve + 1) % 4];
        const auto at = [&](float t) {
            return grid_point{from.x + static_cast<std::int32_t>(t * static_cast<float>(to.x - from.x)),
                              from.y + static_cast<std::int32_t>(t * static_cast<float>(to.y - from.y))};
        };
        CHECK(at(e.t0) == a);
        CHECK(at(e.t1) == b);
    }
}

TEST_CASE("crossing_of() rounds exactly, up to the largest coordinates", "[fill][resolve]")
{
    test::dice d{23};
    for (int i = 0; i < 20'000; ++i) {
        const int bits = 2 + d.roll(28);
        const auto any = [&] {
            return grid_point{d.roll(1 << bits) - (1 << bits) / 2, d.roll(1 << bits) - (1 << bits) / 2};
        };
        const grid_point a = any(), b = any(), c = any(), e = any();
        grid_point x{77, 77};
        const bool crosses = test::oracle::side(a, b, c) * test::oracle::side(a, b, e) < 0 &&
                             test::oracle::side(c, e, a) * test::oracle::side(c, e, b) < 0;
        REQUIRE(crossing_of(a, b, c, e, x) == crosses);
        if (!crosses) continue;
        grid_point turned{};
        REQUIRE(crossing_of(e, c, b, a, turned));
        CHECK(turned == x);
        // The lines come through the cell round x: the nearest corners of the cell lie on both sides, or on them.
        for (const auto& [p, q] : {std::pair{a, b}, std::pair{c, e}}) {
            const double dx = double(q.x) - p.x, dy = double(q.y) - p.y;
            const double side = dx * (double(x.y) - p.y) - dy * (double(x.x) - p.x);
            CHECK(std::fabs(side) <= 0.5 * (std::fabs(dx) + std::fabs(dy)) * (1 + 1e-9));
        }
    }
}

TEST_CASE("resolve() without memory reports it and keeps the contours, and needs none once warm", "[fill][resolve]")
{
    const test::shape s{"pentagram", {pentagram(31, 9, 1000), test::square(-200, -100, 900)}};
    const contours loops = test::contours_of(s);
    const auto copy = [&](contours& to) {
        to.points.clear(), to.edges.clear(), to.starts.clear();
        REQUIRE(to.points.append(loops.points.view()));
        REQUIRE(to.edges.append(loops.edges.view()));
        REQUIRE(to.starts.append(loops.starts.view()));
    };
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        contours own{memory.source()};
        copy(own);
        memory.requests = 0;
        memory.fail_at = nth;
        memory.fail_once = true;
        const result<region> made = resolve(own, fill_rule::non_zero, space);
        was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!made) {
            CHECK(made.error() == error::out_of_memory);
            CHECK(std::ranges::equal(own.points, loops.points));
            REQUIRE(resolve(own, fill_rule::non_zero, space));
        }
        for (int again = 0; again < 2; ++again) {
            copy(own);
            const std::size_t warm = memory.requests;
            REQUIRE(resolve(own, fill_rule::non_zero, space));
            if (again == 1) CHECK(memory.requests == warm);
        }
    }
}

TEST_CASE("An edge that is bent by rounding does not cross another one", "[fill][resolve]")
{
    // Even-odd left (5, 3) to (5, 5) and (3, 8) to (6, 3), which cross at (5, 4.67).
    const test::shape s{
        "three bent loops",
        {{{3, 5}, {3, 2}, {5, 5}, {1, 2}, {0, 7}}, {{8, 4}, {5, 3}, {3, 5}, {1, 4}, {3, 8}}, {{9, 0}, {6, 1}, {3, 8}}}};
    CHECK(mistake_on(s, fill_rule::even_odd) == "");
    CHECK(mistake_on(test::shape{"one bent loop", {{{5, 30}, {30, 8}, {18, 38}, {25, 40}, {9, 4}, {16, 20}}}}) == "");
}

TEST_CASE("A crossing that waits for an edge is forgotten when the edge ends", "[fill][resolve][snap_rounding]")
{
    const test::shape s{
        "three knots",
        {{{13, 2}, {13, 4}, {7, 5}, {1, 1}, {10, 13}, {4, 3}, {10, 2}, {10, 1}},
         {{7, 11}, {13, 0}, {3, 8}, {12, 7}, {6, 2}, {7, 13}, {11, 4}, {1, 9}, {0, 6}, {10, 4}, {3, 7}, {8, 8}},
         {{13, 9}, {7, 0}, {9, 13}, {7, 8}, {9, 11}, {1, 9}, {5, 1}, {6, 4}, {12, 0}, {3, 10}, {4, 8}}}};
    CHECK(mistake_on(s) == "");
}

TEST_CASE("A resolved region has sorted points, whether its contours had them or not", "[fill][resolve]")
{
    test::dice d{91};
    int touching = 0;
    for (int i = 0; i < 600; ++i) {
        const int width = i % 2 == 0 ? 9 : 3000;
        const std::vector<test::polyline> given = test::random_polylines(d, 1 + d.roll(3), 3, 20, width).loops;
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            contours loops = test::contours_of(given), sorted = test::contours_of(given);
            workspace space;
            REQUIRE(sort_points(sorted, space));
            const auto made = resolve(loops, rule, space), again = resolve(sorted, rule, space);
            REQUIRE(made);
            REQUIRE(again);
            CHECK(std::ranges::equal(made->points(), again->points()));
            std::vector<std::uint32_t> expected(made->points().size());
            REQUIRE(sweep_order(made->points(), space, expected.data()));
            CHECK(std::ranges::equal(made->order(), expected));
            touching += made->is_touching();
        }
    }
    CHECK(touching > 50);
}

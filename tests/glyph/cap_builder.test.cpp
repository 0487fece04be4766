// SPDX-License-Identifier: MIT

// Contours that only touch in points: proven without being resolved, and the same region as if they were.

#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/cycles.hpp"
#include "support/regions.hpp"
#include "support/unproving.hpp"

#include <tuple>

using namespace typemesh;

namespace {

using triangulators = std::tuple<monotone, constrained_delaunay>;

/// Each request for memory fails once. The builder works again after that, and a warm one requests nothing.
template <class Make>
void check_memory(const std::vector<test::polyline>& given, const Make& make, bool keeps_loops)
{
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        cap_builder caps{memory.source()};
        caps.loops() = test::contours_of(given, memory.source());
        const std::size_t before = memory.requests;
        memory.fail_at = before + nth;
        memory.fail_once = true;
        const auto made = make(caps);
        const bool has_failed = memory.requests >= before + nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!made) {
            CHECK(made.error() == error::out_of_memory);
            CHECK(caps.triangles().empty());
            if (keeps_loops) CHECK(test::oracle::loops_of(caps.loops()).size() == given.size());
        }
        for (int again = 0; again < 3; ++again) {
            const contours fresh = test::contours_of(given);
            contours& loops = caps.loops();
            loops.clear();
            REQUIRE((loops.points.append(fresh.points.view()) && loops.edges.append(fresh.edges.view()) &&
                     loops.starts.append(fresh.starts.view())));
            const std::size_t warm = memory.requests;
            REQUIRE(make(caps));
            if (again == 2) CHECK(memory.requests == warm);
        }
        if (!has_failed) break;
    }
}

/// Whether no two edges of the loops meet otherwise than in common ends, and no contour has fewer than 3 points.
bool only_touch(const std::vector<test::oracle::loop>& loops)
{
    std::vector<std::pair<grid_point, grid_point>> edges;
    for (const auto l : loops) {
        if (l.size() < 3) return false;
        for (std::size_t i = 0; i < l.size(); ++i) edges.emplace_back(l[i], l[(i + 1) % l.size()]);
    }
    using test::oracle::lies_on;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [a, b] = edges[i];
        if (a == b) return false;
        for (std::size_t k = 0; k < i; ++k) {
            const auto [c, d] = edges[k];
            const bool ends_meet = a == c || a == d || b == c || b == d;
            if (!ends_meet && test::oracle::meet(a, b, c, d)) return false;
            for (const grid_point p : {a, b})
                if (!(p == c) && !(p == d) && lies_on(p, c, d)) return false;
            for (const grid_point p : {c, d})
                if (!(p == a) && !(p == b) && lies_on(p, a, b)) return false;
            if ((a == c && b == d) || (a == d && b == c)) return false;
        }
    }
    return true;
}

/// A triangulator as a user may write it: it proves, but refuses loops that touch, and sorts for itself.
template <class Triangulator>
struct plain_prover {
    error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        return Triangulator{}(r, space, out);
    }
    result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        contours copy;
        copy.grid = loops.grid;
        if (!copy.points.append(loops.points.view()) || !copy.edges.append(loops.edges.view()) ||
            !copy.starts.append(loops.starts.view()))
            return error::out_of_memory;
        const auto made = Triangulator{}.prove(copy, space, out);
        if (!made) return made;
        return region::proven(loops, made->holes(), made->outers());
    }
};
static_assert(proving_triangulator<plain_prover<monotone>> && !touching_triangulator<plain_prover<monotone>>);

int touched = 0, proven_fast = 0;

/// What is wrong with what the fast way makes of loops; empty when nothing is.
template <class Triangulator>
std::string mistake_on(const test::shape& s, fill_rule rule)
{
    contours resolved = test::contours_of(s);
    const auto given = test::loops_of(s);
    cap_builder caps;
    workspace space;
    caps.loops() = test::contours_of(s);
    const contours& loops = caps.loops();
    const triangle_list& out = caps.triangles();
    const auto fast = caps.prove(Triangulator{});
    orient(resolved);
    const std::int64_t signed_area = test::oracle::doubled_area(test::oracle::loops_of(resolved));
    const auto slow = resolve(resolved, rule, space);
    if (!slow) return slow.error().message();
    const bool only_touches = only_touch(given);
    if (!fast) {
        if (fast.error().code != error::crossing_contours) return fast.error().message();
        if (!out.empty()) return "refused, and triangles are left";
        contours as_given = test::contours_of(s);
        orient(as_given);
        if (!std::equal(loops.points.begin(), loops.points.end(), as_given.points.begin(), as_given.points.end()) ||
            !std::equal(loops.starts.begin(), loops.starts.end(), as_given.starts.begin(), as_given.starts.end()))
            return "refused, and the loops are others";
        for (std::size_t i = 0; i < loops.edges.size(); ++i)
            if (loops.edges[i].curve != as_given.edges[i].curve || loops.edges[i].t0 != as_given.edges[i].t0)
                return "refused, and the edges are others";
        // The interior is on the left of every edge when neither rule loses one and both fill what the loops enclose.
        bool is_region = only_touches;
        for (const fill_rule other : {fill_rule::non_zero, fill_rule::even_odd}) {
            contours again = test::contours_of(s);
            const auto made = resolve(again, other, space);
            is_region = is_region && made && made->points().size() == loops.points.size() &&
                        test::oracle::doubled_area(test::oracle::loops_of(*made)) == signed_area;
        }
        if (is_region) return "refused, and is a region that only touches itself";
        return {};
    }
    if (!only_touches) return "accepted, and edges meet";
    if (slow->points().size() != fast->points().size()) return "another number of points than resolved";
    if (test::cycles_of(*fast) != test::cycles_of(*slow)) return "other cycles than resolved";
    if (fast->holes() != slow->holes() || fast->outers() != slow->outers()) return "holes and outers are miscounted";
    if (fast->is_touching() != slow->is_touching()) return "is_touching() is wrong";
    touched += fast->is_touching();
    ++proven_fast;
    if (std::string broken = test::oracle::broken_cycle(test::oracle::loops_of(*fast)); !broken.empty()) return broken;
    return test::oracle::broken_law(*fast, out.view());
}

template <class Triangulator>
std::string mistake_on(const test::shape& s)
{
    for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd})
        if (std::string m = mistake_on<Triangulator>(s, rule); !m.empty()) return m;
    return {};
}

template <class Triangulator>
std::string mistake_in_any_position(const test::shape& s)
{
    for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
        const test::shape t = test::turned(s, degrees);
        for (const test::shape& u : {t, test::mirrored(t), test::reversed(t)})
            if (std::string m = mistake_on<Triangulator>(u); !m.empty()) return m;
    }
    return {};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("random polylines that only touch in points are proven to be the region that resolve() makes",
                        "[glyph][cap_builder]", triangulators)
{
    test::dice d{311};
    touched = proven_fast = 0;
    for (int i = 0; i < 150'000; ++i) {
        const int width = 3 + d.roll(4), count = 1 + d.roll(3), most = count == 1 ? 11 : 5;
        test::shape s{"polylines " + std::to_string(i), {}};
        for (int c = 0; c < count; ++c) {
            test::polyline l;
            for (int n = 3 + d.roll(most - 2); n > 0; --n) l.push_back({d.roll(width), d.roll(width)});
            s.loops.push_back(l);
        }
        if (i % 16 != 0 && !only_touch(test::loops_of(s))) continue;
        INFO(s);
        REQUIRE(mistake_on<TestType>(s) == "");
    }
    CHECK(touched > 100);
}

TEMPLATE_LIST_TEST_CASE("squares and rhombs that touch in corners are proven to be the region that resolve() makes",
                        "[glyph][cap_builder]", triangulators)
{
    test::dice d{312};
    touched = proven_fast = 0;
    for (int i = 0; i < 4000; ++i) {
        // Cells of a board at random, every cell a contour of its own; some inside a frame, as holes; some with more
        // points on their sides; at random turned or skewed.
        const int size = 2 + d.roll(4), skew = d.roll(3) - 1;
        const bool holes = d.roll(2) == 0;
        test::shape s{"board " + std::to_string(i), {}};
        std::vector<char> taken(static_cast<std::size_t>(size * size), 0);
        const auto place = [&](int x, int y) { return grid_point{4 * x + skew * y, 4 * y}; };
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto at = static_cast<std::size_t>(y * size + x);
                if ((x > 0 && taken[at - 1]) || (y > 0 && taken[at - std::size_t(size)]) || d.roll(3) == 0) continue;
                taken[at] = 1;
                test::polyline l{place(x, y), place(x + 1, y), place(x + 1, y + 1), place(x, y + 1)};
                if (d.roll(4) == 0) l.insert(l.begin() + 1, grid_point{4 * x + 1 + skew * y, 4 * y});
                std::rotate(l.begin(), l.begin() + d.roll(4), l.end());
                s.loops.push_back(holes ? test::reversed(l) : l);
            }
        if (holes) {  // round all of them, touching some
            test::polyline frame{place(-3, -1), place(size + 3, -1)};
            frame.push_back(place(size, 0)), frame.push_back(place(size + 3, size + 1));
            frame.push_back(place(-3, size + 1)), frame.push_back(place(0, size));
            s.loops.insert(s.loops.begin() + d.roll(static_cast<int>(s.loops.size()) + 1), frame);
        }
        INFO(s);
        REQUIRE(mistake_in_any_position<TestType>(s) == "");
    }
    CHECK(touched > 20'000);
}

TEMPLATE_LIST_TEST_CASE("any number of sectors round one point is proven, both as one loop and as separate loops",
                        "[glyph][cap_builder]", triangulators)
{
    for (int sectors = 2; sectors <= 40; ++sectors)
        for (const bool one_loop : {true, false}) {
            test::shape s{"sectors " + std::to_string(sectors), {}};
            if (one_loop) s.loops.emplace_back();
            for (int k = 0; k < sectors; ++k) {
                const auto a = test::on_circle(0, 0, 1e5, test::turn_once * (k + 0.1) / sectors),
                           b = test::on_circle(0, 0, 1e5, test::turn_once * (k + 0.6) / sectors);
                if (!one_loop) s.loops.emplace_back();
                test::polyline& l = s.loops.back();
                l.insert(l.end(), {{0, 0}, a, b});
            }
            const auto check = [&s] {
                INFO(s);
                touched = proven_fast = 0;
                CHECK(mistake_in_any_position<TestType>(s) == "");
                CHECK(touched == 24);
            };
            check();
            s.loops.push_back(test::square(-300'000, -300'000, 600'000));  // the sectors become holes
            for (std::size_t k = 0; k + 1 < s.loops.size(); ++k) s.loops[k] = test::reversed(s.loops[k]);
            check();
        }
}

TEST_CASE("a nested loop of the same direction is not a hole if it touches the outer one", "[glyph][cap_builder]")
{
    const test::shape s{"in a corner", {{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{0, 0}, {60, 20}, {20, 60}}}};
    for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
        cap_builder caps;
        caps.loops() = test::contours_of(s);
        const auto made = caps.fill({rule}, monotone{});
        REQUIRE(made);
        CHECK(made->points().size() == (rule == fill_rule::non_zero ? 4u : 7u));
        CHECK(test::oracle::doubled_area(test::oracle::loops_of(*made)) ==
              (rule == fill_rule::non_zero ? 16200 : 13000));
    }
    CHECK(mistake_in_any_position<monotone>(s) == "");
}

TEMPLATE_LIST_TEST_CASE("shapes of the corpus are proven if they only touch in points, and are else left unchanged",
                        "[glyph][cap_builder]", triangulators)
{
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        CHECK(mistake_in_any_position<TestType>(c.shape) == "");
    }
}

TEST_CASE("prove() reports a lack of memory and keeps the contours, and a warm builder requests no memory",
          "[glyph][cap_builder]")
{
    test::shape s{"holes in rows", {{{-8, -8}, {808, -8}, {808, 808}, {-8, 808}}}};
    for (std::int32_t y = 0; y < 20; ++y)
        for (std::int32_t x = y % 2; x < 20; x += 2)
            s.loops.push_back(test::reversed(test::square(40 * x, 40 * y, 40)));
    check_memory(s.loops, [](cap_builder& caps) { return caps.prove(monotone{}); }, true);
}

TEMPLATE_LIST_TEST_CASE("fill() makes the same region with triangulators that do and do not take sorted points",
                        "[glyph][cap_builder]", triangulators)
{
    test::dice d{52};
    int crossing = 0;
    for (int i = 0; i < 2000; ++i) {
        const int width = i % 2 == 0 ? 12 : 4000;
        std::vector<test::polyline> given(1 + static_cast<std::size_t>(d.roll(3)));
        for (test::polyline& l : given)
            for (int n = 3 + d.roll(i % 3 == 0 ? 1 : 12); n > 0; --n) l.push_back({d.roll(width), d.roll(width)});
        cap_builder one, two;
        one.loops() = test::contours_of(given);
        two.loops() = test::contours_of(given);
        const triangle_list &taken = one.triangles(), &sorted = two.triangles();
        const auto a = one.fill({}, TestType{});
        const auto b = two.fill({}, plain_prover<TestType>{});
        REQUIRE(a);
        REQUIRE(b);
        CHECK(test::cycles_of(*a) == test::cycles_of(*b));
        REQUIRE(a->holes() == b->holes());
        REQUIRE(taken.size() == sorted.size());
        if (!a->is_touching())  // else one may have been relinked, from other first points
            CHECK(std::equal(taken.begin(), taken.end(), sorted.begin()));
        crossing += a->points().size() != test::contours_of(given).points.size();
        REQUIRE(test::oracle::broken_law(*a, taken.view()) == "");
    }
    CHECK(crossing > 500);
}

TEST_CASE("fill() of crossing contours reports a lack of memory, and a warm builder requests no memory",
          "[glyph][cap_builder]")
{
    std::vector<test::polyline> given;
    for (std::int32_t i = 0; i < 30; ++i) given.push_back(test::square(7 * i, 5 * (i % 6), 40));
    check_memory(given, [](cap_builder& caps) { return caps.fill({}, monotone{}); }, false);
}

TEMPLATE_TEST_CASE("fill() refuses contours that cross more often than its settings allow", "[glyph][cap_builder]",
                   monotone, plain_prover<monotone>)
{
    const test::shape crossing{"crossing squares",
                               {{{0, 0}, {80, 0}, {80, 80}, {0, 80}}, {{40, 40}, {120, 40}, {120, 120}, {40, 120}}}};
    const auto is_filled = [&](const cap_settings& how) {
        cap_builder caps;
        caps.loops() = test::contours_of(crossing);
        const auto made = caps.fill(how, TestType{});
        if (!made) CHECK(made.error() == error::too_many_pieces);
        CHECK(static_cast<bool>(made) == (caps.triangles().size() != 0));
        return static_cast<bool>(made);
    };
    CHECK(is_filled({}));
    CHECK(is_filled({.max_pieces = 100}));
    CHECK_FALSE(is_filled({.max_pieces = 7}));
}

TEST_CASE("cap() cuts another builder's region, beside the builder's own or instead of it", "[glyph][cap_builder]")
{
    cap_builder caps, other;
    caps.loops() = test::contours_of({test::square(0, 0, 8)});
    other.loops() = test::contours_of({test::square(0, 0, 8), test::square(4, 4, 8)});
    REQUIRE(caps.fill({}, monotone{}));
    const auto made = other.fill({}, monotone{});
    REQUIRE(made);
    triangle_list out;
    REQUIRE(out.push_back({7, 8, 9}));
    REQUIRE(caps.cap(*made, constrained_delaunay{}, out));
    CHECK(test::oracle::broken_law(*made, out.view().subspan(1)) == "");
    CHECK(caps.triangles().size() == 2);
    CHECK(caps.loops().points.size() == 4);
    REQUIRE(caps.cap(*made, monotone{}));
    CHECK(test::oracle::broken_law(*made, caps.triangles().view()) == "");
}

TEMPLATE_TEST_CASE("points in loops() can be moved between two caps", "[glyph][cap_builder]", monotone, test::unproving)
{
    cap_builder caps;
    caps.loops() = test::contours_of({test::square(0, 0, 8)});
    REQUIRE(caps.fill({}, TestType{}));
    for (grid_point& p : caps.loops().points) p = {-p.y, 3 * p.x};
    const auto made = caps.fill({}, TestType{});
    REQUIRE(made);
    CHECK(test::oracle::broken_law(*made, caps.triangles().view()) == "");
}

TEST_CASE("a trimmed builder holds nothing", "[glyph][cap_builder]")
{
    test::counting_memory memory;
    cap_builder caps{memory.source()};
    caps.loops() = test::contours_of({test::square(0, 0, 8), test::square(4, 4, 8)}, memory.source());
    REQUIRE(caps.fill({}, monotone{}));
    caps.trim();
    CHECK(memory.bytes_held == 0);
    CHECK(caps.triangles().empty());
    CHECK(caps.loops().points.empty());
}

// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/collapse_times.hpp>

#include <typemesh/offset/impl/int128.hpp>

#include "support/catch.hpp"
#include "support/kinetic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace typemesh;
using detail::collapse;
using detail::collapse_times;
using detail::fixed_vector;
using detail::place_one;
using detail::time_one;
using test::kinetic_triangles;
using kind = detail::collapse::kind;

namespace {

using wide = detail::int128;

constexpr std::int64_t cell = place_one;

/// One triangle of three corners, whose edges are diagonals until they become segments.
struct lone_triangle {
    kinetic_triangles mesh{heap()};
    collapse_times times{mesh};
    collapse found;

    lone_triangle(fixed_vector a, fixed_vector b, fixed_vector c, std::int64_t limit)
    {
        for (const fixed_vector p : {a, b, c}) REQUIRE(mesh.vertices.push_back({{p, 0, {}}, 0, 0}));
        REQUIRE(mesh.triangles.push_back({{0, 1, 2}, {0, 0, 0}, 41}));
        times.limit = limit;
    }
    /// Makes edge k a segment, whose line runs through its corners.
    void put_segment(std::uint32_t k)
    {
        const std::uint32_t from = k, to = (k + 1) % 3, s = static_cast<std::uint32_t>(mesh.segments.size());
        const fixed_vector all = mesh.vertices[to].moves.start - mesh.vertices[from].moves.start;
        REQUIRE(mesh.lines.push_back({detail::unit_along({all.x / cell, all.y / cell})}));
        REQUIRE(mesh.segments.push_back({s, from, to, k, 0, true}));
        mesh.triangles[0].link[k] = kinetic_triangles::to_segment(s);
    }
    fixed_vector& speed(std::uint32_t v) { return mesh.vertices[v].moves.speed.of; }
    bool find(std::int64_t calm = 0) { return times.find(0, found, calm); }
};

std::int64_t roll(test::dice& d, std::int64_t size)
{
    return static_cast<std::int64_t>(d.bits() % static_cast<std::uint64_t>(2 * size + 1)) - size;
}
fixed_vector roll_vector(test::dice& d, std::int64_t size) { return {roll(d, size), roll(d, size)}; }
fixed_vector roll_place(test::dice& d)
{
    const fixed_vector p = roll_vector(d, 1'000'000);
    return {p.x * cell, p.y * cell};
}

/// An area or a length over time: c + b t + a t^2, with t = 0 now and 1 at the limit.
struct polynomial {
    long double c, b, a;

    [[nodiscard]] long double at(long double t) const { return c + (b + a * t) * t; }
    [[nodiscard]] long double size() const { return std::fabs(c) + std::fabs(b) + std::fabs(a); }
};
long double slow_cross(fixed_vector p, fixed_vector q)
{
    return static_cast<long double>(p.x) * static_cast<long double>(q.y) -
           static_cast<long double>(p.y) * static_cast<long double>(q.x);
}
polynomial area_of(const lone_triangle& t)
{
    const auto &u = t.mesh.vertices[0].moves, &v = t.mesh.vertices[1].moves, &w = t.mesh.vertices[2].moves;
    const fixed_vector p = t.times.place(1) - t.times.place(0), q = t.times.place(2) - t.times.place(0);
    const fixed_vector p_speed = v.speed.of - u.speed.of, q_speed = w.speed.of - u.speed.of;
    const long double left = static_cast<long double>(t.times.limit - t.times.now) * 0x1p-32L;
    return {slow_cross(p, q) * 0x1p-32L, (slow_cross(p, q_speed) + slow_cross(p_speed, q)) * 0x1p-48L * left,
            slow_cross(p_speed, q_speed) * 0x1p-64L * left * left};
}

/// The length of a segment after `passed`, in 2^-94 cells.
wide length_after(const lone_triangle& t, std::uint32_t segment, std::int64_t passed)
{
    const auto& s = t.mesh.segments[segment];
    const fixed_vector along = t.mesh.lines[s.line].along;
    const fixed_vector all = t.times.place(s.to) - t.times.place(s.from),
                       rate = t.mesh.vertices[s.to].moves.speed.of - t.mesh.vertices[s.from].moves.speed.of;
    return ((static_cast<wide>(along.x) * all.x + static_cast<wide>(along.y) * all.y) << 48) +
           (static_cast<wide>(along.x) * rate.x + static_cast<wide>(along.y) * rate.y) * passed;
}
/// The distance of the apex from the line of a segment after `passed`, in 2^-94 cells.
wide height_after(const lone_triangle& t, std::uint32_t segment, std::uint32_t apex, std::int64_t passed)
{
    const auto& s = t.mesh.segments[segment];
    const fixed_vector inward = t.mesh.lines[s.line].inward();
    const fixed_vector all = t.times.place(apex) - t.times.place(s.from), rate = t.mesh.vertices[apex].moves.speed.of;
    const wide own = static_cast<wide>(1) << 62;
    return ((static_cast<wide>(inward.x) * all.x + static_cast<wide>(inward.y) * all.y) << 48) +
           (static_cast<wide>(inward.x) * rate.x + static_cast<wide>(inward.y) * rate.y - own) * passed;
}

long double doubled_area(const kinetic_triangles& mesh, std::uint32_t t, std::int64_t time)
{
    const auto place = [&](int k) { return mesh.vertices[mesh.triangles[t].corner[k]].moves.place(time); };
    return slow_cross(place(1) - place(0), place(2) - place(0)) * 0x1p-32L;
}

}  // namespace

TEST_CASE("a triangle between diagonals turns at the first root of its area", "[offset][collapse_times]")
{
    test::dice d{1};
    int turning = 0, staying = 0;
    for (int i = 0; i < 50'000; ++i) {
        lone_triangle t{roll_place(d), roll_place(d), roll_place(d), (1 + d.roll(1'000'000)) * time_one};
        for (std::uint32_t v = 0; v < 3; ++v) t.speed(v) = roll_vector(d, 4 * time_one);
        if (i % 3 == 0) t.times.now = t.times.limit / 3;
        if (i % 5 == 0) t.speed(2) = t.speed(1) = t.speed(0);  // does not change
        const polynomial area = area_of(t);
        if (area.c <= 0) continue;
        const long double rounding = area.size() * 0x1p-50L;
        const bool turns = t.find();
        const auto left = static_cast<long double>(t.times.limit - t.times.now);
        const auto passed = static_cast<long double>((turns ? t.found.time : t.times.limit) - t.times.now);
        const long double end = passed / left, next = (passed + 2) / left;
        for (int k = 0; k < 64; ++k) CHECK_QUICKLY(area.at(end * k / 64) > -rounding);
        if (turns) {
            CHECK((t.found.what == kind::turn && t.found.triangle == 0 && t.found.stamp == 41));
            CHECK_QUICKLY(std::fabs(area.at(end)) <= rounding || area.at(next) <= 0);
        }
        ++(turns ? turning : staying);
    }
    CHECK(turning > 1000);
    CHECK(staying > 1000);
}

TEST_CASE("a flat or reversed triangle turns now, unless it opens", "[offset][collapse_times]")
{
    constexpr std::int64_t limit = 100 * time_one;
    lone_triangle over{{0, 0}, {0, 9 * cell}, {9 * cell, 0}, limit};
    over.times.now = 7;
    CHECK(over.find());
    CHECK(over.found.time == 7);
    for (const int up : {-1, 0, 1}) {
        lone_triangle flat{{0, 0}, {9 * cell, 0}, {3 * cell, 0}, limit};
        flat.speed(2).y = up * time_one;
        CHECK(flat.find() == (up < 0));
        CHECK(flat.found.time == (up < 0 ? 0 : limit + 1));
    }
}

TEST_CASE("a triangle on a segment goes when that shrinks to a point or meets the apex", "[offset][collapse_times]")
{
    test::dice d{2};
    int shrinking = 0, meeting = 0, staying = 0;
    for (int i = 0; i < 50'000; ++i) {
        lone_triangle t{roll_place(d), roll_place(d), roll_place(d), (1 + d.roll(1'000'000)) * time_one};
        if (area_of(t).c <= 0) continue;
        const auto k = static_cast<std::uint32_t>(d.roll(3));
        t.put_segment(k);
        for (std::uint32_t v = 0; v < 3; ++v) t.speed(v) = roll_vector(d, 2 * time_one);
        if (height_after(t, 0, (k + 2) % 3, 0) <= 0 || length_after(t, 0, 0) < static_cast<wide>(1) << 94) continue;
        const bool goes = t.find();
        const std::int64_t time = goes ? t.found.time : t.times.limit + 3;
        const auto is_positive = [&](std::int64_t passed) {
            return length_after(t, 0, passed) > 0 && height_after(t, 0, (k + 2) % 3, passed) > 0;
        };
        CHECK_QUICKLY(time < 2 || is_positive(time - 2));
        if (goes) {
            const bool shrinks = t.found.what == kind::shrink;
            CHECK((shrinks || t.found.what == kind::meet));
            CHECK(t.found.k == k);
            const wide then = shrinks ? length_after(t, 0, time + 2) : height_after(t, 0, (k + 2) % 3, time + 2);
            CHECK_QUICKLY(then <= 0);
            ++(shrinks ? shrinking : meeting);
        } else {
            ++staying;
        }
    }
    CHECK(shrinking > 1000);
    CHECK(meeting > 1000);
    CHECK(staying > 1000);
}

TEST_CASE("a collapse at the limit is found, and a later one is not", "[offset][collapse_times]")
{
    lone_triangle t{{0, 0}, {100 * cell, 0}, {50 * cell, 30 * cell}, 30 * time_one};
    t.put_segment(0);
    for (std::uint32_t v = 0; v < 2; ++v) t.speed(v).y = time_one;
    REQUIRE(t.find());
    CHECK(t.found.time == 30 * time_one);
    CHECK(t.found.what == kind::meet);
    CHECK(t.found.reach == 100 * cell);
    --t.times.limit;
    CHECK_FALSE(t.find());
    CHECK(t.found.time > t.times.limit);
}

TEST_CASE("a triangle that waits for calm does not meet or turn before, but may shrink", "[offset][collapse_times]")
{
    lone_triangle over{{0, 0}, {0, 9 * cell}, {9 * cell, 0}, 100 * time_one};
    REQUIRE(over.find(3 * time_one));
    CHECK((over.found.what == kind::turn && over.found.time == 3 * time_one));
    CHECK_FALSE(over.find(101 * time_one));

    lone_triangle t{{0, 0}, {100 * cell, 0}, {50 * cell, 30 * cell}, 100 * time_one};
    t.put_segment(0);
    for (std::uint32_t v = 0; v < 2; ++v) t.speed(v).y = time_one;
    REQUIRE(t.find(20 * time_one));
    CHECK((t.found.what == kind::meet && t.found.time == 30 * time_one));
    REQUIRE(t.find(40 * time_one));
    CHECK((t.found.what == kind::meet && t.found.time == 40 * time_one));
    t.speed(1).x = -4 * time_one;
    REQUIRE(t.find(40 * time_one));
    CHECK((t.found.what == kind::shrink && t.found.time == 25 * time_one));
}

TEST_CASE("a triangle beside an instant corner closes up now", "[offset][collapse_times]")
{
    for (std::uint32_t instant = 0; instant < 3; ++instant) {
        lone_triangle t{{0, 0}, {100 * cell, 0}, {50 * cell, 300 * cell}, 10 * time_one};
        t.mesh.vertices[instant].moves.speed.instant = true;
        CHECK_FALSE(t.find());  // between diagonals it waits
        t.put_segment(0);
        t.times.now = 5;
        CHECK(t.find() == (instant != 2));
        if (instant != 2) CHECK((t.found.what == kind::close_up && t.found.time == 5 && t.found.k == 0));
    }
}

TEST_CASE("a segment without length is gone unless it grows from the start", "[offset][collapse_times]")
{
    struct {
        std::int64_t length, since, rate;
        bool goes;
    } constexpr cases[] = {{0, 0, 0, true},
                           {0, 0, time_one, false},
                           {0, 0, -time_one, true},
                           {cell / 32, 9 * time_one, 0, true},
                           {cell / 32, 9 * time_one, time_one, true},
                           {cell / 8, 9 * time_one, time_one, false},
                           {cell / 32, time_one / 2, time_one, false},  // of a join, which turns by a few degrees
                           {cell / 1024, time_one / 2, time_one, true}};
    for (const auto& c : cases) {
        lone_triangle t{{0, 0}, {9 * cell, 0}, {50 * cell, 300 * cell}, 10 * time_one};
        t.put_segment(0);
        t.mesh.vertices[1].moves = {{c.length, 0}, c.since, {{c.rate, time_one}, false}};
        t.speed(0).y = time_one;
        t.mesh.vertices[0].moves.since = t.times.now = c.since;
        CHECK(t.find() == c.goes);
        if (c.goes) CHECK((t.found.what == kind::shrink && t.found.time == c.since));
    }
}

TEST_CASE("a triangle between two segments that turn right goes if the shorter has a few cells",
          "[offset][collapse_times]")
{
    for (const std::int64_t size : {1, 3, 5}) {
        lone_triangle t{{0, 0}, {50 * cell, cell}, {50 * cell, (1 + size) * cell}, 10 * time_one};
        t.put_segment(0);
        t.put_segment(1);
        std::swap(t.mesh.lines[0], t.mesh.lines[1]);  // as if they turned right
        t.times.now = 3;
        const bool goes = t.find() && t.found.what == kind::shrink && t.found.time == 3 && t.found.k == 1;
        CHECK(goes == (size <= 4));
    }
}

TEST_CASE("triangles of regions have area until their collapse, and none then", "[offset][collapse_times]")
{
    test::dice d{3};
    int kinds[4] = {}, staying = 0;
    for (int i = 0; i < 300; ++i) {
        const double radius = i % 3 == 0 ? 1'000'000 : 20'000;
        const auto seed = static_cast<std::uint64_t>(i);
        detail::wavefront front{heap()};
        test::set_up(front, i % 2 == 0 ? test::shape{"star", {test::star(5 + d.roll(60), radius, seed)}}
                                       : test::circle_with_holes(8 + d.roll(40), 1 + d.roll(9)));
        const kinetic_triangles& mesh = front.mesh;
        collapse_times times{mesh};
        times.limit = static_cast<std::int64_t>(radius / 4) * time_one;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            collapse found;
            const bool goes = times.find(t, found);
            const std::int64_t end = goes ? found.time : times.limit;
            bool positive = true;
            long double most = 0;
            for (int k = 0; k < 32; ++k) {
                const long double area = doubled_area(mesh, t, end / 32 * k);
                most = (std::max)(most, area);
                positive = positive && area > -most * 0x1p-12L - 1.0L;
            }
            if (!positive) CHECK(positive);
            if (goes) {
                CHECK_QUICKLY(std::fabs(doubled_area(mesh, t, end)) <= most * 0x1p-12L + 1.0L);
                ++kinds[static_cast<int>(found.what)];
            } else {
                ++staying;
            }
        }
    }
    CHECK(kinds[static_cast<int>(kind::shrink)] > 300);
    CHECK(kinds[static_cast<int>(kind::meet)] > 300);
    CHECK(kinds[static_cast<int>(kind::turn)] > 300);
    CHECK(staying > 300);
}

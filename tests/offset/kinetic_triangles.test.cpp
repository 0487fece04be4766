// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/kinetic_triangles.hpp>

#include "support/catch.hpp"
#include "support/kinetic.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

using namespace typemesh;
using test::kinetic_triangles;

namespace {

/// The front of a shape before it moves, and its triangles.
struct resting {
    detail::wavefront front{heap()};
    kinetic_triangles& mesh = front.mesh;

    explicit resting(const test::shape& s) { test::set_up(front, s); }
};

std::vector<test::shape> shapes()
{
    std::vector<test::shape> all = test::generated_regions();
    // The holes touch their outer loop and each other: corners at one place are still different corners.
    all.push_back(
        {"touching holes",
         {test::square(0, 0, 40), {{0, 20}, {10, 30}, {20, 20}, {10, 10}}, {{20, 20}, {30, 30}, {40, 20}, {30, 10}}}});
    return all;
}

std::uint32_t halves(const kinetic_triangles& mesh) { return static_cast<std::uint32_t>(3 * mesh.triangles.size()); }

std::uint32_t degree(kinetic_triangles& mesh, std::uint32_t after)
{
    std::uint32_t count = 0;
    mesh.around(after, [&](std::uint32_t) { ++count; });
    return count;
}
/// The segment that begins at the corner with most triangles.
std::uint32_t widest(kinetic_triangles& mesh)
{
    std::uint32_t after = 0;
    for (std::uint32_t k = 0; k < mesh.segments.size(); ++k)
        if (degree(mesh, k) > degree(mesh, after)) after = k;
    return after;
}

}  // namespace

TEST_CASE("link_all() finds the same twins and segments as a full search", "[offset][kinetic_triangles]")
{
    for (const test::shape& s : shapes()) {
        const resting r{s};
        const kinetic_triangles& mesh = r.mesh;
        INFO(s.name);
        REQUIRE(mesh.triangles.size() > 0);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> found;
        for (std::uint32_t h = 0; h < halves(mesh); ++h)
            found[{mesh.origin(h), mesh.origin(kinetic_triangles::next(h))}] = h;
        REQUIRE(found.size() == halves(mesh));
        std::size_t segments = 0;
        for (const auto& [ends, h] : found) {
            const auto twin = found.find({ends.second, ends.first});
            const std::uint32_t expected =
                twin != found.end() ? twin->second : kinetic_triangles::to_segment(ends.first);
            CHECK_QUICKLY(mesh.link(h) == expected);
            segments += twin == found.end();
        }
        CHECK(segments == mesh.segments.size());
        CHECK(test::broken_link(mesh) == "");
    }
}

TEST_CASE("flips keep all links mutual", "[offset][kinetic_triangles]")
{
    test::dice d{1};
    for (const test::shape& s : shapes()) {
        resting fresh{s};
        kinetic_triangles& mesh = fresh.mesh;
        if (mesh.triangles.size() > 2000) continue;
        INFO(s.name);
        for (int i = 0; i < 200; ++i) {
            const auto h = static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(halves(mesh))));
            if (kinetic_triangles::is_segment(mesh.link(h))) continue;
            const std::uint32_t t = h / 3, r = mesh.link(h) / 3, stamp = mesh.triangles[t].stamp;
            const std::uint32_t a = mesh.origin(h), b = mesh.origin(mesh.link(h)), c = mesh.apex(h),
                                other = mesh.apex(mesh.link(h));
            if (c == other) continue;  // around a hole, inside no flat triangle
            mesh.flip(h);
            const auto has = [&](std::uint32_t one, std::uint32_t u, std::uint32_t v, std::uint32_t w) {
                const auto* corner = mesh.triangles[one].corner;
                for (int k = 0; k < 3; ++k)
                    if (corner[k] == u && corner[(k + 1) % 3] == v && corner[(k + 2) % 3] == w) return true;
                return false;
            };
            REQUIRE(has(t, a, other, c));
            REQUIRE(has(r, b, c, other));
            REQUIRE(mesh.triangles[t].stamp == stamp);
            REQUIRE(test::broken_link(mesh) == "");
        }
    }
}

TEST_CASE("thin_out() takes allowed triangles from a corner until enough are gone", "[offset][kinetic_triangles]")
{
    for (const test::shape& s : shapes()) {
        INFO(s.name);
        for (const std::uint32_t may : {0u, 1u, 2u}) {  // none, one, or all
            for (const bool once : {true, false}) {
                resting r{s};
                kinetic_triangles& mesh = r.mesh;
                const std::uint32_t after = widest(mesh), before = degree(mesh, after),
                                    corner = mesh.segments[after].from;
                const std::uint32_t enough = once ? before - before / 2 : 1;
                std::uint32_t allowed = 0, looks = 0;
                std::vector<std::uint32_t> taken;
                kinetic_triangles::rounds look;
                REQUIRE(mesh.thin_out(
                    after, enough,
                    [&](std::uint32_t h) {
                        ++looks;
                        CHECK(mesh.origin(h) == corner);
                        const std::uint32_t diagonal = kinetic_triangles::previous(h);
                        return mesh.apex(diagonal) != mesh.apex(mesh.link(diagonal)) && (may == 2 || allowed++ < may);
                    },
                    [&](std::uint32_t t) { taken.push_back(t); }, look));
                const auto count = static_cast<std::uint32_t>(taken.size());
                CHECK(test::broken_link(mesh) == "");
                CHECK(degree(mesh, after) == before - count);
                CHECK(looks <= before + 2 * count);
                if (once) CHECK(count <= before / 2);
                if (may == 0 || before == 1) CHECK(count == 0);
                if (may == 2 && mesh.vertices.size() == mesh.triangles.size() + 2)  // no hole
                    CHECK(count == (once ? before / 2 : before - 1));
                for (const std::uint32_t t : taken)
                    for (const std::uint32_t v : mesh.triangles[t].corner) CHECK(v != corner);
            }
        }
    }
}

TEST_CASE("thin_out() does not look all around a corner for one triangle a round", "[offset][kinetic_triangles]")
{
    test::polyline fan{{0, 0}};
    for (int i = 0; i <= 400; ++i) fan.push_back({20'000 + i * (400 - i), i * 100 - 20'000});
    resting r{{"fan", {fan}}};
    kinetic_triangles& mesh = r.mesh;
    const std::uint32_t after = widest(mesh), before = degree(mesh, after);
    std::uint32_t taken = 0, looks = 0;
    kinetic_triangles::rounds look;
    REQUIRE(mesh.thin_out(
        after, 1,
        [&](std::uint32_t h) {
            ++looks;
            return kinetic_triangles::is_segment(mesh.link(h));  // only of the first one
        },
        [&](std::uint32_t) { ++taken; }, look));
    CHECK(taken > before / 4);
    CHECK(looks <= before + 2 * taken);
    CHECK(test::broken_link(mesh) == "");
}

TEST_CASE("around() visits all half-edges that leave a corner, counter-clockwise", "[offset][kinetic_triangles]")
{
    for (const test::shape& s : shapes()) {
        resting r{s};
        kinetic_triangles& mesh = r.mesh;
        INFO(s.name);
        std::vector<std::vector<std::uint32_t>> leaving(mesh.vertices.size());
        for (std::uint32_t h = 0; h < halves(mesh); ++h) leaving[mesh.origin(h)].push_back(h);
        for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
            std::vector<std::uint32_t> seen;
            mesh.around(mesh.vertices[v].after, [&](std::uint32_t h) noexcept { seen.push_back(h); });
            CHECK_QUICKLY(mesh.link(seen.front()) == kinetic_triangles::to_segment(mesh.vertices[v].after));
            const std::uint32_t last = mesh.link(kinetic_triangles::previous(seen.back()));
            CHECK_QUICKLY(last == kinetic_triangles::to_segment(mesh.vertices[v].before));
            for (std::size_t i = 0; i + 1 < seen.size(); ++i)  // the next one leaves on this triangle's other side
                CHECK_QUICKLY(mesh.origin(kinetic_triangles::next(seen[i + 1])) == mesh.apex(seen[i]));
            std::sort(seen.begin(), seen.end());
            CHECK_QUICKLY(seen == leaving[v]);
        }
    }
}

TEST_CASE("set_corner() replaces a corner in its segments and triangles, and no other", "[offset][kinetic_triangles]")
{
    resting r{{"star", {test::star(30, 10'000, 1)}}};
    kinetic_triangles& mesh = r.mesh;
    for (std::uint32_t v = 0; v < 30; ++v) {
        const std::uint32_t before = mesh.vertices[v].before, after = mesh.vertices[v].after;
        const auto fresh = static_cast<std::uint32_t>(mesh.vertices.size());
        std::vector<std::uint32_t> expected;
        for (std::uint32_t h = 0; h < halves(mesh); ++h)
            expected.push_back(mesh.origin(h) == v ? fresh : mesh.origin(h));
        const auto copy = mesh.vertices[v];
        REQUIRE(mesh.vertices.push_back(copy));
        mesh.set_corner(before, fresh, after);
        for (std::uint32_t h = 0; h < halves(mesh); ++h) CHECK(mesh.origin(h) == expected[h]);
        CHECK(test::broken_link(mesh) == "");
    }
}

TEST_CASE("close() joins the other two sides, and reports when nothing is left", "[offset][kinetic_triangles]")
{
    //   3-----2      Each edge in turn loses its length: its triangle goes, and the segment that is left gets the
    //   |   / |      diagonal's other side.
    //   | /   |
    //   0-----1
    for (std::uint32_t lost = 0; lost < 4; ++lost) {
        resting square{{"square", {test::square(0, 0, 10)}}};
        kinetic_triangles& mesh = square.mesh;
        const std::uint32_t h = mesh.segments[lost].half, t = h / 3, r = 1 - t, stamp = mesh.triangles[t].stamp;
        const std::uint32_t a = mesh.link(kinetic_triangles::next(h)), b = mesh.link(kinetic_triangles::previous(h));
        REQUIRE(kinetic_triangles::is_segment(a) != kinetic_triangles::is_segment(b));
        CHECK(mesh.close(h));
        CHECK_FALSE(mesh.triangles[t].alive);
        CHECK(mesh.triangles[t].stamp == stamp + 1);
        const std::uint32_t segment = kinetic_triangles::is_segment(a) ? a : b,
                            half = kinetic_triangles::is_segment(a) ? b : a;
        CHECK(half / 3 == r);
        CHECK(mesh.link(half) == segment);
        CHECK(mesh.segments[kinetic_triangles::segment_in(segment)].half == half);
        for (std::uint32_t k = 0; k < 3; ++k) CHECK(kinetic_triangles::is_segment(mesh.link(3 * r + k)));
        CHECK_FALSE(mesh.close(3 * r));
        CHECK_FALSE(mesh.triangles[r].alive);
    }
}

TEST_CASE("close() between two diagonals links their other sides", "[offset][kinetic_triangles]")
{
    resting r{{"star", {test::star(60, 10'000, 2)}}};
    kinetic_triangles& mesh = r.mesh;
    int closed = 0;
    for (std::uint32_t s = 0; s < 60; ++s) {
        const std::uint32_t h = mesh.segments[s].half;
        const std::uint32_t a = mesh.link(kinetic_triangles::next(h)), b = mesh.link(kinetic_triangles::previous(h));
        if (!mesh.triangles[h / 3].alive || kinetic_triangles::is_segment(a) || kinetic_triangles::is_segment(b))
            continue;
        CHECK(mesh.close(h));
        CHECK(mesh.link(a) == b);
        CHECK(mesh.link(b) == a);
        ++closed;
    }
    CHECK(closed > 5);
}

// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/edge_splitter.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::edge_splitter;
using detail::refinable_mesh;

namespace {

constexpr auto look_at_none = [](std::uint32_t) noexcept { return true; };

/// A shape with its triangles, and a mesh of them.
struct splittable {
    test::filled_shape shape;
    refinable_mesh mesh;

    explicit splittable(const test::shape& s) : shape{s}
    {
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        REQUIRE(mesh.open(shape.filled, given.view()));
    }

    [[nodiscard]] std::int64_t squared_length(std::uint32_t a) const
    {
        return squared_distance(mesh.place(a), mesh.place(mesh.next_on_boundary(a)));
    }
    /// Whether a corner opposite lies in the circle over the edge that leaves a.
    [[nodiscard]] bool is_encroached(std::uint32_t a) const
    {
        const std::uint32_t h = mesh.at(a).boundary;
        const grid_point p = mesh.place(a), q = mesh.place(mesh.target(h)), c = mesh.place(mesh.apex(h));
        return squared_distance(p, q) > squared_distance(p, c) + squared_distance(c, q);
    }
    /// Lists the edges that must be split, and splits them.
    error split_all(edge_splitter& edges)
    {
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            if (!edges.examine(mesh, mesh.at(v).boundary)) return error::out_of_memory;
        return edges.split_listed(mesh, look_at_none);
    }
};

test::shape wedge(std::int32_t rise) { return {"wedge", {{{0, 0}, {100'000, 0}, {100'000, rise}}}}; }

}  // namespace

TEST_CASE("after a splitter's work no edge is too long, and no corner lies in the circle over an edge", "[refine]")
{
    test::dice d{31};
    edge_splitter edges;
    std::size_t points = 0;
    for (int round = 0; round < 60; ++round) {
        test::shape s{"random polygon", {test::random_polygon(5 + d.roll(20), 40, d)}};
        for (grid_point& p : s.loops[0]) p = {10'000 * p.x, 10'000 * p.y};
        if (!inspect::is_region(test::loops_of(s))) continue;
        for (const std::int64_t longest : {std::int64_t{0}, std::int64_t{30'000}}) {
            splittable given{s};
            const refinable_mesh& mesh = given.mesh;
            edges.open(given.shape.filled, longest * longest, 100'000);
            CHECK(edges.is_too_long(longest * longest + 1) == (longest != 0));
            CHECK_FALSE(edges.is_too_long(longest * longest));
            REQUIRE_FALSE(given.split_all(edges));
            CHECK(edges.take() == edge_splitter::none);
            std::size_t bad = 0;
            for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                if (edge_splitter::is_too_short(given.squared_length(v))) continue;
                bad += given.is_encroached(v) || edges.is_too_long(given.squared_length(v));
            }
            CAPTURE(round, longest);
            CHECK(bad == 0);
            points += mesh.vertex_count() - s.loops[0].size();
        }
    }
    CHECK(points > 1000);
}

TEST_CASE("edges at a sharp corner are cut at the same power of two from it, others in the middle", "[refine]")
{
    for (const std::int32_t rise : {3'000, 90'000}) {  // 2 and 42 degrees, and the opposite of 48
        splittable given{wedge(rise)};
        edge_splitter edges;
        edges.open(given.shape.filled, 0, 100);
        REQUIRE_FALSE(edges.split(given.mesh, 0, look_at_none));
        REQUIRE_FALSE(edges.split(given.mesh, 2, look_at_none));
        REQUIRE(given.mesh.vertex_count() == 5);
        const grid_point corner = given.mesh.place(0), on_first = given.mesh.place(3), on_last = given.mesh.place(4);
        CAPTURE(rise, on_first.x, on_first.y, on_last.x, on_last.y);
        if (rise == 3'000) {
            const auto distance = [&](grid_point p) { return std::sqrt(double(squared_distance(corner, p))); };
            CHECK(distance(on_first) == 65536.0);
            CHECK(std::abs(distance(on_last) - 65536.0) < 1.0);
        } else {  // sharp at both ends
            CHECK(std::abs(on_last.x - 50'000) <= 1);
            CHECK(std::abs(on_last.y - 45'000) <= 1);
        }
    }
    splittable square{{"square", {test::square(0, 0, 1000)}}};
    edge_splitter edges;
    edges.open(square.shape.filled, 0, 100);
    const grid_point p = square.mesh.place(0), q = square.mesh.place(square.mesh.next_on_boundary(0));
    REQUIRE_FALSE(edges.split(square.mesh, 0, look_at_none));
    CHECK(square.mesh.place(4) == grid_point{(p.x + q.x) / 2, (p.y + q.y) / 2});
}

TEST_CASE("a splitter looks once at each triangle that has changed, and stops where a look fails", "[refine]")
{
    splittable given{test::circle_with_holes(40, 3)};
    edge_splitter edges;
    edges.open(given.shape.filled, 0, 10'000);
    const std::uint32_t count = given.mesh.vertex_count();
    for (std::uint32_t a = 0; a < count; ++a) {
        std::multiset<std::uint32_t> seen;
        REQUIRE_FALSE(edges.split(given.mesh, a, [&](std::uint32_t t) {
            seen.insert(t);
            return true;
        }));
        if (given.mesh.vertex_count() == count) continue;
        const auto changed = given.mesh.changed();
        CHECK(std::set<std::uint32_t>(changed.begin(), changed.end()) ==
              std::set<std::uint32_t>(seen.begin(), seen.end()));
        CHECK(std::set<std::uint32_t>(seen.begin(), seen.end()).size() == seen.size());
    }
    CHECK(given.mesh.vertex_count() == 2 * count);
    CHECK(edges.split(given.mesh, 0, [](std::uint32_t) { return false; }) == error::out_of_memory);
}

TEST_CASE("a splitter ends at its limit of points, and says so without memory", "[refine]")
{
    splittable given{wedge(1'000)};
    edge_splitter edges;
    edges.open(given.shape.filled, 1'000 * 1'000, 20);
    const error e = given.split_all(edges);
    CHECK(e == error::too_many_points);
    CHECK(e.count == 20);
    CHECK(given.mesh.vertex_count() == 21);
    CHECK(edges.too_many(given.mesh) == error::too_many_points);

    bool done = false;
    for (std::size_t nth = 1; !done && nth < 20; ++nth) {
        splittable again{wedge(1'000)};
        test::counting_memory memory{.fail_at = nth};
        edge_splitter poor{memory.source()};
        poor.open(again.shape.filled, 1'000 * 1'000, 10'000);
        const error failed = again.split_all(poor);
        done = !failed;
        if (failed) CHECK(failed == error::out_of_memory);
        CHECK(done == (memory.requests < nth));
    }
    CHECK(done);
}

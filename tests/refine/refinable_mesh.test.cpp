// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <algorithm>

#include "support/counting_memory.hpp"
#include "support/delaunay.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::refinable_mesh;

namespace {

triangle_list cut(const test::filled_shape& s)
{
    workspace space;
    triangle_list out;
    REQUIRE_FALSE(monotone{}(s.filled, space, out));
    return out;
}

std::vector<triangle> triangles_of(const refinable_mesh& mesh)
{
    std::vector<triangle> all;
    for (std::uint32_t h = 0; h < mesh.end(); h += 4)
        all.push_back({mesh.origin(h), mesh.origin(h + 1), mesh.origin(h + 2)});
    return all;
}

/// The first law of half-edges that the mesh breaks; "" if it breaks none.
std::string broken_links(const refinable_mesh& mesh)
{
    for (std::uint32_t h = 0; h < mesh.end(); ++h) {
        if (h % 4 == 3) continue;
        const std::uint32_t g = mesh.twin(h);
        if (g == refinable_mesh::none) {
            if (mesh.at(mesh.origin(h)).boundary != h) return "a boundary edge is not known by its first point";
        } else if (mesh.twin(g) != h || mesh.origin(g) != mesh.target(h) || mesh.target(g) != mesh.origin(h)) {
            return "twins do not match";
        } else if (prefers_other_diagonal(mesh.start(h), mesh.start(g), mesh.place(mesh.apex(h)),
                                          mesh.place(mesh.apex(g)))) {
            return "an edge is not Delaunay";
        }
        if (orientation(mesh.start(h), mesh.place(mesh.target(h)), mesh.place(mesh.apex(h))) <= 0)
            return "a triangle is not counter-clockwise";
    }
    return {};
}

}  // namespace

TEST_CASE("a refinable mesh begins with the Delaunay triangles, whatever triangles it was given", "[refine]")
{
    refinable_mesh mesh;
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s))) continue;
        INFO(s.name);
        const test::filled_shape shape{s};
        const triangle_list given = cut(shape);
        REQUIRE(mesh.open(shape.filled, given.view()));
        CHECK(broken_links(mesh) == "");
        workspace space;
        triangle_list wanted;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, wanted));
        CHECK(test::oracle::as_set(triangles_of(mesh)) == test::oracle::as_set(wanted.view()));
    }
}

TEST_CASE("points that are added at random keep a refinable mesh Delaunay and its links right", "[refine]")
{
    refinable_mesh mesh;
    test::dice d{32};
    std::size_t added = 0, split = 0;
    for (int round = 0; round < 60; ++round) {
        const test::shape s{"random polygon", {test::random_polygon(12 + round, 40, d)}};
        test::shape large = s;
        for (grid_point& p : large.loops[0]) p = {1000 * p.x, 1000 * p.y};
        if (!inspect::is_region(test::loops_of(large))) continue;
        INFO(large);
        const test::filled_shape shape{large};
        REQUIRE(mesh.open(shape.filled, cut(shape).view()));
        std::int64_t area = 0;
        for (const triangle t : triangles_of(mesh))
            area += orientation(mesh.place(t.a), mesh.place(t.b), mesh.place(t.c));
        for (int k = 0; k < 40; ++k) {
            const auto t = static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(mesh.triangle_count())));
            const std::uint32_t h = 4 * t + static_cast<std::uint32_t>(d.roll(3));
            const grid_point a = mesh.start(h), b = mesh.place(mesh.target(h)), c = mesh.place(mesh.apex(h));
            if (mesh.is_boundary(h)) {
                const grid_point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
                if (orientation(a, b, middle) < 0 || orientation(a, middle, c) <= 0 || orientation(middle, b, c) <= 0)
                    continue;
                area -= orientation(a, b, middle);
                const std::uint32_t from = mesh.origin(h), to = mesh.target(h), v = mesh.split(from, middle, 0.5f);
                REQUIRE(v != refinable_mesh::none);
                CHECK(mesh.next_on_boundary(from) == v);
                CHECK(mesh.next_on_boundary(v) == to);
                CHECK(mesh.at(from).edge.t1 == 0.5f);
                CHECK(mesh.at(v).edge.t0 == 0.5f);
                CHECK(mesh.at(v).source == mesh.at(from).source);
                ++split;
            } else {
                const grid_point inside{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
                if (orientation(a, b, inside) <= 0 || orientation(b, c, inside) <= 0 || orientation(c, a, inside) <= 0)
                    continue;
                const std::uint32_t v = mesh.insert(t, inside);
                REQUIRE(v != refinable_mesh::none);
                CHECK(mesh.at(v).boundary == refinable_mesh::none);
                std::size_t around = 0;  // and every triangle with the point is among the changed ones
                const auto changed = mesh.changed();
                for (std::uint32_t g = 0; g < mesh.end(); g += 4) {
                    if (mesh.origin(g) != v && mesh.origin(g + 1) != v && mesh.origin(g + 2) != v) continue;
                    CHECK(std::count(changed.begin(), changed.end(), g / 4) > 0);
                    ++around;
                }
                CHECK(around >= 3);
                ++added;
            }
        }
        CHECK(broken_links(mesh) == "");
        std::int64_t now = 0;
        for (const triangle t : triangles_of(mesh))
            now += orientation(mesh.place(t.a), mesh.place(t.b), mesh.place(t.c));
        CHECK(now == area);
    }
    CHECK(added > 500);
    CHECK(split > 200);
}

TEST_CASE("a point that bulges beyond the circle around its edge's triangle leaves a Delaunay mesh", "[refine]")
{
    //    c - - - b      The circle through a, b, c passes between the edge a b and p, so a b becomes an inner edge.
    //     '     / '
    //      '   /   p
    //       ' /  '
    //        a
    const test::filled_shape shape{test::shape{"triangle", {{{0, 0}, {100'000, 0}, {50'000, 140'000}}}}};
    refinable_mesh mesh;
    REQUIRE(mesh.open(shape.filled, cut(shape).view()));
    const grid_point p{50'000, -30'000};
    REQUIRE(in_circle({0, 0}, {100'000, 0}, {50'000, 140'000}, p) < 0);
    REQUIRE(mesh.split(0, p, 0.5f) == 3);
    CHECK(broken_links(mesh) == "");
    CHECK(mesh.triangle_count() == 2);
    const auto changed = mesh.changed();
    for (const std::uint32_t t : {0u, 1u}) CHECK(std::count(changed.begin(), changed.end(), t) > 0);
}

TEST_CASE("a refinable mesh without memory says so", "[refine]")
{
    const test::filled_shape shape{test::square_with_holes(2, 8)};
    const triangle_list given = cut(shape);
    bool opened = false;
    for (std::size_t nth = 1; !opened && nth < 20; ++nth) {
        test::counting_memory memory{.fail_at = nth};
        refinable_mesh mesh{memory.source()};
        opened = mesh.open(shape.filled, given.view());
        CHECK(opened == (memory.requests < nth));
    }
    CHECK(opened);
}

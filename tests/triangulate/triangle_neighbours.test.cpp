// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/impl/triangle_neighbours.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <map>
#include <utility>
#include <vector>

using namespace typemesh;
using detail::triangle_neighbours;

namespace {

/// Triangles with all their neighbours, found by a search through every edge.
struct known {
    contours loops;
    region shape;
    std::vector<triangle> triangles;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> half_edges;  // by its two points

    explicit known(const test::shape& s) : loops{test::contours_of(s)}
    {
        workspace space;
        const auto filled = fill(loops, fill_rule::non_zero, space);
        REQUIRE(filled);
        shape = *filled;
        triangle_list out;
        REQUIRE_FALSE(monotone{}(shape, space, out));
        triangles.assign(out.begin(), out.end());
        for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h)
            half_edges[{point_of(h), point_of(triangle_neighbours::next(h))}] = h;
    }
    [[nodiscard]] std::uint32_t point_of(std::uint32_t h) const
    {
        const triangle& t = triangles[h / 3];
        return h % 3 == 0 ? t.a : h % 3 == 1 ? t.b : t.c;
    }
    [[nodiscard]] std::uint32_t across(std::uint32_t h) const
    {
        const auto found = half_edges.find({point_of(triangle_neighbours::next(h)), point_of(h)});
        return found == half_edges.end() ? triangle_neighbours::none : found->second;
    }
};

void check_all(const known& k, triangle_neighbours& n)
{
    for (std::uint32_t h = 0; h < 3 * k.triangles.size(); ++h) {
        REQUIRE(n.origin(h) == k.point_of(h));
        REQUIRE(n.across(h) == k.across(h));
    }
}

}  // namespace

TEST_CASE("neighbours share an edge, with a table and without", "[triangulate][triangle_neighbours]")
{
    std::vector<test::shape> shapes = test::generated_regions();
    test::dice d{71};
    for (int i = 0; i < 200; ++i) shapes.push_back({"random polygon", {test::random_polygon(4 + d.roll(30), 12, d)}});
    for (const test::shape& s : shapes) {
        const known k{s};
        if (k.triangles.size() > 3000) continue;
        INFO(s);
        triangle_neighbours looking{k.shape.points().size(), k.shape.starts(), k.triangles};
        check_all(k, looking);
        CHECK_FALSE(looking.knows_all());

        workspace space, building;
        workspace::scope scratch{space};
        triangle_neighbours n{k.shape.points().size(), k.shape.starts(), k.triangles};
        for (int round = 0; round < 50; ++round) {  // after enough questions it makes the table
            check_all(k, n);
            REQUIRE(n.prepare(scratch, building));
        }
        CHECK(n.knows_all() == (k.half_edges.size() > k.shape.points().size()));  // not for the region's own edges
        check_all(k, n);
    }
}

TEST_CASE("join() updates the table after an exchange", "[triangulate][triangle_neighbours]")
{
    std::vector<triangle> square{{0, 1, 2}, {0, 2, 3}};
    const std::uint32_t starts[] = {0, 4};
    workspace space, building;
    workspace::scope scratch{space};
    triangle_neighbours n{4, starts, square};
    while (!n.knows_all()) {
        (void)n.across(2);
        REQUIRE(n.prepare(scratch, building));
    }
    REQUIRE(n.across(2) == 3);
    square = {{1, 2, 3}, {3, 0, 1}};  // the other diagonal
    n.join(2, 5);
    n.join(0, triangle_neighbours::none);
    n.join(3, triangle_neighbours::none);
    CHECK(n.across(2) == 5);
    CHECK(n.across(5) == 2);
    CHECK(n.across(0) == triangle_neighbours::none);
    CHECK(n.across(3) == triangle_neighbours::none);
}

TEST_CASE("neighbours without memory for a table report it and keep looking", "[triangulate][triangle_neighbours]")
{
    const known k{{"star", {test::star(60, 100'000, 4)}}};
    test::counting_memory failing{.fail_at = 1};
    workspace space{failing.source()}, building;
    workspace::scope scratch{space};
    triangle_neighbours n{k.shape.points().size(), k.shape.starts(), k.triangles};
    bool reported = false;
    for (int round = 0; round < 100 && !reported; ++round) {
        check_all(k, n);
        reported = !n.prepare(scratch, building);
    }
    CHECK(reported);
    CHECK_FALSE(n.knows_all());
    check_all(k, n);
}

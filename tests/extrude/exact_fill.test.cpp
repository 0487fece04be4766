// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/exact_fill.hpp>

#include "capped.hpp"
#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("the number of a set of edges depends on their points and directions, but not on their order", "[exact_fill]")
{
    contours a, b, c, d;
    const grid_point p[] = {{0, 0}, {10, 0}, {10, 10}, {100, 0}, {110, 0}, {110, 10}};
    const auto fill_in = [&p](contours& to, std::initializer_list<int> order) {
        for (const int i : order) REQUIRE(to.points.push_back(p[i]));
        for (const std::uint32_t start : {0u, 3u, 6u}) REQUIRE(to.starts.push_back(start));
    };
    fill_in(a, {0, 1, 2, 3, 4, 5});
    fill_in(b, {4, 5, 3, 1, 2, 0});
    fill_in(c, {2, 1, 0, 3, 4, 5});
    fill_in(d, {0, 1, 5, 3, 4, 2});
    CHECK(edges_of(a) == edges_of(b));
    CHECK(edges_of(a) != edges_of(c));
    CHECK(edges_of(a) != edges_of(d));
}

namespace {

contours loop_of(std::initializer_list<grid_point> points)
{
    contours loops;
    loops.grid.units_per_em = 1000.0;
    for (const grid_point p : points) {
        REQUIRE(loops.points.push_back(p));
        REQUIRE(loops.edges.push_back({7, 0.25f, 0.5f}));
    }
    for (const std::size_t start : {std::size_t{0}, points.size()})
        REQUIRE(loops.starts.push_back(static_cast<std::uint32_t>(start)));
    return loops;
}

}  // namespace

TEST_CASE("loops that bound a region are filled unchanged, and all others are refused", "[exact_fill]")
{
    meshes::caps_by<> caps{shapes::rectangle().made()};
    auto maker = caps.maker();
    triangle_list triangles;
    REQUIRE(triangles.push_back({1, 2, 3}));

    contours square = loop_of({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}});
    const auto filled = fill_exactly(square, maker, triangles);
    REQUIRE(filled);
    CHECK(filled->points().size() == 4);
    CHECK(filled->points().data() == square.points.data());  // the loops are the caller's again
    CHECK(filled->edges()[0].curve == 7);
    CHECK(triangles.size() == 3);

    contours crossing = loop_of({{0, 0}, {1000, 1000}, {1000, 0}, {0, 900}});
    CHECK(fill_exactly(crossing, maker, triangles).error() == error::crossing_contours);
    CHECK(triangles.size() == 3);
    contours far = loop_of({{0, 0}, {1 << 29, 0}, {0, 1000}});
    CHECK(fill_exactly(far, maker, triangles).error() == error::outline_beyond_grid);

    contours nothing;
    const auto empty = fill_exactly(nothing, maker, triangles);
    REQUIRE(empty);
    CHECK(empty->points().empty());
    CHECK(triangles.size() == 3);
}

// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/cell_diagonals.hpp>

#include <typemesh/core/orientation.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>

using namespace typemesh;

namespace {

/// A sweep of nodes and cells, each a list of triangles.
struct cells_of_a_sweep {
    swept_region swept;

    cells_of_a_sweep(std::initializer_list<grid_point> nodes)
    {
        for (const grid_point p : nodes) REQUIRE(swept.nodes.push_back({p, 0.0f}));
    }
    void add(std::uint32_t band, std::initializer_list<triangle> all)
    {
        const auto first = static_cast<std::uint32_t>(swept.triangles.size());
        REQUIRE(swept.cells.push_back({0, band, first}));
        for (const triangle t : all) REQUIRE(swept.triangles.push_back(t));
    }
    void end() { REQUIRE(swept.cells.push_back({0, 0, static_cast<std::uint32_t>(swept.triangles.size())})); }

    [[nodiscard]] grid_point at(std::uint32_t node) const { return swept.nodes[node].at; }
    [[nodiscard]] std::int64_t doubled_area() const
    {
        std::int64_t sum = 0;
        for (const triangle t : swept.triangles) {
            CHECK(orientation(at(t.a), at(t.b), at(t.c)) > 0);
            sum += orientation(at(t.a), at(t.b), at(t.c));
        }
        return sum;
    }
    /// The third corner of the triangle with a side from a to b.
    [[nodiscard]] std::uint32_t beyond(std::uint32_t a, std::uint32_t b) const
    {
        for (const triangle t : swept.triangles) {
            if (t.a == a && t.b == b) return t.c;
            if (t.b == a && t.c == b) return t.a;
            if (t.c == a && t.a == b) return t.b;
        }
        return ~0u;
    }
};

/// The picture of the class: the rim's edge 2 3 belongs to a thin triangle with the corner 4.
cells_of_a_sweep thin_slope()
{
    cells_of_a_sweep s{{0, 0}, {60, 0}, {50, 100}, {0, 100}, {180, 98}};
    s.add(0, {{3, 4, 2}, {0, 4, 3}, {0, 1, 4}});
    s.end();
    return s;
}

}  // namespace

TEST_CASE("an edge at the last level gets the corner of its cell that sees it best", "[extrude][refine]")
{
    cells_of_a_sweep s = thin_slope();
    const std::int64_t area = s.doubled_area();
    REQUIRE(s.beyond(2, 3) == 4);
    detail::cell_diagonals diagonals;
    REQUIRE(diagonals.improve(s.swept, 0));
    CHECK(s.beyond(2, 3) == 0);
    CHECK(s.doubled_area() == area);
    CHECK(s.swept.triangles.size() == 3);
    CHECK(s.beyond(0, 1) != ~0u);
    CHECK(s.beyond(1, 4) != ~0u);
    CHECK(s.beyond(4, 2) != ~0u);
    CHECK(s.beyond(3, 0) != ~0u);
}

TEST_CASE("edges between cells, other bands, and edges of three sides stay", "[extrude][refine]")
{
    detail::cell_diagonals diagonals;
    cells_of_a_sweep other_band = thin_slope();
    REQUIRE(diagonals.improve(other_band.swept, 1));
    CHECK(other_band.beyond(2, 3) == 4);

    cells_of_a_sweep apart{{0, 0}, {60, 0}, {50, 100}, {0, 100}, {180, 98}};
    apart.add(2, {{3, 4, 2}});
    apart.add(2, {{0, 4, 3}, {0, 1, 4}});
    apart.end();
    REQUIRE(diagonals.improve(apart.swept, 2));
    CHECK(apart.beyond(2, 3) == 4);

    // Nodes where a cell touches itself: the diagonal has four sides.
    cells_of_a_sweep pinched{{0, 0}, {60, 0}, {50, 100}, {0, 100}, {180, 98}};
    pinched.add(0, {{3, 4, 2}, {0, 4, 3}, {3, 4, 2}, {0, 4, 3}});
    pinched.end();
    REQUIRE(diagonals.improve(pinched.swept, 0));
    CHECK(pinched.beyond(2, 3) == 4);
}

TEST_CASE("improving a sweep's cells a second time changes nothing and allocates nothing", "[extrude][refine]")
{
    test::counting_memory counted;
    detail::cell_diagonals diagonals{counted.source()};
    cells_of_a_sweep s = thin_slope();
    REQUIRE(diagonals.improve(s.swept, 0));
    const auto before = counted.requests;
    const std::uint32_t corner = s.beyond(2, 3);
    REQUIRE(diagonals.improve(s.swept, 0));
    CHECK(s.beyond(2, 3) == corner);
    cells_of_a_sweep again = thin_slope();
    REQUIRE(diagonals.improve(again.swept, 0));
    CHECK(counted.requests == before);
}

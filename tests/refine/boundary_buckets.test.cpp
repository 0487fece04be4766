// SPDX-License-Identifier: MIT

#include <typemesh/inspect/simplicity.hpp>
#include <typemesh/refine/impl/boundary_buckets.hpp>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

#include <algorithm>

using namespace typemesh;
using detail::boundary_buckets;
using detail::refinable_mesh;

TEST_CASE("a point beyond an edge is free exactly if the boundary stays simple with it", "[refine]")
{
    refinable_mesh mesh;
    boundary_buckets near;
    test::dice d{77};
    std::size_t free = 0, blocked = 0;
    for (int round = 0; round < 400; ++round) {
        const int width = 6 + d.roll(20);
        test::shape s{"random polygon", {test::random_polygon(5 + d.roll(20), width, d)}};
        if (!inspect::is_region(test::loops_of(s))) continue;
        // A triangle at a great distance puts all of the polygon into one bucket, which is divided.
        const std::int32_t reach = 1 << (8 + d.roll(20));
        if (round % 2 != 0) s.loops.push_back({{reach - 1, reach}, {reach, reach - 1}, {reach, reach}});
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(shape.filled, space, given));
        REQUIRE(mesh.open(shape.filled, given.view()));
        near.clear();
        CHECK(near.is_stale(mesh));
        REQUIRE(near.open(mesh));
        CHECK_FALSE(near.is_stale(mesh));
        const std::size_t n = shape.filled.starts()[1];
        for (int k = 0; k < 20; ++k) {
            const auto from = static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(n)));
            const grid_point p{d.roll(width + 6) - 3, d.roll(width + 6) - 3},
                a = mesh.place(from), b = mesh.place(mesh.next_on_boundary(from));
            if (orientation(a, b, p) >= 0) continue;
            std::vector<grid_point> loop(shape.filled.points().begin(), shape.filled.points().begin() + n);
            REQUIRE(loop.size() == s.loops[0].size());
            loop.insert(loop.begin() + from + 1, p);
            // Simple with the point, and nothing inside the triangle: the area grows by just the triangle.
            const bool simple = !inspect::is_crossing({loop});
            INFO(s << "point " << p.x << ' ' << p.y << " beyond " << from);
            const bool is_free = near.is_free(mesh, from, p);
            bool empty = true;
            for (const grid_point q : shape.filled.points())
                if (!(q == a) && !(q == b))
                    empty =
                        empty && !(orientation(a, p, q) >= 0 && orientation(p, b, q) >= 0 && orientation(b, a, q) >= 0);
            CHECK(is_free == (simple && empty));
            ++(is_free ? free : blocked);
        }
    }
    CHECK(free > 500);
    CHECK(blocked > 500);
}

TEST_CASE("buckets list few edges where points cluster", "[refine]")
{
    // The lowest side of a hole is halved down to edges of 16 cells, in a square 2^26 cells wide.
    constexpr std::int32_t width = 1 << 26, size = 1 << 14, x = width / 3, y = width / 3;
    const test::filled_shape shape{{"hole",
                                    {{{0, 0}, {width, 0}, {width, width}, {0, width}},
                                     {{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}}}}};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    refinable_mesh mesh;
    REQUIRE(mesh.open(shape.filled, given.view()));
    boundary_buckets near;
    std::size_t visited = 0, most = 0, queries = 0;
    for (std::int32_t edge = size; edge >= 16; edge /= 2) {
        const std::uint32_t count = mesh.vertex_count();
        for (std::uint32_t a = 0; a < count; ++a) {
            const grid_point from = mesh.place(a), to = mesh.place(mesh.next_on_boundary(a));
            if (from.y != y || to.y != y) continue;
            REQUIRE(from.x - to.x == edge);
            if (near.is_stale(mesh)) REQUIRE(near.open(mesh));
            const grid_point middle{from.x - edge / 2, y};
            std::size_t here = 0;
            CHECK(near.each_near({from, {middle.x, y + 4}, to}, [&](std::uint32_t) { return ++here != 0; }));
            visited += here;
            most = (std::max)(most, here);
            ++queries;
            CHECK(near.is_free(mesh, a, {middle.x, y + 4}));
            CHECK_FALSE(near.is_free(mesh, a, {middle.x, y + size}));
            if (edge == 16) continue;
            const std::uint32_t v = mesh.split(a, middle, 0.0f);
            if (!near.is_stale(mesh)) REQUIRE((near.add(mesh, a) && near.add(mesh, v)));
        }
    }
    CHECK(queries == 2047);
    CHECK(visited < 40 * queries);
    CHECK(most < 200);
}

TEST_CASE("buckets without memory say so", "[refine]")
{
    test::shape s = test::square_with_holes(3, 12);
    s.loops.push_back({{1 << 27, 1 << 27}, {(1 << 27) + 1, 1 << 27}, {1 << 27, (1 << 27) + 1}});
    const test::filled_shape shape{s};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    refinable_mesh mesh;
    REQUIRE(mesh.open(shape.filled, given.view()));
    bool opened = false;
    for (std::size_t nth = 1; !opened && nth < 20; ++nth) {
        test::counting_memory memory{.fail_at = nth};
        boundary_buckets near{memory.source()};
        opened = near.open(mesh);
        CHECK(opened == (memory.requests < nth));
    }
    CHECK(opened);
}

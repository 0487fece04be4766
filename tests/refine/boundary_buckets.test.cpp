// SPDX-License-Identifier: MIT

#include <typemesh/inspect/simplicity.hpp>
#include <typemesh/refine/impl/boundary_buckets.hpp>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

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
        const test::shape s{"random polygon", {test::random_polygon(5 + d.roll(20), width, d)}};
        if (!inspect::is_region(test::loops_of(s))) continue;
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(shape.filled, space, given));
        REQUIRE(mesh.open(shape.filled, given.view()));
        near.clear();
        CHECK(near.is_stale(mesh));
        REQUIRE(near.open(mesh));
        CHECK_FALSE(near.is_stale(mesh));
        const std::size_t n = shape.filled.points().size();
        for (int k = 0; k < 20; ++k) {
            const auto from = static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(n)));
            const grid_point p{d.roll(width + 6) - 3, d.roll(width + 6) - 3},
                a = mesh.place(from), b = mesh.place(mesh.next_on_boundary(from));
            if (orientation(a, b, p) >= 0) continue;
            std::vector<grid_point> loop(shape.filled.points().begin(), shape.filled.points().end());
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

TEST_CASE("buckets without memory say so", "[refine]")
{
    const test::filled_shape shape{test::square_with_holes(3, 12)};
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

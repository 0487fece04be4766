// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/radical_weights.hpp>

#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::radical_weights;
using detail::refinable_mesh;

namespace {

struct weighed_mesh {
    test::filled_shape shape;
    refinable_mesh mesh;
    radical_weights weights;

    explicit weighed_mesh(const test::shape& s) : shape{s}
    {
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        REQUIRE(mesh.open(shape.filled, given.view()));
        REQUIRE(weights.open(mesh));
    }
};

}  // namespace

TEST_CASE("with equal weights, the radical centre is the circle's, and feet are the edges' middles", "[refine]")
{
    weighed_mesh w{test::shape{"triangle", {{{0, 0}, {9000, 1000}, {3000, 7000}}}}};
    const point o = w.weights.centre_of(w.mesh, 0);
    const grid_point from = w.mesh.start(0);
    for (std::uint32_t h = 0; h < 3; ++h) {
        const double x = o.x + from.x - w.mesh.start(h).x, y = o.y + from.y - w.mesh.start(h).y;
        CHECK(std::hypot(x, y) == Catch::Approx(std::hypot(o.x, o.y)));
        CHECK(w.weights.foot_share(h, (h + 1) % 3, 1e6) == 0.5);
    }
}

TEST_CASE("settled weights put each radical centre inside, over the feet of all its edges", "[refine]")
{
    // An obtuse triangle alone, and a kite of two.
    for (const test::shape& s : {test::shape{"obtuse", {{{0, 0}, {90'000, 0}, {30'000, 20'000}}}},
                                 test::shape{"kite", {{{0, 0}, {60'000, -8000}, {90'000, 0}, {30'000, 20'000}}}}}) {
        INFO(s.name);
        weighed_mesh w{s};
        bool all_centred = true;
        for (std::uint32_t t = 0; t < w.mesh.triangle_count(); ++t)
            all_centred = all_centred && w.weights.is_centred(t);
        CHECK_FALSE(all_centred);
        constexpr double margin = 0.5;
        REQUIRE(w.weights.settle(1000, margin));
        for (std::uint32_t t = 0; t < w.mesh.triangle_count(); ++t) {
            CHECK(w.weights.is_centred(t));
            const point off = w.weights.centre_of(w.mesh, t);
            const point o{off.x + w.mesh.start(4 * t).x, off.y + w.mesh.start(4 * t).y};
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h) {
                const grid_point p = w.mesh.start(h), q = w.mesh.place(w.mesh.target(h));
                const double ex = double(q.x) - p.x, ey = double(q.y) - p.y, square = ex * ex + ey * ey;
                CHECK(ex * (o.y - p.y) - ey * (o.x - p.x) > 0.0);
                const double share = w.weights.foot_share(w.mesh.origin(h), w.mesh.target(h), square);
                CHECK(share > 0.0799 * margin);
                CHECK(share < 1.0 - 0.0799 * margin);
                CHECK(share * square == Catch::Approx(ex * (o.x - p.x) + ey * (o.y - p.y)).epsilon(1e-9));
            }
        }
    }
}

TEST_CASE("points keep their weights when the mesh is read again", "[refine]")
{
    weighed_mesh w{test::shape{"obtuse", {{{0, 0}, {90'000, 0}, {30'000, 20'000}}}}};
    REQUIRE(w.weights.settle(1000, 1.0));
    const point before = w.weights.centre_of(w.mesh, 0);
    REQUIRE(w.weights.open(w.mesh));
    CHECK(w.weights.settle(1, 1.0));
    CHECK(w.weights.centre_of(w.mesh, 0) == before);
}

// SPDX-License-Identifier: MIT

#include <typemesh/inflate/impl/rim_rings.hpp>

#include "inflated_shape.hpp"

using namespace typemesh;
using inflating::at;

TEST_CASE("no edge crosses a mesh from boundary to boundary once they are divided", "[inflate]")
{
    for (const auto& [name, loops] : inflating::inflatable_shapes()) {
        CAPTURE(name);
        const test::filled_shape shape{{"", loops}, fill_rule::non_zero, {512.0, 1000.0}};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        detail::refinable_mesh mesh;
        REQUIRE(mesh.open(shape.filled, given.view()));
        REQUIRE(detail::rim_rings::divide_crossings(mesh));
        std::size_t crossing = 0;
        for (std::uint32_t h = 0; h < mesh.end(); h = h % 4 == 2 ? h + 2 : h + 1)
            crossing += !mesh.is_boundary(h) && mesh.at(mesh.origin(h)).boundary != detail::refinable_mesh::none &&
                        mesh.at(mesh.target(h)).boundary != detail::refinable_mesh::none;
        CHECK(crossing == 0);
    }
}

TEST_CASE("rings lie at steps of 22.5 degrees, on thick strokes of 11.25, all around a square", "[inflate]")
{
    test::polyline loop;
    for (int i = 0; i < 20; ++i) loop.push_back(at(0.025 * i, 0));
    for (int i = 0; i < 20; ++i) loop.push_back(at(0.5, 0.025 * i));
    for (int i = 0; i < 20; ++i) loop.push_back(at(0.5 - 0.025 * i, 0.5));
    for (int i = 0; i < 20; ++i) loop.push_back(at(0, 0.5 - 0.025 * i));
    const test::filled_shape shape{{"", {loop}}, fill_rule::non_zero, {512.0, 1000.0}};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
    // Half a width of 0.06 em leaves 0.0012 em below the section at steps of 22.5 degrees: a 24th of 0.03 em is more.
    for (const auto& [half, degrees] : {std::pair{0.06, 22.5}, {0.07, 11.25}}) {
        CAPTURE(half, degrees);
        detail::refinable_mesh mesh;
        REQUIRE(mesh.open(shape.filled, given.view()));
        const std::vector<double> slopes(mesh.vertex_count(), half * inflating::em);
        REQUIRE(detail::rim_rings::add_rings(mesh, slopes.data(), 0.03 * inflating::em));
        const double distance = half * inflating::em * (1.0 - std::cos(degrees / 57.29577951308232));
        std::size_t on_ring = 0, lower = 0;
        for (std::uint32_t v = 80; v < mesh.vertex_count(); ++v) {
            const grid_point p = mesh.place(v);
            const double side = 0.5 * inflating::em,
                         inside = (std::min)({double(p.x), double(p.y), side - p.x, side - p.y});
            on_ring += std::abs(inside - distance) <= 1.0;
            lower += inside < distance - 1.0;
        }
        CHECK(on_ring >= 76);  // not at the corners, where the rings of the sides meet
        CHECK(lower == 0);
        CHECK(mesh.vertex_count() >= 80 + 2 * 70);
    }
}

TEST_CASE("long inner edges of a mesh are divided until none is left, with at most so many points", "[inflate]")
{
    // A wide shape and one with a sharp corner, their sides in 20 steps each.
    for (const auto& corners :
         {test::polyline{at(0, 0), at(0.5, 0), at(0.5, 0.5), at(0, 0.5)}, {at(0, 0), at(0.5, 0), at(0.5, 0.15)}}) {
        test::polyline loop;
        for (std::size_t k = 0; k < corners.size(); ++k)
            for (int i = 0; i < 20; ++i) {
                const grid_point a = corners[k], b = corners[(k + 1) % corners.size()];
                loop.push_back({a.x + (b.x - a.x) / 20 * i, a.y + (b.y - a.y) / 20 * i});
            }
        const test::filled_shape shape{{"", {loop}}, fill_rule::non_zero, {512.0, 1000.0}};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        const auto divided = [&](double longest, std::uint32_t max_points) {
            detail::refinable_mesh mesh;
            REQUIRE(mesh.open(shape.filled, given.view()));
            REQUIRE(detail::rim_rings::divide_long(mesh, longest * inflating::em, max_points));
            double square = 0.0;  // of the longest inner edge
            for (std::uint32_t h = 0; h < mesh.end(); h = h % 4 == 2 ? h + 2 : h + 1)
                if (!mesh.is_boundary(h))
                    square = (std::max)(square, double(squared_distance(mesh.start(h), mesh.place(mesh.target(h)))));
            return std::pair{mesh.vertex_count(), std::sqrt(square) / inflating::em};
        };
        for (const double longest : {0.1, 0.03}) {
            CAPTURE(corners.size(), longest);
            const auto [points, reached] = divided(longest, 100'000);
            CHECK(reached <= longest);
            CHECK(points < double(loop.size()) + 0.25 / (0.35 * longest * longest));
            CHECK(divided(longest, points).first == points);
            CHECK(divided(longest, 90).first == (std::min)(points, 91u));
        }
    }
}

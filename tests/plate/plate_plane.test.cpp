// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/plate/plate_plane.hpp>
#include <typemesh/plate/silhouette.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

using namespace typemesh;

TEST_CASE("letters stand on the plane where the text's own mesh has them, also letters that a path turns",
          "[plate_plane]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    plane_path circle;
    circle.circle({0.5, -0.5}, 1.0);
    text_mesher turning{font, flat{}, on_path{&circle, {.anchor = path_anchor::middle}}};
    for (const float size : {1.0f, 25.4f})
        for (const frame& f : {right_handed_y_up, right_handed_z_up}) {
            auto turned = test::required(turning.plan("oi", {.size = size, .frame = f}));
            const auto onto = plate_plane::of(*turned, 0.5);
            REQUIRE(onto);
            silhouette discs;
            discs.begin(*onto);
            REQUIRE(discs.add(*turned, *onto));
            std::vector<vec3> corners;
            std::vector<std::uint32_t> triangles;
            REQUIRE(turned->write(into(
                corners, triangles, [](const surface_point<attribute::position>& p) noexcept { return p.position; })));
            REQUIRE(discs.points().size() == corners.size());
            double farthest = 0.0;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const vec3 at = onto->at.position(discs.points()[i], 0.0f), own = corners[i];
                for (const float d : {at.x - own.x, at.y - own.y, at.z - own.z})
                    farthest =
                        std::fabs(static_cast<double>(d)) > farthest ? std::fabs(static_cast<double>(d)) : farthest;
            }
            CHECK(farthest < 2e-6 * static_cast<double>(size));
            auto text = test::required(mesher.plan("oi", {.size = size, .frame = f}));
            const auto plane = plate_plane::of(*text, 0.5);
            REQUIRE(plane);
            CHECK(plane->unit_per_em == Catch::Approx(size));
            CHECK(plane->cells.cells * plane->at.unit_per_cell == Catch::Approx(size));
            silhouette letters;
            letters.begin(*plane);
            REQUIRE(letters.add(*text, *plane));
            std::set<std::tuple<float, float, float>> own;
            std::vector<vec3> vertices;
            std::vector<std::uint32_t> indices;
            constexpr auto position = [](const surface_point<attribute::position>& p) noexcept { return p.position; };
            REQUIRE(text->write(into(vertices, indices, position)));
            for (const vec3 p : vertices) own.insert({p.x, p.y, p.z});
            REQUIRE(letters.points().size() == vertices.size());
            for (const grid_point p : letters.points()) {
                const vec3 at = plane->at.position(p, 0.0f);
                CHECK(own.count({at.x, at.y, at.z}) == 1);
            }
        }
}

TEST_CASE("the plane's grid becomes coarser until text and room fit, and a text without letters has none",
          "[plate_plane]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("o", {}));
    double before = 1e300;
    for (const double room : {0.0, 10.0, 1000.0, 1e5}) {
        const auto plane = plate_plane::of(*text, room);
        REQUIRE(plane);
        CHECK(plane->cells.cells * room <= grid::reach);
        CHECK(plane->cells.cells <= before);
        before = plane->cells.cells;
    }
    CHECK(plate_plane::of(*text, 1e12).error() == error::outline_beyond_grid);
    auto blank = test::required(mesher.plan("", {}));
    CHECK(plate_plane::of(*blank, 1.0).error() == error::bad_option);
}

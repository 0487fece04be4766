// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/morph_proof.hpp>

#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

namespace {

struct tried {
    keyed_outlines outlines;
    morph_points points;
    triangle_list triangles;
    morph_proof proof;
    morph_proof::finding found = morph_proof::finding::unproven;

    tried(glyph_id id, std::vector<axis_coordinate> at, std::vector<std::uint32_t> members)
    {
        test::toy_axis axis;
        REQUIRE_FALSE(outlines.record(axis, id, at));
        const grid g = *grid::fitting(1000.0, outlines.bounds());
        REQUIRE_FALSE(points.divide(outlines, 1.0, g));
        points.reverse();  // all toys are drawn clockwise
        const auto result = proof(points, members, {0, at.size() - 1, 0, area_path::parts}, triangles);
        REQUIRE(result);
        found = *result;
    }
};

}  // namespace

TEST_CASE("simple contours are proven, and their triangles are as many as Euler wants and positive throughout",
          "[morph]")
{
    const tried ring{'o', {-16384, 0, 16384}, {0, 1}};
    CHECK(ring.found == morph_proof::finding::proven);
    CHECK(ring.triangles.size() == ring.points.count());  // n + 2h - 2c, with one hole and one outer loop
    const moving_points moving{ring.points.places.view(), ring.points.count(), {}};
    for (const triangle& t : ring.triangles)
        for (std::size_t k = 0; k < 2; ++k) CHECK(moving.area(k, t).is_positive());
    CHECK_FALSE(ring.proof.crossed_anywhere());

    const tried tooth{'s', {-16384, 16384}, {0}};
    CHECK(tooth.found == morph_proof::finding::proven);
    CHECK(tooth.triangles.size() == 5);
}

TEST_CASE("contours that cross everywhere, or in a part of the stretch, are told apart", "[morph]")
{
    const tried bars{'x', {-16384, 16384}, {0, 1}};
    CHECK(bars.found == morph_proof::finding::crossing);
    CHECK(bars.triangles.empty());
    CHECK(bars.proof.crossed_anywhere());
    const tried one{'x', {-16384, 16384}, {1}};
    CHECK(one.found == morph_proof::finding::proven);

    const tried leaving{'w', {-16384, 16384}, {0, 1}};
    CHECK(leaving.found == morph_proof::finding::unproven);
    CHECK(leaving.proof.crossed_anywhere());
    CHECK(leaving.triangles.empty());
    const tried inside{'w', {-8000, 8000}, {0, 1}};
    CHECK(inside.found == morph_proof::finding::proven);
}

TEST_CASE("outer triangles are part of the proof: a hole that passes another contour is seen between places", "[morph]")
{
    // Two small boxes that pass through each other on the way; at the ends and at many places they are apart. Their own
    // triangles are positive everywhere.
    morph_points points;
    const auto add = [&](std::vector<grid_point> box) {
        for (const grid_point& p : box) REQUIRE(points.places.push_back(p));
    };
    const auto box = [](std::int32_t x, std::int32_t y) {
        return std::vector<grid_point>{{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y + 10}};
    };
    add(box(0, 0)), add(box(100, 300));
    add(box(0, 600)), add(box(-100 - 0, 310));
    for (std::uint32_t i = 0; i < 8; ++i) REQUIRE(points.edges.push_back({}));
    for (const std::uint32_t s : {0u, 4u, 8u}) REQUIRE(points.starts.push_back(s));
    morph_proof proof;
    triangle_list triangles;
    const std::vector<std::uint32_t> both = {0, 1};
    const auto found = proof(points, both, {0, 1, 0, area_path::parts}, triangles);
    REQUIRE(found);
    CHECK(*found != morph_proof::finding::proven);
    CHECK(triangles.empty());
}

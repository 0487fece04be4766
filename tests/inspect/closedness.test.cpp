// SPDX-License-Identifier: MIT

#include <typemesh/inspect/closedness.hpp>

#include "solids.hpp"

using namespace typemesh::inspect;

TEST_CASE("meshes of texts are closed, and each planted fault is found", "[inspect]")
{
    const test::full_mesh right = solids::of("oEx");
    const std::size_t triangles = right.indices.size() / 3;
    const closedness whole = check_closedness(solids::seen(right));
    CHECK(whole.is_closed());
    CHECK(whole.triangles == triangles);
    CHECK(whole.crowded_edges == 0);
    for (std::size_t t = 0; t < triangles; ++t) {
        const closedness missing = check_closedness(solids::seen(solids::without(right, t)));
        CHECK(missing.unmatched_edges == 3);
        CHECK_FALSE(missing.is_closed());
        const closedness turned = check_closedness(solids::seen(solids::turned(right, t)));
        CHECK(turned.unmatched_edges > 0);
        CHECK_FALSE(turned.is_closed());
    }

    test::full_mesh moved = right;  // a vertex away from where its neighbours are: a crack
    moved.vertices[0].position.x += 0.001f;
    CHECK(check_closedness(solids::seen(moved)).unmatched_edges > 0);
    test::full_mesh flat = right;
    flat.indices[1] = flat.indices[0];
    CHECK(check_closedness(solids::seen(flat)).zero_area == 1);
    test::full_mesh wild = right;
    wild.indices[5] = static_cast<std::uint32_t>(wild.vertices.size());
    CHECK(check_closedness(solids::seen(wild)).bad_corners == 1);
    CHECK_FALSE(check_closedness(solids::seen(wild)).is_closed());
    test::full_mesh twice = right;
    for (std::size_t k = 0; k < 3; ++k) twice.indices.push_back(right.indices[k]);
    CHECK(check_closedness(solids::seen(twice)).unmatched_edges == 3);
}

TEST_CASE("edges of more than two faces are counted, and slanted ones separately", "[inspect]")
{
    // Two boxes that share an upright edge; lying down, it is not along the depth any more.
    const auto box = [](double x, double y, std::vector<place>& at, std::vector<int>& indices) {
        const int first = static_cast<int>(at.size());
        for (int i = 0; i < 8; ++i) at.push_back({x + (i & 1), y + (i >> 1 & 1), double(i >> 2)});
        for (const int i : {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5})
            indices.push_back(first + i);
    };
    std::vector<place> at;
    std::vector<int> indices;
    box(0, 0, at, indices);
    CHECK(check_closedness(mesh_view{at, indices}).is_closed());
    box(1, 1, at, indices);
    const closedness upright = check_closedness(mesh_view{at, indices});
    CHECK(upright.is_closed());
    CHECK(upright.crowded_edges == 1);
    CHECK(upright.crowded_slanted == 0);
    const closedness lying = check_closedness(mesh_view{at, indices}, 0);
    CHECK(lying.crowded_edges == 1);
    CHECK(lying.crowded_slanted == 1);
}

TEST_CASE("an edge of three or more faces is crowded, in whichever directions they run", "[inspect]")
{
    const std::vector<place> at{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    const auto crowded = [&](std::vector<int> indices) {
        return check_closedness(mesh_view{at, indices}).crowded_edges;
    };
    CHECK(crowded({0, 1, 2, 1, 0, 3}) == 0);
    CHECK(crowded({0, 1, 2, 0, 1, 3}) == 0);  // two, although they do not fit together
    CHECK(crowded({0, 1, 2, 1, 0, 3, 1, 0, 4}) == 1);
    CHECK(crowded({1, 0, 2, 0, 1, 3, 0, 1, 4}) == 1);
    CHECK(crowded({0, 1, 2, 0, 1, 3, 0, 1, 4}) == 1);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/sewn.hpp"

#include "extruded_ring.hpp"

#include <array>
#include <map>
#include <utility>

using namespace text_to_mesh;

namespace {

/// Whether every directed edge is met by its reverse, and no edge by more than two triangles.
bool is_closed(const model& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> met;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
        for (std::size_t i = 0; i < 3; ++i) ++met[{mesh.indices[t + i], mesh.indices[t + (i + 1) % 3]}];
    for (const auto& [e, times] : met)
        if (times != 1 || met.count({e.second, e.first}) == 0) return false;
    return true;
}

/// The corners of all triangles, by their places.
std::vector<std::array<float, 3>> corners(const model& mesh)
{
    std::vector<std::array<float, 3>> at;
    for (const std::uint32_t i : mesh.indices) {
        const auto& [x, y, z] = mesh.vertices[i].position;
        at.push_back({x, y, z});
    }
    return at;
}

}  // namespace

TEST_CASE("a sewn mesh is closed by its indices, and looks the same", "[sewn]")
{
    const model ring = extruded_ring(12);
    CHECK_FALSE(is_closed(ring));
    const model one = sewn(ring);
    CHECK(is_closed(one));
    CHECK(one.vertices.size() == 4 * 12);
    CHECK(corners(one) == corners(ring));
    CHECK(one.parts.size() == 3);
    CHECK(sewn(one).vertices.size() == one.vertices.size());
}

TEST_CASE("solids that touch in an upright edge keep vertices of their own", "[sewn]")
{
    model two = extruded_ring(12);
    const model ring = two;
    const auto first = static_cast<std::uint32_t>(two.vertices.size());
    for (model_vertex v : ring.vertices) {  // turned by half, it meets the first at (1, 0)
        v.position[0] = 2.0F - v.position[0];
        v.position[1] = -v.position[1];
        if (v.position[0] < 1.0001F) v.position[0] = 1.0F, v.position[1] = 0.0F;
        two.vertices.push_back(v);
    }
    for (const std::uint32_t i : ring.indices) two.indices.push_back(first + i);
    two.parts.clear();
    const model sewn_two = sewn(two);
    CHECK(is_closed(sewn_two));
    CHECK(sewn_two.vertices.size() == 2 * 4 * 12);
}

TEST_CASE("a letter and the ring around it are sewn each by itself", "[sewn]")
{
    model two = extruded_ring(12);
    const model ring = two;
    const auto first = static_cast<std::uint32_t>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), ring.vertices.begin(), ring.vertices.end());
    for (const std::uint32_t i : ring.indices) two.indices.push_back(first + i);
    two.parts.push_back({"letter_side", ring.indices.size(), ring.indices.size(), 1});
    const model sewn_two = sewn(two);
    CHECK(is_closed(sewn_two));
    CHECK(sewn_two.vertices.size() == 2 * 4 * 12);
}

TEST_CASE("an empty mesh is sewn to an empty one", "[sewn]") { CHECK(sewn(model{}).vertices.empty()); }

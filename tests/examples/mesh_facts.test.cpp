// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/mesh_facts.hpp"

#include "extruded_ring.hpp"

using namespace text_to_mesh;

TEST_CASE("a model's volume does not depend on where it stands, and grows as its size to the third", "[mesh_facts]")
{
    const model ring = extruded_ring(64);
    const mesh_facts f = facts_of(ring);
    CHECK(f.volume > 0.0);
    model other = ring;
    for (model_vertex& v : other.vertices) {
        for (float& at : v.position) at *= 3.0f;
        v.position[1] += 40.0f;
    }
    const mesh_facts g = facts_of(other);
    CHECK(g.volume == Approx(27.0 * f.volume).epsilon(1e-4));
    for (int k = 0; k < 3; ++k) CHECK(g.high[k] - g.low[k] == Approx(3.0 * (f.high[k] - f.low[k])).epsilon(1e-5));
    CHECK(g.low[1] == Approx(3.0 * f.low[1] + 40.0));
}

TEST_CASE("instances count where they stand", "[mesh_facts]")
{
    const model ring = extruded_ring(64);
    const mesh_facts f = facts_of(ring);
    model two = ring;
    two.letters = {{"o", 0, ring.vertices.size(), 0, ring.parts.size()}};
    two.places = {{0, {5.0f, 0.0f, 1.0f}}, {0, {-5.0f, 0.0f, 1.0f}}};
    const mesh_facts g = facts_of(two);
    CHECK(g.volume == Approx(2.0 * f.volume));
    CHECK(g.low[0] == Approx(f.low[0] - 5.0));
    CHECK(g.high[0] == Approx(f.high[0] + 5.0));
    CHECK(g.low[2] == Approx(f.low[2] + 1.0));
}

TEST_CASE("a size is told in few digits, in millimetres where it is printed", "[mesh_facts]")
{
    mesh_facts f;
    f.high[0] = 35.79999;
    f.high[1] = 13.3;
    f.low[2] = -2.0;
    CHECK(size_in_words(f, true) == "35.8 x 13.3 x 2 mm");
    CHECK(size_in_words(f, false) == "35.8 x 13.3 x 2");
    CHECK(facts_of(model{}).volume == 0.0);
}

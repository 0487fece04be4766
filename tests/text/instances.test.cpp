// SPDX-License-Identifier: MIT

// Labels that share the meshes of their letters: a shape tells which mesh an instance needs, in any plan of a mesher.

#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/toy_runs.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/text/font_faces.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

/// The meshes of a plan, each with indices that count from its own first vertex.
std::vector<full_mesh> meshes_of(const auto& plan)
{
    full_mesh all;
    REQUIRE(plan.write_meshes(into(all.vertices, all.indices)));
    std::vector<full_mesh> meshes(plan.meshes().size());
    for (std::size_t k = 0; k < meshes.size(); ++k)
        for (const part p : plan.parts()) {
            const mesh_range r = plan.mesh_part(k, p);
            for (std::uint32_t i = 0; i < r.vertex_count; ++i)
                meshes[k].vertices.push_back(all.vertices[r.first_vertex + i]);
            for (std::uint32_t i = 0; i < r.index_count; ++i)
                meshes[k].indices.push_back(all.indices[r.first_index + i] - plan.meshes()[k].first_vertex);
        }
    return meshes;
}

/// The letters of all labels, each written once: the guide's pattern.
struct shared_letters {
    std::vector<glyph_shape> shapes;
    std::vector<full_mesh> meshes;

    [[nodiscard]] std::size_t number_of(const glyph_shape& shape) const
    {
        std::size_t k = 0;
        while (k < shapes.size() && !(shapes[k] == shape)) ++k;
        return k;
    }

    /// Adds the letters of a label that no label has had yet, and checks that each of its instances finds its own mesh.
    void show(auto& mesher, const glyph_run& label)
    {
        glyph_run unseen;
        std::vector<full_mesh> expected;
        std::vector<glyph_shape> instances;
        {
            const auto plan = test::required(mesher.plan(label));
            const auto own = meshes_of(*plan);
            for (std::size_t k = 0; k < own.size(); ++k)
                if (number_of(plan->shape_of(k)) == shapes.size()) REQUIRE(unseen.add(plan->shape_of(k)));
            plan->write_instances([&](const glyph_instance& i) {
                instances.push_back(plan->shape_of(i.mesh));
                expected.push_back(own[i.mesh]);
            });
        }
        const auto plan = test::required(mesher.plan(unseen));
        const auto added = meshes_of(*plan);
        for (std::size_t k = 0; k < added.size(); ++k) {
            CHECK(number_of(plan->shape_of(k)) == shapes.size());
            shapes.push_back(plan->shape_of(k));
            meshes.push_back(added[k]);
        }
        for (std::size_t i = 0; i < instances.size(); ++i) {
            const std::size_t k = number_of(instances[i]);
            REQUIRE(k < meshes.size());
            CHECK(test::same_bits(meshes[k], expected[i]));
        }
    }
};

}  // namespace

TEST_CASE("labels in two faces and several sizes share meshes, and each letter has its own", "[text][glyph_styles]")
{
    test::toy_font font, wide;
    transformed_outlines second{wide, affine{.xx = 1.5, .xy = 0.1}};
    font_faces faces{font, second};
    text_mesher mesher{faces};
    shared_letters all;
    all.show(mesher, test::styled_run({}, {{1, 0, {0, 0}}, {2, 1, {600, 0}}, {1, 2, {1200, 0}}}));
    CHECK(all.shapes.size() == 2);
    // The same numbers in the other face, which the first label did not have.
    all.show(mesher, test::styled_run({{.face = 1}}, {{2, 0, {0, 0}}, {1, 1, {900, 0}}}));
    CHECK(all.shapes.size() == 4);
    // Smaller, slanted, and in another style; a bar that is no letter; and what both labels had before.
    const affine small{.xx = 0.5, .yy = 0.5}, slanted{.xy = 0.2};
    all.show(mesher, test::styled_run({{.map = small},
                                       {.map = slanted},
                                       {.map = slanted, .style = style_id{1}},
                                       {.face = 1, .map = small},
                                       {.face = bar_face, .map = {.xx = 500, .yy = 40}},
                                       {},
                                       {.face = 1}},
                                      {{1, 0, {0, 0}, false, 0},
                                       {1, 1, {300, 0}, false, 1},
                                       {1, 2, {900, 0}, false, 2},
                                       {1, 3, {1500, 0}, false, 3},
                                       {0, no_cluster, {0, -90}, false, 4},
                                       {1, 4, {2000, 0}, false, 5},
                                       {1, 5, {2600, 0}, false, 6}}));
    CHECK(all.shapes.size() == 8);
    all.show(mesher, test::styled_run({{.face = 1, .map = small}}, {{1, 0, {0, 0}}}));
    CHECK(all.shapes.size() == 8);
}

TEST_CASE("meshes that belong to one text alone have no shape, and turned letters keep theirs", "[text]")
{
    test::toy_font font;
    {
        text_mesher mesher{font};
        const glyph_run run = test::styled_run({}, {{2, 0, {0, 0}}, {2, 1, {200, 0}}, {1, 2, {5000, 0}}});
        const auto plan = test::required(mesher.plan(run, {.merge = true}));
        REQUIRE(plan->meshes().size() == 2);
        CHECK(plan->shape_of(0) == glyph_shape{});
        CHECK(plan->shape_of(1) == glyph_shape{.id = 1});
        glyph_run other;
        CHECK(other.add(plan->shape_of(0)).error() == error::unknown_glyph);
    }
    {
        text_mesher mesher{font, bent<on_cylinder>{.how = {.radius = 2.0}}};
        const auto plan = test::required(mesher.plan("oo"));
        REQUIRE(plan->meshes().size() == 2);
        for (std::size_t k = 0; k < 2; ++k) CHECK(plan->shape_of(k) == glyph_shape{});
    }
    plane_path ring;
    ring.circle({0, 0}, 1.5);
    text_mesher mesher{font, on_path{&ring}};
    const auto plan = test::required(mesher.plan("oEo"));
    REQUIRE(plan->meshes().size() == 2);
    CHECK(plan->shape_of(0) == glyph_shape{.id = 1});
    CHECK(plan->shape_of(1) == glyph_shape{.id = 2});
}

TEST_CASE("the shapes of a text are those of its faces and styles", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const style_span spans[] = {{1, 2, {.size = 2.0}}, {2, 3, {.style = style_id{4}}}};
    const auto plan = test::required(mesher.plan("ooo", {.shape = {.styles = spans}}));
    REQUIRE(plan->meshes().size() == 2);
    CHECK(plan->shape_of(0) == glyph_shape{.id = 1});
    CHECK(plan->shape_of(1) == glyph_shape{.id = 1, .map = {.xx = 2.0, .yy = 2.0}});
}

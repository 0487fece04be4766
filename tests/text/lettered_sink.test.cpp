// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

static_assert(mesh_sink<moved_sink<decltype(into(std::span<vec3>{}, std::span<std::uint32_t>{}))>>);
static_assert(chunked_sink<moved_sink<decltype(into(std::span<vec3>{}, std::span<std::uint32_t>{}))>>);

TEST_CASE("a hidden letter keeps its room in the mesh, and the others stay where they are", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan("oE xi"));
    REQUIRE(plan->find_letters("oE xi"));
    const test::lit_mesh whole = test::written(*plan);
    test::lit_mesh m;
    REQUIRE(plan->write(into(m.vertices, m.indices), reveal{.graphemes = 2}));
    CHECK(m.indices == whole.indices);
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
        for (const part p : plan->parts()) {
            const mesh_range r = plan->range(g, p);
            for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i)
                REQUIRE((g < 2 ? m.vertices[i] == whole.vertices[i]
                               : m.vertices[i].place == plan->letters().letters[g].pivot));
        }
}

TEST_CASE("only the glyphs that are written are announced, also for a part of a text", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan("oE xi"));
    REQUIRE(plan->find_letters("oE xi"));
    const auto motion = [](const letter_place& l) noexcept { return shifted({0.0f, float(l.index), 0.0f}); };
    test::lit_mesh m = test::written(*plan);
    const test::lit_mesh whole = m;
    auto sink = into(std::span{m.vertices}, std::span{m.indices});
    REQUIRE(plan->write(glyph_span{2, 4}, plan->moved(sink, motion)));
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        const mesh_range r = plan->range(g, part::front);
        CHECK(m.vertices[r.first_vertex].place.y ==
              Catch::Approx(whole.vertices[r.first_vertex].place.y + (g < 2 ? 0.0 : double(g))));
    }
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct named_vertex {
    vec3 place;
    cluster_id cluster;
    std::uint32_t letter, word, line;
    vec3 pivot, extent;
};

}  // namespace

template <>
struct typemesh::vertex_traits<named_vertex> {
    static constexpr auto wants = attribute::position | attribute::cluster | letter_attributes;
    named_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.cluster, s.letter, s.word, s.line, s.pivot, s.extent};
    }
};

TEMPLATE_TEST_CASE("a vertex's letter, word and line are those of a walk along the text", "[letters]", flat, extruded<>,
                   bevelled)
{
    const std::string text = "oEi xo\nio  E oo x";
    const style_span spans[] = {{2, 5, {.style = style_id{3}}}};
    test::toy_font font;
    text_mesher mesher{font, TestType{}};
    std::vector<named_vertex> vertices;
    std::vector<std::uint32_t> indices;
    REQUIRE(mesher.build(text, into(vertices, indices), {.shape = {.styles = spans}}));
    std::vector<bool> seen(text.size(), false);
    std::size_t wrong = 0;
    for (const named_vertex& v : vertices) {
        std::uint32_t letter = 0, word = 0, line = 0;
        for (std::uint32_t i = 0; i < v.cluster; ++i) {
            const bool drawn = std::isspace(static_cast<unsigned char>(text[i])) == 0;
            letter += drawn ? 1u : 0u;
            word += drawn && std::isspace(static_cast<unsigned char>(text[i + 1])) != 0 ? 1u : 0u;
            line += text[i] == '\n' ? 1u : 0u;
        }
        wrong += v.letter != letter || v.word != word || v.line != line ? 1u : 0u;
        seen[v.cluster] = true;
    }
    CHECK(wrong == 0);
    for (std::size_t i = 0; i < text.size(); ++i)
        CHECK(seen[i] == (std::isspace(static_cast<unsigned char>(text[i])) == 0));

    // Pivot and extent, from the vertices themselves.
    for (std::uint32_t letter = 0; letter < 11; ++letter) {
        bounds3 box;
        const named_vertex* one = nullptr;
        for (const named_vertex& v : vertices) {
            if (v.letter != letter) continue;
            if (one == nullptr) box = {v.place, v.place};
            one = &v;
            box.add(v.place);
        }
        REQUIRE(one != nullptr);
        CHECK(one->pivot.x == Catch::Approx(0.5 * (box.low.x + box.high.x)).margin(1e-5));
        CHECK(one->pivot.y == Catch::Approx(one->line == 0 ? 0.0 : -1.0).margin(1e-6));
        CHECK(one->pivot.z == Catch::Approx(box.high.z));
        CHECK(one->extent.x == Catch::Approx(box.high.x - box.low.x).margin(1e-5));
        CHECK(one->extent.y == Catch::Approx(box.high.y - box.low.y).margin(1e-5));
        CHECK(one->extent.z == Catch::Approx(box.high.z - box.low.z).margin(1e-6));
    }
}

TEST_CASE("streams hold letter data, and shared meshes have none", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan("oo E"));
    REQUIRE(plan->find_letters("oo E"));
    const std::size_t count = plan->size().vertices;
    std::vector<std::uint16_t> letters(count), words(count), lines(count);
    std::vector<vec3> pivots(count), extents(count);
    std::vector<std::uint32_t> indices(plan->size().indices());
    REQUIRE(plan->write(stream_sink{std::span{indices}, stream<attribute::letter, std::uint16_t>{std::span{letters}},
                                    stream<attribute::word, std::uint16_t>{std::span{words}},
                                    stream<attribute::line, std::uint16_t>{std::span{lines}},
                                    stream<attribute::pivot, vec3>{std::span{pivots}},
                                    stream<attribute::extent, vec3>{std::span{extents}}}));
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
        for (const part p : plan->parts()) {
            const mesh_range r = plan->range(g, p);
            const text_letter row = plan->letters().letters[g];
            for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
                REQUIRE(letters[i] == g);
                REQUIRE(words[i] == (g < 2 ? 0 : 1));
                REQUIRE(lines[i] == 0);
                REQUIRE(pivots[i] == row.pivot);
                REQUIRE(extents[i] == row.extent);
            }
        }
    std::vector<named_vertex> once;
    REQUIRE(plan->write_meshes(into(once, indices)));
    CHECK(std::all_of(once.begin(), once.end(), [](const named_vertex& v) { return v.letter == not_a_letter; }));
    plan->write_instances([&](const glyph_instance& drawn) noexcept { CHECK(drawn.letter == drawn.glyph); });
}

// SPDX-License-Identifier: MIT

#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/transformed_outlines.hpp>
#include <typemesh/text/shaped_by.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <cmath>
#include <vector>

using namespace typemesh;

namespace {

struct vertex {
    vec3 position;
};

}  // namespace

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position}; }
};

namespace {

struct mesh {
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
};

template <class Font>
mesh built(Font& font, std::string_view text)
{
    mesh m;
    text_mesher mesher{font};
    REQUIRE(mesher.build(text, into(m.vertices, m.indices)));
    return m;
}

}  // namespace

TEST_CASE("text shaped by one font and drawn by another has the places of the first and the outlines of the second",
          "[text][shaped_by]")
{
    test::toy_font font, drawn;
    const affine slant{.xy = 0.25};
    transformed_outlines slanted{drawn, slant};
    shaped_by both{font, slanted};
    // Straight letters: their points are the plain ones, moved by a quarter of how high they stand.
    const mesh e = built(font, "EiE"), slanted_e = built(both, "EiE");
    REQUIRE((slanted_e.indices.size() == e.indices.size()));
    REQUIRE(slanted_e.vertices.size() == e.vertices.size());
    for (std::size_t i = 0; i < e.vertices.size(); ++i) {
        bool found = false;
        const vec3 p = e.vertices[i].position;
        for (const vertex& v : slanted_e.vertices)
            found = found || (std::abs(v.position.x - (p.x + 0.25f * p.y)) < 1e-5f &&
                              std::abs(v.position.y - p.y) < 1e-5f && same(v.position.z, p.z));
        CHECK(found);
    }
}

TEST_CASE("what is drawn tells units, fill rule and variation, what shapes tells the lines", "[text][shaped_by]")
{
    test::toy_font font, drawn;
    transformed_outlines slanted{drawn, affine{.xy = 0.25}};
    shaped_by both{font, slanted};
    CHECK(both.units_per_em() == 1000.0);
    CHECK(both.fill() == fill_rule::non_zero);
    CHECK(both.variation_key() == variation_of(slanted));
    CHECK(both.variation_key() != variation_of(font));
    CHECK(both.metrics(direction::left_to_right).ascender == 800.0);
    outline o;
    CHECK(record(both, test::toy_font::glyph_of('E'), o));
    CHECK(o.curves.size() == 12);
}

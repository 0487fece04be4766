// SPDX-License-Identifier: MIT

#include "text_to_mesh/annotations.hpp"

#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <utility>

using text_to_mesh::model;
using text_to_mesh::overlay;

namespace shown_outline {

/// A square front of two triangles whose corners are doubled, with a wall on one side of it.
model square()
{
    model m;
    for (const auto& p : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}})
        m.vertices.push_back({{p.first, p.second, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
    m.vertices.push_back({{0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
    m.indices = {0, 1, 2, 3, 4, 5, 0, 6, 1};
    m.parts = {{"front", 0, 6}, {"side", 6, 3}};
    return m;
}

overlay of(const text_to_mesh::options& o, const model& m)
{
    auto font = typemesh::harfbuzz_font::open(font_file("truetype/liberation/LiberationSerif-Regular.ttf").c_str());
    REQUIRE(font);
    text_to_mesh::installed_fallback nothing;
    text_to_mesh::font_set fonts{*font, nothing};
    return text_to_mesh::annotate(o, fonts, typemesh::glyph_run{}, {}, m);
}

}  // namespace shown_outline

TEST_CASE("the outline that --show draws is that of the letters as they are, bold or hollow", "[text_to_mesh]")
{
    text_to_mesh::options o;
    o.show_contours = o.show_points = true;
    CHECK(shown_outline::of(o, shown_outline::square()).segments.empty());
    for (const bool hollow : {false, true}) {
        o.embolden = hollow ? 0.0f : -0.01f;
        o.outline.width = hollow ? 0.02f : 0.0f;
        const overlay drawn = shown_outline::of(o, shown_outline::square());
        CHECK(drawn.segments.size() == 4);
        CHECK(drawn.dots.size() == 8);
        for (const auto& s : drawn.segments) {
            const float across = (s.a[0] - s.b[0]) * (s.a[1] - s.b[1]);
            CHECK_FALSE((across > 0.0f || across < 0.0f));  // no diagonal
            CHECK_FALSE(s.a[2] + s.b[2] < 0.0f);
        }
    }
}

// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

/// A toy font with lines of another height, which keeps the features that it was last shaped with.
struct tall_font : test::toy_font {
    std::vector<std::string> features;

    [[nodiscard]] line_metrics metrics(direction) const noexcept { return {900.0, -350.0, 77.0}; }
    error shape(text_view text, const text_item& item, const shape_options& o, buffer<shaped_glyph>& glyphs) noexcept
    {
        features.clear();
        for (const feature& f : o.features) features.push_back(f.tag + std::string{"="} + std::to_string(f.value));
        return toy_font::shape(text, item, o, glyphs);
    }
};

template <class Maker>
auto planned(Maker& maker, const auto& text, const d3dx_text_options& options = {})
{
    auto plan = maker.plan(text, options);
    REQUIRE(plan);
    return std::move(*plan);
}

/// The mesh of a plan in arrays of the caller, as D3DXCreateText's is read.
template <class Vertex = test::full_vertex, class Index = std::uint32_t>
struct arrays {
    std::vector<Vertex> vertices;
    std::vector<Index> indices;

    explicit arrays(const auto& plan) : vertices(plan.size().vertices), indices(plan.size().indices())
    {
        REQUIRE(plan.write(std::span{vertices}, std::span{indices}));
    }
    operator full_mesh() const { return {vertices, indices}; }
};

full_mesh write(const auto& plan) { return arrays{plan}; }

template <class Font>
full_mesh made(Font& font, const std::u16string& text, const d3dx_text_options& options = {})
{
    d3dx_text maker{font};
    return write(planned(maker, text, options));
}

template <class Font>
std::vector<d3dx_glyph_metrics> metrics_of(Font& font, const auto& text, const d3dx_text_options& options = {})
{
    d3dx_text maker{font};
    const auto plan = planned(maker, text, options);
    std::vector<d3dx_glyph_metrics> m(plan.metrics_size(), {9, 9, {9, 9}, 9, 9});
    REQUIRE(plan.metrics(m));
    return m;
}

const std::u16string all_glyphs = u"oEx i?\u4E2D";

}  // namespace

TEST_CASE("the front cap lies at z = -extrusion, and the back cap at z = 0", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const double extrusion = GENERATE(0.01, 0.3, 5.0);
    const auto plan = planned(maker, all_glyphs, {.extrusion = extrusion});
    const full_mesh m = write(plan);

    const auto cap = [&](mesh_range r, float z, float facing) {
        REQUIRE(r.vertex_count > 0);
        for (std::uint32_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
            REQUIRE(m.vertices[i].position.z == z);
            REQUIRE(m.vertices[i].normal == vec3{0.0f, 0.0f, facing});
        }
    };
    cap(plan.front(), -static_cast<float>(extrusion), -1.0f);
    cap(plan.back(), 0.0f, 1.0f);
    for (const auto& v : m.vertices) {
        REQUIRE(v.position.z <= 0.0f);
        REQUIRE(v.position.z >= -static_cast<float>(extrusion));
    }
    CHECK(plan.front().index_count == plan.back().index_count);
    CHECK(plan.front().index_count + plan.back().index_count + plan.sides().index_count == m.indices.size());
}

TEST_CASE("text runs from left to right along x, and y points up", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const auto plan = planned(maker, u"iE");
    const full_mesh m = write(plan);
    REQUIRE(plan.text().glyphs().size() == 2);

    const mesh_range e = plan.text().range(1, part::back);
    float arms = 0.0f;
    for (std::uint32_t i = e.first_vertex; i < e.first_vertex + e.vertex_count; ++i) {
        CHECK(m.vertices[i].position.x >= 0.65f);  // the second letter, one advance of 0.6 further on
        CHECK(m.vertices[i].position.y >= 0.0f);
        arms = std::fmax(arms, m.vertices[i].position.x);
    }
    CHECK(arms == Approx(1.05f));  // its arms point to the right
}

TEST_CASE("front faces are clockwise, and every normal points outwards", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const auto plan = planned(maker, all_glyphs);
    const full_mesh m = write(plan);
    const auto corner = [&](std::uint32_t i) { return m.vertices[m.indices[i]]; };
    for (std::uint32_t i = 0; i < m.indices.size(); i += 3) {
        const test::cross_product turn{test::subtract(corner(i + 1).position, corner(i).position),
                                       test::subtract(corner(i + 2).position, corner(i).position)};
        REQUIRE(turn.along(corner(i).normal) > 0.0);
    }
    // As drawn on the viewer's screen, where x is to the right and y up: clockwise is a negative area.
    const mesh_range front = plan.front();
    for (std::uint32_t i = front.first_index; i < front.first_index + front.index_count; i += 3) {
        const vec3 a = corner(i).position, b = corner(i + 1).position, c = corner(i + 2).position;
        REQUIRE((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0.0f);
    }
}

TEST_CASE("the mesh is closed and encloses its outline's area times the extrusion", "[compat]")
{
    test::toy_font font;
    for (const double deviation : {0.1, 0.01, 0.005, 0.001, 0.0}) {
        const full_mesh m = made(font, u"E", {.deviation = deviation, .extrusion = 0.25});
        CHECK(test::volume(m.vertices, m.indices) == Approx(0.155 * 0.25));
        const auto closed = test::examine(made(font, all_glyphs, {.deviation = deviation}));
        CHECK(closed.unmatched_edges == 0);
        CHECK(closed.zero_area == 0);
    }
}

TEST_CASE("the mesh equals the one of text_mesher", "[compat]")
{
    test::toy_font font;
    text_mesher mesher = text_mesher{font}.with(extruded<>{.depth = 0.4f, .texture = texture_mapping::box});
    full_mesh own;
    REQUIRE(mesher.build(all_glyphs, into(own.vertices, own.indices),
                         {.tolerance = d3dx_tolerance(0.005), .draw_missing = true}));
    CHECK(test::same_bits(made(font, all_glyphs, {.deviation = 0.005, .size = d3dx_size::em}), own));
}

TEST_CASE("the size is the height of the cell, as in Direct3D, or of the em", "[compat]")
{
    tall_font font;
    const full_mesh cell = made(font, u"Eo", {.deviation = 0.004, .extrusion = 0.5}),
                    em = made(font, u"Eo", {.deviation = 0.005, .extrusion = 0.5, .size = d3dx_size::em});
    REQUIRE(cell.vertices.size() == em.vertices.size());  // the deviation is in the output's unit, as 0.004 cells
    for (std::size_t i = 0; i < cell.vertices.size(); ++i) {
        CHECK(cell.vertices[i].position.x * 1.25f == Approx(em.vertices[i].position.x).margin(1e-6));
        CHECK(cell.vertices[i].position.y * 1.25f == Approx(em.vertices[i].position.y).margin(1e-6));
        CHECK(cell.vertices[i].position.z == Approx(em.vertices[i].position.z));  // and so is the extrusion
    }
}

TEST_CASE("metrics do not depend on the styles of letters", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    constexpr std::string_view text = "oE x\nixoE o";
    std::vector<style_span> spans;  // every other letter in a style of its own, a descending one
    for (std::uint32_t i = 0; i < text.size(); i += 2) spans.push_back({i, i + 1, {.style = style_id{900 - i}}});
    REQUIRE(planned(maker, text, {.shape = {.styles = spans}}).text().styles().size() > 2);
    const auto expected = metrics_of(font, text), found = metrics_of(font, text, {.shape = {.styles = spans}});
    REQUIRE(expected.size() == text.size());
    REQUIRE(found.size() == text.size());
    CHECK(std::memcmp(found.data(), expected.data(), text.size() * sizeof(d3dx_glyph_metrics)) == 0);
}

TEST_CASE("metrics do not depend on underlines", "[compat]")
{
    test::toy_font font;
    const style_span spans[] = {{0, 7, {.decorations = decoration::underline}}};
    const auto expected = metrics_of(font, "oE x\nix"),
               found = metrics_of(font, "oE x\nix", {.shape = {.styles = spans}});
    REQUIRE(found.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        INFO("character " << i);
        CHECK(found[i].advance_x == Approx(expected[i].advance_x).margin(1e-6));
        CHECK(found[i].box_width == Approx(expected[i].box_width));
    }
}

TEST_CASE("spaces at a line's end keep their advance", "[compat]")
{
    test::toy_font font;
    const auto m = metrics_of(font, u"E  \no ");
    REQUIRE(m.size() == 6);
    for (const std::size_t i : {0u, 1u, 2u, 4u, 5u}) {
        INFO("character " << i);
        CHECK(m[i].advance_x == Approx(0.6f));
    }
}

TEST_CASE("each character has its metrics", "[compat]")
{
    test::toy_font font;
    const auto m = metrics_of(font, u"E i\no?", {.draw_missing = false});
    REQUIRE(m.size() == 6);
    const auto is = [&](std::size_t i, float w, float h, float x, float y, float advance) {
        INFO("character " << i);
        CHECK(m[i].box_width == Approx(w));
        CHECK(m[i].box_height == Approx(h));
        CHECK(m[i].origin.x == Approx(x));
        CHECK(m[i].origin.y == Approx(y));
        CHECK(m[i].advance_x == Approx(advance));
        CHECK(m[i].advance_y == 0.0f);
    };
    is(0, 0.4f, 0.7f, 0.05f, 0.7f, 0.6f);
    is(1, 0.0f, 0.0f, 0.0f, 0.0f, 0.6f);
    is(2, 0.1f, 0.5f, 0.1f, 0.5f, 0.6f);
    is(3, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f);  // a line break
    is(4, 0.5f, 0.5f, 0.0f, 0.5f, 0.6f);  // from its own line's baseline
    is(5, 0.0f, 0.0f, 0.0f, 0.0f, 0.6f);  // missing, and not drawn
}

TEST_CASE("arrays that are too small stay unchanged, and the error reports the size that is needed", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const auto plan = planned(maker, u"oE");
    const auto size = plan.size();
    std::vector<d3dx_vertex> vertices(size.vertices, {{7, 7, 7}, {7, 7, 7}});
    std::vector<std::uint16_t> indices(size.indices(), 7);
    std::vector<d3dx_glyph_metrics> metrics(2, {7, 7, {7, 7}, 7, 7});
    const auto needs = [](error e, std::uint64_t count) {
        CHECK(e == error::buffer_too_small);
        CHECK(e.count == count);
    };
    needs(plan.write(std::span{vertices}.first(size.vertices - 1), std::span{indices}).error(), size.vertices);
    needs(plan.write(std::span{vertices}, std::span{indices}.first(size.indices() - 1)).error(), size.indices());
    needs(plan.metrics(std::span{metrics}.first(1)).error(), 2);
    for (const auto& v : vertices) REQUIRE(v.position == vec3{7, 7, 7});
    for (const auto i : indices) REQUIRE(i == 7);
    CHECK(metrics[0].box_width == 7.0f);
    CHECK(plan.write(std::span{vertices}, std::span{indices}));
    CHECK(plan.metrics(metrics));
}

TEST_CASE("16-bit indices are refused if they are too small, and otherwise equal 32-bit ones", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const auto few = planned(maker, u"o");
    const arrays<d3dx_vertex, std::uint16_t> narrow{few};
    const arrays<d3dx_vertex> wide{few};
    CHECK(std::equal(narrow.indices.begin(), narrow.indices.end(), wide.indices.begin(), wide.indices.end()));

    const std::u16string text(65536 / narrow.vertices.size() + 1, u'o');
    const auto many = planned(maker, text);
    REQUIRE(many.size().vertices > 65535);
    std::vector<d3dx_vertex> vertices(many.size().vertices, {{7, 7, 7}, {7, 7, 7}});
    std::vector<std::uint16_t> indices(many.size().indices());
    const error refused = many.write(std::span{vertices}, std::span{indices}).error();
    CHECK(refused == error::index_overflow);
    CHECK(refused.count == many.size().vertices);
    CHECK(vertices[0].position == vec3{7, 7, 7});
    (void)arrays<d3dx_vertex>{many};
}

TEST_CASE("an empty text and a blank text have empty meshes", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const std::u16string text = GENERATE(std::u16string{}, std::u16string{u"  "}, std::u16string{u"\n"});
    const auto plan = planned(maker, text);
    CHECK(plan.size() == mesh_size{});
    CHECK(metrics_of(font, text).size() == text.size());
    (void)arrays<d3dx_vertex, std::uint16_t>{plan};
}

TEST_CASE("characters that the font lacks are drawn as a box and reported", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    for (const bool drawn : {true, false}) {
        const auto plan = planned(maker, u"o?", {.draw_missing = drawn});
        CHECK(plan.report().missing == 1);
        CHECK(plan.report().first_missing == 1);
        CHECK(plan.text().glyphs().size() == (drawn ? 2 : 1));
    }
    CHECK(planned(maker, u"o?").text().glyphs().size() == 2);
}

TEST_CASE("kerning and ligatures are off by default, and further features are passed on", "[compat]")
{
    tall_font font;
    d3dx_text maker{font};
    const feature more[] = {{"ss01", 2}};
    using tags = std::vector<std::string>;
    for (const auto& [options, features] :
         {std::pair<d3dx_text_options, tags>{{}, {"kern=0", "liga=0", "clig=0"}},
          {{.kerning = true}, {"liga=0", "clig=0"}},
          {{.ligatures = true}, {"kern=0"}},
          {{.kerning = true, .ligatures = true, .shape = {.features = more}}, {"ss01=2"}}}) {
        REQUIRE(maker.plan(u"o", options));
        CHECK(font.features == features);
    }
}

TEST_CASE("arguments out of range are refused by name", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {-1.0, -1e-9, nan, inf}) {
        CHECK(maker.plan(u"o", {.deviation = bad}).error() == error::bad_tolerance);
        const error e = maker.plan(u"o", {.extrusion = bad}).error();
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option} == "extrusion");
    }
    for (const double bad : {0.0, 1e-300, 1e-40, 1e39, 1e300})  // not zero, and yet no depth of 32 bits
        CHECK(maker.plan(u"o", {.extrusion = bad}).error() == error::bad_option);
    CHECK(maker.plan(u"o"));
}

TEST_CASE("a deviation of 0 is one font unit, as in Direct3D", "[compat]")
{
    test::toy_font font;
    CHECK(test::same_bits(made(font, u"o", {.deviation = 0.0}), made(font, u"o", {.deviation = 0.001})));
}

TEST_CASE("texture coordinates span the text", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    const arrays<d3dx_textured_vertex, std::uint16_t> m{planned(maker, u"Eo")};
    vec2 low{1, 1}, high{0, 0};
    for (const auto& v : m.vertices) {
        low = {std::fmin(low.x, v.uv.x), std::fmin(low.y, v.uv.y)};
        high = {std::fmax(high.x, v.uv.x), std::fmax(high.y, v.uv.y)};
    }
    CHECK(low.x == Approx(0.0f).margin(1e-6));
    CHECK(low.y == Approx(0.0f).margin(1e-6));
    CHECK(high.x == Approx(1.0f));
    CHECK(high.y == Approx(1.0f));
}

TEST_CASE("the crease angle can be the one of Direct3D", "[compat]")
{
    test::toy_font font;
    d3dx_text maker{font};
    CHECK(planned(maker, u"E").text().hard_edges() == 12);
    maker.normals_policy().crease_degrees = 120.0f;
    CHECK(planned(maker, u"E").text().hard_edges() == 0);
}

TEST_CASE("a cache changes only the time", "[compat]")
{
    test::toy_font font;
    glyph_cache cache;
    d3dx_text maker{font, cached_in{cache, 1}};
    for (int round = 0; round < 2; ++round) {
        CHECK(test::same_bits(write(planned(maker, all_glyphs)), made(font, all_glyphs)));
    }
    CHECK(cache.statistics().hits > 0);
}

TEST_CASE("nothing is allocated after warm-up, and a lack of memory is a temporary error", "[compat]")
{
    test::toy_font font;
    test::counting_memory counted;
    std::vector<d3dx_vertex> vertices(65536);
    std::vector<std::uint32_t> indices(3 * 65536);
    std::vector<d3dx_glyph_metrics> metrics(all_glyphs.size());
    {
        d3dx_text maker{font, counted.source()};
        const auto work = [&] {
            const auto plan = maker.plan(all_glyphs);
            if (!plan) return plan.error();
            if (const auto done = plan->write(std::span{vertices}, std::span{indices}); !done) return done.error();
            return plan->metrics(metrics).error();
        };
        REQUIRE_FALSE(work());
        REQUIRE_FALSE(work());
        const std::size_t warm = counted.requests;
        for (int i = 0; i < 3; ++i) REQUIRE_FALSE(work());
        CHECK(counted.requests == warm);
    }
    CHECK(counted.bytes_held == 0);
    const std::size_t all = counted.requests;
    for (std::size_t n = 1; n <= all; ++n) {
        test::counting_memory failing;
        failing.fail_at = n;
        failing.fail_once = true;
        d3dx_text maker{font, failing.source()};
        const auto first = maker.plan(all_glyphs);
        if (!first) CHECK(first.error() == error::out_of_memory);
        CHECK(maker.plan(all_glyphs));
    }
}

namespace {
template <class Font>
concept takes_a_temporary = requires { d3dx_text{Font{}}; };
template <class Font>
concept plans_without_a_name = requires(Font& f) { d3dx_text{f}.plan(u"o"); };
}  // namespace

TEST_CASE("a temporary font and a temporary maker do not compile", "[compat]")
{
    STATIC_REQUIRE_FALSE(takes_a_temporary<test::toy_font>);
    STATIC_REQUIRE_FALSE(plans_without_a_name<test::toy_font>);
}

TEST_CASE("another triangulator changes only the triangles of the caps", "[compat]")
{
    test::toy_font font;
    d3dx_text usual{font};
    auto fair = d3dx_text{font}.with(constrained_delaunay{});
    static_assert(std::is_same_v<decltype(fair), d3dx_text<>>);
    for (const auto* text : {u"o", u"Eo i", u""}) {
        const auto a = planned(usual, text), b = planned(fair, text);
        REQUIRE(a.size() == b.size());
        const arrays<d3dx_textured_vertex, std::uint16_t> first{a}, second{b};
        for (std::size_t i = 0; i < first.vertices.size(); ++i) {
            CHECK(first.vertices[i].position == second.vertices[i].position);
            CHECK(first.vertices[i].normal == second.vertices[i].normal);
            CHECK(first.vertices[i].uv == second.vertices[i].uv);
        }
        const auto walls = a.sides();
        for (std::size_t i = walls.first_index; i < walls.first_index + walls.index_count; ++i)
            CHECK(first.indices[i] == second.indices[i]);
        if (!first.indices.empty()) CHECK_FALSE(first.indices == second.indices);
    }
}

TEST_CASE("another extruder has Direct3D's position, all of its parts, and the extrusion as its depth", "[compat]")
{
    test::toy_font font;
    const double extrusion = GENERATE(0.1, 5.0);
    // The cell of the toy font is as large as its em, so widths and depths have the same unit.
    auto maker = d3dx_text{font}.with(bevelled{.width = 0.02f, .bevel_depth = 0.04f});
    const auto plan = planned(maker, all_glyphs, {.extrusion = extrusion});
    const full_mesh m = write(plan);
    CHECK(test::examine(m).unmatched_edges == 0);
    std::size_t indices = 0;
    const auto lies = [&](mesh_range r, double low, double high, double facing) {
        REQUIRE(r.vertex_count > 0);
        indices += r.index_count;
        for (std::uint32_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
            REQUIRE(m.vertices[i].position.z >= static_cast<float>(low) - 1e-6f);
            REQUIRE(m.vertices[i].position.z <= static_cast<float>(high) + 1e-6f);
            REQUIRE(as_double(m.vertices[i].normal.z) == Approx(facing).margin(1e-6));
        }
    };
    const double lean = std::sqrt(0.2);  // of a bevel twice as deep as wide
    lies(plan.front(), -extrusion, -extrusion, -1.0);
    lies(plan.front_bevel(), -extrusion, -extrusion + 0.04, -lean);
    lies(plan.sides(), -extrusion + 0.04, -0.04, 0.0);
    lies(plan.back_bevel(), -0.04, 0.0, lean);
    lies(plan.back(), 0.0, 0.0, 1.0);
    CHECK(indices == m.indices.size());

    CHECK(std::string{maker.plan(u"o", {.extrusion = 0.07}).error().option} == "bevel_depth");
    maker.solid().bevel_depth = 0.03f;
    CHECK(maker.plan(u"o", {.extrusion = 0.07}));

    const arrays<d3dx_textured_vertex> textured{planned(maker, u"oE")};
    for (const auto& v : textured.vertices) {  // as without bevels: one tile over the text
        CHECK(v.uv.x >= 0.0f);
        CHECK(v.uv.x <= 1.0f);
    }
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/failing_memory.hpp"
#include "support/laid_out.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <concepts>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

template <class Mesher, class Text>
full_mesh build(Mesher& mesher, const Text& text, const text_options& options = {})
{
    full_mesh m;
    const auto made = test::required(mesher.build(text, into(m.vertices, m.indices), options));
    return m;
}

struct span2 {
    float low, high;
};

span2 extent(const full_mesh& m, float vec3::* axis)
{
    span2 e{m.vertices.at(0).position.*axis, m.vertices.at(0).position.*axis};
    for (const auto& v : m.vertices) e = {std::fmin(e.low, v.position.*axis), std::fmax(e.high, v.position.*axis)};
    return e;
}

/// A discretiser that can be told from the default: it gives each curve `pieces` lines.
struct equal_steps {
    int pieces = 3;
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        for (int i = 1; i <= pieces; ++i) put(c.at(double(i) / pieces), double(i) / pieces);
    }
};

// A mesher's type names its solid alone, whatever else it is given: also with clang 14 to 16, which deduce otherwise.
template <class Mesher>
using mesher_of_its_solid = decltype(text_mesher{std::declval<test::toy_font&>(), std::declval<Mesher&>().solid()});
template <class... Option>
using mesher_of = decltype(text_mesher{std::declval<test::toy_font&>(), std::declval<Option>()...});
static_assert(std::same_as<mesher_of<>, text_mesher<extruded<>>>);
static_assert(std::same_as<mesher_of<flat>, text_mesher<flat>>);
static_assert(std::same_as<mesher_of<constrained_delaunay, flat, memory>, text_mesher<flat>>);
static_assert(std::same_as<mesher_of<two_lines, monotone, no_cache>, text_mesher<>>);
static_assert(std::same_as<decltype(text_mesher{heap()}), text_mesher<>>);
static_assert(std::same_as<mesher_of_its_solid<text_mesher<flat>>, text_mesher<flat>>);

}  // namespace

TEST_CASE("a text becomes one closed mesh a glyph", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oEi o"));
    const full_mesh m = test::written<full_mesh>(*plan);

    REQUIRE(plan->glyphs().size() == 4);
    CHECK(plan->report().blank == 1);
    CHECK(plan->report().complete());
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        std::vector<std::uint32_t> own;
        for (const part p : all_parts) {
            const mesh_range r = plan->range(g, p);
            for (std::uint32_t i = 0; i < r.index_count; ++i) {
                const std::uint32_t v = m.indices[r.first_index + i];
                own.push_back(v);
                bool mine = false;
                for (const part q : all_parts) {
                    const mesh_range vertices = plan->range(g, q);
                    mine = mine || (v >= vertices.first_vertex && v < vertices.first_vertex + vertices.vertex_count);
                }
                REQUIRE(mine);
            }
        }
        const auto c = test::examine(m.vertices, own);
        CHECK(c.unmatched_edges == 0);
        CHECK(c.crowded_edges == 0);
        CHECK(c.zero_area == 0);
        CHECK(test::volume(m.vertices, own) > 0.0);
    }
}

TEST_CASE("the parts' ranges tile the output and hold each glyph's in order", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oEi"));
    std::uint32_t vertex = 0, index = 0;
    for (const part p : all_parts) {
        const mesh_range whole = plan->range(p);
        CHECK(whole.first_vertex == vertex);
        CHECK(whole.first_index == index);
        for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
            const mesh_range r = plan->range(g, p);
            CHECK(r.first_vertex == vertex);
            CHECK(r.first_index == index);
            vertex += r.vertex_count;
            index += r.index_count;
        }
        CHECK(whole.first_vertex + whole.vertex_count == vertex);
        CHECK(whole.first_index + whole.index_count == index);
    }
    CHECK(vertex == plan->size().vertices);
    CHECK(index == plan->size().indices());
}

TEST_CASE("the bounds are exactly those of the vertices, in every frame and unit", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto frame = GENERATE(right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up);
    const auto unit = GENERATE(output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box);
    const text_options options{.unit = unit, .frame = frame};
    auto plan = test::required(mesher.plan("o\nEi", options));
    const full_mesh m = test::written<full_mesh>(*plan);
    const bounds3 b = plan->bounds();
    for (const auto axis : {&vec3::x, &vec3::y, &vec3::z}) {
        CHECK(extent(m, axis).low == b.low.*axis);
        CHECK(extent(m, axis).high == b.high.*axis);
    }
}

TEST_CASE("the size multiplies every position of every unit, and nothing else changes", "[text]")
{
    test::toy_font font;
    const auto unit = GENERATE(output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box);
    const auto frame = GENERATE(right_handed_y_up, left_handed_z_up);
    const auto texture = GENERATE(from_range(std::begin(texture_mappings), std::end(texture_mappings)));
    const bool merge = GENERATE(false, true);
    const double size = GENERATE(0.37, 0.5, 2.0, 1e-6, 1000.0);
    auto mesher = text_mesher{font}.with(extruded<>{.depth = 0.3f, .texture = texture});
    const auto built = [&](double s, bounds3& bounds, double& step, std::vector<vec3>& moved) {
        const text_options options{.unit = unit, .size = s, .frame = frame, .merge = merge};
        auto plan = test::required(mesher.plan("Eo\nio", options));
        bounds = plan->bounds();
        step = plan->position_step();
        plan->write_instances([&](const glyph_instance& g) { moved.push_back(g.translation); });
        const full_mesh m = test::written<full_mesh>(*plan);
        return m;
    };
    bounds3 box, sized_box;
    double step = 0.0, sized_step = 0.0;
    std::vector<vec3> moved, sized_moved;
    const full_mesh plain = built(1.0, box, step, moved), sized = built(size, sized_box, sized_step, sized_moved);

    const bool exact = std::ldexp(1.0, std::ilogb(size)) == size;
    const auto check = [&](vec3 p, vec3 q) {
        for (const auto axis : {&vec3::x, &vec3::y, &vec3::z}) {
            const double expected = size * static_cast<double>(p.*axis);
            if (exact)
                CHECK(q.*axis == expected);
            else
                CHECK(std::fabs(q.*axis - expected) <= 3e-7 * std::fabs(expected));
        }
    };
    CHECK(sized.indices == plain.indices);
    REQUIRE(sized.vertices.size() == plain.vertices.size());
    for (std::size_t i = 0; i < plain.vertices.size(); ++i) {
        check(plain.vertices[i].position, sized.vertices[i].position);
        CHECK(sized.vertices[i].normal == plain.vertices[i].normal);
        CHECK(sized.vertices[i].uv == plain.vertices[i].uv);
    }
    check(box.low, sized_box.low);
    check(box.high, sized_box.high);
    REQUIRE(sized_moved.size() == moved.size());
    for (std::size_t i = 0; i < moved.size(); ++i) check(moved[i], sized_moved[i]);
    // In em: the same, but for where in its power of two the farthest coordinate lies.
    if (exact)
        CHECK(sized_step == step);
    else
        CHECK((sized_step > 0.49 * step && sized_step < 2.01 * step));
}

TEST_CASE("a size is how large an em is", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(extruded<>{.depth = 0.5f});
    auto plan = test::required(mesher.plan("E", {.size = 0.37}));
    CHECK(plan->bounds().high.x == static_cast<float>(0.37 * 0.45));
    CHECK(plan->bounds().low.z == static_cast<float>(0.37 * -0.5));
    CHECK(plan->bounds().high.z == 0.0f);
}

TEST_CASE("positions come in the unit of the options", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto box = [&](output_unit unit) {
        return extent(build(mesher, "E", {.unit = unit, .pixels_per_em = 32.0}), &vec3::x);
    };
    CHECK(box(output_unit::em).low == 0.05f);
    CHECK(box(output_unit::em).high == 0.45f);
    CHECK(box(output_unit::font_units).high == 450.0f);
    CHECK(box(output_unit::pixels).high == 0.45f * 32.0f);

    const auto fitted = build(mesher, "E", {.unit = output_unit::unit_box});  // 400 x 700: the height spans [-1, 1]
    CHECK(extent(fitted, &vec3::y).low == -1.0f);
    CHECK(extent(fitted, &vec3::y).high == 1.0f);
    CHECK(extent(fitted, &vec3::x).high == Catch::Approx(4.0 / 7.0));
    CHECK(extent(fitted, &vec3::x).low == Catch::Approx(-4.0 / 7.0));
}

TEST_CASE("each glyph stands at its pen position", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto one = build(mesher, "E"), two = build(mesher, "EE");
    CHECK(extent(two, &vec3::x).high == Catch::Approx(extent(one, &vec3::x).high + 0.6));
    const auto lines = build(mesher, "E\nE");
    CHECK(extent(lines, &vec3::y).low == Catch::Approx(-1.0));
    const auto right = build(mesher, "E\nEE", {.layout = {.align = alignment::right}});
    CHECK(extent(right, &vec3::x).high == Catch::Approx(-0.15));
}

TEST_CASE("box texture coordinates span 0 to 1 over the text, the line or the glyph", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(extruded<>{.texture = texture_mapping::box});
    const auto over = GENERATE(texture_box::text, texture_box::line, texture_box::glyph);
    auto plan = test::required(mesher.plan("oE\ni", {.texture_over = over}));
    const full_mesh m = test::written<full_mesh>(*plan);
    const auto range_of = [&](std::size_t first_glyph, std::size_t last_glyph) {
        vec2 low{9, 9}, high{-9, -9};
        for (std::size_t g = first_glyph; g < last_glyph; ++g) {
            const mesh_range r = plan->range(g, part::front);
            for (std::uint32_t v = r.first_vertex; v < r.first_vertex + r.vertex_count; ++v) {
                const vec2 uv = m.vertices[v].uv;
                low = {std::fmin(low.x, uv.x), std::fmin(low.y, uv.y)};
                high = {std::fmax(high.x, uv.x), std::fmax(high.y, uv.y)};
            }
        }
        return std::pair{low, high};
    };
    const auto spans_everything = [&](std::size_t first, std::size_t last) {
        const auto [low, high] = range_of(first, last);
        CHECK(low == vec2{0, 0});
        CHECK(high == vec2{1, 1});
    };
    if (over == texture_box::text) spans_everything(0, 3);
    if (over == texture_box::line) spans_everything(0, 2), spans_everything(2, 3);
    if (over == texture_box::glyph) spans_everything(0, 1), spans_everything(1, 2), spans_everything(2, 3);
}

TEST_CASE("a glyph that cannot be built is left out, counted and named, and the rest is there", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    full_mesh m;
    const auto made = test::required(mesher.build("Ex~o", into(m.vertices, m.indices)));
    CHECK(made->refused == 1);
    CHECK(made->first_refusal.code == error::outline_not_finite);
    CHECK(made->first_refusal.glyph == 6);
    CHECK(made->first_refusal.cluster == 2);
    CHECK_FALSE(made->complete());
    char words[160];
    CHECK(std::string(describe(made->first_refusal, words)) ==
          "glyph 6, cluster 2: The outline contains NaN or infinity: correct the font or its transform.");

    const auto alone = build(mesher, "Ex o");
    CHECK(alone.vertices.size() == m.vertices.size());
    CHECK(alone.indices == m.indices);
}

TEST_CASE("a missing glyph is reported, and drawn only on request", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    full_mesh m;
    const auto made = test::required(mesher.build("EqE", into(m.vertices, m.indices)));
    CHECK(made->missing == 1);
    CHECK(made->first_missing == 1);
    CHECK(made->unbroken == 0);
    glyph_run run;
    run.unbroken = 2;
    run.first_unbroken = 7;
    const auto reported = test::required(mesher.build(run, into(m.vertices, m.indices)));
    CHECK(reported->unbroken == 2);
    CHECK(reported->first_unbroken == 7);
    CHECK(mesher.build("EqE", into(m.vertices, m.indices)));
    const std::size_t without = m.vertices.size();
    REQUIRE(mesher.build("EqE", into(m.vertices, m.indices), {.draw_missing = true}));
    CHECK(m.vertices.size() > without);
}

TEST_CASE("empty text and blank glyphs give an empty mesh, not an error", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const char* text = GENERATE("", " ", "\n", " \n\n ");
    auto plan = test::required(mesher.plan(text));
    CHECK(plan->size() == mesh_size{});
    CHECK(plan->bounds().low == vec3{});
    full_mesh m = {{{}, {}}, {0, 0, 0}};
    REQUIRE(plan->write(into(m.vertices, m.indices)));
    CHECK(m.vertices.empty());
    CHECK(m.indices.empty());
}

static_assert(std::is_nothrow_move_constructible_v<text_plan<flat>> && !std::is_copy_constructible_v<text_plan<flat>>);

// A plan refers to its run, so a run that ends with the line is refused; text of any kind may end.
template <class M, class Run>
concept plans = requires(M& mesher, Run&& run) { mesher.plan(std::forward<Run>(run)); };
static_assert(plans<text_mesher<>, const glyph_run&> && plans<text_mesher<>, std::string>);
static_assert(!plans<text_mesher<>, glyph_run>);

// Overloads that refuse in a sentence take nothing away from the others: a text that is wide as well, a font that is
// const and no result.
struct text_of_an_engine {
    operator std::u16string_view() const noexcept { return u"oo"; }
    operator std::wstring_view() const noexcept { return L"oo"; }
};
static_assert(plans<text_mesher<>, text_of_an_engine> && !foreign_text<text_of_an_engine>);
static_assert(!foreign_text<std::nullptr_t> && !foreign_text<std::string> && foreign_text<std::wstring>);
static_assert(!std::is_constructible_v<text_mesher<>, const test::toy_font&>);

TEST_CASE("a run made by hand needs no shaper and no lines", "[text]")
{
    recorded_outlines shapes{1000.0};
    const auto id = shapes.add([](auto& pen) { pen.move({0, 0}), pen.line({10, 0}), pen.line({0, 10}), pen.close(); });
    REQUIRE(id);
    glyph_run run;
    REQUIRE(run.glyphs.push_back({*id, 0, {0, 0}}));
    REQUIRE(run.glyphs.push_back({*id, 1, {100, 0}}));
    text_mesher mesher{shapes};
    const auto over = GENERATE(texture_box::text, texture_box::line);
    const auto m = build(mesher, run, {.unit = output_unit::font_units, .texture_over = over});
    CHECK(extent(m, &vec3::x).high == 110.0f);
    CHECK(test::examine(m).unmatched_edges == 0);
}

TEST_CASE("a changed policy is used, the others stay", "[text]")
{
    test::toy_font font;
    text_mesher plain{font};
    auto flat_text = text_mesher{font}.with(flat{});
    auto stepped = text_mesher{font}.with(extruded<>{.depth = 1.0f}).with(equal_steps{7});

    const auto p = plain.plan("o");
    // two round contours, a seam each
    CHECK(flat_text.plan("o")->size().vertices * 4 + 2 * 2 == p->size().vertices);
    const auto s = stepped.plan("o");
    CHECK(s->contour_points() == 2 * 4 * 7);
    CHECK(s->bounds().low.z == -1.0f);
    stepped.policy<equal_steps>()->pieces = 2;
    CHECK(stepped.plan("o")->contour_points() == 2 * 4 * 2);
}

TEST_CASE("options out of range are refused in words", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const double nan = std::nan("");
    for (const double bad : {0.0, -1.0, nan, HUGE_VAL}) {
        CHECK(mesher.plan("o", {.tolerance = bad}).error() == error::bad_tolerance);
        CHECK(mesher.plan("o", {.pixels_per_em = bad}).error() == error::bad_option);
        const auto sized = mesher.plan("o", {.size = bad});
        CHECK(sized.error() == error::bad_option);
        CHECK(std::string{sized.error().option} == "size");
    }
    CHECK(mesher.plan("o", {.size = 0x1p30}));
    CHECK_FALSE(mesher.plan("o", {.size = 0x1p31}));
    CHECK_FALSE(mesher.plan("o", {.unit = output_unit::pixels, .size = 0x1p20, .pixels_per_em = 0x1p20}));
    mesher.solid().depth = static_cast<float>(nan);
    CHECK(mesher.plan("o").error() == error::bad_option);
    mesher.solid().depth = 0.2f;
    CHECK(mesher.plan("o"));
}

TEST_CASE("after warm-up a text of the same size allocates nothing", "[text]")
{
    test::counting_memory counted;
    {
        test::toy_font font;
        text_mesher mesher{font, counted.source()};
        full_mesh m;
        for (int i = 0; i < 2; ++i) REQUIRE(mesher.build("oEi o\nooo", into(m.vertices, m.indices)));
        const std::size_t before = counted.requests;
        REQUIRE(before > 0);
        for (int i = 0; i < 3; ++i) REQUIRE(mesher.build("oEi o\nooo", into(m.vertices, m.indices)));
        CHECK(counted.requests == before);
    }
    CHECK(counted.bytes_held == 0);
}

TEST_CASE("memory that fails at any request gives a clear error and leaves the mesher usable", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto make = [&](memory source) {
        return [poor = text_mesher{font, source}](full_mesh& m) mutable {
            return poor.build("oEi", into(m.vertices, m.indices));
        };
    };
    CHECK(test::failures_of(make, build(mesher, "oEi"), GENERATE(true, false)) > 5);
}

TEST_CASE("text comes as UTF-8 and UTF-16, clusters in its own units", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto clusters = [&](auto text) {
        std::vector<cluster_id> c;
        const auto plan = mesher.plan(text);
        for (const auto& g : plan->glyphs()) c.push_back(g.cluster);
        return c;
    };
    const std::vector<cluster_id> expected{0, 2};
    CHECK(clusters("o\nE") == expected);
    CHECK(clusters(u8"o\nE") == expected);
    CHECK(clusters(u"o\nE") == expected);
    CHECK(clusters(std::u16string(u"o\nE")) == expected);
}

TEST_CASE("a sink that refuses gets nothing more", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oE"));
    std::vector<test::full_vertex> vertices(plan->size().vertices - 1);
    std::vector<std::uint32_t> indices(plan->size().indices(), 77u);
    const error e = plan->write(into(std::span{vertices}, std::span{indices})).error();
    CHECK(e == error::buffer_too_small);
    CHECK(e.count == plan->size().vertices);
    CHECK(indices == std::vector<std::uint32_t>(plan->size().indices(), 77u));
}

TEST_CASE("the observer sees the stages in order and ends idle", "[text]")
{
    struct recorder {
        std::vector<stage>* seen;
        void operator()(stage s) noexcept { seen->push_back(s); }
    };
    test::toy_font font;
    std::vector<stage> seen;
    auto mesher = text_mesher{font}.with(recorder{&seen});
    REQUIRE(mesher.plan("o"));
    CHECK(seen == std::vector<stage>{stage::shape, stage::outline, stage::discretise, stage::triangulate,
                                     stage::extrude, stage::idle});
    seen.clear();
    REQUIRE(mesher.plan("x"));
    CHECK(seen == std::vector<stage>{stage::shape, stage::outline, stage::discretise, stage::triangulate, stage::fill,
                                     stage::triangulate, stage::extrude, stage::idle});
}

TEST_CASE("a glyph beyond all reach is refused, and no vertex is infinite", "[text]")
{
    test::toy_font font;
    const double origin = GENERATE(1e20, -1e20, 1e100, 1.7e308);
    const auto unit = GENERATE(output_unit::em, output_unit::font_units, output_unit::pixels, output_unit::unit_box);
    glyph_run run;
    REQUIRE(run.glyphs.push_back({.id = 2, .cluster = 0, .origin = {origin, 0}}));
    REQUIRE(run.glyphs.push_back({.id = 2, .cluster = 1, .origin = {0, 0}}));
    text_mesher mesher{font};
    full_mesh m;
    const auto made = test::required(mesher.build(run, into(m.vertices, m.indices), {.unit = unit}));
    CHECK(made->refused == (std::fabs(origin) > 1e24 ? 1u : 0u));
    if (made->refused != 0) CHECK(made->first_refusal == error::outline_beyond_grid);
    for (const auto& v : m.vertices)
        for (const float f : {v.position.x, v.position.y, v.position.z, v.uv.x, v.uv.y}) REQUIRE(is_finite(double(f)));
}

TEST_CASE("texture coordinates in em do not depend on the unit, not even where that centres the text", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const full_mesh plain = build(mesher, "oE"), boxed = build(mesher, "oE", {.unit = output_unit::unit_box});
    REQUIRE(plain.vertices.size() == boxed.vertices.size());
    for (std::size_t i = 0; i < plain.vertices.size(); ++i) CHECK(plain.vertices[i].uv == boxed.vertices[i].uv);
}

TEST_CASE("texture coordinates of walls are em deep, whatever the unit of depths", "[text]")
{
    test::toy_font font;
    text_mesher mesher = text_mesher{font}.with(extruded<>{.depth = 0.25f});
    const full_mesh plain = build(mesher, "oE", {.size = 2.0});
    text_mesher other = text_mesher{font}.with(extruded<>{.depth = 0.5f});
    const full_mesh deep = build(other, "oE", {.size = 2.0, .depth_in = depth_unit::output});
    REQUIRE(plain.vertices.size() == deep.vertices.size());
    for (std::size_t i = 0; i < plain.vertices.size(); ++i) {
        CHECK(plain.vertices[i].position == deep.vertices[i].position);
        CHECK(plain.vertices[i].uv == deep.vertices[i].uv);
    }
}

TEST_CASE("plain text refuses what only a paragraph can do, and names it", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const error width = mesher.plan("EE EE", {.layout = {.width = 2.0}}).error();
    CHECK(width == error::needs_paragraph);
    CHECK(std::string{width.option} == "width");
    const error ellipsis = mesher.plan("EE", {.layout = {.ellipsis = "..."}}).error();
    CHECK(ellipsis == error::needs_paragraph);
    CHECK(std::string{ellipsis.option} == "ellipsis");

    const auto centred =
        build(mesher, "E", {.layout = {.width = 2.0, .wrap = wrap_mode::none, .align = alignment::centre}});
    CHECK(extent(centred, &vec3::x).low == Catch::Approx(1.0 - 0.3 + 0.05));
}

TEST_CASE("plain text with styles is the mesh of a paragraph with them", "[text]")
{
    test::toy_font font;
    const style_span spans[] = {{1, 3, {.size = 1.5, .decorations = decoration::underline, .style = style_id{1}}},
                                {3, 4, {.rise = 0.25, .style = style_id{2}}}};
    const shape_options how{.letter_spacing = 0.1, .styles = spans};
    const layout_options lines{.align = alignment::right, .anchor = vertical_anchor::top};
    paragraph words{font};
    const glyph_run run = test::laid_out(words, "oEix\nEo", how, lines);
    text_mesher mesher{font}, other{font};
    const auto plain = test::required(mesher.plan("oEix\nEo", {.shape = how, .layout = lines}));
    const auto page = test::required(other.plan(run));
    CHECK(plain->styles().size() == 3);
    CHECK(test::same_bits(test::written<full_mesh>(*plain), test::written<full_mesh>(*page)));
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/colour_font.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/mesh_laws.hpp"

#include <typemesh/colour/colour_outlines.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/layout/select_glyphs.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;
using namespace test;

namespace {

/// Two lines: the colour glyphs 1 and 2 around the plain glyph 3, then 1 again in style 7; the last glyph is missing.
void fill(glyph_run& run)
{
    run.units_per_em = 1000.0;
    REQUIRE(run.glyph_styles.push_back({}));
    REQUIRE(run.glyph_styles.push_back({.style = style_id{7}}));
    REQUIRE(run.glyphs.push_back({1, 10, {0, 0}}));
    REQUIRE(run.glyphs.push_back({3, 11, {1000, 0}}));
    REQUIRE(run.glyphs.push_back({2, 12, {2000, 0}}));
    REQUIRE(run.glyphs.push_back({1, 13, {0, -1200}, false, 1}));
    REQUIRE(run.glyphs.push_back({2, 14, {1000, -1200}, true, 0}));
    REQUIRE(run.lines.push_back({0, 3, {0, 0}, 3000.0}));
    REQUIRE(run.lines.push_back({3, 2, {0, -1200}, 2000.0}));
}

/// Glyph 1: red, the text's colour, blue; glyph 2: red and green.
colour_font toy_colours() { return flat_font({{1, {{9, 0}, {6, 0xFFFF}, {3, 2}}}, {2, {{8, 0}, {4, 1}}}}); }

/// The area of all upward faces in planes of one height, by height.
std::map<float, double> fronts_of(const full_mesh& m)
{
    std::map<float, double> all;
    for (std::size_t t = 0; t + 2 < m.indices.size(); t += 3) {
        const vec3 a = m.vertices[m.indices[t]].position, b = m.vertices[m.indices[t + 1]].position,
                   c = m.vertices[m.indices[t + 2]].position;
        const double area = (double(b.x - a.x) * double(c.y - a.y) - double(b.y - a.y) * double(c.x - a.x)) / 2.0;
        if (area > 0.0 && a.z <= b.z && a.z >= b.z && a.z <= c.z && a.z >= c.z) all[a.z] += area;
    }
    return all;
}

}  // namespace

TEST_CASE("a run's colour glyphs become layers in their order, its lines and other glyphs stay", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = toy_colours();
    colour_outlines colours{outlines};
    REQUIRE(colours.use(0, font.tables()));
    glyph_run run;
    fill(run);
    const auto report = colours.split(run);
    REQUIRE(report);
    CHECK(report->coloured == 3);
    CHECK(report->refused == 0);
    REQUIRE(run.glyphs.size() == 3 + 1 + 2 + 3 + 1);
    CHECK(run.lines[0].first_glyph == 0);
    CHECK(run.lines[0].glyph_count == 6);
    CHECK(run.lines[1].first_glyph == 6);
    CHECK(run.lines[1].glyph_count == 4);
    const cluster_id clusters[] = {10, 10, 10, 11, 12, 12, 13, 13, 13, 14};
    for (std::size_t i = 0; i < 10; ++i) CHECK(run.glyphs[i].cluster == clusters[i]);
    CHECK(run.glyphs[3].id == 3);
    CHECK(run.glyphs[9].id == 2);
    CHECK(run.glyphs[9].missing);
    const auto style = [&](std::size_t i) { return run.glyph_styles[run.glyphs[i].glyph_style].style; };
    CHECK(style(0) == style(4));  // red
    CHECK(style(0) == style(6));
    CHECK(style(1) == style_id{0});  // the text's own
    CHECK(style(7) == style_id{7});
    CHECK(style(2) != style(5));
    REQUIRE(colours.style_of(style(5)) != nullptr);
    CHECK(colours.style_of(style(5))->paint.entry == 1);
    CHECK(colours.style_of(style(5))->paint.colour == palette_colour{0, 255, 0, 1.0f});
    CHECK(colours.style_of(style_id{7}) == nullptr);
    CHECK(colours.styles().size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(run.glyphs[i].origin == point{0, 0});

    const auto again = colours.split(run);  // layers are no colour glyphs
    REQUIRE(again);
    CHECK(again->coloured == 0);
    CHECK(run.glyphs.size() == 10);
}

TEST_CASE("visible layers are closed solids that tile the glyph", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = toy_colours();
    colour_outlines colours{outlines};
    REQUIRE(colours.use(0, font.tables()));
    glyph_run run;
    run.units_per_em = 1000.0;
    REQUIRE(run.glyphs.push_back({1, 0}));
    REQUIRE(colours.split(run));
    text_mesher mesher{colours, extruded<>{.depth = 0.25f}};
    full_mesh all;
    const auto plan = mesher.plan(run);
    REQUIRE(plan);
    CHECK(plan->styles().size() == 3);
    REQUIRE(plan->write(into(all.vertices, all.indices)));
    CHECK(examine(all).is_closed());
    CHECK(std::fabs(test::volume(all.vertices, all.indices) - 0.81 * 0.25) < 1e-6);
    const auto fronts = fronts_of(all);
    REQUIRE(fronts.size() == 1);  // all in one plane, and none above another
    CHECK(std::fabs(fronts.begin()->second - 0.81) < 1e-6);
    double sum = 0.0;
    std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
    for (const style_id s : plan->styles()) {
        glyph_run some;
        REQUIRE(select_glyphs(run, [&](style_id own) noexcept { return own == s; }, some));
        full_mesh one;
        text_mesher other{colours, extruded<>{.depth = 0.25f}};
        REQUIRE(other.build(some, into(one.vertices, one.indices)));
        CHECK(examine(one).is_closed());
        sum += test::volume(one.vertices, one.indices);
    }
    CHECK(std::fabs(sum - 0.81 * 0.25) < 1e-6);
}

TEST_CASE("stacked layers have levels, and thin solids of them lie in planes of their own", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = toy_colours();
    colour_outlines colours{outlines, {.layers = layer_cut::stacked}};
    REQUIRE(colours.use(0, font.tables()));
    glyph_run run;
    fill(run);
    REQUIRE(colours.split(run));
    CHECK(colours.level_count() == 3);
    full_mesh all;
    std::size_t glyphs = 0;
    const double areas[] = {2 * 0.81 + 0.64 + 0.09, 2 * 0.36 + 0.16, 2 * 0.09};  // glyph 3 is plain
    for (std::uint32_t level = 0; level < 3; ++level) {
        glyph_run some;
        REQUIRE(select_glyphs(run, [&](style_id s) noexcept { return colours.level_of(s) == level; }, some));
        glyphs += some.glyphs.size();
        const float depth = level == 0 ? 0.25f : 0.01f;
        text_mesher mesher{colours, extruded<>{.depth = depth}};
        full_mesh one;
        const auto made = mesher.build(some, into(one.vertices, one.indices));
        REQUIRE(made);
        CHECK(examine(one).is_closed());
        const auto fronts = fronts_of(one);
        REQUIRE(fronts.size() == 1);
        CHECK(std::fabs(fronts.begin()->second - areas[level]) < 1e-6);
    }
    CHECK(glyphs == run.glyphs.size());
    // The text's colour above level 0 has a style for each style of the text.
    std::size_t of_text = 0;
    for (const colour_style& s : colours.styles())
        if (s.paint.is_text_colour()) {
            ++of_text;
            CHECK((s.own == style_id{0} || s.own == style_id{7}));
            CHECK(s.level == 1);
        }
    CHECK(of_text == 2);
}

TEST_CASE("normals of cut layers follow the curves, and their chords stay", "[colour]")
{
    recorded_outlines outlines{1000.0};
    for (const double radius : {400.0, 200.0})
        REQUIRE(outlines.add([&](auto& pen) {
            const double k = 0.5522847498 * radius, m = 500.0, r = radius;
            pen.move({m + r, m});
            pen.cubic({m + r, m + k}, {m + k, m + r}, {m, m + r});
            pen.cubic({m - k, m + r}, {m - r, m + k}, {m - r, m});
            pen.cubic({m - r, m - k}, {m - k, m - r}, {m, m - r});
            pen.cubic({m + k, m - r}, {m + r, m - k}, {m + r, m});
            pen.close();
        }));
    const colour_font font = flat_font({{7, {{0, 0}, {1, 1}}}});
    colour_outlines colours{outlines};
    REQUIRE(colours.use(0, font.tables()));
    glyph_run run;
    run.units_per_em = 1000.0;
    REQUIRE(run.glyphs.push_back({7, 0}));
    REQUIRE(colours.split(run));
    text_mesher mesher{colours, extruded<>{.depth = 0.25f}};
    full_mesh all;
    REQUIRE(mesher.build(run, into(all.vertices, all.indices)));
    CHECK(examine(all).is_closed());
    std::size_t walls = 0, wrong = 0;
    for (const full_vertex& v : all.vertices) {
        if (std::fabs(v.normal.z) > 0.5f) continue;
        ++walls;
        const double x = double(v.position.x) - 0.5, y = double(v.position.y) - 0.5, away = std::hypot(x, y);
        const double turned = std::fabs(x * double(v.normal.x) + y * double(v.normal.y)) / away;
        wrong += turned < std::cos(0.01) ? 1u : 0u;  // radii of the circle, within half a degree
    }
    CHECK(walls > 30);
    CHECK(wrong == 0);
}

TEST_CASE("refused glyphs stay plain and are counted, blank ones of bitmap fonts as well", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = flat_font({{1, {{77, 0}}}, {2, {{8, 0}, {4, 3}}}});
    colour_tables tables = font.tables();
    tables.has_bitmaps = true;
    colour_outlines colours{outlines};
    REQUIRE(colours.use(0, tables));
    glyph_run run;
    fill(run);
    REQUIRE(run.glyphs.push_back({0, 15, {2000, -1200}}));  // blank
    ++run.lines[1].glyph_count;
    const auto report = colours.split(run);
    REQUIRE(report);
    CHECK(report->coloured == 1);
    CHECK(report->translucent == 1);  // entry 3 lets the layer below shine through
    CHECK(report->refused == 2);
    CHECK(report->first_refusal == error::unknown_glyph);
    CHECK(report->first_refusal.glyph == 1);
    CHECK(report->first_refusal.cluster == 10);
    CHECK(report->pictures == 1);
    CHECK(run.glyphs[0].id == 1);
    CHECK(run.glyphs.size() == 7);
    run.glyphs[0].glyph_style = 99;
    CHECK(colours.split(run).error() == error::no_such_glyph_style);
    CHECK(run.glyphs.size() == 7);
}

TEST_CASE("the number of a layer's glyph is enough to draw it, and keys tell options apart", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = toy_colours();
    colour_outlines one{outlines}, other{outlines}, stacked{outlines, {.layers = layer_cut::stacked}};
    for (auto* c : {&one, &other, &stacked}) REQUIRE(c->use(0, font.tables()));
    glyph_run run;
    fill(run);
    REQUIRE(one.split(run));
    outline drawn, drawn_by_other;
    for (const placed_glyph& g : run.glyphs) {
        REQUIRE(record(one, g.id, drawn));
        REQUIRE(record(other, g.id, drawn_by_other));
        REQUIRE(drawn.curves.size() == drawn_by_other.curves.size());
        for (std::size_t i = 0; i < drawn.curves.size(); ++i)
            CHECK(drawn.curves[i].start() == drawn_by_other.curves[i].start());
    }
    CHECK(record(one, run.glyphs[0].id + 5, drawn).error() == error::unknown_glyph);
    CHECK(one.variation_key() == other.variation_key());
    CHECK(one.variation_key() != stacked.variation_key());
}

namespace {

/// Squares whose size is an axis: half as large, or whole.
struct growing_squares {
    [[nodiscard]] double units_per_em() const noexcept { return 1000.0; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }
    [[nodiscard]] std::uint64_t variation_key() const noexcept { return whole ? 1 : 2; }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        const double side = (whole ? 100.0 : 50.0) * id;
        sink.move({0.0, 0.0});
        sink.line({side, 0.0});
        sink.line({side, side});
        sink.line({0.0, side});
        sink.close();
        return {};
    }
    bool whole = true;
};

}  // namespace

TEST_CASE("layers follow the font's variation, and come back with it", "[colour]")
{
    growing_squares outlines;
    const colour_font font = toy_colours();
    colour_outlines colours{outlines};
    REQUIRE(colours.use(0, font.tables()));
    const std::uint64_t whole_key = colours.variation_key();
    outline drawn;
    for (const bool whole : {true, false, true}) {
        outlines.whole = whole;
        glyph_run run;
        fill(run);
        REQUIRE(colours.split(run));
        REQUIRE(record(colours, run.glyphs[2].id, drawn));  // the uppermost layer of glyph 1
        CHECK(drawn.bounds.high == (whole ? point{300.0, 300.0} : point{150.0, 150.0}));
        CHECK((colours.variation_key() == whole_key) == whole);
    }
    // Another place on the axes may paint otherwise.
    colour_font other = toy_colours();
    other.axes = {1000};
    REQUIRE(colours.use(0, other.tables()));
    CHECK(colours.variation_key() != whole_key);
}

TEST_CASE("colours are flattened as finely as texts", "[colour]")
{
    CHECK(same(colour_options{}.tolerance, text_options{}.tolerance));
}

TEST_CASE("splitting allocates nothing after warm-up, and fails whole without memory", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = toy_colours();
    counting_memory counted;
    colour_outlines colours{outlines, {}, counted.source()};
    REQUIRE(colours.use(0, font.tables()));
    glyph_run run{counted.source()};
    std::size_t requests = 0;
    for (int round = 0; round < 3; ++round) {
        if (round == 2) requests = counted.requests;
        run.clear();
        fill(run);
        REQUIRE(colours.split(run));
    }
    CHECK(counted.requests == requests);

    const std::size_t needed = check_each_failure([&](memory source) -> error {
        colour_outlines own{outlines, {}, source};
        if (const auto used = own.use(0, font.tables()); !used) return used.error();
        glyph_run some;
        fill(some);
        const auto report = own.split(some);
        if (!report) CHECK((some.glyphs.size() == 5 && some.glyph_styles.size() == 2));
        return report ? error{} : report.error();
    });
    CHECK(needed > 10);
}

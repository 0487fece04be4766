// SPDX-License-Identifier: MIT
//
// Every text of the workload with every font of its script, glyph by glyph, against the laws and the oracle.

#include "opened_font.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"
#include "support/oracle.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct subject {
    std::string script;
    test::workload_font font;
};

std::vector<subject> subjects()
{
    std::vector<subject> all;
    for (const auto& font : test::workload_fonts())
        for (const char* script : {"latin", "arabic", "chinese", "japanese"})
            if (font.serves(script) && font.available()) all.push_back({script, font});
    return all;
}

/// What the oracle says of one glyph: true when its contours cross or touch at this tolerance, so that they were resolved.
template <discretiser D>
bool is_resolved(outline_source auto& font, glyph_id id, const D& how, double tolerance_em)
{
    outline shape;
    contours loops;
    REQUIRE(record(font, id, shape));
    if (shape.curves.empty()) return false;
    const auto g = grid::fitting(font.units_per_em(), shape.bounds);
    REQUIRE(g);
    REQUIRE(discretise(shape, how, tolerance_em * font.units_per_em(), *g, loops));
    return test::oracle::is_crossing(test::oracle::loops_of(loops));
}

/// Twice the area of a cap as it was written, in square cells: exact, for caps in font units hold grid points exactly.
double cap_area(const test::full_mesh& m, const mesh_range& r)
{
    double area = 0.0;
    for (std::uint32_t i = r.first_index; i < r.first_index + r.index_count; i += 3) {
        const vec3 a = m.vertices[m.indices[i]].position, b = m.vertices[m.indices[i + 1]].position,
                   c = m.vertices[m.indices[i + 2]].position;
        const double twice = (double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x);
        REQUIRE(twice > 0.0);
        area += twice;
    }
    return area;
}

}  // namespace

TEST_CASE("every glyph of every text of the workload is present and closed, even where its contours meet", "[workload]")
{
    const auto s = GENERATE(from_range(subjects()));
    INFO(s.font.name << " (" << s.script << ")");
    auto font = test::opened(s.font.path);
    text_mesher mesher{font};

    std::size_t built = 0;
    std::set<glyph_id> resolved;
    for (const double tolerance : {quality::low, quality::high})
        for (const std::string& text : test::workload_texts(s.script)) {
            INFO(text << " at " << tolerance);
            auto plan = mesher.plan(text, {.tolerance = tolerance});
            REQUIRE(plan);
            CHECK(plan->report().invalid_units == 0);
            CHECK(plan->report().refused == 0);
            const auto m = test::written<test::full_mesh>(*plan);
            std::set<glyph_id> present;
            for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
                present.insert(plan->glyphs()[g].id);
                const auto own = test::indices_of(*plan, g, m);
                const auto law = test::examine(m.vertices, own);
                INFO("glyph " << plan->glyphs()[g].id);
                CHECK(law.unmatched_edges == 0);
                CHECK(law.crowded_slanted == 0);
                CHECK(law.zero_area == 0);
                CHECK(test::volume(m.vertices, own) > 0.0);
                ++built;
            }
            const auto normals =
                check_normals(inspect::mesh_view{m.vertices, m.indices}, &test::full_vertex::normal, 1, 5e-6);
            CHECK(normals.not_unit == 0);
            if (flipped_triangles(*plan) == 0) CHECK(normals.is_right());
            for (const auto& g : plan->run().glyphs) {
                if (g.missing) continue;
                if (is_resolved(font, g.id, certified{}, tolerance)) resolved.insert(g.id);
                if (!present.count(g.id)) {  // then it must be blank
                    outline shape;
                    REQUIRE(record(font, g.id, shape));
                    CHECK(shape.bounds.width() * shape.bounds.height() == 0.0);
                }
            }
        }
    CHECK(built > 100);
    std::string list;
    for (const glyph_id g : resolved) list += " " + std::to_string(g);
    if (!resolved.empty()) WARN(s.font.name << ": contours meet in glyphs" << list);
}

TEST_CASE("the four styles of normals have 2N, 4N, 4N+2H and 4N+2H vertices for every phrase", "[workload]")
{
    const auto s = GENERATE(from_range(subjects()));
    INFO(s.font.name << " (" << s.script << ")");
    auto font = test::opened(s.font.path);
    const auto law = [&](auto extruder, std::uint64_t per_point, bool doubles) {
        auto mesher = text_mesher{font}.with(extruder);
        for (const std::string& text : test::workload_lines("phrases-" + s.script + ".txt")) {
            auto plan = mesher.plan(text);
            REQUIRE(plan);
            const std::uint64_t n = plan->contour_points(), h = plan->hard_edges();
            CHECK(plan->size().vertices == per_point * n + (doubles ? 2 * h : 0));
            if (!doubles) CHECK(h == 0);
            CHECK(plan->range(part::side).index_count == 6 * n);
            CHECK(test::examine(test::written<test::full_mesh>(*plan)).unmatched_edges == 0);
        }
    };
    constexpr auto box = texture_mapping::box;  // without seams
    law(extruded<shared_normals>{.texture = box}, 2, false);
    law(extruded<averaged_normals>{.texture = box}, 4, false);
    law(extruded<creased_normals>{.texture = box}, 4, true);
    law(extruded<curve_normals>{.texture = box}, 4, true);
}

TEST_CASE("caps have exactly the area of the region, and walls close, for every rotation of the glyph", "[workload]")
{
    const auto s = GENERATE(from_range(subjects()));
    auto font = test::opened(s.font.path);
    const double degrees = GENERATE(0.0, 0.001, 90.0, 180.0);
    const bool mirrored = GENERATE(false, true);
    INFO(s.font.name << " (" << s.script << ") turned by " << degrees << (mirrored ? ", mirrored" : ""));

    const double angle = degrees * 3.14159265358979323846 / 180.0;
    const bool quarters = degrees == 90.0 || degrees == 180.0;  // which are exact
    const double c = quarters ? std::round(std::cos(angle)) : std::cos(angle);
    const double n = quarters ? std::round(std::sin(angle)) : std::sin(angle), m = mirrored ? -1.0 : 1.0;
    transformed_outlines turned{font, {.xx = c * m, .xy = -n, .yx = n * m, .yy = c}};

    shaped_by both{font, turned};
    auto mesher = text_mesher{both}.with(flat{});
    auto plan = mesher.plan(test::workload_texts(s.script).front(), {.unit = output_unit::font_units});
    REQUIRE(plan);
    CHECK(plan->report().refused == 0);

    text_mesher deep{both};
    auto walls = deep.plan(test::workload_texts(s.script).front());
    REQUIRE(walls);
    const auto solid = test::written<test::full_mesh>(*walls);
    CHECK(test::examine(solid).unmatched_edges == 0);
    CHECK(test::volume(solid.vertices, solid.indices) > 0.0);

    outline shape;
    contours loops;
    workspace space;
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        const auto& glyph = plan->glyphs()[g];
        glyph_run alone;  // at the origin, so that 32-bit floats hold the grid points exactly
        alone.units_per_em = font.units_per_em();
        REQUIRE(alone.glyphs.push_back({glyph.id, 0, {0, 0}}));
        auto single = text_mesher{turned}.with(flat{});
        auto own = single.plan(alone, {.unit = output_unit::font_units});
        REQUIRE(own);
        const auto mesh = test::written<test::full_mesh>(*own);
        REQUIRE(record(turned, glyph.id, shape));
        const auto grid_of = grid::fitting(font.units_per_em(), shape.bounds);
        REQUIRE(discretise(shape, certified{}, quality::high * font.units_per_em(), *grid_of, loops));
        const double cells = grid_of->cells;
        const double area = cap_area(mesh, own->range(part::front)) * cells * cells;
        const auto given = test::oracle::loops_of(loops);
        const double filled_area = test::oracle::doubled_filled_area(given, shape.rule);
        const double snapped = test::oracle::is_crossing(given) ? 2.0 * test::oracle::length(given) : 0.0;
        CHECK(std::fabs(area - filled_area) <= 1e-11 * filled_area + snapped);
        orient(loops);
        const auto filled = fill(loops, shape.rule, space);
        REQUIRE(filled);
        CHECK(area == static_cast<double>(test::oracle::doubled_area(test::oracle::loops_of(*filled))));
        CHECK(own->range(part::front).index_count == 3 * filled->triangle_count());
    }
}

TEST_CASE("the same text from FreeType's outlines is as closed as from HarfBuzz'", "[workload]")
{
    const auto s = GENERATE(from_range(subjects()));
    INFO(s.font.name);
    auto shapes = test::opened(s.font.path);
    auto draws = freetype_font::open(s.font.path.c_str());
    REQUIRE(draws);
    shaped_by font{shapes, *draws};
    text_mesher mesher{font}, reference{shapes};
    for (const std::string& text : test::workload_lines("phrases-" + s.script + ".txt")) {
        test::full_mesh m;
        const auto made = mesher.build(text, into(m.vertices, m.indices));
        REQUIRE(made);
        CHECK(test::examine(m).unmatched_edges == 0);
        CHECK(made->refused == reference.plan(text)->report().refused);
    }
}

TEST_CASE("the worst glyphs known are built and closed", "[workload]")
{
    std::size_t tried = 0;
    std::string absent;
    const auto rows = test::workload_lines("nasty-glyphs.tsv");
    for (std::size_t i = 1; i < rows.size(); ++i) {
        std::vector<std::string> column;
        std::istringstream row{rows[i]};
        for (std::string cell; std::getline(row, cell, '\t');) column.push_back(cell);
        INFO(column.at(1) << ", glyph " << column.at(3) << ": " << column.at(6));
        auto font = harfbuzz_font::open(("/" + column[1]).c_str(), {.face = std::uint32_t(std::stoul(column[2]))});
        if (font.error() == error::unreadable_file) {
            absent += " " + column[0];
            continue;
        }
        REQUIRE(font);
        ++tried;
        const auto id = glyph_id(std::stoul(column[3]));
        glyph_run run;
        run.units_per_em = font->units_per_em();
        REQUIRE(run.glyphs.push_back({id, 0, {0, 0}}));
        text_mesher mesher{*font};
        for (const double tolerance : {quality::low, quality::high}) {
            test::full_mesh m;
            const auto made = mesher.build(run, into(m.vertices, m.indices), {.tolerance = tolerance});
            REQUIRE(made);
            CHECK(made->refused == 0);
            const auto law = test::examine(m);
            CHECK(law.unmatched_edges == 0);
            CHECK(law.zero_area == 0);
            CHECK(test::volume(m.vertices, m.indices) > 0.0);
        }
    }
    if (!absent.empty()) WARN("skipped, fonts not installed:" << absent);
    CHECK(tried != 0);
}

TEST_CASE("a variable font is meshed at every end of its axes, and each weight has a different mesh", "[workload]")
{
    const std::string path = font_file("truetype/inter-vf/Inter.var.ttf");
    std::vector<double> volumes;
    for (const float weight : {100.0f, 400.0f, 900.0f}) {
        const variation wanted[] = {{"wght", weight}};
        INFO("Debian package fonts-inter-variable, at weight " << weight);
        auto font = test::opened(path, {.variations = wanted});
        text_mesher mesher{font};
        for (const std::string& text : test::workload_texts("latin")) {
            test::full_mesh m;
            const auto made = mesher.build(text, into(m.vertices, m.indices));
            REQUIRE(made);
            CHECK(made->refused == 0);
            CHECK(test::examine(m).unmatched_edges == 0);
            if (text == "Hello world!") volumes.push_back(test::volume(m.vertices, m.indices));
        }
    }
    REQUIRE(volumes.size() == 3);
    CHECK(volumes[0] < volumes[1]);
    CHECK(volumes[1] < volumes[2]);
}

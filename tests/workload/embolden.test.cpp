// SPDX-License-Identifier: MIT
//
// Bold and hollow letters of real fonts: closed at every distance, none narrowed, the same in every way that a text is
// built.

#include "opened_font.hpp"
#include "same_meshes.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct moved_vertex {
    vec3 place, normal;
    part of;

    friend bool operator==(const moved_vertex&, const moved_vertex&) = default;
};

struct moved_mesh {
    std::vector<moved_vertex> vertices;
    std::vector<std::uint32_t> indices;

    friend bool operator==(const moved_mesh&, const moved_mesh&) = default;
    [[nodiscard]] auto view() const { return inspect::mesh_view{vertices, indices, &moved_vertex::place}; }
};

}  // namespace

template <>
struct typemesh::vertex_traits<moved_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::part;
    moved_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.part}; }
};

namespace {

using framed = outlined<extruded<>, extruded<>>;

template <class Plan>
moved_mesh written(const Plan& plan)
{
    moved_mesh m;
    REQUIRE(plan.write(into(m.vertices, m.indices)));
    CHECK(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan.size());
    CHECK(inspect::check_closedness(m.view(), 2).is_closed());
    return m;
}

/// What became of the letters of all fonts.
struct tally {
    std::size_t letters = 0, gone = 0, refused = 0, narrowed = 0;
};

/// Every character of the workload in every font that serves it, letter by letter.
template <class E>
void check_letters(const E& how, tally& all)
{
    test::for_each_script([&](harfbuzz_font& font, const std::string& path, const std::string& script) {
        auto mesher = text_mesher{font}.with(how);
        for (const std::string& character : test::workload_lines("chars-" + script + ".txt")) {
            INFO(path << ", " << character);
            const auto plan = mesher.plan(character, {.unit = output_unit::font_units});  // floats are exact
            REQUIRE(plan);
            const text_report& report = plan->report();
            const bool gone = report.refused != 0 && report.first_refusal == error::nothing_left;
            all.gone += gone;
            all.refused += report.refused != 0 && !gone;
            all.narrowed += report.narrowed;
            if (plan->size().triangles == 0) continue;
            const moved_mesh m = written(*plan);
            CHECK(inspect::check_normals(m.view(), &moved_vertex::normal, 1).is_right());
            ++all.letters;
        }
    });
}

}  // namespace

TEST_CASE("bold letters of real fonts are closed and lit from outside, both bolder and thinner", "[workload]")
{
    tally all;
    for (const float by : {0.01f, 0.03f, 0.1f, -0.01f}) {
        INFO("by " << by);
        check_letters(embolden{.by = by}, all);
    }
    CHECK(all.letters >= 1000);
    CHECK(all.refused == 0);
    CHECK(all.narrowed == 0);

    tally thinnest;
    check_letters(embolden{.by = -0.05f}, thinnest);
    CHECK(thinnest.gone > 20);
    CHECK(thinnest.letters > 20);
    CHECK(thinnest.refused == 0);
}

TEST_CASE("hollow letters of real fonts are closed and lit from outside, with the ring in every place", "[workload]")
{
    tally all;
    for (const outline_place place : {outline_place::inner, outline_place::centre, outline_place::outer}) {
        INFO("place " << int(place));
        check_letters(framed{.width = 0.02f, .place = place}, all);
    }
    CHECK(all.letters >= 1000);
    CHECK(all.refused == 0);
    CHECK(all.gone == 0);
    CHECK(all.narrowed == 0);
}

TEST_CASE("bold, bevelled and hollow texts of real fonts are the same from caches, workers and merged", "[workload]")
{
    std::size_t texts = 0;
    test::for_each_script([&texts](harfbuzz_font& font, const std::string& path, const std::string& script) {
        const std::string text = test::workload_texts(script).back();
        INFO(path << ": " << text);
        const auto check = [&](const auto&... steps) {
            test::check_same_meshes(path, text, [](const auto& plan) { return written(plan); }, steps...);
            text_mesher mesher{font, steps...};
            const auto merged = mesher.plan(text, {.unit = output_unit::font_units, .merge = true});
            REQUIRE(merged);
            CHECK(merged->report().refused == 0);
            CHECK(merged->report().narrowed == 0);
            (void)written(*merged);
        };
        check(bevelled{.width = 0.01f}, embolden{.by = 0.015f});
        check(framed{.width = 0.015f, .place = outline_place::outer});
        ++texts;
    });
    CHECK(texts > 5);
}

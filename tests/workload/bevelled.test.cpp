// SPDX-License-Identifier: MIT
//
// Bevelled letters of real fonts: closed whatever strokes vanish, in every way that a text is built.

#include "opened_font.hpp"
#include "same_meshes.hpp"
#include "support/lit_mesh.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;
using test::lit_mesh;
using test::lit_vertex;

namespace {

/// The beginning of a script's first text, of 300 bytes at most.
std::string short_text(const std::string& script)
{
    std::string text = test::workload_texts(script).front();
    if (text.size() > 300) {
        std::size_t end = 300;
        while ((static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
        text.resize(end);
    }
    return text;
}

/// The triangles that are wider than 3 cells in the plane or stand upright: nodes are rounded by up to two, so that
/// narrower ones lean anywhere.
lit_mesh without_slivers(const lit_mesh& all, double cells_per_unit)
{
    lit_mesh wide{all.vertices, {}};
    for (std::size_t t = 0; t < all.indices.size(); t += 3) {
        const vec3 a = all.vertices[all.indices[t]].place, b = all.vertices[all.indices[t + 1]].place,
                   c = all.vertices[all.indices[t + 2]].place;
        const point ab{double{b.x} - double{a.x}, double{b.y} - double{a.y}},
            ac{double{c.x} - double{a.x}, double{c.y} - double{a.y}};
        const double longest = std::max({length(ab), length(ac), length(ac - ab)}), area = std::abs(cross(ab, ac));
        if (area > 0.0 && area <= 3.0 / cells_per_unit * longest) continue;
        wide.indices.insert(wide.indices.end(), {all.indices[t], all.indices[t + 1], all.indices[t + 2]});
    }
    return wide;
}

template <class Plan>
lit_mesh written_bevels(const Plan& plan)
{
    const lit_mesh m = test::written(plan);
    CHECK(inspect::check_closedness(m.view(), 2).is_closed());
    return m;
}

}  // namespace

TEST_CASE("bevelled letters of real fonts are closed and lit from outside at every width", "[workload]")
{
    std::size_t letters = 0, slivers = 0, triangles = 0;
    test::for_each_script([&](harfbuzz_font& font, const std::string& path, const std::string& script) {
        for (const float width : {0.01f, 0.03f, 0.05f, 0.3f}) {
            const bevelled how{.width = width, .bevel_depth = 0.05f, .profile = round_profile(4)};
            auto mesher = text_mesher{font}.with(how);
            for (const std::string& character : test::workload_lines("chars-" + script + ".txt")) {
                INFO(path << ", " << character << ", width " << width);
                const auto plan = mesher.plan(character, {.unit = output_unit::font_units});  // floats are exact
                REQUIRE(plan);
                if (plan->size().triangles == 0) continue;
                CHECK(plan->report().refused == 0);
                const lit_mesh all = written_bevels(*plan), m = without_slivers(all, 512.0);
                slivers += all.indices.size() / 3 - m.indices.size() / 3;
                triangles += all.indices.size() / 3;
                CHECK(inspect::check_normals(m.view(), &lit_vertex::normal, 1).is_right());
                ++letters;
            }
        }
    });
    CHECK(letters >= 1000);
    CHECK(slivers * 1000 < triangles);
}

TEST_CASE("bevelled texts are the same from caches, workers and every order of tasks", "[workload]")
{
    test::for_each_script([](harfbuzz_font&, const std::string& path, const std::string& script) {
        INFO(path << ", " << script);
        test::check_same_meshes(
            path, short_text(script), [](const auto& plan) { return written_bevels(plan); },
            bevelled{.width = 0.04f, .bevel_depth = 0.04f});
    });
}

TEST_CASE("bevelled letters that meet are merged first, and have one bevel around them", "[workload]")
{
    std::size_t groups = 0;
    test::for_each_script([&groups](harfbuzz_font& font, const std::string& path, const std::string& script) {
        if (script != "arabic") return;
        for (const std::string& phrase : test::workload_texts(script)) {
            INFO(path << ": " << phrase);
            auto mesher = text_mesher{font}.with(bevelled{.width = 0.01f, .bevel_depth = 0.01f});
            const auto plan = mesher.plan(phrase, {.unit = output_unit::font_units, .merge = true});
            REQUIRE(plan);
            CHECK(plan->report().refused == 0);
            for (std::size_t g = 0; g < plan->glyphs().size(); ++g) groups += plan->members(g).size() > 1;
            (void)written_bevels(*plan);
        }
    });
    CHECK(groups > 10);
}

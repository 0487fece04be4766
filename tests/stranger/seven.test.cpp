// SPDX-License-Identifier: MIT

// Seven strangers, each written from one comment: a discretiser, a triangulator, an extruder, an outline source, a vertex, a
// sink and a shaper. Their common results obey the laws of the library's own meshes. (tests/asserts shows what wrong ones
// report.)

#include <typemesh/inspect/cap_check.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/euler_count.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/text/shaped_by.hpp>
#include <typemesh/typemesh.hpp>

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "equal_steps.hpp"
#include "fixed_point_vertex.hpp"
#include "monospace_shaper.hpp"
#include "ply_sink.hpp"
#include "strangers.hpp"
#include "support/catch.hpp"
#include "support/required.hpp"
#include "svg_paths.hpp"
#include "tapering_twist.hpp"
#if defined(TYPEMESH_TEST_WITH_GLU)
#include "glu_tessellator.hpp"
#endif

using namespace typemesh;
using Catch::Approx;

namespace {

/// Three letters and a box for missing characters: O has curves and a hole, L is straight, i is two boxes.
struct drawn_font {
    stranger::svg_paths paths{100.0,
                              {"M10 100 V20 H60 V100 Z",
                               "M40 100 C62 100 80 82 80 60 S62 20 40 20 S0 38 0 60 S18 100 40 100 Z"
                               "M40 80 Q20 80 20 60 T40 40 T60 60 T40 80 z",
                               "m 10,20 v80 h50 v-15 H25 V20 z", "m10 40 h15 v60 h-15 z m0-30 h15 v15 h-15 z"}};
    stranger::monospace_shaper cells{100.0, 90.0, std::string{"\0OLi", 4}};
    shaped_by<stranger::monospace_shaper, stranger::svg_paths> both{cells, paths};
};

/// A mesh as a PLY file contains it.
struct ply_mesh {
    std::vector<std::array<float, 3>> places;
    std::vector<std::uint32_t> indices;

    explicit ply_mesh(std::span<const std::byte> file)
    {
        const char* text = reinterpret_cast<const char*>(file.data());
        const std::string end = "end_header\n", header{text, std::string{text, 300}.find(end) + end.size()};
        const auto number = [&](const char* what) {
            return std::stoul(header.substr(header.find(what) + std::strlen(what)));
        };
        places.resize(number("element vertex "));
        indices.resize(3 * number("element face "));
        const std::byte* next = file.data() + header.size();
        std::memcpy(places.data(), next, 12 * places.size());
        next += 12 * places.size();
        for (std::size_t t = 0; t < indices.size(); t += 3, next += 13) std::memcpy(&indices[t], next + 1, 12);
        CHECK(next == file.data() + file.size());
    }
};

constexpr const char* word = "OLi";

/// The word through a mesher, in a PLY file, read back.
template <class Mesher>
ply_mesh written(Mesher mesher)
{
    std::FILE* file = std::tmpfile();
    REQUIRE(file != nullptr);
    stranger::ply_sink sink{file};
    const text_options options;
    CHECK(test::required(mesher.build(word, sink, options))->complete());
    std::vector<std::byte> bytes(static_cast<std::size_t>(std::ftell(file)));
    std::rewind(file);
    REQUIRE(std::fread(bytes.data(), 1, bytes.size(), file) == bytes.size());
    std::fclose(file);
    return ply_mesh{bytes};
}

/// The volume of four solids, one with a hole, which must be closed and right side out.
double volume_of(const ply_mesh& m)
{
    const inspect::mesh_view mesh{m.places, m.indices};
    CHECK(inspect::check_closedness(mesh).is_closed());
    const inspect::euler_count euler = inspect::count_euler(mesh);
    CHECK(euler.solids == 4);
    CHECK(euler.holes() == 1);
    const double volume = inspect::measure(mesh).volume;
    CHECK(volume > 0.0);
    return volume;
}

constexpr double L_and_i = 0.1725 + 0.09 + 0.0225;  // areas, in em squared

}  // namespace

TEST_CASE("seven strangers make closed solids, each by itself and all together", "[stranger]")
{
    drawn_font font;
    const double own = volume_of(written(text_mesher{font.both})) / 0.2;
    CHECK(own > L_and_i + 0.3);  // and an O between a circle and its square
    CHECK(own < L_and_i + 0.6);
    CHECK(volume_of(written(text_mesher{font.both}.with(stranger::equal_steps{}))) / 0.2 == Approx(own).epsilon(0.01));
    CHECK(volume_of(written(text_mesher{font.both}.with(stranger::patient{}))) / 0.2 == Approx(own));

    const stranger::tapering_twist twist;
    const double twisted = volume_of(written(text_mesher{font.both}.with(twist)));
    const double mean = (1.0 + twist.taper + twist.taper * twist.taper) / 3.0;  // of the area, over the depth
    CHECK(twisted == Approx(own * twist.depth * mean).epsilon(0.02));
    auto all = text_mesher{font.both}.with(twist).with(stranger::equal_steps{});
#if defined(TYPEMESH_TEST_WITH_GLU)
    CHECK(volume_of(written(text_mesher{font.both}.with(stranger::glu_tessellator{}))) / 0.2 == Approx(own));
    CHECK(volume_of(written(std::move(all).with(stranger::glu_tessellator{}))) == Approx(twisted).epsilon(0.01));
#else
    CHECK(volume_of(written(std::move(all).with(stranger::patient{}))) == Approx(twisted).epsilon(0.01));
#endif
}

TEST_CASE("a stranger's packed vertex contains a closed mesh with right normals", "[stranger]")
{
    drawn_font font;
    const auto looked_at = [&](auto mesher, float size) {
        std::vector<stranger::fixed_point_vertex> vertices;
        std::vector<std::uint16_t> indices;
        const text_options options{.size = size};
        const auto plan = test::required(mesher.plan(word, options));
        REQUIRE(plan->write(into(vertices, indices)));
        const inspect::mesh_view mesh{vertices, indices, &stranger::fixed_point_vertex::place};
        CHECK(inspect::check_closedness(mesh).is_closed());
        const auto normals = inspect::check_normals(
            mesh,
            [](const auto& v) { return inspect::place{v.normal[0] / 127.0, v.normal[1] / 127.0, v.normal[2] / 127.0}; },
            1, 0.01);
        CHECK(normals.is_right());
        const auto back = plan->range(part::back);
        for (std::uint32_t i = 0; i < back.vertex_count; ++i)
            CHECK(vertices[back.first_vertex + i].part == static_cast<std::uint8_t>(part::back));
    };
    looked_at(text_mesher{font.both}, 1.0f);
    looked_at(text_mesher{font.both}.with(stranger::tapering_twist{.taper = 1.0}), 1.0f);
}

TEST_CASE("strangers' triangulators cover a region once", "[stranger]")
{
    drawn_font font;
    cap_builder caps;
    outline drawn;
    const auto covers = [&](const auto& how, glyph_id id) {
        REQUIRE(record(font.paths, id, drawn));
        REQUIRE(caps.flatten(drawn, stranger::equal_steps{}, 0.1, *test::required(grid::fitting(100.0, drawn.bounds))));
        const auto r = test::required(caps.fill({drawn.rule}, how));
        CHECK(std::string{inspect::check_cap(*r, caps.triangles().view()).broken()} == "");
    };
    for (const glyph_id id : {0u, 1u, 2u, 3u}) {
        covers(stranger::patient{}, id);
#if defined(TYPEMESH_TEST_WITH_GLU)
        covers(stranger::glu_tessellator{}, id);
#endif
    }
}

TEST_CASE("a stranger's shaper reports missing characters, and its drawings unknown glyphs", "[stranger]")
{
    drawn_font font;
    std::vector<stranger::fixed_point_vertex> vertices;
    std::vector<std::uint32_t> indices;
    text_mesher mesher{font.both};
    const auto report = test::required(mesher.build("OL\nOx", into(vertices, indices)));
    CHECK(report->missing == 1);
    CHECK(report->first_missing == 4);
    outline drawn;
    CHECK(record(font.paths, 4, drawn) == error::unknown_glyph);
}

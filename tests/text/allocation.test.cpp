// SPDX-License-Identifier: MIT

// Every operator new of this program is counted: see support/counted_allocations.hpp.

#include "support/catch.hpp"
#include "support/counted_allocations.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <cstdlib>
#include <vector>

using namespace typemesh;

TEST_CASE("the counter sees every block that the heap hands out", "[text]") { CHECK(test::every_allocation_counts()); }

TEST_CASE("after warm-up a text asks nobody for memory, in any layout of the output", "[text]")
{
    test::toy_font font;
    glyph_cache cache;
    plane_path ring;
    ring.circle({0.0, 0.0}, 2.0);
    const auto asked_by = [&](auto mesher, const text_options& options) {
        std::vector<test::full_vertex> vertices;
        std::vector<std::uint32_t> indices;
        std::vector<std::uint16_t> short_indices;
        std::vector<vec3> positions;
        std::vector<vec2> uvs;
        std::size_t before = 0;
        for (int i = 0; i < 4; ++i) {
            if (i == 2) before = test::allocations;
            auto plan = mesher.plan("oEi x~o\noEq", options);
            if (!plan) std::abort();
            if (i == 0) {
                vertices.resize(plan->size().vertices);
                positions.resize(vertices.size());
                uvs.resize(vertices.size());
                indices.resize(plan->size().indices());
                short_indices.resize(indices.size());
            }
            stream_sink streams{std::span{short_indices}, stream<attribute::position, vec3>{std::span{positions}},
                                stream<attribute::uv, vec2>{std::span{uvs}}};
            bool failed = false;
            failed |= !plan->write(into(std::span{vertices}, std::span{indices}));
            failed |= !plan->write(into(std::span{vertices}, std::span{short_indices}));
            failed |= !plan->write(into(vertices, indices));
            failed |= !plan->write(streams);
            failed |= !plan->write(glyph_span{1, 2}, streams);
            failed |= !plan->write_meshes(into(std::span{vertices}, std::span{indices}));
            plan->write_instances([&](const glyph_instance&) noexcept {});
            if (failed) std::abort();
        }
        return test::allocations - before;
    };
    for (const bool reuse : {true, false}) {
        for (const auto over : {texture_box::text, texture_box::line}) {
            const text_options options{.texture_over = over, .reuse = reuse};
            CHECK(asked_by(text_mesher{font}, options) == 0);
            CHECK(asked_by(text_mesher{font}.with(flat{}).with(constrained_delaunay{}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(extruded<shared_normals>{}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(bevelled{.profile = round_profile()}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(embolden{}).with(bevelled{}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(outlined<extruded<>, extruded<>>{}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(cached_in{cache, 1}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(warped{arc{.degrees = 20}}).with(bevelled{}), options) == 0);
            for (const path_warp warp : {path_warp::never, path_warp::always})
                CHECK(asked_by(text_mesher{font}.with(on_path{&ring, {.warp = warp}}), options) == 0);
        }
    }
}

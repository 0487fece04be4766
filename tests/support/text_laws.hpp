// SPDX-License-Identifier: MIT
#pragma once

// Laws of a text's mesh that hold for any extruder: it is the same through caches, teams and another triangulator, and in
// chunks, instances and partial writes.

#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace test {

constexpr const char* crossed_word = "oExi Eo";  // x has contours that cross

inline double volume_of(const lit_mesh& m) { return typemesh::inspect::measure(m.view()).volume; }

/// A lawful mesh of so many parts, none of them empty.
template <class Plan>
lit_mesh lawful_parts(const Plan& plan, std::size_t parts, const typemesh::frame& f = typemesh::right_handed_y_up)
{
    REQUIRE(plan.parts().size() == parts);
    for (const typemesh::part p : plan.parts()) CHECK(plan.range(p).vertex_count != 0);
    return lawful(plan, f);
}

/// A text comes out of caches, teams and constrained Delaunay as it is built alone. mesher_of(font, how) makes the mesher;
/// `other` is the same extruder with other options.
template <class Cache = typemesh::glyph_cache<>>
void check_everywhere(const auto& mesher_of, const auto& how, const auto& other)
{
    using namespace typemesh;
    toy_font font;
    auto mesher = mesher_of(font, how);
    const auto plan = required(mesher.plan(crossed_word));
    CHECK(plan->report().complete());
    CHECK(plan->report().narrowed == 0);
    const std::size_t parts = plan->parts().size();
    const lit_mesh expected = lawful_parts(*plan, parts);

    Cache cache;
    auto cached = mesher_of(font, how).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) CHECK(lawful_parts(*required(cached.plan(crossed_word)), parts) == expected);
    CHECK(cache.statistics().hits >= 5);
    auto unlike = mesher_of(font, other).with(cached_in{cache, 1});
    CHECK_FALSE(lawful_parts(*required(unlike.plan(crossed_word)), parts) == expected);

    scrambled_workers pool;
    auto team = toy_team(pool);
    for (int i = 0; i < 2; ++i) {
        const auto shared = required(mesher.plan(crossed_word, {}, *team));
        lit_mesh m;
        REQUIRE(shared->write(into(m.vertices, m.indices), pool));
        CHECK(m == expected);
    }

    auto delaunay = mesher_of(font, how).with(constrained_delaunay{});
    const lit_mesh cut = lawful_parts(*required(delaunay.plan(crossed_word)), parts);
    CHECK(cut.vertices.size() == expected.vertices.size());
    CHECK(volume_of(cut) == Catch::Approx(volume_of(expected)).epsilon(1e-5));
}

/// A text is cut into chunks of at most so many vertices, written as instances, and its second glyph is written alone.
template <class Plan>
void check_pieces(const Plan& plan, std::initializer_list<std::uint32_t> limits)
{
    using namespace typemesh;
    const lit_mesh whole = lawful(plan);
    text_chunks chunks;
    for (const std::uint32_t most : limits) {
        REQUIRE(chunks.cut(plan, most));
        std::vector<lit_vertex> vertices;
        std::vector<std::uint16_t> indices;
        REQUIRE(chunks.write(plan, into(vertices, indices)));
        lit_mesh all{vertices, {}};
        for (const text_chunk& c : chunks.view()) {
            CHECK(c.size().vertices <= most);
            const mesh_range r = c.range();
            for (std::uint32_t i = 0; i < r.index_count; ++i)
                all.indices.push_back(r.first_vertex + indices[r.first_index + i]);
            std::uint32_t next = r.first_vertex;
            for (const part p : plan.parts())
                for (std::uint32_t i = 0; i < c.range(p).vertex_count; ++i) REQUIRE(vertices[next++].of == p);
        }
        CHECK(all.indices.size() == whole.indices.size());
        CHECK(inspect::check_closedness(all.view()).is_closed());
        CHECK(volume_of(all) == Catch::Approx(volume_of(whole)));
    }

    lit_mesh once;
    REQUIRE(plan.write_meshes(into(once.vertices, once.indices)));
    CHECK(once.vertices.size() == plan.meshes_size().vertices);
    CHECK(inspect::check_closedness(once.view()).is_closed());
    for (std::size_t m = 0; m < plan.meshes().size(); ++m)
        for (const part p : plan.parts())
            for (std::uint32_t i = 0; i < plan.mesh_part(m, p).vertex_count; ++i)
                REQUIRE(once.vertices[plan.mesh_part(m, p).first_vertex + i].of == p);

    lit_mesh some = whole;
    for (const part p : plan.parts()) {
        const mesh_range r = plan.range(1, p);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) some.vertices[r.first_vertex + i] = {};
        for (std::uint32_t i = 0; i < r.index_count; ++i) some.indices[r.first_index + i] = 0;
    }
    CHECK_FALSE(some == whole);
    REQUIRE(plan.write(glyph_span{1, 2}, into(std::span{some.vertices}, std::span{some.indices})));
    CHECK(some == whole);
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

// What the styles of a run may change in a mesh: a styled text is compared with the same text in one style.

#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>
#include <vector>

namespace test {

using namespace typemesh;

/// A vertex with everything that a style must not change, and the style.
struct styled_vertex {
    vec3 position, normal;
    vec2 uv;
    glyph_id glyph;
    cluster_id cluster;
    std::uint32_t part;
    std::uint32_t style;
};

struct styled_mesh {
    std::vector<styled_vertex> vertices;
    std::vector<std::uint32_t> indices;
};

}  // namespace test

template <>
struct typemesh::vertex_traits<test::styled_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv | attribute::glyph |
                                  attribute::cluster | attribute::part | attribute::style;
    test::styled_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        const auto number = [](auto named) { return static_cast<std::uint32_t>(named); };
        return {s.position, s.normal, s.uv, s.glyph, s.cluster, number(s.part), number(s.style)};
    }
};

namespace test {

/// The same run with each glyph in a random style, of a few that are neither neighbours nor in order.
inline glyph_run styled_at_random(const glyph_run& plain, std::uint32_t seed)
{
    constexpr std::uint32_t numbers[] = {7, 0, 0xFFFF'FFF0u, 3, 7};
    std::mt19937 random{seed};
    glyph_run run;
    run.units_per_em = plain.units_per_em;
    for (const std::uint32_t n : numbers) REQUIRE(run.glyph_styles.push_back({.style = style_id{n}}));
    for (placed_glyph g : plain.glyphs) {
        g.glyph_style = static_cast<std::uint32_t>(random() % std::size(numbers));
        REQUIRE(run.glyphs.push_back(g));
    }
    REQUIRE(run.lines.append(plain.lines.view()));
    return run;
}

/// Every triangle by the bytes of its vertices except for their style, sorted: what is drawn, in any order.
using drawn_triangle = std::array<unsigned char, 3 * sizeof(styled_vertex)>;

inline void add_triangles(const styled_mesh& m, std::vector<drawn_triangle>& out)
{
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        drawn_triangle t;
        for (std::size_t k = 0; k < 3; ++k) {
            styled_vertex v = m.vertices[m.indices[i + k]];
            v.style = 0;
            std::memcpy(t.data() + k * sizeof v, &v, sizeof v);
        }
        out.push_back(t);
    }
    std::sort(out.begin(), out.end());
}
inline std::vector<drawn_triangle> triangles_of(const styled_mesh& m)
{
    std::vector<drawn_triangle> out;
    add_triangles(m, out);
    return out;
}

/// The glyphs come style by style, ranges of styles and of glyphs tile the mesh, and vertices have their style.
inline void check_ranges(const auto& plan, const glyph_run& run, const styled_mesh& m)
{
    const auto glyphs = plan.glyphs();
    for (std::size_t g = 0; g < glyphs.size(); ++g) {
        CHECK(glyphs[g].style == run.glyph_styles[run.glyphs[glyphs[g].glyph].glyph_style].style);
        if (g == 0) continue;
        const bool ascends = glyphs[g - 1].style != glyphs[g].style ? glyphs[g - 1].style < glyphs[g].style
                                                                    : glyphs[g - 1].glyph < glyphs[g].glyph;
        CHECK(ascends);
    }
    std::size_t glyph = 0;
    for (const style_id s : plan.styles()) {
        const glyph_span own = plan.glyphs_of(s);
        CHECK(own.first == glyph);
        REQUIRE(own.last > own.first);
        for (; glyph < own.last; ++glyph) CHECK(glyphs[glyph].style == s);
    }
    CHECK(glyph == glyphs.size());

    std::uint32_t vertex = 0, index = 0;
    for (const part p : all_parts) {
        for (const style_id s : plan.styles()) {
            const mesh_range of_style = plan.range(s, p);
            CHECK(of_style.first_vertex == vertex);
            CHECK(of_style.first_index == index);
            for (std::size_t g = plan.glyphs_of(s).first; g < plan.glyphs_of(s).last; ++g) {
                const mesh_range r = plan.range(g, p);
                CHECK(r.first_vertex == vertex);
                CHECK(r.first_index == index);
                vertex += r.vertex_count;
                index += r.index_count;
            }
            CHECK(of_style.first_vertex + of_style.vertex_count == vertex);
            CHECK(of_style.first_index + of_style.index_count == index);
            bool of_its_style = true;
            for (std::uint32_t v = of_style.first_vertex; v < vertex; ++v)
                of_its_style = of_its_style && m.vertices[v].style == static_cast<std::uint32_t>(s) &&
                               m.vertices[v].part == static_cast<std::uint32_t>(p);
            for (std::uint32_t i = of_style.first_index; i < index; ++i)
                of_its_style = of_its_style && m.vertices[m.indices[i]].style == static_cast<std::uint32_t>(s);
            CHECK(of_its_style);
        }
    }
    CHECK(vertex == m.vertices.size());
    CHECK(index == m.indices.size());
}

/// Each glyph's own mesh is the same bit for bit, wherever it lies.
inline void check_glyphs(const auto& plain, const styled_mesh& of_plain, const auto& styled, const styled_mesh& m)
{
    REQUIRE(plain.glyphs().size() == styled.glyphs().size());
    std::map<std::uint32_t, std::size_t> by_place;
    for (std::size_t g = 0; g < plain.glyphs().size(); ++g) by_place[plain.glyphs()[g].glyph] = g;
    for (std::size_t g = 0; g < styled.glyphs().size(); ++g) {
        REQUIRE(by_place.count(styled.glyphs()[g].glyph) == 1);
        const std::size_t other = by_place[styled.glyphs()[g].glyph];
        for (const part p : all_parts) {
            const mesh_range a = styled.range(g, p), b = plain.range(other, p);
            REQUIRE(a.vertex_count == b.vertex_count);
            REQUIRE(a.index_count == b.index_count);
            for (std::uint32_t v = 0; v < a.vertex_count; ++v) {
                styled_vertex one = m.vertices[a.first_vertex + v], two = of_plain.vertices[b.first_vertex + v];
                one.style = two.style = 0;
                REQUIRE(std::memcmp(&one, &two, sizeof one) == 0);
            }
            for (const part to : all_parts) {  // a wall may use a cap's vertices
                const mesh_range here = styled.range(g, to), there = plain.range(other, to);
                for (std::uint32_t i = 0; i < a.index_count; ++i) {
                    const std::uint32_t v = m.indices[a.first_index + i], w = of_plain.indices[b.first_index + i];
                    const bool in_here = v - here.first_vertex < here.vertex_count;
                    REQUIRE(in_here == (w - there.first_vertex < there.vertex_count));
                    if (in_here) REQUIRE(v - here.first_vertex == w - there.first_vertex);
                }
            }
        }
    }
}

/// Glyphs written by themselves arrive at their places in the whole mesh, and nothing else is touched.
inline void check_partial_writes(const auto& plan, const styled_mesh& whole)
{
    styled_mesh assembled;
    assembled.vertices.resize(whole.vertices.size());
    assembled.indices.resize(whole.indices.size());
    for (const style_id s : plan.styles()) {
        styled_mesh one;
        one.vertices.resize(whole.vertices.size(), styled_vertex{{9, 9, 9}, {}, {}, 1, 2, 3, 4});
        one.indices.resize(whole.indices.size(), 0xFFFF'FFFFu);
        REQUIRE(plan.write(plan.glyphs_of(s), into(std::span{one.vertices}, std::span{one.indices})));
        std::uint32_t touched = 0, expected = 0;
        for (const std::uint32_t i : one.indices) touched += i != 0xFFFF'FFFFu ? 1u : 0u;
        for (const part p : all_parts) {
            const mesh_range r = plan.range(s, p);
            expected += r.index_count;
            std::copy_n(one.vertices.begin() + r.first_vertex, r.vertex_count,
                        assembled.vertices.begin() + r.first_vertex);
            std::copy_n(one.indices.begin() + r.first_index, r.index_count, assembled.indices.begin() + r.first_index);
        }
        CHECK(touched == expected);
    }
    CHECK(same_bits(assembled, whole));
}

/// Chunks draw the same, and the ranges of styles tile each of them.
inline void check_chunks(const auto& plan, const styled_mesh& whole, std::uint32_t most)
{
    text_chunks chunks;
    REQUIRE(chunks.cut(plan, most));
    std::vector<drawn_triangle> drawn;
    for (std::size_t k = 0; k < chunks.view().size(); ++k) {
        const text_chunk& c = chunks.view()[k];
        styled_mesh m;
        REQUIRE(chunks.write(plan, k, into(m.vertices, m.indices)));
        add_triangles(m, drawn);
        for (const part p : all_parts) {
            const mesh_range all = c.range(p);
            std::uint32_t vertex = all.first_vertex, index = all.first_index;
            for (const style_id s : plan.styles()) {
                const mesh_range r = chunks.range(plan, k, s, p);
                CHECK(r.first_vertex == vertex);
                CHECK(r.first_index == index);
                bool of_its_style = true;
                for (std::uint32_t v = 0; v < r.vertex_count; ++v)
                    of_its_style =
                        of_its_style && m.vertices[vertex - c.first_vertex + v].style == static_cast<std::uint32_t>(s);
                for (std::uint32_t i = 0; i < r.index_count; ++i)
                    of_its_style = of_its_style && m.vertices[m.indices[index - c.first_index + i]].style ==
                                                       static_cast<std::uint32_t>(s);
                CHECK(of_its_style);
                vertex += r.vertex_count;
                index += r.index_count;
            }
            CHECK(vertex == all.first_vertex + all.vertex_count);
            CHECK(index == all.first_index + all.index_count);
        }
    }
    std::sort(drawn.begin(), drawn.end());
    CHECK((drawn == triangles_of(whole)));
}

/// Instances come mesh by mesh, and style by style within a mesh, each glyph once. Meshes that have shapes have different
/// ones, if glyphs are reused.
inline void check_instances(const auto& plan, bool reuse)
{
    for (std::size_t mesh = 0; reuse && mesh < plan.meshes().size(); ++mesh)
        for (std::size_t other = 0; other < mesh && plan.shape_of(mesh).id != no_glyph; ++other)
            REQUIRE_FALSE(plan.shape_of(other) == plan.shape_of(mesh));
    std::vector<glyph_instance> all;
    plan.write_instances([&](const glyph_instance& i) { all.push_back(i); });
    REQUIRE(all.size() == plan.glyphs().size());
    std::vector<int> seen(all.size(), 0);
    std::size_t k = 0;
    for (std::size_t mesh = 0; mesh < plan.meshes().size(); ++mesh) {
        CHECK(plan.meshes()[mesh].first_instance == k);
        for (const style_id s : plan.styles()) {
            const instance_range r = plan.instances(mesh, s);
            CHECK(r.first == k);
            for (std::uint32_t i = 0; i < r.count; ++i, ++k) {
                REQUIRE(k < all.size());
                CHECK(all[k].mesh == mesh);
                CHECK(all[k].style == s);
                CHECK(plan.glyphs()[all[k].glyph].style == s);
                ++seen[all[k].glyph];
            }
        }
        CHECK(plan.meshes()[mesh].first_instance + plan.meshes()[mesh].glyph_count == k);
    }
    CHECK(k == all.size());
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(seen.size()));
}

/// A merged styled text is the sum of its styles merged one by one, and a triangle's owner has its style.
inline void check_merging(auto& mesher, const glyph_run& run, text_options options)
{
    options.merge = true;
    options.texture_over = texture_box::glyph;  // over the whole text it would depend on the other glyphs
    std::vector<drawn_triangle> expected;
    std::map<style_id, std::vector<std::uint32_t>> members;
    std::map<style_id, bool> in_use;
    for (const placed_glyph& g : run.glyphs) in_use[run.glyph_styles[g.glyph_style].style] = true;
    for (const auto& [s, used] : in_use) {
        glyph_run single;
        single.units_per_em = run.units_per_em;
        REQUIRE(single.lines.append(run.lines.view()));
        for (placed_glyph g : run.glyphs) {
            g.missing = g.missing ||
                        run.glyph_styles[g.glyph_style].style != s;  // its position stays, and nothing is drawn there
            g.glyph_style = 0;
            REQUIRE(single.glyphs.push_back(g));
        }
        const auto plan = mesher.plan(single, options);
        REQUIRE(plan);
        add_triangles(written<styled_mesh>(*plan), expected);
        for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
            for (const std::uint32_t m : plan->members(g)) members[s].push_back(m);
    }
    const auto plan = mesher.plan(run, options);
    REQUIRE(plan);
    const styled_mesh merged = written<styled_mesh>(*plan);
    check_ranges(*plan, run, merged);
    CHECK((triangles_of(merged) == expected));
    std::map<style_id, std::vector<std::uint32_t>> found;
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        const style_id s = plan->glyphs()[g].style;
        for (const std::uint32_t m : plan->members(g)) {
            CHECK(run.glyph_styles[run.glyphs[m].glyph_style].style == s);
            found[s].push_back(m);
        }
        for (const part p : all_parts)
            for (std::uint32_t t = 0; t < plan->range(g, p).index_count / 3; ++t) {
                const std::uint32_t owner = plan->owner(g, p, t);
                if (owner != shared_glyph && run.glyph_styles[run.glyphs[owner].glyph_style].style != s)
                    FAIL("another style's triangle");
            }
    }
    CHECK(found == members);
    check_partial_writes(*plan, merged);
    for (const std::uint32_t most : {200u, 5000u}) check_chunks(*plan, merged, most);
}

/// All checks. `mesher`, `other_mesher`: two of one type; `pool`: workers with sources of the second one.
template <class Mesher, class Team>
void check_styles(Mesher& mesher, Mesher& other_mesher, Team& pool, const glyph_run& plain_run,
                  const text_options& options, std::uint32_t seed)
{
    const glyph_run run = styled_at_random(plain_run, seed);
    const auto plain = mesher.plan(plain_run, options);
    const auto styled = other_mesher.plan(run, options);
    REQUIRE(plain);
    REQUIRE(styled);
    const styled_mesh of_plain = written<styled_mesh>(*plain), m = written<styled_mesh>(*styled);
    CHECK(styled->size() == plain->size());
    CHECK(styled->bounds().low == plain->bounds().low);
    CHECK(styled->bounds().high == plain->bounds().high);
    CHECK(styled->meshes().size() == plain->meshes().size());
    CHECK(flipped_triangles(*styled) == flipped_triangles(*plain));
    CHECK((triangles_of(m) == triangles_of(of_plain)));
    check_ranges(*styled, run, m);
    check_glyphs(*plain, of_plain, *styled, m);
    check_partial_writes(*styled, m);
    for (const std::uint32_t most : {30u, 200u, 5000u}) check_chunks(*styled, m, most);
    check_instances(*styled, options.reuse);

    styled_mesh shared;
    scrambled_workers several{4};
    shared.vertices.resize(m.vertices.size());
    shared.indices.resize(m.indices.size());
    REQUIRE(styled->write(into(std::span{shared.vertices}, std::span{shared.indices}), several));
    CHECK(same_bits(shared, m));
    const auto by_pool = other_mesher.plan(run, options, pool);
    REQUIRE(by_pool);
    CHECK(same_bits(written<styled_mesh>(*by_pool), m));

    check_merging(mesher, run, options);
}

}  // namespace test

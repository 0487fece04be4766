// SPDX-License-Identifier: MIT
//
// Compiled with more warnings than the other tests, all of them errors: what a user sees of the headers, and of the
// templates that are made of them, who turns everything on. Nothing is run. CMakeLists.txt names the warnings.

#include "adapter_headers.hpp"  // of the adapters whose libraries are there
#include "core_headers.hpp"

#include <support/toy_font.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace {

using namespace typemesh;

/// Takes every attribute, and packs it in every format.
struct packed_vertex {
    vec3 position;
    std::array<half, 2> uv;
    std::array<snorm8, 3> normal8;
    std::array<unorm16, 2> uv16;
    snorm10 normal10;
    unorm10 uv10;
    octahedral32 folded;
    octahedral_tangent32 tangent;
    std::uint32_t glyph, cluster;
    bgra8 colour;
};

}  // namespace

template <>
struct typemesh::vertex_traits<packed_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent |
                                  attribute::glyph | attribute::cluster | attribute::part;
    packed_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        const vec3 n = s.normal;
        const vec4 t = s.tangent;
        const part_colours<> colours{{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
        return {s.position,       {s.uv.x, s.uv.y},     {n.x, n.y, n.z},
                {s.uv.x, s.uv.y}, {n.x, n.y, n.z},      {s.uv.x, s.uv.y, 0.0f},
                {n.x, n.y, n.z},  {t.x, t.y, t.z, t.w}, s.glyph,
                s.cluster,        colours(s.part)};
    }
};

namespace {

/// A text through one choice of policies: planned, chunked, counted and written in every way.
template <class Mesher>
error everything(Mesher&& mesher)
{
    auto plan = mesher.plan("text", {.merge = true});
    if (!plan) return plan.error();
    std::vector<packed_vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::array<std::uint16_t, 3> short_indices{};
    std::array<packed_vertex, 3> three{};
    std::array<vec3, 3> places{};
    std::array<box_position, 3> boxed{};
    one_worker alone;
    auto done = plan->write(into(vertices, indices)).and_then([&]() noexcept {
        return plan->write(into(std::span{three}, std::span{short_indices}), alone);
    });
    if (done) done = plan->write(glyph_span{0, 1}, into(vertices, indices));
    if (done) done = plan->write_meshes(into(vertices, indices));
    plan->write_instances([](const glyph_instance&) noexcept {});
    const bounds3 bounds = plan->bounds();
    const position_box box = position_box::around(bounds.low, bounds.high);
    (void)box.decoded(box(bounds.low));
    stream_sink streams{
        std::span{indices}, stream<attribute::position, vec3>{std::span{places}},
        computed_stream<attribute::position>(
            std::span{boxed}, [box](const surface_point<attribute::position>& s) noexcept { return box(s.position); })};
    if (done) done = plan->write(streams);
    text_chunks chunks;
    if (done) done = chunks.cut(*plan);
    if (done) done = chunks.write(*plan, into(vertices, indices));
    (void)flipped_triangles(*plan);
    (void)plan->position_step();
    if constexpr (requires { plan->hard_edges(); }) (void)plan->hard_edges();
    (void)snorm8{0.5f}.operator float();
    (void)half{0.5f}.operator float();
    (void)snorm10{0.0f, 0.0f, 1.0f}.decoded();
    (void)unorm10{0.0f, 0.0f, 1.0f}.decoded();
    (void)octahedral16{0.0f, 0.0f, 1.0f}.decoded();
    (void)octahedral_tangent16{1.0f, 0.0f, 0.0f, 1.0f}.decoded();
    return done.error();
}

template <class Font>
error every_policy(Font& font)
{
    glyph_cache<> cache;
    if (error e = everything(text_mesher{font})) return e;
    if (error e = everything(text_mesher{font}.with(constrained_delaunay{}).with(two_lines{}))) return e;
    if (error e =
            everything(text_mesher{font}.with(thesis_quality{thesis_quality::high, font.units_per_em()}).with(flat{})))
        return e;
    if (error e = everything(text_mesher{font}.with(extruded<shared_normals>{}))) return e;
    if (error e = everything(text_mesher{font}.with(extruded<cap_normals>{}))) return e;
    if (error e = everything(text_mesher{font}.with(extruded<averaged_normals>{}))) return e;
    if (error e = everything(text_mesher{font}.with(extruded<creased_normals>{}))) return e;
    if (error e = everything(text_mesher{font}.with(cached_in{cache, 1}))) return e;
    d3dx_text compatible{font};
    auto plan = compatible.plan("text");
    if (!plan) return plan.error();
    std::array<d3dx_glyph_metrics, 4> metrics;
    if (const auto done = plan->metrics(metrics); !done) return done.error();
    one_worker alone;
    auto team = workers_of(alone, [&](std::size_t) noexcept { return result{transformed_outlines{font, affine{}}}; });
    if (!team) return team.error();
    glyph_run run;
    text_mesher mesher{font};
    return mesher.plan(run, {}, *team).error();
}

}  // namespace

int main()
{
    test::toy_font toy;
    error e = every_policy(toy);
#ifdef TYPEMESH_WITH_HARFBUZZ
    if (auto font = harfbuzz_font::open("")) e = every_policy(*font);
#endif
#ifdef TYPEMESH_WITH_FREETYPE
    if (auto font = freetype_font::open("")) e = every_policy(*font);
#endif
    return e ? 1 : 0;
}

// SPDX-License-Identifier: MIT
#pragma once

#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/typemesh.hpp>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>

/// A glyph from an untrusted font, with every kind of policy: a lawful mesh or a clear refusal, in bounded time and memory.
namespace hostile {

using namespace typemesh;

/// The largest of some values, and its place.
struct worst {
    double value = 0.0;
    std::string where;

    void add(double v, const std::string& at)
    {
        if (v > value) value = v, where = at;
    }
};

struct trials {
    std::string place;  ///< of the glyph being tried
    std::uint64_t glyphs = 0, blank = 0, meshes = 0, triangles = 0;
    std::map<std::string, std::uint64_t> refusals;  ///< by error: of opening, of outlines, of meshes
    std::map<std::string, std::uint64_t> broken;    ///< by law
    worst seconds, bytes;                           ///< of one mesh
    worst points;                                   ///< of one glyph, at the finest tolerance tried

    void breaks(const std::string& law, const char* policies) { ++broken[law + ": " + place + ", " + policies]; }
};

/// The limits of a program that does not trust its fonts. Memory: 0.3 kB a point, 1.5 kB with bevels.
inline constexpr std::uint32_t max_points = 50'000, max_pieces = 50'000;
inline constexpr double max_bytes = 200e6;

/// One glyph of any font, as it was recorded.
struct held_glyph {
    typemesh::outline shape;
    double em = 1000.0;

    [[nodiscard]] double units_per_em() const noexcept { return em; }
    [[nodiscard]] fill_rule fill() const noexcept { return shape.rule; }
    template <class Sink>
    [[nodiscard]] error outline(glyph_id, Sink& sink) const noexcept
    {
        draw_outline(shape, sink);
        return {};
    }
};

/// Acceptable reasons not to build a glyph.
inline bool is_a_refusal(const error& e)
{
    for (const error::kind k : {error::outline_not_finite, error::outline_beyond_grid, error::too_many_pieces,
                                error::too_many_points, error::nothing_left, error::edges_not_moved})
        if (e == k) return true;
    return false;
}

template <class Plan>
void check_mesh(const Plan& plan, bool is_flat, const char* policies, trials& seen)
{
    test::full_mesh m;
    if (!plan.write(into(m.vertices, m.indices))) return seen.breaks("write() fails", policies);
    if (!(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan.size()))
        return seen.breaks("another size than planned", policies);
    const auto closed = test::examine(m);
    if (closed.bad_corners != 0) seen.breaks("corners that are no vertices or not finite", policies);
    if (!is_flat && closed.unmatched_edges != 0) seen.breaks("the mesh is open", policies);
    for (const auto& v : m.vertices)
        if (!(std::fabs(test::dot(v.normal, v.normal) - 1.0) < 1e-4))
            return seen.breaks("a normal is not of unit length", policies);
    ++seen.meshes;
    seen.triangles += plan.size().triangles;
}

/// How a glyph is built.
template <class Extruder, class Discretiser = certified, class Triangulator = monotone>
struct way {
    const char* policies;  ///< in words
    Extruder raise = {};
    double tolerance = quality::normal;
    Discretiser flatten{};
    Triangulator cut{};
    embolden step = {.by = 0.0f};
};

template <class Extruder, class... Policy>
void try_mesh(held_glyph& font, const way<Extruder, Policy...>& how, trials& seen)
{
    const char* policies = how.policies;
    test::counting_memory counted;
    {
        text_mesher mesher{font, counted.source(), how.raise, how.flatten, how.cut};
        if (how.step.by != 0.0f) mesher.use(how.step);
        glyph_run run;
        run.units_per_em = font.em;
        if (!run.glyphs.push_back({0, 0, {}})) return seen.breaks("the tests' memory ends", policies);
        const auto begin = std::chrono::steady_clock::now();
        const auto plan = mesher.plan(run, {.tolerance = how.tolerance,
                                            .max_pieces = max_pieces,
                                            .max_points = max_points,
                                            .unit = output_unit::font_units});
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        seen.seconds.add(taken.count(), seen.place + ", " + policies);
        if (!plan) {
            seen.breaks(plan.error().message(), policies);
        } else if (const error e = plan->report().first_refusal) {
            if (!is_a_refusal(e)) seen.breaks(e.message(), policies);
            ++seen.refusals[e.message()];
        } else {
            seen.points.add(static_cast<double>(plan->contour_points()), seen.place + ", " + policies);
            check_mesh(*plan, std::is_same_v<Extruder, flat>, policies, seen);
        }
    }
    const auto peak = static_cast<double>(counted.peak);
    seen.bytes.add(peak, seen.place + ", " + policies);
    if (peak > max_bytes) seen.breaks("more memory than allowed", policies);
}

/// Each discretiser, triangulator and style of normals at least once.
inline void try_policies(held_glyph& font, trials& seen)
{
    const double em = font.em;
    try_mesh(font, way<extruded<>>{"extruded"}, seen);
    try_mesh(font, way<extruded<averaged_normals>>{.policies = "fine, extruded", .tolerance = quality::best}, seen);
    try_mesh(font, way<flat, two_lines, constrained_delaunay>{"two_lines, flat"}, seen);
    try_mesh(font,
             way<extruded<shared_normals>, adaptive_subdivision>{.policies = "adaptive_subdivision, extruded",
                                                                 .flatten = adaptive_subdivision::normal(em)},
             seen);
    try_mesh(font,
             way<extruded<creased_normals>, thesis_quality, constrained_delaunay>{
                 .policies = "thesis_quality, extruded", .flatten = thesis_quality{thesis_quality::high, em}},
             seen);
    try_mesh(font,
             way<bevelled, certified, constrained_delaunay>{"bevelled", {.width = 0.03f, .profile = round_profile(4)}},
             seen);
    try_mesh(font, way<bevelled>{"bevelled outwards", {.outward = true}}, seen);
    try_mesh(font, way<extruded<cap_normals>>{.policies = "embolden, extruded", .step = {.by = 0.02f}}, seen);
    try_mesh(font, way<extruded<>>{.policies = "embolden inwards, extruded", .step = {.by = -0.02f}}, seen);
    try_mesh(font, way<outlined<>>{"outlined"}, seen);
}

/// All glyphs of the first face, or `most` of them evenly.
template <class Font>
void try_glyphs(std::span<const std::byte> bytes, const std::string& name, std::uint32_t most, trials& seen)
{
    auto font = Font::open(bytes, {});
    if (!font) {
        ++seen.refusals[font.error().message()];
        return;
    }
    held_glyph held;
    held.em = font->units_per_em();
    const std::uint32_t count = font->glyph_count(), step = most == 0 ? 1 : (count + most - 1) / most;
    for (glyph_id id = 0; id < count; id += step == 0 ? 1 : step) {
        ++seen.glyphs;
        seen.place = name + ", glyph " + std::to_string(id);
        const auto begin = std::chrono::steady_clock::now();
        const error e = record(*font, id, held.shape, max_points).error();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        seen.seconds.add(taken.count(), seen.place + ", its outline");
        if (e) {
            ++seen.refusals[e.message()];
            if (!is_a_refusal(e) && !(e == error::unknown_glyph)) seen.breaks(e.message(), "its outline");
        } else if (held.shape.curves.empty()) {
            ++seen.blank;
        } else {
            try_policies(held, seen);
        }
    }
}

}  // namespace hostile

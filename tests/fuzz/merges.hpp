// SPDX-License-Identifier: MIT
#pragma once

#include "front_cap.hpp"
#include "plan_laws.hpp"

#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/text/font_faces.hpp>
#include <typemesh/text/text_mesher.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Glyphs anywhere, of several faces, sizes, slants and styles -> merged solids: in each style they fill once what the
/// glyphs fill.
namespace fuzz {

namespace merge_laws {

using namespace typemesh;

/// Another face, style or map: larger, smaller, slanted, mirrored, turned, flat.
inline glyph_style read_glyph_style(values& in)
{
    static constexpr affine maps[] = {{},
                                      {.xx = 2.0, .yy = 2.0},
                                      {.xx = 0.0625, .yy = 0.0625},
                                      {.xy = 0.25},
                                      {.xx = -1.0},
                                      {.xx = 0.0, .xy = -1.0, .dx = 100.0, .yx = 1.0, .yy = 0.0, .dy = 30.0},
                                      {.xx = 0.3, .xy = 0.7, .yx = -0.7, .yy = 0.3},
                                      {.yy = 0.0}};
    const std::uint32_t bits = in.byte();
    return {bits & 1, maps[bits >> 1 & 7], style_id{bits >> 4 & 3}};
}

/// In font units, at most 10,000 from the origin, often on a lattice so that edges coincide.
inline glyph_run read_run(values& in)
{
    glyph_run run;
    run.units_per_em = 1000.0;
    const std::uint32_t bits = in.byte(), kind = bits % 3;
    for (std::uint32_t count = 1 + in.below(8), i = 0; i < count; ++i) {
        constexpr double steps[] = {50.0, 1.0, 1.0 / 2048};
        placed_glyph g{in.below(6), static_cast<cluster_id>(i), {}};
        g.origin.x =
            steps[kind] * ((kind == 0 ? in.byte() & 31u : in.bits(2)) & 2047u) + 16.0 * (kind == 2 ? in.byte() : 0);
        g.origin.y = steps[kind] * ((kind == 0 ? in.byte() & 31u : in.bits(2)) & 2047u);
        if (bits >= 128) {
            const auto number = run.number_of(read_glyph_style(in));
            if (!number) return glyph_run{};
            g.glyph_style = *number;
        }
        if (!run.glyphs.push_back(g)) return glyph_run{};
    }
    return run;
}

/// Places all over: the merged front is there once where any glyph's is, and nowhere else.
inline broken_law of_fronts(const front_cap& apart, const front_cap& merged)
{
    float right = 0.0f, top = 0.0f, left = 1e9f, bottom = 1e9f;
    for (std::size_t i = 0; i < apart.range.vertex_count; ++i) {
        const auto& v = apart.m.vertices[apart.range.first_vertex + i];
        right = (std::max)(right, v.position.x), left = (std::min)(left, v.position.x);
        top = (std::max)(top, v.position.y), bottom = (std::min)(bottom, v.position.y);
    }
    constexpr int rows = 12;
    constexpr double margin = 0.05;  // font units: grid and floats are much finer
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < rows; ++k) {
            const double x = double(left) + (double(right) - double(left)) * (i + 0.37) / rows;
            const double y = double(bottom) + (double(top) - double(bottom)) * (k + 0.61) / rows;
            const int before = apart.count_at(x, y, margin), after = merged.count_at(x, y, margin);
            if (before >= 0 && after >= 0 && after != (before > 0 ? 1 : 0))
                return "a place is filled wrongly, or twice";
        }
    return {};
}

/// Laws of merged solids of every extruder: closed, each glyph in one group, written the same in all ways.
template <class Plan>
broken_law of_groups(const Plan& merged, std::size_t drawn, const test::full_mesh& m)
{
    const inspect::closedness closed = test::examine(m);
    if (closed.unmatched_edges != 0 || closed.bad_corners != 0) return "the mesh is open";
    std::vector<bool> seen(merged.run().glyphs.size(), false);
    std::size_t members = 0;
    for (std::size_t g = 0; g < merged.glyphs().size(); ++g)
        for (const std::uint32_t k : merged.members(g)) {
            if (seen.at(k)) return "a glyph belongs to two groups";
            seen[k] = true;
            ++members;
            const std::uint32_t glyph_style = merged.run().glyphs[k].glyph_style;
            if (!merged.run().glyph_styles.empty() &&
                merged.run().glyph_styles[glyph_style].style != merged.glyphs()[g].style)
                return "a glyph is merged with glyphs of another style";
        }
    return members == drawn ? "" : "a glyph belongs to no group";
}

/// Letters that grow, or have outward bevels, are merged where they then meet.
template <class Mesher>
broken_law of_grown(Mesher mesher, const glyph_run& run, const text_options& how, values& in)
{
    const auto plan = mesher.plan(run, how);
    if (!plan) return plan.error().message();
    test::full_mesh m;
    if (!plan->write(into(m.vertices, m.indices))) return "write failed";
    std::size_t drawn = 0;
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) drawn += plan->members(g).size();
    if (broken_law broken = of_groups(*plan, drawn, m); !broken.empty()) return broken;
    return plan_laws::of_writing(*plan, in);
}

/// Each style's merged front is there once where a glyph's is.
template <class Font>
broken_law of_plain(Font& font, const glyph_run& run, text_options how, values& in)
{
    auto a = text_mesher{font}.with(extruded<>{.depth = 0.25f}), b = text_mesher{font}.with(extruded<>{.depth = 0.25f});
    const auto apart = a.plan(run, how);
    how.merge = true;
    const auto merged = b.plan(run, how);
    if (!apart || !merged) return apart ? merged.error().message() : apart.error().message();
    if (merged->report().refused != 0) return "a group is refused";
    test::full_mesh m, n;
    if (!apart->write(into(m.vertices, m.indices)) || !merged->write(into(n.vertices, n.indices)))
        return "write failed";
    if (broken_law broken = of_groups(*merged, apart->glyphs().size(), n); !broken.empty()) return broken;
    double area = 0.0;
    for (const style_id s : merged->styles()) {
        const front_cap fronts{m, apart->range(s, part::front)}, front{n, merged->range(s, part::front)};
        if (broken_law broken = of_fronts(fronts, front); !broken.empty()) return broken;
        if (!(front.area() <= fronts.area() * (1.0 + 1e-5) + 1.0)) return "merging adds area";
        area += front.area();
    }
    const double volume = test::volume(n.vertices, n.indices), depth = 250.0;
    if (!(std::fabs(volume - area * depth) <= 1e-4 * area * depth + 1.0)) return "the volume is not area times depth";
    return plan_laws::of_writing(*merged, in);
}

}  // namespace merge_laws

inline broken_law merges(values in)
{
    using namespace typemesh;
    using namespace merge_laws;
    test::toy_font font, other;
    font_faces faces{font, other};
    const glyph_run run = read_run(in);
    text_options how;
    how.unit = output_unit::font_units;
    how.tolerance = in.one_of({quality::high, quality::low, 0.05});
    const std::uint32_t kind = in.byte() & 15;
    if (kind < 11) return of_plain(faces, run, how, in);
    how.merge = true;
    const auto width = float(in.between(-0.05, 0.2));
    if (kind < 14) return of_grown(text_mesher{faces}.with(embolden{.by = width}), run, how, in);
    const bevelled bevels{.width = std::fabs(width), .outward = true};
    return of_grown(text_mesher{faces}.with(bevels), run, how, in);
}

}  // namespace fuzz

// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_shapes.hpp"

#include "support/mesh_laws.hpp"

#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/tapered.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// Letters that touch themselves, anywhere, in any frame and unit -> solids whose corners are parted or joined.
namespace fuzz {

namespace corner_laws {

using namespace typemesh;

/// A font of one letter, of closed polylines or of curves. The letter is as large as an em, 4 times or 1/16 of it.
struct drawn_letter {
    double em = 1000.0;
    recorded_outlines font{em};
    broken_law failure;

    explicit drawn_letter(values& in)
    {
        if (in.flag()) {
            const crossing_laws::drawn_outline curves{in};
            if (curves.failure) failure = curves.failure.message();
            draw([&](auto& pen) {
                if (!curves.recorded.starts.empty())
                    draw_outline(curves.recorded.curves.view(), curves.recorded.starts.view(), pen);
            });
            return;
        }
        const double scale = in.one_of({1.0, 0.25, 16.0});
        const std::vector<polyline> loops = loop_reader{in}.read(60);
        double reach = 16.0;
        for (const polyline& l : loops)
            for (const grid_point p : l) reach = (std::max)({reach, std::fabs(double(p.x)), std::fabs(double(p.y))});
        em = scale * reach;
        font = recorded_outlines{em};
        draw([&](auto& pen) {
            for (const polyline& l : loops) {
                for (std::size_t i = 0; i < l.size(); ++i) {
                    const point p{double(l[i].x), double(l[i].y)};
                    i == 0 ? pen.move(p) : pen.line(p);
                }
                pen.close();
            }
        });
    }

private:
    template <class Draw>
    void draw(Draw&& pen_of)
    {
        if (const auto added = font.add(pen_of); !added && failure.empty()) failure = added.error().message();
    }
};

inline text_options read_corner_options(values& in)
{
    static constexpr frame slanted{
        .right = {0.36f, 0.48f, -0.8f}, .up = {-0.8f, 0.6f, 0.0f}, .toward = {0.48f, 0.64f, 0.6f}};
    static constexpr frame frames[] = {right_handed_y_up, slanted, left_handed_z_up, slanted};
    const std::uint32_t bits = in.byte();
    text_options how;
    how.corners = (bits & 1) != 0 ? touching::join : touching::part;
    how.frame = frames[bits >> 1 & 3];
    how.merge = (bits & 8) != 0;
    if ((bits & 16) != 0) how.fill = fill_rule::even_odd;
    how.unit = static_cast<output_unit>(bits >> 5 & 3);
    if ((bits & 128) != 0) how.size = in.one_of({72.0, 0.37, 1000.0, 1e-3});
    how.tolerance = in.one_of({quality::high, quality::low, 0.05});
    return how;
}

/// One letter, or several that are merged; in em, as far out as every edge is promised two faces.
inline glyph_run read_corner_run(values& in, const drawn_letter& letter, const text_options& how)
{
    static constexpr point places[] = {{0, 0}, {-3, 7}, {100, -60}, {1500, 0.3}, {-1000, 1700}, {1.0 / 3.0, 0.1}};
    glyph_run run;
    run.units_per_em = letter.em;
    const point from = in.one_of(places);
    for (std::uint32_t i = 0, count = how.merge ? 1 + in.below(3) : 1; i < count; ++i) {
        const double x = from.x + in.byte() / 16.0 * (i == 0 ? 0 : 1), y = from.y + in.byte() / 16.0 * (i == 0 ? 0 : 1);
        if (!run.glyphs.push_back({0, i, {letter.em * x, letter.em * y}})) return glyph_run{};
    }
    return run;
}

/// Every edge has two faces and every point one fan, whatever the letter. A bevel may leave no room for the walls that
/// this needs; the report says so.
template <class Extruder>
broken_law of_solid(const Extruder& how, drawn_letter& letter, const glyph_run& run, const text_options& options,
                    bool may_touch = false)
{
    auto mesher = text_mesher{letter.font}.with(how);
    const auto plan = mesher.plan(run, options);
    if (!plan) return unless_one_of(plan.error(), {error::bad_option});
    const text_report& report = plan->report();
    if (report.refused != 0)
        return unless_one_of(report.first_refusal, {error::nothing_left, error::outline_beyond_grid,
                                                    error::too_many_points, error::bad_option});
    test::full_mesh m;
    if (!plan->write(into(m.vertices, m.indices))) return "write failed";
    if (report.touching != 0) return may_touch ? "" : "corners or sides touch";
    const inspect::manifoldness found =
        inspect::check_manifoldness(inspect::mesh_view{m.vertices, m.indices, &test::full_vertex::position});
    if (found.bad_triangles != 0) return "a triangle has two corners in one place";
    if (found.open_edges != 0) return "the mesh is open";
    if (found.crowded_edges != 0) return "an edge has more than two faces";
    if (found.pinched_points != 0) return "the faces round a point make several fans";
    return {};
}

}  // namespace corner_laws

inline broken_law corners(values in)
{
    using namespace typemesh;
    using namespace corner_laws;
    static constexpr float depths[] = {0.2f, 0.01f, 1.0f, 8.0f}, shares[] = {1.0f, 0.5f, 0.999f, 0.1f, 0.4999f, 0.7f};
    const std::uint32_t what = in.byte(), bits = in.byte();
    text_options options = read_corner_options(in);
    bevelled bevel = solid_laws::read_bevel(in, what >> 3);
    drawn_letter letter{in};
    if (!letter.failure.empty()) return letter.failure;
    const glyph_run run = read_corner_run(in, letter, options);
    float depth = in.one_of(depths), limit = in.one_of({0.0f, 0.02f, 0.3f}), height = in.one_of({1.0f, 0.2f, 5.0f});
    const float share = in.one_of(shares);
    // Depths in output units count as em in a unit_box.
    if ((bits & 1) != 0 && options.unit != output_unit::unit_box) {
        const double unit = options.unit == output_unit::em       ? 1.0
                            : options.unit == output_unit::pixels ? options.pixels_per_em
                                                                  : letter.em;
        const auto output = static_cast<float>(unit * options.size);
        options.depth_in = depth_unit::output;
        depth *= output, limit *= output, height *= output;
    }
    bevel.depth = depth;
    bevel.bevel_depth = depth * share;
    if (bevel.sides == bevel_sides::both && share > 0.5f) bevel.bevel_depth *= 0.5f;
    bevel.segments = 1 + (bits >> 1 & 1);
    switch (what & 7) {
    case 0: return of_solid(extruded<>{.depth = depth}, letter, run, options);
    case 1: {
        inflated how{.height = height, .edge = in.one_of({0.1f, 0.03f, 1.0f}), .limit = limit, .max_points = 3000};
        if ((bits & 8) != 0) how.form = inflated_form::dome, how.depth = depth;
        return of_solid(how, letter, run, options);
    }
    case 2: {
        options.depth_in = depth_unit::em;
        const carved how{.tool_angle = in.one_of({90.0f, 30.0f, 150.0f}),
                         .max_depth = in.one_of({0.0f, 0.03f, 0.1f}),
                         .as = (bits & 8) != 0 ? carving::cutter : carving::relief};
        return of_solid(how, letter, run, options);
    }
    case 3: {
        options.depth_in = depth_unit::em;
        tapered how{.degrees = in.one_of({5.0f, 30.0f, 1.0f, 60.0f})};
        how.mitre_limit = bevel.mitre_limit;
        return of_solid(how, letter, run, options);
    }
    case 4: {
        const auto by = float(in.between(-0.05, 0.1));
        if ((bits & 8) != 0) return of_solid(embolden{.by = by}, letter, run, options);
        return of_solid(outlined<>{.width = 0.005f + std::fabs(by), .place = static_cast<outline_place>(what >> 3 & 1)},
                        letter, run, options);
    }
    default: return of_solid(bevel, letter, run, options, true);
    }
}

}  // namespace fuzz

// SPDX-License-Identifier: MIT
#pragma once

// Laws of the caps and the solid of one glyph, for all contours and triangulators.

#include "support/delaunay.hpp"
#include "support/face_instances.hpp"
#include "support/mesh_laws.hpp"
#include "support/oracle.hpp"

#include <typemesh/inspect/curve_distance.hpp>
#include <typemesh/inspect/fill_check.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

using namespace typemesh;

/// The findings about one glyph.
struct glyph_findings {
    bool blank = false;
    bool resolved = false;  ///< its contours meet
    bool touching = false;  ///< its region touches itself
    std::size_t points = 0;
    std::size_t crowded = 0;      ///< vertical edges with more than two faces
    bool refined = false;         ///< the guard made curves finer
    std::uint32_t unsettled = 0;  ///< meetings that the guard accepted only because their curves cannot be finer
    bool bent_more = false;       ///< the area differs from that of the contours led through their rounded crossings
    double moved = 0.0;           ///< then: the difference, over its bound (see examine)
    std::string wrong;            ///< the first law that is broken, or nothing
};

/// Reuses its memory for one glyph after another. Use each on one thread.
class glyph_laws {
public:
    template <class Font>
    glyph_findings examine(Font& font, glyph_id id, double tolerance_em)
    {
        glyph_findings f;
        if (const auto done = record(font, id, outline_); !done) return f.wrong = done.error().message(), f;
        if (outline_.curves.empty()) return f.blank = true, f;
        const auto cells = grid::fitting(font.units_per_em(), outline_.bounds);
        if (!cells) return f.wrong = cells.error().message(), f;
        const double tolerance = tolerance_em * font.units_per_em();
        seen given_last;
        no_observer nobody;
        const auto made = caps_.build(outline_, tolerance, *cells, {outline_.rule},
                                      policies{certified{}, watched_monotone{{}, &given_last}, flat{}, nobody});
        const refinement_effort& effort = caps_.effort();
        if (!made) return f.wrong = std::string{"refused: "} + made.error().message(), f;
        if (caps_.loops().points.empty() && given_last.points.empty()) return f.blank = true, f;
        f.refined = effort.rounds != 0;
        f.unsettled = effort.unsettled;
        f.resolved = given_last.refused;
        const auto given = oracle::loops_of(given_last.points, given_last.starts);
        f.touching = made->is_touching();
        f.points = made->points().size();
        const auto kept = oracle::loops_of(*made);
        if (made->points().empty()) return f.blank = true, f;

        if (f.wrong = oracle::broken_law(*made, caps_.triangles().view()); !f.wrong.empty()) return f;
        if (f.wrong = broken_delaunay(*made); !f.wrong.empty()) return f;
        if (f.resolved)
            if (f.wrong = oracle::broken_cycle(kept); !f.wrong.empty()) return f;
        const double area = static_cast<double>(oracle::doubled_area(kept));
        if (!f.resolved) {
            const double filled = oracle::doubled_filled_area(given, outline_.rule);
            if (std::fabs(area - filled) > 1e-11 * filled) return f.wrong = "the area is not what the contours fill", f;
        } else {
            // Equal to the area of the contours led through their rounded crossings. If that makes new crossings, which
            // are rounded in their turn, no edge moves by more than 1.5 cells.
            const auto bent = oracle::reroute_through_crossings(given);
            const double filled = oracle::doubled_filled_area(bent.loops(), outline_.rule);
            const double off = std::fabs(area - filled);
            if (off > 1e-11 * filled) {
                f.bent_more = true;
                f.moved = off / (2 * 1.5 * bent.bent_length + 1e-11 * filled);
                if (f.moved > 1) return f.wrong = "the area is not what the contours fill", f;
            }
        }
        const double in_cells = tolerance * cells->cells, allowed = 1.01 * in_cells + 1.5;  // chords, and bends
        curves_.take(outline_, cells->cells, 0.01 * in_cells);
        if (inspect::check_distance(*made, curves_, allowed).strays != 0)
            return f.wrong = "the boundary strays from all curves", f;
        if (f.resolved && f.unsettled == 0)
            if (f.wrong = false_intersection(*made, in_cells); !f.wrong.empty()) return f;

        for (const triangle t : caps_.triangles()) {
            const auto at = [&](std::uint32_t i) {
                const point p = made->grid().place(made->points()[i]);
                return vec2{static_cast<float>(p.x), static_cast<float>(p.y)};
            };
            const vec2 a = at(t.a), b = at(t.b), c = at(t.c);
            const double turn = (double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x);
            if (!(turn > 0)) return f.wrong = "a triangle is flipped or flat in 32-bit floats", f;
        }

        if (inspect::check_fill(curves_, outline_.rule, kept, allowed, 20, id).wrong != 0)
            return f.wrong = "a place is filled wrongly", f;
        if (f.wrong = badly_lit(*made, tolerance * cells->cells); !f.wrong.empty()) return f;

        glyph_run single;
        single.units_per_em = font.units_per_em();
        if (!single.glyphs.push_back({id, 0, {0, 0}})) return f.wrong = "no memory", f;
        text_mesher mesher{font};
        const auto built = mesher.plan(single, {.tolerance = tolerance_em, .unit = output_unit::font_units});
        if (!built) return f.wrong = built.error().message(), f;
        if (built->report().refused != 0) return f.wrong = "refused by the mesher", f;
        if (!built->write(into(mesh_.vertices, mesh_.indices))) return f.wrong = "cannot be written", f;
        const closedness law = test::examine(mesh_);
        f.crowded = law.crowded_edges;
        if (law.unmatched_edges != 0) return f.wrong = "the solid is not closed", f;
        if (law.crowded_slanted != 0) return f.wrong = "more than two faces meet at an edge that is not vertical", f;
        if (law.zero_area != 0) return f.wrong = "a wall or cap triangle is flat", f;
        if (!f.touching && law.crowded_edges != 0) return f.wrong = "more than two faces meet where nothing touches", f;
        return f;
    }

private:
    /// The last contours that a triangulator sees: the guard has accepted them.
    struct seen {
        std::vector<grid_point> points;
        std::vector<std::uint32_t> starts;
        bool refused = false;
    };
    struct watched_monotone : monotone {
        seen* last;
        result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
        {
            last->points.assign(loops.points.begin(), loops.points.end());
            last->starts.assign(loops.starts.begin(), loops.starts.end());
            auto made = monotone::prove(loops, space, out);
            last->refused = !made;
            return made;
        }
    };

    using chord = inspect::curve_chords::chord;

    static double squared_distance(point p, point start, point end)
    {
        return inspect::curve_chords::squared_distance(p, start, end);
    }

    /// Normals point out of their walls. If a wall is longer than 16 tolerances, they are at most 45 degrees off the wall's
    /// own normal. A point that is not doubled has one normal.
    std::string badly_lit(const region& made, double tolerance)
    {
        constexpr double rounding = 1e-6;  // of normals in 32 bits, on either side of a right angle or half of one
        const auto points = made.points();
        sides_.assign(points.size(), {});
        if (const error e = curve_normals{}(made, sides_)) return e.message();
        for (std::size_t l = 0; l + 1 < made.starts().size(); ++l) {
            const std::uint32_t begin = made.starts()[l], end = made.starts()[l + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t next = i + 1 < end ? i + 1 : begin;
                if (!sides_[i].doubled && !(sides_[i].before == sides_[i].after)) return "a soft point has two normals";
                const point own = outward(delta(points[i], points[next]));
                for (const vec2 n : {sides_[i].after, sides_[next].before}) {
                    const double up = dot({n.x, n.y}, own), aside = std::fabs(cross({n.x, n.y}, own));
                    if (up < -rounding * length(own)) return "a normal points into its wall";
                    if (length(own) > 16.0 * tolerance && up < aside - rounding * length(own))
                        return "a long wall is lit from the side";
                }
            }
        }
        return {};
    }

    /// Where the boundary changes from one curve to another that is not its neighbour, the two contours have a common point
    /// within four tolerances along both, to 3 % of a tolerance.
    std::string false_intersection(const region& made, double tolerance)
    {
        const auto points = made.points();
        const double reach = 4.0 * tolerance + 3.0, little = 0.03 * tolerance + 2.0;
        const auto round = [&](std::uint32_t k) {  // a curve and its neighbours
            std::uint32_t c = 0;
            while (outline_.starts[c + 1] <= k) ++c;
            const std::uint32_t first = outline_.starts[c], n = outline_.starts[c + 1] - first;
            return std::vector<std::uint32_t>{first + (k - first + n - 1) % n, k, first + (k - first + 1) % n};
        };
        for (std::size_t l = 0; l + 1 < made.starts().size(); ++l) {
            const std::uint32_t begin = made.starts()[l], end = made.starts()[l + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t a = made.edges()[i == begin ? end - 1 : i - 1].curve, b = made.edges()[i].curve;
                if (a == b || (outline_.curves[a].degree == 1 && outline_.curves[b].degree == 1)) continue;
                const auto of_a = round(a), of_b = round(b);
                if (std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end()) continue;
                const point x{double(points[i].x), double(points[i].y)};
                const auto chords_within = [&](std::uint32_t k, std::vector<chord>& all) {
                    const std::size_t before = all.size();
                    for (const chord& c : curves_.of_curve(k))
                        if (squared_distance(x, c.start, c.end) <= reach * reach) all.push_back(c);
                    return all.size() > before;
                };
                const auto chords_of = [&](const std::vector<std::uint32_t>& curves) {  // and on along the contour
                    std::vector<chord> all;
                    for (const std::uint32_t k : curves) chords_within(k, all);
                    for (std::uint32_t k = curves.back(), n = 0; n < 16 && chords_within(k = round(k).back(), all);)
                        ++n;
                    for (std::uint32_t k = curves[0], n = 0; n < 16 && chords_within(k = round(k)[0], all);) ++n;
                    return all;
                };
                bool met = false;
                const auto all_a = chords_of(of_a), all_b = chords_of(of_b);
                for (const chord& p : all_a) {
                    for (const chord& q : all_b) {
                        const point u = p.end - p.start, v = q.end - q.start;
                        met = met || (cross(u, q.start - p.start) * cross(u, q.end - p.start) <= 0 &&
                                      cross(v, p.start - q.start) * cross(v, p.end - q.start) <= 0);
                        for (const double nearest :
                             {squared_distance(p.start, q.start, q.end), squared_distance(p.end, q.start, q.end),
                              squared_distance(q.start, p.start, p.end), squared_distance(q.end, p.start, p.end)})
                            met = met || nearest <= little * little;
                    }
                    if (met) break;
                }
                if (!met) return "chords meet where the curves do not";
            }
        }
        return {};
    }

    /// The Delaunay triangles obey the laws of all triangles and their own, and both ways to make them agree.
    std::string broken_delaunay(const region& r)
    {
        delaunay_.clear();
        by_slabs_.clear();
        if (const error e = constrained_delaunay{}(r, space_, delaunay_))
            return std::string{"Delaunay: "} + e.message();
        if (const error e = constrained_delaunay{.max_flips = 0}(r, space_, by_slabs_))
            return std::string{"Delaunay by slabs: "} + e.message();
        std::string wrong = oracle::broken_law(r, delaunay_.view());
        if (wrong.empty()) wrong = oracle::broken_delaunay(r, delaunay_.view());
        if (wrong.empty() && oracle::as_set(delaunay_.view()) != oracle::as_set(by_slabs_.view()))
            wrong = "flips and slabs do not make the same triangles";
        return wrong.empty() ? wrong : "Delaunay: " + wrong;
    }

    workspace space_;
    outline outline_;
    cap_builder caps_;
    triangle_list delaunay_, by_slabs_;
    inspect::curve_chords curves_;
    std::vector<side_point> sides_;
    full_mesh mesh_;
};

}  // namespace test

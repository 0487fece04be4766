// SPDX-License-Identifier: MIT
#pragma once

// A glyph whose filled boundary has become curves again, compared with the curves that the font drew.

#include "support/catch.hpp"

#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/fill/boundary_curves.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/outline/svg_path_writer.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace test {

/// An outline -> region -> curves again.
class redrawn_glyph {
public:
    explicit redrawn_glyph(typemesh::memory source = typemesh::heap())
        : drawn{source}, loops_{source}, again_{source}, read_{source}, space_{source}, curves_{source}
    {
    }

    typemesh::outline drawn;  ///< the curves that were found
    typemesh::region filled;

    /// `tolerance` in em.
    [[nodiscard]] typemesh::error make(const typemesh::outline& given, double units_per_em, double tolerance)
    {
        using namespace typemesh;
        const auto cells = grid::fitting(units_per_em, given.bounds);
        if (!cells) return cells.error();
        if (auto made = discretise(given, certified{}, tolerance * units_per_em, *cells, loops_); !made)
            return made.error();
        const auto region = fill(loops_, given.rule, space_);
        if (!region) return region.error();
        filled = *region;
        return curves_.find(filled, drawn).error();
    }

    [[nodiscard]] const typemesh::boundary_curves& found() const { return curves_; }

    /// "" if the curves, flattened again, are loops that do not cross, as many as the region's, and the two boundaries
    /// are no farther from each other than `allowed` tolerances plus 4 cells.
    [[nodiscard]] std::string broken_again(double allowed)
    {
        using namespace typemesh;
        const double tolerance = filled.tolerance();
        if (auto made = discretise(drawn, certified{}, tolerance / filled.grid().cells, filled.grid(), again_); !made)
            return "not flattened";
        const auto second = fill(again_, fill_rule::non_zero, space_);
        if (!second) return "not filled";
        const double most = allowed * tolerance + 4.0;
        if (const double far = farthest(*second, filled); far > most)
            return "too far: " + std::to_string(far / tolerance);
        if (const double far = farthest(filled, *second); far > most) return "lost: " + std::to_string(far / tolerance);
        return "";
    }

    /// What became of the curves in a file.
    struct file_findings {
        std::string wrong;   ///< the first law that is broken, or nothing
        double area = 0.0;   ///< between the two regions, over the boundary's length, in tolerances
        double moved = 0.0;  ///< the farthest point of one boundary from the other one, in tolerances
    };

    /// Writes the curves as path data of SVG, reads and flattens these sixteen times as finely, and compares the region
    /// with the one that the curves were found in. Laws: it is a region without crossings; the area that only one of
    /// both covers is at most one tolerance and two cells wide on average; no boundary is farther from the other than
    /// four tolerances and four cells, as boundary_curves promises.
    [[nodiscard]] file_findings through_a_file()
    {
        using namespace typemesh;
        file_findings f;
        svg_path_writer text{{.yy = -1.0}, 4};
        draw_outline(drawn, text);
        if (!text.finish()) return f.wrong = "not written", f;
        outline_recorder recorder{read_};
        const affine turned{.yy = -1.0};
        detail::mapping_sink<outline_recorder> upright{recorder, turned};
        if (!draw_svg_path(text.text(), 1e-6, upright) || recorder.finish()) return f.wrong = "not read", f;
        const double tolerance = filled.tolerance(), cells = filled.grid().cells;
        if (!discretise(read_, certified{}, tolerance / 16.0 / cells, filled.grid(), again_))
            return f.wrong = "not flattened", f;
        const auto second = fill(again_, fill_rule::non_zero, space_);
        if (!second) return f.wrong = "not filled", f;
        f.moved = (std::max)(farthest(*second, filled), farthest(filled, *second)) / tolerance;
        contours both;
        both.grid = filled.grid();
        both.tolerance = tolerance;
        double length = 0.0, again = 0.0;
        if (!both.starts.push_back(0) || !add_loops(filled, both, length) || !add_loops(*second, both, again))
            return f.wrong = "no memory", f;
        workspace space;
        const auto differ = fill(both, fill_rule::even_odd, space);
        if (!differ) return f.wrong = "not compared", f;
        const double area = 0.5 * static_cast<double>(inspect::doubled_area(*differ));
        f.area = area > 0.0 ? area / length / tolerance : 0.0;
        if (area > (tolerance + 2.0) * length) f.wrong = "another area: " + std::to_string(f.area);
        if (f.moved > 4.0 + 4.0 / tolerance) f.wrong = "too far: " + std::to_string(f.moved);
        return f;
    }

    /// How many of `places` next to the given curves are on another side than the font's fill says, though farther
    /// from all curves than `allowed` cells.
    [[nodiscard]] std::size_t wrong_places(const typemesh::outline& given, std::size_t places, double allowed,
                                           std::uint64_t seed) const
    {
        using namespace typemesh;
        if (given.curves.empty()) return 0;
        const double cells = filled.grid().cells;
        const inspect::curve_chords before{given, cells, 0.1}, after{drawn, cells, 0.1};
        std::uint64_t state = seed * 0x9E37'79B9'7F4A'7C15u | 1;
        const auto fraction = [&state] {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            return static_cast<double>(state >> 11) * 0x1p-53;
        };
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < places; ++i) {
            const auto nth = static_cast<std::size_t>(fraction() * static_cast<double>(given.curves.size()));
            const double angle = 6.283185307179586 * fraction(), away = allowed + 30.0 * allowed * fraction();
            const point q = cells * given.curves[nth].at(fraction()) + away * point{std::cos(angle), std::sin(angle)};
            if (is_filled(given.rule, before.winding(q)) == (after.winding(q) != 0)) continue;
            wrong += std::sqrt(inspect::curve_chords::squared_distance(q, before.all())) > allowed;
        }
        return wrong;
    }

private:
    /// Adds a region's loops as plain polygons, and gives their length in cells.
    static bool add_loops(const typemesh::region& from, typemesh::contours& to, double& length)
    {
        using namespace typemesh;
        bool ok = true;
        for (std::uint32_t k = 0; k < from.loop_count(); ++k) {
            const std::uint32_t begin = from.starts()[k], end = from.starts()[k + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const grid_point a = from.points()[i], b = from.points()[i + 1 < end ? i + 1 : begin];
                length += std::hypot(double(b.x) - a.x, double(b.y) - a.y);
                ok = ok && to.points.push_back(a) && to.edges.push_back({});
            }
            ok = ok && to.starts.push_back(static_cast<std::uint32_t>(to.points.size()));
        }
        return ok;
    }

    /// The farthest point of a region's boundary from another region's, in cells.
    [[nodiscard]] static double farthest(const typemesh::region& from, const typemesh::region& to)
    {
        using namespace typemesh;
        const auto exact = [](grid_point p) { return point{static_cast<double>(p.x), static_cast<double>(p.y)}; };
        double most = 0.0;
        for (const grid_point p : from.points()) {
            double nearest = 1e300;
            for (std::uint32_t k = 0; k < to.loop_count(); ++k)
                for (std::uint32_t i = to.starts()[k], end = to.starts()[k + 1]; i < end; ++i) {
                    const grid_point a = to.points()[i], b = to.points()[i + 1 < end ? i + 1 : to.starts()[k]];
                    nearest =
                        (std::min)(nearest, inspect::curve_chords::squared_distance(exact(p), exact(a), exact(b)));
                }
            most = (std::max)(most, nearest);
        }
        return std::sqrt(most);
    }

    typemesh::contours loops_, again_;
    typemesh::outline read_;
    typemesh::workspace space_;
    typemesh::boundary_curves curves_;
};

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/piece_of.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/fill/impl/curve_chain.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The boundary of a region as Bezier curves again: the filled outline without overlaps, for files of drawings and for
/// machines that cut curves.
///
///       .---.                     .---.        Consecutive edges of one curve become one piece of it, from t0
///      /   .-+---.               /     '---.   to t1. Where two curves meet, the piece ends where the curves
///     |   |   \   |   becomes   |           |  themselves cross, not where their chords do. Newton's method finds
///      \   '-+---'               \     .---'   that place.
///       '---'                     '---'
///
/// Curves that meet no other one are the font's own, unchanged. If curves do not cross next to their chords' crossing
/// (they touch, or are almost parallel), the pieces end at the region's point, and their ends move there, by no more
/// than four times the region's tolerance plus 4 cells. If edges do not follow their curve at all (a boundary that has
/// been moved, a glyph of another size among merged ones), they become lines.
///
/// Every point of the pieces is as near to the region's boundary as the region's own edges are to their curves, apart
/// from those moved ends. The pieces are not tested for crossings: contours that are nearer to each other than the
/// tolerance, and do not cross as polylines, may cross as curves.
class boundary_curves {
public:
    explicit boundary_curves(memory source = heap()) noexcept : chains_{source} {}

    /// Finds the curves of a region, in font units, into `out`: outer loops counter-clockwise, holes clockwise. Each
    /// curve begins exactly where the one before it ends.
    ///
    /// Fails  error::out_of_memory; `out` is then empty
    /// Cost   O(n), and a few evaluations for each meeting; no allocation once the buffers have grown
    [[nodiscard]] result<void> find(const region& filled, outline& out) noexcept
    {
        out.clear();
        out.rule = fill_rule::non_zero;
        meetings_ = straight_ = 0;
        if (filled.loop_count() == 0) return {};
        cells_ = filled.grid().cells;
        slack_ = filled.tolerance() + 2.0;
        reach_ = 4.0 * filled.tolerance() + 4.0;
        bool fits = out.starts.push_back(0);
        for (std::uint32_t k = 0; k < filled.loop_count() && fits; ++k) {
            fits = add_loop(filled, filled.starts()[k], filled.starts()[k + 1], out);
            const auto end = static_cast<std::uint32_t>(out.curves.size());
            if (fits && end != out.starts.back()) fits = out.starts.push_back(end);
        }
        if (out.starts.size() == 1) out.starts.clear();
        if (fits) return {};
        out.clear();
        return error::out_of_memory;
    }

    /// The number of meetings of curves that were found in the last region.
    [[nodiscard]] std::uint32_t meetings() const noexcept { return meetings_; }
    /// The number of edges in the last region that became lines, because they do not follow their curves.
    [[nodiscard]] std::uint32_t straight_edges() const noexcept { return straight_; }

private:
    /// The points and edges of a loop, counted from its seam, a place where a chain begins.
    struct loop {
        array_view<const grid_point> points;
        array_view<const contour_edge> edges;
        array_view<const curve> curves;
        std::uint32_t seam = 0;

        [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(points.size()); }
        [[nodiscard]] const contour_edge& edge(std::uint32_t i) const noexcept { return edges[(seam + i) % size()]; }
        [[nodiscard]] point place(std::uint32_t i) const noexcept
        {
            const grid_point p = points[(seam + i) % size()];
            return {static_cast<double>(p.x), static_cast<double>(p.y)};
        }
        [[nodiscard]] bool has(std::uint32_t curve) const noexcept { return curve < curves.size(); }
    };

    [[nodiscard]] bool add_loop(const region& filled, std::uint32_t begin, std::uint32_t end, outline& out) noexcept
    {
        loop of{filled.points().subspan(begin, end - begin), filled.edges().subspan(begin, end - begin),
                filled.curves()};
        while (of.seam < of.size() && goes_on(of, of.size() - 1)) ++of.seam;
        if (of.seam == of.size()) of.seam = 0;
        chains_.clear();
        for (std::uint32_t i = 0; i < of.size();) {
            detail::curve_chain r;
            r.first = i++;
            while (i < of.size() && goes_on(of, i - 1)) ++i;
            r.last = i;
            r.curve = of.edge(r.first).curve;
            r.t0 = as_double(of.edge(r.first).t0);
            r.t1 = as_double(of.edge(i - 1).t1);
            if (of.has(r.curve)) set_shift(of, r);
            if (!chains_.push_back(r)) return false;
        }
        for (std::size_t k = 0; k < chains_.size(); ++k)
            chains_[k].start = meet(of, chains_[k == 0 ? chains_.size() - 1 : k - 1], chains_[k]);
        for (std::size_t k = 0; k < chains_.size(); ++k)
            if (!add_chain(of, chains_[k], chains_[k + 1 == chains_.size() ? 0 : k + 1].start, out)) return false;
        return true;
    }

    /// Whether the edge after edge i continues its curve. Parameters may jump by less than 4 cells.
    [[nodiscard]] bool goes_on(const loop& of, std::uint32_t i) const noexcept
    {
        const contour_edge &before = of.edge(i), &e = of.edge(i + 1);
        if (before.curve != e.curve || !of.has(e.curve)) return false;
        const bool up = e.t0 < e.t1;
        if ((before.t0 < before.t1) != up || (up ? e.t0 < before.t1 : e.t0 > before.t1)) return false;
        const curve& c = of.curves[e.curve];
        double legs = 0.0;
        for (std::uint32_t k = 0; k < c.degree; ++k) legs += length(c.p[k + 1] - c.p[k]);
        return std::fabs(as_double(e.t0) - as_double(before.t1)) * legs * c.degree * cells_ <= 4.0;
    }

    /// Sets how far a chain is from its curve: points inside a chain are the curve's own, rounded.
    void set_shift(const loop& of, detail::curve_chain& r) const noexcept
    {
        const curve& c = of.curves[r.curve];
        point sum;
        double count = 0.0;
        for (std::uint32_t i = r.first + 1; i < r.last; ++i, count += 1.0)
            sum = sum + of.place(i) - cells_ * c.at(as_double(of.edge(i).t0));
        const bool inner = count > 0.0;
        if (!inner) {
            sum = of.place(r.first) - cells_ * c.at(r.t0) + of.place(r.last) - cells_ * c.at(r.t1);
            count = 2.0;
        }
        const point mean = (1.0 / count) * sum;
        r.shift = {std::floor(mean.x + 0.5), std::floor(mean.y + 0.5)};
        if (length(mean) <= (inner ? 1.0 : reach_)) r.shift = {};
        const point first = of.place(r.first) - place(of, r, r.t0), last = of.place(r.last) - place(of, r, r.t1);
        r.follows = length(first) <= reach_ && length(last) <= reach_;
        for (std::uint32_t i = r.first + 1; i < r.last && r.follows; ++i)
            r.follows = length(of.place(i) - place(of, r, as_double(of.edge(i).t0))) <= slack_;
    }

    [[nodiscard]] point place(const loop& of, const detail::curve_chain& r, double t) const noexcept
    {
        return detail::place_on(of.curves[r.curve], t, cells_, r.shift);
    }
    [[nodiscard]] static bool is_end(double t) noexcept { return !(t > 0.0) || !(t < 1.0); }

    /// The point where a chain ends and the next one begins. Their parameters are set to it.
    [[nodiscard]] point meet(const loop& of, detail::curve_chain& a, detail::curve_chain& b) noexcept
    {
        const point corner = of.place(b.first);
        const point end = a.follows ? place(of, a, a.t1) : corner, begin = b.follows ? place(of, b, b.t0) : corner;
        const bool ends = !a.follows || is_end(a.t1), begins = !b.follows || is_end(b.t0);
        constexpr double close = 2.0;
        if (ends && begins) {
            const bool one = length(end - begin) <= close && length(end - corner) <= close;
            return !one ? corner : a.follows ? end : begin;
        }
        if (!a.follows || !b.follows) return corner;
        const auto m = detail::meeting_of({&of.curves[a.curve], a.shift, a.t1}, {&of.curves[b.curve], b.shift, b.t0},
                                          cells_, corner, reach_);
        const bool up = a.t0<a.t1, down = b.t0> b.t1;
        if (!m.found || (up ? !(a.t0 < m.s) : !(m.s < a.t0)) || (down ? !(m.t > b.t1) : !(m.t < b.t1))) return corner;
        a.t1 = m.s;
        b.t0 = m.t;
        ++meetings_;
        return m.at;
    }

    /// Adds a chain's piece, or its edges.
    [[nodiscard]] bool add_chain(const loop& of, const detail::curve_chain& r, point end, outline& out) noexcept
    {
        if (r.follows && add_piece(of, r, end, out)) return !failed_;
        point at = r.start;
        for (std::uint32_t i = r.first + 1; i <= r.last; ++i) {
            const point next = i == r.last ? end : of.place(i);
            if (!add(curve::from(at, next), out)) return false;
            at = next;
            ++straight_;
        }
        return true;
    }

    /// Adds a chain's piece of its curve. Its ends are moved to where it must begin and end, the points between in
    /// proportion. False if it is then too far from the region.
    [[nodiscard]] bool add_piece(const loop& of, const detail::curve_chain& r, point end, outline& out) noexcept
    {
        failed_ = false;
        curve piece = detail::piece_of(of.curves[r.curve], r.t0, r.t1);
        const std::uint32_t n = piece.degree;
        for (std::uint32_t i = 0; i <= n; ++i) piece.p[i] = cells_ * piece.p[i] + r.shift;
        const point first = r.start - piece.p[0], last = end - piece.p[n];
        if (!(length(first) <= reach_) || !(length(last) <= reach_)) return false;
        for (std::uint32_t i = 1; i < n; ++i)
            piece.p[i] = piece.p[i] + lerp(first, last, static_cast<double>(i) / static_cast<double>(n));
        piece.p[0] = r.start;
        piece.p[n] = end;
        const double span = r.t1 - r.t0;
        for (std::uint32_t i = r.first + 1; i < r.last; ++i) {
            double share = (as_double(of.edge(i).t0) - r.t0) / span;
            if (!(share > 0.0)) share = 0.0;
            if (share > 1.0) share = 1.0;
            if (!(length(of.place(i) - piece.at(share)) <= slack_)) return false;
        }
        failed_ = !add(piece, out);
        return true;
    }

    /// Adds a curve in cells, unless all its points are one.
    [[nodiscard]] bool add(curve c, outline& out) const noexcept
    {
        bool is_point = true;
        for (std::uint32_t i = 1; i <= c.degree; ++i) is_point = is_point && c.p[i] == c.p[0];
        if (is_point) return true;
        for (std::uint32_t i = 0; i <= c.degree; ++i) {
            c.p[i] = {c.p[i].x / cells_, c.p[i].y / cells_};
            out.bounds.add(c.p[i]);
        }
        return out.curves.push_back(c);
    }

    buffer<detail::curve_chain> chains_;
    double cells_ = 1.0;
    double slack_ = 0.0;   // of points between the ends of a chain, in cells
    double reach_ = 0.0;   // of its ends
    bool failed_ = false;  // out of memory
    std::uint32_t meetings_ = 0, straight_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/impl/box_tree.hpp>
#include <typemesh/extrude/impl/conic_fit.hpp>
#include <typemesh/extrude/impl/curve_piece.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A region's boundary as a few arcs of conics and straight edges, whose control triangles do not meet.
///
///     edges of one curve -- join --> chains -- fit --> pieces -- compare --> pieces
///                                                      ^         + meet
///                                                      +- split -+
///
/// Consecutive edges of one curve become a chain. It is divided where a cubic turns to the other side, then into as
/// few equal parts as suffice, up to four: each piece is an arc within 2 cells of the curve (conic_fit) and within 3
/// cells of the region's points that it skips. If four do not suffice, it is halved until all are. If two control
/// triangles meet, the larger one is divided at a point of the region, or inside an edge if only one is left. At last
/// a piece is an edge of the region, and these do not cross: the region proves it.
///
///         .--c--.                   .-c-.-c-.
///        / .---. \                 /.--- ---.\        .
///       +---------+   becomes     +-----+-----+
///        \ .---. /                 \.--- ---./
///         '--c--'                   '-c-'-c-'
///
/// Cost   O(n) for n edges of the region, and O(log n) for each piece while pieces meet few others
class curved_boundary {
public:
    explicit curved_boundary(memory source = heap()) noexcept
        : points_{source}, edges_{source}, pieces_{source}, next_{source}, tree_{source}
    {
    }

    void clear() noexcept
    {
        pieces_.clear();
        points_.clear();
        edges_.clear();
    }

    /// Finds the pieces of a region. Crossings are moved onto their curves, unless `with_crossings` is false or pieces
    /// would then meet. Fails only with error::out_of_memory.
    [[nodiscard]] error find(const region& filled, bool with_crossings = true) noexcept
    {
        curves_ = filled.curves();
        cells_ = filled.grid().cells;
        tolerance_ = filled.tolerance();
        for (;;) {
            clear();
            moved_ = 0;
            stuck_ = false;
            for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop)
                if (!add_loop(filled, filled.starts()[loop], filled.starts()[loop + 1], with_crossings))
                    return error::out_of_memory;
            if (error e = part_pieces()) return e;
            if (!stuck_ || moved_ == 0) return {};  // the region's own edges do not meet
            with_crossings = false;
        }
    }

    /// The number of crossings that were moved onto their curves.
    [[nodiscard]] std::uint32_t moved() const noexcept { return moved_; }

    /// The pieces, loop by loop.
    [[nodiscard]] array_view<const curve_piece> pieces() const noexcept { return pieces_.view(); }

private:
    // curve_piece::fate
    static constexpr std::uint8_t stay = 0, split = 1, revert = 2;

    // --- chains

    /// Copies a loop's points and edges, beginning where a chain begins, and adds its pieces.
    [[nodiscard]] bool add_loop(const region& filled, std::uint32_t begin, std::uint32_t end,
                                bool with_crossings) noexcept
    {
        const auto edges = filled.edges();
        std::uint32_t seam = begin;
        while (seam < end && goes_on(edges[seam == begin ? end - 1 : seam - 1], edges[seam])) ++seam;
        if (seam == end) seam = begin;
        const auto base = static_cast<std::uint32_t>(edges_.size());
        for (const auto [from, to] : {range{seam, end}, range{begin, seam}})
            if (!points_.append(filled.points().subspan(from, to - from)) ||
                !edges_.append(edges.subspan(from, to - from)))
                return false;
        const auto last = static_cast<std::uint32_t>(edges_.size());
        if (with_crossings && tolerance_ > 2.0)
            for (std::uint32_t i = base; i < last; ++i)
                move_crossing(i == base ? last - 1 : i - 1, i, i + 1 == last ? base : i + 1);
        first_point_ = points_[base];
        for (std::uint32_t i = base; i < last;) {
            std::uint32_t k = i + 1;
            while (k < last && goes_on(edges_[k - 1], edges_[k])) ++k;
            const std::size_t before = pieces_.size();
            if (!add_bends(whole(i, k, last))) return false;
            if (i == base) pieces_[before].begins_loop = true;
            i = k;
        }
        return true;
    }

    struct range {
        std::uint32_t from, to;
    };

    /// Whether an edge continues the curve of the edge before it. Parameters may jump by less than 4 cells.
    [[nodiscard]] bool goes_on(const contour_edge& before, const contour_edge& e) const noexcept
    {
        if (before.curve != e.curve || e.curve >= curves_.size()) return false;
        const bool up = e.t0 < e.t1;
        if ((before.t0 < before.t1) != up || (up ? e.t0 < before.t1 : e.t0 > before.t1)) return false;
        const curve& c = curves_[e.curve];
        double legs = 0.0;
        for (std::uint32_t k = 0; k < c.degree; ++k) legs += length(c.p[k + 1] - c.p[k]);
        return std::abs(as_double(e.t0) - as_double(before.t1)) * legs * c.degree * cells_ <= 4.0;
    }

    /// Moves the point between two edges to where their curves cross, if it is a crossing of their chords: by Newton's
    /// method. It stays if that is no point of both edges, is not near, or makes an edge so long that it is no more
    /// within the tolerance.
    void move_crossing(std::uint32_t before, std::uint32_t after, std::uint32_t next) noexcept
    {
        contour_edge &e = edges_[before], &f = edges_[after];
        const auto is_end = [](float t) noexcept { return !(t > 0.0f) || !(t < 1.0f); };
        if (e.curve == f.curve || e.curve >= curves_.size() || f.curve >= curves_.size()) return;
        if (is_end(e.t1) && is_end(f.t0)) return;
        const curve &a = curves_[e.curve], &b = curves_[f.curve];
        const hodograph of_a{a}, of_b{b};
        const point was = curve_section::exact(points_[after]);
        const double reach = 4.0 * tolerance_ + 4.0;
        double s = as_double(e.t1), t = as_double(f.t0);
        if (length(cells_ * a.at(s) - was) > reach || length(cells_ * b.at(t) - was) > reach) return;
        point gap = cells_ * (a.at(s) - b.at(t));
        for (int step = 0; step < 8 && dot(gap, gap) > 0x1p-10; ++step) {
            const point along = cells_ * a.degree * of_a.derivative(s), other = cells_ * b.degree * of_b.derivative(t);
            const double turn = cross(along, other);
            if (!(turn * turn > 0x1p-16 * dot(along, along) * dot(other, other))) return;
            s -= cross(gap, other) / turn;
            t -= cross(gap, along) / turn;
            if (!(s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)) return;
            gap = cells_ * (a.at(s) - b.at(t));
        }
        const point found = cells_ * a.at(s);
        const auto new_s = static_cast<float>(s), new_t = static_cast<float>(t);
        const bool is_before = e.t0 < e.t1 ? e.t0 < new_s : new_s < e.t0;
        const bool is_after = f.t0 < f.t1 ? new_t < f.t1 : f.t1 < new_t;
        if (dot(gap, gap) > 0x1p-10 || !is_before || !is_after || length(found - was) > reach) return;
        const grid_point place = grid{.cells = 1.0}.snap(found);
        const auto is_close = [&](const curve& c, float from, float to, grid_point p, grid_point q) noexcept {
            const double high = curve_section::of(c, as_double(from), as_double(to), cells_, p, q).height();
            return high >= 0.0 && high <= tolerance_;
        };
        if ((e.t0 < e.t1 ? new_s > e.t1 : new_s < e.t1) && !is_close(a, e.t0, new_s, points_[before], place)) return;
        if ((f.t0 < f.t1 ? new_t < f.t0 : new_t > f.t0) && !is_close(b, new_t, f.t1, place, points_[next])) return;
        points_[after] = place;
        e.t1 = new_s;
        f.t0 = new_t;
        ++moved_;
    }

    /// The straight piece over the edges [first, last) of a loop that ends before edge `loop_end`.
    [[nodiscard]] curve_piece whole(std::uint32_t first, std::uint32_t last, std::uint32_t loop_end) const noexcept
    {
        curve_piece p;
        p.start = points_[first];
        p.end = last == loop_end ? first_point_ : points_[last];
        p.first = first;
        p.last = last;
        p.t0 = edges_[first].t0;
        p.t1 = edges_[last - 1].t1;
        return p;
    }

    /// Adds the pieces of a chain, which is divided first where a cubic turns from one side to the other.
    [[nodiscard]] bool add_bends(const curve_piece& chain) noexcept
    {
        const std::uint32_t of = edges_[chain.first].curve;
        if (of >= curves_.size() || curves_[of].degree != 3) return add_chain(chain);
        const turning_points turns = turning_points_of(curves_[of].as_cubic());
        curve_piece rest = chain, first;
        const bool up = chain.t0 < chain.t1;
        for (std::uint32_t i = 0; i < turns.count; ++i) {
            const auto t = static_cast<float>(turns.t[up ? i : turns.count - 1 - i]);
            constexpr float margin = 0.02f;  // what is shorter hardly turns
            const bool inside =
                up ? rest.t0 + margin < t && t < rest.t1 - margin : rest.t1 + margin < t && t < rest.t0 - margin;
            if (!inside || !cut(rest, t, first, rest)) continue;
            if (!add_chain(first)) return false;
        }
        return add_chain(rest);
    }

    /// Adds the pieces of a chain: up to four of about equal length, if they fit.
    [[nodiscard]] bool add_chain(const curve_piece& chain) noexcept
    {
        const std::size_t before = pieces_.size();
        for (std::uint32_t count = 1; count <= 4; ++count) {
            curve_piece rest = chain;
            bool all_fit = true;
            for (std::uint32_t k = 0; k < count && all_fit; ++k) {
                curve_piece part = rest;
                if (k + 1 < count) {
                    const float share = static_cast<float>(k + 1) / static_cast<float>(count);
                    if (!cut(rest, chain.t0 + share * (chain.t1 - chain.t0), part, rest)) break;
                }
                all_fit = fit(part);
                if (!pieces_.push_back(part)) return false;
                if (k + 1 == count && all_fit) return true;
            }
            pieces_.truncate(before);
        }
        return add_halves(chain);
    }

    /// Adds the pieces of a section, each half as long as the one before it until they fit.
    [[nodiscard]] bool add_halves(const curve_piece& section) noexcept
    {
        curve_piece waiting[64];
        std::size_t depth = 0;
        waiting[depth++] = section;
        while (depth != 0) {
            curve_piece p = waiting[--depth], first, second;
            if (!fit(p) && depth + 2 <= 64 && halve(p, first, second)) {
                waiting[depth++] = second;
                waiting[depth++] = first;
            } else if (!pieces_.push_back(p)) {
                return false;
            }
        }
        return true;
    }

    // --- pieces

    /// Makes a section an arc or a straight piece. If neither fits, the piece is straight, and the result is false.
    [[nodiscard]] bool fit(curve_piece& p) const noexcept
    {
        constexpr double straight_error = 1.0, skipped_error = 3.0;
        p.weight = 0.0f;
        p.control = p.start;
        const contour_edge& e = edges_[p.first];
        if (p.start == p.end) return false;
        const bool single = p.first + 1 == p.last;
        if (e.curve >= curves_.size()) return single;
        const auto section =
            curve_section::of(curves_[e.curve], as_double(p.t0), as_double(p.t1), cells_, p.start, p.end);
        const double height = section.degree == 1 ? 0.0 : section.height();
        if (height >= 0.0 && height <= straight_error)
            return each_skipped(p, [&](point q) noexcept {
                const point chord = section.p[section.degree];
                const double across = cross(chord, q), along = dot(chord, q), square = dot(chord, chord);
                return across * across <= square * (straight_error + 1.0) * (straight_error + 1.0) &&
                       along > -straight_error * std::sqrt(square) &&
                       along < square + straight_error * std::sqrt(square);
            });
        // A single edge is farther from its curve than the tolerance: the boundary has been moved, or the curve belongs
        // to a glyph of another size.
        if (single && tolerance_ > 0.0 && !(height <= 4.0 * tolerance_ + 4.0)) return true;
        const fitted_conic conic = fit_conic(section, p.start);
        if (!(conic.weight > 0.0f)) return false;
        conic_arc arc{curve_section::exact(conic.control) - curve_section::exact(p.start), section.p[section.degree]};
        arc.square = as_double(conic.weight) * as_double(conic.weight);
        if (!each_skipped(p, [&](point q) noexcept { return arc.passes(q, skipped_error); })) return false;
        p.control = conic.control;
        p.weight = conic.weight;
        return true;
    }

    /// Whether all points of the region that the piece skips pass a test; they are relative to its start.
    template <class Test>
    [[nodiscard]] bool each_skipped(const curve_piece& p, const Test& passes) const noexcept
    {
        for (std::uint32_t i = p.first + 1; i < p.last; ++i)
            if (!passes(curve_section::exact(points_[i]) - curve_section::exact(p.start))) return false;
        return true;
    }

    /// Divides a section at the point of the region whose parameter is nearest to t, or at a new point if the section
    /// skips none. False if there is no point between its ends.
    [[nodiscard]] bool cut(const curve_piece& p, float t, curve_piece& first, curve_piece& second) const noexcept
    {
        curve_piece a = p, b = p;
        if (p.first + 1 < p.last) {
            std::uint32_t best = p.first + 1;
            for (std::uint32_t i = best + 1; i < p.last; ++i)
                if (std::abs(edges_[i].t0 - t) < std::abs(edges_[best].t0 - t)) best = i;
            a.last = b.first = best;
            a.t1 = edges_[best - 1].t1;
            b.t0 = edges_[best].t0;
            a.end = b.start = points_[best];
        } else {
            const contour_edge& e = edges_[p.first];
            if (e.curve >= curves_.size() || curves_[e.curve].degree == 1) return false;
            if (!((p.t0 < t && t < p.t1) || (p.t1 < t && t < p.t0))) return false;
            const auto section =
                curve_section::of(curves_[e.curve], as_double(p.t0), as_double(p.t1), cells_, p.start, p.end);
            if (tolerance_ > 0.0 && !(section.height() <= 4.0 * tolerance_ + 4.0)) return false;
            const double share = (as_double(t) - as_double(p.t0)) / (as_double(p.t1) - as_double(p.t0));
            const point q = section.at(share) + curve_section::exact(p.start);
            if (!(std::abs(q.x) < grid::reach && std::abs(q.y) < grid::reach)) return false;
            a.end = b.start = grid{.cells = 1.0}.snap(q);
            if (a.end == p.start || a.end == p.end) return false;
            a.t1 = b.t0 = t;
            a.is_part = b.is_part = true;
        }
        b.begins_loop = false;
        a.is_fresh = b.is_fresh = true;
        a.fate = b.fate = stay;
        first = a;
        second = b;
        return true;
    }
    [[nodiscard]] bool halve(const curve_piece& p, curve_piece& first, curve_piece& second) const noexcept
    {
        return cut(p, 0.5f * (p.t0 + p.t1), first, second);
    }

    // --- rounds

    /// Divides pieces until none meet.
    [[nodiscard]] error part_pieces() noexcept
    {
        constexpr int max_rounds = 64;
        for (int round = 0; round < max_rounds; ++round) {
            if (!list_boxes()) return error::out_of_memory;
            if (!compare()) return {};
            if (!divide()) return error::out_of_memory;
        }
        stuck_ = true;
        return {};
    }

    [[nodiscard]] static grid_box box_of(const curve_piece& p) noexcept
    {
        grid_box b;
        b.add(p.start);
        b.add(p.end);
        if (!p.is_straight()) b.add(p.control);
        return b;
    }

    [[nodiscard]] bool list_boxes() noexcept
    {
        if (!tree_.open(pieces_.size())) return false;
        for (std::size_t i = 0; i < pieces_.size(); ++i) tree_.set(i, box_of(pieces_[i]));
        tree_.close();
        return true;
    }

    /// Decides which pieces must be divided, because they meet others. False if there are none.
    [[nodiscard]] bool compare() noexcept
    {
        bool any = false;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            curve_piece& p = pieces_[i];
            if (!p.is_fresh) continue;
            tree_.each_meeting(box_of(p), [&](std::size_t k) noexcept {
                curve_piece& q = pieces_[k];
                if (k == i || (q.is_fresh && k < i) || p.fate != stay || q.fate != stay || !pieces_meet(p, q)) return;
                const std::int64_t of_p = size_of(p), of_q = size_of(q);
                if (of_p >= of_q) choose(p);
                if (of_q >= of_p) choose(q);
                const bool chosen = p.fate != stay || q.fate != stay;
                any = any || chosen;
                stuck_ = stuck_ || !chosen;
            });
        }
        for (curve_piece& p : pieces_) p.is_fresh = false;
        return any;
    }

    /// The size by which the larger of two pieces is found: of arcs before straight pieces of several edges, and these
    /// before parts of edges.
    [[nodiscard]] static std::int64_t size_of(const curve_piece& p) noexcept
    {
        const std::int64_t area = p.doubled_area();
        if (area != 0) return area < 0 ? 3 - area : 3 + area;
        return p.last - p.first > 1 ? 2 : p.is_part ? 1 : 0;
    }
    static void choose(curve_piece& p) noexcept
    {
        const bool can_split = !p.is_straight() || p.last - p.first > 1;
        if (can_split)
            p.fate = split;
        else if (p.is_part)
            p.fate = revert;
    }

    /// Divides the pieces that were chosen.
    [[nodiscard]] bool divide() noexcept
    {
        next_.clear();
        for (std::size_t i = 0; i < pieces_.size();) {
            std::size_t end = i + 1;
            bool reverts = pieces_[i].fate == revert;
            if (pieces_[i].is_part)  // with the other parts of its edge
                for (; end < pieces_.size() && pieces_[end].is_part && pieces_[end].first == pieces_[i].first; ++end)
                    reverts = reverts || pieces_[end].fate == revert;
            if (reverts) {
                if (!next_.push_back(joined(pieces_[i], pieces_[end - 1]))) return false;
            } else {
                for (std::size_t k = i; k < end; ++k)
                    if (!divide(pieces_[k])) return false;
            }
            i = end;
        }
        pieces_.swap(next_);
        return true;
    }

    /// The straight edge of the region in place of all its parts.
    [[nodiscard]] static curve_piece joined(const curve_piece& first, const curve_piece& last) noexcept
    {
        curve_piece p = first;
        p.end = last.end;
        p.t1 = last.t1;
        p.control = p.start;
        p.weight = 0.0f;
        p.is_part = false;
        p.is_fresh = true;
        p.fate = stay;
        return p;
    }

    [[nodiscard]] bool divide(const curve_piece& p) noexcept
    {
        if (p.fate != split) return next_.push_back(p);
        curve_piece halves[2];
        if (!halve(p, halves[0], halves[1])) {
            curve_piece straight = joined(p, p);
            straight.is_part = p.is_part;
            return next_.push_back(straight);
        }
        // What does not fit is straight for now; it is divided again, and then may fit.
        for (curve_piece& half : halves) {
            const std::size_t before = pieces_.size();
            if (!fit(half)) {
                if (!add_halves(half)) return false;
                const bool kept = next_.append(pieces_.view().subspan(before, pieces_.size() - before));
                pieces_.truncate(before);
                if (!kept) return false;
            } else if (!next_.push_back(half)) {
                return false;
            }
        }
        return true;
    }

    array_view<const curve> curves_;
    double cells_ = 1.0;
    double tolerance_ = 0.0;
    grid_point first_point_;
    std::uint32_t moved_ = 0;
    bool stuck_ = false;
    buffer<grid_point> points_;  // of the region, each loop from the beginning of a chain
    buffer<contour_edge> edges_;
    buffer<curve_piece> pieces_, next_;
    box_tree tree_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

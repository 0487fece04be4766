// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/box_tree.hpp>
#include <typemesh/fill/outer_of.hpp>
#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/layer_arrangement.hpp>
#include <typemesh/plate/silhouette.hpp>
#include <typemesh/plate/stencil_wishes.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The bridges of a stencil, and what they tie.
struct stencil_report {
    std::uint32_t islands = 0;  ///< the number of islands that would fall out without bridges
    std::uint32_t bridges = 0;  ///< the number of bridges that were made
    std::uint32_t loose = 0;    ///< the number of islands that still fall out: 0, unless no bar can reach them
};

/// A bridge: an upright or a level rectangle of the plane's grid.
struct stencil_bar {
    grid_point low, high;
    bool upright = true;  ///< whether its ends, which lie in solid plate, are its lower and upper sides

    [[nodiscard]] constexpr std::int32_t width() const noexcept { return upright ? high.x - low.x : high.y - low.y; }
};

/// Finds the bridges that tie the islands of a stencil: the counters of cut letters, which would fall out.
///
///        .-----.          An island is a component of the plate that is not joined to the rim. A bridge is an upright
///       / .-|-. \         or level rectangle across the stroke beside the island. It is as wide as requested, and it
///      | | ||| | |        spans the stroke over its whole width: its ends reach into the plate on both sides, or as
///       \ '-|-' /         far as there is plate, where this is narrower than the bridge.
///        '-----'
///
/// For each island, places are tried along its width; upright bridges are tried first. Of these places the one with the
/// shortest bar counts, and of equal ones the one nearest to the middle. Further bridges of an island leave on the
/// other side if they can, or keep a bridge's width away from the first. Level bridges are used if an upright bar
/// would be more than twice as long, or finds no solid. Islands that only reach other islands are tied in the next
/// round.
///
/// Which places are chosen is a matter of taste and uses floating point. That nothing is loose is not: tie() counts the
/// components of the traced region, which is exact.
class stencil_bridges {
public:
    static constexpr int max_rounds = 8;  ///< the greatest number of rounds: tie() is called until nothing is loose

    explicit stencil_bridges(memory source = heap()) noexcept
        : loops_{source},
          component_{source},
          tied_{source},
          edges_{source},
          tree_{source},
          hits_{source},
          lines_{source},
          made_{source}
    {
    }

    /// Begins a new stencil.
    void clear() noexcept
    {
        report_ = {};
        made_.clear();
        is_first_ = true;
    }
    /// What the rounds have found and made.
    [[nodiscard]] const stencil_report& report() const noexcept { return report_; }
    /// All bars of the stencil.
    [[nodiscard]] array_view<const stencil_bar> bars() const noexcept { return made_.view(); }

    /// Counts the islands of `solid` that are loose now. The first call also sets stencil_report::islands.
    ///
    /// Fails  error::out_of_memory, and as layer_arrangement::trace() does
    /// Cost   O(edges)
    [[nodiscard]] result<void> count(layer_arrangement& cells, cell_set solid, std::uint32_t rim_edges,
                                     workspace& space) noexcept
    {
        const auto traced = cells.trace(solid, space, loops_);
        if (!traced) return traced.error();
        region_ = *traced;
        if (error e = find_components(rim_edges, space)) return e;
        report_.loose = 0;
        for (std::uint32_t k = 0; k < region_.loop_count(); ++k) report_.loose += component_[k] == k && tied_[k] == 0;
        if (is_first_) report_.islands = report_.loose;
        is_first_ = false;
        return {};
    }

    /// One round: counts the islands of `solid`, and adds bars for them.
    ///
    ///     solid       the cells of the plate that remain when the letters are cut, with the bridges so far
    ///     rim_edges   sources with lower numbers are the plate's outer rim: components with one of them are no
    ///                 islands. The edges of its holes have higher numbers: a ring around a hole may fall out as well
    ///     bars        receives the bars
    ///
    /// Returns whether bars were added: then make the arrangement with them, and call tie() again, or count() after the
    /// last round.
    ///
    /// Fails  error::bad_option ("width", "per_island"): a wish outside its range. error::out_of_memory, and as
    ///        layer_arrangement::trace() does
    /// Cost   O(edges), and for each of the few hundred lines per bridge O(log(edges)) and the edges that it meets near
    ///        the island: see box_tree
    [[nodiscard]] result<bool> tie(layer_arrangement& cells, cell_set solid, std::uint32_t rim_edges,
                                   const stencil_wishes& wanted, silhouette& bars, workspace& space) noexcept
    {
        bool more = false;
        if (error e = wanted.refused()) return e;
        if (const auto counted = count(cells, solid, rim_edges, space); !counted) return counted.error();
        if (report_.loose == 0) return more;
        if (error e = list_edges()) return e;
        for (std::uint32_t k = 0; k < region_.loop_count(); ++k) {
            if (component_[k] != k || tied_[k] != 0) continue;
            if (error e = tie_island(island_of(k), wanted, bars, more)) return e;
        }
        return more;
    }

private:
    /// A component that is not joined to the rim.
    struct island {
        std::uint32_t component;
        detail::grid_box box;
    };
    /// An edge of the solid's boundary.
    struct rim_edge {
        grid_point from, to;
        std::uint32_t component;
    };
    /// A bar across a stroke, in the direction in which it was sought.
    struct bar {
        bool found = false;
        bool upright = true;
        bool up = true;                // it leaves the island upwards, or to the right
        double along = 0.0;            // its middle
        double low = 0.0, high = 0.0;  // its ends
        [[nodiscard]] double length() const noexcept { return high - low; }
    };
    /// A place where a line crosses the boundary.
    struct hit {
        double at;
        std::uint32_t component;
        [[nodiscard]] bool before(const hit& other) const noexcept { return at < other.at; }
    };

    /// Gives each loop the number of its component's outer loop, and finds the components that touch the rim.
    [[nodiscard]] error find_components(std::uint32_t rim_edges, workspace& space) noexcept
    {
        const std::uint32_t loops = region_.loop_count();
        component_.clear();
        tied_.clear();
        std::uint32_t* const component = component_.append(loops);
        std::uint8_t* const tied = tied_.append(loops);
        if (loops != 0 && (component == nullptr || tied == nullptr)) return error::out_of_memory;
        if (const auto done = outer_of(region_, space, {component, loops}); !done) return done.error();
        for (std::uint32_t k = 0; k < loops; ++k) tied[k] = 0;
        for (std::uint32_t k = 0; k < loops; ++k)
            for (std::uint32_t i = region_.starts()[k]; i < region_.starts()[k + 1]; ++i)
                if (region_.edges()[i].curve < rim_edges) tied[component[k]] = 1;
        return {};
    }

    /// Lists the edges, and puts their boxes into a tree.
    [[nodiscard]] error list_edges() noexcept
    {
        const auto points = region_.points();
        edges_.clear();
        if (!edges_.reserve(points.size()) || !tree_.open(points.size())) return error::out_of_memory;
        around_ = {};
        for (std::uint32_t k = 0; k < region_.loop_count(); ++k) {
            const std::uint32_t first = region_.starts()[k], end = region_.starts()[k + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                const rim_edge e{points[i], points[i + 1 < end ? i + 1 : first], component_[k]};
                detail::grid_box box;
                box.add(e.from);
                box.add(e.to);
                around_.merge(box);
                tree_.set(i, box);
                edges_.push_back_unchecked(e);
            }
        }
        tree_.close();
        return {};
    }

    /// The island with this outer loop.
    [[nodiscard]] island island_of(std::uint32_t loop) const noexcept
    {
        island made{loop, {}};
        for (std::uint32_t i = region_.starts()[loop]; i < region_.starts()[loop + 1]; ++i)
            made.box.add(edges_[i].from);
        return made;
    }

    [[nodiscard]] error tie_island(const island& of, const stencil_wishes& wanted, silhouette& bars,
                                   bool& more) noexcept
    {
        bar made[stencil_wishes::max_per_island];
        const std::int32_t width = wanted.width;
        for (std::uint32_t b = 0; b < wanted.per_island; ++b) {
            bar best;
            if (error e = find_bar(of, true, width, {made, b}, best)) return e;
            bar level;
            if (error e = find_bar(of, false, width, {made, b}, level)) return e;
            if (level.found && (!best.found || best.length() > 2.0 * level.length())) best = level;
            if (!best.found) break;
            const std::int32_t half = (width + 1) / 2;
            bar exact[2];
            if (error e = spread_lines(best.along, half + 1.0)) return e;
            if (error e = add_corners(best, half + 1.0)) return e;
            if (error e = bars_at(of, best.upright, best.along, exact)) return e;
            if (exact[best.up ? 1 : 0].found) best = exact[best.up ? 1 : 0];
            made[b] = best;
            const std::int32_t into = 2 + half / 4;  // so far the bar reaches into the solid
            const std::int32_t along = down(best.along), low = down(best.low) - into,
                               high = static_cast<std::int32_t>(std::ceil(best.high)) + into;
            const grid_point from = place(along - half, low, best.upright),
                             to = place(along + half, high, best.upright);
            if (const auto done = bars.add_rectangle(from, to, 0.0, 1.0); !done) return done.error();
            if (!made_.push_back({from, to, best.upright})) return error::out_of_memory;
            ++report_.bridges;
            more = true;
        }
        return {};
    }

    /// The best bar in one direction that keeps away from those made before.
    [[nodiscard]] error find_bar(const island& of, bool upright, std::int32_t width, array_view<const bar> made,
                                 bar& best) noexcept
    {
        constexpr int places = 17;
        const double low = across(of.box.low, upright), high = across(of.box.high, upright);
        const double middle = 0.5 * (low + high), half = 0.5 * width;
        const double reach = 0.5 * (high - low) - half;  // the bar's middle stays so near to the island's
        const int tried = reach > 0.0 ? places : 1;
        double cost = 0.0;
        for (int k = 0; k < tried; ++k) {
            // From the middle outwards: 0, 1, -1, 2, -2, ...
            const int step = k % 2 != 0 ? (k + 1) / 2 : -(k / 2);
            const double along = middle + (tried == 1 ? 0.0 : reach * step / (places / 2));
            bar found[2];
            if (error e = spread_lines(along, half)) return e;
            if (error e = bars_at(of, upright, along, found)) return e;
            for (const bar& b : found) {
                if (!b.found) continue;
                double own = b.length() * (1.0 + 0.5 * std::fabs(along - middle) / (high - low));
                bool free = true;
                for (const bar& other : made) {
                    if (other.upright != b.upright || other.up != b.up) continue;
                    own *= 4.0;  // the other side is better
                    free = free && std::fabs(other.along - along) >= 2.0 * width;
                }
                if (!free || (best.found && own >= cost)) continue;
                best = b;
                cost = own;
            }
        }
        return {};
    }

    /// The bars at one place: the one that leaves the island upwards, and the one that leaves it downwards. They span
    /// the stroke on each of lines_; the first line is the middle.
    [[nodiscard]] error bars_at(const island& of, bool upright, double along, bar* found) noexcept
    {
        bool ok[2] = {true, true};
        std::uint32_t other[2] = {nothing, nothing};
        double edge[2] = {0.0, 0.0};  // the island's ends on the first line
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (error e = cross(lines_[k], upright, of.box)) return e;
            std::size_t top = 0, bottom = 0;  // 1 + the island's last and first place on the line
            for (std::size_t i = 0; i < hits_.size(); ++i) {
                if (hits_[i].component != of.component) continue;
                top = i + 1;
                if (bottom == 0) bottom = i + 1;
            }
            if (k == 0 && top == 0) return {};
            if (k == 0) {
                edge[0] = hits_[bottom - 1].at;
                edge[1] = hits_[top - 1].at;
            }
            for (std::size_t up = 0; up < 2; ++up) {
                bar& b = found[up];
                std::size_t next = 0;  // 1 + the place where the stroke ends
                double own = edge[up];
                if (top != 0) {
                    const std::size_t at = up != 0 ? top - 1 : bottom - 1;
                    own = hits_[at].at;
                    next = up != 0 ? (at + 1 < hits_.size() ? at + 2 : 0) : at;
                } else {  // beside a narrow island
                    for (std::size_t i = 0; i < hits_.size(); ++i) {
                        if (up == 0 && hits_[i].at < own) next = i + 1;
                        if (up != 0 && hits_[i].at > own && next == 0) next = i + 1;
                    }
                }
                if (next == 0) {
                    ok[up] = false;
                    continue;
                }
                const hit& beyond = hits_[next - 1];
                if (other[up] == nothing) other[up] = beyond.component;
                if (beyond.component != other[up]) ok[up] = false;
                const double low = up != 0 ? own : beyond.at, high = up != 0 ? beyond.at : own;
                b.low = b.found && b.low < low ? b.low : low;
                b.high = b.found && b.high > high ? b.high : high;
                b.found = true;
            }
        }
        for (std::size_t up = 0; up < 2; ++up) {
            found[up].found = found[up].found && ok[up];
            found[up].upright = upright;
            found[up].up = up != 0;
            found[up].along = along;
        }
        return {};
    }

    /// Lines at the middle and over the width of a bar.
    [[nodiscard]] error spread_lines(double along, double half) noexcept
    {
        constexpr int count = 9;
        lines_.clear();
        for (int k = 0; k < count; ++k) {
            const int step = k % 2 != 0 ? (k + 1) / 2 : -(k / 2);
            if (!lines_.push_back(std::floor(along + half * step / (count / 2)) + 0.5)) return error::out_of_memory;
        }
        return {};
    }

    /// Adds a line on both sides of each corner that lies within a bar's width and not far from it. A boundary's
    /// extremes lie at corners, so the bar then spans the stroke everywhere.
    [[nodiscard]] error add_corners(const bar& b, double half) noexcept
    {
        const double slack = b.length() + half, wide = half + 1.0;
        const detail::grid_box window{place(down(b.along - wide), down(b.low - slack), b.upright),
                                      place(down(b.along + wide), down(b.high + slack), b.upright)};
        bool ok = true;
        tree_.each_meeting(window, [&](std::size_t i) noexcept {
            const double x = across(edges_[i].from, b.upright), y = across(edges_[i].from, !b.upright);
            if (std::fabs(x - b.along) > wide || y < b.low - slack || y > b.high + slack) return;
            ok = ok && lines_.push_back(x - 0.5) && lines_.push_back(x + 0.5);
        });
        return ok ? error{} : error{error::out_of_memory};
    }

    /// Finds the places where a line crosses the boundary, in ascending order: those between the ends of a box, and on
    /// both sides as far as the next one, or farther. The part of the line that is searched grows until it is so.
    [[nodiscard]] error cross(double line, bool upright, const detail::grid_box& box) noexcept
    {
        const std::int32_t beside = down(line), low = across(box.low, !upright), high = across(box.high, !upright);
        for (std::int32_t reach = high - low;; reach *= 2) {
            const std::int32_t from = low - reach, to = high + reach;
            bool ok = true;
            hits_.clear();
            const detail::grid_box window{place(beside, from, upright), place(beside + 1, to, upright)};
            tree_.each_meeting(window, [&](std::size_t i) noexcept {
                const rim_edge& e = edges_[i];
                const double a = across(e.from, upright), b = across(e.to, upright);
                if ((a < line) == (b < line)) return;
                const double c = across(e.from, !upright), d = across(e.to, !upright);
                const double at = c + (line - a) / (b - a) * (d - c);
                ok = ok && (at < from || at > to || hits_.push_back({at, e.component}));
            });
            if (!ok) return error::out_of_memory;
            detail::heap_sort(hits_.data(), hits_.size());
            const bool is_whole = from <= across(around_.low, !upright) && to >= across(around_.high, !upright);
            if (is_whole || (!hits_.empty() && hits_[0].at < low && hits_.back().at > high)) return {};
        }
    }

    /// A point's coordinate across the bars of a direction, and the point with two coordinates: across, and along them.
    static std::int32_t across(grid_point p, bool upright) noexcept { return upright ? p.x : p.y; }
    static grid_point place(std::int32_t beside, std::int32_t on, bool upright) noexcept
    {
        return upright ? grid_point{beside, on} : grid_point{on, beside};
    }
    static std::int32_t down(double v) noexcept { return static_cast<std::int32_t>(std::floor(v)); }

    static constexpr std::uint32_t nothing = 0xFFFF'FFFFu;

    contours loops_;
    region region_;
    buffer<std::uint32_t> component_;  // for each loop
    buffer<std::uint8_t> tied_;        // for each outer loop: whether its component touches the rim
    buffer<rim_edge> edges_;           // as the region's points
    detail::box_tree tree_;            // of the edges
    detail::grid_box around_;          // all edges
    buffer<hit> hits_;                 // of one line
    buffer<double> lines_;             // on which a bar is measured
    buffer<stencil_bar> made_;
    stencil_report report_;
    bool is_first_ = true;
};

}  // namespace typemesh::inline TYPEMESH_ABI

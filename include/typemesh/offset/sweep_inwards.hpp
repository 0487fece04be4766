// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/offset/impl/cell_repair.hpp>
#include <typemesh/offset/impl/reflex_joins.hpp>
#include <typemesh/offset/impl/ring_cutter.hpp>
#include <typemesh/offset/impl/wavefront.hpp>
#include <typemesh/offset/speck_cover.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The options of sweep_inwards(). All lengths are in cells.
struct sweep_options {
    /// The distances at which faces are divided: from 0 to the width, each at least finest_band more than the last.
    array_view<const double> levels;
    /// A reflex corner that would move farther than mitre_limit times the sweep distance is cut off by join edges, at
    /// most 31 of them. 0: only needles are cut off.
    double mitre_limit = 2.0;
    /// The distance by which a corner may end beyond the round join's arc at the full width. A mitre limit near 1 is
    /// raised to allow this, at most to 1.42. 0: unknown.
    double tolerance = 0.0;
    /// Whether joins are rounded, to the tolerance at the full width; otherwise they have only the edges that the mitre
    /// limit requires.
    bool round = true;
    /// The number of joins is chosen as if the sweep went to this width, so corners move exactly as in the wider sweep.
    /// 0: the last level.
    double joins_at = 0.0;
    /// swept_region::first_loss ignores components that are swept completely before this distance, unless all are.
    double speck = 0.0;
    /// Whether the faces are not needed: the sweep then does not fail if some faces cannot be divided into triangles.
    bool only_cap = false;
};

namespace detail {

class inward_sweep {
public:
    inward_sweep(workspace::scope& scratch, swept_region& out) noexcept
        : scratch_{scratch},
          out_{out},
          front_{scratch.source()},
          cutter_{scratch.source()},
          level_of_{scratch.source()},
          same_{scratch.source()},
          path_{scratch.source()},
          stack_{scratch.source()},
          ring_{scratch.source()},
          on_path_{scratch.source()},
          cover_{scratch.source()},
          repair_{scratch.source()}
    {
    }

    [[nodiscard]] error run(const region& r, array_view<const triangle> cap, const sweep_options& how) noexcept
    {
        if (error e = begin(r, cap)) return e;
        if (error e = add_joins(how)) return e;
        given_ = cap;
        only_cap_ = how.only_cap;
        front_.speck = time_of(how.speck);
        if (!front_.start(time_of(how.levels.back()) + early) || !open_cells() || !note_edges())
            return error::out_of_memory;
        const auto bands = static_cast<std::uint32_t>(how.levels.size() - 1);
        for (std::uint32_t band = 0; band < bands; ++band) {
            if (!front_.advance(time_of(how.levels[band + 1]), early))
                return front_.has_failed() ? error::out_of_memory : error::crossing_contours;
            if (error e = reach_level(band)) return e;
            if (band + 1 != bands && !open_cells()) return error::out_of_memory;
        }
        if (error e = make_cap(r)) return e;
        out_.events = front_.events();
        out_.schedules = front_.schedules();
        out_.first_loss = front_.first_loss() < 0 ? -1.0 : static_cast<double>(front_.first_loss()) * 0x1p-32;
        out_.lost = front_.lost();
        const auto triangles = static_cast<std::uint32_t>(out_.triangles.size());
        return out_.levels.append(how.levels) && out_.nodes.append(front_.nodes.view()) &&
                       out_.cells.push_back({0, bands, triangles}) && note_edges_end()
                   ? error::none
                   : error::out_of_memory;
    }

private:
    static constexpr std::uint32_t none = wavefront::none;
    static constexpr std::int64_t early = 2 * time_one;

    [[nodiscard]] static std::int64_t time_of(double cells) noexcept
    {
        return static_cast<std::int64_t>(cells * static_cast<double>(time_one));
    }

    /// Segment, line, vertex and node i belong to point i and the edge that begins there.
    [[nodiscard]] error begin(const region& r, array_view<const triangle> cap) noexcept
    {
        // Half-edges are numbered below 2^31, including up to 31 joins per corner.
        if (r.points().size() > std::size_t{1} << 24 || cap.size() > std::size_t{1} << 25) return error::too_large;
        const auto n = static_cast<std::uint32_t>(r.points().size());
        kinetic_triangles& mesh = front_.mesh;
        if (!mesh.lines.reserve(n) || !mesh.vertices.reserve(3 * n) || !mesh.segments.reserve(n) ||
            !mesh.triangles.reserve(cap.size()) || !front_.nodes.reserve(3 * n) || !front_.node_of.reserve(3 * n) ||
            !front_.ends_of.reserve(n))
            return error::out_of_memory;
        for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
            const std::uint32_t first = r.starts()[loop], end = r.starts()[loop + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                const std::uint32_t next = i + 1 == end ? first : i + 1, last = i == first ? end - 1 : i - 1;
                const grid_point p = r.points()[i], q = r.points()[next];
                mesh.lines.push_back_unchecked({unit_along({std::int64_t{q.x} - p.x, std::int64_t{q.y} - p.y})});
                mesh.vertices.push_back_unchecked({{place_of(p), 0, {}}, last, i});
                mesh.segments.push_back_unchecked({i, i, next, 0, none, true});
                front_.nodes.push_back_unchecked({p, 0.0f});
                front_.node_of.push_back_unchecked(i);
            }
        }
        for (auto& v : mesh.vertices) v.moves.speed = speed_of(mesh.lines[v.before], mesh.lines[v.after], false);
        for (const triangle t : cap) mesh.triangles.push_back_unchecked({{t.a, t.b, t.c}});
        auto* const links = scratch_.take<std::uint32_t>(2 * std::size_t{n} + 3 * cap.size());
        if (links == nullptr) return error::out_of_memory;
        mesh.link_all(n, links);
        return find_components() ? error::none : error::out_of_memory;
    }

    /// Numbers the connected components of the region: triangles connected across diagonals.
    [[nodiscard]] bool find_components() noexcept
    {
        kinetic_triangles& mesh = front_.mesh;
        const std::size_t count = mesh.triangles.size();
        auto* const todo = scratch_.take<std::uint32_t>(count);
        auto* const seen = scratch_.take<bool>(count);
        if (todo == nullptr || seen == nullptr) return false;
        for (std::size_t t = 0; t < count; ++t) seen[t] = false;
        for (std::uint32_t t = 0; t < count; ++t) {
            if (seen[t]) continue;
            const auto component = static_cast<std::uint32_t>(front_.live.size());
            std::uint32_t live = 0, waiting = 0;
            seen[t] = true;
            for (todo[waiting++] = t; waiting != 0;) {
                for (const std::uint32_t link : mesh.triangles[todo[--waiting]].link) {
                    if (kinetic_triangles::is_segment(link)) {
                        mesh.segments[kinetic_triangles::segment_in(link)].component = component;
                        ++live;
                    } else if (!seen[link / 3]) {
                        seen[link / 3] = true;
                        todo[waiting++] = link / 3;
                    }
                }
            }
            if (!front_.live.push_back(live)) return false;
        }
        return true;
    }

    [[nodiscard]] error add_joins(const sweep_options& how) noexcept
    {
        reflex_joins joins{front_};
        const double width = how.joins_at > 0.0 ? how.joins_at : how.levels.back();
        return joins.add({how.mitre_limit, width, how.tolerance, how.round},
                         [&](std::uint32_t point, fixed_vector inward) noexcept -> error {
                             const auto share = [](std::int64_t unit) noexcept {
                                 return static_cast<float>(static_cast<double>(unit) * 0x1p-30);
                             };
                             return out_.joins.push_back({point, {share(inward.x), share(inward.y)}})
                                        ? error::none
                                        : error::out_of_memory;
                         });
    }

    /// Begins a new cell (the area that an edge sweeps between two levels) for each segment, at the segment's current
    /// position.
    [[nodiscard]] bool open_cells() noexcept
    {
        front_.outlines.clear();
        first_node_ = front_.nodes.size();
        const std::size_t missing = front_.mesh.segments.size() - front_.ends_of.size();
        if (missing != 0 && front_.ends_of.append(missing) == nullptr) return false;
        for (std::uint32_t s = 0; s < front_.mesh.segments.size(); ++s) {
            const auto& one = front_.mesh.segments[s];
            if (one.alive)
                front_.ends_of[s] = front_.outlines.open(one.line, front_.node_of[one.from], front_.node_of[one.to]);
        }
        return !front_.has_failed();
    }

    /// Records the position of the segments at this level.
    [[nodiscard]] bool note_edges() noexcept
    {
        if (!note_edges_end()) return false;
        for (const auto& s : front_.mesh.segments) {
            const std::uint32_t a = front_.node_of[s.from], b = front_.node_of[s.to];
            if (s.alive && a != b && !out_.edges_at.push_back({s.line, a, b})) return false;
        }
        return true;
    }
    [[nodiscard]] bool note_edges_end() noexcept
    {
        return out_.at_level.push_back(static_cast<std::uint32_t>(out_.edges_at.size()));
    }

    [[nodiscard]] error reach_level(std::uint32_t band) noexcept
    {
        kinetic_triangles& mesh = front_.mesh;
        level_of_.clear();
        if (level_of_.append(mesh.vertices.size()) == nullptr) return error::out_of_memory;
        for (auto& node : level_of_) node = none;
        for (const auto& s : mesh.segments) {
            if (!s.alive) continue;
            const std::uint32_t last = mesh.segments[mesh.vertices[s.from].before].from;
            level_of_[s.from] = front_.node_at_level(s.from, level_of_[last], level_of_[s.to]);
        }
        for (std::uint32_t s = 0; s < mesh.segments.size() && !front_.has_failed(); ++s) {
            if (!mesh.segments[s].alive) continue;
            front_.outlines.at_tail(front_.ends_of[s], level_of_[mesh.segments[s].to]);
            front_.outlines.at_head(front_.ends_of[s], level_of_[mesh.segments[s].from]);
            if (!front_.has_failed()) front_.outlines.close(front_.ends_of[s]);
        }
        if (front_.has_failed() || !unite_nodes()) return error::out_of_memory;
        for (const auto& s : mesh.segments)
            if (s.alive) front_.node_of[s.from] = same(level_of_[s.from]);
        if (!note_edges()) return error::out_of_memory;
        return cut_cells(band);
    }

    // --- nodes of outlines that follow one another at one place are one

    [[nodiscard]] std::uint32_t same(std::uint32_t node) noexcept
    {
        while (same_[node] != node) node = same_[node] = same_[same_[node]];
        return node;
    }
    [[nodiscard]] bool unite_nodes() noexcept
    {
        while (same_.size() < front_.nodes.size())
            if (!same_.push_back(static_cast<std::uint32_t>(same_.size()))) return false;
        auto& corners = front_.outlines.corners;
        for (auto& c : corners) c.node = same(c.node);
        bool changed = false;
        for (const auto& c : corners) {
            const std::uint32_t a = same(c.node), b = same(corners[c.next].node);
            if (a == b || !(front_.nodes[a].at == front_.nodes[b].at)) continue;
            same_[a < b ? b : a] = a < b ? a : b;
            changed = true;
        }
        if (changed)
            for (auto& c : corners) c.node = same(c.node);
        return true;
    }

    /// Divides all cells into triangles. If this fails for a cell, the cell is mended, and all cells are divided again.
    /// If the repetition does not end, specks are covered.
    [[nodiscard]] error cut_cells(std::uint32_t band) noexcept
    {
        constexpr int max_attempts = 64;
        const std::size_t cells = out_.cells.size(), triangles = out_.triangles.size();
        repair_.begin(first_node_);
        for (int attempt = 1;; attempt = attempt < max_attempts ? attempt + 1 : 0) {
            changed_ = false;
            if (error e = try_to_cut(band, attempt != 0)) return e;
            if (!changed_) return band == 0 ? cover_.add(front_, given_, out_) : error{};
            out_.cells.truncate(cells);
            out_.triangles.truncate(triangles);
        }
    }

    /// `mends`: a ring that cannot be divided is first mended; changed_ becomes true if anything was changed.
    [[nodiscard]] error try_to_cut(std::uint32_t band, bool mends) noexcept
    {
        const auto& corners = front_.outlines.corners;
        for (const auto& c : front_.outlines.cells) {
            if (!cover_.empty() && cover_.covers(component_of(c))) continue;
            path_.clear();
            std::uint32_t i = c.corner;
            do {
                if (!path_.push_back(repair_.node(corners[i].node)) ||
                    !repair_.follow(path_, repair_.node(corners[corners[i].next].node)))
                    return error::out_of_memory;
                i = corners[i].next;
            } while (i != c.corner);
            const auto first = static_cast<std::uint32_t>(out_.triangles.size());
            if (error e = each_ring([&](const buffer<std::uint32_t>& ring) noexcept {
                    const error cut = cutter_(ring, front_.nodes, out_.triangles);
                    return cut == error::crossing_contours ? get_round(ring, c, band, mends) : cut;
                }))
                return e;
            if (first != out_.triangles.size() && !out_.cells.push_back({c.line, band, first}))
                return error::out_of_memory;
        }
        return error::none;
    }

    /// Handles a ring that cannot be divided into triangles.
    [[nodiscard]] error get_round(const buffer<std::uint32_t>& ring, const cell_outlines::cell& c, std::uint32_t band,
                                  bool mends) noexcept
    {
        const auto is_at_level = [&](std::uint32_t a, std::uint32_t b) noexcept {
            for (std::size_t k = out_.at_level[band]; k < out_.edges_at.size(); ++k) {
                const swept_edge_at& e = out_.edges_at[k];
                if ((e.a == a && e.b == b) || (e.a == b && e.b == a) || (a == b && (e.a == a || e.b == a))) return true;
            }
            return false;
        };
        if (mends && repair_.mend(ring, front_.nodes, is_at_level)) {
            changed_ = true;
            return {};
        }
        if (only_cap_) return {};
        const std::uint32_t component = component_of(c);
        if (cover_.covers(component)) return {};  // for another of its rings
        changed_ = true;
        return band == 0 ? cover_.cover(component, front_) : error{error::crossing_contours};
    }
    [[nodiscard]] std::uint32_t component_of(const cell_outlines::cell& c) const noexcept
    {
        return front_.mesh.segments[c.line].component;  // the first segment of a line has the line's number
    }

    /// Divides the closed path where it returns to a node, and passes each ring of 3 nodes or more to `take`, until
    /// `take` fails. A path from a node to the next and back encloses nothing.
    template <class Take>
    [[nodiscard]] error each_ring(Take take) noexcept
    {
        if (is_short_ring()) return take(path_);
        while (on_path_.size() < front_.nodes.size())
            if (!on_path_.push_back(none)) return error::out_of_memory;
        stack_.clear();
        error e;
        for (std::size_t i = 0; i < path_.size() && !e; ++i) {
            const std::uint32_t node = path_[i], from = on_path_[node];
            if (from == none) {
                on_path_[node] = static_cast<std::uint32_t>(stack_.size());
                if (!stack_.push_back(node)) return error::out_of_memory;
                continue;
            }
            ring_.clear();
            if (!ring_.append(stack_.view().subspan(from))) return error::out_of_memory;
            for (std::size_t k = 1; k < ring_.size(); ++k) on_path_[ring_[k]] = none;
            stack_.truncate(from + 1);
            if (ring_.size() >= 3) e = take(ring_);
        }
        for (const std::uint32_t node : stack_) on_path_[node] = none;
        if (e || stack_.size() < 3) return e;
        ring_.swap(stack_);
        return take(ring_);
    }

    /// Whether the path is already a ring. Recognises only short rings, which nearly all cells are.
    [[nodiscard]] bool is_short_ring() const noexcept
    {
        const std::size_t n = path_.size();
        if (n < 3 || n > 6) return false;
        for (std::size_t i = 1; i < n; ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (path_[i] == path_[k]) return false;
        return true;
    }

    /// Collects the loops that the segments still form.
    [[nodiscard]] error make_cap(const region& r) noexcept
    {
        kinetic_triangles& mesh = front_.mesh;
        contours& cap = out_.cap;
        cap.clear();
        cap.grid = r.grid();
        cap.corners = r.corners();
        cap.curves = r.curves();
        cap.tolerance = r.tolerance();
        if (!cap.starts.push_back(0)) return error::out_of_memory;
        for (std::uint32_t s = 0; s < mesh.segments.size(); ++s) {
            path_.clear();
            for (std::uint32_t k = s; mesh.segments[k].alive; k = mesh.vertices[mesh.segments[k].to].after) {
                mesh.segments[k].alive = false;
                if (!path_.push_back(front_.node_of[mesh.segments[k].from])) return error::out_of_memory;
            }
            if (error e = each_ring([&](const buffer<std::uint32_t>& ring) noexcept -> error {
                    grid_point* at = cap.points.append(ring.size());
                    auto* edge = cap.edges.append(ring.size());
                    if (at == nullptr || edge == nullptr || !out_.cap_nodes.append(ring.view()))
                        return error::out_of_memory;
                    for (const std::uint32_t node : ring) {
                        *at++ = front_.nodes[node].at;
                        *edge++ = {};
                    }
                    return cap.starts.push_back(static_cast<std::uint32_t>(cap.points.size())) ? error::none
                                                                                               : error::out_of_memory;
                }))
                return e;
        }
        return error::none;
    }

    workspace::scope& scratch_;
    swept_region& out_;
    wavefront front_;
    ring_cutter cutter_;
    buffer<std::uint32_t> level_of_;  // for each vertex, its node at the level
    buffer<std::uint32_t> same_;      // for each node, another node at its place, or itself
    buffer<std::uint32_t> path_, stack_, ring_, on_path_;
    speck_cover cover_;
    cell_repair repair_;
    array_view<const triangle> given_;
    std::size_t first_node_ = 0;  // the first node of a band
    bool only_cap_ = false, changed_ = false;
};

}  // namespace detail

/// Sweeps the boundary of a region inwards, each edge with the same speed, up to the last level. The result has the
/// faces of the straight skeleton, divided at the levels, and the region that remains.
///
///     triangles   any triangulation of the region without additional points. The results for two triangulations can
///                 differ only where several events happen within a fraction of a cell
///     scratch     provides all memory; `out`, which is empty, may also draw from it
///
/// The remaining region (`out.cap`) is bounded by nodes on the grid. It is a region once fill or a proving triangulator
/// confirms it. Then the triangles in `out` and the cap's triangles cover the region once: all are counter-clockwise,
/// and their common boundary is the boundary of the region.
///
/// Fails  error::crossing_contours: on the grid a cell's outline crosses itself, flips do not end, or rounding loses a
///        hole; the content of `out` is then undefined. No known glyph causes this
///        error::too_large: more than 2^24 points
///        error::out_of_memory
/// Cost   O(n log n) and O(log n) per event. A band in which a cell must be mended is divided again; the
///        time for mending is quadratic in the cell's nodes
[[nodiscard]] inline error sweep_inwards(const region& r, array_view<const triangle> triangles,
                                         const sweep_options& how, workspace::scope& scratch,
                                         swept_region& out) noexcept
{
    TYPEMESH_ASSERT(how.levels.size() >= 2 && !(how.levels[0] > 0.0) && how.levels.back() < grid::reach,
                    "levels begin with 0 and end with the width, which is below 2^28 cells");
    detail::inward_sweep sweep{scratch, out};
    return sweep.run(r, triangles, how);
}

}  // namespace typemesh::inline TYPEMESH_ABI

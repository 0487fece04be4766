// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/bevel_facing.hpp>
#include <typemesh/extrude/impl/bevel_light.hpp>
#include <typemesh/extrude/impl/bevel_strips.hpp>
#include <typemesh/extrude/impl/profile_levels.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Makes the vertices and triangles of a bevel from a swept region.
///
/// The faces that meet at a node share a vertex under three conditions. Their normals differ by less than the crease
/// angle from the first one's normal. Their normals and flat faces differ by less than 90 degrees from the normalised
/// sum, which is the vertex's normal. They agree on `along`. Faces of two bands share a vertex if the strips are smooth
/// there. A riser has its own vertices: pairs, below and above in the profile's order.
class bevel_vertices {
public:
    struct sharing {
        double crease = 1.0;      ///< the cosine of the crease angle
        double max_apart = -1.0;  ///< the largest difference of `along`; negative: any
    };

    bevel_vertices(bevel_data& data, const bevel_light& light, sharing how) noexcept
        : data_{data},
          swept_{data.swept},
          light_{light},
          how_{how},
          is_near_{how.crease >= always_near && !light.strays()}
    {
    }

    /// For an outward sweep of a region's surroundings: the levels are in reverse order, and the frame's edges,
    /// starting with this one, are left out.
    void outwards(std::uint32_t frame) noexcept { frame_ = frame; }

    /// `data` holds the strips of `profile`, whose levels are equal to data.swept's.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] error make(const profile_levels& profile, workspace::scope& scratch) noexcept
    {
        const std::size_t n = swept_.nodes.size();
        nodes_ = scratch.take<node>(n);
        if (nodes_ == nullptr) return error::out_of_memory;
        for (std::size_t i = 0; i < n; ++i) nodes_[i] = {none, 0, none};
        find_levels();
        data_.corners.clear();
        data_.normals.clear();
        const auto levels = profile.view();
        const auto last = static_cast<std::uint32_t>(levels.size() - 1);
        std::uint32_t strip = is_outward() ? static_cast<std::uint32_t>(data_.of<bevel_strip>().size()) : 0;
        const auto next_strip = [&]() noexcept { return is_outward() ? --strip : strip++; };
        std::size_t cell = 0;
        for (std::uint32_t k = 0; k <= last; ++k) {
            if (levels[is_outward() ? last - k : k].has_riser()) {
                ++age_;
                if (!add_riser(k, next_strip())) return error::out_of_memory;
            }
            if (k == last) break;
            const std::uint32_t here = next_strip();
            const bevel_strip& across = data_.of<bevel_strip>()[here];
            if (k == 0 || !(is_outward() ? across.smooth_after : across.smooth_before)) ++age_;
            if (!add_band(k, here, cell)) return error::out_of_memory;
        }
        return finish(0, scratch) ? error{} : error{error::out_of_memory};
    }

    /// After make(): whether front and back of a solid without walls would meet inside the outline, in an edge, which
    /// then has four faces, or in a point.
    ///
    ///      p ____________ s         p-q joins two points of the outline, but is no edge of it; so does a side of a
    ///       |\__________/|          triangle with three corners on the outline. Or
    ///       |  \   r   /  |         r is no point of the outline, but lies lower than `low`
    ///       |____\__/_____|
    ///             q
    ///
    ///     low     as a share of the bevel's depth, like the heights of strips
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(n)
    [[nodiscard]] result<bool> is_low_inside(float low, workspace::scope& scratch) const noexcept
    {
        if (returns_below(low)) return true;
        if (!begins_with_slope()) return false;
        const std::uint32_t* const next = next_on_outline(scratch);
        if (next == nullptr) return error::out_of_memory;
        const std::uint32_t band = is_outward() ? last_level() - 1 : 0;
        for (std::size_t c = 0; c + 1 < swept_.cells.size(); ++c) {
            if (swept_.cells[c].band != band || is_frame(swept_.cells[c].edge)) continue;
            for (std::uint32_t t = swept_.cells[c].first_triangle; t < swept_.cells[c + 1].first_triangle; ++t)
                if (is_low_inside(swept_.triangles[t], band, next, low)) return true;
        }
        return false;
    }

    /// Makes walls on the edges at the last level: pairs of vertices, from the back to the front.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] error add_walls(workspace::scope& scratch) noexcept
    {
        ++age_;
        const std::size_t bevel = data_.of<bevel_triangle>().size();
        return add_riser(last_level(), 0) && finish(bevel, scratch) ? error{} : error{error::out_of_memory};
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// The number of corners tried at a node: thousands may meet where a round shape closes, each with its own vertex.
    static constexpr std::uint32_t max_tried = 64;

    /// The cosine of 30 degrees, rounded up. If normals differ by less from one of them, they are near the sum of all.
    /// Their faces are too, if they are near their own normals.
    static constexpr double always_near = 0.8661;

    /// The corners at a node so far, of strips that share vertices: the ones of the current age.
    struct node {
        std::uint32_t corners;
        std::uint32_t age;
        std::uint32_t level;  ///< its level; none: it lies between two levels
    };

    /// A node of an edge at a level lies on this level; a node of two bands lies on the level between them.
    void find_levels() noexcept
    {
        for (std::size_t i = 0; i + 1 < swept_.cells.size(); ++i) {
            const swept_cell* c = &swept_.cells[i];
            for (std::uint32_t t = c[0].first_triangle; t < c[1].first_triangle; ++t)
                for (const std::uint32_t at : {swept_.triangles[t].a, swept_.triangles[t].b, swept_.triangles[t].c}) {
                    std::uint32_t& last = nodes_[at].corners;  // the last band that contained it
                    if (last != none && last != c->band) nodes_[at].level = c->band;
                    last = c->band;
                }
        }
        for (std::uint32_t k = 0; k + 1 < swept_.at_level.size(); ++k)
            for (std::uint32_t i = swept_.at_level[k]; i < swept_.at_level[k + 1]; ++i)
                nodes_[swept_.edges_at[i].a].level = nodes_[swept_.edges_at[i].b].level = k;
    }

    /// The cells of a band. `cell` is the first of them, and then the next band's first.
    bool add_band(std::uint32_t band, std::uint32_t strip, std::size_t& cell) noexcept
    {
        auto& triangles = data_.of<bevel_triangle>();
        for (; cell + 1 < swept_.cells.size() && swept_.cells[cell].band == band; ++cell) {
            const swept_cell& c = swept_.cells[cell];
            if (is_frame(c.edge)) continue;
            triangle last{none, none, none}, made;  // reuses vertices of the previous triangle in a cell, which is
                                                    // mostly a neighbour
            const auto add = [&](std::uint32_t at, std::uint32_t& vertex, const triangle& known) noexcept {
                const bool is_known = at == last.a || at == last.b || at == last.c;
                if (is_known) vertex = at == last.a ? known.a : at == last.b ? known.b : known.c;
                return is_known || add_corner(c.edge, at, band, strip, vertex);
            };
            for (std::uint32_t t = c.first_triangle; t < swept_.cells[cell + 1].first_triangle; ++t) {
                const triangle& at = swept_.triangles[t];
                const triangle known = made;
                if (!add(at.a, made.a, known) || !add(at.b, made.b, known) || !add(at.c, made.c, known) ||
                    !triangles.push_back({made}))
                    return false;
                last = at;
            }
        }
        return true;
    }

    /// The upright rectangles on the edges at a level.
    bool add_riser(std::uint32_t level, std::uint32_t strip) noexcept
    {
        auto& triangles = data_.of<bevel_triangle>();
        for (std::uint32_t i = swept_.at_level[level]; i < swept_.at_level[level + 1]; ++i) {
            const swept_edge_at& e = swept_.edges_at[i];
            if (is_frame(e.edge) || swept_.nodes[e.a].at == swept_.nodes[e.b].at) continue;
            const std::uint32_t from = is_outward() ? e.b : e.a, to = is_outward() ? e.a : e.b;
            std::uint32_t a = 0, b = 0;
            if (!add_corner(e.edge, from, none, strip, a) || !add_corner(e.edge, to, none, strip, b) ||
                !triangles.push_back({{a, b, b + 1}}) || !triangles.push_back({{a, b + 1, a + 1}}))
                return false;
        }
        return true;
    }

    /// The vertex of an edge's face at a node, in a band or (none) on a riser. False if out of memory.
    bool add_corner(std::uint32_t edge, std::uint32_t at, std::uint32_t band, std::uint32_t strip,
                    std::uint32_t& vertex) noexcept
    {
        node& here = nodes_[at];
        if (here.age != age_) {
            here.corners = none;
            here.age = age_;
        }
        std::uint32_t left = max_tried;
        for (std::uint32_t c = here.corners; c != none && left-- != 0; c = data_.corners[c].next) {
            if (data_.corners[c].edge != edge) continue;
            vertex = data_.corners[c].vertex;
            return true;
        }
        const bevel_light::lit lit = light_.at(edge, swept_.nodes[at]);
        std::uint32_t found = here.corners;
        for (left = max_tried; found != none && !share(data_.corners[found].vertex, lit);)
            found = --left != 0 ? data_.corners[found].next : none;
        if (found != none) {
            vertex = data_.corners[found].vertex;
            for (std::uint32_t v = vertex; v < vertex + (band == none ? 2u : 1u); ++v)
                data_.normals[v].add(lit.outward, lit.face);
        } else if (!add_vertices(at, band, strip, lit, vertex)) {
            return false;
        }
        if (!data_.corners.push_back({edge, vertex, here.corners})) return false;
        here.corners = static_cast<std::uint32_t>(data_.corners.size() - 1);
        return true;
    }

    /// One vertex, or two for a riser.
    bool add_vertices(std::uint32_t at, std::uint32_t band, std::uint32_t strip, const bevel_light::lit& lit,
                      std::uint32_t& vertex) noexcept
    {
        auto& vertices = data_.of<bevel_vertex>();
        vertex = static_cast<std::uint32_t>(vertices.size());
        bevel_vertex made{swept_.nodes[at].at, {}, static_cast<float>(lit.along), 0.0f, strip};
        if (band != none) made.share = share_of(at, band);
        if (!vertices.push_back(made) || !data_.normals.push_back(bevel_data::corner_normals{lit.outward, lit.face}))
            return false;
        if (band != none) return true;
        made.share = 1.0f;
        return vertices.push_back(made) && data_.normals.push_back(bevel_data::corner_normals{lit.outward, lit.face});
    }

    /// The position of a node across a band: 0 on its outer level and 1 on its inner.
    [[nodiscard]] float share_of(std::uint32_t at, std::uint32_t band) const noexcept
    {
        const float swept = swept_share(at, band);
        return is_outward() ? 1.0f - swept : swept;
    }

    /// The same in the direction of the sweep.
    [[nodiscard]] float swept_share(std::uint32_t at, std::uint32_t band) const noexcept
    {
        const double from = swept_.levels[band], to = swept_.levels[band + 1];
        const double share = (as_double(swept_.nodes[at].distance) - from) / (to - from);
        if (nodes_[at].level == band || share <= 0.0) return 0.0f;
        if (nodes_[at].level == band + 1 || share >= 1.0) return 1.0f;
        return static_cast<float>(share);
    }

    /// Whether the profile comes back to the outline's height, or stays there.
    [[nodiscard]] bool returns_below(float low) const noexcept
    {
        const auto strips = data_.of<bevel_strip>().view();
        for (std::size_t i = 0; i < strips.size(); ++i)
            if ((i != 0 && strips[i].from < low) || strips[i].to < low) return true;
        return false;
    }

    [[nodiscard]] bool begins_with_slope() const noexcept
    {
        const auto strips = data_.of<bevel_strip>().view();
        return !strips.empty() && !is_zero(strips[0].run);
    }

    /// For each node the next one along the outline; none if it is no point of the outline. Null if out of memory.
    [[nodiscard]] const std::uint32_t* next_on_outline(workspace::scope& scratch) const noexcept
    {
        auto* const next = scratch.take<std::uint32_t>(swept_.nodes.size());
        if (next == nullptr) return nullptr;
        std::fill_n(next, swept_.nodes.size(), none);
        const std::uint32_t level = is_outward() ? last_level() : 0;
        for (std::uint32_t i = swept_.at_level[level]; i < swept_.at_level[level + 1]; ++i)
            next[swept_.edges_at[i].a] = swept_.edges_at[i].b;
        return next;
    }

    /// Whether a triangle beside the outline lies at its height anywhere but on one edge of the outline.
    [[nodiscard]] bool is_low_inside(const triangle& t, std::uint32_t band, const std::uint32_t* next,
                                     float low) const noexcept
    {
        int on_outline = 0;
        for (const std::uint32_t at : {t.a, t.b, t.c})
            if (next[at] != none)
                ++on_outline;
            else if (height_of({{}, {}, 0.0f, share_of(at, band), 0}, data_.of<bevel_strip>().view()) < low)
                return true;
        const auto is_edge = [&](std::uint32_t p, std::uint32_t q) noexcept { return next[p] == q || next[q] == p; };
        const bool has_edge = is_edge(t.a, t.b) || is_edge(t.b, t.c) || is_edge(t.c, t.a);
        return on_outline > (has_edge ? 2 : 1);
    }

    [[nodiscard]] bool share(std::uint32_t vertex, const bevel_light::lit& lit) const noexcept
    {
        const bevel_data::corner_normals& normals = data_.normals[vertex];
        if (dot(normals.first, lit.outward) < how_.crease) return false;
        if (!is_near_ && !normals.stays_near(lit.outward, lit.face)) return false;
        const double apart = as_double(data_.of<bevel_vertex>()[vertex].along) - lit.along;
        return how_.max_apart < 0.0 || std::fabs(apart) <= how_.max_apart;
    }

    [[nodiscard]] bool is_outward() const noexcept { return frame_ != none; }
    [[nodiscard]] std::uint32_t last_level() const noexcept
    {
        return static_cast<std::uint32_t>(swept_.levels.size() - 1);
    }
    [[nodiscard]] bool is_frame(std::uint32_t edge) const noexcept
    {
        return is_outward() && edge >= frame_ && edge - frame_ < 4;
    }

    /// Sets the normals of all new vertices, which belong to the triangles from this one on.
    [[nodiscard]] bool finish(std::size_t first_triangle, workspace::scope& scratch) noexcept
    {
        auto& vertices = data_.of<bevel_vertex>();
        for (; finished_ < vertices.size(); ++finished_)
            vertices[finished_].outward = rounded(unit(data_.normals[finished_].sum));
        const bool turned = is_near_ || bevel_facing{data_, scratch}.turn_out(first_triangle);
        finished_ = vertices.size();
        return turned;
    }

    bevel_data& data_;
    const swept_region& swept_;
    const bevel_light& light_;
    sharing how_;
    bool is_near_;  ///< all normals that share a vertex are near each other and their faces
    node* nodes_ = nullptr;
    std::uint32_t age_ = 0;
    std::uint32_t frame_ = none;
    std::size_t finished_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI

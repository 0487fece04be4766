// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/cell_diagonals.hpp>
#include <typemesh/offset/swept_region.hpp>
#include <typemesh/refine/refiner.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Refines the cap within a bevel. Points that are added to its edges divide the bevel's triangles there as well.
///
///       cap                    cap
///     a------b  rim          a--p---b     An edge of the cap is an edge of one triangle of the last band, whose third
///      \    /         -->     \ |  /      corner r then gets an edge to each new point. A refiner whose scratch has
///       \  /  bevel            \| /       attach() adds no point that would turn one of these triangles. Where an edge
///        r                      r         belongs to no triangle alone, such a refiner adds none. First the band's
///                                         cells get the diagonals that leave most room: see cell_diagonals.
class rim_refinement {
public:
    explicit rim_refinement(memory source = heap()) noexcept
        : rim_{source},
          inner_{source},
          triangles_{source},
          beyond_{source},
          fans_{source},
          rims_{source},
          sides_{source},
          fan_of_{source},
          divided_{source},
          edges_{source},
          diagonals_{source}
    {
    }

    /// Refines the cap of a bevel's sweep, whose triangles are in `data`, and stores its points there. `cap` is the
    /// sweep's own, but its loops may have been `turned`.
    ///
    /// Fails  as the refiner does
    ///        error::crossing_contours: the refiner added a point that would turn a triangle of the bevel
    template <refiner R>
    [[nodiscard]] error run(bevel_data& data, const region& cap, bool turned, const R& how,
                            typename R::scratch& working) noexcept
    {
        if (cap.points().empty()) return {};
        swept_ = &data.swept;
        const error e = refine(data.of<triangle>().view(), cap, turned, how, working);
        data.of<triangle>().clear();
        if (e) return e;
        auto& points = data.of<grid_point>();
        const bool fits = points.append(rim_.points.view()) && points.append(inner_.view()) &&
                          data.of<std::uint32_t>().append(rim_.starts.view()) &&
                          data.of<triangle>().append(triangles_.view());
        return fits ? error{} : error{error::out_of_memory};
    }

    /// The last refined_cap::kept.
    [[nodiscard]] std::uint32_t kept() const noexcept { return kept_; }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// The triangle on an edge of the cap.
    struct fan {
        std::uint32_t side = none;  ///< 3 * its number + the number of its corner at which the edge begins
        std::uint32_t edge = none;  ///< the edge in edges_at
        bool forward = false;       ///< whether the triangle's side runs in the direction of the cap's edge
        bool with_rim = true;       ///< whether the edge in edges_at does
        std::uint32_t first = 0;    ///< the first node that has been added to it
        std::uint32_t count = 0;    ///< and their number
    };
    struct rim_edge {
        grid_point from, to;
        std::uint32_t index;  // in edges_at
    };
    struct side {
        std::uint64_t key;  // of its two nodes
        std::uint32_t h;
    };

    [[nodiscard]] static bool is_before(grid_point p, grid_point q) noexcept
    {
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    }
    [[nodiscard]] static bool is_before(const rim_edge& a, const rim_edge& b) noexcept
    {
        return a.from != b.from ? is_before(a.from, b.from) : is_before(a.to, b.to);
    }
    [[nodiscard]] static std::uint64_t key_of(std::uint32_t a, std::uint32_t b) noexcept
    {
        return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
    }
    [[nodiscard]] std::uint32_t node_of(std::uint32_t h) const noexcept
    {
        const triangle& t = swept_->triangles[h / 3];
        return h % 3 == 0 ? t.a : h % 3 == 1 ? t.b : t.c;
    }
    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
    [[nodiscard]] grid_point place(std::uint32_t node) const noexcept { return swept_->nodes[node].at; }

    template <refiner R>
    [[nodiscard]] error refine(array_view<const triangle> triangles, const region& cap, bool turned, const R& how,
                               typename R::scratch& working) noexcept
    {
        if (!open(cap, turned)) return error::out_of_memory;
        if constexpr (requires { working.attach(beyond_.view()); }) working.attach(beyond_.view());
        contours& loops = swept_->cap;
        const array_view<const curve> curves = loops.curves;
        loops.curves = {};  // new points on a bevel's rim lie on straight edges
        const region straight = region::proven(loops, cap.holes(), cap.outers(), cap.is_touching());
        loops.curves = curves;
        if (error e = how(straight, triangles, working, {rim_, inner_, triangles_, kept_})) return e;
        if (rim_.points.size() == cap.points().size()) return {};
        if (!add_nodes(cap)) return error::out_of_memory;
        if (!is_unturned()) return error::crossing_contours;
        return divide_band() && divide_rim() ? error{} : error{error::out_of_memory};
    }

    // --- before

    /// Finds the triangle on each edge of the cap. False if out of memory.
    [[nodiscard]] bool open(const region& cap, bool turned) noexcept
    {
        const std::size_t n = cap.points().size();
        beyond_.clear();
        fans_.clear();
        grid_point* const beyond = beyond_.append(n);
        fan* const fans = fans_.append(n);
        if (beyond == nullptr || fans == nullptr) return false;
        if (!diagonals_.improve(*swept_, swept_->levels.size() - 2) || !list_rim() || !list_sides()) return false;
        const auto starts = cap.starts();
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop)
            for (std::uint32_t i = starts[loop], end = starts[loop + 1]; i < end; ++i) {
                const grid_point p = cap.points()[i], q = cap.points()[i + 1 < end ? i + 1 : starts[loop]];
                fans[i] = turned ? fan_on(q, p, true) : fan_on(p, q, false);
                // Of a triangle with two edges of the cap, none is divided.
                std::uint32_t* const one = fans[i].side == none ? nullptr : &fan_of_[fans[i].side / 3];
                if (one != nullptr && *one != none) fans[i].side = fans[*one].side = none;
                if (one != nullptr) *one = i;
                beyond[i] = p;
            }
        for (std::uint32_t i = 0; i < n; ++i) {
            if (fans[i].side == none) continue;
            beyond[i] = place(node_of(next(next(fans[i].side))));
        }
        return true;
    }

    /// Lists the edges at the last level. False if out of memory.
    [[nodiscard]] bool list_rim() noexcept
    {
        const auto& levels = swept_->at_level;
        const std::uint32_t first = levels[levels.size() - 2], end = levels.back();
        rims_.clear();
        if (!rims_.reserve(end - first)) return false;
        for (std::uint32_t i = first; i < end; ++i) {
            const swept_edge_at& e = swept_->edges_at[i];
            if (place(e.a) != place(e.b)) rims_.push_back_unchecked({place(e.a), place(e.b), i});
        }
        std::sort(rims_.begin(), rims_.end(), [](const rim_edge& a, const rim_edge& b) noexcept {
            return a.from == b.from && a.to == b.to ? a.index < b.index : is_before(a, b);
        });
        return true;
    }

    /// Lists the sides of the last band's triangles between nodes of the last level. False if out of memory.
    [[nodiscard]] bool list_sides() noexcept
    {
        fan_of_.clear();
        std::uint32_t* const on_rim = fan_of_.append(swept_->nodes.size());
        if (on_rim == nullptr) return false;
        for (std::size_t i = 0; i < swept_->nodes.size(); ++i) on_rim[i] = 0;
        for (const rim_edge& e : rims_) on_rim[swept_->edges_at[e.index].a] = on_rim[swept_->edges_at[e.index].b] = 1;
        sides_.clear();
        const auto& cells = swept_->cells;
        const std::size_t last = swept_->levels.size() - 2;
        for (std::size_t c = 0; c + 1 < cells.size(); ++c) {
            if (cells[c].band != last) continue;
            for (std::uint32_t h = 3 * cells[c].first_triangle; h < 3 * cells[c + 1].first_triangle; ++h) {
                const std::uint32_t a = node_of(h), b = node_of(next(h));
                if (on_rim[a] != 0 && on_rim[b] != 0 && !sides_.push_back({key_of(a, b), h})) return false;
            }
        }
        std::sort(sides_.begin(), sides_.end(),
                  [](const side& a, const side& b) noexcept { return a.key != b.key ? a.key < b.key : a.h < b.h; });
        fan_of_.clear();
        std::uint32_t* const all = fan_of_.append(swept_->triangles.size());
        if (all == nullptr && !swept_->triangles.empty()) return false;
        for (std::size_t t = 0; t < swept_->triangles.size(); ++t) all[t] = none;
        return true;
    }

    /// The fan on the only edge from p to q at the last level. Its side is none if there are several, or if it is not
    /// the side of exactly one triangle.
    [[nodiscard]] fan fan_on(grid_point p, grid_point q, bool turned) const noexcept
    {
        const rim_edge wanted{p, q, 0};
        const auto order = [](const rim_edge& a, const rim_edge& b) noexcept { return is_before(a, b); };
        const auto [first, end] = std::equal_range(rims_.begin(), rims_.end(), wanted, order);
        fan made;
        if (end - first != 1) return made;
        const swept_edge_at& e = swept_->edges_at[first->index];
        const side key{key_of(e.a, e.b), 0};
        const auto less = [](const side& a, const side& b) noexcept { return a.key < b.key; };
        const auto [one, after] = std::equal_range(sides_.begin(), sides_.end(), key, less);
        if (after - one != 1) return made;
        made.side = one->h;
        made.edge = first->index;
        made.forward = node_of(made.side) == (turned ? e.b : e.a);
        made.with_rim = !turned;
        return made;
    }

    // --- afterwards

    /// Makes a node of each point that has been added to the cap's edges. False if out of memory.
    [[nodiscard]] bool add_nodes(const region& cap) noexcept
    {
        const auto distance = static_cast<float>(swept_->levels.back());
        const auto starts = cap.starts();
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
            std::uint32_t at = rim_.starts[loop];
            const std::uint32_t last = rim_.starts[loop + 1];
            for (std::uint32_t i = starts[loop], end = starts[loop + 1]; i < end; ++i) {
                fan& f = fans_[i];
                f.first = static_cast<std::uint32_t>(swept_->nodes.size());
                for (++at; at < last && (i + 1 == end || rim_.points[at] != cap.points()[i + 1]); ++at)
                    if (!swept_->nodes.push_back({rim_.points[at], distance})) return false;
                f.count = static_cast<std::uint32_t>(swept_->nodes.size()) - f.first;
            }
        }
        return true;
    }

    /// Visits the parts of an edge from a to b with the nodes of a fan, which lie on it in that direction or against
    /// it. False as soon as visit(from, to) is.
    template <class Visit>
    [[nodiscard]] static bool each_part(const fan& f, bool forward, std::uint32_t a, std::uint32_t b,
                                        const Visit& visit) noexcept
    {
        std::uint32_t from = a;
        for (std::uint32_t k = 0; k < f.count; ++k) {
            const std::uint32_t to = f.first + (forward ? k : f.count - 1 - k);
            if (!visit(from, to)) return false;
            from = to;
        }
        return visit(from, b);
    }

    /// Whether the triangles of all fans are counter-clockwise.
    [[nodiscard]] bool is_unturned() const noexcept
    {
        for (const fan& f : fans_) {
            if (f.count == 0) continue;
            if (f.side == none) return false;
            const std::uint32_t r = node_of(next(next(f.side)));
            if (!each_part(f, f.forward, node_of(f.side), node_of(next(f.side)),
                           [&](std::uint32_t from, std::uint32_t to) noexcept {
                               return orientation(place(from), place(to), place(r)) > 0;
                           }))
                return false;
        }
        return true;
    }

    /// Divides the triangles on the cap's edges. False if out of memory.
    [[nodiscard]] bool divide_band() noexcept
    {
        divided_.clear();
        auto& cells = swept_->cells;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::uint32_t first = cells[c].first_triangle;
            cells[c].first_triangle = static_cast<std::uint32_t>(divided_.size());
            if (c + 1 == cells.size()) break;
            for (std::uint32_t t = first; t < cells[c + 1].first_triangle; ++t) {
                const bool is_divided = fan_of_[t] != none && fans_[fan_of_[t]].count != 0;
                if (!(is_divided ? add_fan(fans_[fan_of_[t]]) : divided_.push_back(swept_->triangles[t]))) return false;
            }
        }
        swept_->triangles.swap(divided_);
        return true;
    }
    [[nodiscard]] bool add_fan(const fan& f) noexcept
    {
        const std::uint32_t r = node_of(next(next(f.side)));
        return each_part(
            f, f.forward, node_of(f.side), node_of(next(f.side)),
            [&](std::uint32_t from, std::uint32_t to) noexcept { return divided_.push_back({from, to, r}); });
    }

    /// Divides the edges at the last level. False if out of memory.
    [[nodiscard]] bool divide_rim() noexcept
    {
        fan_of_.clear();
        const std::uint32_t first = swept_->at_level[swept_->at_level.size() - 2], end = swept_->at_level.back();
        std::uint32_t* const of_edge = fan_of_.append(end - first);
        if (of_edge == nullptr) return false;
        for (std::uint32_t i = first; i < end; ++i) of_edge[i - first] = none;
        for (std::uint32_t i = 0; i < fans_.size(); ++i)
            if (fans_[i].count != 0) of_edge[fans_[i].edge - first] = i;
        edges_.clear();
        if (!edges_.append(swept_->edges_at.view().first(first))) return false;
        for (std::uint32_t i = first; i < end; ++i) {
            const swept_edge_at e = swept_->edges_at[i];
            const auto add = [&](std::uint32_t from, std::uint32_t to) noexcept {
                return edges_.push_back({e.edge, from, to});
            };
            const std::uint32_t at = of_edge[i - first];
            if (!(at == none ? add(e.a, e.b) : each_part(fans_[at], fans_[at].with_rim, e.a, e.b, add))) return false;
        }
        swept_->edges_at.swap(edges_);
        swept_->at_level.back() = static_cast<std::uint32_t>(swept_->edges_at.size());
        return true;
    }

    contours rim_;
    buffer<grid_point> inner_;
    triangle_list triangles_;
    buffer<grid_point> beyond_;  // for each edge of the cap, the corner that sees it; its first point if none does
    buffer<fan> fans_;           // for each edge of the cap
    buffer<rim_edge> rims_;
    buffer<side> sides_;
    buffer<std::uint32_t> fan_of_;  // for each triangle
    buffer<triangle> divided_;
    buffer<swept_edge_at> edges_;
    cell_diagonals diagonals_;
    std::uint32_t kept_ = 0;
    swept_region* swept_ = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

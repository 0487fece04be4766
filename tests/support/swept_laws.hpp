// SPDX-License-Identifier: MIT
#pragma once

// Laws of every region swept inwards.

#include "support/cycles.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/fill/impl/touching_cycles.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Why loops are not the boundary of a region as they are, or "". Loops without points are one.
inline std::string broken_cap(const typemesh::contours& cap)
{
    using namespace typemesh;
    if (cap.edges.size() != cap.points.size()) return "the cap's edges and points differ in number";
    if (cap.points.empty()) return "";
    contours again;
    const bool fits = again.points.append(cap.points.view()) && again.edges.append(cap.edges.view()) &&
                      again.starts.append(cap.starts.view());
    if (!fits) return "out of memory";
    again.curves = cap.curves;
    workspace space;
    const auto filled = fill(again, fill_rule::non_zero, space);
    if (!filled) return "the cap cannot be filled";
    return cycles_of(*filled) == cycles_of(region::proven(cap, 0, 0))
               ? ""
               : "the cap is no region: filled, it has other loops";
}

/// The same loops, except where two touch in a point: there each edge follows the one of its own sector.
inline typemesh::contours linked(const typemesh::contours& cap)
{
    using namespace typemesh;
    contours again;
    if (!again.points.append(cap.points.view()) || !again.edges.append(cap.edges.view()) ||
        !again.starts.append(cap.starts.view()))
        throw std::runtime_error("no memory for the test's own contours");
    workspace space;
    workspace::scope scratch{space};
    touching_cycles cycles;
    (void)cycles.link(again, scratch, space);  // unchanged, if it fails
    return again;
}

/// Checks a swept region against its original region, by brute force.
///
///     swept_laws laws{r, swept};
///     CHECK(laws.broken() == "");
class swept_laws {
public:
    static constexpr double max_beyond_band = 1.5;  ///< cells
    static constexpr double max_off_level = 1.5;    ///< cells, of the edges at a level
    static constexpr double max_off_plane = 4.0;    ///< cells, of a node from the plane of a face

    swept_laws(const typemesh::region& r, const typemesh::swept_region& s) : region_{r}, swept_{s}
    {
        if (is_well_formed()) {
            check_triangles();
            check_edges();
            check_cap_edges();
            check_levels();
            const std::string wrong = broken_cap(linked(swept_.cap));
            law(wrong.empty(), wrong);
            check_areas();
        }
    }

    /// The first law that is broken, in words, or "".
    [[nodiscard]] const std::string& broken() const { return broken_; }

    /// Twice the area within each level.
    [[nodiscard]] const std::vector<std::int64_t>& doubled_areas() const { return areas_; }
    [[nodiscard]] double farthest_off_plane() const { return off_plane_; }

    /// The edges at a level as loops, joined in one of the possible ways.
    [[nodiscard]] std::vector<std::vector<typemesh::grid_point>> loops_at(std::size_t level) const
    {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::uint32_t i = swept_.at_level[level]; i < swept_.at_level[level + 1]; ++i)
            edges.emplace_back(swept_.edges_at[i].a, swept_.edges_at[i].b);
        std::sort(edges.begin(), edges.end());
        std::vector<bool> used(edges.size(), false);
        std::vector<std::vector<typemesh::grid_point>> all;
        for (std::size_t first = 0; first < edges.size(); ++first) {
            if (used[first]) continue;
            auto& loop = all.emplace_back();
            for (std::size_t e = first; e != edges.size() && !used[e];) {
                used[e] = true;
                loop.push_back(swept_.nodes[edges[e].first].at);
                const std::pair<std::uint32_t, std::uint32_t> from{edges[e].second, 0u};
                e = static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), from) - edges.begin());
                while (e != edges.size() && used[e] && edges[e].first == from.first) ++e;
                if (e != edges.size() && edges[e].first != from.first) break;
            }
        }
        return all;
    }

private:
    /// A side of a triangle, from node to node.
    struct side_of {
        std::uint32_t a, b, cell;

        friend bool operator<(const side_of& p, const side_of& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }
    };

    void law(bool holds, const std::string& sentence)
    {
        if (!holds && broken_.empty()) broken_ = sentence;
    }

    bool is_well_formed()
    {
        const auto& s = swept_;
        const std::size_t n = region_.points().size();
        law(s.levels.size() > 1 && s.levels[0] <= 0.0 && s.levels[0] >= 0.0, "the levels do not begin at 0");
        for (std::size_t k = 1; k < s.levels.size(); ++k) law(s.levels[k - 1] < s.levels[k], "the levels do not rise");
        law(s.nodes.size() >= n, "nodes are missing");
        for (std::size_t i = 0; i < n && broken_.empty(); ++i)
            law(s.nodes[i].at == region_.points()[i] && !(s.nodes[i].distance > 0.0f),
                "the first nodes are not the region's points");
        law(!s.cells.empty() && s.cells.back().first_triangle == s.triangles.size(), "the last cell is no sentinel");
        law(s.cells.empty() || s.cells[0].first_triangle == 0, "the first cell does not begin with the first triangle");
        for (std::size_t c = 0; c + 1 < s.cells.size() && broken_.empty(); ++c) {
            law(s.cells[c].first_triangle <= s.cells[c + 1].first_triangle, "a cell ends before it begins");
            law(c + 2 >= s.cells.size() || s.cells[c].band <= s.cells[c + 1].band, "the cells are not ordered by band");
            law(s.cells[c].band + 1 < s.levels.size(), "a cell's band lies between no levels");
            law(s.cells[c].edge < n + s.joins.size(), "a cell has no edge");
        }
        for (const typemesh::triangle t : s.triangles)
            law((std::max)({t.a, t.b, t.c}) < s.nodes.size(), "a triangle has no nodes");
        law(s.at_level.size() == s.levels.size() + 1 && s.at_level[0] == 0 && s.at_level.back() == s.edges_at.size(),
            "the edges at levels do not begin and end where they should");
        for (std::size_t k = 1; k < s.at_level.size() && broken_.empty(); ++k)
            law(s.at_level[k - 1] <= s.at_level[k], "a level ends before it begins");
        for (const auto& e : s.edges_at)
            law((std::max)(e.a, e.b) < s.nodes.size() && e.edge < n + s.joins.size(), "an edge at a level has no ends");
        for (const auto& j : s.joins)
            law(j.point < n && std::fabs(std::hypot(j.inward.x, j.inward.y) - 1.0f) < 1e-4f,
                "a join has no point or no direction");
        return broken_.empty();
    }

    /// The distance of a node from the line of an edge, inwards.
    [[nodiscard]] double height_over(std::uint32_t edge, typemesh::grid_point p) const
    {
        const auto points = region_.points();
        if (edge >= points.size()) {
            const auto& j = swept_.joins[edge - points.size()];
            const auto o = points[j.point];
            return double(j.inward.x) * (double(p.x) - o.x) + double(j.inward.y) * (double(p.y) - o.y);
        }
        const auto a = points[edge], b = points[next_[edge]];
        const double x = double(b.x) - a.x, y = double(b.y) - a.y;
        return (x * (double(p.y) - a.y) - y * (double(p.x) - a.x)) / std::hypot(x, y);
    }

    void check_triangles()
    {
        next_.resize(region_.points().size());
        const auto starts = region_.starts();
        for (std::size_t l = 0; l + 1 < starts.size(); ++l)
            for (std::uint32_t i = starts[l]; i < starts[l + 1]; ++i)
                next_[i] = i + 1 < starts[l + 1] ? i + 1 : starts[l];

        const auto& s = swept_;
        const double width = s.levels.back();
        for (const auto& n : s.nodes)
            law(n.distance >= 0.0f && n.distance <= width * (1.0 + 1e-7), "a node is not within the width");
        std::uint32_t cell = 0;
        for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
            while (s.cells[cell + 1].first_triangle <= i) ++cell;
            const typemesh::triangle t = s.triangles[i];
            const auto of = s.cells[cell];
            law(typemesh::inspect::side(s.nodes[t.a].at, s.nodes[t.b].at, s.nodes[t.c].at) > 0,
                "a triangle is flat or turned over");
            for (const std::uint32_t v : {t.a, t.b, t.c}) {
                const double d = double(s.nodes[v].distance);
                beyond_band_ = (std::max)({beyond_band_, s.levels[of.band] - d, d - s.levels[of.band + 1]});
                off_plane_ = (std::max)(off_plane_, std::fabs(height_over(of.edge, s.nodes[v].at) - d));
            }
            sides_.push_back({t.a, t.b, cell});
            sides_.push_back({t.b, t.c, cell});
            sides_.push_back({t.c, t.a, cell});
        }
        law(beyond_band_ <= max_beyond_band, "a triangle reaches out of its band");
        law(off_plane_ <= max_off_plane, "a triangle leaves the plane of its face");
        std::sort(sides_.begin(), sides_.end());
    }

    [[nodiscard]] const side_of* find(std::uint32_t a, std::uint32_t b) const
    {
        const auto it = std::lower_bound(sides_.begin(), sides_.end(), side_of{a, b, 0});
        return it != sides_.end() && it->a == a && it->b == b ? &*it : nullptr;
    }

    /// The sides without a counterpart are the region's boundary, and the cap's reversed.
    void check_edges()
    {
        for (std::size_t i = 1; i < sides_.size(); ++i)
            law(sides_[i - 1] < sides_[i], "two triangles have the same side");
        std::vector<side_of> wanted;
        for (std::uint32_t i = 0; i < next_.size(); ++i) wanted.push_back({i, next_[i], 0});
        const auto& s = swept_;
        for (std::uint32_t i = s.at_level[s.levels.size() - 1]; i < s.edges_at.size(); ++i)
            wanted.push_back({s.edges_at[i].b, s.edges_at[i].a, 0});
        std::sort(wanted.begin(), wanted.end());
        std::vector<side_of> open;
        for (const side_of& p : sides_)
            if (find(p.b, p.a) == nullptr) open.push_back(p);
        const auto is_same = [](const side_of& p, const side_of& q) { return p.a == q.a && p.b == q.b; };
        law(std::equal(open.begin(), open.end(), wanted.begin(), wanted.end(), is_same),
            "the triangles are not bounded by the region and the last level");
    }

    /// The edges at the last level are the cap's, by their places.
    void check_cap_edges()
    {
        using ends = std::array<std::int32_t, 4>;
        std::vector<ends> of_cap, of_level;
        const auto note = [](std::vector<ends>& list, typemesh::grid_point a, typemesh::grid_point b) {
            list.push_back({a.x, a.y, b.x, b.y});
        };
        for (const auto& l : typemesh::inspect::loops_of(swept_.cap))
            for (std::size_t i = 0; i < l.size(); ++i) note(of_cap, l[i], l[(i + 1) % l.size()]);
        for (std::uint32_t i = swept_.at_level[swept_.levels.size() - 1]; i < swept_.edges_at.size(); ++i)
            note(of_level, swept_.nodes[swept_.edges_at[i].a].at, swept_.nodes[swept_.edges_at[i].b].at);
        std::sort(of_cap.begin(), of_cap.end());
        std::sort(of_level.begin(), of_level.end());
        law(of_cap == of_level, "the edges at the last level are not the cap's");
    }

    /// The edges at a level separate the bands that meet there, and know their faces.
    void check_levels()
    {
        const auto& s = swept_;
        const auto last = s.levels.size() - 1;
        for (std::size_t k = 0; k <= last; ++k) {
            std::vector<side_of> listed, parting;
            for (std::uint32_t i = s.at_level[k]; i < s.at_level[k + 1]; ++i) {
                const auto e = s.edges_at[i];
                listed.push_back({e.a, e.b, 0});
                for (const std::uint32_t v : {e.a, e.b})
                    off_level_ = (std::max)(off_level_, std::fabs(double(s.nodes[v].distance) - s.levels[k]));
                const side_of *inner = find(e.a, e.b), *outer = find(e.b, e.a);
                law(k == last || (inner != nullptr && is_of_face(*inner, e.edge)),
                    "an edge at a level is not the face's within");
                law(k == 0 || (outer != nullptr && is_of_face(*outer, e.edge)),
                    "an edge at a level is not the face's without");
            }
            for (const side_of& p : sides_) {
                const side_of* other = find(p.b, p.a);  // none: beyond the region or, inside of all levels, in the cap
                const bool inside = s.cells[p.cell].band >= k;
                const bool parts = other != nullptr ? s.cells[other->cell].band < k : is_on_boundary(p);
                if (inside && parts) parting.push_back({p.a, p.b, 0});
                if (!inside && other == nullptr && !is_on_boundary(p)) parting.push_back({p.b, p.a, 0});
            }
            std::sort(listed.begin(), listed.end());
            std::sort(parting.begin(), parting.end());
            const auto is_same = [](const side_of& p, const side_of& q) { return p.a == q.a && p.b == q.b; };
            law(std::equal(listed.begin(), listed.end(), parting.begin(), parting.end(), is_same),
                "the edges at a level are not what parts its bands");
        }
        law(off_level_ <= max_off_level, "an edge at a level is not at its distance");
    }
    /// Whether the triangle belongs to the edge's face, or that face is too narrow to have a triangle in this band.
    [[nodiscard]] bool is_of_face(const side_of& p, std::uint32_t edge) const
    {
        const auto cell = swept_.cells[p.cell];
        const auto is_there = [&](const typemesh::swept_cell& c) { return c.edge == edge && c.band == cell.band; };
        return cell.edge == edge || std::none_of(swept_.cells.begin(), swept_.cells.end() - 1, is_there);
    }
    [[nodiscard]] bool is_on_boundary(const side_of& p) const { return p.a < next_.size() && next_[p.a] == p.b; }

    void check_areas()
    {
        const auto& s = swept_;
        auto left = static_cast<std::uint64_t>(typemesh::inspect::doubled_area(typemesh::inspect::loops_of(region_)));
        std::uint32_t cell = 0;
        areas_.assign(1, static_cast<std::int64_t>(left));
        for (std::uint32_t band = 0; band + 1 < s.levels.size(); ++band) {
            for (; cell + 1 < s.cells.size() && s.cells[cell].band == band; ++cell) {
                for (std::uint32_t i = s.cells[cell].first_triangle; i < s.cells[cell + 1].first_triangle; ++i) {
                    const typemesh::triangle t = s.triangles[i];
                    const typemesh::grid_point corners[3] = {s.nodes[t.a].at, s.nodes[t.b].at, s.nodes[t.c].at};
                    left -= static_cast<std::uint64_t>(typemesh::inspect::doubled_area(corners));
                }
            }
            areas_.push_back(static_cast<std::int64_t>(left));
            law(areas_[band + 1] <= areas_[band] && areas_[band + 1] >= 0, "the area grows from a level to the next");
        }
        const auto cap = typemesh::inspect::loops_of(s.cap);
        law(areas_.back() == typemesh::inspect::doubled_area(cap), "what the triangles leave is not the cap's area");
    }
    const typemesh::region& region_;
    const typemesh::swept_region& swept_;
    std::vector<std::uint32_t> next_;
    std::vector<side_of> sides_;
    std::vector<std::int64_t> areas_;
    double beyond_band_ = 0.0, off_plane_ = 0.0, off_level_ = 0.0;
    std::string broken_;
};

}  // namespace test

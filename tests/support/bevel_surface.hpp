// SPDX-License-Identifier: MIT
#pragma once

// A bevelled mesh in cells, and the laws of its triangles.

#include <typemesh/core/region.hpp>
#include <typemesh/extrude/part_sizes.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/mesh_view.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test {

using namespace typemesh;

/// Takes a mesh as a sink. With placement's defaults x and y are whole numbers of cells.
struct bevel_surface {
    static constexpr attribute wants = attribute::position | attribute::normal;

    std::vector<vec3> vertices, normals;
    std::vector<std::uint32_t> indices;
    part_sizes sizes;

    error begin(mesh_size) noexcept
    {
        vertices.clear();
        normals.clear();
        indices.clear();
        return {};
    }
    void vertex(const surface_point<wants>& v) noexcept
    {
        vertices.push_back(v.position);
        normals.push_back(v.normal);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        indices.insert(indices.end(), {a, b, c});
    }
    void end() noexcept {}

    struct range {
        std::size_t begin, end;
    };
    /// The triangles of a part.
    [[nodiscard]] range triangles_of(part p) const
    {
        const std::size_t first = sizes.triangles.starts()[p];
        return {first, first + sizes.triangles[p]};
    }
    [[nodiscard]] inspect::place corner(std::size_t triangle, std::size_t k) const
    {
        return inspect::to_place(vertices[indices[3 * triangle + k]]);
    }
    /// A vector normal to the triangle, outwards, twice as long as its area.
    [[nodiscard]] inspect::place normal(std::size_t t) const
    {
        return inspect::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0));
    }
    /// The number of corners of walls and bevels that are lit from behind: 90 degrees or more off the triangle. Triangles
    /// up to 3 cells high do not count, because their points are rounded to the grid. The height of a slope is measured
    /// in the plane.
    [[nodiscard]] std::size_t lit_from_behind() const
    {
        namespace inspect = typemesh::inspect;
        std::size_t found = 0;
        for (const auto p : {part::side, part::front_bevel, part::back_bevel}) {
            const auto all = triangles_of(p);
            for (std::size_t t = all.begin; t < all.end; ++t) {
                const auto n = normal(t);
                const double size = std::sqrt(dot(n, n));
                const bool upright = std::fabs(n.z) < 1e-9 * size;
                double longest = 0.0;
                for (std::size_t k = 0; k < 3; ++k) {
                    auto edge = corner(t, (k + 1) % 3) - corner(t, k);
                    if (!upright) edge.z = 0.0;
                    longest = (std::max)(longest, std::sqrt(dot(edge, edge)));
                }
                if (!((upright ? size : std::fabs(n.z)) > 3.0 * longest)) continue;
                for (std::size_t k = 0; k < 3; ++k)
                    found += !(dot(n, inspect::to_place(normals[indices[3 * t + k]])) > 0.0);
            }
        }
        return found;
    }
    [[nodiscard]] double volume() const { return inspect::measure(inspect::mesh_view{vertices, indices}).volume; }
};

/// Checks the mesh of a bevel with a profile that never falls.
///
///     CHECK(surface_laws{surface, region, false}.broken() == "");
class surface_laws {
public:
    /// With risers some triangles of the bevel are upright.
    surface_laws(const bevel_surface& s, const region& r, bool has_risers) : surface_{s}, region_{r}
    {
        has_risers_ = has_risers;
        find_touching_points();
        check_triangles();
        check_edges();
        law(s.lit_from_behind() == 0, "a normal is 90 degrees or more off its face");
    }

    /// The first law that is broken, in words, or "".
    [[nodiscard]] const std::string& broken() const { return broken_; }

    /// Twice the area of the front, in square cells.
    [[nodiscard]] double doubled_cap_area() const { return cap_area_; }

private:
    using part = typemesh::part;
    struct edge {
        std::uint64_t ends;    // two places, the lower one first
        std::uint32_t corner;  // 3 t + k: its start in triangle t
        bool forward;
    };

    void law(bool holds, const char* sentence)
    {
        if (!holds && broken_.empty()) broken_ = sentence;
    }

    void find_touching_points()
    {
        std::vector<std::pair<double, double>> all;
        for (const grid_point p : region_.points()) all.emplace_back(p.x, p.y);
        std::sort(all.begin(), all.end());
        for (std::size_t i = 1; i < all.size(); ++i)
            if (all[i] == all[i - 1]) touching_.insert(all[i]);
    }

    /// Front and back, with their bevels, cover the region once each: all of their triangles face their side, and their
    /// areas in the plane add up to the region's.
    void check_triangles()
    {
        const double whole = static_cast<double>(inspect::doubled_area(region_));
        for (const bool in_front : {true, false}) {
            double area = 0.0;
            for (const part p :
                 {in_front ? part::front : part::back, in_front ? part::front_bevel : part::back_bevel}) {
                const auto all = surface_.triangles_of(p);
                double of_part = 0.0;
                for (std::size_t t = all.begin; t < all.end; ++t) {
                    const auto n = surface_.normal(t);
                    const double up = (in_front ? 1.0 : -1.0) * n.z;
                    law(up > 0.0 || (has_risers_ && !(up < 0.0) && dot(n, n) > 0.0),
                        "a triangle of a cap or bevel is flat or turned over");
                    of_part += up;
                }
                area += of_part;
                if (p == part::front) cap_area_ = of_part;
            }
            law(!(area < whole || area > whole), "a side does not lie over the region once");
        }
        const auto walls = surface_.triangles_of(part::side);
        for (std::size_t t = walls.begin; t < walls.end; ++t) {
            const auto n = surface_.normal(t);
            law(dot(n, n) > 0.0, "a triangle of a wall is flat");
            law(!(n.z < 0.0 || n.z > 0.0), "a wall is not upright");
        }
    }

    /// Each edge has two triangles, except for upright edges at points where loops touch. Each place has one fan of
    /// triangles around it, except there and where a cap touches itself.
    void check_edges()
    {
        const inspect::mesh_view view{surface_.vertices, surface_.indices};
        const auto places = weld(view);
        std::vector<edge> edges;
        const auto corners = static_cast<std::uint32_t>(surface_.indices.size());
        edges.reserve(corners);
        const auto next = [](std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
        const auto place_of = [&](std::uint32_t c) { return std::uint64_t{places.of[surface_.indices[c]]}; };
        for (std::uint32_t c = 0; c < corners; ++c) {
            const std::uint64_t a = place_of(c), b = place_of(next(c));
            law(a != b, "an edge has no length");
            edges.push_back({a < b ? a << 32 | b : b << 32 | a, c, a < b});
        }
        std::sort(edges.begin(), edges.end(), [](const edge& p, const edge& q) { return p.ends < q.ends; });
        fan_.resize(corners);
        std::iota(fan_.begin(), fan_.end(), 0u);
        std::vector<bool> excused(places.at.size(), false);
        for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
            std::size_t forward = 0;
            for (end = i; end < edges.size() && edges[end].ends == edges[i].ends; ++end) forward += edges[end].forward;
            law(2 * forward == end - i, "the mesh is not closed");
            const std::uint64_t a = edges[i].ends >> 32, b = edges[i].ends & 0xFFFF'FFFFu;
            if (end - i == 2) {
                unite(edges[i].corner, next(edges[i + 1].corner));
                unite(next(edges[i].corner), edges[i + 1].corner);
                continue;
            }
            law(is_over_touching_point(places.at[a]) && is_over_touching_point(places.at[b]) &&
                    is_upright(places.at[a] - places.at[b]),
                "more than two triangles meet at an edge");
            excused[a] = excused[b] = true;
        }
        check_fans(places, excused);
    }

    void check_fans(const inspect::welded_places& places, std::vector<bool>& excused)
    {
        double high = -1e300, low = 1e300;
        for (const auto& p : places.at) high = (std::max)(high, p.z), low = (std::min)(low, p.z);
        constexpr std::uint32_t none = ~std::uint32_t{0};
        std::vector<std::uint32_t> fan_at(places.at.size(), none);
        for (std::uint32_t c = 0; c < fan_.size(); ++c) {
            const std::uint32_t at = places.of[surface_.indices[c]], fan = root(c);
            if (fan_at[at] == none) fan_at[at] = fan;
            if (fan_at[at] == fan || excused[at]) continue;
            const auto p = places.at[at];
            const bool is_on_cap = !(p.z < high) || !(p.z > low);
            law(is_on_cap || is_over_touching_point(p), "a point has two fans of triangles");
            excused[at] = true;
        }
    }

    [[nodiscard]] static bool is_upright(inspect::place along)
    {
        return !(along.x < 0.0 || along.x > 0.0 || along.y < 0.0 || along.y > 0.0);
    }
    [[nodiscard]] bool is_over_touching_point(inspect::place p) const { return touching_.count({p.x, p.y}) != 0; }

    [[nodiscard]] std::uint32_t root(std::uint32_t c)
    {
        while (fan_[c] != c) c = fan_[c] = fan_[fan_[c]];
        return c;
    }
    void unite(std::uint32_t a, std::uint32_t b) { fan_[root(a)] = root(b); }

    const bevel_surface& surface_;
    const region& region_;
    std::set<std::pair<double, double>> touching_;
    std::vector<std::uint32_t> fan_;  // for each corner, another one of the same fan
    bool has_risers_ = false;
    double cap_area_ = 0.0;
    std::string broken_;
};

}  // namespace test

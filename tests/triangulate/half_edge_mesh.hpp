// SPDX-License-Identifier: MIT
#pragma once

// Meshes of half-edges over polygons, and what is true of every such mesh.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/impl/chain_cutter.hpp>
#include <typemesh/triangulate/impl/half_edges.hpp>
#include <typemesh/triangulate/impl/monotone_sweep.hpp>

#include "support/regions.hpp"

#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace test {

/// Loops of points by their numbers.
using numbered_loops = std::vector<std::vector<std::uint32_t>>;

/// Whether these loops bound a region as they are.
inline bool is_region(const std::vector<polyline>& loops)
{
    const typemesh::contours given = contours_of(loops);
    typemesh::workspace space;
    typemesh::detail::monotone_sweep<true, false, typemesh::detail::no_cutter> sweep{
        given.points.view(), given.starts.view(), {}};
    return !sweep.run(space);
}

/// The mesh that a sweep makes of the points in `loops`, with room for all points.
class half_edge_mesh {
public:
    half_edge_mesh(std::vector<grid_point> points, const numbered_loops& loops)
        : points_{std::move(points)}, mesh{points_}
    {
        std::vector<grid_point> kept;
        std::vector<std::uint32_t> starts{0};
        for (const auto& l : loops) {
            for (const std::uint32_t v : l) {
                kept.push_back(points_[v]);
                names_.push_back(v);
            }
            starts.push_back(static_cast<std::uint32_t>(kept.size()));
        }
        if (!mesh.open(scratch_, points_.size() + 2 * loops.size())) throw std::runtime_error("no memory");
        using output = typemesh::detail::half_edges::output;
        using cutter = typemesh::detail::chain_cutter<output>;
        typemesh::detail::monotone_sweep<true, false, cutter> sweep{kept, starts, cutter{output{mesh, names_.data()}}};
        typemesh::workspace other;
        if (sweep.run(other)) throw std::runtime_error("no region");
        mesh.finish(sweep.cutter().output());
    }

    [[nodiscard]] std::vector<typemesh::triangle> triangles() const
    {
        std::vector<typemesh::triangle> all(mesh.end() / 4);
        mesh.write(all.data());
        return all;
    }
    [[nodiscard]] const std::vector<grid_point>& points() const { return points_; }
    [[nodiscard]] typemesh::workspace::scope& scratch() { return scratch_; }

private:
    std::vector<grid_point> points_;
    std::vector<std::uint32_t> names_;
    typemesh::workspace space_;
    typemesh::workspace::scope scratch_{space_};

public:
    typemesh::detail::half_edges mesh;
};

/// The first law that a mesh with this boundary breaks, or nothing.
inline std::string broken_mesh(const half_edge_mesh& m, const numbered_loops& loops)
{
    using typemesh::detail::half_edges;
    const half_edges& e = m.mesh;
    std::size_t boundary = 0, first = 0, inner = 0;
    for (std::uint32_t t = 0; t < e.end(); t += 4) {
        if (orientation(e.place(t), e.place(t + 1), e.place(t + 2)) <= 0) return "a triangle is flat or clockwise";
        for (std::uint32_t h = t; h < t + 3; ++h) {
            if (!(e.place(h) == m.points()[e.origin(h)])) return "a half-edge is not where its point is";
            if (half_edges::previous(half_edges::next(h)) != h) return "next() and previous() are not opposite";
            if (e.is_boundary(h)) {
                ++boundary;
                if (e.boundary_from(e.origin(h)) != h) return "a boundary edge is not found by its first point";
                if (e.is_first_half(h)) return "a boundary edge is the first half of an inner edge";
                continue;
            }
            const std::uint32_t g = e.twin(h);
            ++inner;
            first += e.is_first_half(h);
            if (e.twin(g) != h) return "a twin has another twin";
            if (e.origin(g) != e.origin(half_edges::next(h))) return "a twin does not begin where its edge ends";
        }
    }
    if (2 * first != inner) return "not one half of every inner edge is its first";
    std::size_t edges = 0;
    for (const auto& l : loops) {
        edges += l.size();
        for (std::size_t i = 0; i < l.size(); ++i) {
            const std::uint32_t h = e.boundary_from(l[i]);
            if (!e.is_boundary(h) || e.origin(h) != l[i] || e.origin(half_edges::next(h)) != l[(i + 1) % l.size()])
                return "an edge of the region is not where its first point says";
        }
    }
    return edges == boundary ? "" : "there are boundary edges that the region does not have";
}

/// Why the mesh does not cover the region of these loops, or nothing.
inline std::string broken_cover(const half_edge_mesh& m, const numbered_loops& loops)
{
    std::vector<std::uint32_t> place(m.points().size(), ~std::uint32_t{0});
    std::vector<polyline> placed;
    std::uint32_t count = 0, holes = 0;
    for (const auto& l : loops) {
        placed.emplace_back();
        for (const std::uint32_t v : l) {
            place[v] = count++;
            placed.back().push_back(m.points()[v]);
        }
        holes += oracle::doubled_area(oracle::loop{placed.back()}) < 0;
    }
    std::vector<typemesh::triangle> triangles = m.triangles();
    for (typemesh::triangle& t : triangles) t = {place[t.a], place[t.b], place[t.c]};
    const typemesh::contours given = contours_of(placed);
    const auto outers = static_cast<std::uint32_t>(loops.size()) - holes;
    return oracle::broken_law(typemesh::region::proven(given, holes, outers), triangles);
}

/// All points of a shape, and its loops by their numbers.
struct numbered_shape {
    std::vector<grid_point> points;
    numbered_loops loops;

    explicit numbered_shape(const shape& s)
    {
        for (const polyline& l : s.loops) {
            loops.emplace_back(l.size());
            std::iota(loops.back().begin(), loops.back().end(), static_cast<std::uint32_t>(points.size()));
            points.insert(points.end(), l.begin(), l.end());
        }
    }
};

/// A region, a point of its boundary, and the point before it. Without the point it is a region too.
struct one_point_less {
    numbered_shape all;
    numbered_loops loops;  ///< without it
    std::uint32_t before, left_out;
};

/// A random polygon of a small grid, if it is a region with and without a point taken at random.
inline std::optional<one_point_less> random_point_less(dice& d)
{
    const int width = 4 + d.roll(12), n = 4 + d.roll((std::min)(width * width / 3, 40));
    const shape s{"", {random_polygon(n, width, d)}};
    if (!is_region(s.loops)) return {};
    one_point_less made{numbered_shape{s}, {}, 0, 0};
    const std::size_t k = static_cast<std::size_t>(d.roll(static_cast<std::int32_t>(s.loops[0].size())));
    made.loops = made.all.loops;
    made.left_out = made.loops[0][k];
    made.before = made.loops[0][(k + made.loops[0].size() - 1) % made.loops[0].size()];
    made.loops[0].erase(made.loops[0].begin() + static_cast<std::ptrdiff_t>(k));
    polyline rest;
    for (const std::uint32_t v : made.loops[0]) rest.push_back(s.loops[0][v]);
    if (!is_region({rest})) return {};
    return made;
}

}  // namespace test

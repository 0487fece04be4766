// SPDX-License-Identifier: MIT
#pragma once

// The peer of bench_refine: CGAL's two-dimensional Delaunay mesher (GPL). Only with -DTYPEMESH_BENCH_PEERS=ON; nothing of it is
// installed or part of the library. It gets the region's edges in double precision, adds no point on a curve, and takes the
// same bound for angles (sin^2, as it wants it) and for the length of edges.

#include <typemesh/core/region.hpp>
#include <typemesh/refine/delaunay_refined.hpp>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace bench {

/// How many triangles CGAL makes of a region.
inline std::size_t cgal_triangles(const typemesh::region& r, const typemesh::delaunay_refined& how)
{
    using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using vertices = CGAL::Triangulation_vertex_base_2<kernel>;
    using storage = CGAL::Triangulation_data_structure_2<vertices, CGAL::Delaunay_mesh_face_base_2<kernel>>;
    using cdt = CGAL::Constrained_Delaunay_triangulation_2<kernel, storage>;
    using criteria = CGAL::Delaunay_mesh_size_criteria_2<cdt>;
    std::vector<kernel::Point_2> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (const typemesh::grid_point p : r.points()) points.emplace_back(p.x, p.y);
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
        const std::uint32_t begin = r.starts()[loop], end = r.starts()[loop + 1];
        for (std::uint32_t i = begin; i < end; ++i) edges.emplace_back(i, i + 1 < end ? i + 1 : begin);
    }
    cdt t;
    t.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
    // What is meshed is what an odd number of constraints parts from the outside.
    for (auto f = t.all_faces_begin(); f != t.all_faces_end(); ++f) f->set_in_domain(false);
    std::vector<std::pair<cdt::Face_handle, bool>> stack{{t.infinite_face(), false}};
    CGAL::Unique_hash_map<cdt::Face_handle, bool> seen(false);
    seen[t.infinite_face()] = true;
    while (!stack.empty()) {
        const auto [face, inside] = stack.back();
        stack.pop_back();
        face->set_in_domain(inside);
        for (int i = 0; i < 3; ++i) {
            const cdt::Face_handle next = face->neighbor(i);
            if (seen[next]) continue;
            seen[next] = true;
            stack.emplace_back(next, inside != t.is_constrained({face, i}));
        }
    }
    const double sine = std::sin(double{how.min_angle} * 0.017453292519943295);
    CGAL::Delaunay_mesher_2<cdt, criteria> mesher{
        t, criteria{sine * sine, double{how.max_edge} * r.grid().cells * r.grid().units_per_em}};
    mesher.init(true);
    mesher.refine_mesh();
    std::size_t count = 0;
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) count += f->is_in_domain();
    return count;
}

}  // namespace bench

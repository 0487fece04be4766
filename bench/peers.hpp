// SPDX-License-Identifier: MIT
#pragma once

// The peers of bench_delaunay: GLU's tessellator (SGI Free Software Licence B) and CGAL's constrained Delaunay triangulation (GPL).
// Only with -DTYPEMESH_BENCH_PEERS=ON; nothing here is installed or part of the library. Each gets the loops as monotone accepts
// them and leaves its result in its own form. POSIX only.

#include "seconds_within.hpp"

#include <typemesh/core/contours.hpp>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>
#include <GL/glu.h>

#include <array>
#include <cstdint>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace bench {

struct glu_run {
    GLUtesselator* tessellator = gluNewTess();
    std::vector<std::array<double, 3>> places;
    std::vector<std::uint32_t> triangles;

    glu_run()
    {
        const auto set = [this](GLenum which, auto f) {
            gluTessCallback(tessellator, which, reinterpret_cast<_GLUfuncptr>(f));
        };
        set(
            GLU_TESS_VERTEX_DATA, +[](void* index, void* self) {
                static_cast<glu_run*>(self)->triangles.push_back(
                    static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(index)));
            });
        set(GLU_TESS_EDGE_FLAG, +[](GLboolean) {});  // so that triangles come one by one
        set(GLU_TESS_COMBINE, +[](double*, void**, float*, void** out) { *out = nullptr; });
        gluTessProperty(tessellator, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
        gluTessNormal(tessellator, 0, 0, 1);
    }
    glu_run(const glu_run&) = delete;
    ~glu_run() { gluDeleteTess(tessellator); }

    void operator()(const contours& c)
    {
        triangles.clear();
        places.clear();
        for (const grid_point p : c.points) places.push_back({double(p.x), double(p.y), 0.0});
        gluTessBeginPolygon(tessellator, this);
        for (std::uint32_t loop = 0; loop < c.contour_count(); ++loop) {
            gluTessBeginContour(tessellator);
            for (std::uint32_t i = c.starts[loop]; i < c.starts[loop + 1]; ++i)
                gluTessVertex(tessellator, places[i].data(), reinterpret_cast<void*>(std::uintptr_t{i}));
            gluTessEndContour(tessellator);
        }
        gluTessEndPolygon(tessellator);
    }
};

inline void glu(const contours& c)
{
    static glu_run run;
    run(c);
}

inline void cgal(const contours& c)
{
    using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using faces =
        CGAL::Constrained_triangulation_face_base_2<kernel, CGAL::Triangulation_face_base_with_info_2<int, kernel>>;
    using storage = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<kernel>, faces>;
    using cdt = CGAL::Constrained_Delaunay_triangulation_2<kernel, storage, CGAL::No_constraint_intersection_tag>;
    std::vector<kernel::Point_2> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (const grid_point p : c.points) points.emplace_back(p.x, p.y);
    for (std::uint32_t loop = 0; loop < c.contour_count(); ++loop)
        for (std::uint32_t i = c.starts[loop]; i < c.starts[loop + 1]; ++i)
            edges.emplace_back(i, i + 1 < c.starts[loop + 1] ? i + 1 : c.starts[loop]);
    cdt t;
    t.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
    // Inside is what an odd number of constraints parts from the infinite face.
    for (auto f = t.all_faces_begin(); f != t.all_faces_end(); ++f) f->info() = -1;
    std::list<cdt::Edge> border;
    const auto flood = [&](cdt::Face_handle start, int depth) {
        if (start->info() != -1) return;
        std::vector<cdt::Face_handle> open{start};
        start->info() = depth;
        while (!open.empty()) {
            const cdt::Face_handle f = open.back();
            open.pop_back();
            for (int i = 0; i < 3; ++i) {
                const cdt::Face_handle g = f->neighbor(i);
                if (g->info() != -1) continue;
                if (t.is_constrained(cdt::Edge{f, i})) {
                    border.push_back({f, i});
                } else {
                    g->info() = depth;
                    open.push_back(g);
                }
            }
        }
    };
    flood(t.infinite_face(), 0);
    while (!border.empty()) {
        const cdt::Edge e = border.front();
        border.pop_front();
        flood(e.first->neighbor(e.second), e.first->info() + 1);
    }
}

inline const std::vector<std::pair<std::string, void (*)(const contours&)>>& peers()
{
    static const std::vector<std::pair<std::string, void (*)(const contours&)>> all{{"GLU", glu}, {"CGAL", cgal}};
    return all;
}

}  // namespace bench

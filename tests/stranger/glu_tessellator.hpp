// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/triangulate/triangulator.hpp>

#include <GL/glu.h>

#include <cstddef>
#include <cstdint>

namespace stranger {

/// OpenGL's own old tessellator. Written only from the comment on triangulator.
struct glu_tessellator {
    typemesh::error operator()(const typemesh::region& r, typemesh::workspace& space,
                               typemesh::triangle_list& out) const noexcept
    {
        const auto points = r.points();
        const std::size_t before = out.size();
        typemesh::workspace::scope scratch{space};
        double* places = scratch.take<double>(3 * points.size());
        GLUtesselator* tess = gluNewTess();
        if (places == nullptr || tess == nullptr || !out.reserve(before + r.triangle_count())) {
            if (tess != nullptr) gluDeleteTess(tess);
            return typemesh::error::out_of_memory;
        }
        job work{places, out};
        gluTessProperty(tess, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
        gluTessNormal(tess, 0.0, 0.0, 1.0);
        gluTessCallback(tess, GLU_TESS_VERTEX_DATA, reinterpret_cast<_GLUfuncptr>(&corner));
        gluTessCallback(tess, GLU_TESS_EDGE_FLAG_DATA, reinterpret_cast<_GLUfuncptr>(&only_triangles));
        gluTessCallback(tess, GLU_TESS_COMBINE_DATA, reinterpret_cast<_GLUfuncptr>(&join));
        gluTessCallback(tess, GLU_TESS_ERROR_DATA, reinterpret_cast<_GLUfuncptr>(&fail));
        gluTessBeginPolygon(tess, &work);
        for (std::uint32_t k = 0; k < r.loop_count(); ++k) {
            gluTessBeginContour(tess);
            for (std::uint32_t i = r.starts()[k]; i < r.starts()[k + 1]; ++i) {
                double* place = places + 3 * std::size_t{i};
                place[0] = points[i].x, place[1] = points[i].y, place[2] = 0.0;
                gluTessVertex(tess, place, place);
            }
            gluTessEndContour(tess);
        }
        gluTessEndPolygon(tess);
        gluDeleteTess(tess);
        if (!work.failed) return {};
        out.truncate(before);
        return work.failed;
    }

private:
    struct job {
        const double* places;
        typemesh::triangle_list& out;
        std::uint32_t corners[3] = {};
        std::size_t count = 0;
        typemesh::error failed = {};
    };
    static void corner(void* place, void* data)
    {
        job& work = *static_cast<job*>(data);
        work.corners[work.count++] = static_cast<std::uint32_t>((static_cast<const double*>(place) - work.places) / 3);
        if (work.count < 3) return;
        work.count = 0;
        if (!work.out.push_back({work.corners[0], work.corners[1], work.corners[2]}))
            work.failed = typemesh::error::out_of_memory;
    }
    static void only_triangles(GLboolean, void*) {}
    static void join(const GLdouble*, void* met[4], const GLfloat*, void** out, void*)
    {
        *out = met[0];
    }  // equal points
    static void fail(GLenum, void* data) { static_cast<job*>(data)->failed = typemesh::error::refused_by_user; }
};
static_assert(typemesh::triangulator<glu_tessellator>);

}  // namespace stranger

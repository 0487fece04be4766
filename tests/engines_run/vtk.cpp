// SPDX-License-Identifier: MIT
//
// VTK's own eyes on the vtkPolyData that the recipe in docs/engines.md fills.

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkIdList.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <typemesh/vertex/growing_sink.hpp>

#include "engines/recipe_laws.hpp"

typemesh::error vtk_snippet(const typemesh::result<typemesh::text_plan<typemesh::extruded<>>>& plan, vtkPolyData* text);

using namespace recipes;

namespace {

text_options options()
{
    text_options o;
    o.frame.uv = uv_origin::bottom_left;
    return o;
}

}  // namespace

TEST_CASE("VTK's arrays hold the mesh, counter-clockwise, v upwards", "[engines]")
{
    bench b;
    const auto plan = b.mesher.plan(word, options());
    REQUIRE(plan);
    vtkNew<vtkPolyData> text;
    REQUIRE_FALSE(vtk_snippet(plan, text));
    seen mesh;
    for (vtkIdType i = 0; i < text->GetNumberOfPoints(); ++i) {
        const double *p = text->GetPoint(i), *n = nullptr, *t = nullptr;
        mesh.position.push_back({float(p[0]), float(p[1]), float(p[2])});
        n = text->GetPointData()->GetNormals()->GetTuple3(i);
        mesh.normal.push_back({float(n[0]), float(n[1]), float(n[2])});
        t = text->GetPointData()->GetTCoords()->GetTuple2(i);
        mesh.uv.push_back({float(t[0]), float(t[1])});
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < text->GetNumberOfPolys(); ++i) {
        text->GetPolys()->GetCellAtId(i, corners);
        REQUIRE(corners->GetNumberOfIds() == 3);
        for (vtkIdType k = 0; k < 3; ++k) mesh.index.push_back(static_cast<std::uint32_t>(corners->GetId(k)));
    }
    obeys(mesh, *plan, opengl);
}

TEST_CASE("VTK finds no open edge, no edge of three faces, and the same box and volume", "[engines]")
{
    bench b;
    const auto plan = b.mesher.plan(word, options());
    REQUIRE(plan);
    vtkNew<vtkPolyData> text;
    REQUIRE_FALSE(vtk_snippet(plan, text));
    vtkNew<vtkCleanPolyData> joined;  // points in one place become one
    joined->SetInputData(text);
    joined->SetTolerance(0.0);
    vtkNew<vtkFeatureEdges> faults;
    faults->SetInputConnection(joined->GetOutputPort());
    faults->BoundaryEdgesOn();
    faults->NonManifoldEdgesOn();
    faults->FeatureEdgesOff();
    faults->ManifoldEdgesOff();
    faults->Update();
    CHECK(faults->GetOutput()->GetNumberOfCells() == 0);
    CHECK(joined->GetOutput()->GetNumberOfPolys() == static_cast<vtkIdType>(plan->size().triangles));

    std::vector<test::full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    REQUIRE(plan->write(into(vertices, indices)));
    vtkNew<vtkMassProperties> solid;
    solid->SetInputConnection(joined->GetOutputPort());
    solid->Update();
    CHECK(solid->GetVolume() == Catch::Approx(test::volume(vertices, indices)).epsilon(1e-5));

    double box[6];
    text->GetBounds(box);
    const bounds3 said = plan->bounds();
    CHECK(box[0] == double{said.low.x});
    CHECK(box[1] == double{said.high.x});
    CHECK(box[2] == double{said.low.y});
    CHECK(box[3] == double{said.high.y});
    CHECK(box[4] == double{said.low.z});
    CHECK(box[5] == double{said.high.z});
}

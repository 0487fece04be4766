// SPDX-License-Identifier: MIT
//
// The lines of docs/engines.md for VTK: tests/run.sh --with engines compiles and runs them.

#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <cstddef>
#include <cstdint>
#include <span>

using plan_type = typemesh::result<typemesh::text_plan<typemesh::extruded<>>>;

typemesh::error vtk_snippet(const plan_type& plan, vtkPolyData* text);
typemesh::error vtk_snippet(const plan_type& plan, vtkPolyData* text)
{
const auto size = plan->size();
const auto floats = [&](vtkFloatArray* array, int components) {
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(size.vertices);
    return std::as_writable_bytes(std::span{array->GetPointer(0), size.vertices * std::size_t(components)});
};
vtkNew<vtkFloatArray> positions, normals, uvs;
vtkNew<vtkTypeInt32Array> corners;
corners->SetNumberOfValues(vtkIdType(size.indices()));
using typemesh::attribute;
auto written = plan->write(typemesh::stream_sink{std::span{corners->GetPointer(0), size.indices()},
                                               typemesh::stream<attribute::position, typemesh::vec3>::in(floats(positions, 3), 0),
                                               typemesh::stream<attribute::normal, typemesh::vec3>::in(floats(normals, 3), 0),
                                               typemesh::stream<attribute::uv, typemesh::vec2>::in(floats(uvs, 2), 0)});
vtkNew<vtkPoints> points;
points->SetData(positions);
vtkNew<vtkCellArray> triangles;
triangles->SetData(3, corners);
text->SetPoints(points);
text->SetPolys(triangles);
text->GetPointData()->SetNormals(normals);
text->GetPointData()->SetTCoords(uvs);
    return written.error();
}

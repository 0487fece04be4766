// SPDX-License-Identifier: MIT
//
// VTK's vtkVectorText, extruded, with normals. It has a face of its own, whose letters are triangulated already: it reads no
// font, and there are no curves to compare it with.

#include "peer_program.hpp"

#include <vtkLinearExtrusionFilter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>
#include <vtkVectorText.h>

#include <memory>

namespace {

struct pipeline {
    vtkNew<vtkVectorText> text;
    vtkNew<vtkLinearExtrusionFilter> solid;
    vtkNew<vtkTriangleFilter> triangles;
    vtkNew<vtkPolyDataNormals> normals;

    pipeline()
    {
        solid->SetInputConnection(text->GetOutputPort());
        solid->SetExtrusionTypeToVectorExtrusion();
        solid->SetVector(0, 0, 1);
        solid->SetScaleFactor(peers::depth);
        triangles->SetInputConnection(solid->GetOutputPort());
        normals->SetInputConnection(triangles->GetOutputPort());
    }

    peers::mesh made() const
    {
        peers::mesh m;
        vtkPolyData* data = normals->GetOutput();
        for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
            for (const double x : {data->GetPoint(i)[0], data->GetPoint(i)[1], data->GetPoint(i)[2]})
                m.points.push_back(float(x));
        const vtkIdType* corners = nullptr;
        vtkIdType n = 0;
        vtkCellArray* cells = data->GetPolys();
        for (cells->InitTraversal(); cells->GetNextCell(n, corners) != 0;)
            for (vtkIdType i = 0; i < n; ++i) m.corners.push_back(std::uint32_t(corners[i]));
        return m;
    }
};

std::vector<peers::way> open(const std::string& file)
{
    if (file.find("LiberationSans") == std::string::npos) return {};  // once is enough: it takes no font
    const auto all = std::make_shared<pipeline>();
    return {{"a face of its own", "extruded", "cold",
             [all](const std::string& text) {
                 all->text->SetText(text.c_str());
                 all->text->Modified();
                 all->normals->Update();
                 return all->normals->GetOutput()->GetNumberOfPolys() > 0;
             },
             [all] { return all->made(); }}};
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc > 1 && std::strcmp(argv[1], "meshes") == 0) return 0;
    return peers::run(argc, argv, "VTK", open);
}

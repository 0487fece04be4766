// SPDX-License-Identifier: MIT
//
// Open CASCADE: exact faces of the text, a prism of them, a mesh of that.

#include "peer_program.hpp"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <Font_BRepFont.hxx>
#include <Font_BRepTextBuilder.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <memory>

namespace {

peers::mesh mesh_of(const TopoDS_Shape& solid)
{
    peers::mesh m;
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Face& face = TopoDS::Face(faces.Current());
        TopLoc_Location place;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
        if (mesh.IsNull()) continue;
        const auto base = std::uint32_t(m.vertices());
        for (int i = 1; i <= mesh->NbNodes(); ++i) {
            const gp_Pnt p = mesh->Node(i).Transformed(place.Transformation());
            for (const double x : {p.X(), p.Y(), p.Z()}) m.points.push_back(float(x));
        }
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            int a = 0, b = 0, c = 0;
            mesh->Triangle(i).Get(a, b, c);
            if (face.Orientation() == TopAbs_REVERSED) std::swap(a, b);
            for (const int corner : {a, b, c}) m.corners.push_back(base + std::uint32_t(corner) - 1);
        }
    }
    return m;
}

std::vector<peers::way> open(const std::string& file)
{
    std::vector<peers::way> ways;
    for (const double deflection : {1e-2, 1e-3}) {
        char setting[48];
        std::snprintf(setting, sizeof setting, "deflection %g em", deflection);
        const auto solid = std::make_shared<TopoDS_Shape>();
        ways.push_back({setting, "extruded", "reuse",
                        [=](const std::string& text) {
                            Font_BRepFont font;  // keeps its letters: anew for each text
                            if (!font.Init(file.c_str(), 1.0, 0)) return false;
                            Font_BRepTextBuilder builder;
                            const TopoDS_Shape flat = builder.Perform(font, NCollection_String(text.c_str()));
                            if (flat.IsNull()) return false;
                            *solid = BRepPrimAPI_MakePrism(flat, gp_Vec(0, 0, peers::depth)).Shape();
                            BRepMesh_IncrementalMesh mesh(*solid, deflection);
                            return true;
                        },
                        [solid] { return mesh_of(*solid); }});
    }
    return ways;
}

}  // namespace

int main(int argc, char** argv) { return peers::run(argc, argv, "OCCT", open); }

// SPDX-License-Identifier: MIT
//
// Draws an OBJ file as text_to_mesh draws its meshes, each triangle in the light of its own plane.
//
//     draw_obj FILE.obj FILE.png

#include "obj_triangles.hpp"
#include "picture/picture.hpp"
#include "write_png.hpp"

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
    using namespace text_to_mesh;
    if (argc != 3) return 2;
    const three::obj_triangles mesh(argv[1]);
    model drawn;
    for (const char* name : {"front", "back", "side", "front_bevel", "back_bevel"}) {
        const std::size_t first = drawn.indices.size();
        for (const three::obj_triangles::triangle& t : mesh.triangles) {
            if (t.part != name) continue;
            for (const std::size_t corner : t.corners) {
                const std::array<float, 3>& p = mesh.points[corner];
                drawn.indices.push_back(static_cast<std::uint32_t>(drawn.vertices.size()));
                drawn.vertices.push_back({{p[0], p[1], p[2]}, {}, {}});
            }
        }
        drawn.parts.push_back({name, first, drawn.indices.size() - first});
    }
    picture_options options;
    options.shading = shading::flat;
    int width = 0, height = 0;
    const std::vector<unsigned char> rgb = draw(drawn, {}, options, width, height);
    file_set files;
    std::string problem = write_png(rgb, width, height, argv[2], files);
    if (problem.empty()) problem = files.finish();
    std::fputs(problem.c_str(), stderr);
    return problem.empty() ? 0 : 1;
}

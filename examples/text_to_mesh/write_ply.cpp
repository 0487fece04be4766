// SPDX-License-Identifier: MIT
#include "write_ply.hpp"

#include "byte_writer.hpp"

namespace text_to_mesh {

std::string write_ply(const model& mesh, const std::string& path, file_set& files)
{
    byte_writer out;
    const std::size_t triangles = mesh.indices.size() / 3;
    out.reserve(1024 + mesh.vertices.size() * 32 + triangles * 14);
    out.text("ply\nformat binary_little_endian 1.0\ncomment written by typemesh\n");
    if (!mesh.name.empty()) out.text("comment " + one_line(mesh.name) + "\n");
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        out.text("comment part " + std::to_string(i) + " " + mesh.parts[i].name + "\n");
    out.text("element vertex " + std::to_string(mesh.vertices.size()) + "\n");
    for (const char* property : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
        out.text(std::string("property float ") + property + "\n");
    out.text("element face " + std::to_string(triangles) + "\n");
    out.text("property list uchar uint vertex_indices\n");
    if (!mesh.parts.empty()) out.text("property uchar part\n");
    out.text("end_header\n");
    for (const model_vertex& v : mesh.vertices) {
        for (const float f : v.position) out.f32(f);
        for (const float f : v.normal) out.f32(f);
        for (const float f : v.uv) out.f32(f);
    }
    std::size_t part = 0;
    for (std::size_t t = 0; t < triangles; ++t) {
        out.u8(3);
        for (std::size_t i = 0; i < 3; ++i) out.u32(mesh.indices[3 * t + i]);
        if (mesh.parts.empty()) continue;
        while (3 * t >= mesh.parts[part].first_index + mesh.parts[part].index_count) ++part;
        out.u8(static_cast<std::uint8_t>(part));
    }
    return files.add(path, out.bytes());
}

}  // namespace text_to_mesh

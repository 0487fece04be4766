// SPDX-License-Identifier: MIT
#include "write_obj.hpp"

#include "atomic_file.hpp"
#include "byte_writer.hpp"

namespace text_to_mesh {
namespace {

void line(byte_writer& out, const char* key, const float* values, int count)
{
    out.text(key);
    for (int i = 0; i < count; ++i) {
        out.u8(' ');
        out.decimal(values[i]);
    }
    out.u8('\n');
}

void faces(byte_writer& out, const model& mesh, std::size_t first, std::size_t count)
{
    for (std::size_t i = first; i + 2 < first + count; i += 3) {
        out.u8('f');
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t number = std::uint64_t{mesh.indices[i + corner]} + 1;  // OBJ counts from one
            for (const char before : {' ', '/', '/'}) {
                out.u8(static_cast<unsigned char>(before));
                out.decimal(number);
            }
        }
        out.u8('\n');
    }
}

}  // namespace

std::string write_obj(const model& mesh, const std::string& path)
{
    byte_writer out;
    out.reserve(mesh.vertices.size() * 90 + mesh.indices.size() * 20 + 256);
    out.text("# written by typemesh\no ");
    out.text(mesh.name.empty() ? "text" : one_line(mesh.name));
    out.u8('\n');
    for (const model_vertex& v : mesh.vertices) line(out, "v", v.position, 3);
    for (const model_vertex& v : mesh.vertices) line(out, "vt", v.uv, 2);
    for (const model_vertex& v : mesh.vertices) line(out, "vn", v.normal, 3);
    for (const model::part& part : mesh.parts) {
        if (part.index_count == 0) continue;
        out.text("g ");
        out.text(part.name);
        out.u8('\n');
        faces(out, mesh, part.first_index, part.index_count);
    }
    if (mesh.parts.empty()) faces(out, mesh, 0, mesh.indices.size());
    return write_atomically(path, out.bytes());
}

}  // namespace text_to_mesh

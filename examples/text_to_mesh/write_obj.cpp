// SPDX-License-Identifier: MIT
#include "write_obj.hpp"

#include "byte_writer.hpp"
#include "part_colours.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace text_to_mesh {
namespace {

/// At most three numbers.
void line(byte_writer& out, const char* key, const float* values, int count)
{
    char written[3 * 32];
    char* at = written;
    for (int i = 0; i < count; ++i) {
        *at++ = ' ';
        at = std::to_chars(at, written + sizeof written - 1, values[i]).ptr;
    }
    *at++ = '\n';
    out.text(key);
    out.text({written, at});
}

void faces(byte_writer& out, const model& mesh, std::size_t first, std::size_t count)
{
    char line[3 * 3 * 24], number[24];  // " 12345/12345/12345" three times
    for (std::size_t i = first; i + 2 < first + count; i += 3) {
        char* at = line;
        *at++ = 'f';
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t one_based = std::uint64_t{mesh.indices[i + corner]} + 1;
            const char* const end = std::to_chars(number, number + sizeof number, one_based).ptr;
            for (const char before : {' ', '/', '/'}) {
                *at++ = before;
                at = std::copy(static_cast<const char*>(number), end, at);
            }
        }
        *at++ = '\n';
        out.text({line, at});
    }
}

/// One material per part, named after it.
byte_writer materials(const model& mesh)
{
    byte_writer out;
    out.text("# written by typemesh\n");
    for (const model::part& part : mesh.parts) {
        if (part.index_count == 0) continue;
        out.text("newmtl ");
        out.text(part.name);
        float colour[3];
        for (std::size_t i = 0; i < 3; ++i) colour[i] = static_cast<float>(colour_of(part).rgb[i]) / 255.0F;
        out.u8('\n');
        line(out, "Kd", colour, 3);
        out.text("Ks 0.2 0.2 0.2\nNs 60\nillum 2\n");
    }
    return out;
}

}  // namespace

std::string write_obj(const model& mesh, const std::string& path, file_set& files)
{
    const bool alone = mesh.parts.empty() || path == standard_output;
    byte_writer out;
    out.reserve(mesh.vertices.size() * 90 + mesh.indices.size() * 20 + 256);
    out.text("# written by typemesh\n");
    const std::filesystem::path material_path = std::filesystem::path(path).replace_extension(".mtl");
    if (!alone) out.text("mtllib " + one_line(material_path.filename().string()) + "\n");
    if (mesh.solid_names.empty())
        out.text("o " + (mesh.name.empty() ? std::string{"text"} : one_line(mesh.name)) + "\n");
    for (const model_vertex& v : mesh.vertices) line(out, "v", v.position, 3);
    for (const model_vertex& v : mesh.vertices) line(out, "vt", v.uv, 2);
    for (const model_vertex& v : mesh.vertices) line(out, "vn", v.normal, 3);
    for (const model::part& part : mesh.parts) {
        if (part.index_count == 0) continue;
        if (!mesh.solid_names.empty() && (&part == mesh.parts.data() || part.solid != (&part)[-1].solid))
            out.text("o " + mesh.solid_names[part.solid] + "\n");
        out.text("g " + part.name + (alone ? "\n" : "\nusemtl " + part.name + "\n"));
        faces(out, mesh, part.first_index, part.index_count);
    }
    if (mesh.parts.empty()) faces(out, mesh, 0, mesh.indices.size());
    if (alone) return files.add(path, out.bytes());
    const byte_writer colours = materials(mesh);
    std::string trouble = files.add(material_path.string(), colours.bytes());
    return trouble.empty() ? files.add(path, out.bytes()) : trouble;
}

}  // namespace text_to_mesh

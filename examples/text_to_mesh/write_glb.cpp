// SPDX-License-Identifier: MIT
#include "write_glb.hpp"

#include "atomic_file.hpp"
#include "byte_writer.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <sstream>

namespace text_to_mesh {
namespace {

/// The length of the well-formed UTF-8 sequence at the start of `s` (not empty), or 0.
std::size_t sequence_length(std::string_view s)
{
    const auto at = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0u; };
    const auto follows = [&](std::size_t i) { return (at(i) & 0xC0u) == 0x80u; };
    const unsigned lead = at(0);
    if (lead < 0x80u) return 1;
    if (lead >= 0xC2u && lead <= 0xDFu) return follows(1) ? 2 : 0;
    if (lead >= 0xE0u && lead <= 0xEFu) {
        if (!follows(1) || !follows(2)) return 0;
        if (lead == 0xE0u && at(1) < 0xA0u) return 0;  // longer than needed
        if (lead == 0xEDu && at(1) > 0x9Fu) return 0;  // a surrogate
        return 3;
    }
    if (lead >= 0xF0u && lead <= 0xF4u) {
        if (!follows(1) || !follows(2) || !follows(3)) return 0;
        if (lead == 0xF0u && at(1) < 0x90u) return 0;
        if (lead == 0xF4u && at(1) > 0x8Fu) return 0;
        return 4;
    }
    return 0;
}

/// JSON holds well-formed Unicode only: every other byte becomes U+FFFD.
std::string well_formed(std::string_view s)
{
    std::string out;
    while (!s.empty()) {
        const std::size_t length = sequence_length(s);
        if (length == 0) out += "\xEF\xBF\xBD";
        else out.append(s.substr(0, length));
        s.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

int add_view(tinygltf::Model& file, std::size_t offset, std::size_t length, std::size_t stride, int target)
{
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = offset;
    view.byteLength = length;
    view.byteStride = stride;
    view.target = target;
    file.bufferViews.push_back(std::move(view));
    return static_cast<int>(file.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& file, int view, std::size_t offset, std::size_t count, int component, int type)
{
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.byteOffset = offset;
    accessor.count = count;
    accessor.componentType = component;
    accessor.type = type;
    file.accessors.push_back(std::move(accessor));
    return static_cast<int>(file.accessors.size()) - 1;
}

int add_material(tinygltf::Model& file, const std::string& name)
{
    tinygltf::Material material;
    material.name = name;
    const bool side = name == "side";
    const double face_colour[4] = {0.871, 0.138, 0.051, 1.0};  // the usual colours of picture_options, as linear light
    const double side_colour[4] = {0.617, 0.061, 0.030, 1.0};
    material.pbrMetallicRoughness.baseColorFactor.assign(side ? side_colour : face_colour,
                                                         (side ? side_colour : face_colour) + 4);
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = 0.45;
    file.materials.push_back(std::move(material));
    return static_cast<int>(file.materials.size()) - 1;
}

/// All the geometry: interleaved vertices, then the indices of every part.
void add_mesh(tinygltf::Model& file, const model& mesh, const std::string& name)
{
    constexpr std::size_t stride = sizeof(float) * 8;
    byte_writer out;
    const std::size_t vertices = mesh.vertices.size();
    out.reserve(vertices * stride + mesh.indices.size() * 4);
    std::vector<double> lowest(3), highest(3);
    for (std::size_t axis = 0; axis < 3; ++axis) lowest[axis] = highest[axis] = double{mesh.vertices[0].position[axis]};
    for (const model_vertex& v : mesh.vertices) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lowest[axis] = (std::min)(lowest[axis], double{v.position[axis]});
            highest[axis] = (std::max)(highest[axis], double{v.position[axis]});
        }
        for (const float f : v.position) out.f32(f);
        for (const float f : v.normal) out.f32(f);
        for (const float f : v.uv) out.f32(f);
    }
    const int vertex_view = add_view(file, 0, vertices * stride, stride, TINYGLTF_TARGET_ARRAY_BUFFER);
    const int position =
        add_accessor(file, vertex_view, 0, vertices, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3);
    file.accessors.back().minValues = lowest;
    file.accessors.back().maxValues = highest;
    const int normal = add_accessor(file, vertex_view, 12, vertices, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3);
    const int uv = add_accessor(file, vertex_view, 24, vertices, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2);

    const bool wide = vertices > 65535;  // the index 65535 is not allowed: it restarts a strip
    const std::size_t index_bytes = wide ? 4 : 2;
    const int index_view =
        add_view(file, vertices * stride, mesh.indices.size() * index_bytes, 0, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    for (const std::uint32_t i : mesh.indices) wide ? out.u32(i) : out.u16(i);

    tinygltf::Mesh gltf_mesh;
    gltf_mesh.name = name;
    std::vector<model::part> parts = mesh.parts;
    if (parts.empty()) parts.push_back({"text", 0, mesh.indices.size()});
    for (const model::part& part : parts) {
        if (part.index_count == 0) continue;
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.attributes = {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}};
        primitive.indices = add_accessor(
            file, index_view, part.first_index * index_bytes, part.index_count,
            wide ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR);
        primitive.material = add_material(file, part.name);
        gltf_mesh.primitives.push_back(std::move(primitive));
    }
    file.meshes.push_back(std::move(gltf_mesh));

    tinygltf::Buffer buffer;
    buffer.data = out.take();
    file.buffers.push_back(std::move(buffer));

    tinygltf::Node node;
    node.name = name;
    node.mesh = 0;
    file.nodes.push_back(std::move(node));
}

}  // namespace

std::string write_glb(const model& mesh, const std::string& path)
{
    if (std::uint64_t{mesh.vertices.size()} * 32 + std::uint64_t{mesh.indices.size()} * 4 > 2000000000)
        return path + " cannot be written: the mesh is too large for one GLB file (2 GB).";

    const std::string name = mesh.name.empty() ? std::string("text") : well_formed(mesh.name);
    tinygltf::Model file;
    file.asset.version = "2.0";
    file.asset.generator = "typemesh";
    tinygltf::Scene scene;
    scene.name = name;  // also keeps an empty scene from being written as null
    if (!mesh.indices.empty()) {
        add_mesh(file, mesh, name);
        scene.nodes.push_back(0);
    }
    file.scenes.push_back(std::move(scene));
    file.defaultScene = 0;

    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&file, stream, false, true) || !stream)
        return path + " cannot be written: the glTF library refused the mesh.";
    const std::string bytes = stream.str();
    return write_atomically(path, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

}  // namespace text_to_mesh

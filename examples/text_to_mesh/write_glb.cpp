// SPDX-License-Identifier: MIT
#include "write_glb.hpp"

#include "byte_writer.hpp"
#include "part_colours.hpp"
#include "picture/srgb.hpp"
#include "sewn.hpp"
#include "well_formed.hpp"
#include "write_png.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

namespace text_to_mesh {
namespace {

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

/// The texture of each ramp of a model, with the same number. Its bytes are behind the geometry. False if one cannot be
/// compressed.
bool add_ramps(tinygltf::Model& file, const model& mesh)
{
    for (const model::ramp& ramp : mesh.ramps) {
        std::vector<unsigned char> pixels;
        for (const rgb_colour& c : ramp.texels) pixels.insert(pixels.end(), {c.rgb[0], c.rgb[1], c.rgb[2], c.alpha});
        const auto png = png_with_alpha(pixels, static_cast<int>(ramp.texels.size()), 1);
        if (png.empty()) return false;
        std::vector<unsigned char>& bytes = file.buffers[0].data;
        bytes.resize((bytes.size() + 3) / 4 * 4);
        tinygltf::Image image;
        image.bufferView = add_view(file, bytes.size(), png.size(), 0, 0);
        image.mimeType = "image/png";
        bytes.insert(bytes.end(), png.begin(), png.end());
        file.images.push_back(std::move(image));
        tinygltf::Sampler sampler;
        sampler.minFilter = sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.wrapS = ramp.beyond == model::ramp::wrap::clamp    ? TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE
                        : ramp.beyond == model::ramp::wrap::repeat ? TINYGLTF_TEXTURE_WRAP_REPEAT
                                                                   : TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
        sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        file.samplers.push_back(sampler);
        tinygltf::Texture texture;
        texture.source = static_cast<int>(file.images.size()) - 1;
        texture.sampler = static_cast<int>(file.samplers.size()) - 1;
        file.textures.push_back(std::move(texture));
    }
    return true;
}

/// The material of a part, made if it does not exist yet. A ramp has the part's colours, which its shade multiplies.
int material_of(tinygltf::Model& file, const model& mesh, const model::part& part)
{
    const std::string name = part.ramp ? part.name + "-gradient" + std::to_string(*part.ramp) : part.name;
    for (std::size_t i = 0; i < file.materials.size(); ++i)
        if (file.materials[i].name == name) return static_cast<int>(i);
    tinygltf::Material material;
    material.name = name;
    rgb_colour own = colour_of(part);
    if (part.ramp) {
        model::part white = part;
        white.colour = rgb_colour{{255, 255, 255}};
        own = colour_of(white);
        material.pbrMetallicRoughness.baseColorTexture.index = static_cast<int>(*part.ramp);
        for (const rgb_colour& c : mesh.ramps[*part.ramp].texels) own.alpha = std::min(own.alpha, c.alpha);
        if (own.alpha < 255) material.alphaMode = "BLEND";
        own.alpha = 255;
    }
    const vec3 colour = to_linear(own.rgb);
    material.pbrMetallicRoughness.baseColorFactor = {colour.x, colour.y, colour.z, own.alpha / 255.0};
    if (own.alpha < 255) material.alphaMode = "BLEND";
    material.pbrMetallicRoughness.metallicFactor = 0.0;
    material.pbrMetallicRoughness.roughnessFactor = 0.45;
    file.materials.push_back(std::move(material));
    return static_cast<int>(file.materials.size()) - 1;
}

/// The buffer and its views: interleaved vertices, what they know of their letters, if that is wanted, then the indices,
/// each counted from its letter's first vertex.
struct geometry {
    static constexpr std::size_t stride = sizeof(float) * 8, letter_stride = sizeof(float) * 6;
    int vertex_view, letter_view, index_view;
    int merge_view;  // -1: none
    bool wide;       // indices of 32 bits
};

geometry add_geometry(tinygltf::Model& file, const model& mesh, const std::vector<model::letter>& letters,
                      const merged_indices& merged)
{
    byte_writer out;
    geometry made{};
    for (const model::letter& l : letters)
        made.wide = made.wide || l.vertex_count > 65535;  // the index 65535 is not allowed: it restarts a strip
    const std::size_t index_bytes = made.wide ? 4 : 2, vertex_bytes = mesh.vertices.size() * geometry::stride;
    out.reserve(vertex_bytes + mesh.vertex_letters.size() * geometry::letter_stride +
                mesh.indices.size() * index_bytes);
    for (const model_vertex& v : mesh.vertices) {
        for (const float f : v.position) out.f32(f);
        for (const float f : v.normal) out.f32(f);
        for (const float f : v.uv) out.f32(f);
    }
    for (const model::vertex_letter& l : mesh.vertex_letters) {
        for (const float f : {l.letter, l.word, l.line}) out.f32(f);
        for (const float f : l.pivot) out.f32(f);
    }
    for (const model::letter& l : letters) {
        if (l.again) continue;
        for (std::size_t p = l.first_part; p < l.first_part + l.part_count; ++p) {
            const model::part& part = mesh.parts[p];
            for (std::size_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
                const auto index = static_cast<std::uint32_t>(mesh.indices[i] - l.first_vertex);
                made.wide ? out.u32(index) : out.u16(index);
            }
        }
    }
    const std::size_t index_end = out.bytes().size();
    if (!merged.places.empty()) {
        while (out.bytes().size() % 4 != 0) out.u8(0);
        for (const std::uint32_t place : merged.places) out.u32(place);
        for (const std::uint32_t vertex : merged.vertices) made.wide ? out.u32(vertex) : out.u16(vertex);
    }
    made.vertex_view = add_view(file, 0, vertex_bytes, geometry::stride, TINYGLTF_TARGET_ARRAY_BUFFER);
    const std::size_t letter_bytes = mesh.vertex_letters.size() * geometry::letter_stride;
    made.letter_view = letter_bytes == 0 ? -1
                                         : add_view(file, vertex_bytes, letter_bytes, geometry::letter_stride,
                                                    TINYGLTF_TARGET_ARRAY_BUFFER);
    made.index_view = add_view(file, vertex_bytes + letter_bytes, mesh.indices.size() * index_bytes, 0,
                               TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    const std::size_t merge_bytes = merged.places.size() * (4 + index_bytes);
    made.merge_view = merge_bytes == 0 ? -1 : add_view(file, (index_end + 3) / 4 * 4, merge_bytes, 0, 0);
    tinygltf::Buffer buffer;
    buffer.data = out.take();
    file.buffers.push_back(std::move(buffer));
    return made;
}

/// A mesh of one letter, a primitive per part.
void add_mesh(tinygltf::Model& file, const model& mesh, const model::letter& l, const geometry& in)
{
    const std::size_t start = l.first_vertex * geometry::stride;
    constexpr int number = TINYGLTF_COMPONENT_TYPE_FLOAT;
    const int position = add_accessor(file, in.vertex_view, start, l.vertex_count, number, TINYGLTF_TYPE_VEC3);
    const float* const one = mesh.vertices[l.first_vertex].position;
    std::vector<double> lowest(one, one + 3), highest = lowest;
    for (std::size_t i = l.first_vertex; i < l.first_vertex + l.vertex_count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lowest[axis] = (std::min)(lowest[axis], double{mesh.vertices[i].position[axis]});
            highest[axis] = (std::max)(highest[axis], double{mesh.vertices[i].position[axis]});
        }
    }
    file.accessors.back().minValues = lowest;
    file.accessors.back().maxValues = highest;
    const int normal = add_accessor(file, in.vertex_view, start + 12, l.vertex_count, number, TINYGLTF_TYPE_VEC3);
    const int uv = add_accessor(file, in.vertex_view, start + 24, l.vertex_count, number, TINYGLTF_TYPE_VEC2);

    std::map<std::string, int> attributes{{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}};
    if (in.letter_view >= 0) {
        const std::size_t from = l.first_vertex * geometry::letter_stride;
        const auto add = [&](const char* name, std::size_t offset, int type) {
            attributes[name] = add_accessor(file, in.letter_view, from + offset, l.vertex_count, number, type);
        };
        add("_LETTER", 0, TINYGLTF_TYPE_SCALAR);
        add("_WORD", 4, TINYGLTF_TYPE_SCALAR);
        add("_LINE", 8, TINYGLTF_TYPE_SCALAR);
        add("_PIVOT", 12, TINYGLTF_TYPE_VEC3);
    }

    tinygltf::Mesh made;
    made.name = well_formed(l.name);
    for (std::size_t p = l.first_part; p < l.first_part + l.part_count; ++p) {
        const model::part& part = mesh.parts[p];
        if (part.index_count == 0) continue;
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.attributes = attributes;
        primitive.indices =
            add_accessor(file, in.index_view, part.first_index * (in.wide ? 4 : 2), part.index_count,
                         in.wide ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                         TINYGLTF_TYPE_SCALAR);
        primitive.material = material_of(file, mesh, part);
        made.primitives.push_back(std::move(primitive));
    }
    file.meshes.push_back(std::move(made));
}

/// Says that the one mesh of a file is a 2-manifold.
/// https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Vendor/EXT_mesh_manifold
void add_manifold(tinygltf::Model& file, const model& mesh, const geometry& in, const merged_indices& merged)
{
    const auto number = [](int n) { return tinygltf::Value{n}; };
    const int component = in.wide ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const std::size_t count = merged.places.size();
    tinygltf::Value::Object extension;
    if (count != 0) {
        extension["mergeIndices"] = number(
            add_accessor(file, in.merge_view, 0, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR));
        extension["mergeValues"] =
            number(add_accessor(file, in.merge_view, 4 * count, count, component, TINYGLTF_TYPE_SCALAR));
    }
    const int indices = add_accessor(file, in.index_view, 0, mesh.indices.size(), component, TINYGLTF_TYPE_SCALAR);
    if (count != 0) {
        auto& sparse = file.accessors.back().sparse;
        sparse.isSparse = true;
        sparse.count = static_cast<int>(count);
        sparse.indices.bufferView = sparse.values.bufferView = in.merge_view;
        sparse.indices.byteOffset = 0;
        sparse.indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        sparse.values.byteOffset = static_cast<int>(4 * count);
    }
    const int position = file.meshes[0].primitives[0].attributes.at("POSITION");
    extension["manifoldPrimitive"] = tinygltf::Value{tinygltf::Value::Object{
        {"mode", number(TINYGLTF_MODE_TRIANGLES)},
        {"indices", number(indices)},
        {"attributes", tinygltf::Value{tinygltf::Value::Object{{"POSITION", number(position)}}}}}};
    file.meshes[0].extensions["EXT_mesh_manifold"] = tinygltf::Value{std::move(extension)};
    file.extensionsUsed.emplace_back("EXT_mesh_manifold");
}

/// What a node keeps of the text.
tinygltf::Value text_of(const std::string& text)
{
    return tinygltf::Value{tinygltf::Value::Object{{"text", tinygltf::Value{well_formed(text)}}}};
}

/// What a node keeps of the letter that it places.
tinygltf::Value facts_of(const model::place& p)
{
    tinygltf::Value::Object facts;
    if (!p.text.empty()) facts["text"] = tinygltf::Value{well_formed(p.text)};
    if (p.numbers) {
        constexpr const char* names[] = {"letter", "word", "line"};
        for (std::size_t i = 0; i < 3; ++i) facts[names[i]] = tinygltf::Value{static_cast<int>((*p.numbers)[i])};
    }
    return facts.empty() ? tinygltf::Value{} : tinygltf::Value{std::move(facts)};
}

/// What the node of a whole text keeps of it.
tinygltf::Value facts_of(const model& mesh)
{
    tinygltf::Value::Object facts{{"text", tinygltf::Value{well_formed(mesh.name)}}};
    if (!mesh.letter_texts.empty()) {
        tinygltf::Value::Array letters;
        for (const std::string& one : mesh.letter_texts) letters.emplace_back(well_formed(one));
        facts["letters"] = tinygltf::Value{std::move(letters)};
    }
    return tinygltf::Value{std::move(facts)};
}

/// A node of the text's name with a node for each place under it, named after its letter and counted.
void add_places(tinygltf::Model& file, const model& mesh, const std::string& name)
{
    tinygltf::Node root;
    root.name = name;
    root.extras = text_of(mesh.name);
    for (std::size_t i = 0; i < mesh.places.size(); ++i) root.children.push_back(static_cast<int>(i) + 1);
    file.nodes.push_back(std::move(root));
    for (const model::place& p : mesh.places) {
        tinygltf::Node node;
        node.name = well_formed(mesh.letters[p.letter].name) + "_" + std::to_string(file.nodes.size());
        node.extras = facts_of(p);
        node.mesh = static_cast<int>(p.letter);
        node.translation = {double{p.at[0]}, double{p.at[1]}, double{p.at[2]}};
        if (p.right[1] != 0.0f || p.right[0] < 0.0f) {
            const double half = 0.5 * std::atan2(double{p.right[1]}, double{p.right[0]});
            node.rotation = {0.0, 0.0, std::sin(half), std::cos(half)};
        }
        file.nodes.push_back(std::move(node));
    }
}

/// A node for each level of detail: only the first one, the finest, is in the scene, and it names the others.
/// https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Vendor/MSFT_lod
void add_levels(tinygltf::Model& file, const model& mesh)
{
    tinygltf::Value::Array coarser;
    for (std::size_t k = 0; k < mesh.letters.size(); ++k) {
        tinygltf::Node node;
        node.name = well_formed(mesh.letters[k].name);
        node.mesh = static_cast<int>(k);
        if (k != 0) coarser.emplace_back(static_cast<int>(k));
        file.nodes.push_back(std::move(node));
    }
    file.nodes[0].extras = text_of(mesh.name);
    file.nodes[0].extensions["MSFT_lod"] =
        tinygltf::Value{tinygltf::Value::Object{{"ids", tinygltf::Value{std::move(coarser)}}}};
    file.extensionsUsed.emplace_back("MSFT_lod");
}

/// False if a ramp cannot be compressed.
bool add_scene(tinygltf::Model& file, const model& mesh, const std::string& name,
               const std::optional<merged_indices>& merged)
{
    std::vector<model::letter> letters = mesh.letters;
    if (letters.empty()) letters.push_back({name, 0, mesh.vertices.size(), 0, mesh.parts.size()});
    const geometry made = add_geometry(file, mesh, letters, merged.value_or(merged_indices{}));
    if (!add_ramps(file, mesh)) return false;
    for (const model::letter& l : letters) add_mesh(file, mesh, l, made);
    if (merged) add_manifold(file, mesh, made, *merged);
    if (mesh.has_levels) {
        add_levels(file, mesh);
        return true;
    }
    if (!mesh.letters.empty()) {
        add_places(file, mesh, name);
        return true;
    }
    tinygltf::Node node;
    node.name = name;
    node.extras = facts_of(mesh);
    node.mesh = 0;
    file.nodes.push_back(std::move(node));
    return true;
}

}  // namespace

std::string write_glb(const model& mesh, const std::string& path, file_set& files)
{
    if (std::uint64_t{mesh.vertices.size()} * 32 + std::uint64_t{mesh.indices.size()} * 4 > 2000000000)
        return path + " cannot be written: the mesh is too large for one GLB file (2 GB).";

    if (mesh.parts.empty() && !mesh.indices.empty()) {
        model whole = mesh;
        whole.parts.push_back({"text", 0, mesh.indices.size()});
        return write_glb(whole, path, files);
    }

    std::optional<merged_indices> merged;
    if (mesh.as_manifold && !mesh.indices.empty() && !(merged = manifold_of(mesh)))
        return path + " cannot be written with --manifold: the mesh is not closed, or solids touch in it.";

    const std::string name = mesh.name.empty() ? std::string("text") : well_formed(mesh.name);
    tinygltf::Model file;
    file.asset.version = "2.0";
    file.asset.generator = "typemesh";
    tinygltf::Scene scene;
    scene.name = name;  // also keeps an empty scene from being written as null
    if (!mesh.indices.empty()) {
        if (!add_scene(file, mesh, name, merged))
            return path + " cannot be written: there is no memory to compress a gradient.";
        scene.nodes.push_back(0);
    }
    file.scenes.push_back(std::move(scene));
    file.defaultScene = 0;

    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&file, stream, false, true) || !stream)
        return path + " cannot be written: the glTF library refused the mesh.";
    const std::string bytes = stream.str();
    return files.add(path, {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

}  // namespace text_to_mesh

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/sewn.hpp"
#include "text_to_mesh/write_glb.hpp"

#include "extruded_ring.hpp"
#include "scratch_folder.hpp"
#include "written_alone.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace text_to_mesh;

namespace {

tinygltf::Model reread(const std::string& path)
{
    tinygltf::TinyGLTF reader;
    tinygltf::Model file;
    std::string trouble, warning;
    CHECK(reader.LoadBinaryFromFile(&file, &trouble, &warning, path));
    CHECK(trouble == "");
    CHECK(warning == "");
    return file;
}

std::vector<std::uint32_t> indices_of(const tinygltf::Model& file)
{
    std::vector<std::uint32_t> all;
    for (const tinygltf::Primitive& p : file.meshes.at(0).primitives) {
        const tinygltf::Accessor& a = file.accessors.at(static_cast<std::size_t>(p.indices));
        const tinygltf::BufferView& v = file.bufferViews.at(static_cast<std::size_t>(a.bufferView));
        const unsigned char* at = file.buffers[0].data.data() + v.byteOffset + a.byteOffset;
        const bool wide = a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        for (std::size_t i = 0; i < a.count; ++i, at += wide ? 4 : 2)
            all.push_back(wide ? at[0] | std::uint32_t{at[1]} << 8 | std::uint32_t{at[2]} << 16 |
                                     std::uint32_t{at[3]} << 24
                               : at[0] | std::uint32_t{at[1]} << 8);
    }
    return all;
}

}  // namespace

TEST_CASE("a GLB read again holds the same vertices, indices, parts and bounds", "[write_glb]")
{
    const std::uint32_t steps = GENERATE(24u, 4095u, 4096u);  // 16 vertices a step: 65520 take 16 bits, 65536 do not
    scratch_folder folder;
    const model ring = extruded_ring(steps);
    REQUIRE(written_alone(write_glb, ring, folder.file("ring.glb")) == "");
    const tinygltf::Model file = reread(folder.file("ring.glb"));

    CHECK(file.asset.generator == "typemesh");
    REQUIRE(file.meshes.size() == 1);
    REQUIRE(file.meshes[0].primitives.size() == 3);
    CHECK(file.materials[static_cast<std::size_t>(file.meshes[0].primitives[2].material)].name == "side");
    CHECK(indices_of(file) == ring.indices);
    const tinygltf::Accessor& index = file.accessors[static_cast<std::size_t>(file.meshes[0].primitives[0].indices)];
    CHECK(index.componentType ==
          (steps < 4096 ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT));

    const auto& attributes = file.meshes[0].primitives[0].attributes;
    REQUIRE(attributes.size() == 3);
    const tinygltf::Accessor& position = file.accessors[static_cast<std::size_t>(attributes.at("POSITION"))];
    REQUIRE(position.count == ring.vertices.size());
    CHECK(std::memcmp(file.buffers[0].data.data(), ring.vertices.data(), ring.vertices.size() * sizeof(model_vertex)) ==
          0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto less = [axis](const model_vertex& a, const model_vertex& b) {
            return a.position[axis] < b.position[axis];
        };
        const auto bounds = std::minmax_element(ring.vertices.begin(), ring.vertices.end(), less);
        CHECK(position.minValues[axis] == double{bounds.first->position[axis]});
        CHECK(position.maxValues[axis] == double{bounds.second->position[axis]});
    }
}

TEST_CASE("an empty model gives a GLB with an empty scene", "[write_glb]")
{
    scratch_folder folder;
    REQUIRE(written_alone(write_glb, model{}, folder.file("empty.glb")) == "");
    const tinygltf::Model file = reread(folder.file("empty.glb"));
    CHECK(file.scenes.size() == 1);
    CHECK(file.scenes[0].nodes.empty());
    CHECK(file.meshes.empty());
    CHECK(file.buffers.empty());
}

TEST_CASE("a name that is not UTF-8 is written with replacement characters", "[write_glb]")
{
    scratch_folder folder;
    model ring = extruded_ring(3);
    ring.name = "a\x80\xC3\xA9\xED\xA0\x80\xF4\x90\x80\x80\xE0\x9F\xBF\xC3";
    REQUIRE(written_alone(write_glb, ring, folder.file("name.glb")) == "");
    const std::string r = "\xEF\xBF\xBD";
    CHECK(reread(folder.file("name.glb")).meshes[0].name ==
          "a" + r + "\xC3\xA9" + r + r + r + r + r + r + r + r + r + r + r);
}

TEST_CASE("a model without parts is one primitive, and a part without triangles is none", "[write_glb]")
{
    scratch_folder folder;
    model ring = extruded_ring(3);
    ring.parts.clear();
    REQUIRE(written_alone(write_glb, ring, folder.file("whole.glb")) == "");
    CHECK(indices_of(reread(folder.file("whole.glb"))) == ring.indices);
    ring.parts = {{"front", 0, ring.indices.size()}, {"back", ring.indices.size(), 0}};
    REQUIRE(written_alone(write_glb, ring, folder.file("front.glb")) == "");
    CHECK(reread(folder.file("front.glb")).meshes[0].primitives.size() == 1);
}

TEST_CASE("the letters of an instanced model are meshes, and their places nodes under one", "[write_glb]")
{
    scratch_folder folder;
    model two = extruded_ring(4), more = extruded_ring(6);
    const std::size_t first = two.vertices.size(), first_index = two.indices.size();
    for (const std::uint32_t i : more.indices) two.indices.push_back(i + static_cast<std::uint32_t>(first));
    two.vertices.insert(two.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const model::part& p : more.parts) two.parts.push_back({p.name, p.first_index + first_index, p.index_count});
    two.letters = {{"O", 0, first, 0, 3}, {"Q", first, more.vertices.size(), 3, 3}};
    two.places = {{1, {0.5F, 0.0F, 0.0F}, "Q"}, {0, {1.5F, 2.0F, 0.0F}, "\xFF"}, {1, {2.5F, 0.0F, -1.0F}}};
    two.name = "QO\nQ";
    REQUIRE(written_alone(write_glb, two, folder.file("two.glb")) == "");

    const tinygltf::Model file = reread(folder.file("two.glb"));
    REQUIRE(file.meshes.size() == 2);
    CHECK(file.meshes[0].name == "O");
    CHECK(file.meshes[1].name == "Q");
    CHECK(file.materials.size() == 3);  // shared
    REQUIRE(file.scenes[0].nodes.size() == 1);
    const std::vector<int>& nodes = file.nodes[static_cast<std::size_t>(file.scenes[0].nodes[0])].children;
    REQUIRE(nodes.size() == 3);
    CHECK(file.nodes[static_cast<std::size_t>(file.scenes[0].nodes[0])].extras.Get("text").Get<std::string>() ==
          "QO\nQ");
    for (std::size_t i = 0; i < 3; ++i) {
        const tinygltf::Node& node = file.nodes[static_cast<std::size_t>(nodes[i])];
        CHECK(node.mesh == static_cast<int>(two.places[i].letter));
        CHECK(node.translation == std::vector<double>(two.places[i].at, two.places[i].at + 3));
        CHECK(node.name == two.letters[two.places[i].letter].name + "_" + std::to_string(i + 1));
        CHECK(node.extras.Has("text") == (i < 2));
        if (i < 2) CHECK(node.extras.Get("text").Get<std::string>() == (i == 0 ? "Q" : "\xEF\xBF\xBD"));
    }
    for (std::size_t m = 0; m < 2; ++m) {  // each letter's indices count from its own first vertex
        const tinygltf::Primitive& p = file.meshes[m].primitives[2];
        const tinygltf::Accessor& position = file.accessors[static_cast<std::size_t>(p.attributes.at("POSITION"))];
        CHECK(position.count == two.letters[m].vertex_count);
        CHECK(position.byteOffset == two.letters[m].first_vertex * sizeof(model_vertex));
        const tinygltf::Accessor& index = file.accessors[static_cast<std::size_t>(p.indices)];
        const unsigned char* at = file.buffers[0].data.data() +
                                  file.bufferViews[static_cast<std::size_t>(index.bufferView)].byteOffset +
                                  index.byteOffset;
        const model& own = m == 0 ? extruded_ring(4) : more;
        bool same = index.count == own.parts[2].index_count;
        for (std::size_t i = 0; i < index.count && same; ++i)
            same = (at[2 * i] | std::uint32_t{at[2 * i + 1]} << 8) == own.indices[own.parts[2].first_index + i];
        CHECK(same);
    }
}

TEST_CASE("a letter in two colours is two meshes over the same vertices and indices", "[write_glb]")
{
    scratch_folder folder;
    model o = extruded_ring(4);
    const std::size_t parts = o.parts.size();
    for (std::size_t p = 0; p < parts; ++p) {
        model::part red = o.parts[p];
        red.colour = rgb_colour{{208, 40, 44}};
        red.name += "_red";
        CHECK(red.kind() == o.parts[p].name);
        o.parts.push_back(red);
    }
    o.letters = {{"o", 0, o.vertices.size(), 0, parts}, {"o", 0, o.vertices.size(), parts, parts, true}};
    o.places = {{0, {0.0F, 0.0F, 0.0F}}, {1, {1.0F, 0.0F, 0.0F}}};
    REQUIRE(written_alone(write_glb, o, folder.file("o.glb")) == "");

    const tinygltf::Model file = reread(folder.file("o.glb"));
    REQUIRE(file.meshes.size() == 2);
    CHECK(file.materials.size() == 2 * parts);
    CHECK(file.buffers[0].data.size() == o.vertices.size() * 32 + o.indices.size() * 2);
    for (std::size_t p = 0; p < parts; ++p) {
        const tinygltf::Primitive &a = file.meshes[0].primitives[p], &b = file.meshes[1].primitives[p];
        const auto begin = [&](int accessor) { return file.accessors[static_cast<std::size_t>(accessor)].byteOffset; };
        CHECK(begin(a.indices) == begin(b.indices));
        CHECK(begin(a.attributes.at("POSITION")) == begin(b.attributes.at("POSITION")));
        CHECK(file.materials[static_cast<std::size_t>(b.material)].name ==
              file.materials[static_cast<std::size_t>(a.material)].name + "_red");
    }
}

TEST_CASE("vertices of a GLB hold their letter, word, line and pivot in types that glTF allows", "[write_glb]")
{
    scratch_folder folder;
    model ring = extruded_ring(5);  // an odd number of 16-bit indices would put what follows them at an odd place
    ring.name = "ab";
    ring.letter_texts = {"a", "\xFF"};
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
        const auto n = static_cast<float>(i);
        ring.vertex_letters.push_back({i % 7 == 0 ? -1.0F : n, n + 0.5F, 16777216.0F - n, {n, 2.0F * n, -n}});
    }
    REQUIRE(written_alone(write_glb, ring, folder.file("letters.glb")) == "");
    const tinygltf::Model file = reread(folder.file("letters.glb"));
    CHECK(indices_of(file) == ring.indices);
    const std::size_t offsets[] = {0, 1, 2, 3};
    const char* names[] = {"_LETTER", "_WORD", "_LINE", "_PIVOT"};
    for (const tinygltf::Primitive& primitive : file.meshes.at(0).primitives) {
        for (std::size_t k = 0; k < 4; ++k) {
            const tinygltf::Accessor& a =
                file.accessors.at(static_cast<std::size_t>(primitive.attributes.at(names[k])));
            const tinygltf::BufferView& v = file.bufferViews.at(static_cast<std::size_t>(a.bufferView));
            CHECK(a.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT);
            CHECK(a.type == (k < 3 ? TINYGLTF_TYPE_SCALAR : TINYGLTF_TYPE_VEC3));
            REQUIRE(a.count == ring.vertices.size());
            const std::size_t width = k < 3 ? 1 : 3;
            bool same = true;
            for (std::size_t i = 0; i < a.count; ++i) {
                float read[3];
                std::memcpy(read, file.buffers[0].data.data() + v.byteOffset + a.byteOffset + i * v.byteStride,
                            width * sizeof(float));
                const auto* const wanted = reinterpret_cast<const float*>(&ring.vertex_letters[i]) + offsets[k];
                same = same && std::memcmp(read, wanted, width * sizeof(float)) == 0;
            }
            CHECK(same);
        }
    }
    const tinygltf::Value& texts = file.nodes.at(0).extras.Get("letters");
    REQUIRE(texts.ArrayLen() == 2);
    CHECK(texts.Get(0).Get<std::string>() == "a");
    CHECK(texts.Get(1).Get<std::string>() == "\xEF\xBF\xBD");
}

TEST_CASE("the node of a letter has its numbers, that of a bar none", "[write_glb]")
{
    scratch_folder folder;
    model o = extruded_ring(4);
    o.letters = {{"o", 0, o.vertices.size(), 0, o.parts.size()}};
    o.places = {{0, {0.0F, 0.0F, 0.0F}, "o"}, {0, {1.0F, 0.0F, 0.0F}}};
    o.places[0].numbers = {{7, 3, 1}};
    REQUIRE(written_alone(write_glb, o, folder.file("o.glb")) == "");
    const tinygltf::Model file = reread(folder.file("o.glb"));
    const tinygltf::Value& facts = file.nodes.at(1).extras;
    CHECK(facts.Get("letter").GetNumberAsInt() == 7);
    CHECK(facts.Get("word").GetNumberAsInt() == 3);
    CHECK(facts.Get("line").GetNumberAsInt() == 1);
    CHECK_FALSE(file.nodes.at(2).extras.Has("letter"));
}

TEST_CASE("a GLB that is a manifold says which indices become others", "[write_glb]")
{
    const std::uint32_t steps = GENERATE(24u, 4096u);
    scratch_folder folder;
    model ring = extruded_ring(steps);
    ring.as_manifold = true;
    REQUIRE(written_alone(write_glb, ring, folder.file("ring.glb")) == "");
    const tinygltf::Model file = reread(folder.file("ring.glb"));
    CHECK(file.extensionsUsed == std::vector<std::string>{"EXT_mesh_manifold"});
    CHECK(indices_of(file) == ring.indices);
    const tinygltf::Value& extension = file.meshes[0].extensions.at("EXT_mesh_manifold");
    const auto accessor = [&](const tinygltf::Value& number) {
        return file.accessors.at(static_cast<std::size_t>(number.GetNumberAsInt()));
    };
    const tinygltf::Value& primitive = extension.Get("manifoldPrimitive");
    CHECK(primitive.Get("attributes").Get("POSITION").GetNumberAsInt() ==
          file.meshes[0].primitives[0].attributes.at("POSITION"));
    const tinygltf::Accessor whole = accessor(primitive.Get("indices")),
                             places = accessor(extension.Get("mergeIndices")),
                             vertices = accessor(extension.Get("mergeValues"));
    CHECK(whole.count == ring.indices.size());
    REQUIRE(whole.sparse.isSparse);
    CHECK(whole.bufferView ==
          file.accessors.at(static_cast<std::size_t>(file.meshes[0].primitives[0].indices)).bufferView);
    CHECK(static_cast<std::size_t>(whole.sparse.count) == places.count);
    CHECK(places.count == vertices.count);
    CHECK(places.count > 0);
    CHECK(whole.sparse.indices.bufferView == places.bufferView);
    CHECK(static_cast<std::size_t>(whole.sparse.values.byteOffset) == vertices.byteOffset);
    // As any reader applies it, it is a 2-manifold, and nothing has moved.
    const auto merged = manifold_of(ring);
    REQUIRE(merged);
    const unsigned char* const bytes =
        file.buffers[0].data.data() + file.bufferViews.at(static_cast<std::size_t>(places.bufferView)).byteOffset;
    std::vector<std::uint32_t> indices = ring.indices;
    for (std::size_t i = 0; i < places.count; ++i) {
        std::uint32_t place = 0, vertex = 0;
        for (int k = 3; k >= 0; --k) place = place << 8 | bytes[4 * i + static_cast<std::size_t>(k)];
        const std::size_t size = steps == 24 ? 2 : 4;
        for (std::size_t k = size; k-- > 0;) vertex = vertex << 8 | bytes[vertices.byteOffset + size * i + k];
        const bool is_same = place == merged->places[i] && vertex == merged->vertices[i];
        if (!is_same) REQUIRE(is_same);  // once, where it fails
        const auto &from = ring.vertices[indices[place]].position, &to = ring.vertices[vertex].position;
        const bool stays = std::equal(std::begin(from), std::end(from), std::begin(to));
        if (!stays) REQUIRE(stays);
        indices[place] = vertex;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, reversed;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint32_t a = indices[i], b = indices[i % 3 == 2 ? i - 2 : i + 1];
        edges.emplace_back(a, b);
        reversed.emplace_back(b, a);
    }
    std::sort(edges.begin(), edges.end());
    std::sort(reversed.begin(), reversed.end());
    CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
    CHECK(edges == reversed);

    ring.indices.resize(ring.indices.size() - 3);
    ring.parts.back().index_count -= 3;
    CHECK(written_alone(write_glb, ring, folder.file("open.glb")).find("--manifold") != std::string::npos);
}

TEST_CASE("a gradient is a texture of one row, which its parts share", "[write_glb]")
{
    scratch_folder folder;
    model ring = extruded_ring(4);
    ring.ramps.push_back({{{{255, 0, 0}}, {{0, 0, 255}, 128}}, model::ramp::wrap::mirror});
    for (model::part& p : ring.parts) {
        p.colour = rgb_colour{{128, 0, 128}};
        p.name += "_800080";
        p.ramp = 0;
    }
    REQUIRE(written_alone(write_glb, ring, folder.file("ramp.glb")) == "");
    std::ifstream in{folder.file("ramp.glb"), std::ios::binary};
    const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
    const auto count = [&bytes](const std::string& what) {
        std::size_t n = 0;
        for (auto at = bytes.find(what); at != std::string::npos; at = bytes.find(what, at + 1)) ++n;
        return n;
    };
    CHECK(count("\x89PNG") == 1);
    CHECK(count("\"image/png\"") == 1);
    CHECK(count("\"wrapS\":33648") == 1);  // mirrored
    CHECK(count("\"baseColorTexture\"") == 3);
    CHECK(count("\"alphaMode\":\"BLEND\"") == 3);
    CHECK(count("-gradient0\"") == 3);

    ring.ramps[0].texels.clear();  // as without memory, nothing can be compressed
    CHECK(written_alone(write_glb, ring, folder.file("none.glb")) ==
          folder.file("none.glb") + " cannot be written: there is no memory to compress a gradient.");
    CHECK_FALSE(std::filesystem::exists(folder.file("none.glb")));
}

// SPDX-License-Identifier: MIT

#include "engines/gltf.hpp"
#include "engines/three.hpp"

#include <typemesh/extrude/flat.hpp>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "recipe_laws.hpp"

using namespace recipes;

namespace {

std::uint32_t word_at(const std::vector<std::byte>& file, std::size_t at)
{
    std::uint32_t v = 0;
    for (std::size_t k = 0; k < 4; ++k) v |= std::to_integer<std::uint32_t>(file.at(at + k)) << (8 * k);
    return v;
}

/// The numbers after a name in a GLB's JSON: "min":[1,2,3].
std::vector<double> numbers_after(const std::string& json, const std::string& name)
{
    const std::size_t at = json.find("\"" + name + "\":");
    REQUIRE(at != std::string::npos);
    const char* p = json.c_str() + at + name.size() + 3;
    std::vector<double> out;
    const bool list = *p == '[';
    if (list) ++p;
    for (;;) {
        char* end = nullptr;
        out.push_back(std::strtod(p, &end));
        REQUIRE(end != p);
        if (!list || *end != ',') break;
        p = end + 1;
    }
    return out;
}

/// What stands behind each occurrence of some words, up to the next comma or bracket.
std::vector<std::string> all_after(const std::string& json, const std::string& words)
{
    std::vector<std::string> out;
    for (std::size_t at = json.find(words); at != std::string::npos; at = json.find(words, at)) {
        at += words.size();
        out.push_back(json.substr(at, json.find_first_of(",}]", at) - at));
    }
    return out;
}

std::vector<std::string> quoted(std::vector<std::string> words)
{
    for (std::string& w : words) w = "\"" + w + "\"";
    return words;
}

struct glb {
    std::string json;
    std::vector<std::byte> bin;
};

glb open(const std::vector<std::byte>& file)
{
    REQUIRE(word_at(file, 0) == 0x46546C67);
    REQUIRE(word_at(file, 4) == 2);
    REQUIRE(word_at(file, 8) == file.size());
    const std::size_t json = word_at(file, 12);
    REQUIRE(json % 4 == 0);
    REQUIRE(word_at(file, 16) == 0x4E4F534A);
    glb g;
    g.json.assign(reinterpret_cast<const char*>(file.data()) + 20, json);
    if (20 + json == file.size()) return g;
    REQUIRE(word_at(file, 20 + json) % 4 == 0);
    REQUIRE(word_at(file, 24 + json) == 0x004E4942);
    g.bin.assign(file.begin() + static_cast<std::ptrdiff_t>(28 + json), file.end());
    REQUIRE(g.bin.size() == word_at(file, 20 + json));
    return g;
}

template <class Plan>
glb written(const Plan& plan, engines::gltf::layout how)
{
    std::vector<std::byte> file;
    REQUIRE(engines::gltf::write(plan, how, file));
    return open(file);
}

/// The 16-bit indices of a plan's file, after its vertices.
template <class Plan>
std::vector<std::uint32_t> indices_in(const glb& g, const Plan& plan, std::size_t bytes_a_vertex)
{
    std::vector<std::uint16_t> narrow(plan.size().indices());
    std::memcpy(narrow.data(), g.bin.data() + bytes_a_vertex * plan.size().vertices, 2 * narrow.size());
    return {narrow.begin(), narrow.end()};
}

struct letter_node {
    std::vector<double> offset, scale;
};

/// The nodes of a quantised file that have a mesh.
std::vector<letter_node> letter_nodes(const std::string& json)
{
    std::vector<letter_node> nodes;
    for (std::size_t at = json.find("\"translation\":"); at != std::string::npos;
         at = json.find("\"translation\":", at + 1))
        nodes.push_back({numbers_after(json.substr(at), "translation"), numbers_after(json.substr(at), "scale")});
    return nodes;
}

}  // namespace

TEMPLATE_TEST_CASE("three.js gets one typed array per attribute, counter-clockwise triangles and upward v", "[engines]",
                   bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::three::options());
    const std::size_t n = plan.size().vertices;
    std::vector<float> position(3 * n), normal(3 * n), tangent(4 * n), uv(2 * n);
    std::vector<std::uint32_t> index(plan.size().indices());
    REQUIRE(engines::three::write(plan, engines::three::buffer_geometry<>{position, normal, tangent, uv, index}));
    seen mesh;
    for (std::size_t i = 0; i < n; ++i)
        mesh.add({position[3 * i], position[3 * i + 1], position[3 * i + 2]}, &normal[3 * i], &tangent[4 * i],
                 &uv[2 * i]);
    mesh.index = index;
    obeys(mesh, plan, opengl);

    std::vector<std::uint16_t> narrow(index.size());
    REQUIRE(engines::three::write(
        plan, engines::three::buffer_geometry<std::uint16_t>{position, normal, tangent, uv, narrow}));
    CHECK(std::vector<std::uint32_t>(narrow.begin(), narrow.end()) == index);
    std::vector<float> short_uv(2 * n - 1, -7.0f);
    const error e =
        engines::three::write(plan, engines::three::buffer_geometry<>{position, normal, tangent, short_uv, index})
            .error();
    CHECK(e == error::buffer_too_small);
    CHECK(e.count == n);
    CHECK(short_uv == std::vector<float>(2 * n - 1, -7.0f));
}

TEMPLATE_TEST_CASE("a plain glTF file contains right-handed floats, counter-clockwise triangles and downward v",
                   "[engines]", bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::gltf::options());
    const glb g = written(plan, engines::gltf::layout::plain);
    seen mesh;
    for (std::size_t i = 0; i < plan.size().vertices; ++i) {
        float f[12];
        std::memcpy(f, g.bin.data() + 48 * i, sizeof f);
        mesh.add({f[0], f[1], f[2]}, f + 3, f + 6, f + 10);
    }
    mesh.index = indices_in(g, plan, 48);
    obeys(mesh, plan, gltf);
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (const vec3 p : mesh.position) {
        const double at[3] = {p.x, p.y, p.z};
        for (std::size_t k = 0; k < 3; ++k) low[k] = (std::min)(low[k], at[k]), high[k] = (std::max)(high[k], at[k]);
    }
    const auto file_low = numbers_after(g.json, "min"), file_high = numbers_after(g.json, "max");
    for (std::size_t k = 0; k < 3; ++k) {  // the same floats
        CHECK(static_cast<float>(file_low.at(k)) == static_cast<float>(low[k]));
        CHECK(static_cast<float>(file_high.at(k)) == static_cast<float>(high[k]));
    }
    CHECK(numbers_after(g.json, "byteStride")[0] == 48);
}

TEMPLATE_TEST_CASE("a quantised glTF file contains the same mesh in 20 bytes per vertex, through its nodes' transforms",
                   "[engines]", bench, bevelled_bench)
{
    TestType b;
    const auto plan = planned(b, engines::gltf::options());
    const glb g = written(plan, engines::gltf::layout::quantised);
    CHECK(g.json.find("extensionsRequired\":[\"KHR_mesh_quantization\"]") != std::string::npos);
    const auto nodes = letter_nodes(g.json);
    REQUIRE(nodes.size() == plan.glyphs().size());
    std::vector<std::size_t> letter_of(plan.size().vertices);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        REQUIRE(nodes[i].scale[0] == nodes[i].scale[1]);
        REQUIRE(nodes[i].scale[0] == nodes[i].scale[2]);
        for (const part where : plan.parts()) {
            const mesh_range range = plan.range(i, where);
            for (std::uint32_t k = 0; k < range.vertex_count; ++k) letter_of.at(range.first_vertex + k) = i;
        }
    }
    const std::string transform = g.json.substr(g.json.find("\"KHR_texture_transform\":{"));
    const auto uv_offset = numbers_after(transform, "offset"), uv_scale = numbers_after(transform, "scale");
    seen mesh;
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1, -1, -1};
    for (std::size_t i = 0; i < plan.size().vertices; ++i) {
        struct {
            std::uint16_t position[4];
            std::int8_t normal[4], tangent[4];
            std::uint16_t uv[2];
        } v;
        static_assert(sizeof v == 20);
        std::memcpy(&v, g.bin.data() + 20 * i, 20);
        float p[3];
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = (std::min)(low[k], double(v.position[k])), high[k] = (std::max)(high[k], double(v.position[k]));
            const letter_node& node = nodes[letter_of[i]];
            p[k] = static_cast<float>(v.position[k] / 65535.0 * node.scale[k] + node.offset[k]);
        }
        const auto d = [](std::int8_t n) { return static_cast<float>(n) / 127.0f; };
        mesh.position.push_back({p[0], p[1], p[2]});
        mesh.normal.push_back({d(v.normal[0]), d(v.normal[1]), d(v.normal[2])});
        mesh.tangent.push_back({d(v.tangent[0]), d(v.tangent[1]), d(v.tangent[2]), d(v.tangent[3])});
        mesh.uv.push_back({static_cast<float>(uv_offset.at(0) + uv_scale.at(0) * v.uv[0] / 65535.0),
                           static_cast<float>(uv_offset.at(1) + uv_scale.at(1) * v.uv[1] / 65535.0)});
        CHECK(v.position[3] == 0);
        CHECK(v.normal[3] == 0);
    }
    mesh.index = indices_in(g, plan, 20);
    CHECK(numbers_after(g.json, "min") == std::vector<double>(low, low + 3));
    CHECK(numbers_after(g.json, "max") == std::vector<double>(high, high + 3));
    engine is = gltf;
    is.off_position = 1e-5;  // half a step of the longest side, less than 1.3 em
    is.off_direction = 0.01;
    is.off_uv = 1e-4;  // half a step of the longest contour, below 8 em
    obeys(mesh, plan, is);
    if (const char* folder = std::getenv("TYPEMESH_KEEP_GLB")) {  // for gltf-validator
        for (const auto how : {engines::gltf::layout::plain, engines::gltf::layout::quantised}) {
            std::vector<std::byte> file;
            REQUIRE(engines::gltf::write(plan, how, file));
            std::ofstream{std::string{folder} + (how == engines::gltf::layout::plain ? "/plain.glb" : "/quantised.glb"),
                          std::ios::binary}
                .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
        }
    }
}

TEST_CASE("one box per letter turns over a tenth of the triangles that one box for all does, and both are counted",
          "[engines]")
{
    bench b;
    const std::string line =
        "Sphinx of black quartz, judge my vow & quick @ the lazy dogs; Sphinx of black quartz, judge my vow & quick";
    std::uint64_t by_line = 0, by_letter = 0;
    for (const double tolerance : {quality::normal, quality::high, quality::best}) {
        auto options = engines::gltf::options();
        options.tolerance = tolerance;
        const auto plan = planned(b, options, line);
        const position_box one = position_box::cube_around(plan.bounds().low, plan.bounds().high);
        const glb g = written(plan, engines::gltf::layout::quantised);
        const auto turns = [&](const auto& corner, triangle t) {
            return orientation(corner(t.a), corner(t.b), corner(t.c)) <= 0 ? 1u : 0u;
        };
        std::uint64_t in_file = 0;
        for (std::size_t i = 0; i < plan.glyphs().size(); ++i) {
            const solid& shape = plan.glyphs()[i].built->form();
            const placement at = plan.place(i);
            const std::uint32_t first = plan.range(i, part::front).first_vertex;
            for (const triangle t : shape.triangles) {
                by_line += turns(
                    [&](std::uint32_t p) {
                        const box_position q = one(at.position(shape.points[p], 0.0f));
                        return grid_point{q.x.bits, q.y.bits};
                    },
                    t);
                in_file += turns(
                    [&](std::uint32_t p) {
                        std::uint16_t q[2];
                        std::memcpy(q, g.bin.data() + 20 * (first + p), sizeof q);
                        return grid_point{q[0], q[1]};
                    },
                    t);
            }
        }
        const std::uint64_t reported = engines::gltf::turned_by_quantising(plan);
        CHECK(reported == in_file);
        by_letter += reported;
    }
    CHECK(by_line > 10);
    INFO(by_line << " by one box");
    CHECK(10 * by_letter <= by_line);
}

TEST_CASE("a glTF file has a named, non-metallic material for each part that is drawn", "[engines]")
{
    bench b;
    const auto law = [](const auto& plan, const std::vector<std::string>& drawn) {
        for (const auto how : {engines::gltf::layout::plain, engines::gltf::layout::quantised}) {
            const std::string json = written(plan, how).json;
            const auto list = json.substr(json.find("\"materials\":["));
            const auto materials = list.substr(0, list.find("}}]"));
            CHECK(all_after(materials, "\"name\":") == quoted(drawn));
            CHECK(all_after(materials, "\"metallicFactor\":") == std::vector<std::string>(drawn.size(), "0"));
            CHECK(all_after(materials, "\"roughnessFactor\":").size() == drawn.size());

            // Without one, a primitive is drawn as metal; a node and a mesh without a name are called by a number.
            const auto meshes = json.substr(json.find("\"meshes\":["), json.find("\"buffers\":["));
            const auto named = all_after(meshes, "\"material\":");
            CHECK(named.size() == all_after(meshes, "\"attributes\":").size());
            for (std::size_t k = 0; k < named.size(); ++k) CHECK(named[k] == std::to_string(k % drawn.size()));
            CHECK(all_after(json, "\"nodes\":[{\"name\":").size() == 1);
            CHECK(all_after(json, "\"meshes\":[{\"name\":").size() == 1);
        }
    };
    const auto solid = planned(b, engines::gltf::options());
    law(solid, {"front", "back", "side"});
    bevelled_bench rounded;
    const auto five = planned(rounded, engines::gltf::options());
    law(five, {"front", "back", "side", "front_bevel", "back_bevel"});
    bench second, third;
    auto open_behind = std::move(second.mesher).with(extruded<>{.back = false});
    auto ribbon = open_behind.plan(word, engines::gltf::options());
    REQUIRE(ribbon);
    law(*ribbon, {"front", "side"});
    auto flattened = std::move(third.mesher).with(flat{});
    auto sheet = flattened.plan(word, engines::gltf::options());
    REQUIRE(sheet);
    law(*sheet, {"front"});
}

TEST_CASE("a letter whose bevels meet in a ridge has primitives and materials only for its other parts", "[engines]")
{
    bevelled_bench b;
    b.mesher.solid().width = 0.05f;  // wider than half of the stem, less than half of the dot
    const auto plan = planned(b, engines::gltf::options(), "l.");
    REQUIRE(plan.range(0, part::front).index_count == 0);
    REQUIRE(plan.range(1, part::front).index_count != 0);
    for (const auto how : {engines::gltf::layout::plain, engines::gltf::layout::quantised}) {
        const std::string json = written(plan, how).json;
        const bool packed = how == engines::gltf::layout::quantised;
        const auto meshes = json.substr(json.find("\"meshes\":["), json.find("\"buffers\":["));
        using words = std::vector<std::string>;
        CHECK(all_after(meshes, "\"material\":") ==
              (packed ? words{"2", "3", "4", "0", "1", "2", "3", "4"} : words{"0", "1", "2", "3", "4"}));
        words counts;
        for (std::size_t i = 0; i < (packed ? 2 : 1); ++i)
            for (const part p : plan.parts()) {
                const mesh_range range = packed ? plan.range(i, p) : plan.range(p);
                if (range.index_count != 0) counts.push_back(std::to_string(range.index_count));
            }
        words told;
        const auto indices = all_after(meshes, "\"indices\":");
        const auto all = all_after(json.substr(json.find("\"accessors\":[")), "\"count\":");
        for (const std::string& k : indices) told.push_back(all.at(std::stoul(k)));
        CHECK(told == counts);
        CHECK(all.size() == 4 + counts.size());
    }
}

TEST_CASE("texture coordinates over the text's box are written unchanged into a quantised glTF file", "[engines]")
{
    bench b;
    auto boxed = std::move(b.mesher).with(extruded<>{.texture = texture_mapping::box});
    auto plan = boxed.plan(word, engines::gltf::options());
    REQUIRE(plan);
    const glb g = written(*plan, engines::gltf::layout::quantised);
    CHECK(g.json.find("KHR_texture_transform") == std::string::npos);
    CHECK(g.json.find("\"textures\"") == std::string::npos);
    std::uint16_t least = 0xFFFF, most = 0;
    for (std::size_t i = 0; i < plan->size().vertices; ++i) {
        std::uint16_t u;
        std::memcpy(&u, g.bin.data() + 20 * i + 16, 2);
        least = (std::min)(least, u), most = (std::max)(most, u);
    }
    CHECK(least == 0);
    CHECK(most == 0xFFFF);
}

TEST_CASE("a glTF file has wide indices for a long text, and no mesh for an empty one", "[engines]")
{
    bench b;
    std::string lines;
    for (int i = 0; i < 600; ++i) lines += "@&g";
    const auto plan = planned(b, engines::gltf::options(), lines);
    const glb g = written(plan, engines::gltf::layout::quantised);
    CHECK(g.json.find("\"componentType\":5125") != std::string::npos);
    std::uint32_t most = 0;
    for (std::size_t i = 0; i < plan.size().indices(); ++i) {
        std::uint32_t n;
        std::memcpy(&n, g.bin.data() + 20 * plan.size().vertices + 4 * i, 4);
        most = (std::max)(most, n);
    }
    CHECK(most == plan.size().vertices - 1);

    const auto nothing = planned(b, engines::gltf::options(), "");
    CHECK(written(nothing, engines::gltf::layout::plain).json.find("meshes") == std::string::npos);
}

TEST_CASE("a glTF file is right for a text longer than any line of the file", "[engines][gltf]")
{
    const std::string name(3000, 'n');
    std::string json = "[";
    engines::gltf::say(json, "\"%s\",%d", name.c_str(), 7);
    CHECK(json == "[\"" + name + "\",7");
}

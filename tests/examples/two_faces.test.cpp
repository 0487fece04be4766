// SPDX-License-Identifier: MIT
//
// What text_to_mesh writes for programs that compute with solids, read back from the file: every edge has two faces, and
// round every point its faces make one fan, in lines that are long enough for floats to be coarse.

#include "support/catch.hpp"

#include "scratch_folder.hpp"

#include <typemesh/core/point.hpp>
#include <typemesh/inspect/manifoldness.hpp>

#include <tiny_gltf.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

using typemesh::vec3;

namespace {

struct read_mesh {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
};

template <class T>
T number_at(const std::vector<unsigned char>& bytes, std::size_t at)
{
    T value{};
    if (at + sizeof value > bytes.size()) FAIL("the file ends too early");
    std::memcpy(&value, bytes.data() + at, sizeof value);  // on a little-endian machine, as all that run this are
    return value;
}

vec3 place_at(const std::vector<unsigned char>& bytes, std::size_t at)
{
    return {number_at<float>(bytes, at), number_at<float>(bytes, at + 4), number_at<float>(bytes, at + 8)};
}

read_mesh read_stl(const std::string& path)
{
    const auto bytes = bytes_of(path);
    read_mesh m;
    for (std::size_t t = 0, n = number_at<std::uint32_t>(bytes, 80); t < n; ++t)
        for (std::size_t k = 1; k < 4; ++k) {
            m.indices.push_back(static_cast<std::uint32_t>(m.vertices.size()));
            m.vertices.push_back(place_at(bytes, 84 + 50 * t + 12 * k));
        }
    return m;
}

read_mesh read_ply(const std::string& path)
{
    const auto bytes = bytes_of(path);
    const std::string text(bytes.begin(), bytes.end()), end = "end_header\n";
    const bool has_parts = text.find("property uchar part") != std::string::npos;
    const auto count = [&](const std::string& of) {
        const auto found = text.find("element " + of + " ");
        REQUIRE(found != std::string::npos);
        return static_cast<std::size_t>(std::atoll(text.c_str() + found + of.size() + 9));
    };
    std::size_t at = text.find(end) + end.size();
    read_mesh m;
    for (std::size_t i = 0; i < count("vertex"); ++i, at += 32) m.vertices.push_back(place_at(bytes, at));
    for (std::size_t i = 0; i < count("face"); ++i, at += has_parts ? 14 : 13)
        for (std::size_t k = 0; k < 3; ++k) m.indices.push_back(number_at<std::uint32_t>(bytes, at + 1 + 4 * k));
    return m;
}

read_mesh read_obj(const std::string& path)
{
    const auto bytes = bytes_of(path);
    std::istringstream in(std::string(bytes.begin(), bytes.end()));
    read_mesh m;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key, a, b, c;
        words >> key >> a >> b >> c;
        if (key == "v")
            m.vertices.push_back(
                {std::strtof(a.c_str(), nullptr), std::strtof(b.c_str(), nullptr), std::strtof(c.c_str(), nullptr)});
        if (key == "f")
            for (const std::string& corner : {a, b, c})
                m.indices.push_back(static_cast<std::uint32_t>(std::strtoul(corner.c_str(), nullptr, 10) - 1));
    }
    return m;
}

read_mesh read_glb(const std::string& path)
{
    tinygltf::Model file;
    tinygltf::TinyGLTF reader;
    std::string trouble, warning;
    REQUIRE(reader.LoadBinaryFromFile(&file, &trouble, &warning, path));
    read_mesh m;
    const auto bytes_from = [&](const tinygltf::Accessor& a) {
        const auto& view = file.bufferViews[static_cast<std::size_t>(a.bufferView)];
        return view.byteOffset + a.byteOffset;
    };
    const auto& bytes = file.buffers[0].data;
    for (const auto& mesh : file.meshes)
        for (const auto& part : mesh.primitives) {
            const auto& places = file.accessors[static_cast<std::size_t>(part.attributes.at("POSITION"))];
            const auto& corners = file.accessors[static_cast<std::size_t>(part.indices)];
            const std::size_t stride = file.bufferViews[static_cast<std::size_t>(places.bufferView)].byteStride;
            const auto first = static_cast<std::uint32_t>(m.vertices.size());
            for (std::size_t i = 0; i < places.count; ++i)
                m.vertices.push_back(place_at(bytes, bytes_from(places) + i * (stride == 0 ? 12 : stride)));
            const bool wide = corners.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
            for (std::size_t i = 0; i < corners.count; ++i)
                m.indices.push_back(first + (wide ? number_at<std::uint32_t>(bytes, bytes_from(corners) + 4 * i)
                                                  : number_at<std::uint16_t>(bytes, bytes_from(corners) + 2 * i)));
        }
    return m;
}

/// Of the model's XML, which unzip has written. lib3mf writes an element a line or several; only their order counts.
read_mesh read_3mf(const std::string& path)
{
    const std::string xml = path + ".xml";
    REQUIRE(std::system(("unzip -p '" + path + "' 3D/3dmodel.model >'" + xml + "'").c_str()) == 0);
    const auto bytes = bytes_of(xml);
    const std::string text(bytes.begin(), bytes.end());
    const auto value = [&](std::size_t from, const char* name) {
        const auto at = text.find(std::string(" ") + name + "=\"", from);
        if (at == std::string::npos) FAIL("an element without " << name);
        return text.c_str() + at + std::strlen(name) + 3;
    };
    read_mesh m;
    for (std::size_t at = 0; (at = text.find("<vertex ", at)) != std::string::npos; ++at)
        m.vertices.push_back({std::strtof(value(at, "x"), nullptr), std::strtof(value(at, "y"), nullptr),
                              std::strtof(value(at, "z"), nullptr)});
    for (std::size_t at = 0; (at = text.find("<triangle ", at)) != std::string::npos; ++at)
        for (const char* corner : {"v1", "v2", "v3"})
            m.indices.push_back(static_cast<std::uint32_t>(std::strtoul(value(at, corner), nullptr, 10)));
    return m;
}

struct format {
    const char* ending;
    read_mesh (*read)(const std::string& path);
};
constexpr format formats[] = {
    {"stl", read_stl}, {"obj", read_obj}, {"ply", read_ply}, {"glb", read_glb}, {"3mf", read_3mf}};

struct line_of_letters {
    const char *font, *text;
};

// A hundred letters each; those of the last two touch themselves and each other.
constexpr line_of_letters lines[] = {
    {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
     "Sphinx of black quartz, judge my vow: the five boxing wizards jump quickly over 0123456789 lazy dogs"},
    {"/usr/share/fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
     "السلام عليكم ورحمة الله وبركاته بسم الله الرحمن الرحيم السلام عليكم ورحمة الله وبركاته بسم الله الرح"},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
     "▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞▚▞"},
    {"/usr/share/fonts/truetype/ancient-scripts/Symbola_hint.ttf",
     "⚀⚁⚂⚃⚄⚅♔♕♖♗♘♙♚♛♜♝♞♟⚀⚁▚▞▙▛▜▟☰☱☲☳☴☵☶☷♠♡♢♣♤♥♦♧♩♪♫♬♭♮♯⚐⚑⚒⚓⚔⚕⚖⚗⚘⚙⚚⚛⚜⚝⚞⚟⚠⚡⚢⚣⚤⚥⚦⚧⚨⚩⚪⚫⚬⚭⚮⚯⚰⚱⚲⚳⚴⚵⚶⚷⚸⚹⚺⚻⚼⚽⚾⚿⛀⛁⛂"},
};

constexpr const char* looks[] = {"",
                                 "--bevel 0.02 --profile stepped",
                                 "--bevel 0.01 --bevel-out --profile round",
                                 "--outline 0.01",
                                 "--outline 0.02 --outline-letter",
                                 "--embolden 0.01"};

}  // namespace

TEST_CASE("every edge of a line of a hundred letters has two faces, in every format", "[two_faces]")
{
    scratch_folder folder;
    const bool has_3mf = std::system(("'" TYPEMESH_TEXT_TO_MESH "' o --output '" + folder.file("probe.3mf") +
                                      "' >/dev/null 2>&1 && command -v unzip >/dev/null")
                                         .c_str()) == 0;
    if (!has_3mf) WARN("3MF is left out: text_to_mesh was built without lib3mf, or there is no unzip");
    std::size_t crowded_when_kept = 0;
    for (const auto& [font, text] : lines)
        for (const char* look : looks)
            for (const auto& [ending, read] : formats)
                for (const char* way : {"", "join", "keep"}) {
                    if (ending == std::string("3mf") && !has_3mf) continue;
                    const bool glb = ending == std::string("glb"), keep = way == std::string("keep");
                    if (way == std::string("join") && ending != std::string("stl")) continue;
                    if (keep && (ending != std::string("stl") || *look != '\0')) continue;
                    const std::string path = folder.file(std::string("line.") + ending);
                    const std::string touching = *way != '\0' ? way : "part";
                    const std::string option = *way != '\0' || glb ? " --touching " + touching : "";
                    const std::string command = std::string("'" TYPEMESH_TEXT_TO_MESH "' '") + text + "' --font " +
                                                font + " --quality low --output '" + path + "' " + look + option;
                    INFO(command);
                    REQUIRE(std::system(command.c_str()) == 0);
                    const read_mesh m = read(path);
                    REQUIRE(m.indices.size() > 300);
                    const auto found =
                        typemesh::inspect::check_manifoldness(typemesh::inspect::mesh_view{m.vertices, m.indices});
                    if (keep) {
                        crowded_when_kept += found.crowded_edges;
                        continue;
                    }
                    CHECK(found.open_edges == 0);
                    CHECK(found.crowded_edges == 0);
                    CHECK(found.pinched_points == 0);
                    CHECK(found.bad_triangles == 0);
                }
    CHECK(crowded_when_kept > 100);
}

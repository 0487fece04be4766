// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/part_colours.hpp"
#include "text_to_mesh/write_obj.hpp"

#include "extruded_ring.hpp"
#include "scratch_folder.hpp"
#include "written_alone.hpp"

#include <cstdlib>
#include <sstream>

using namespace text_to_mesh;

TEST_CASE("an OBJ read again holds the same floats, triangles and groups", "[write_obj]")
{
    scratch_folder folder;
    model ring = extruded_ring();
    ring.vertices[0].uv[0] = 1.0e-7F;
    ring.vertices[1].uv[0] = 12345.678F;
    REQUIRE(written_alone(write_obj, ring, folder.file("ring.obj")) == "");

    std::istringstream in(text_of(folder.file("ring.obj")));
    std::vector<std::vector<float>> v, vt, vn;
    std::vector<std::uint32_t> indices;
    std::vector<std::string> groups, libraries, materials;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key, word;
        words >> key;
        std::vector<float> numbers;
        if (key == "#" || key == "o") continue;
        if (key == "g" || key == "mtllib" || key == "usemtl") {
            words >> word;
            (key == "g" ? groups : key == "mtllib" ? libraries : materials).push_back(word);
        } else if (key == "f") {
            while (words >> word) {
                const unsigned long number = std::strtoul(word.c_str(), nullptr, 10);
                const std::string n = std::to_string(number);
                CHECK(word == n + "/" + n + "/" + n);
                indices.push_back(static_cast<std::uint32_t>(number - 1));
            }
        } else {
            while (words >> word) numbers.push_back(std::strtof(word.c_str(), nullptr));
            INFO(line);
            REQUIRE((key == "v" || key == "vt" || key == "vn"));
            (key == "v" ? v : key == "vt" ? vt : vn).push_back(numbers);
        }
    }
    CHECK(groups == std::vector<std::string>{"front", "back", "side"});
    CHECK(materials == groups);
    CHECK(libraries == std::vector<std::string>{"ring.mtl"});
    CHECK(indices == ring.indices);
    REQUIRE(v.size() == ring.vertices.size());
    REQUIRE(vt.size() == ring.vertices.size());
    REQUIRE(vn.size() == ring.vertices.size());
    bool equal = true;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const model_vertex& given = ring.vertices[i];
        equal = equal && v[i] == std::vector<float>(given.position, given.position + 3) &&
                vt[i] == std::vector<float>(given.uv, given.uv + 2) &&
                vn[i] == std::vector<float>(given.normal, given.normal + 3);
    }
    CHECK(equal);
}

TEST_CASE("an empty model gives an OBJ without vertices and faces", "[write_obj]")
{
    scratch_folder folder;
    REQUIRE(written_alone(write_obj, model{}, folder.file("empty.obj")) == "");
    CHECK(text_of(folder.file("empty.obj")) == "# written by typemesh\no text\n");
}

TEST_CASE("an OBJ's materials are named after its parts and have the colours of pictures", "[write_obj]")
{
    scratch_folder folder;
    REQUIRE(written_alone(write_obj, extruded_ring(), folder.file("Ring.of.OBJ")) == "");
    std::istringstream in(text_of(folder.file("Ring.of.mtl")));
    std::vector<std::string> names;
    std::vector<int> reds;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key, name;
        words >> key;
        float red = 0.0F;
        if (key == "newmtl" && words >> name) names.push_back(name);
        if (key == "Kd" && words >> red) reds.push_back(static_cast<int>(red * 255.0F + 0.5F));
    }
    CHECK(names == std::vector<std::string>{"front", "back", "side"});
    CHECK(reds == std::vector<int>{face_rgb[0], face_rgb[0], side_rgb[0]});
    CHECK(folder.count() == 2);
}

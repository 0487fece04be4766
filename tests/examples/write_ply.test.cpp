// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/write_ply.hpp"

#include "extruded_ring.hpp"
#include "scratch_folder.hpp"
#include "written_alone.hpp"

#include <cstring>

using namespace text_to_mesh;

TEST_CASE("a PLY read again holds the same vertices and triangles", "[write_ply]")
{
    scratch_folder folder;
    const model ring = extruded_ring();
    REQUIRE(written_alone(write_ply, ring, folder.file("ring.ply")) == "");
    const std::string file = text_of(folder.file("ring.ply"));

    const std::string last = "end_header\n";
    const std::size_t start = file.find(last) + last.size();
    const std::string header = file.substr(0, start);
    CHECK(header.find("ply\nformat binary_little_endian 1.0\n") == 0);
    CHECK(header.find("comment O ring") != std::string::npos);
    CHECK(header.find("element vertex " + std::to_string(ring.vertices.size()) + "\nproperty float x\n") !=
          std::string::npos);
    CHECK(header.find("element face " + std::to_string(ring.indices.size() / 3) + "\n") != std::string::npos);

    const std::size_t vertex_bytes = ring.vertices.size() * sizeof(model_vertex);
    CHECK(header.find("comment part 0 front\ncomment part 1 back\ncomment part 2 side\n") != std::string::npos);
    CHECK(header.find("property list uchar uint vertex_indices\nproperty uchar part\nend_header\n") !=
          std::string::npos);
    REQUIRE(file.size() == start + vertex_bytes + ring.indices.size() / 3 * 14);
    CHECK(std::memcmp(file.data() + start, ring.vertices.data(), vertex_bytes) == 0);
    std::vector<std::uint32_t> indices;
    for (std::size_t at = start + vertex_bytes; at < file.size(); at += 14) {
        CHECK(file[at] == 3);
        std::uint32_t three[3];
        std::memcpy(three, file.data() + at + 1, sizeof three);
        const auto& part = ring.parts.at(static_cast<std::size_t>(file[at + 13]));
        CHECK(indices.size() >= part.first_index);
        CHECK(indices.size() < part.first_index + part.index_count);
        indices.insert(indices.end(), three, three + 3);
    }
    CHECK(indices == ring.indices);
}

TEST_CASE("a PLY of a model without parts has no property for them", "[write_ply]")
{
    scratch_folder folder;
    model ring = extruded_ring();
    ring.parts.clear();
    REQUIRE(written_alone(write_ply, ring, folder.file("ring.ply")) == "");
    const std::string file = text_of(folder.file("ring.ply"));
    CHECK(file.find("part") == std::string::npos);
    CHECK(file.size() == file.find("end_header\n") + 11 + ring.vertices.size() * 32 + ring.indices.size() / 3 * 13);
}

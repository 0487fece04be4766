// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/write_stl.hpp"

#include "extruded_ring.hpp"
#include "scratch_folder.hpp"
#include "written_alone.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

using namespace text_to_mesh;

TEST_CASE("an STL read again is closed, and its facet normals are unit and outward", "[write_stl]")
{
    scratch_folder folder;
    const model ring = extruded_ring();
    REQUIRE(written_alone(write_stl, ring, folder.file("ring.stl")) == "");
    const std::vector<unsigned char> bytes = bytes_of(folder.file("ring.stl"));

    const std::size_t triangles = ring.indices.size() / 3;
    REQUIRE(bytes.size() == 84 + 50 * triangles);
    CHECK(std::memcmp(bytes.data(), "solid", 5) != 0);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    CHECK(count == triangles);

    using place = std::array<float, 3>;
    std::map<std::pair<place, place>, int> edges;
    double volume = 0.0;
    for (std::size_t t = 0; t < triangles; ++t) {
        float f[12];
        std::memcpy(f, bytes.data() + 84 + 50 * t, sizeof f);
        const place p[3] = {{f[3], f[4], f[5]}, {f[6], f[7], f[8]}, {f[9], f[10], f[11]}};
        for (std::size_t i = 0; i < 3; ++i) {
            edges[{p[i], p[(i + 1) % 3]}] += 1;
            edges[{p[(i + 1) % 3], p[i]}] -= 1;
        }
        const double length = double(f[0]) * f[0] + double(f[1]) * f[1] + double(f[2]) * f[2];
        CHECK(length == Catch::Approx(1.0).epsilon(1e-6));
        const model_vertex& first = ring.vertices[ring.indices[3 * t]];
        CHECK(f[0] * first.normal[0] + f[1] * first.normal[1] + f[2] * first.normal[2] > 0.9F);
        volume += (double(p[0][0]) * (double(p[1][1]) * p[2][2] - double(p[1][2]) * p[2][1]) +
                   double(p[0][1]) * (double(p[1][2]) * p[2][0] - double(p[1][0]) * p[2][2]) +
                   double(p[0][2]) * (double(p[1][0]) * p[2][1] - double(p[1][1]) * p[2][0])) /
                  6.0;
    }
    bool closed = true;
    for (const auto& edge : edges) closed = closed && edge.second == 0;
    CHECK(closed);
    CHECK(volume == Catch::Approx(0.75 * 0.5 * 24.0 / 2.0 * std::sin(2.0 * 3.14159265358979 / 24.0)).epsilon(1e-5));
}

TEST_CASE("a triangle without area has a zero normal in an STL, never NaN", "[write_stl]")
{
    scratch_folder folder;
    model line;
    line.vertices = std::vector<model_vertex>(3);
    line.vertices[1].position[0] = -0.0F;
    line.indices = {0, 1, 2};
    REQUIRE(written_alone(write_stl, line, folder.file("line.stl")) == "");
    const std::vector<unsigned char> bytes = bytes_of(folder.file("line.stl"));
    REQUIRE(bytes.size() == 134);
    CHECK(std::all_of(bytes.begin() + 84, bytes.end(), [](unsigned char b) { return b == 0; }));
    REQUIRE(written_alone(write_stl, model{}, folder.file("empty.stl")) == "");
    CHECK(bytes_of(folder.file("empty.stl")).size() == 84);
}

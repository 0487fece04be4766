// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace three {

/// What these programs read of an OBJ file: corners, and triangles with the names of their materials.
struct obj_triangles {
    struct triangle {
        std::array<std::size_t, 3> corners;
        std::string part;
    };
    std::vector<std::array<float, 3>> points;
    std::vector<triangle> triangles;

    explicit obj_triangles(const char* path)
    {
        std::ifstream file(path);
        std::string part;
        for (std::string line; std::getline(file, line);) {
            std::istringstream words(line);
            std::string word;
            words >> word;
            if (word == "v") {
                std::array<float, 3>& p = points.emplace_back();
                words >> p[0] >> p[1] >> p[2];
            } else if (word == "usemtl") {
                words >> part;
            } else if (word == "f") {
                triangle t{{}, part};
                for (std::size_t& corner : t.corners) {
                    words >> word;
                    corner = std::stoul(word) - 1;  // "3/1/2": the point comes first
                }
                triangles.push_back(t);
            }
        }
    }
};

}  // namespace three

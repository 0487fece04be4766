// SPDX-License-Identifier: MIT

// Must not compile, each with a sentence: lambdas that make no vertices.

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

struct vertex {
    float x, y, z;
};

void make(std::vector<vertex>& vertices, std::vector<std::uint32_t>& indices)
{
    (void)into(vertices, indices, [](const auto& s) noexcept { return vertex{s.position.x, 0, 0}; });
    (void)into(vertices, indices, [](const surface_point<attribute::position>&) { return vertex{}; });
    (void)into(vertices, indices, [](const surface_point<attribute::position>&) noexcept { return std::string{}; });
}

// SPDX-License-Identifier: MIT

// Must not compile, each line in the same words: indices that are no integers, or cannot be written.

#include <typemesh/compat/d3dx_vertex.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

using namespace typemesh;

void write(std::vector<d3dx_vertex>& vertices, std::vector<float>& numbers, std::vector<char>& letters,
           std::span<const std::uint32_t> read_only)
{
    (void)into(vertices, numbers);
    (void)into(std::span{vertices}, std::span{letters});
    (void)into(std::span{vertices}, read_only);
    (void)stream_sink{std::span{numbers}};
}

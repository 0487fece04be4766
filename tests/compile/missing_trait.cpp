// SPDX-License-Identifier: MIT

// Must not compile, and the message must name typemesh::vertex_traits (tests/compile/CMakeLists.txt looks for it): a user who
// has not yet written the trait meets it here, with the container and the call of the first example.
#include <typemesh/vertex/growing_sink.hpp>

#include <cstdint>
#include <vector>

struct vertex_without_trait {
    float x, y, z;
};

void build()
{
    std::vector<vertex_without_trait> vertices;
    std::vector<std::uint32_t> indices;
    auto sink = typemesh::into(vertices, indices);
    (void)sink;
}

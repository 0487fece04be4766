// SPDX-License-Identifier: MIT

// Must not compile, and the message must name typemesh::vertex_traits (tests/compile/CMakeLists.txt looks for it).
#include <typemesh/typemesh.hpp>

struct vertex_without_trait {
    float x, y, z;
};
static_assert(typemesh::mesh_vertex<vertex_without_trait>);

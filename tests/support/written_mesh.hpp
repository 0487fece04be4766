// SPDX-License-Identifier: MIT
#pragma once

// What a plan writes, and whether two such meshes are the same to the bit.

#include "support/catch.hpp"

#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cstring>
#include <vector>

namespace test {

/// The whole mesh of a plan, in arrays of Mesh.
template <class Mesh>
Mesh written(const auto& plan)
{
    Mesh m;
    REQUIRE(plan.write(typemesh::into(m.vertices, m.indices)));
    REQUIRE(m.vertices.size() == plan.size().vertices);
    return m;
}

template <class Vertex>
bool same_bits(const std::vector<Vertex>& a, const std::vector<Vertex>& b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Vertex)) == 0);
}

template <class Mesh>
    requires requires(const Mesh& m) { m.vertices, m.indices; }
bool same_bits(const Mesh& a, const Mesh& b)
{
    return a.indices == b.indices && same_bits(a.vertices, b.vertices);
}

}  // namespace test

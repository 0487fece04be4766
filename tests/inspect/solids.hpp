// SPDX-License-Identifier: MIT
#pragma once

// Meshes to spoil: right as they are made.

#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/inspect/mesh_view.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cstdint>
#include <utility>

namespace solids {

/// The toy font's text as a mesh, extruded by 0.2 em, in em.
inline test::full_mesh of(const char* text, const typemesh::text_options& options = {})
{
    test::toy_font font;
    typemesh::text_mesher mesher{font};
    test::full_mesh m;
    const auto report = mesher.build(text, typemesh::into(m.vertices, m.indices), options);
    REQUIRE(report);
    return m;
}

/// It, looked at.
inline auto seen(const test::full_mesh& m) { return typemesh::inspect::mesh_view{m.vertices, m.indices}; }

/// Triangle t the other way round, and without triangle t.
inline test::full_mesh turned(test::full_mesh m, std::size_t t)
{
    std::swap(m.indices[3 * t], m.indices[3 * t + 1]);
    return m;
}
inline test::full_mesh without(test::full_mesh m, std::size_t t)
{
    m.indices.erase(m.indices.begin() + static_cast<std::ptrdiff_t>(3 * t),
                    m.indices.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
    return m;
}

}  // namespace solids

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Writes the refined cap of a region. `numbers` is working memory.
///
/// Fails  error::out_of_memory
[[nodiscard]] inline error write_cap(const refinable_mesh& mesh, const region& of, buffer<std::uint32_t>& numbers,
                                     const refined_cap& out) noexcept
{
    numbers.clear();
    std::uint32_t* const number = numbers.append(mesh.vertex_count());
    if (number == nullptr) return error::out_of_memory;
    out.loops.clear();
    out.inner.clear();
    out.triangles.clear();
    std::uint32_t count = 0;
    const auto all = of.starts();
    for (std::size_t loop = 0; loop + 1 < all.size(); ++loop) {
        if (!out.loops.starts.push_back(count)) return error::out_of_memory;
        std::uint32_t v = all[loop];
        do {
            const refinable_mesh::vertex& at = mesh.at(v);
            if (!out.loops.points.push_back(at.place) || !out.loops.edges.push_back(at.edge))
                return error::out_of_memory;
            number[v] = count++;
            v = mesh.next_on_boundary(v);
        } while (v != all[loop]);
    }
    if (!out.loops.starts.push_back(count)) return error::out_of_memory;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.at(v).boundary != refinable_mesh::none) continue;
        if (!out.inner.push_back(mesh.place(v))) return error::out_of_memory;
        number[v] = count++;
    }
    triangle* to = out.triangles.append(mesh.triangle_count());
    if (to == nullptr) return error::out_of_memory;
    for (std::uint32_t h = 0; h < mesh.end(); h += 4)
        *to++ = {number[mesh.origin(h)], number[mesh.origin(h + 1)], number[mesh.origin(h + 2)]};
    out.loops.curves = of.curves();
    out.loops.grid = of.grid();
    out.loops.tolerance = of.tolerance();
    out.loops.corners = of.corners();
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include "support/mesh_laws.hpp"

#include <typemesh/vertex/mesh_range.hpp>

#include <cmath>
#include <cstddef>

namespace fuzz {

/// The triangles of a mesh's front, which lie in the plane.
struct front_cap {
    const test::full_mesh& m;
    typemesh::mesh_range range;

    /// The number of triangles over a place; -1 if it is nearer than `margin` to an edge of one.
    [[nodiscard]] int count_at(double x, double y, double margin) const
    {
        int count = 0;
        for (std::size_t i = range.first_index; i < std::size_t{range.first_index} + range.index_count; i += 3) {
            bool inside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const typemesh::vec3 a = m.vertices[m.indices[i + k]].position,
                                     b = m.vertices[m.indices[i + (k + 1) % 3]].position;
                const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
                const double off = length > 0.0 ? (dx * (y - a.y) - dy * (x - a.x)) / length : 0.0;
                const double along = length > 0.0 ? (dx * (x - a.x) + dy * (y - a.y)) / length : 0.0;
                if (std::fabs(off) < margin && along > -margin && along < length + margin) return -1;
                inside = inside && off > 0.0;
            }
            count += inside ? 1 : 0;
        }
        return count;
    }
    [[nodiscard]] double area() const
    {
        double sum = 0.0;
        for (std::size_t i = range.first_index; i < std::size_t{range.first_index} + range.index_count; i += 3) {
            const typemesh::vec3 a = m.vertices[m.indices[i]].position, b = m.vertices[m.indices[i + 1]].position,
                                 c = m.vertices[m.indices[i + 2]].position;
            sum += 0.5 * ((double(b.x) - a.x) * (double(c.y) - a.y) - (double(c.x) - a.x) * (double(b.y) - a.y));
        }
        return sum;
    }
};

}  // namespace fuzz

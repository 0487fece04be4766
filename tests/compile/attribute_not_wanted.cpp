// SPDX-License-Identifier: MIT
//
// Refused: a writer that takes an attribute that its `wants` does not name.

#include <typemesh/vertex/vertex_traits.hpp>

struct packed {
    float place[3];
    float normal[3];
};

template <>
struct typemesh::vertex_traits<packed> {
    static constexpr auto wants = attribute::position;
    packed operator()(const surface_point<wants>& s) const noexcept
    {
        const vec3 n = s.normal;
        return {{s.position.x, s.position.y, s.position.z}, {n.x, n.y, n.z}};
    }
};

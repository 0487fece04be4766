// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/vertex_traits.hpp>

#include <cmath>
#include <cstdint>

namespace stranger {

/// 12 bytes: positions in 1/4096 of a unit, a normal and a part in four bytes. Written only from vertex_traits' comment.
struct fixed_point_vertex {
    std::int16_t place[3];
    std::int8_t normal[3];
    std::uint8_t part;
};

}  // namespace stranger

template <>
struct typemesh::vertex_traits<stranger::fixed_point_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::part;
    stranger::fixed_point_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        const auto place = [](float f) { return static_cast<std::int16_t>(std::lround(f * 4096.0f)); };
        const auto byte = [](float f) { return static_cast<std::int8_t>(std::lround(f * 127.0f)); };
        return {{place(s.position.x), place(s.position.y), place(s.position.z)},
                {byte(s.normal.x), byte(s.normal.y), byte(s.normal.z)},
                static_cast<std::uint8_t>(s.part)};
    }
};
static_assert(typemesh::mesh_vertex<stranger::fixed_point_vertex>);

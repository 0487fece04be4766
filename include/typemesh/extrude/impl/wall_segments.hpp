// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

// The number of segments of any extruder's walls: its member `segments`, or what its wall_segments() and
// set_wall_segments() say; 1 for an extruder without such walls.

template <class E>
[[nodiscard]] std::uint32_t segments_of([[maybe_unused]] const E& how) noexcept
{
    if constexpr (requires { how.wall_segments(); })
        return how.wall_segments();
    else if constexpr (requires { how.segments; })
        return how.segments;
    else
        return 1;
}

template <class E>
void set_segments([[maybe_unused]] E& how, [[maybe_unused]] std::uint32_t segments) noexcept
{
    if constexpr (requires { how.set_wall_segments(segments); })
        how.set_wall_segments(segments);
    else if constexpr (requires { how.segments; })
        how.segments = segments;
}

/// Whether the walls of this type of extruder can be divided.
template <class E>
inline constexpr bool has_segments =
    requires(E& how) { how.set_wall_segments(1u); } || requires(E& how) { how.segments; };

}  // namespace typemesh::inline TYPEMESH_ABI

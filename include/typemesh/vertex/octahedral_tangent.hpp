// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/octahedral.hpp>

#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A tangent and its sign in the size of an octahedral vector. The sign is the lowest bit of y (1 means -1), and y is
/// rounded to a step with this bit.
///
///     octahedral_tangent<snorm8>   2 bytes, within 1.1 degrees    octahedral_tangent<snorm16>   4 bytes, within 0.0043
///
/// A shader decodes the direction as if there were no sign: the bounds above include this error. Tangents of 8, 10 or
/// 16 bits per component do not need this type: {x, y, z, w} of snorm8 or snorm16, snorm10{x, y, z, w}.
template <class Step>
struct octahedral_tangent : private octahedral<Step> {
    using octahedral<Step>::x;
    using octahedral<Step>::y;

    octahedral_tangent() = default;
    octahedral_tangent(float tx, float ty, float tz, float sign) noexcept
        : octahedral<Step>{tx, ty, tz, std::integral_constant<int, 2>{}, sign < 0.0f ? 1 : 0}
    {
    }

    /// The unit vector and the sign.
    [[nodiscard]] vec4 decoded() const noexcept
    {
        const vec3 t = octahedral<Step>::decoded();
        return {t.x, t.y, t.z, (static_cast<unsigned>(static_cast<int>(y.bits)) & 1u) != 0 ? -1.0f : 1.0f};
    }
};

using octahedral_tangent16 = octahedral_tangent<snorm8>;   ///< a tangent in 16 bits
using octahedral_tangent32 = octahedral_tangent<snorm16>;  ///< a tangent in 32 bits
static_assert(sizeof(octahedral_tangent32) == 4);

}  // namespace typemesh::inline TYPEMESH_ABI

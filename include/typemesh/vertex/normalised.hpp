// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A number from -1 to 1 (signed Integer) or 0 to 1 (unsigned) stored as an integer. Graphics interfaces call it snorm
/// and unorm.
///
///     value = bits / most        most = 127, 255, 32,767 or 65,535; for snorm, bits = -most - 1 also means -1
///
/// A float out of range is clamped (NaN becomes one of the ends). All other floats are rounded to the nearest step,
/// ties away from 0, as Direct3D specifies. The rounding is exact: the product with `most` is computed in double
/// precision.
///
///     struct my_vertex { float position[3]; snorm8 normal[4]; };  // {..., {s.normal.x, s.normal.y, s.normal.z, 0.0f}}
template <std::integral Integer>
    requires(sizeof(Integer) <= 2)
struct normalised {
    static constexpr int most = (std::numeric_limits<Integer>::max)();

    Integer bits;

    normalised() = default;
    constexpr normalised(float value) noexcept : bits{rounded(value)} {}

    [[nodiscard]] static constexpr normalised from_bits(Integer bits) noexcept
    {
        normalised n{0.0f};
        n.bits = bits;
        return n;
    }

    /// The nearest float to bits / most, at least -1.
    [[nodiscard]] explicit constexpr operator float() const noexcept
    {
        const float value = static_cast<float>(bits) / static_cast<float>(most);
        return value < -1.0f ? -1.0f : value;
    }

    friend constexpr bool operator==(normalised, normalised) noexcept = default;

private:
    [[nodiscard]] static constexpr Integer rounded(float value) noexcept
    {
        constexpr float least = std::is_signed_v<Integer> ? -1.0f : 0.0f;
        const float inside = value > least ? (value < 1.0f ? value : 1.0f) : least;
        const double steps = static_cast<double>(inside) * most;  // 24 bits by 16: exact, and so is adding the half
        return static_cast<Integer>(static_cast<int>(steps + 0.5 - static_cast<double>(steps < 0.0)));
    }
};

using snorm8 = normalised<std::int8_t>;
using snorm16 = normalised<std::int16_t>;   ///< [-1, 1] in 16 bits
using unorm8 = normalised<std::uint8_t>;    ///< [0, 1] in 8 bits
using unorm16 = normalised<std::uint16_t>;  ///< [0, 1] in 16 bits
static_assert(sizeof(snorm8) == 1 && sizeof(unorm16) == 2);

}  // namespace typemesh::inline TYPEMESH_ABI

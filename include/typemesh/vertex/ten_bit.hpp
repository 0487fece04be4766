// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Three numbers of 10 bits and one of 2 in 32 bits, x lowest:
///
///      31 30 29        20 19        10 9          0
///     | w   |     z      |     y      |     x      |    DXGI_FORMAT_R10G10B10A2, GL_(UNSIGNED_)INT_2_10_10_10_REV,
///                                                       VK_FORMAT_A2B10G10R10_*_PACK32
///
/// snorm10: from -1 to 1 in steps of 1/511; w is -1, 0 or 1, enough for the sign of a tangent.
/// unorm10: from 0 to 1 in steps of 1/1023; w in steps of 1/3.
///
/// Numbers are rounded like `normalised` (normalised.hpp): exactly to the nearest step; values out of range are
/// clamped. They are made from three numbers (a normal) or four (a tangent).
struct snorm10 {
    std::uint32_t bits;

    snorm10() = default;
    constexpr snorm10(float x, float y, float z, float w = 0.0f) noexcept
        : bits{(field(x, 511) & 0x3FFu) | (field(y, 511) & 0x3FFu) << 10 | (field(z, 511) & 0x3FFu) << 20 |
               (field(w, 1) & 3u) << 30}
    {
    }

    [[nodiscard]] constexpr vec4 decoded() const noexcept
    {
        return {number(0, 10, 511.0f), number(10, 10, 511.0f), number(20, 10, 511.0f), number(30, 2, 1.0f)};
    }

private:
    [[nodiscard]] static constexpr std::uint32_t field(float value, int most) noexcept
    {
        const float inside = value > -1.0f ? (value < 1.0f ? value : 1.0f) : -1.0f;
        const double steps = static_cast<double>(inside) * most;
        return static_cast<std::uint32_t>(static_cast<int>(steps + 0.5 - static_cast<double>(steps < 0.0)));
    }
    [[nodiscard]] constexpr float number(int lowest, int width, float most) const noexcept
    {
        const auto raw = static_cast<int>(bits >> lowest & ((1u << width) - 1u));
        const int value = raw >= 1 << (width - 1) ? raw - (1 << width) : raw;
        return static_cast<float>(value) < -most ? -1.0f : static_cast<float>(value) / most;
    }
};

/// The unsigned variant of snorm10.
struct unorm10 {
    std::uint32_t bits;

    unorm10() = default;
    constexpr unorm10(float x, float y, float z, float w = 0.0f) noexcept
        : bits{field(x, 1023) | field(y, 1023) << 10 | field(z, 1023) << 20 | field(w, 3) << 30}
    {
    }

    [[nodiscard]] constexpr vec4 decoded() const noexcept
    {
        const auto ten = [this](int lowest) { return static_cast<float>(bits >> lowest & 0x3FFu) / 1023.0f; };
        return {ten(0), ten(10), ten(20), static_cast<float>(bits >> 30) / 3.0f};
    }

private:
    [[nodiscard]] static constexpr std::uint32_t field(float value, int most) noexcept
    {
        const float inside = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
        return static_cast<std::uint32_t>(static_cast<double>(inside) * most + 0.5);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

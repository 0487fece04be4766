// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// A 16-bit number, IEEE 754 binary16: 1 sign bit, 5 exponent bits, 11 significant bits. The largest value is 65,504,
/// the smallest above 0 is 2^-24. Graphics interfaces call it half or float16.
///
///     struct my_vertex { float position[3]; half uv[2]; };    // {..., {s.uv.x, s.uv.y}} converts implicitly
///
/// A float is rounded to nearest, ties to even; 65,520 and more become infinity, NaN stays NaN. Conversion back to
/// float is exact. Both work on the bits, so compiler switches for fast arithmetic change nothing.
struct half {
    std::uint16_t bits;

    half() = default;
    half(float value) noexcept : bits{rounded(value)} {}

    [[nodiscard]] static half from_bits(std::uint16_t bits) noexcept
    {
        half h;
        h.bits = bits;
        return h;
    }

    [[nodiscard]] explicit operator float() const noexcept
    {
        const std::uint32_t sign = (bits & 0x8000u) << 16, exponent = bits >> 10 & 0x1Fu, fraction = bits & 0x3FFu;
        if (exponent == 0x1F) return as_float(sign | 0x7F80'0000u | fraction << 13);
        if (exponent != 0) return as_float(sign | (exponent + 112) << 23 | fraction << 13);
        const float tiny = static_cast<float>(fraction) * 0x1p-24f;
        std::uint32_t size;  // the sign is added as a bit: -ffast-math drops the sign of a zero
        std::memcpy(&size, &tiny, sizeof size);
        return as_float(sign | size);
    }

private:
    [[nodiscard]] static float as_float(std::uint32_t b) noexcept
    {
        float value;
        std::memcpy(&value, &b, sizeof value);
        return value;
    }

    [[nodiscard]] static std::uint16_t rounded(float value) noexcept
    {
        std::uint32_t b;
        std::memcpy(&b, &value, sizeof b);
        const std::uint32_t sign = b >> 16 & 0x8000u;
        b &= 0x7FFF'FFFFu;
        if (b > 0x7F80'0000u) return static_cast<std::uint16_t>(sign | 0x7E00u | (b >> 13 & 0x3FFu));  // NaN
        if (b >= 0x4780'0000u) return static_cast<std::uint16_t>(sign | 0x7C00u);                      // from 2^16
        if (b >= 0x3880'0000u) {  // from 2^-14: changes the exponent's bias; a carry into the exponent is correct
            b += 0xC800'0FFFu + (b >> 13 & 1u);
            return static_cast<std::uint16_t>(sign | b >> 13);
        }
        const std::uint32_t shift = 126 - (b >> 23);  // in units of 2^-24
        if (shift > 24) return static_cast<std::uint16_t>(sign);
        const std::uint32_t mantissa = (b & 0x7F'FFFFu) | 0x80'0000u, quotient = mantissa >> shift,
                            rest = mantissa & ((1u << shift) - 1), middle = 1u << (shift - 1);
        const std::uint32_t up = rest > middle || (rest == middle && (quotient & 1u) != 0) ? 1u : 0u;
        return static_cast<std::uint16_t>(sign | (quotient + up));
    }
};
static_assert(sizeof(half) == 2);

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The attributes of a surface point: a set, joined by |. Only requested attributes are computed.
enum class attribute : std::uint32_t {
    none = 0,
    position = 1u << 0,
    normal = 1u << 1,
    uv = 1u << 2,
    tangent = 1u << 3,
    glyph = 1u << 4,
    cluster = 1u << 5,
    part = 1u << 6,
    style = 1u << 7,
    curve = 1u << 8,
    letter = 1u << 9,
    word = 1u << 10,
    line = 1u << 11,
    pivot = 1u << 12,
    extent = 1u << 13,
};

[[nodiscard]] constexpr attribute operator|(attribute a, attribute b) noexcept
{
    return static_cast<attribute>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}

/// Whether a set contains an attribute, or any of several.
[[nodiscard]] constexpr bool has(attribute set, attribute one) noexcept
{
    return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(one)) != 0;
}

/// What a vertex can know of its letter: text_plan::find_letters() finds it.
inline constexpr attribute letter_attributes =
    attribute::letter | attribute::word | attribute::line | attribute::pivot | attribute::extent;

}  // namespace typemesh::inline TYPEMESH_ABI

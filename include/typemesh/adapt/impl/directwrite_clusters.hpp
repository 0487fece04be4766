// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/plain_text.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Inverts DirectWrite's map, which gives the first glyph of each unit's cluster (never decreasing, in both
/// directions). The result is the first unit of each glyph's cluster.
inline void invert_cluster_map(std::span<const std::uint16_t> map, std::span<std::uint32_t> units) noexcept
{
    std::size_t glyph = 0, unit = 0;
    for (std::size_t i = 0; i < map.size(); i = unit) {
        for (unit = i + 1; unit < map.size() && map[unit] == map[i];) ++unit;
        const std::size_t end = unit < map.size() ? map[unit] : units.size();
        for (; glyph < end && glyph < units.size(); ++glyph) units[glyph] = static_cast<std::uint32_t>(i);
    }
    for (; glyph < units.size(); ++glyph) units[glyph] = 0;
}

/// Whether a font may lack a glyph for a unit: controls, line breaks, characters that are never drawn.
[[nodiscard]] inline bool draws_nothing(char32_t unit) noexcept
{
    const bool is_control = unit < 0x20 || (unit >= 0x7F && unit < 0xA0);
    return is_control || unit == 0x2028 || unit == 0x2029 || is_default_ignorable(unit);
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

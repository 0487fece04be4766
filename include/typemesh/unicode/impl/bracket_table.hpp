// SPDX-License-Identifier: MIT AND Unicode-3.0
#pragma once

// Made from the Unicode Character Database 17.0.0 by tests/unicode/table_maker.hpp. Copyright 1991-2025 Unicode, Inc.
// https://www.unicode.org/license.html

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

// clang-format off

// Bidi_Paired_Bracket: a closing bracket and its opening one.

inline constexpr std::uint32_t bracket_pairs[] = {
0x00290028, 0x005D005B, 0x007D007B, 0x0F3B0F3A, 0x0F3D0F3C, 0x169C169B, 0x20462045, 0x207E207D, 0x208E208D, 0x23092308,
0x230B230A, 0x232A2329, 0x27692768, 0x276B276A, 0x276D276C, 0x276F276E, 0x27712770, 0x27732772, 0x27752774, 0x27C627C5,
0x27E727E6, 0x27E927E8, 0x27EB27EA, 0x27ED27EC, 0x27EF27EE, 0x29842983, 0x29862985, 0x29882987, 0x298A2989, 0x298C298B,
0x298E298F, 0x2990298D, 0x29922991, 0x29942993, 0x29962995, 0x29982997, 0x29D929D8, 0x29DB29DA, 0x29FD29FC, 0x2E232E22,
0x2E252E24, 0x2E272E26, 0x2E292E28, 0x2E562E55, 0x2E582E57, 0x2E5A2E59, 0x2E5C2E5B, 0x30093008, 0x300B300A, 0x300D300C,
0x300F300E, 0x30113010, 0x30153014, 0x30173016, 0x30193018, 0x301B301A, 0xFE5AFE59, 0xFE5CFE5B, 0xFE5EFE5D, 0xFF09FF08,
0xFF3DFF3B, 0xFF5DFF5B, 0xFF60FF5F, 0xFF63FF62,
};

// clang-format on

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An OpenType feature, switched on (1), off (0) or set to one of its alternates (2, 3, ...): {"liga", 0}.
struct feature {
    char tag[5] = {};  ///< four letters and a terminating zero
    std::uint32_t value = 1;
};

/// Turns the optional ligatures off: see shape_options::ligatures.
inline constexpr feature no_ligatures[] = {{"liga", 0}, {"clig", 0}};

}  // namespace typemesh::inline TYPEMESH_ABI

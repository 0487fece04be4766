// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A place in memory for each type, whose address tells it from all others. Not const: linkers may merge constants.
template <class T>
inline char place_of_type = 0;

}  // namespace typemesh::inline TYPEMESH_ABI::detail

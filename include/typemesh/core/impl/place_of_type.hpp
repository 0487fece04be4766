// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// One variable for each type: its address identifies the type. It is not const, because linkers may merge constants.
template <class T>
inline char place_of_type = 0;

}  // namespace typemesh::inline TYPEMESH_ABI::detail

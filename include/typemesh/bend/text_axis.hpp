// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One of the text's axes in its plane: along the text (x) or up (y).
enum class text_axis : std::uint8_t { along, up };

}  // namespace typemesh::inline TYPEMESH_ABI

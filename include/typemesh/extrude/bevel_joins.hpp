// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How a corner is filled that edges move away from and that is sharper than the mitre limit.
enum class bevel_joins : std::uint8_t { round, bevelled };

}  // namespace typemesh::inline TYPEMESH_ABI

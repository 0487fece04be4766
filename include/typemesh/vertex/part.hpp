// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace typemesh {

/// The parts of a mesh that may carry materials of their own. In the output each part's vertices lie together, and so
/// do each part's indices, in this order.
enum class part : std::uint8_t { front, back, side };

inline constexpr part all_parts[] = {part::front, part::back, part::side};

}  // namespace typemesh

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/look.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/layout/text_item.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// How a glyph of an item is drawn; what it stands for in the text is glyph.cluster.
[[nodiscard]] inline look look_of([[maybe_unused]] const text_item& item, const shaped_glyph& glyph) noexcept
{
    return {.face = glyph.face};
}

}  // namespace typemesh::inline TYPEMESH_ABI

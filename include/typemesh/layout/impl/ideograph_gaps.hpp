// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/impl/ideographic.hpp>
#include <typemesh/layout/impl/shaped_text.hpp>
#include <typemesh/unicode/utf.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a line of Chinese or Japanese grows after a cluster: at a space, and beside an ideograph.
///
///     |han|han|comma|abc def|han|      grows at each | inside the line and at the space
[[nodiscard]] inline bool has_ideograph_gap(const shaped_text& shaped, const text_cluster& c) noexcept
{
    if (has(c.flags, cluster_flags::stretches)) return true;
    if (c.glyph_count == 0 || has(c.flags, cluster_flags::unshown | cluster_flags::foreign)) return false;
    const text_view text = shaped.text();
    if (c.last >= text.size() || has(shaped.analysis.marks[c.last], text_mark::space)) return false;
    return is_ideographic(decode(text, c.first).value) || is_ideographic(decode(text, c.last).value);
}

}  // namespace typemesh::inline TYPEMESH_ABI

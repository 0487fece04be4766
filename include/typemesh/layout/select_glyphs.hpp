// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/layout/glyph_run.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Copies the glyphs of some styles into another run, each to the same place, so that a mesher can make another solid
/// of them:
///
///     mesher.solid().depth = 0.5f;
///     select_glyphs(page, [](style_id s) noexcept { return s == style_id{7}; }, deep);
///     mesher.build(deep, into(vertices, indices));
///
///     keep    bool(style_id); of a run without glyph styles, all glyphs have style 0
///     out     keeps the lines, which may be empty, the glyph styles, and the count of missing glyphs among those that
///             are copied. What the run counts of the whole text (parted, invalid_units, unbroken) is not copied.
///             Must be another run
///
/// Solids of different runs are not merged where they meet.
///
/// Fails  error::no_such_glyph_style, error::out_of_memory; `out` has then no glyphs
/// Cost   O(glyphs + lines + glyph styles)
template <class Keep>
result<void> select_glyphs(const glyph_run& run, const Keep& keep, glyph_run& out) noexcept
{
    TYPEMESH_ASSERT(&run != &out, "glyphs are selected into the run from which they come");
    out.clear();
    out.units_per_em = run.units_per_em;
    const std::size_t count = run.glyphs.size(), styles = run.glyph_styles.size();
    const auto is_kept = [&](const placed_glyph& g) noexcept -> bool {
        return keep(styles == 0 ? style_id{} : run.glyph_styles[g.glyph_style].style);
    };
    for (const placed_glyph& g : run.glyphs)
        if (styles != 0 && g.glyph_style >= styles) return error{error::no_such_glyph_style, styles};
    bool ok = out.glyph_styles.append(run.glyph_styles.view()) && out.lines.append(run.lines.view());
    for (const placed_glyph& g : run.glyphs) {
        if (!ok) break;
        if (!is_kept(g)) continue;
        ok = out.glyphs.push_back(g);
        if (g.missing) out.note_missing(g.cluster);
    }
    if (!ok) {
        out.clear();
        return error::out_of_memory;
    }
    std::uint32_t kept = 0;
    std::size_t read = 0;
    for (text_line& line : out.lines) {
        const auto first = kept;
        for (const std::size_t end = std::size_t{line.first_glyph} + line.glyph_count; read < end && read < count;
             ++read)
            kept += is_kept(run.glyphs[read]) ? 1u : 0u;
        line.first_glyph = first;
        line.glyph_count = kept - first;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI

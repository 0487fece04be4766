// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_shape.hpp>
#include <typemesh/layout/glyph_style.hpp>
#include <typemesh/layout/impl/value_index.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One glyph at its position: `origin` is the position of the glyph's own (0, 0), in font units, y up.
struct placed_glyph {
    glyph_id id = 0;
    cluster_id cluster = 0;
    point origin = {};
    bool missing = false;  ///< whether the font lacks a glyph for this text: `id` is then the font's .notdef, drawn
                           ///< only on request
    std::uint32_t glyph_style = 0;  ///< the index in glyph_run::glyph_styles; 0 if there are none
    float to_middle = 0.0f;  ///< the way along the line from `origin` to the middle of its cluster's advance, in font
                             ///< units; all glyphs of a cluster have one middle. A path turns letters there
    bool joined = false;     ///< whether its script joins letters, which must then not be turned one by one
};

/// One line (or column) of a run: its glyphs, the start of its baseline, its length.
struct text_line {
    std::uint32_t first_glyph = 0;
    std::uint32_t glyph_count = 0;
    point origin = {};     ///< the pen position at the line's start, alignment included
    double advance = 0.0;  ///< the distance that the pen moved, in font units; never negative
    double hanging = 0.0;  ///< the advance of white space at the line's end, which does not count for `advance`
};

/// Shaped text: the input of every stage after shaping. If you make one by hand, you need no shaper.
///
/// Glyphs are in drawing order (left to right in a horizontal line, for any direction of the script). A line's glyphs
/// are contiguous. If you make a run by hand, `lines` may be empty; the run then counts as one line. A run without
/// glyph styles is drawn from one face in one style. `id` is the number of a glyph in its own face.
struct glyph_run {
    buffer<placed_glyph> glyphs;
    buffer<text_line> lines;
    buffer<glyph_style> glyph_styles;  ///< the table for placed_glyph::glyph_style; usually empty
    double units_per_em = 0.0;  ///< the units per em of the source's first face, in which positions are given; 0: the
                                ///< source's own units

    std::uint32_t missing = 0;              ///< the number of glyphs that the font lacks (.notdef is drawn only on
                                            ///< request)
    cluster_id first_missing = no_cluster;  ///< the place of the first missing glyph in the text
    std::uint32_t parted = 0;  ///< the number of emoji of several code points whose parts are drawn one by one, because
                               ///< the font has no glyph for the whole: families, flags, skin tones
    cluster_id first_parted = no_cluster;  ///< the place of the first of these emoji in the text
    std::uint32_t invalid_units = 0;       ///< the number of places where the text was not valid UTF and was read as
                                           ///< U+FFFD
    cluster_id first_invalid_unit = no_cluster;
    std::uint32_t unbroken = 0;  ///< the number of runs of Thai, Lao, Khmer and similar scripts in lines with a width;
                                 ///< lines could end inside these runs, but only a dictionary knows where, and there
                                 ///< was no dictionary
    cluster_id first_unbroken = no_cluster;

    explicit glyph_run(memory source = heap()) noexcept
        : glyphs{source}, lines{source}, glyph_styles{source}, index_{source}
    {
    }

    /// For shapers: counts a missing glyph, for the text at this cluster. Also set placed_glyph::missing.
    void note_missing(cluster_id cluster) noexcept
    {
        ++missing;
        if (cluster < first_missing) first_missing = cluster;
    }
    /// For shapers: counts an emoji that is drawn in parts, at this cluster.
    void note_parted(cluster_id cluster) noexcept
    {
        ++parted;
        if (cluster < first_parted) first_parted = cluster;
    }
    /// For shapers: counts places that were not valid UTF; `first` is the first of them.
    void note_invalid_units(cluster_id first, std::uint32_t count = 1) noexcept
    {
        invalid_units += count;
        if (first < first_invalid_unit) first_invalid_unit = first;
    }

    /// The number by which glyphs refer to a glyph style. If an equal one is in the table, returns its number;
    /// otherwise appends the glyph style. In a table that only this function fills, the plain glyph style has number 0.
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(1) on average
    result<std::uint32_t> number_of(const glyph_style& l) noexcept
    {
        constexpr std::size_t few = 8;  // up to this number, a search without an index is faster
        for (std::size_t i = glyph_styles.size() < few ? glyph_styles.size() : few; i-- > 0;)
            if (glyph_styles[i] == l) return static_cast<std::uint32_t>(i);
        if (glyph_styles.size() > few) {
            if (!index_.read(glyph_styles.view())) return error::out_of_memory;
            const std::size_t found = index_.find(glyph_styles.view(), l);
            if (found < glyph_styles.size()) return static_cast<std::uint32_t>(found);
        }
        const bool plain = l == glyph_style{};
        if (glyph_styles.empty() && plain) return std::uint32_t{0};
        const std::size_t before = glyph_styles.size();
        if ((before == 0 && !glyph_styles.push_back({})) || !glyph_styles.push_back(l)) {
            glyph_styles.truncate(before);
            return error::out_of_memory;
        }
        return static_cast<std::uint32_t>(glyph_styles.size() - 1);
    }

    /// Appends a glyph of this shape, at the origin and in style 0, so that a mesher makes its mesh. The shape must
    /// come from a run of the same font, because its map is in units of that font. Use a mesher without a path: one
    /// with a path leaves out glyphs for which it has no room.
    ///
    /// Fails  error::unknown_glyph: the shape has no glyph; error::out_of_memory
    result<void> add(const glyph_shape& shape) noexcept
    {
        if (shape.id == no_glyph) return error{error::unknown_glyph};
        const result<std::uint32_t> number = number_of({.face = shape.face, .map = shape.map});
        if (!number) return number.error();
        if (!glyphs.push_back({.id = shape.id, .glyph_style = *number})) return error{error::out_of_memory};
        return {};
    }

    void clear() noexcept
    {
        glyphs.clear();
        lines.clear();
        glyph_styles.clear();
        index_.clear();
        units_per_em = 0.0;
        missing = parted = invalid_units = unbroken = 0;
        first_missing = first_parted = first_invalid_unit = first_unbroken = no_cluster;
    }

    /// The glyphs of a line without its bars: backgrounds, which come before its letters, and underlines and the like,
    /// which come after them.
    [[nodiscard]] array_view<const placed_glyph> letters_of(const text_line& line) const noexcept
    {
        std::size_t count = line.glyph_count, first = line.first_glyph;
        while (count > 0 && glyphs[first + count - 1].cluster == no_cluster) --count;
        for (; count > 0 && glyphs[first].cluster == no_cluster; ++first) --count;
        return glyphs.view().subspan(first, count);
    }

    /// Whether a line is a column: its letters follow each other downwards.
    [[nodiscard]] bool is_column(const text_line& line) const noexcept
    {
        const array_view<const placed_glyph> letters = letters_of(line);
        if (letters.empty()) return false;
        const point step = letters.back().origin - letters.front().origin;
        return std::fabs(step.y) > std::fabs(step.x);
    }

private:
    value_index<glyph_style> index_;  // the index of glyph styles, if there are many
};

}  // namespace typemesh::inline TYPEMESH_ABI

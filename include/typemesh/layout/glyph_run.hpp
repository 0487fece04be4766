// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/impl/value_index.hpp>
#include <typemesh/layout/look.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One glyph at its position: `origin` is where the glyph's own (0, 0) goes, in font units, y up.
struct placed_glyph {
    glyph_id id = 0;
    cluster_id cluster = 0;
    point origin = {};
    bool missing = false;    ///< the font has no glyph for this text: `id` is its .notdef, drawn only on request
    std::uint32_t look = 0;  ///< its index in glyph_run::looks; 0 if there are none
};

/// One line (or column) of a run: which glyphs, where its baseline begins, how long it is.
struct text_line {
    std::uint32_t first_glyph = 0;
    std::uint32_t glyph_count = 0;
    point origin = {};     ///< the pen position at the line's start, alignment included
    double advance = 0.0;  ///< how far the pen moved, in font units, never negative
};

/// Shaped text: what every stage after shaping works from. Make one by hand and no shaper is needed.
///
/// Glyphs are in drawing order (left to right in a horizontal line, whatever the script's direction); a line's glyphs
/// are contiguous. A run made by hand may leave `lines` empty: it then counts as one line. A run without looks is drawn
/// from one face in one style. `id` is the number of a glyph in its own face.
struct glyph_run {
    buffer<placed_glyph> glyphs;
    buffer<text_line> lines;
    buffer<look> looks;         ///< what placed_glyph::look refers to; usually empty
    double units_per_em = 0.0;  ///< of the source's first face, the unit of positions; 0: whatever they are there

    std::uint32_t missing = 0;              ///< glyphs that the font lacks (drawn as .notdef only on request)
    cluster_id first_missing = no_cluster;  ///< the position of the first of them in the text
    std::uint32_t parted = 0;  ///< emoji of several code points whose parts are drawn one by one, as the font has no
                               ///< glyph for the whole: see emoji_sequence.hpp
    cluster_id first_parted = no_cluster;  ///< the position of the first of them in the text
    std::uint32_t invalid_units = 0;       ///< places where the text was not valid UTF and U+FFFD was read instead
    cluster_id first_invalid_unit = no_cluster;
    std::uint32_t unbroken = 0;  ///< runs of Thai, Lao, Khmer and the like in lines of a width, which could end inside
                                 ///< but only a dictionary tells where, and there was none
    cluster_id first_unbroken = no_cluster;

    explicit glyph_run(memory source = heap()) noexcept : glyphs{source}, lines{source}, looks{source}, index_{source}
    {
    }

    /// For shapers: counts another missing glyph, for the text at this cluster (besides setting placed_glyph::missing).
    void note_missing(cluster_id cluster) noexcept
    {
        ++missing;
        if (cluster < first_missing) first_missing = cluster;
    }
    /// For shapers: counts another emoji that has fallen apart, at this cluster.
    void note_parted(cluster_id cluster) noexcept
    {
        ++parted;
        if (cluster < first_parted) first_parted = cluster;
    }
    /// For shapers: counts further places that were not valid UTF, the first of them here.
    void note_invalid_units(cluster_id first, std::uint32_t count = 1) noexcept
    {
        invalid_units += count;
        if (first < first_invalid_unit) first_invalid_unit = first;
    }

    /// The number by which glyphs refer to a look: that of an equal one in the table, else of a new one at its end. In
    /// a table made only by this the plain look has number 0.
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(1) on average
    result<std::uint32_t> number_of(const look& l) noexcept
    {
        constexpr std::size_t few = 8;  // quicker without an index
        for (std::size_t i = looks.size() < few ? looks.size() : few; i-- > 0;)
            if (looks[i] == l) return static_cast<std::uint32_t>(i);
        if (looks.size() > few) {
            if (!index_.read(looks.view())) return error::out_of_memory;
            const std::size_t found = index_.find(looks.view(), l);
            if (found < looks.size()) return static_cast<std::uint32_t>(found);
        }
        const bool plain = l == look{};
        if (looks.empty() && plain) return std::uint32_t{0};
        const std::size_t before = looks.size();
        if ((before == 0 && !looks.push_back({})) || !looks.push_back(l)) {
            looks.truncate(before);
            return error::out_of_memory;
        }
        return static_cast<std::uint32_t>(looks.size() - 1);
    }

    void clear() noexcept
    {
        glyphs.clear();
        lines.clear();
        looks.clear();
        index_.clear();
        units_per_em = 0.0;
        missing = parted = invalid_units = unbroken = 0;
        first_missing = first_parted = first_invalid_unit = first_unbroken = no_cluster;
    }

private:
    value_index<look> index_;  // of looks, once there are many
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A failure: what went wrong, and where. The library reports failures in no other way; nothing throws.
///
/// Functions that you call return a result (result.hpp), which is true on success and otherwise has an error. Functions
/// that you write for the library (in a policy, a font or a sink) return an error: `return {};` on success, and
/// otherwise for example `return error::out_of_memory;`. `message()` is a plain sentence.
struct [[nodiscard]] error {
    /// What went wrong.
    enum kind : std::uint8_t {
        none,
        out_of_memory,        ///< the memory source returned null
        buffer_too_small,     ///< the caller's vertices or indices do not fit; count = the number needed
        index_overflow,       ///< the index type cannot number the vertices; count = the number of vertices
        too_large,            ///< more than 2^32 - 1 vertices, points or characters
        unreadable_file,      ///< the file cannot be opened or read
        not_a_font,           ///< the font library does not recognise the bytes as a font
        no_such_face,         ///< the file or outline source has no face with that number; count = the number of faces
        no_such_look,         ///< a glyph names a look that its run's table does not have; count = the number of looks
        other_units,          ///< the run and the font that draws it have different units per em
        no_such_family,       ///< no font of that family is installed or in the given collection
        no_such_style,        ///< the family has no font of that style; `option` names the property
        no_font,              ///< a text_mesher has no font yet
        not_a_shaper,         ///< a text was given to a font that only draws: give it a glyph_run
        unlocked_cache,       ///< several workers share a glyph_cache without a lock
        no_cache_key,         ///< a policy with data members has no cache_key(), which a glyph_cache needs
        no_outlines,          ///< the font has only bitmaps, or is not scalable
        unknown_glyph,        ///< the font has no such glyph, or its outline cannot be loaded
        unknown_variation,    ///< the font has no such axis; count = its tag, first letter in the highest bits
        bad_feature,          ///< the tag of an OpenType feature is not four printable ASCII characters
        bad_outline,          ///< a contour does not start with move(), or a similar mistake
        outline_not_finite,   ///< an outline contains NaN or infinity
        outline_beyond_grid,  ///< an outline is too large for the integer grid
        too_many_pieces,      ///< contours cross more often than the caller allows; count = the limit
        too_many_points,      ///< an outline has more curves or points than the caller allows; count = the limit
        crossing_contours,    ///< contours cross, touch or overlap where they must not; count: see triangulator.hpp
        nothing_left,         ///< the glyph is thinner everywhere than the amount taken off
        edges_not_moved,      ///< a glyph's moved edges cross on the grid, for any part of the distance
        bad_tolerance,        ///< a tolerance is not a positive finite number
        bad_option,           ///< an option is outside its range; `option` names it
        overlapping_spans,    ///< two spans of a text's styles contain the same character
        needs_paragraph,      ///< plain text has no such option; `option` names it
        needs_shaping,        ///< the plain shaper cannot set this script correctly
        font_library_failed,  ///< FreeType, HarfBuzz or DirectWrite refused; count = its own error number, if any
        not_written,          ///< a sink could not store all of its input, for example because the disk is full
        refused_by_user,      ///< for the caller's own policies
    };

    kind code = none;                 ///< what went wrong
    glyph_id glyph = no_glyph;        ///< the glyph concerned, or no_glyph
    cluster_id cluster = no_cluster;  ///< its position in the caller's text, or no_cluster
    std::uint64_t count = 0;          ///< described beside each code
    const char* option = nullptr;     ///< the name of the bad option, or of the buffer that is too small

    constexpr error() noexcept = default;
    constexpr error(kind k, std::uint64_t how_many = 0) noexcept : code{k}, count{how_many} {}

    /// error::bad_option with the option's name, which must live as long as the program.
    [[nodiscard]] static constexpr error bad(const char* option) noexcept
    {
        error e = bad_option;
        e.option = option;
        return e;
    }

    /// error::unknown_variation with the axis's tag.
    [[nodiscard]] static constexpr error no_axis(const char (&tag)[5]) noexcept
    {
        std::uint64_t letters = 0;
        for (int i = 0; i < 4; ++i) letters = letters << 8 | static_cast<unsigned char>(tag[i]);
        return {unknown_variation, letters};
    }

    /// error::buffer_too_small: `needed` elements of `what` are needed.
    [[nodiscard]] static constexpr error short_of(const char* what, std::uint64_t needed) noexcept
    {
        error e{buffer_too_small, needed};
        e.option = what;
        return e;
    }

    /// True if something went wrong.
    [[nodiscard]] explicit constexpr operator bool() const noexcept { return code != none; }
    friend constexpr bool operator==(const error& e, kind k) noexcept { return e.code == k; }

    /// The same error, attributed to this glyph.
    [[nodiscard]] constexpr error at(glyph_id g, cluster_id c) const noexcept
    {
        error e = *this;
        e.glyph = g;
        e.cluster = c;
        return e;
    }

    /// One sentence, without numbers. It is never null and lives as long as the program.
    [[nodiscard]] constexpr const char* message() const noexcept
    {
        switch (code) {
        case none: return "No error.";
        case out_of_memory: return "The memory source has no more memory.";
        case buffer_too_small: return "The caller's buffer is too small for the mesh.";
        case index_overflow:
            return "The index type cannot number so many vertices; use 32-bit indices, or text_chunks.";
        case too_large: return "The text is too large: points, vertices and indices are numbered with 32 bits.";
        case unreadable_file: return "The font file cannot be opened or read.";
        case not_a_font: return "The data is not a font, or is damaged.";
        case no_such_face: return "There is no face with that number in the font file or among the given fonts.";
        case no_such_look: return "A glyph names a look that the table of its glyph_run does not hold.";
        case other_units: return "The glyph_run was made for a font with other units per em.";
        case no_such_family: return "No font of this family is installed or in the given collection.";
        case no_such_style: return "No installed font of the family has this style.";
        case no_font: return "The mesher has no font yet.";
        case not_a_shaper: return "The font only draws: text needs a font that shapes it, or a glyph_run.";
        case unlocked_cache:
            return "A glyph_workers needs a glyph_cache with a lock: glyph_cache<mutex_lock>, or one of your own.";
        case no_cache_key:
            return "A policy with data members needs a cache_key() for its glyphs to be kept in a cache.";
        case no_outlines: return "The font has no outlines (it holds bitmaps only).";
        case unknown_glyph: return "The font has no such glyph, or its outline cannot be loaded.";
        case unknown_variation: return "The font has no such variation axis.";
        case bad_feature: return "The tag of an OpenType feature is not four printable ASCII characters.";
        case bad_outline: return "The outline is malformed: a contour must begin with move().";
        case outline_not_finite: return "The outline holds a coordinate that is not a finite number.";
        case outline_beyond_grid: return "The outline is too large for the integer grid.";
        case too_many_pieces: return "The contours cross more often than max_pieces allows.";
        case too_many_points: return "The outline has more points than max_points allows.";
        case crossing_contours: return "Contours of the outline cross, touch or overlap.";
        case nothing_left: return "Nothing is left of the glyph: it is thinner than what is taken off.";
        case edges_not_moved: return "The glyph's edges cannot be moved: once moved, they cross on the grid.";
        case bad_tolerance: return "The tolerance is not a positive finite number.";
        case bad_option: return "An option is outside its range.";
        case overlapping_spans: return "Two spans of styles hold the same character.";
        case needs_paragraph:
            return "Plain text ends its lines only at line breaks: give this option to a paragraph.";
        case needs_shaping:
            return "The text needs a real shaper (HarfBuzz, DirectWrite): a character map and kerning cannot set its "
                   "script.";
        case font_library_failed: return "The font library refused the request.";
        case not_written: return "The mesh could not be written to its end: the disk may be full.";
        case refused_by_user: return "A policy of the caller's own refused.";
        }
        return "Unknown error.";
    }
};

/// Writes the sentence with its numbers into `out`. The text is always zero-terminated, and truncated if it does not
/// fit (200 characters always suffice). Returns out.data(), or "" if `out` is empty.
///
///     glyph 37, cluster 4: Contours of the outline cross, touch or overlap.
///     The caller's buffer is too small for the mesh. (needed: 720 vertices)
///     The font has no such variation axis. (wdth)
inline const char* describe(const error& e, std::span<char> out) noexcept
{
    if (out.empty()) return "";
    std::size_t size = 0;
    const auto put = [&](const char* words) noexcept {
        while (*words != '\0' && size + 1 < out.size()) out[size++] = *words++;
    };
    const auto put_number = [&](const char* before, std::uint64_t n) noexcept {
        char digits[21] = {}, *first = digits + 20;
        do *--first = static_cast<char>('0' + n % 10);
        while ((n /= 10) != 0);
        put(before);
        put(first);
    };
    const bool has_glyph = e.glyph != no_glyph, has_cluster = e.cluster != no_cluster;
    if (has_glyph) put_number("glyph ", e.glyph);
    if (has_cluster) put_number(has_glyph ? ", cluster " : "cluster ", e.cluster);
    if (has_glyph || has_cluster) put(": ");
    put(e.message());
    const char* what = e.option != nullptr ? e.option : "";
    const auto before = [&e]() noexcept {
        if (e == error::buffer_too_small) return " (needed: ";
        if (e == error::index_overflow) return " (vertices: ";
        if (e == error::no_such_face) return " (faces: ";
        if (e == error::no_such_look) return " (it holds: ";
        if (e == error::too_many_pieces || e == error::too_many_points) return " (the limit: ";
        return e == error::font_library_failed ? " (its error: " : " (";
    };
    if (e == error::unknown_variation && e.count != 0) {
        put(" (");
        for (int shift = 24; shift >= 0; shift -= 8) {
            const char letter[] = {static_cast<char>(e.count >> shift), '\0'};
            put(letter);
        }
    } else if (e.count != 0) {
        put_number(before(), e.count);
    }
    if (*what != '\0') {
        put(e.count != 0 ? " " : " (");
        put(what);
    }
    if (e.count != 0 || *what != '\0') put(")");
    out[size] = '\0';
    return out.data();
}

}  // namespace typemesh::inline TYPEMESH_ABI

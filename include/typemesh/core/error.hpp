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
/// otherwise for example `return error::out_of_memory;`. `message()` is one plain sentence that says what is wrong and
/// what to do.
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
        no_such_glyph_style,  ///< a glyph names a glyph style that its run's table does not have; count = how many
                              ///< the table has
        other_units,          ///< the run and the font that draws it disagree in their units per em
        no_such_family,       ///< no font of that family is installed or in the given collection
        no_such_style,        ///< the family has no font of that style; `option` names the property
        no_font,              ///< a text_mesher has no font yet
        not_a_shaper,         ///< the font only draws outlines and cannot shape a text: give a glyph_run instead
        unlocked_cache,       ///< several workers share a glyph_cache without a lock
        no_cache_key,         ///< a policy with data members has no cache_key(), which a glyph_cache needs
        no_outlines,          ///< the font has no outlines, because it has only bitmaps, for example
        unknown_glyph,        ///< the font has no such glyph, or its outline cannot be loaded
        unknown_variation,    ///< the font has no such axis; count = its tag, first letter in the highest bits
        bad_feature,          ///< the tag of an OpenType feature is not four printable ASCII characters
        bad_outline,          ///< a contour does not start with move(), or a similar mistake
        outline_not_finite,   ///< an outline contains NaN or infinity
        outline_beyond_grid,  ///< an outline is too large for the integer grid
        too_many_pieces,      ///< contours cross more often than the caller allows; count = the limit
        too_many_points,      ///< an outline has more curves or points than the caller allows; count = the limit
        crossing_contours,    ///< contours cross, touch or overlap where they must not; count: see triangulator.hpp
        nothing_left,         ///< the glyph is everywhere thinner than the thickness that is removed
        edges_not_moved,      ///< a glyph's edges cannot be moved: on the grid they cross, even if moved less far
        folds_over,           ///< a deformation turns letters inside out, or would need to bend them too tightly
        unknown_letters,      ///< letters are moved, or their data is wanted, and find_letters() was not called
        goes_around,          ///< a text is longer than the circumference or the curve that it follows
        bad_tolerance,        ///< a tolerance is not a positive finite number
        bad_option,           ///< an option is outside its range; `option` names it
        overlapping_spans,    ///< two spans of a text's styles contain the same character
        bad_markup,           ///< a tag of a text's mark-up is wrong; `option` says what, cluster is its place
        bad_path,             ///< path data has a mistake; `option` says what, count is its place (1: the first byte)
        bad_colours,          ///< a font's colour table is damaged, or describes a glyph in too many steps
        needs_paragraph,      ///< plain text has no such option; `option` names it
        needs_shaping,        ///< the plain shaper cannot set this script correctly
        font_library_failed,  ///< FreeType, HarfBuzz or DirectWrite refused; count = its own error number, if any
        not_written,          ///< a sink could not store all of its input, for example because the disk is full
        refused_by_user,      ///< a refusal by one of the caller's own policies
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

    /// This error, attributed to a glyph and a place in the text.
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
        case none: return "There is no error.";
        case out_of_memory: return "The memory source has no more memory: free some, or give another source.";
        case buffer_too_small: return "The buffer is too small for the mesh: give a larger one.";
        case index_overflow: return "The index type cannot number all vertices: use 32-bit indices or text_chunks.";
        case too_large: return "The text is too large for numbers of 32 bits: split it into several meshes.";
        case unreadable_file: return "The font file cannot be opened or read: check its path and its permissions.";
        case not_a_font: return "The data is not a font, or it is damaged: give another font file.";
        case no_such_face: return "There is no face with that number: count faces from 0, and choose one that exists.";
        case no_such_glyph_style:
            return "A glyph names a glyph style that its glyph_run does not contain: add it to the glyph styles.";
        case other_units: return "The glyph_run and the font have different units per em: use the run's own font.";
        case no_such_family: return "No font of this family is installed or given: check the family's name.";
        case no_such_style: return "The family has no font of this style: choose another style.";
        case no_font: return "The mesher has no font yet: give it one with use().";
        case not_a_shaper: return "The font only draws glyphs: give a font that shapes text, or a glyph_run.";
        case unlocked_cache:
            return "Several workers share a glyph_cache without a lock: use for example glyph_cache<mutex_lock>.";
        case no_cache_key: return "A policy with data members has no cache_key(): add one, or build without a cache.";
        case no_outlines: return "The font has no outlines (glyf, CFF or CFF2): choose a font with outlines.";
        case unknown_glyph: return "The font has no such glyph or cannot load its outline: check the glyph's number.";
        case unknown_variation: return "The font has no such variation axis: choose one of its own axes.";
        case bad_feature: return "An OpenType feature has a bad tag: write four printable ASCII characters.";
        case bad_outline: return "The outline is malformed: begin each contour with move().";
        case outline_not_finite: return "The outline contains NaN or infinity: correct the font or its transform.";
        case outline_beyond_grid: return "The outline is too large for the integer grid: make it smaller.";
        case too_many_pieces: return "The contours cross more often than max_pieces allows: raise max_pieces.";
        case too_many_points: return "The outline has more points than max_points allows: raise max_points.";
        case crossing_contours: return "Contours of the outline cross, touch or overlap: resolve them first.";
        case nothing_left: return "Nothing is left of the glyph, which is too thin: take off less.";
        case edges_not_moved: return "The glyph's edges cross on the grid after any move: do not move them.";
        case folds_over: return "The deformation folds the letters: bend them less, or make them smaller.";
        case unknown_letters: return "Nobody has looked for the letters: call find_letters() of the plan, then write.";
        case goes_around: return "The text is longer than the circumference or curve that it follows: shorten it.";
        case bad_tolerance: return "The tolerance is not a positive finite number: give for example quality::high.";
        case bad_option: return "An option is outside its range: give a value within the documented range.";
        case overlapping_spans: return "Two spans of styles overlap: end one where the other begins.";
        case bad_markup: return "The mark-up has a mistake: correct the tag, or write [[ for a bracket of the text.";
        case bad_path: return "The path data has a mistake: correct it at the place that is given.";
        case bad_colours: return "The font's colour table is damaged or too complex: draw the glyph without colours.";
        case needs_paragraph: return "Plain text ends lines only at line breaks: give this option to a paragraph.";
        case needs_shaping:
            return "A character map and kerning cannot set this script: shape the text with HarfBuzz or DirectWrite.";
        case font_library_failed: return "The font library refused the request: check the font.";
        case not_written: return "The mesh could not be written to its end: check the free space on the disk.";
        case refused_by_user: return "One of your own policies refused: look there for the reason.";
        }
        return "The error's code is unknown: check where the error was made.";
    }
};

/// Writes the sentence with its numbers into `out`. The text is always zero-terminated, and truncated if it does not
/// fit (200 characters always suffice). Returns out.data(), or "" if `out` is empty.
///
///     glyph 37, cluster 4: Contours of the outline cross, touch or overlap: resolve them first.
///     The buffer is too small for the mesh: give a larger one. (needed: 720 vertices)
///     The font has no such variation axis: choose one of its own axes. (wdth)
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
        if (e == error::no_such_glyph_style) return " (glyph styles: ";
        if (e == error::bad_path) return " (byte ";
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
        put(e.count == 0 ? " (" : e == error::bad_path ? ": " : " ");
        put(what);
    }
    if (e.count != 0 || *what != '\0') put(")");
    out[size] = '\0';
    return out.data();
}

}  // namespace typemesh::inline TYPEMESH_ABI

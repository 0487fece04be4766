// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <vector>

namespace text_to_mesh {
namespace {

/// Kerning may stand in a table of its own.
bool has_kern_table(hb_face_t* face)
{
    hb_blob_t* table = hb_face_reference_table(face, HB_TAG('k', 'e', 'r', 'n'));
    const unsigned bytes = hb_blob_get_length(table);
    hb_blob_destroy(table);
    return bytes != 0;
}

bool has_feature(hb_face_t* face, hb_tag_t tag)
{
    if (tag == HB_TAG('k', 'e', 'r', 'n') && has_kern_table(face)) return true;
    for (const hb_tag_t table : {HB_OT_TAG_GSUB, HB_OT_TAG_GPOS}) {
        hb_tag_t tags[32];
        unsigned count = 32;
        for (unsigned start = 0; count == 32; start += count) {
            hb_ot_layout_table_get_feature_tags(face, table, start, &count, tags);
            for (unsigned i = 0; i < count; ++i)
                if (tags[i] == tag) return true;
        }
    }
    return false;
}

bool is_in(const font_set& fonts, char32_t character)
{
    hb_codepoint_t glyph = 0;
    for (std::uint32_t face = 0; face < fonts.face_count(); ++face)
        if (hb_font_get_nominal_glyph(fonts.font(face).handle(), character, &glyph)) return true;
    return false;
}

bool is_one_of(char32_t character, std::initializer_list<hb_unicode_general_category_t> categories)
{
    const auto own = hb_unicode_general_category(hb_unicode_funcs_get_default(), character);
    return std::find(categories.begin(), categories.end(), own) != categories.end();
}

/// Skin tones of emoji are marks, too.
bool is_mark(char32_t character)
{
    return (character >= 0x1F3FB && character <= 0x1F3FF) ||
           is_one_of(character, {HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK, HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK,
                                 HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK});
}

/// Controls, joiners and variation selectors, for which a font needs no glyph.
bool is_ignorable(char32_t character)
{
    return (character >= 0xFE00 && character <= 0xFE0F) || (character >= 0xE0100 && character <= 0xE01EF) ||
           is_one_of(character, {HB_UNICODE_GENERAL_CATEGORY_CONTROL, HB_UNICODE_GENERAL_CATEGORY_FORMAT});
}

/// Not a mark, which would stand on the character before it.
bool is_printable(char32_t character)
{
    return !is_mark(character) && !is_ignorable(character) &&
           !is_one_of(character,
                      {HB_UNICODE_GENERAL_CATEGORY_UNASSIGNED, HB_UNICODE_GENERAL_CATEGORY_PRIVATE_USE,
                       HB_UNICODE_GENERAL_CATEGORY_SURROGATE, HB_UNICODE_GENERAL_CATEGORY_LINE_SEPARATOR,
                       HB_UNICODE_GENERAL_CATEGORY_PARAGRAPH_SEPARATOR, HB_UNICODE_GENERAL_CATEGORY_SPACE_SEPARATOR});
}

std::string in_utf8(char32_t c)
{
    const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
    const auto tail = [&](int shift) { return byte(0x80 | (c >> shift & 0x3F)); };
    if (c < 0x80) return {byte(c)};
    if (c < 0x800) return {byte(0xC0 | c >> 6), tail(0)};
    if (c < 0x10000) return {byte(0xE0 | c >> 12), tail(6), tail(0)};
    return {byte(0xF0 | c >> 18), tail(12), tail(6), tail(0)};
}

/// " (U+8336 and 3 more)", or nothing.
std::string in_brackets(std::u32string_view characters)
{
    constexpr std::size_t max_named = 8;
    std::string all;
    for (std::size_t i = 0; i < characters.size() && i < max_named; ++i)
        all += (i == 0 ? " (" : ", ") + name_of(characters[i]);
    if (characters.size() > max_named) all += " and " + std::to_string(characters.size() - max_named) + " more";
    return all.empty() ? all : all + ")";
}

}  // namespace

std::string in_words(const typemesh::error& e)
{
    std::string where;
    if (e.glyph != typemesh::no_glyph) where = "glyph " + std::to_string(e.glyph);
    if (e.cluster != typemesh::no_cluster)
        where += (where.empty() ? "at byte " : ", at byte ") + std::to_string(e.cluster) + " of the text";
    char sentence[256];
    return (where.empty() ? "" : where + ": ") +
           typemesh::describe(e.at(typemesh::no_glyph, typemesh::no_cluster), sentence);
}

std::string name_of(char32_t character)
{
    char number[16];
    std::snprintf(number, sizeof number, "U+%04X", static_cast<unsigned>(character));
    if (!is_printable(character)) return number;
    return std::string{number} + " " + in_utf8(character);
}

std::u32string missing_characters(const typemesh::glyph_run& run, const std::string& text, const font_set& fonts)
{
    std::vector<std::size_t> starts, missing;  // clusters
    for (const typemesh::placed_glyph& g : run.glyphs) {
        starts.push_back(g.cluster);
        if (g.missing) missing.push_back(g.cluster);
    }
    std::sort(starts.begin(), starts.end());
    std::sort(missing.begin(), missing.end());
    std::u32string all;
    for (std::size_t place : missing) {
        const auto next = std::upper_bound(starts.begin(), starts.end(), place);
        const std::size_t end = next == starts.end() ? text.size() : std::min(*next, text.size());
        bool found = false;
        while (place < end) {  // up to the first that is missing, and the marks on it
            const typemesh::code_point c = typemesh::decode(text, place, end);
            place = c.next;
            if (found && !is_mark(c.value)) break;
            if (is_ignorable(c.value) || is_in(fonts, c.value)) continue;
            found = true;
            if (all.find(c.value) == std::u32string::npos) all += c.value;
        }
    }
    return all;
}

std::string in_words(const typemesh::text_report& report, bool several_fonts, const std::string& who,
                     std::u32string_view missing)
{
    std::string all;
    const auto number = [](std::uint32_t n) { return std::to_string(n); };
    const auto say = [&](const std::string& line) { all += who + line + "\n"; };
    const auto at = [&](typemesh::cluster_id place) {
        return "; the first is at byte " + number(place) + " of the text.";
    };
    const std::string of_all = " of " + number(report.glyphs);
    if (report.refused > 0)
        say(number(report.refused) + of_all + (report.refused == 1 ? " glyphs is" : " glyphs are") +
            " left out; the first is " + in_words(report.first_refusal));
    if (report.missing > 0)
        say((several_fonts ? "no font has a glyph for " : "the font has no glyph for ") + number(report.missing) +
            of_all + " characters" + in_brackets(missing) + at(report.first_missing) +
            (several_fonts ? " Add another font with --fallback."
                           : " Give another --font, or add a font with --fallback."));
    if (report.parted > 0)
        say(number(report.parted) + " of them " +
            (report.parted == 1 ? "is an emoji whose parts are" : "are emoji whose parts are") +
            " drawn one by one, because " + (several_fonts ? "no font has" : "the font has no") +
            (several_fonts ? " a glyph for the whole" : " glyph for the whole") + at(report.first_parted));
    if (report.invalid_units > 0)
        say("the text is not valid UTF-8 at " + number(report.invalid_units) +
            (report.invalid_units == 1 ? " place" : " places") + at(report.first_invalid_unit));
    if (report.off_path > 0)
        say(number(report.off_path) + of_all + (report.off_path == 1 ? " glyphs has" : " glyphs have") +
            " no room on the --path" + at(report.first_off_path));
    if (report.unbroken > 0)
        say("the program has no dictionary for the words of " + number(report.unbroken) +
            (report.unbroken == 1 ? " run" : " runs") +
            " of Thai, Lao, Khmer, Burmese or a similar script, so lines end there only where they must" +
            at(report.first_unbroken));
    if (report.narrowed > 0)
        say("the edges of " + number(report.narrowed) + of_all +
            " glyphs have moved less than --bevel, --outline, --embolden or --tube request" +
            at(report.first_narrowed));
    if (report.touching > 0)
        say("the corners of " + number(report.touching) + of_all + " glyphs still touch in spite of --touching" +
            at(report.first_touching));
    if (report.lost_caps > 0)
        say("bevels meet in a ridge on " + number(report.lost_caps) + (report.lost_caps == 1 ? " piece" : " pieces") +
            " of glyphs that are smaller than the tolerance" + at(report.first_lost_cap));
    return all;
}

bool name_losses(const typemesh::text_report& report, bool several_fonts, const std::string& who,
                 std::u32string_view missing)
{
    const std::string losses = in_words(report, several_fonts, who, missing);
    std::fputs(losses.c_str(), stderr);
    return !losses.empty();
}

bool name_missing_features(const font_set& fonts, std::span<const typemesh::feature> wanted, const std::string& who)
{
    bool missing = false;
    for (const typemesh::feature& f : wanted) {
        bool found = f.value == 0;
        for (std::uint32_t face = 0; face < fonts.face_count(); ++face)
            found = found || has_feature(hb_font_get_face(fonts.font(face).handle()), hb_tag_from_string(f.tag, 4));
        if (found) continue;
        std::fprintf(stderr, "%s%s feature %s: leave it out, or give another --font.\n", who.c_str(),
                     fonts.face_count() > 1 ? "no font has" : "the font has no", f.tag);
        missing = true;
    }
    return missing;
}

bool name_flipped_triangles(std::uint64_t flipped, bool instances_help, const std::string& who)
{
    if (flipped == 0) return false;
    std::fprintf(stderr,
                 "%s%llu triangles of each face are turned over or flat, because 32-bit numbers are too coarse "
                 "so far from the origin: make the lines shorter%s.\n",
                 who.c_str(), static_cast<unsigned long long>(flipped), instances_help ? ", or give --instances" : "");
    return true;
}

}  // namespace text_to_mesh

// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <hb-ot.h>

#include <cstdio>

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

}  // namespace

std::string in_words(const typemesh::error& e)
{
    if (e.code == typemesh::error::mixed_direction)
        return "at byte " + std::to_string(e.cluster) +
               " of the text: a line holds both left-to-right and right-to-left text (digits count as left-to-right); "
               "make two texts of it.";
    std::string where;
    if (e.glyph != typemesh::no_glyph) where = "glyph " + std::to_string(e.glyph);
    if (e.cluster != typemesh::no_cluster)
        where += (where.empty() ? "at byte " : ", at byte ") + std::to_string(e.cluster) + " of the text";
    char sentence[256];
    return (where.empty() ? "" : where + ": ") +
           typemesh::describe(e.at(typemesh::no_glyph, typemesh::no_cluster), sentence);
}

bool name_losses(const typemesh::text_report& report)
{
    if (report.refused > 0)
        std::fprintf(stderr, "text_to_mesh: %u of %u glyphs left out; the first: %s\n", report.refused, report.glyphs,
                     in_words(report.first_refusal).c_str());
    if (report.missing > 0)
        std::fprintf(
            stderr,
            "text_to_mesh: the font has no glyph for %u of %u characters; the first is at byte %u of the text.\n",
            report.missing, report.glyphs, report.first_missing);
    if (report.invalid_units > 0)
        std::fprintf(stderr,
                     "text_to_mesh: the text is not valid UTF-8 at %u place%s; the first is at byte %u of the text.\n",
                     report.invalid_units, report.invalid_units == 1 ? "" : "s", report.first_invalid_unit);
    return !report.complete();
}

bool name_missing_features(const typemesh::harfbuzz_font& font, std::span<const typemesh::feature> wanted)
{
    bool missing = false;
    for (const typemesh::feature& f : wanted) {
        if (f.value == 0 || has_feature(hb_font_get_face(font.handle()), hb_tag_from_string(f.tag, 4))) continue;
        std::fprintf(stderr, "text_to_mesh: the font has no feature %s.\n", f.tag);
        missing = true;
    }
    return missing;
}

bool name_flipped_triangles(std::uint64_t flipped, bool instances_help)
{
    if (flipped == 0) return false;
    std::fprintf(stderr,
                 "text_to_mesh: %llu triangles of each face are turned over or flat, for 32-bit numbers are too coarse "
                 "so far from the origin; shorter lines help%s.\n",
                 static_cast<unsigned long long>(flipped), instances_help ? ", and so does --instances" : "");
    return true;
}

}  // namespace text_to_mesh

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
    std::string where;
    if (e.glyph != typemesh::no_glyph) where = "glyph " + std::to_string(e.glyph);
    if (e.cluster != typemesh::no_cluster)
        where += (where.empty() ? "at byte " : ", at byte ") + std::to_string(e.cluster) + " of the text";
    char sentence[256];
    return (where.empty() ? "" : where + ": ") +
           typemesh::describe(e.at(typemesh::no_glyph, typemesh::no_cluster), sentence);
}

std::string in_words(const typemesh::text_report& report, bool several_fonts, const std::string& who)
{
    std::string all;
    const auto number = [](std::uint32_t n) { return std::to_string(n); };
    const auto say = [&](const std::string& line) { all += who + line + "\n"; };
    const auto at = [&](typemesh::cluster_id place) {
        return "; the first is at byte " + number(place) + " of the text.";
    };
    const std::string of_all = " of " + number(report.glyphs);
    if (report.refused > 0)
        say(number(report.refused) + of_all + " glyphs left out; the first: " + in_words(report.first_refusal));
    if (report.missing > 0)
        say((several_fonts ? "no font has a glyph for " : "the font has no glyph for ") + number(report.missing) +
            of_all + " characters" + at(report.first_missing));
    if (report.parted > 0)
        say(number(report.parted) + " of them " +
            (report.parted == 1 ? "is an emoji whose parts are" : "are emoji whose parts are") +
            " drawn one by one, as " + (several_fonts ? "no font has" : "the font has no") +
            (several_fonts ? " a glyph for the whole" : " glyph for the whole") + at(report.first_parted));
    if (report.invalid_units > 0)
        say("the text is not valid UTF-8 at " + number(report.invalid_units) +
            (report.invalid_units == 1 ? " place" : " places") + at(report.first_invalid_unit));
    if (report.unbroken > 0)
        say("no dictionary tells where the words end in " + number(report.unbroken) +
            (report.unbroken == 1 ? " run" : " runs") +
            " of Thai, Lao, Khmer, Burmese or the like, so lines end there only where they must" +
            at(report.first_unbroken));
    if (report.narrowed > 0)
        say("edges of " + number(report.narrowed) + of_all +
            " glyphs have moved less than --bevel, --outline or --embolden ask for" + at(report.first_narrowed));
    if (report.touching > 0)
        say("corners of " + number(report.touching) + of_all + " glyphs still touch, whatever --touching asks for" +
            at(report.first_touching));
    if (report.lost_caps > 0)
        say("bevels meet in a ridge on " + number(report.lost_caps) + (report.lost_caps == 1 ? " piece" : " pieces") +
            " of glyphs smaller than the tolerance" + at(report.first_lost_cap));
    return all;
}

bool name_losses(const typemesh::text_report& report, bool several_fonts, const std::string& who)
{
    const std::string losses = in_words(report, several_fonts, who);
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
        std::fprintf(stderr, "%s%s feature %s.\n", who.c_str(),
                     fonts.face_count() > 1 ? "no font has" : "the font has no", f.tag);
        missing = true;
    }
    return missing;
}

bool name_flipped_triangles(std::uint64_t flipped, bool instances_help, const std::string& who)
{
    if (flipped == 0) return false;
    std::fprintf(stderr,
                 "%s%llu triangles of each face are turned over or flat, for 32-bit numbers are too coarse "
                 "so far from the origin; shorter lines help%s.\n",
                 who.c_str(), static_cast<unsigned long long>(flipped),
                 instances_help ? ", and so does --instances" : "");
    return true;
}

}  // namespace text_to_mesh

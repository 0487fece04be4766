// SPDX-License-Identifier: MIT
#pragma once

#include "unicode/character_database.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// Makes the headers include/typemesh/unicode/impl/*_table.hpp. The tests "[tables]" compare them with the headers in the
// tree, or write them if TYPEMESH_MAKE_TABLES is set in the environment.
namespace ucd {

using numbers = std::vector<std::uint64_t>;

/// The place of a name in a list, which has the order of an enumeration.
inline std::uint64_t number_of(const std::vector<std::string>& names, const std::string& name)
{
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) FAIL(name << " is unknown");
    return static_cast<std::uint64_t>(found - names.begin());
}

inline std::string hex(std::uint64_t value, int digits)
{
    std::string s;
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) s += "0123456789ABCDEF"[value >> shift & 15];
    return "0x" + s;
}

/// An array of words.
inline std::string array_of(const std::string& type, const std::string& name, const numbers& values, int digits)
{
    const std::size_t a_row = 120 / (static_cast<std::size_t>(digits) + 4);
    std::string s = "inline constexpr " + type + " " + name + "[] = {";
    for (std::size_t i = 0; i < values.size(); ++i) s += (i % a_row == 0 ? "\n" : " ") + hex(values[i], digits) + ",";
    return s + "\n};\n";
}

/// Small numbers, several in a word of 64 bits: fewer words compile sooner.
inline numbers packed(const numbers& values, int bits)
{
    const std::size_t a_word = 64 / static_cast<std::size_t>(bits);
    numbers words((values.size() + a_word - 1) / a_word);
    for (std::size_t i = 0; i < values.size(); ++i)
        words[i / a_word] |= values[i] << (i % a_word * static_cast<std::size_t>(bits));
    return words;
}

/// Cuts values into blocks; returns the number of each block. Equal blocks have equal numbers.
inline numbers blocks(const numbers& values, std::size_t size, numbers& different)
{
    // Not a < b: in libstdc++ 12 it compares too few bytes if the high byte comes first.
    const auto less = [](const numbers& a, const numbers& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::map<numbers, std::uint64_t, decltype(less)> known{less};
    numbers which;
    for (std::size_t i = 0; i < values.size(); i += size) {
        const numbers block(values.begin() + static_cast<std::ptrdiff_t>(i),
                            values.begin() + static_cast<std::ptrdiff_t>(i + size));
        const auto [at, fresh] = known.try_emplace(block, known.size());
        if (fresh) different.insert(different.end(), block.begin(), block.end());
        which.push_back(at->second);
    }
    return which;
}

inline std::string header(const std::string& includes, const std::string& about, const std::string& arrays)
{
    return "// SPDX-License-Identifier: MIT AND Unicode-3.0\n#pragma once\n\n// Made from the Unicode Character "
           "Database " +
           version +
           " by tests/unicode/table_maker.hpp. Copyright 1991-2025 Unicode, Inc.\n"
           "// https://www.unicode.org/license.html\n\n" +
           includes + "\nnamespace typemesh::inline TYPEMESH_ABI::detail {\n\n// clang-format off\n\n" + about +
           arrays + "\n// clang-format on\n\n}  // namespace typemesh::inline TYPEMESH_ABI::detail\n";
}

/// Splits the classes "Extend" and "Other" by Indic_Conjunct_Break, because rule GB9c of UAX #29 needs both.
inline void refine_grapheme_class(std::string& grapheme, const std::string& conjunct)
{
    const bool mark = grapheme == "Extend" || grapheme == "ZWJ";
    if (conjunct == "Consonant" && grapheme != "Other") FAIL("a consonant that is " << grapheme);
    if ((conjunct == "Linker" && grapheme != "Extend") || (conjunct == "Extend" && !mark))
        FAIL("a sign of conjuncts that is " << grapheme);
    if (conjunct == "Linker" || conjunct == "Consonant") grapheme = conjunct;
    if (grapheme == "Extend" && conjunct != "Extend") grapheme = "NonJoiner";
}

/// The table of character_of().
inline std::string character_table()
{
    const auto
        bidi_names = words("L R AL EN ES ET AN CS NSM BN B S WS ON LRE LRO RLE RLO PDF LRI RLI FSI PDI"),
        line_names = words(
            "AL ALc ALp BK CR LF NL SP ZW CM ZWJ WJ GL BA BB B2 HY HH CB CL CP EX IN NS CJ OP OPw QU QUi QUf IS "
            "NU PO PR SY HL ID EB EM IDp H2 H3 JL JV JT AK AS AP VF VI RI SA SAm"),
        grapheme_names = words(
            "Other CR LF Control Extend Linker NonJoiner Consonant ZWJ Regional_Indicator Prepend SpacingMark L V "
            "T LV LVT Pictographic"),
        upright_names = words("R U Tr Tu");
    const std::map<std::string, std::string> long_names = {{"Left_To_Right", "L"},
                                                           {"Right_To_Left", "R"},
                                                           {"Arabic_Letter", "AL"},
                                                           {"European_Terminator", "ET"},
                                                           {"Boundary_Neutral", "BN"}};

    auto bidi = property("extracted/DerivedBidiClass.txt");
    auto line = property("LineBreak.txt");
    auto grapheme = property("auxiliary/GraphemeBreakProperty.txt");
    const auto wide = property("EastAsianWidth.txt"), category = property("extracted/DerivedGeneralCategory.txt");
    const auto picture = property("emoji/emoji-data.txt", "Extended_Pictographic");
    const auto upright = property("VerticalOrientation.txt");
    const auto conjunct = property("DerivedCoreProperties.txt", "InCB", 1);
    std::vector<std::string> bracket(0x110000);
    for_each_line(contents("BidiBrackets.txt"), [&](std::string_view row) {
        const auto fields = split(row.substr(0, row.find('#')), ';');
        if (fields.size() == 3) bracket[hexadecimal(fields[0])] = fields[2];
    });

    numbers which, records;
    std::map<std::uint64_t, std::uint64_t> known;
    for (char32_t c = 0; c < 0x110000; ++c) {
        if (const auto name = long_names.find(bidi[c]); name != long_names.end()) bidi[c] = name->second;
        const bool mark = category[c] == "Mn" || category[c] == "Mc",
                   unassigned = category[c].empty() || category[c] == "Cn" || category[c] == "Unassigned";
        std::string l = line[c];
        if (l == "AI" || l == "SG" || l == "XX") l = "AL";
        if (l == "SA" && mark) l = "SAm";
        if (c == 0x25CC) l += "c";
        if (l == "QU" && category[c] == "Pi") l = "QUi";
        if (l == "QU" && category[c] == "Pf") l = "QUf";
        const bool is_wide = wide[c] == "F" || wide[c] == "W" || wide[c] == "H";
        if ((l == "OP" || l == "CP") && is_wide) l += "w";
        refine_grapheme_class(grapheme[c], conjunct[c]);
        if (!picture[c].empty()) {
            if (grapheme[c] != "Other") FAIL("a pictographic character of another grapheme class");
            grapheme[c] = "Pictographic";
            if (unassigned) {
                if (l != "ID" && l != "AL") FAIL("an unassigned pictographic character of class " << l);
                l += "p";
            }
        }
        const std::uint64_t record =
            number_of(bidi_names, bidi[c]) | (bracket[c].empty() ? 0u : number_of({"n", "o", "c"}, bracket[c])) << 6 |
            number_of(line_names, l) << 8 | (is_wide ? 1u : 0u) << 15 | number_of(grapheme_names, grapheme[c]) << 16 |
            number_of(upright_names, upright[c]) << 24;
        const auto [at, fresh] = known.try_emplace(record, records.size());
        if (fresh) records.push_back(record);
        which.push_back(at->second);
    }
    REQUIRE(records.size() <= 256);

    numbers leaves, middles;
    const numbers leaf_of = blocks(which, 16, leaves);
    const numbers middle_of = blocks(leaf_of, 32, middles);
    REQUIRE(*std::max_element(middle_of.begin(), middle_of.end()) < 256);
    return header("#include <typemesh/core/version.hpp>\n\n#include <cstdint>\n",
                  "// Bidi_Class and Bidi_Paired_Bracket_Type, Line_Break, Grapheme_Cluster_Break, "
                  "Vertical_Orientation of code point c:\n"
                  "//     middle = 32 x top[c / 512] + c / 16 % 32,  leaf = 16 x middles[middle] + c % 16,  "
                  "records[leaves[leaf]]\n\n",
                  array_of("std::uint32_t", "character_records", records, 8) + "\n" +
                      array_of("std::uint64_t", "character_top", packed(middle_of, 8), 16) + "\n" +
                      array_of("std::uint64_t", "character_middles", packed(middles, 16), 16) + "\n" +
                      array_of("std::uint64_t", "character_leaves", packed(leaves, 8), 16));
}

/// The table of opening_bracket().
inline std::string bracket_table()
{
    numbers pairs;
    for_each_line(contents("BidiBrackets.txt"), [&](std::string_view row) {
        const auto fields = split(row.substr(0, row.find('#')), ';');
        if (fields.size() == 3 && fields[2] == "c")
            pairs.push_back(static_cast<std::uint64_t>(hexadecimal(fields[0])) << 16 | hexadecimal(fields[1]));
    });
    std::sort(pairs.begin(), pairs.end());
    REQUIRE(pairs.back() < 0x1'0000'0000);
    return header("#include <typemesh/core/version.hpp>\n\n#include <cstdint>\n",
                  "// Bidi_Paired_Bracket: a closing bracket and its opening one.\n\n",
                  array_of("std::uint32_t", "bracket_pairs", pairs, 8));
}

/// The table of script.hpp. Scripts are numbered, Common first, then Inherited and Unknown. Higher numbers are sets of
/// scripts, with the preferred one first: a letter's own script, or Latin if several share the character.
inline std::string script_table()
{
    std::map<std::string, std::string> tags;  // ISO 15924, by long name
    std::vector<std::string> scripts = {"Zyyy", "Zinh", "Zzzz"};
    for_each_line(contents("PropertyValueAliases.txt"), [&](std::string_view row) {
        const auto fields = split(row.substr(0, row.find('#')), ';');
        if (fields[0] == "sc") tags[fields[2]] = fields[1];
    });
    auto script = property("Scripts.txt");
    const auto extensions = property("ScriptExtensions.txt");
    for (std::string& name : script) {
        name = tags.at(name);
        if (std::find(scripts.begin(), scripts.end(), name) == scripts.end()) scripts.push_back(name);
    }
    std::sort(scripts.begin() + 3, scripts.end());

    numbers ranges, members, starts, scripts_by_number;
    std::vector<std::vector<std::string>> sets;
    std::uint64_t before = ~std::uint64_t{0};
    for (char32_t c = 0; c < 0x110000; ++c) {
        auto all = words(extensions[c].substr(0, 1) == "<" ? "" : extensions[c]);
        if (all.empty()) all = {script[c]};
        const bool shared = script[c] == "Zyyy" || script[c] == "Zinh";
        if (const auto own = std::find(all.begin(), all.end(), shared ? "Latn" : script[c]); own != all.end())
            std::rotate(all.begin(), own, own + 1);
        std::uint64_t number = all.size() == 1 ? number_of(scripts, all[0]) : 0;
        if (all.size() > 1) {
            const auto known = std::find(sets.begin(), sets.end(), all);
            number = scripts.size() + static_cast<std::size_t>(known - sets.begin());
            if (known == sets.end()) sets.push_back(all);
        }
        if (number != before) ranges.push_back(static_cast<std::uint64_t>(c) << 9 | number);
        before = number;
    }
    REQUIRE(scripts.size() + sets.size() <= 512);
    REQUIRE(scripts.size() <= 192);  // bits of a script_set
    for (const std::string& tag : scripts) {
        std::uint64_t word = 0;
        for (const char letter : tag) word = word << 8 | static_cast<unsigned char>(letter);
        scripts_by_number.push_back(word);
    }
    for (const auto& set : sets) {
        starts.push_back(members.size());
        for (const std::string& tag : set) members.push_back(number_of(scripts, tag));
    }
    starts.push_back(members.size());
    return header("#include <typemesh/core/version.hpp>\n\n#include <cstdint>\n",
                  "// Script and Script_Extensions. script_ranges: the first code point of a range << 9 | its script's "
                  "number, or, from\n// the number of scripts on, that of a set. Set k: script_members from "
                  "script_starts[k] up to script_starts[k + 1].\n\n",
                  array_of("std::uint32_t", "script_tags", scripts_by_number, 8) + "\n" +
                      array_of("std::uint16_t", "script_starts", starts, 4) + "\n" +
                      array_of("std::uint8_t", "script_members", members, 2) + "\n" +
                      array_of("std::uint32_t", "script_ranges", ranges, 8));
}

/// The table of word_boundaries.hpp: Word_Break with Extended_Pictographic, and Joining_Type, by ranges.
inline std::string word_table()
{
    const auto names = words(
                   "Other CR LF Newline Extend Format ZWJ Regional_Indicator Katakana Hebrew_Letter ALetter "
                   "ALetterPicto Single_Quote Double_Quote MidNumLet MidLetter MidNum Numeric ExtendNumLet WSegSpace "
                   "Pictographic"),
               joining_names = words("U R L D C T");
    const auto word = property("auxiliary/WordBreakProperty.txt"),
               joining = property("extracted/DerivedJoiningType.txt");
    const auto picture = property("emoji/emoji-data.txt", "Extended_Pictographic");
    numbers ranges;
    std::uint64_t before = ~std::uint64_t{0};
    for (char32_t c = 0; c < 0x110000; ++c) {
        std::string name = word[c];
        if (!picture[c].empty()) {
            if (name != "Other" && name != "ALetter") FAIL("a pictographic character of another word class");
            name = name == "Other" ? "Pictographic" : "ALetterPicto";
        }
        const std::string join = joining[c] == "Non_Joining" ? "U" : joining[c];
        const std::uint64_t value = number_of(names, name) | number_of(joining_names, join) << 5;
        if (value != before) ranges.push_back(static_cast<std::uint64_t>(c) << 8 | value);
        before = value;
    }
    return header("#include <typemesh/core/version.hpp>\n\n#include <cstdint>\n",
                  "// The first code point of a range << 8 | its Joining_Type << 5 | its Word_Break.\n\n",
                  array_of("std::uint32_t", "word_ranges", ranges, 8));
}

/// Compares a header with the wanted text, or writes it.
inline void check_or_make(const std::string& name, const std::string& wanted)
{
    const std::string path = TYPEMESH_TEST_DATA "/../include/typemesh/unicode/impl/" + name;
    if (std::getenv("TYPEMESH_MAKE_TABLES") != nullptr) {
        std::ofstream{path, std::ios::binary} << wanted;
        WARN("written: " << path);
    }
    std::ifstream file{path, std::ios::binary};
    const std::string is{std::istreambuf_iterator<char>{file}, {}};
    CHECK(std::count(wanted.begin(), wanted.end(), '\n') <= 500);
    CHECK((is == wanted));
}

}  // namespace ucd

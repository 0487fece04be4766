// SPDX-License-Identifier: MIT
//
// Every kind of policy on glyphs of damaged fonts. tests/hostile/run.sh takes all glyphs of other people's fonts.
#include "glyph_trials.hpp"

#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>

#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>

namespace glyph_trials_test {

using namespace typemesh;

void try_both(std::span<const std::byte> bytes, const std::string& name, std::uint32_t most, hostile::trials& seen)
{
    hostile::try_glyphs<harfbuzz_font>(bytes, name + " (HarfBuzz)", most, seen);
    hostile::try_glyphs<freetype_font>(bytes, name + " (FreeType)", most, seen);
}

/// The start of a table's entry in the directory; 0 if the font has no such table.
std::size_t entry_of(std::span<const std::byte> font, const std::string& tag)
{
    for (std::size_t i = 12; i + 16 <= font.size() && i < 12 + 16 * 64; i += 16)
        if (std::equal(tag.begin(), tag.end(), font.begin() + static_cast<std::ptrdiff_t>(i),
                       [](char a, std::byte b) { return static_cast<std::byte>(a) == b; }))
            return i;
    return 0;
}

/// A font with extreme numbers in the table that contains its outlines.
std::vector<std::byte> with_wild_outlines(std::vector<std::byte> font, std::mt19937& random)
{
    const std::size_t entry = entry_of(font, "glyf") != 0 ? entry_of(font, "glyf") : entry_of(font, "CFF ");
    REQUIRE(entry != 0);
    const auto word = [&](std::size_t i) {
        std::size_t w = 0;
        for (std::size_t k = 0; k < 4; ++k) w = w << 8 | std::to_integer<std::size_t>(font[i + k]);
        return w;
    };
    const std::size_t first = word(entry + 8), size = word(entry + 12);
    REQUIRE(first + size <= font.size());
    for (std::size_t k = 0; k < size / 64; ++k) {
        constexpr unsigned extremes[] = {0x7F, 0x80, 0xFF, 0x00};
        font[first + random() % size] = static_cast<std::byte>(extremes[random() % 4]);
    }
    return font;
}

}  // namespace glyph_trials_test

TEST_CASE("glyphs of damaged fonts become lawful meshes or are refused, with every policy", "[hostile]")
{
    using namespace glyph_trials_test;
    std::mt19937 random{20261123};
    hostile::trials seen;
    for (const char* name : {"truetype/liberation/LiberationMono-Regular.ttf",
                             "opentype/comic-neue/ComicNeue-Regular.otf", "truetype/inter-vf/Inter-roman.var.ttf"})
        try_both(with_wild_outlines(bytes_of(font_file(name)), random), name, 20, seen);
    for (const auto& [words, times] : seen.broken) FAIL_CHECK(words << ": " << times << " times");
    CHECK(seen.glyphs >= 100);
    CHECK(seen.meshes > 400);
    CHECK_FALSE(seen.refusals.empty());
    CHECK(seen.seconds.value < 20.0);
}

TEST_CASE("glyphs of fuzzing suites' fonts become lawful meshes or are refused, with every policy", "[hostile]")
{
    using namespace glyph_trials_test;
    const char* folder = std::getenv("TYPEMESH_HOSTILE_FONTS");
    if (folder == nullptr) {
        WARN("Skipped: TYPEMESH_HOSTILE_FONTS names no folder of hostile fonts.");
        return;
    }
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path());
    hostile::trials seen;
    for (const auto& file : files) try_both(bytes_of(file.string()), file.filename().string(), 3, seen);
    for (const auto& [words, times] : seen.broken) FAIL_CHECK(words << ": " << times << " times");
    CHECK(seen.meshes > 0);
    CHECK(seen.seconds.value < 20.0);
}

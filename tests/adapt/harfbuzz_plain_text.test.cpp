// SPDX-License-Identifier: MIT
#include "support/font_file.hpp"
#include "support/plain_text_law.hpp"

#include <typemesh/adapt/harfbuzz.hpp>

// The smoke fonts have Latin, Greek, Cyrillic, Hebrew, Arabic (Naskh and Nastaliq), Devanagari, Thai, Chinese, Japanese
// and symbols.
TEST_CASE("Plain text and a paragraph without a width are laid out alike in all smoke fonts", "[adapt][paragraph]")
{
    std::vector<std::string> files;
    for (const font_package& package : smoke_fonts())
        if (package.required)
            for (const std::string& file : font_files(package)) files.push_back(file);
    REQUIRE_FALSE(files.empty());
    test::random_text random{2026};
    constexpr std::size_t each = 50;
    std::size_t one_line = 0;
    for (std::size_t round = 0; one_line < 10'000; ++round) {
        const std::string& file = files[round % files.size()];
        auto font = typemesh::harfbuzz_font::open(file.c_str());
        if (!font) continue;  // a face with bitmaps only
        INFO(file << ", round " << round);
        test::check_plain_text(*font, random, each);
        one_line += each;
    }
}

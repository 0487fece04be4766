// SPDX-License-Identifier: MIT
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/font_path.hpp"
#include "support/required.hpp"
#include "support/workload.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

struct named_vertex {
    cluster_id cluster;
    std::uint32_t letter, word, line;
};

/// A letter as a reader sees it: its text, and which word of the text it is in.
struct read_letter {
    std::string text;
    std::uint32_t word;
};

}  // namespace

template <>
struct typemesh::vertex_traits<named_vertex> {
    static constexpr auto wants = attribute::cluster | attribute::letter | attribute::word | attribute::line;
    named_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.cluster, s.letter, s.word, s.line};
    }
};

namespace {

harfbuzz_font opened(const std::string& path)
{
    auto font = harfbuzz_font::open(path.c_str());
    REQUIRE(font);
    return std::move(*font);
}

/// The numbers of vertices that do not have the letter and word that a reader finds at their place of the text.
std::size_t wrong_vertices(const std::string& text, const std::vector<named_vertex>& vertices,
                           const std::vector<read_letter>& letters)
{
    std::vector<std::size_t> starts;
    std::size_t from = 0;
    for (const read_letter& l : letters) {
        starts.push_back(text.find(l.text, from));
        REQUIRE(starts.back() != std::string::npos);
        from = starts.back() + l.text.size();
    }
    std::size_t wrong = 0;
    std::vector<bool> seen(letters.size(), false);
    for (const named_vertex& v : vertices) {
        std::size_t k = letters.size();
        for (std::size_t i = 0; i < letters.size(); ++i)
            if (v.cluster >= starts[i] && v.cluster < starts[i] + letters[i].text.size()) k = i;
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(v.cluster), '\n');
        wrong += k == letters.size() || v.letter != k || v.word != letters[k].word || v.line != line ? 1u : 0u;
        if (k < letters.size()) seen[k] = true;
    }
    return wrong + static_cast<std::size_t>(std::count(seen.begin(), seen.end(), false));
}

}  // namespace

TEST_CASE("each vertex has the letter, word and line that a reader finds", "[adapt][harfbuzz][letters]")
{
    struct known {
        const char* font;
        std::string text;
        std::vector<read_letter> letters;
        std::vector<read_letter> merged;  // where their headline makes one solid of them
    };
    const known all[] = {
        {"truetype/dejavu/DejaVuSans.ttf",
         "fix it,\noffice",
         {{"fi", 0}, {"x", 0}, {"i", 1}, {"t", 1}, {",", 1}, {"o", 2}, {"ffi", 2}, {"c", 2}, {"e", 2}},
         {}},
        {"truetype/dejavu/DejaVuSans.ttf",  // marks; a picture of two characters
         "x\u0308y \u263A\uFE0F!",
         {{"x\u0308", 0}, {"y", 0}, {"\u263A\uFE0F", 1}, {"!", 1}},
         {}},
        {"opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
         "\u0633\u0644\u0627\u0645 \u0639\u0644\u064A\u0643\u0645",
         {{"\u0633\u0644\u0627", 0}, {"\u0645", 0}, {"\u0639\u0644\u064A\u0643\u0645", 1}},
         {}},
        {"truetype/noto/NotoSansDevanagari-Regular.ttf",
         "\u0915\u094D\u0937\u0924\u094D\u0930\u093F\u092F \u0928\u092E",
         {{"\u0915\u094D\u0937", 0}, {"\u0924\u094D\u0930\u093F", 0}, {"\u092F", 0}, {"\u0928", 1}, {"\u092E", 1}},
         {{"\u0915\u094D\u0937\u0924\u094D\u0930\u093F\u092F", 0}, {"\u0928\u092E", 1}}},
    };
    for (const known& one : all) {
        const auto path = font_path(one.font);
        if (!std::filesystem::exists(path)) continue;
        INFO(one.text);
        harfbuzz_font font = opened(path.string());
        text_mesher mesher{font};
        for (const bool merge : {false, true}) {
            std::vector<named_vertex> vertices;
            std::vector<std::uint32_t> indices;
            REQUIRE(mesher.build(one.text, into(vertices, indices), {.merge = merge}));
            const bool fewer = merge && !one.merged.empty();
            CHECK(wrong_vertices(one.text, vertices, fewer ? one.merged : one.letters) == 0);
            const auto plan = test::required(mesher.plan(one.text, {.merge = merge}));
            REQUIRE(plan->find_letters(one.text));
            for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
                CHECK(&plan->row_of(g) == &plan->letters().letters[plan->letter_of(g)]);
        }
    }
}

TEST_CASE("the letters of the workload's Latin texts are those of a walk along its clusters",
          "[adapt][harfbuzz][letters]")
{
    std::size_t checked = 0;
    for (const test::workload_font& file : test::workload_fonts()) {
        if (!std::filesystem::exists(file.path) || !file.serves("latin")) continue;
        INFO(file.path);
        harfbuzz_font font = opened(file.path);
        text_mesher mesher{font, flat{}};
        const std::string text = "The quick brown fox\njumps over the lazy dog 1234567890";
        std::vector<named_vertex> vertices;
        std::vector<std::uint32_t> indices;
        auto plan = test::required(mesher.plan(text));
        REQUIRE(plan->find_letters(text));
        REQUIRE(plan->write(into(vertices, indices)));
        std::vector<cluster_id> clusters;
        for (const drawn_glyph& g : plan->glyphs()) clusters.push_back(plan->run().glyphs[g.glyph].cluster);
        std::sort(clusters.begin(), clusters.end());
        clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
        std::size_t wrong = 0;
        for (const named_vertex& v : vertices) {
            const auto before = text.begin() + static_cast<std::ptrdiff_t>(v.cluster);
            const auto letter = std::lower_bound(clusters.begin(), clusters.end(), v.cluster) - clusters.begin();
            const auto word = std::count_if(text.begin(), before, [](char c) { return c == ' ' || c == '\n'; });
            wrong += v.letter != letter || v.word != word || v.line != std::count(text.begin(), before, '\n') ? 1u : 0u;
        }
        CHECK(wrong == 0);
        ++checked;
    }
    CHECK(checked > 0);
}

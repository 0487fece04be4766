// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "unicode/character_database.hpp"
#include "unicode/slow_bidi.hpp"

#include <typemesh/unicode/impl/bidi_levels.hpp>
#include <typemesh/unicode/visual_order.hpp>

#include <random>
#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;

namespace {

constexpr paragraph_direction directions[] = {paragraph_direction::automatic, paragraph_direction::left_to_right,
                                              paragraph_direction::right_to_left};

/// Resolves and orders one line, which is one paragraph.
class line_under_test {
public:
    bool resolve(const std::vector<char32_t>& text, const std::vector<bidi_class>& classes,
                 paragraph_direction direction)
    {
        levels_.assign(text.size(), 0xFF);
        const auto base = bidi_levels(text, classes, direction, space_, levels_);
        if (!base) return false;
        base_ = *base;
        marks_.clear();
        removed_.clear();
        for (const bidi_class c : classes) {
            using enum bidi_class;
            const bool removed = bidi_classes{bn, lre, rle, lro, rlo, pdf}.holds(c);
            removed_.push_back(removed);
            marks_.push_back(bidi_classes{s, b}.holds(c)                                ? text_mark::separator
                             : removed || bidi_classes{ws, lri, rli, fsi, pdi}.holds(c) ? text_mark::trailing
                                                                                        : text_mark::none);
        }
        if (!visual_runs(levels_.data(), marks_.data(), base_, {0, static_cast<std::uint32_t>(text.size())}, runs_))
            return false;
        order_.clear();
        for (const visual_run& run : runs_)
            for (std::uint32_t i = run.first; i < run.last; ++i) {
                const std::uint32_t k = run.level % 2 == 0 ? i : run.last - 1 - (i - run.first);
                if (!removed_[k]) order_.push_back(static_cast<int>(k));
                levels_[i] = run.level;
            }
        return true;
    }

    /// Compares in the notation of the test files: -1 for what is removed.
    bool has(const std::vector<int>& levels, const std::vector<int>& order) const
    {
        for (std::size_t i = 0; i < levels_.size(); ++i)
            if (levels[i] != (removed_[i] ? -1 : int(levels_[i]))) return false;
        return order == order_;
    }

    int base() const { return base_; }

private:
    workspace space_;
    buffer<visual_run> runs_;
    std::vector<std::uint8_t> levels_;
    std::vector<text_mark> marks_;
    std::vector<bool> removed_;
    std::vector<int> order_;
    std::uint8_t base_ = 0;
};

/// Decimal numbers, and -1 for x.
std::vector<int> numbers(std::string_view s)
{
    std::vector<int> all;
    for (const std::string& word : ucd::words(s)) all.push_back(word == "x" ? -1 : std::stoi(word));
    return all;
}

std::vector<bidi_class> classes_of(std::u32string_view text)
{
    std::vector<bidi_class> classes;
    for (const char32_t c : text) classes.push_back(character_of(c).bidi);
    return classes;
}

bidi_class class_named(std::string_view name)
{
    constexpr std::string_view names[] = {"L",  "R",  "AL",  "EN",  "ES",  "ET",  "AN",  "CS",  "NSM", "BN",  "B",  "S",
                                          "WS", "ON", "LRE", "LRO", "RLE", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"};
    for (std::size_t i = 0; i < std::size(names); ++i)
        if (names[i] == name) return static_cast<bidi_class>(i);
    FAIL("no class " << name);
    return {};
}

}  // namespace

TEST_CASE("bidi levels and orders pass every case of BidiTest.txt", "[bidi]")
{
    if (!ucd::is_of_our_version()) return;
    const std::string all = ucd::contents("BidiTest.txt");
    std::vector<int> levels, order;
    std::size_t cases = 0, wrong = 0;
    line_under_test line;
    ucd::for_each_line(all, [&](std::string_view row) {
        if (row.empty() || row[0] == '#') return;
        if (row.substr(0, 8) == "@Levels:") return void(levels = numbers(row.substr(8)));
        if (row.substr(0, 9) == "@Reorder:") return void(order = numbers(row.substr(9)));
        const auto semicolon = row.find(';');
        std::vector<bidi_class> classes;
        for (const std::string& word : ucd::words(row.substr(0, semicolon))) classes.push_back(class_named(word));
        const std::vector<char32_t> text(classes.size(), U'a');  // no bracket
        const int asked = row.back() - '0';
        for (int k = 0; k < 3; ++k) {
            if ((asked >> k & 1) == 0) continue;
            ++cases;
            if (line.resolve(text, classes, directions[k]) && line.has(levels, order)) continue;
            if (++wrong <= 5) WARN(row << ", direction " << k);
        }
    });
    CHECK(cases == 770241);
    CHECK(wrong == 0);
}

TEST_CASE("bidi levels and orders pass every case of BidiCharacterTest.txt", "[bidi]")
{
    if (!ucd::is_of_our_version()) return;
    const std::string all = ucd::contents("BidiCharacterTest.txt");
    std::size_t cases = 0, wrong = 0;
    line_under_test line;
    ucd::for_each_line(all, [&](std::string_view row) {
        if (row.empty() || row[0] == '#') return;
        const auto fields = ucd::split(row, ';');
        REQUIRE(fields.size() == 5);
        std::u32string text;
        for (const std::string& word : ucd::words(fields[0])) text += ucd::hexadecimal(word);
        constexpr paragraph_direction asked[] = {paragraph_direction::left_to_right, paragraph_direction::right_to_left,
                                                 paragraph_direction::automatic};
        ++cases;
        if (line.resolve({text.begin(), text.end()}, classes_of(text), asked[std::stoi(fields[1])]) &&
            line.base() == std::stoi(fields[2]) && line.has(numbers(fields[3]), numbers(fields[4])))
            return;
        if (++wrong <= 5) WARN(row);
    });
    CHECK(cases == 91707);
    CHECK(wrong == 0);
}

TEST_CASE("bidi levels of any text agree with the rules word by word", "[bidi]")
{
    std::mt19937 random{9};
    workspace space;
    const std::u32string letters =
        U"a\u05D0\u06281+$\u0661,\u0301\u00AD\t .()[]\u2329\u232A\u3008\u3009"
        U"\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069";
    for (std::size_t repeat = 0; repeat < 20000; ++repeat) {
        // Some letters are frequent, so that brackets and isolates close what was opened. Some texts are deep.
        const std::size_t few = 1 + random() % letters.size(), deep = repeat % 100 == 0 ? 140 : 0;
        std::u32string text;
        for (std::size_t i = 0; i < deep; ++i) text += letters[letters.size() - 1 - random() % 9];
        const std::size_t size = deep + random() % 40;
        while (text.size() < size)
            text += letters[random() % 2 == 0 ? random() % letters.size() : (random() % few + repeat) % letters.size()];
        const std::vector<bidi_class> classes = classes_of(text);

        const int k = static_cast<int>(random() % 3);
        int base = k - 1;
        const std::vector<int> wanted = slow_bidi::levels(text, classes, base);
        std::vector<std::uint8_t> levels(text.size());
        const auto found = bidi_levels(text, classes, directions[k], space, levels);
        REQUIRE(found);
        REQUIRE(int(*found) == base);
        for (std::size_t i = 0; i < text.size(); ++i) {
            const int before = i == 0 ? base : int(levels[i - 1]);
            if (int(levels[i]) != (wanted[i] < 0 ? before : wanted[i])) {
                std::string shown;
                for (const char32_t c : text) shown += ucd::hex_of(c) + " ";
                FAIL(shown << "direction " << k << ", character " << i);
            }
        }
    }
}

TEST_CASE("an overridden mark does not follow the bracket before it", "[bidi]")
{
    const std::u32string text = U"\u202Ba(b)\u202C\u202E\u0301";
    std::vector<std::uint8_t> levels(text.size());
    workspace space;
    REQUIRE(bidi_levels(text, classes_of(text), paragraph_direction::left_to_right, space, levels));
    CHECK(levels == std::vector<std::uint8_t>{0, 2, 2, 2, 2, 2, 2, 1});
}

TEST_CASE("an empty paragraph has a level, and a paragraph without memory an error", "[bidi]")
{
    test::counting_memory heap;
    workspace space{heap.source()};
    CHECK(*bidi_levels({}, {}, paragraph_direction::automatic, space, {}) == 0);
    CHECK(*bidi_levels({}, {}, paragraph_direction::right_to_left, space, {}) == 1);
    const std::u32string text = U"a\u05D0b";
    const std::vector<bidi_class> classes = classes_of(text);
    std::vector<std::uint8_t> levels(3);
    heap.fail_at = 1;
    CHECK(bidi_levels(text, classes, paragraph_direction::automatic, space, levels).error() == error::out_of_memory);
    heap.fail_at = 0;
    CHECK(bidi_levels(text, classes, paragraph_direction::automatic, space, levels));
    CHECK(levels == std::vector<std::uint8_t>{0, 1, 0});
}

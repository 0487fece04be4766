// SPDX-License-Identifier: MIT
#pragma once

#include "support/encoded.hpp"

#include <typemesh/markup/markup.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace test {

/// What applies to a character: for each kind of tag its value, in words.
using tag_values = std::map<std::string, std::string>;

inline std::string in_words(double number)
{
    char words[40];
    std::snprintf(words, sizeof words, "%.6f", number);
    return words;
}

/// A text with random tags, and what must be read from it, known from the way it was made.
class marked_document {
public:
    explicit marked_document(std::uint32_t seed, int tokens = 40)
    {
        std::mt19937 random{seed};
        const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
        for (int i = 0; i < tokens; ++i) {
            const std::size_t what = below(16);
            if (what == 15)
                add_box(below);
            else if (what < 6)
                add_text(below);
            else if (what < 12)
                open(below);
            else
                close(below);
        }
    }

    std::u32string source, text;
    std::vector<tag_values> looks;  ///< of each character of the text

private:
    struct entry {
        std::string name, written_name, value;
    };

    void write(std::string_view ascii)
    {
        for (const char c : ascii) source += static_cast<char32_t>(c);
    }

    /// What the open tags say.
    [[nodiscard]] tag_values look() const
    {
        tag_values v;
        for (const entry& e : open_)
            v[e.name == "sup" || e.name == "sub" ? "position" : e.name] =
                e.name == "sup" || e.name == "sub" ? e.name : e.value;
        return v;
    }

    void add_box(const auto& below)
    {
        static constexpr const char* boxes[][2] = {{"1.2,0.8", "1.200000 0.800000 0.000000"},
                                                   {"0,0.5,-.5", "0.000000 0.500000 -0.500000"},
                                                   {"\"1000,-1,1.000001\"", "1000.000000 -1.000000 1.000001"}};
        const auto& [written, value] = boxes[below(std::size(boxes))];
        write(std::string{"[box="} + written + "]");
        text += U'\xFFFC';
        looks.push_back(look());
        looks.back()["box"] = value;
    }

    void add_text(const auto& below)
    {
        constexpr char32_t letters[] = {U'a', U'b', U' ',    U']',    U'[',      U'/',    U'=',
                                        U'"', U'#', U'\x9F', U'\xE9', U'\x672C', 0x1F600, U'\xFFFC'};
        const tag_values now = look();
        for (std::size_t count = below(4); count > 0; --count) {
            const char32_t c = letters[below(std::size(letters))];
            source += c;
            if (c == U'[') source += c;
            text += c;
            looks.push_back(now);
        }
    }

    void open(const auto& below)
    {
        static constexpr const char* tags[][3] = {
            // name, value as it is written, value
            {"b", "", "on"},
            {"i", "", "on"},
            {"u", "", "on"},
            {"s", "", "on"},
            {"o", "", "on"},
            {"sup", "", "on"},
            {"sub", "", "on"},
            {"size", "1.5", "1.500000"},
            {"size", "1", "1.000000"},
            {"rise", "-.25", "-0.250000"},
            {"rise", "-0", "0.000000"},
            {"spacing", "0.000001", "0.000001"},
            {"depth", "\"1000\"", "1000.000000"},
            {"bevel", "00.020", "0.020000"},
            {"colour", "#c3F", "cc33ff"},
            {"color", "#0123Ab", "0123ab"},
            {"style", "4294967294", "4294967294"},
            {"mark", "#fF0", "ffff00"},
            {"mark", "#0123Ab", "0123ab"},
            {"font", "Liberation Serif", "Liberation Serif"},
            {"font", "'a\"]b'", "a\"]b"},
            {"lang", "zh-Hant", "zh-Hant"},
            {"ruby", "x y", "x y"},
            {"ruby", "\"[']\"", "[']"},
        };
        const auto& [name, written, value] = tags[below(std::size(tags))];
        entry e{name, name, value};
        if (e.name == "color") e.name = "colour";
        if (e.name == "ruby") {
            for (const entry& around : open_)
                if (around.name == e.name) return;
            e.value = std::to_string(rubies_++) + ": " + e.value;
        }
        write(std::string{"["} + name + (*written != '\0' ? "=" : "") + written + "]");
        open_.push_back(e);
    }

    void close(const auto& below)
    {
        if (open_.empty()) return;
        std::size_t k = below(open_.size());
        if (below(3) == 0) {
            k = open_.size() - 1;
            write("[/]");
        } else {
            for (std::size_t i = k + 1; i < open_.size(); ++i)
                if (open_[i].name == open_[k].name) k = i;
            write("[/" + open_[k].written_name + "]");
        }
        open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(k));
    }

    std::vector<entry> open_;
    int rubies_ = 0;
};

template <class Char>
std::string ascii_of(std::basic_string_view<Char> words)
{
    std::string s;
    for (const Char c : words) s += static_cast<char>(c);
    return s;
}

/// The values that a look has.
template <class Char>
tag_values values_of(const typemesh::basic_markup_look<Char>& l)
{
    using typemesh::markup_tag;
    tag_values v;
    const auto add = [&](markup_tag t, const char* name, const std::string& value) {
        if (l.has(t)) v[name] = value;
    };
    constexpr const char* switches[] = {"b", "i", "u", "s", "o"};
    for (unsigned i = 0; i < 5; ++i) add(static_cast<markup_tag>(i), switches[i], "on");
    add(markup_tag::size, "size", in_words(l.size));
    add(markup_tag::rise, "rise", in_words(l.rise));
    add(markup_tag::spacing, "spacing", in_words(l.spacing));
    add(markup_tag::depth, "depth", in_words(l.depth));
    add(markup_tag::bevel, "bevel", in_words(l.bevel));
    char colour[12];
    std::snprintf(colour, sizeof colour, "%06x", static_cast<unsigned>(l.colour));
    add(markup_tag::colour, "colour", colour);
    std::snprintf(colour, sizeof colour, "%06x", static_cast<unsigned>(l.mark));
    add(markup_tag::mark, "mark", colour);
    add(markup_tag::style, "style", std::to_string(l.style));
    add(markup_tag::font, "font", ascii_of(l.font));
    add(markup_tag::language, "lang", ascii_of(l.language));
    if (l.position != typemesh::script_position::normal)
        v["position"] = l.position == typemesh::script_position::superscript ? "sup" : "sub";
    return v;
}

/// The values of each unit of what has been read. Rubies that have text are counted from 0.
template <class Char>
std::vector<tag_values> values_of(const typemesh::basic_markup<Char>& read)
{
    std::vector<tag_values> all(read.text().size());
    for (const typemesh::markup_span& s : read.spans()) {
        tag_values v = s.look != 0 ? values_of(read.looks()[s.look]) : tag_values{};
        if (s.ruby != 0) v["ruby"] = std::to_string(s.ruby) + ": " + ascii_of(read.rubies()[s.ruby - 1]);
        for (std::size_t i = s.first; i < s.last; ++i) all[i] = v;
    }
    for (const typemesh::inline_box& b : read.boxes())
        for (std::size_t i = b.unit, units = sizeof(Char) == 1 ? 3 : 1; units > 0; --units, ++i)
            all[i]["box"] = in_words(b.width) + " " + in_words(b.ascent) + " " + in_words(b.descent);
    return all;
}

}  // namespace test

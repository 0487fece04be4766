// SPDX-License-Identifier: MIT
#pragma once

#include "unicode/character_database.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ucd {

/// One line of LineBreakTest.txt or GraphemeBreakTest.txt.
struct break_case {
    std::string row;
    std::vector<char32_t> text;
    std::vector<bool> breaks;  ///< before each character and after the last
};

inline std::vector<break_case> break_cases(const std::string& file)
{
    std::vector<break_case> cases;
    for_each_line(contents(file), [&](std::string_view row) {
        if (row.empty() || row[0] == '#') return;
        break_case one;
        one.row = row;
        for (const std::string& word : words(row.substr(0, row.find('#')))) {
            if (word == "\u00F7" || word == "\u00D7")
                one.breaks.push_back(word == "\u00F7");
            else
                one.text.push_back(hexadecimal(word));
        }
        cases.push_back(one);
    });
    return cases;
}

/// Every case of a file: breaks_of(text) says before which characters there is a break.
template <class Find>
void check_break_cases(const std::string& file, std::size_t count, const Find& breaks_of)
{
    if (!is_of_our_version()) return;
    const auto cases = break_cases(file);
    CHECK(cases.size() == count);
    std::size_t wrong = 0;
    for (const break_case& one : cases) {
        std::vector<bool> breaks = breaks_of(one.text);
        breaks.push_back(true);  // at the end
        if (breaks != one.breaks && ++wrong <= 5) WARN(one.row);
    }
    CHECK(wrong == 0);
}

}  // namespace ucd

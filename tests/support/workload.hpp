// SPDX-License-Identifier: MIT
#pragma once

// The texts and fonts of tests/workload.

#include "support/catch.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace test {

/// The lines of a file in tests/workload.
inline std::vector<std::string> workload_lines(const std::string& file)
{
    std::ifstream in{std::string{TYPEMESH_TEST_DATA "/workload/"} + file};
    if (!in) FAIL("tests/workload/" << file << " cannot be read");
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

/// A row of fonts.tsv.
struct workload_font {
    std::string role, name, package, path;

    /// Too large for every machine: where it is not installed, the test says so and continues.
    [[nodiscard]] bool optional() const { return package == "fonts-mplus" || package == "fonts-noto-cjk"; }
    [[nodiscard]] bool serves(const std::string& script) const { return role.find(script) != std::string::npos; }

    /// True when the font is there; fails the test, or says that it is skipped, when it is not.
    [[nodiscard]] bool available() const
    {
        if (std::ifstream{path}) return true;
        if (!optional()) FAIL(name << " is not installed (Debian package " << package << ", file " << path << ")");
        WARN("skipped: " << name << " is not installed (Debian package " << package << ")");
        return false;
    }
};

inline std::vector<workload_font> workload_fonts()
{
    std::vector<workload_font> fonts;
    const auto lines = workload_lines("fonts.tsv");
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::vector<std::string> column;
        std::istringstream row{lines[i]};
        for (std::string cell; std::getline(row, cell, '\t');) column.push_back(cell);
        fonts.push_back({column.at(0), column.at(2), column.at(3), "/" + column.at(4)});
    }
    return fonts;
}

/// All texts of one script ("latin", "arabic", "chinese", "japanese"): its characters joined to one line, its phrases,
/// and the long text.
inline std::vector<std::string> workload_texts(const std::string& script)
{
    std::string characters;
    for (const auto& c : workload_lines("chars-" + script + ".txt")) characters += c + " ";
    std::vector<std::string> texts{characters};
    for (const auto& phrase : workload_lines("phrases-" + script + ".txt")) texts.push_back(phrase);
    if (script == "latin")
        for (const auto& line : workload_lines("long-latin.txt")) texts.push_back(line);
    return texts;
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace fuzz {

/// The bytes of a file of tests/corpus/fuzz: pairs of hexadecimal digits, white space, and comments from # to the end of
/// the line.
inline std::vector<std::uint8_t> read_hex(const std::filesystem::path& file)
{
    std::ifstream in{file};
    std::vector<std::uint8_t> bytes;
    std::string line, digits;
    while (std::getline(in, line))
        for (const char c : line.substr(0, line.find('#')))
            if (c != ' ' && c != '\r' && c != '\t') digits += c;
    REQUIRE(digits.size() % 2 == 0);
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
    return bytes;
}

inline std::string to_hex(const std::vector<std::uint8_t>& bytes)
{
    std::string digits;
    for (const std::uint8_t b : bytes) {
        digits += "0123456789abcdef"[b >> 4];
        digits += "0123456789abcdef"[b & 15];
    }
    return digits;
}

/// Runs a target over its kept inputs, and over `count` random ones, which are the same everywhere. Half of them are short.
template <class Target>
void replay(const std::string& name, const Target& target, int count, std::int32_t longest)
{
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = std::filesystem::path{TYPEMESH_TEST_DATA} / "corpus" / "fuzz" / name;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::directory_iterator{folder}) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        INFO(file.filename().string());
        CHECK(target(values{read_hex(file)}) == "");
    }
    test::dice d{20261123};
    int mistakes = 0;
    for (int i = 0; i < count && mistakes < 3; ++i) {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(1 + d.roll(i % 2 == 0 ? longest : longest / 8)));
        for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(d.bits());
        const broken_law broken = target(values{bytes});
        if (broken.empty()) continue;
        ++mistakes;
        INFO(to_hex(bytes));
        CHECK(broken == "");
    }
    CHECK(mistakes == 0);
}

}  // namespace fuzz

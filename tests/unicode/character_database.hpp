// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

/// Reads the Unicode Character Database as Debian's package unicode-data installs it.
namespace ucd {

inline const std::string version = "17.0.0";

/// The folder of the database: TYPEMESH_UNICODE_DATA, or where install_unicode_data() of cmake/setup.sh or Debian has put
/// it. Of several, the first of our version; empty if there is none.
inline std::filesystem::path folder()
{
    const char* given = std::getenv("TYPEMESH_UNICODE_DATA");
    const std::filesystem::path fetched = TYPEMESH_TEST_DATA "/../build/unicode-data-" + version;
    for (const std::filesystem::path& where :
         {given != nullptr ? std::filesystem::path{given} : fetched, std::filesystem::path{"/usr/share/unicode"}}) {
        std::ifstream file{where / "BidiTest.txt"};
        std::string head;
        if (file.is_open() && std::getline(file, head) && head.find(version) != std::string::npos) return where;
    }
    return {};
}

/// Whether the database is there in our version; warns if it is not.
inline bool is_of_our_version()
{
    if (!folder().empty()) return true;
    WARN("Skipped: the Unicode Character Database " << version << " is not here (Debian package unicode-data)");
    return false;
}

/// The whole text of one file. Needs is_of_our_version().
inline std::string contents(const std::string& name)
{
    std::ifstream file{folder() / name, std::ios::binary};
    INFO(name);
    REQUIRE(file.is_open());
    return {std::istreambuf_iterator<char>{file}, {}};
}

/// Calls use(line) for each line, without its end; test files have hundreds of thousands of lines.
inline void for_each_line(const std::string& all, const std::function<void(std::string_view)>& use)
{
    for (std::size_t i = 0; i < all.size();) {
        const std::size_t end = std::min(all.find('\n', i), all.size());
        use(std::string_view{all}.substr(i, end - i));
        i = end + 1;
    }
}

inline std::string trimmed(std::string_view s)
{
    const auto first = s.find_first_not_of(" \t"), last = s.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string{} : std::string{s.substr(first, last - first + 1)};
}

inline std::vector<std::string> split(std::string_view s, char by)
{
    std::vector<std::string> parts;
    for (std::size_t i = 0; i <= s.size();) {
        const std::size_t end = std::min(s.find(by, i), s.size());
        parts.push_back(trimmed(s.substr(i, end - i)));
        i = end + 1;
    }
    return parts;
}

inline std::vector<std::string> words(std::string_view s)
{
    std::istringstream in{std::string{s}};
    return {std::istream_iterator<std::string>{in}, {}};
}

inline char32_t hexadecimal(const std::string& s) { return static_cast<char32_t>(std::stoul(s, nullptr, 16)); }

inline std::string hex_of(char32_t c)
{
    std::ostringstream out;
    out << std::hex << static_cast<std::uint32_t>(c);
    return out.str();
}

/// A property of all code points, from lines such as "0041..005A ; Latin # comment". A code point without a line has the
/// value of the last "@missing" line that includes it, by its long name.
///
///     wanted    the property, by its name in the second field, in a file of several
///     value     the number of the field after the name that contains the value; 0: the name itself
inline std::vector<std::string> property(const std::string& name, const std::string& wanted = "", std::size_t value = 0)
{
    std::vector<std::string> values(0x110000);
    const auto set = [&](const std::string& line) {
        const auto fields = split(line, ';');
        if (fields.size() < 2 + value || (!wanted.empty() && fields[1] != wanted)) return;
        const auto dots = fields[0].find("..");
        const char32_t first = hexadecimal(fields[0]);
        const char32_t last = dots == std::string::npos ? first : hexadecimal(fields[0].substr(dots + 2));
        for (char32_t c = first; c <= last; ++c) values[c] = fields[1 + value];
    };
    const std::string all = contents(name);
    const std::string_view missing = "# @missing: ";
    for_each_line(all, [&](std::string_view line) {
        if (line.substr(0, missing.size()) == missing) set(std::string{line.substr(missing.size())});
    });
    for_each_line(all, [&](std::string_view line) { set(std::string{line.substr(0, line.find('#'))}); });
    return values;
}

}  // namespace ucd

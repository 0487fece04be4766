// SPDX-License-Identifier: MIT
#include "wrong_usage.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace text_to_mesh {
namespace {

/// How many letters must be changed, left out, added or exchanged with their neighbour to get from one word to another.
std::size_t distance(const std::string& a, const std::string& b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t k = 0; k <= b.size(); ++k) {
            if (i == 0 || k == 0) {
                d[i][k] = i + k;
                continue;
            }
            d[i][k] = (std::min)({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] != b[k - 1])});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                d[i][k] = (std::min)(d[i][k], d[i - 2][k - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

/// "--fnot is not an option: did you mean --font?", about the first argument that needs it; else nothing.
std::string unknown_option(CLI::App& app, int argc, char** argv)
{
    bool is_value = false;  // of the option before it
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto equals = argument.find('=');
        const std::string name = argument.substr(0, equals);
        const bool short_one = name.size() == 2 && name[0] == '-' && name[1] != '-';
        if (is_value || (!short_one && (name.size() < 3 || name.compare(0, 2, "--") != 0))) {
            is_value = false;
            continue;
        }
        const CLI::Option* option = app.get_option_no_throw(name);
        if (option == nullptr && short_one) continue;
        if (option != nullptr) {
            is_value = equals == std::string::npos && option->get_items_expected_min() > 0;
            continue;
        }
        std::string meant;
        std::size_t nearest = 3;
        for (const CLI::Option* known : app.get_options()) {
            for (const std::string& other : known->get_lnames()) {
                const std::size_t way = distance(name.substr(2), other);
                if (way < nearest) meant = "--" + other, nearest = way;
            }
        }
        return name + " is not an option" + (meant.empty() ? "" : ": did you mean " + meant + "?");
    }
    return {};
}

}  // namespace

std::string in_words(const CLI::ParseError& wrong, CLI::App& app, int argc, char** argv)
{
    if (std::string typo = unknown_option(app, argc, argv); !typo.empty()) return typo;
    if (dynamic_cast<const CLI::ExtrasError*>(&wrong) != nullptr && !app.remaining().empty()) {
        const std::vector<std::string> left = app.remaining();
        const std::string unexpected = left.size() > 1 && left[0] == "--" ? left[1] : left[0];
        return unexpected + (unexpected[0] == '-' ? " is not an option"
                                                  : " was not expected: put a text of several words in quotes");
    }
    const std::string said = wrong.what();
    constexpr std::string_view unconverted = "Could not convert: ";
    if (said.rfind(unconverted, 0) == 0) {  // what stands after the = of a flag; values of others are read by checks
        const std::string option = said.substr(unconverted.size());
        return option.substr(0, option.find(' ')) + " takes no value";
    }
    const auto colon = said.find(':');
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&wrong) == nullptr || colon == std::string::npos) {
        const bool about_itself = colon != std::string::npos &&
                                  (said.compare(colon, 7, ": must ") == 0 || said.compare(colon, 6, ": may ") == 0);
        return about_itself ? said.substr(0, colon) + said.substr(colon + 1) : said;  // "--depth must be", one sentence
    }
    const bool lacks = said.find("missing", colon) != std::string::npos;
    return said.substr(0, colon) + (lacks ? " needs a value" : " may be given only once");
}

}  // namespace text_to_mesh

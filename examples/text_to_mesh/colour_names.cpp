// SPDX-License-Identifier: MIT
#include "colour_names.hpp"

#include "option_values.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace text_to_mesh {
namespace {

constexpr std::pair<std::string_view, rgb_colour> named[] = {
    {"black", {{24, 24, 28}}},    {"white", {{245, 245, 245}}}, {"grey", {{128, 132, 140}}}, {"red", {{208, 40, 44}}},
    {"orange", {{240, 130, 40}}}, {"yellow", {{240, 200, 48}}}, {"green", {{52, 148, 72}}},  {"blue", {{40, 96, 192}}},
    {"purple", {{124, 64, 168}}}, {"brown", {{132, 84, 52}}},
};

constexpr std::string_view digits = "0123456789abcdef", capitals = "0123456789ABCDEF";

}  // namespace

std::optional<rgb_colour> read_colour(std::string_view written)
{
    for (const auto& [name, colour] : named)
        if (written == name) return colour;
    if (written.size() != 7 || written[0] != '#') return {};
    rgb_colour made{};
    for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t digit = std::min(digits.find(written[i + 1]), capitals.find(written[i + 1]));
        if (digit == std::string_view::npos) return {};
        made.rgb[i / 2] = static_cast<unsigned char>(made.rgb[i / 2] * 16 + digit);
    }
    return made;
}

std::string name_of(const rgb_colour& colour)
{
    for (const auto& [name, known] : named)
        if (colour.alpha == 255 && std::equal(std::begin(known.rgb), std::end(known.rgb), colour.rgb))
            return std::string{name};
    std::string name;
    for (const unsigned char c : colour.rgb) {
        name += digits[c / 16];
        name += digits[c % 16];
    }
    if (colour.alpha == 255) return name;
    name += digits[colour.alpha / 16];
    name += digits[colour.alpha % 16];
    return name;
}

std::string colours_in_words()
{
    std::vector<std::string> names;
    for (const auto& [known, unused] : named) names.emplace_back(known);
    return "#2060c0, or " + joined(names);
}

}  // namespace text_to_mesh

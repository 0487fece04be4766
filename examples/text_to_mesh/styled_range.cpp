// SPDX-License-Identifier: MIT
#include "styled_range.hpp"

#include "colour_names.hpp"
#include "option_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace text_to_mesh {
namespace {

using typemesh::decoration;
using typemesh::text_style;

/// A setting that is a word.
bool take_word(std::string_view word, text_style& style)
{
    using typemesh::script_position;
    if (word == "underline") return style.decorations = style.decorations | decoration::underline, true;
    if (word == "strike-through") return style.decorations = style.decorations | decoration::strike_through, true;
    if (word == "overline") return style.decorations = style.decorations | decoration::overline, true;
    if (word == "superscript") return style.position = script_position::superscript, true;
    if (word == "subscript") return style.position = script_position::subscript, true;
    using typemesh::column_style;
    if (word == "upright") return style.column = column_style::upright, true;
    if (word == "sideways") return style.column = column_style::sideways, true;
    if (word == "combined") return style.column = column_style::combined, true;
    return false;
}

/// A setting that is a number. Gives an empty string, or what is wrong; nothing if it is none.
std::optional<std::string> take_measure(std::string_view name, std::string_view value, text_style& style)
{
    struct {
        std::string_view name;
        double& number;
    } const numbers[] = {{"size", style.size},
                         {"rise", style.rise},
                         {"slant", style.slant},
                         {"letter-spacing", style.letter_spacing},
                         {"word-spacing", style.word_spacing}};
    for (const auto& [known, number] : numbers) {
        if (name != known) continue;
        const auto read = decimal(value);
        const double least = known == "size" ? 0.001 : -1000.0;
        if (!read || *read < least || *read > 1000.0)
            return std::string{known} + " must be a number from " + (known == "size" ? "0.001" : "-1000") +
                   " to 1000, not " + std::string{value};
        number = *read;
        return std::string{};
    }
    return {};
}

/// One setting. Gives an empty string, or what is wrong.
std::string take_setting(std::string_view setting, styled_range& out)
{
    if (take_word(setting, out.style)) return {};
    const auto equals = setting.find('=');
    const std::string_view name = setting.substr(0, equals);
    const std::string_view value = equals == std::string_view::npos ? std::string_view{} : setting.substr(equals + 1);
    for (const std::string_view known :
         {"colour", "color", "font", "language", "feature", "size", "rise", "slant", "letter-spacing", "word-spacing"})
        if (name == known && value.empty()) return std::string{name} + " must have a value, as in size=1.5";
    if (const auto number = take_measure(name, value, out.style)) return *number;
    if (name == "colour" || name == "color") {
        out.colour = read_colour(value);
        if (out.colour) return {};
        return "colour must be " + colours_in_words() + ", not " + std::string{value};
    }
    if (name == "font") {
        const auto number = decimal(value);
        if (!number || *number < 1.0 || *number > 65535.0 || *number != std::floor(*number))
            return "font must be a whole number, 1 for --font and 2 for the first --fallback, not " +
                   std::string{value};
        out.style.face = static_cast<std::uint16_t>(*number - 1.0);
        return {};
    }
    if (name == "language") return out.language = value, std::string{};
    if (name == "feature") {
        const auto read = read_feature(value);
        if (!read) return "feature must have the form liga, -liga or liga=0, not " + std::string{value};
        return out.features.push_back(*read), std::string{};
    }
    return "must contain settings such as colour=red, underline or size=1.5, not " +
           (setting.empty() ? "nothing" : std::string{setting});
}

/// What a setting sets: a range has one setting of each kind; empty where it may have several.
std::string what_is_set(std::string_view setting)
{
    const std::string_view name = setting.substr(0, setting.find('='));
    if (name == "feature") return {};
    if (name == "color") return "colour";
    for (const auto& group : {std::vector<std::string>{"superscript", "subscript"},
                              std::vector<std::string>{"upright", "sideways", "combined"}})
        if (std::find(group.begin(), group.end(), name) != group.end()) return joined(group);
    return std::string{name};
}

std::optional<std::size_t> read_place(std::string_view written)
{
    const auto number = decimal(written);
    if (!number || *number < 0.0 || *number > 4e9 || *number != std::floor(*number)) return {};
    return static_cast<std::size_t>(*number);
}

std::string in_words(const styled_range& r) { return std::to_string(r.first) + ".." + std::to_string(r.last); }

/// Where each character of a text begins, and where it ends.
std::vector<std::uint32_t> characters_of(std::string_view text)
{
    std::vector<std::uint32_t> places;
    for (std::size_t i = 0; i < text.size(); i = typemesh::decode(text, i, text.size()).next)
        places.push_back(static_cast<std::uint32_t>(i));
    places.push_back(static_cast<std::uint32_t>(text.size()));
    return places;
}

}  // namespace

std::string read_styled_range(std::string_view written, styled_range& out)
{
    const auto colon = written.find(':');
    const std::string_view range = written.substr(0, colon);
    const auto dots = range.find("..");
    const auto first = read_place(range.substr(0, dots));
    const auto last = dots == std::string_view::npos ? std::nullopt : read_place(range.substr(dots + 2));
    if (colon == std::string_view::npos || !first || !last)
        return "must have the form 6..11:colour=red,underline, not " + std::string{written};
    if (*first >= *last) return "must end after its beginning, not " + std::string{range};
    out.first = *first;
    out.last = *last;
    std::vector<std::string> set;
    for (std::string_view rest = written.substr(colon + 1);;) {
        const auto comma = rest.find(',');
        const std::string_view setting = rest.substr(0, comma);
        if (std::string trouble = take_setting(setting, out); !trouble.empty()) return trouble;
        if (std::string what = what_is_set(setting); !what.empty()) {
            if (std::find(set.begin(), set.end(), what) != set.end()) return "may set " + what + " only once";
            set.push_back(std::move(what));
        }
        if (comma == std::string_view::npos) return {};
        rest.remove_prefix(comma + 1);
    }
}

std::string refused_ranges(const std::vector<styled_range>& ranges, std::string_view text)
{
    const std::size_t size = characters_of(text).size() - 1;
    for (const styled_range& a : ranges) {
        if (a.last > size)
            return in_words(a) + " ends after the text, which has " + std::to_string(size) + " code points";
        for (const styled_range* b = &a + 1; b != ranges.data() + ranges.size(); ++b)
            if (a.first < b->last && b->first < a.last) return in_words(a) + " and " + in_words(*b) + " overlap";
    }
    return {};
}

typemesh::style_id style_of(const std::vector<styled_range>& ranges, std::size_t range)
{
    if (!ranges[range].colour) return {};
    const auto equal = [&](const styled_range& r) {
        return r.colour && name_of(*r.colour) == name_of(*ranges[range].colour);
    };
    const auto first = std::find_if(ranges.begin(), ranges.end(), equal);
    return typemesh::style_id{static_cast<std::uint32_t>(first - ranges.begin()) + 1};
}

std::vector<typemesh::style_span> spans_of(const std::vector<styled_range>& ranges, std::string_view text)
{
    const std::vector<std::uint32_t> places = characters_of(text);
    std::vector<typemesh::style_span> spans;
    for (std::uint32_t i = 0; i < ranges.size(); ++i) {
        typemesh::style_span span{places[ranges[i].first], places[ranges[i].last], ranges[i].style};
        span.style.features = ranges[i].features;
        span.style.language = ranges[i].language;
        span.style.style = style_of(ranges, i);
        spans.push_back(span);
    }
    return spans;
}

}  // namespace text_to_mesh

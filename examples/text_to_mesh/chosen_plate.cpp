// SPDX-License-Identifier: MIT
#include "chosen_plate.hpp"

#include "option_values.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace text_to_mesh {
namespace {

/// A number of an option, and its range.
struct number {
    double low, high;
    float* to;
};

/// Reads one number or several, joined by commas: the first one, and as many of the others as are given.
template <std::size_t N>
bool read_numbers(std::string_view written, const number (&wanted)[N])
{
    for (const number& n : wanted) {
        const auto comma = written.find(',');
        const auto value = decimal(written.substr(0, comma));
        if (!value || *value < n.low || *value > n.high) return false;
        *n.to = static_cast<float>(*value);
        if (comma == std::string_view::npos) return true;
        written.remove_prefix(comma + 1);
    }
    return false;
}

constexpr double min_size = 1e-4;  // of what must not be 0, in em

/// Which option of two is given that do not work together, or that needs another one; empty if all is well.
std::string refused_words(const plate_words& words)
{
    const bool cut = words.cut || !words.stencil.empty();
    const std::pair<bool, const char*> all[] = {{words.cut, "--cut"},
                                                {!words.engrave.empty(), "--engrave"},
                                                {words.inlay, "--inlay"},
                                                {!words.stencil.empty(), "--stencil"},
                                                {words.stamp, "--stamp"},
                                                {!words.keyring.empty(), "--keyring"},
                                                {!words.fillet.empty(), "--fillet"},
                                                {words.open_counters, "--open-counters"}};
    if (words.plate.empty() && words.backing.empty())
        for (const auto& [given, name] : all)
            if (given) return std::string{name} + " needs --plate or --backing";
    if (!words.plate.empty() && !words.backing.empty()) return "--backing does not work with --plate: give one of them";
    if (words.open_counters && words.backing.empty()) return "--open-counters needs --backing";
    if (cut && !words.engrave.empty())
        return std::string{words.cut ? "--cut" : "--stencil"} + " does not work with --engrave: give one of them";
    if (!words.fillet.empty() && (cut || words.inlay || !words.engrave.empty()))
        return "--fillet needs letters that stand on the plate: leave out " + std::string{words.inlay ? "--inlay"
                                                                                          : words.cut ? "--cut"
                                                                                          : cut       ? "--stencil"
                                                                                                      : "--engrave"};
    if (words.inlay && !words.stencil.empty()) return "--inlay does not work with --stencil";
    return {};
}

/// How deep the letters go into the plate, or how high they stand on it.
std::string read_style(const plate_words& words, std::optional<float> depth, typemesh::plate_options& how)
{
    using typemesh::plate_style;
    const bool cut = words.cut || !words.stencil.empty();
    how.style = words.inlay              ? plate_style::inlay
                : cut                    ? plate_style::cut
                : !words.engrave.empty() ? plate_style::engraved
                                         : plate_style::standing;
    if (depth && how.style != plate_style::standing)
        return "--depth does not work with " +
               std::string{words.cut                ? "--cut"
                           : !words.stencil.empty() ? "--stencil"
                           : words.inlay            ? "--inlay"
                                                    : "--engrave"} +
               ": --engrave says how deep the letters are";
    if (depth) how.depth = *depth;
    if (!(how.depth > 0.0f)) return "--depth must be more than 0 on a plate, because the letters stand on it";
    if (cut) how.depth = how.thickness;
    if (!words.fillet.empty() && !read_numbers(words.fillet, {{0.0, 1000.0, &how.fillet}}))
        return "--fillet must be a radius from 0 to 1000, not " + words.fillet;
    if (!words.engrave.empty() && !read_numbers(words.engrave, {{min_size, 1000.0, &how.depth}}))
        return "--engrave must be a number from 0.0001 to 1000, not " + words.engrave;
    return {};
}

/// The plate's outline.
std::string read_outline(const plate_words& words, chosen_plate& out)
{
    typemesh::plate_options& how = out.how;
    if (!words.plate.empty() &&
        !read_numbers(words.plate,
                      {{-1000.0, 1000.0, &how.margin}, {0.0, 1000.0, &how.radius}, {min_size, 1000.0, &how.thickness}}))
        return "--plate must be a margin, a radius and a thickness, such as 0.2 or 0.2,0.1,0.1, not " + words.plate;
    if (!words.backing.empty() &&
        !read_numbers(words.backing, {{0.0, 1.0, &out.growth}, {min_size, 1000.0, &how.thickness}}))
        return "--backing must be a growth up to 1 and a thickness, such as 0.1 or 0.1,0.05, not " + words.backing;
    if (!words.keyring.empty() &&
        !read_numbers(words.keyring, {{min_size, 1000.0, &how.ring_hole}, {min_size, 1000.0, &how.ring_width}}))
        return "--keyring must be the radius of a hole and the width of its ring, such as 0.1 or 0.1,0.06, not " +
               words.keyring;
    return {};
}

/// The width of the bridges, and how many an island gets.
std::string read_stencil(const plate_words& words, typemesh::plate_options& how)
{
    if (words.stencil.empty()) return {};
    auto bridges = static_cast<float>(how.bridges);
    if (!read_numbers(words.stencil, {{min_size, 1000.0, &how.bridge_width}, {1.0, 8.0, &bridges}}) ||
        bridges != std::floor(bridges))
        return "--stencil must be the width of the bridges, and perhaps how many an island gets, 1 to 8, such as 0.05 "
               "or 0.05,3, not " +
               words.stencil;
    how.bridges = static_cast<std::uint32_t>(bridges);
    return {};
}

}  // namespace

std::string read_plate(const plate_words& words, std::optional<float> depth, chosen_plate& out)
{
    if (std::string trouble = refused_words(words); !trouble.empty()) return trouble;
    out.is_on = !words.plate.empty() || !words.backing.empty();
    if (!out.is_on) return {};
    out.follows = !words.backing.empty();
    out.how.mirrored = words.stamp;
    out.how.fill_counters = !words.open_counters;
    if (std::string trouble = read_outline(words, out); !trouble.empty()) return trouble;
    if (std::string trouble = read_style(words, depth, out.how); !trouble.empty()) return trouble;
    return read_stencil(words, out.how);
}

}  // namespace text_to_mesh

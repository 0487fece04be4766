// SPDX-License-Identifier: MIT
#include "svg_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace text_to_mesh {
namespace {

constexpr std::string_view blanks = " \t\r\n\f";
constexpr double degree = 3.14159265358979323846 / 180.0;

bool is_blank(char c) { return blanks.find(c) != std::string_view::npos; }

void skip_blanks(std::string_view& text)
{
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
}

/// A number without what follows it.
std::optional<double> take_bare_number(std::string_view& text)
{
    std::string_view digits = text;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    if (digits.starts_with('+') || (digits.size() < text.size() && digits.starts_with('-'))) return {};
    const std::string_view first = digits.starts_with('-') ? digits.substr(1) : digits;
    if (first.empty() || (first[0] != '.' && (first[0] < '0' || first[0] > '9'))) return {};  // no inf, no nan
    double value = 0.0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, value);
    const char* last = read.ptr;
    if (read.ec == std::errc::invalid_argument) return {};
    if (read.ec == std::errc::result_out_of_range) {
        const std::string_view number{digits.data(), static_cast<std::size_t>(last - digits.data())};
        const auto exponent = number.find_first_of("eE");
        const bool is_tiny = exponent == std::string_view::npos ? first[0] == '0' || first[0] == '.'
                                                                : number.substr(exponent + 1).starts_with('-');
        if (!is_tiny) return {};
        value = 0.0;
    }
    text = {last, static_cast<std::size_t>(end - last)};
    return value;
}

std::optional<typemesh::affine> transform_of(const std::string& name, const std::vector<double>& n)
{
    const std::size_t count = n.size();
    if (name == "matrix" && count == 6) return typemesh::affine{n[0], n[2], n[4], n[1], n[3], n[5]};
    if (name == "translate" && (count == 1 || count == 2))
        return typemesh::affine{.dx = n[0], .dy = count == 2 ? n[1] : 0.0};
    if (name == "scale" && (count == 1 || count == 2)) return typemesh::affine{.xx = n[0], .yy = n[count - 1]};
    if (name == "rotate" && (count == 1 || count == 3)) {
        const double c = std::cos(n[0] * degree), s = std::sin(n[0] * degree);
        const typemesh::affine turn{c, -s, 0.0, s, c, 0.0};
        if (count == 1) return turn;
        return after(typemesh::affine{.dx = n[1], .dy = n[2]}, after(turn, typemesh::affine{.dx = -n[1], .dy = -n[2]}));
    }
    if (name == "skewX" && count == 1) return typemesh::affine{.xy = std::tan(n[0] * degree)};
    if (name == "skewY" && count == 1) return typemesh::affine{.yx = std::tan(n[0] * degree)};
    return {};
}

}  // namespace

std::string_view trimmed(std::string_view text)
{
    skip_blanks(text);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lower(std::string_view text)
{
    std::string made{text};
    for (char& c : made)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return made;
}

std::optional<double> take_number(std::string_view& text)
{
    skip_blanks(text);
    const auto value = take_bare_number(text);
    if (!value) return {};
    skip_blanks(text);
    if (text.starts_with(',')) text.remove_prefix(1);
    skip_blanks(text);
    return value;
}

std::optional<std::vector<double>> read_numbers(std::string_view text)
{
    std::vector<double> all;
    for (skip_blanks(text); !text.empty();) {
        const auto value = take_number(text);
        if (!value) return {};
        all.push_back(*value);
    }
    return all;
}

std::optional<double> read_length(std::string_view text, double whole)
{
    text = trimmed(text);
    const auto value = take_bare_number(text);
    if (!value) return {};
    constexpr std::pair<std::string_view, double> units[] = {
        {"", 1.0},    {"px", 1.0},         {"pt", 96.0 / 72.0}, {"pc", 16.0},  {"mm", 96.0 / 25.4}, {"cm", 96.0 / 2.54},
        {"in", 96.0}, {"q", 96.0 / 101.6}, {"em", 16.0},        {"rem", 16.0}, {"ex", 8.0}};
    const std::string unit = lower(text);
    std::optional<double> length;
    if (unit == "%") length = *value / 100.0 * whole;
    for (const auto& [name, size] : units)
        if (unit == name) length = *value * size;
    return length && std::isfinite(*length) ? length : std::nullopt;
}

typemesh::affine after(const typemesh::affine& outer, const typemesh::affine& inner)
{
    const typemesh::point shift = outer({inner.dx, inner.dy});
    return {outer.xx * inner.xx + outer.xy * inner.yx, outer.xx * inner.xy + outer.xy * inner.yy, shift.x,
            outer.yx * inner.xx + outer.yy * inner.yx, outer.yx * inner.xy + outer.yy * inner.yy, shift.y};
}

bool is_flat(const typemesh::affine& map) { return !(std::fabs(map.xx * map.yy - map.xy * map.yx) > 0.0); }

double stretch_of(const typemesh::affine& map)
{
    // The larger singular value, from the parts of the map that turn and that mirror.
    return 0.5 * (std::hypot(map.xx + map.yy, map.yx - map.xy) + std::hypot(map.xx - map.yy, map.yx + map.xy));
}

std::optional<typemesh::affine> read_transform(std::string_view text)
{
    typemesh::affine all;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const auto open = text.find('('), close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
        const auto numbers = read_numbers(text.substr(open + 1, close - open - 1));
        if (!numbers) return {};
        const auto one = transform_of(std::string{trimmed(text.substr(0, open))}, *numbers);
        if (!one) return {};
        all = after(all, *one);
        text.remove_prefix(close + 1);
        text = trimmed(text);
        if (text.starts_with(',')) text.remove_prefix(1);
    }
    return all;
}

std::optional<typemesh::box> read_view_box(std::string_view text)
{
    const auto n = read_numbers(text);
    if (!n || n->size() != 4 || !((*n)[2] > 0.0) || !((*n)[3] > 0.0)) return {};
    return typemesh::box{{(*n)[0], (*n)[1]}, {(*n)[0] + (*n)[2], (*n)[1] + (*n)[3]}};
}

typemesh::affine view_map(const typemesh::box& view, const typemesh::box& port, std::string_view how)
{
    const typemesh::point from = view.high - view.low, to = port.high - port.low;
    double sx = to.x / from.x, sy = to.y / from.y;
    const bool stretched = how.find("none") != std::string_view::npos;
    if (!stretched) sx = sy = how.find("slice") != std::string_view::npos ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](std::string_view least, std::string_view most) {
        return how.find(least) != std::string_view::npos ? 0.0 : how.find(most) != std::string_view::npos ? 1.0 : 0.5;
    };
    const double free_x = to.x - sx * from.x, free_y = to.y - sy * from.y;
    return {.xx = sx,
            .dx = port.low.x + (stretched ? 0.0 : free_x * share("xMin", "xMax")) - sx * view.low.x,
            .yy = sy,
            .dy = port.low.y + (stretched ? 0.0 : free_y * share("YMin", "YMax")) - sy * view.low.y};
}

std::string name_of_reference(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with("url(")) {
        text.remove_prefix(4);
        text = trimmed(text.substr(0, text.find(')')));
        if (text.size() > 1 && (text.front() == '"' || text.front() == '\'')) text = text.substr(1, text.size() - 2);
    }
    return text.starts_with('#') ? std::string{text.substr(1)} : std::string{};
}

}  // namespace text_to_mesh

// SPDX-License-Identifier: MIT
#include "chosen_path.hpp"

#include "option_values.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// Numbers with commas or blanks between them. False if there is anything else.
bool read_numbers(std::string_view written, std::vector<double>& out)
{
    out.clear();
    for (;;) {
        const auto first = written.find_first_not_of(", ");
        if (first == std::string_view::npos) return true;
        written.remove_prefix(first);
        const auto end = written.find_first_of(", ");
        const std::optional<double> number = decimal(written.substr(0, end));
        if (!number) return false;
        out.push_back(*number);
        if (end == std::string_view::npos) return true;
        written.remove_prefix(end);
    }
}

/// The commands M, L, Q, C and Z of SVG, with y up.
bool draw_commands(std::string_view written, plane_path& way)
{
    std::vector<double> n;
    while (!written.empty()) {
        const char command = written[0];
        const auto end = written.find_first_of("MLQCZ", 1);
        if (!read_numbers(written.substr(1, end == std::string_view::npos ? end : end - 1), n)) return false;
        const std::size_t each = command == 'Z' ? 0 : command == 'Q' ? 4 : command == 'C' ? 6 : 2;
        if (std::string_view{"MLQCZ"}.find(command) == std::string_view::npos) return false;
        if (each == 0 ? !n.empty() : n.empty() || n.size() % each != 0) return false;
        if (command == 'M' && n.size() != 2) return false;
        if (command == 'Z') way.close();
        for (std::size_t i = 0; i < n.size(); i += each) {
            if (command == 'M') way.move({n[i], n[i + 1]});
            if (command == 'L') way.line({n[i], n[i + 1]});
            if (command == 'Q') way.quadratic({n[i], n[i + 1]}, {n[i + 2], n[i + 3]});
            if (command == 'C') way.cubic({n[i], n[i + 1]}, {n[i + 2], n[i + 3]}, {n[i + 4], n[i + 5]});
        }
        written.remove_prefix(end == std::string_view::npos ? written.size() : end);
    }
    return true;
}

/// An arc with its top in the middle; with a negative radius, a bowl.
void draw_arc(double radius, double degrees, plane_path& way)
{
    const double side = radius < 0.0 ? -1.0 : 1.0, half = 0.5 * degrees * 0.017453292519943295;
    const point centre{0.0, -radius};
    way.move(centre + std::fabs(radius) * point{-std::sin(half), side * std::cos(half)});
    way.arc(centre, -side * degrees);
}

/// Eight waves of quadratics, with the text's middle where the fifth one begins.
void draw_wave(double height, double length, plane_path& way)
{
    const double step = 0.5 * length;
    way.move({-8.0 * step, 0.0});
    for (int i = -8; i < 8; ++i)
        way.quadratic({(i + 0.5) * step, i % 2 == 0 ? 2.0 * height : -2.0 * height}, {(i + 1) * step, 0.0});
}

}  // namespace

std::string read_path(std::string_view written, chosen_path& out)
{
    const std::string wrong =
        "must be circle:RADIUS, arc:RADIUS,DEGREES, wave:HEIGHT,LENGTH or a path such as \"M0,0 C1,1 2,1 3,0\", not " +
        std::string{written};
    const auto way = std::make_shared<plane_path>();
    std::vector<double> n;
    const auto is = [&](std::string_view name, std::size_t count) {
        return written.substr(0, name.size()) == name && read_numbers(written.substr(name.size()), n) &&
               n.size() == count;
    };
    if (is("circle:", 1)) {
        way->circle({0.0, 0.0}, std::fabs(n[0]));
        if (n[0] < 0.0) out.how.side = path_side::right;
    } else if (is("arc:", 2)) {
        draw_arc(n[0], n[1], *way);
    } else if (is("wave:", 2)) {
        draw_wave(n[0], n[1], *way);
    } else if (written.empty() || written[0] != 'M' || !draw_commands(written, *way)) {
        return wrong;
    }
    if (way->failure() || way->empty()) return "has a number that is out of range: " + std::string{written};
    out.curve = way;
    return {};
}

}  // namespace text_to_mesh

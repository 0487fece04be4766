// SPDX-License-Identifier: MIT
#include "chosen_bend.hpp"

#include "option_values.hpp"

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace text_to_mesh {
namespace {

using namespace typemesh;

struct kind {
    std::string_view name;
    std::size_t numbers;  ///< that follow it
};
constexpr kind kinds[] = {{"cylinder", 1}, {"sphere", 1}, {"twist", 1}, {"taper", 1},      {"wave", 2},
                          {"arc", 1},      {"arch", 2},   {"flag", 2},  {"perspective", 1}};

}  // namespace

std::string read_bend(std::string_view written, chosen_bend& out, chosen_warp& warp)
{
    const std::string wrong =
        "must be cylinder:RADIUS, sphere:RADIUS, twist:DEGREES, taper:GROWTH, wave:HEIGHT,LENGTH, arc:DEGREES, "
        "arch:TOP,BASELINE, flag:HEIGHT,LENGTH or perspective:SCALE, not " +
        std::string{written};
    const auto colon = written.find(':');
    if (colon == std::string_view::npos) return wrong;
    const std::string_view name = written.substr(0, colon);
    std::vector<double> numbers;
    for (std::string_view rest = written.substr(colon + 1);;) {
        const auto comma = rest.find(',');
        const std::optional<double> number = decimal(rest.substr(0, comma));
        if (!number) return wrong;
        numbers.push_back(*number);
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    for (const kind& k : kinds)
        if (k.name == name && k.numbers != numbers.size()) return wrong;
    if (name == "cylinder")
        out.of = on_cylinder{.radius = numbers[0]};
    else if (name == "sphere")
        out.of = on_sphere{.radius = numbers[0]};
    else if (name == "twist")
        out.of = twist{.degrees_per_em = numbers[0], .across = 0.35};
    else if (name == "taper")
        out.of = taper{.growth = numbers[0]};
    else if (name == "wave")
        out.of = displaced<wave>{{.height = numbers[0], .length = numbers[1]}};
    else if (name == "arc")
        warp = arc{.degrees = numbers[0]};
    else if (name == "arch")
        warp = arch{.rise = numbers[0], .baseline = numbers[1]};
    else if (name == "flag")
        warp = flag{.height = numbers[0], .length = numbers[1]};
    else if (name == "perspective")
        warp = perspective{.scale = numbers[0]};
    else
        return wrong;
    const bool refused = std::visit(
        [](const auto& w) noexcept {
            if constexpr (plane_warp<std::decay_t<decltype(w)>>)
                return bool{w.refused_options()};
            else
                return false;
        },
        warp);
    if (refused) return "has a number that is out of range: " + std::string{written};
    if (out.refused_options()) return "must not have a 0 here: " + std::string{written};
    return {};
}

}  // namespace text_to_mesh

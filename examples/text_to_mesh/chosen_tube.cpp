// SPDX-License-Identifier: MIT
#include "chosen_tube.hpp"

#include "option_values.hpp"

#include <cmath>

namespace text_to_mesh {

std::string read_tube(std::string_view written, chosen_tube& out)
{
    const std::string wanted =
        "must be a radius from 0.001 to 1, and with a comma 3 to 128 sides, such as 0.02,24; not ";
    const auto comma = written.find(',');
    const auto radius = decimal(written.substr(0, comma));
    if (!radius || !(*radius >= 0.001 && *radius <= 1.0)) return wanted + std::string{written};
    out.radius = static_cast<float>(*radius);
    if (comma == std::string_view::npos) return {};
    const auto sides = decimal(written.substr(comma + 1));
    if (!sides || !(*sides >= 3.0 && *sides <= 128.0) || std::floor(*sides) < *sides)
        return wanted + std::string{written};
    out.sides = static_cast<unsigned>(*sides);
    return {};
}

}  // namespace text_to_mesh

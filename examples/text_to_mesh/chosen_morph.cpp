// SPDX-License-Identifier: MIT
#include "chosen_morph.hpp"

#include "option_values.hpp"

#include <string>

namespace text_to_mesh {

std::string read_morph(std::string_view written, chosen_morph& out)
{
    const std::string wanted = "must have the form wght=100..900, with the smaller number first, not ";
    const auto equals = written.find('='), dots = written.find("..");
    if (equals != 4 || dots == std::string_view::npos || dots < equals) return wanted + std::string{written};
    const auto from = decimal(written.substr(equals + 1, dots - equals - 1)), to = decimal(written.substr(dots + 2));
    if (!from || !to || !(*from < *to)) return wanted + std::string{written};
    out = {std::string{written.substr(0, equals)}, *from, *to};
    return {};
}

}  // namespace text_to_mesh

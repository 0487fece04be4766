// SPDX-License-Identifier: MIT
#include "chosen_stroke.hpp"

#include "option_values.hpp"

#include <algorithm>

namespace text_to_mesh {

std::string read_stroke(std::string_view written, chosen_stroke& out)
{
    using namespace typemesh;
    const std::string given = '"' + std::string{written} + '"';
    const auto take = [&written] {
        const auto comma = std::min(written.find(','), written.size());
        const std::string_view one = written.substr(0, comma);
        written.remove_prefix(std::min(comma + 1, written.size()));
        return one;
    };
    const auto width = decimal(take());
    if (!width || !(*width > 0.0) || *width > 10.0)
        return "must begin with a width above 0 and up to 10, such as 0.03 or 0.03,round, not " + given;
    out = {.width = *width, .dashes = {}};
    while (!written.empty()) {
        const std::string_view one = take();
        if (one == "round") {
            out.cap = stroke_cap::round;
            out.join = stroke_join::round;
        } else if (one == "square" || one == "butt") {
            out.cap = one == "butt" ? stroke_cap::butt : stroke_cap::square;
        } else if (one == "bevel" || one == "mitre" || one == "miter") {
            out.join = one == "bevel" ? stroke_join::bevel : stroke_join::mitre;
        } else if (const auto length = decimal(one); length && *length >= 0.0 && *length <= 1000.0) {
            out.dashes.push_back(*length);
        } else {
            return "must have round, square, butt, bevel, mitre or lengths of dashes behind its width, not " + given;
        }
    }
    return {};
}

}  // namespace text_to_mesh

// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <string_view>

namespace text_to_mesh {

/// The usual colours of the faces, of the sides and of the bevels, in sRGB: of pictures and of the materials of files.
inline constexpr unsigned char face_rgb[3] = {240, 104, 64}, side_rgb[3] = {206, 70, 48}, bevel_rgb[3] = {248, 146, 84};

/// The colours of the letter within a ring, and of a plate.
inline constexpr unsigned char letter_face_rgb[3] = {250, 232, 208}, letter_side_rgb[3] = {222, 196, 166};

/// The colour of a part by its name: see model::part.
[[nodiscard]] constexpr const unsigned char (&colour_of(std::string_view part))[3]
{
    if (part == "letter_side" || part == "plate_side" || part == "cut_side") return letter_side_rgb;
    if (part == "letter_front" || part == "letter_back" || part.substr(0, 5) == "plate") return letter_face_rgb;
    return part == "side" || part == "pocket_side"         ? side_rgb
           : part == "front_bevel" || part == "back_bevel" ? bevel_rgb
                                                           : face_rgb;
}

/// The colour of a part. Of a style's own the front has it, sides are darker and bevels lighter, and a letter within a
/// ring is much lighter, or darker if the ring is light.
[[nodiscard]] inline rgb_colour colour_of(const model::part& part)
{
    if (!part.colour) {
        const auto& usual = colour_of(part.kind());
        return {{usual[0], usual[1], usual[2]}};
    }
    rgb_colour made = *part.colour;
    const bool side = part.name.find("side") != std::string::npos, bevel = part.name.find("bevel") != std::string::npos;
    const bool letter = part.name.find("letter_") == 0, light = made.rgb[0] + made.rgb[1] + made.rgb[2] > 3 * 190;
    for (unsigned char& c : made.rgb) {
        if (letter) c = static_cast<unsigned char>(light ? c / 2 : c + (255 - c) * 2 / 3);
        if (side) c = static_cast<unsigned char>(c * 8 / 10);
        if (bevel) c = static_cast<unsigned char>(c + (255 - c) / 5);
    }
    return made;
}

}  // namespace text_to_mesh

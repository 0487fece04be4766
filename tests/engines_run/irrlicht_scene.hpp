// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// What Irrlicht says of a text in one of its mesh buffers. Plain C++: Irrlicht on one side, C++20 on the other.
struct irrlicht_findings {
    std::string failure;  ///< empty when all is well
    std::vector<float> positions, normals, uvs;
    std::vector<unsigned> indices;
    unsigned colours_wrong = 0;       ///< vertices whose colour is not the one asked for
    unsigned turned = 0;              ///< triangles whose normal, as Irrlicht makes it, looks against their vertices'
    float low[3] = {}, high[3] = {};  ///< the buffer's box
    bool front_hit = false;  ///< a ray from -z meets the front of the stem of an L (asked of 16-bit buffers alone)
};

enum class irrlicht_buffer { small, dynamic };

irrlicht_findings look_with_irrlicht(const char* font_file, const char* utf8, irrlicht_buffer kind);

// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/face_instances.hpp"
#include "support/font_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace test {

/// Calls of(font, glyph, name) for every `step`th glyph of the smoke fonts in the tests' set-up.
template <class F>
void each_smoke_glyph(std::size_t step, const F& of)
{
    for (const font_package& package : smoke_fonts()) {
        if (!package.required) continue;
        std::size_t in_package = 0;  // continues from face to face, so that faces do not repeat each other
        for (const std::string& file : font_files(package)) {
            for (const face_instance& face : instances_of(file)) {
                auto font = face.open();
                REQUIRE(font);
                for (std::uint32_t g = 0; g < face.glyph_count; ++g)
                    if (in_package++ % step == 0)
                        of(*font, g,
                           file + "@" + std::to_string(face.face) + ":" + std::to_string(g) + " " + face.name());
            }
        }
    }
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/harfbuzz.hpp>

#include <utility>

namespace test {

// Fonts that several files of this room open.
inline const char* const dejavu = "truetype/dejavu/DejaVuSans.ttf";
inline const char* const amiri = "opentype/fonts-hosny-amiri/Amiri-Regular.ttf";
inline const char* const inter = "truetype/inter-vf/Inter-roman.var.ttf";
inline const char* const microhei = "truetype/wqy/wqy-microhei.ttc";
inline const char* const sawarabi = "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf";  // with vertical metrics

/// A font by HarfBuzz, or a failed test.
inline typemesh::harfbuzz_font opened(const char* name, const typemesh::font_options& options = {})
{
    auto font = typemesh::harfbuzz_font::open(font_file(name).c_str(), options);
    INFO(font.error().message());
    REQUIRE(font);
    return std::move(*font);
}

}  // namespace test

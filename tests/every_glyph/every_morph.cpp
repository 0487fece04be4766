// SPDX-License-Identifier: MIT
//
//     every_morph FONT AXIS [STEP [PLACES]]      AXIS: a tag, such as wght
//
// Makes a morph of every mapped glyph of a variable font, or of one in STEP, and compares it with the font opened at 33
// places of the axis. Prints what was found; the status is 0 if no law is broken.

#include "morph_laws.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

int main(int argc, char** argv)
{
    if (argc < 3 || std::strlen(argv[2]) != 4) return std::puts("usage: every_morph FONT AXIS [STEP [PLACES]]"), 2;
    char tag[5] = {};
    std::memcpy(tag, argv[2], 4);
    const std::size_t step = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1,
                      places = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 33;
    test::morph_laws laws{argv[1], tag, places};
    const auto glyphs = test::mapped_glyphs(laws.font());
    for (std::size_t i = 0; i < glyphs.size(); i += step) laws.examine(glyphs[i]);
    test::morph_findings f = laws.found();
    std::sort(f.normal_errors.begin(), f.normal_errors.end());
    const auto quantile = [&f](double share) {
        if (f.normal_errors.empty()) return 0.0;
        return 57.29577951308232 *
               f.normal_errors[static_cast<std::size_t>(share * static_cast<double>(f.normal_errors.size() - 1))];
    };
    std::printf(
        "%s %s: %zu glyphs that are not blank: %zu whole, %zu of overlapping solids, %zu split, %zu partly refused, "
        "%zu refused, %zu pinched; %zu meshes; a vertex at most %.3f cells off, the outline at most %.3f "
        "tolerances off; %zu triangles turned; normals: half of the glyphs below %.2f degrees, 99 %% below %.2f, all "
        "below %.2f\n",
        argv[1], argv[2], f.glyphs, f.whole, f.overlapping, f.split, f.partly_refused, f.refused, f.pinched, f.places,
        f.far, f.off, f.turned, quantile(0.5), quantile(0.99), quantile(1.0));
    if (!f.wrong.empty()) std::puts(f.wrong.c_str());
    return f.wrong.empty() ? 0 : 1;
}

// SPDX-License-Identifier: MIT
//
//     every_boundary [--quality low|normal|high|best]... [--step N] [NAME=]FILE_OR_FOLDER...
//
// Fills every glyph of every face of the fonts (variable ones also at each axis' ends and at mixed corners), gives its
// boundary back as curves, flattens and fills these again, and compares: support/redrawn_glyph.hpp. The same after they
// have been written as path data of SVG and read again. Prints what is wrong, and sums; the status is 0 if nothing is.

#include "support/glyph_arguments.hpp"
#include "support/redrawn_glyph.hpp"

#include <typemesh/outline/outline_recorder.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

int main(int argc, char** argv)
{
    using namespace typemesh;
    test::glyph_arguments arguments;
    bool understood = true;
    for (int i = 1; i < argc; ++i) understood = understood && arguments.take(argc, argv, i);
    if (const int status = arguments.start(understood, "every_boundary", 2, 3); status != 0) return status;
    std::size_t glyphs = 0, blank = 0, refused = 0, wrong = 0, meetings = 0, straight = 0, before = 0, after = 0,
                off = 0, files = 0, over = 0;
    double area = 0.0, area_sum = 0.0, moved = 0.0;
    for (const test::glyph_job& job : arguments.jobs()) {
        test::redrawn_glyph again;
        outline curves;
        arguments.each_glyph(job, [&](auto& font, std::uint32_t g) {
            const std::string name = job.face.name() + " " + std::to_string(g);
            ++glyphs;
            if (!record(font, g, curves) || curves.curves.empty()) {
                ++blank;
                return;
            }
            for (const test::quality_named& q : arguments.wanted) {
                if (again.make(curves, font.units_per_em(), q.tolerance)) {
                    ++refused;
                    continue;
                }
                const std::string broken = again.broken_again(4.0);
                if (!broken.empty()) {
                    ++wrong;
                    std::printf("%s at %g em: %s\n", name.c_str(), q.tolerance, broken.c_str());
                }
                const auto f = again.through_a_file();
                if (!f.wrong.empty()) {
                    ++wrong;
                    std::printf("%s at %g em, written and read: %s\n", name.c_str(), q.tolerance, f.wrong.c_str());
                }
                ++files;
                over += f.moved > 1.0 + 2.0 / again.filled.tolerance();
                area = (std::max)(area, f.area);
                area_sum += f.area;
                moved = (std::max)(moved, f.moved);
                const std::size_t places = again.wrong_places(curves, 20, again.filled.tolerance() + 4.0, glyphs);
                if (places != 0) {
                    ++off;
                    std::printf("%s at %g em: %zu of 20 places wrong\n", name.c_str(), q.tolerance, places);
                }
                meetings += again.found().meetings();
                straight += again.found().straight_edges();
                before += curves.curves.size();
                after += again.drawn.curves.size();
            }
        });
    }
    std::printf(
        "glyphs %zu (%zu blank), refused %zu, wrong %zu, with wrong places %zu; meetings %zu, straight edges %zu, "
        "curves %zu, pieces %zu\n",
        glyphs, blank, refused, wrong, off, meetings, straight, before, after);
    std::printf(
        "written and read: %zu, in tolerances: area between the boundaries, over their length, %.3f on average, %.3f "
        "at "
        "most; distance %.3f at most, beyond one tolerance and two cells in %zu\n",
        files, files != 0 ? area_sum / static_cast<double>(files) : 0.0, area, moved, over);
    return wrong + off + refused == 0 ? 0 : 1;
}

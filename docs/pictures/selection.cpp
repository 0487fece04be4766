// SPDX-License-Identifier: MIT
//
// Draws a line of both directions with the boxes of a selection round a range of it, as commands for ImageMagick's
// -draw: see make.sh.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/paragraph/paragraph.hpp>

#include <cstdio>

using namespace typemesh;

namespace {

constexpr double pixels = 90.0;  // per em

/// Writes an outline as a path, which in pictures has y down.
struct path_writer {
    point origin;
    double scale;

    void put(char command, point p) const noexcept
    {
        std::printf("%c%g,%g ", command, scale * (origin.x + p.x), -scale * (origin.y + p.y));
    }
    void move(point p) const noexcept { put('M', p); }
    void line(point p) const noexcept { put('L', p); }
    void quadratic(point c, point p) const noexcept { put('Q', c), put(' ', p); }
    void cubic(point a, point b, point p) const noexcept { put('C', a), put(' ', b), put(' ', p); }
    void close() const noexcept { std::printf("Z "); }
};

}  // namespace

int main(int, char** argv)
{
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    paragraph words{*font};
    glyph_run run;
    const auto laid = words.set(u"one \u05E9\u05EA\u05D9\u05D9\u05DD 12 three").and_then([&]() noexcept {
        return words.lay_out({}, run);
    });
    if (!laid) return std::puts(laid.error().message()), 1;

    std::printf("translate 20,110 stroke '#2060c0' fill '#bcd6ff'\n");
    words.laid().boxes_of(2, 11, [](const box& b) {
        std::printf("rectangle %g,%g %g,%g\n", pixels * b.low.x, -pixels * b.high.y, pixels * b.high.x,
                    -pixels * b.low.y);
    });
    std::printf("stroke none fill '#202430'\n");
    for (const placed_glyph& g : run.glyphs) {
        if (words.shaped().text().unit(g.cluster) == ' ') continue;
        std::printf("path '");
        path_writer to{g.origin, pixels / font->units_per_em()};
        if (error wrong = font->outline(g.id, to)) return std::puts(wrong.message()), 1;
        std::printf("'\n");
    }
    return 0;
}

// SPDX-License-Identifier: MIT
//
// Draws what stands beside letters: rubies, backgrounds, and a star in each inline box, as commands for ImageMagick's
// -draw: see make.sh.
//
//     beside FONT WIDTH MARKUP      a width in em; columns of this height if it is negative

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/inline_box_place.hpp>
#include <typemesh/markup/markup_styles.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/ruby_writer.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace typemesh;

namespace {

constexpr double pixels = 60.0;  // per em

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

int wrong(const error& e) { return std::fprintf(stderr, "%s\n", e.message()), 1; }

}  // namespace

int main(int, char** argv)
{
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return wrong(font.error());
    const double width = std::atof(argv[2]);
    const bool down = width < 0.0;

    markup marked;
    if (auto read = marked.read(std::string_view{argv[3]}); !read) return wrong(read.error());
    markup_styles tagged;
    if (auto set = tagged.set(marked); !set) return wrong(set.error());
    std::vector<ruby_span> small_texts;
    marked.each_ruby([&](std::uint32_t first, std::uint32_t last, std::string_view ruby, std::uint32_t look) {
        small_texts.push_back({first, last, ruby, tagged.style_of(look)});
    });

    const direction way = down ? direction::top_to_bottom : direction::automatic;
    const ruby_options how{.overhang = 0.25, .shape = {.direction = way}};
    ruby_writer rubies;
    highlight_writer backgrounds;
    paragraph words{*font};
    glyph_run page;
    const auto rooms = rubies.rooms(*font, marked.text(), small_texts, how);
    if (!rooms) return wrong(rooms.error());
    auto done = words.set(marked.text(),
                          {.direction = way, .styles = tagged.spans(), .boxes = marked.boxes(), .rooms = *rooms});
    if (done) done = words.lay_out({.width = std::fabs(width), .align = alignment::left}, page);
    if (done)
        done = backgrounds.write(*font, words.laid(), tagged.marks(), {.pad_along = 0.08, .radius = 0.2}, page);
    if (done) done = rubies.write(*font, words.laid(), small_texts, how, page);
    if (!done) return wrong(done.error());

    const box first = words.laid().line_box(0);
    std::printf("translate %g,%g stroke none\n", 20.0 + (down ? pixels * 6.3 : 0.0), 20.0 + pixels * first.high.y);
    for (const placed_glyph& g : page.glyphs) {
        const glyph_style drawn = page.glyph_styles.empty() ? glyph_style{} : page.glyph_styles[g.glyph_style];
        if (drawn.face == bar_face && is_blank_bar(g.id)) continue;
        if (g.cluster != no_cluster && words.shaped().text().unit(g.cluster) == ' ') continue;
        const markup_paint& paint = tagged.paints()[static_cast<std::size_t>(drawn.style)];
        std::printf("fill '#%06x' path '", paint.tags != 0 ? static_cast<unsigned>(paint.colour) : 0x202430u);
        path_writer to{g.origin, pixels / font->units_per_em()};
        mapped_face<harfbuzz_font> face{*font, drawn.face, &drawn.map, font->units_per_em()};
        if (error e = face.outline(g.id, to)) return wrong(e);
        std::printf("'\n");
    }
    each_inline_box(page, [&](const inline_box_place& b) {
        std::printf("fill '#e0a000' path '");
        const path_writer to{{0.0, 0.0}, pixels};
        for (int i = 0; i < 10; ++i) {
            const double turn = 0.62831853 * i, r = i % 2 == 0 ? 0.5 : 0.22;
            to.put(i == 0 ? 'M' : 'L', b.map({0.5 + r * std::sin(turn), 0.5 + r * std::cos(turn)}));
        }
        std::printf("Z'\n");
    });
    return 0;
}

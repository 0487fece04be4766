// SPDX-License-Identifier: MIT
#pragma once

// Colour tables that a test makes itself, byte by byte.

#include <typemesh/colour/colour_tables.hpp>
#include <typemesh/outline/recorded_outlines.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace test {

/// Bytes, to which big-endian numbers are added.
struct table_writer {
    std::vector<std::byte> bytes;

    table_writer& put(std::uint32_t value, int size)
    {
        for (int i = size; i-- > 0;) bytes.push_back(static_cast<std::byte>(value >> 8 * i & 0xFF));
        return *this;
    }
    table_writer& u8(std::uint32_t v) { return put(v, 1); }
    table_writer& u16(std::uint32_t v) { return put(v, 2); }
    table_writer& u24(std::size_t v) { return put(static_cast<std::uint32_t>(v), 3); }
    table_writer& u32(std::size_t v) { return put(static_cast<std::uint32_t>(v), 4); }
    table_writer& i16(int v) { return put(static_cast<std::uint32_t>(v), 2); }
    table_writer& fraction(double v) { return i16(static_cast<int>(std::lround(v * 16384))); }  // 2.14
    table_writer& fixed(double v) { return put(static_cast<std::uint32_t>(std::lround(v * 65536)), 4); }
    table_writer& add(const table_writer& more)
    {
        bytes.insert(bytes.end(), more.bytes.begin(), more.bytes.end());
        return *this;
    }
    [[nodiscard]] std::size_t size() const { return bytes.size(); }
};

/// A paint of COLR version 1 with all that it refers to behind it, so that paints nest as they are written.
using paint = table_writer;

inline paint solid_paint(unsigned entry, double alpha = 1.0) { return paint{}.u8(2).u16(entry).fraction(alpha); }
inline paint glyph(const paint& inner, unsigned id) { return paint{}.u8(10).u24(6).u16(id).add(inner); }
inline paint colr_glyph(unsigned id) { return paint{}.u8(11).u16(id); }
inline paint colr_layers(unsigned count, unsigned first) { return paint{}.u8(1).u8(count).u32(first); }
inline paint composite(const paint& source, unsigned mode, const paint& backdrop)
{
    return paint{}.u8(32).u24(8).u8(mode).u24(8 + source.size()).add(source).add(backdrop);
}
/// A transform of the formats 14 to 31; `var_index` of odd formats.
inline paint moved(unsigned format, std::initializer_list<double> fractions, std::initializer_list<int> units,
                   const paint& inner, std::uint32_t var_index = 0xFFFF'FFFFu)
{
    table_writer numbers;
    for (const double f : fractions) numbers.fraction(f);
    for (const int u : units) numbers.i16(u);
    if (format % 2 == 1) numbers.u32(var_index);
    return paint{}.u8(format).u24(4 + numbers.size()).add(numbers).add(inner);
}
inline paint transformed(const double (&m)[6], const paint& inner)
{
    paint p = paint{}.u8(12).u24(7 + 24).u24(7);
    for (const double v : m) p.fixed(v);
    return p.add(inner);
}

struct stop {
    double at;
    unsigned entry;
    double alpha = 1.0;
};
inline table_writer colour_line(unsigned extend, std::initializer_list<stop> stops)
{
    table_writer line = table_writer{}.u8(extend).u16(static_cast<unsigned>(stops.size()));
    for (const stop& s : stops) line.fraction(s.at).u16(s.entry).fraction(s.alpha);
    return line;
}
inline paint linear(std::initializer_list<int> numbers, const table_writer& line)
{
    paint p = paint{}.u8(4).u24(16);
    for (const int n : numbers) p.i16(n);
    return p.add(line);
}
inline paint radial(std::initializer_list<int> numbers, const table_writer& line)
{
    paint p = paint{}.u8(6).u24(16);
    for (const int n : numbers) p.i16(n);
    return p.add(line);
}
inline paint sweep(int x, int y, double from, double to, const table_writer& line)
{
    return paint{}.u8(8).u24(12).i16(x).i16(y).fraction(from - 1.0).fraction(to - 1.0).add(line);
}

/// The tables of a font.
struct colour_font {
    table_writer colr, cpal;
    std::vector<std::int32_t> axes;

    [[nodiscard]] typemesh::colour_tables tables() const { return {colr.bytes, cpal.bytes, axes}; }
};

/// Red, green, blue, half transparent white; and a second palette: cyan, magenta, yellow, black.
inline table_writer two_palettes()
{
    table_writer t = table_writer{}.u16(0).u16(4).u16(2).u16(8).u32(16).u16(0).u16(4);
    for (const std::uint32_t bgra :
         {0x0000FFFFu, 0x00FF00FFu, 0xFF0000FFu, 0xFFFFFF80u, 0xFFFF00FFu, 0xFF00FFFFu, 0x00FFFFFFu, 0x000000FFu})
        t.u32(bgra);
    return t;
}

struct flat_glyph {
    unsigned id;
    std::vector<std::pair<unsigned, unsigned>> layers;  // glyph, palette entry
};

/// A font of COLR version 0; the glyphs ascend.
inline colour_font flat_font(const std::vector<flat_glyph>& glyphs)
{
    colour_font made;
    made.cpal = two_palettes();
    table_writer bases, layers;
    unsigned count = 0;
    for (const flat_glyph& g : glyphs) {
        bases.u16(g.id).u16(count).u16(static_cast<unsigned>(g.layers.size()));
        for (const auto& [id, entry] : g.layers) layers.u16(id).u16(entry);
        count += static_cast<unsigned>(g.layers.size());
    }
    made.colr.u16(0).u16(static_cast<unsigned>(glyphs.size())).u32(14).u32(14 + bases.size()).u16(count);
    made.colr.add(bases).add(layers);
    return made;
}

struct painted_glyph {
    unsigned id;
    paint root;
};
struct clip_box {
    unsigned first, last;
    int low_x, low_y, high_x, high_y;
};

/// A font of COLR version 1; the glyphs ascend, and `layers` are for colr_layers(). `store` is an item variation store.
inline colour_font painted_font(const std::vector<painted_glyph>& glyphs, const std::vector<paint>& layers = {},
                                const std::vector<clip_box>& clips = {}, const table_writer& store = {})
{
    colour_font made;
    made.cpal = two_palettes();
    table_writer bases = table_writer{}.u32(glyphs.size()), base_paints;
    for (const painted_glyph& g : glyphs) {
        bases.u16(g.id).u32(4 + 6 * glyphs.size() + base_paints.size());
        base_paints.add(g.root);
    }
    bases.add(base_paints);
    table_writer list = table_writer{}.u32(layers.size()), list_paints;
    for (const paint& p : layers) {
        list.u32(4 + 4 * layers.size() + list_paints.size());
        list_paints.add(p);
    }
    list.add(list_paints);
    table_writer boxes = table_writer{}.u8(1).u32(clips.size()), box_bytes;
    for (const clip_box& c : clips) {
        boxes.u16(c.first).u16(c.last).u24(5 + 7 * clips.size() + box_bytes.size());
        box_bytes.u8(1).i16(c.low_x).i16(c.low_y).i16(c.high_x).i16(c.high_y);
    }
    boxes.add(box_bytes);
    const std::size_t first = 34, second = first + bases.size(), third = second + list.size(),
                      fourth = third + boxes.size();
    made.colr.u16(1).u16(0).u32(0).u32(0).u16(0).u32(first).u32(second).u32(clips.empty() ? 0 : third).u32(0);
    made.colr.u32(store.size() == 0 ? 0 : fourth).add(bases).add(list).add(boxes).add(store);
    return made;
}

/// Squares: glyph i is the square of side 100 * i from (0, 0), in a font of 1000 units per em, up to glyph 9.
inline typemesh::recorded_outlines squares()
{
    typemesh::recorded_outlines font{1000.0};
    for (int i = 0; i < 10; ++i)
        static_cast<void>(font.add([i](auto& pen) {
            if (i == 0) return;
            const double side = 100.0 * i;
            pen.move({0.0, 0.0});
            pen.line({side, 0.0});
            pen.line({side, side});
            pen.line({0.0, side});
            pen.close();
        }));
    return font;
}

}  // namespace test

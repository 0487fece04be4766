// SPDX-License-Identifier: MIT
#pragma once

// A font without a font file: a few drawn glyphs and a shaper that maps characters to them. 1000 units per em.

#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstdlib>
#include <limits>

namespace test {

/// Glyphs: 0 .notdef (a box with a hole), 'o' (round, with a round hole), 'E' (straight lines), 'x' (contours that
/// cross), ' ' (blank), 'i' (a box), '~' (a coordinate that is not a number). Every other character is missing. Advance
/// 600 for all; ascender 800, descender -200.
class toy_font {
public:
    explicit toy_font(typemesh::memory source = typemesh::heap())
        : drawings_{1000.0, typemesh::fill_rule::non_zero, source}
    {
        add([](auto& pen) { box(pen, 50, 0, 500, 700), hole(pen, 100, 50, 450, 650); });
        add([](auto& pen) { ring(pen, 250, 250, 250, true), ring(pen, 250, 250, 150, false); });
        add([](auto& pen) {
            const typemesh::point e[] = {{50, 0},    {450, 0},   {450, 100}, {150, 100}, {150, 300}, {400, 300},
                                         {400, 400}, {150, 400}, {150, 600}, {450, 600}, {450, 700}, {50, 700}};
            pen.move(e[0]);
            for (int i = 1; i < 12; ++i) pen.line(e[i]);
            pen.close();
        });
        add([](auto& pen) { box(pen, 0, 0, 300, 100), box(pen, 100, -100, 200, 300); });
        add([](auto&) {});
        add([](auto& pen) { box(pen, 100, 0, 200, 500); });
        add([](auto& pen) { box(pen, 100, 0, 200, 500); });
    }

    [[nodiscard]] double units_per_em() const noexcept { return 1000.0; }
    [[nodiscard]] typemesh::fill_rule fill() const noexcept { return typemesh::fill_rule::non_zero; }

    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id id, Sink& sink) noexcept
    {
        if (id == 6)
            return sink.move({0, 0}), sink.line({std::numeric_limits<double>::quiet_NaN(), 1}), typemesh::error{};
        return drawings_.outline(id, sink);
    }

    [[nodiscard]] typemesh::line_metrics metrics(typemesh::direction) const noexcept { return {800.0, -200.0, 0.0}; }

    typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item, const typemesh::shape_options&,
                          typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
    {
        using namespace typemesh;
        for (std::uint32_t k = item.first; k < item.last; ++k) {
            const std::uint32_t i = item.to_the_left() ? item.first + item.last - 1 - k : k;
            const glyph_id id = glyph_of(text.unit(i));
            const glyph_flags flags = id == 0 ? glyph_flags::missing : glyph_flags::none;
            if (!glyphs.push_back({id, i, 600.0, {}, 0, flags})) return error::out_of_memory;
        }
        return {};
    }

    static typemesh::glyph_id glyph_of(std::uint32_t character)
    {
        switch (character) {
        case 'o': return 1;
        case 'E': return 2;
        case 'x': return 3;
        case ' ': return 4;
        case 'i': return 5;
        case '~': return 6;
        default: return 0;
        }
    }

private:
    template <class Draw>
    void add(Draw draw)
    {
        if (!drawings_.add(draw)) std::abort();
    }
    template <class Pen>
    static void box(Pen& pen, double l, double b, double r, double t)
    {
        pen.move({l, b}), pen.line({r, b}), pen.line({r, t}), pen.line({l, t}), pen.close();
    }
    template <class Pen>
    static void hole(Pen& pen, double l, double b, double r, double t)
    {
        pen.move({l, b}), pen.line({l, t}), pen.line({r, t}), pen.line({r, b}), pen.close();
    }
    template <class Pen>
    static void ring(Pen& pen, double x, double y, double r, bool ccw)
    {
        const double k = 0.5522847498 * r, s = ccw ? 1.0 : -1.0;
        pen.move({x + r, y});
        pen.cubic({x + r, y + s * k}, {x + k, y + s * r}, {x, y + s * r});
        pen.cubic({x - k, y + s * r}, {x - r, y + s * k}, {x - r, y});
        pen.cubic({x - r, y - s * k}, {x - k, y - s * r}, {x, y - s * r});
        pen.cubic({x + k, y - s * r}, {x + r, y - s * k}, {x + r, y});
        pen.close();
    }

    typemesh::recorded_outlines drawings_;
};

}  // namespace test

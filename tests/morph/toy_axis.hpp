// SPDX-License-Identifier: MIT
#pragma once

// A variable font without a font file, with one axis.

#include <typemesh/layout/variation_axis.hpp>
#include <typemesh/unicode/utf.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace test {

/// An axis from -1 to 1 with masters at both ends and at 0. Between masters everything is linear in v, its value:
///
///     'o'  a ring of quadratics with a hole        'x'  two bars that cross
///     '8'  a stroke that overlaps itself           'w'  a box with a hole that leaves it above 0.5
///     'p'  a triangle and a dot that is a point    'q'  a closing line that has no length at -1
///          at -1
///     'r'  an 'o' below 1000/16384, an 'x' from there on
///     's'  a bar past which a tooth moves          ' '  blank; all others are missing
///     'R'  an 'x' below 1000/16384, an 'o' from there on
///
/// Only drawn:   'l'  a box, which is enormous at 0        '#'  144 boxes with holes, and an 'x'
///               '*'  a star of 901 points, whose edges cross nearly all others
///               'h'  curves that begin with hooks, which coarse chords omit: smoothly after a line, and at -1 only
///
/// 1000 units per em. An advance is 500 + 100 v; below 0 it is 500 + 40 v.
class toy_axis {
public:
    class toy_font {
    public:
        [[nodiscard]] double units_per_em() const noexcept { return 1000.0; }
        [[nodiscard]] typemesh::fill_rule fill() const noexcept { return typemesh::fill_rule::non_zero; }
        [[nodiscard]] typemesh::line_metrics metrics(typemesh::direction) const noexcept
        {
            return {800.0, -200.0, 0.0};
        }

        typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item, const typemesh::shape_options&,
                              typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
        {
            using namespace typemesh;
            for (std::uint32_t i = item.first; i < item.last; ++i) {
                char32_t c = text.unit(i);
                if (c == 'r') c = at < 1000 ? 'o' : 'x';
                if (c == 'R') c = at < 1000 ? 'x' : 'o';
                const bool known =
                    c == 'o' || c == 'x' || c == '8' || c == 'w' || c == 'p' || c == 'q' || c == 's' || c == ' ';
                const double v = static_cast<double>(at) / 16384.0;
                if (!glyphs.push_back({known ? static_cast<glyph_id>(c) : 0u,
                                       i,
                                       500.0 + (v < 0.0 ? 40.0 : 100.0) * v,
                                       {},
                                       0,
                                       known ? glyph_flags::none : glyph_flags::missing}))
                    return error::out_of_memory;
            }
            return {};
        }

        template <typemesh::outline_sink Sink>
        typemesh::error outline(typemesh::glyph_id id, Sink& pen) noexcept
        {
            const double v = static_cast<double>(at) / 16384.0, bend = v < 0.0 ? 0.5 * v : v;
            switch (id) {
            case 'o':
                ring(pen, 250.0, 240.0 + 10.0 * v, false);
                ring(pen, 250.0, 120.0 - 80.0 * bend, true);
                break;
            case 'x':
                box(pen, 50.0, 200.0 - 40.0 * v, 450.0, 300.0 + 40.0 * v);
                box(pen, 200.0 - 40.0 * v, 0.0, 300.0 + 40.0 * v, 500.0);
                break;
            case '8': {
                const double w = 60.0 + 30.0 * v;  // the stroke goes up, round to the right, and back across itself
                polygon(pen, {{100, 0},
                              {100, 600},
                              {500, 600},
                              {500, 300},
                              {0, 300},
                              {0, 300 - w},
                              {500 + w, 300 - w},
                              {500 + w, 600 + w},
                              {100 - w, 600 + w},
                              {100 - w, 0}});
                break;
            }
            case 'w':
                box(pen, 0.0, 0.0, 400.0, 400.0);
                hole(pen, 250.0 + 200.0 * v, 100.0, 300.0 + 200.0 * v, 300.0);
                break;
            case 'l': box(pen, 0.0, 0.0, at == 0 ? 1e6 : 400.0, 400.0); break;
            case '#':
                for (int i = 0; i < 144; ++i) {
                    const double x = 600.0 + 20.0 * (i % 12), y = 20.0 * (i / 12);
                    box(pen, x, y, x + 15.0 + v, y + 15.0);
                    hole(pen, x + 5.0, y + 5.0, x + 10.0 + v, y + 10.0);
                }
                return outline('x', pen);
            case '*': {
                std::vector<typemesh::point> star;
                for (int i = 0; i < 901; ++i) {
                    const double turn = 6.283185307179586 * 400 / 901 * i;
                    star.push_back({300.0 + 290.0 * std::cos(turn), 300.0 - (290.0 + v) * std::sin(turn)});
                }
                polygon(pen, star);
                break;
            }
            case 'p': {
                const double h = 50.0 * (v + 1.0);
                polygon(pen, {{0, 0}, {300, 400}, {600, 0}});
                polygon(pen, {{700, 100}, {700 + 0.0, 100 + h}, {700 + h, 100}});
                break;
            }
            case 'h':
                pen.move({0, 0});
                pen.line({0, 500});
                pen.quadratic({0, 520}, {400, 300});
                pen.quadratic({430, 290.0 - 20.0 * v}, {400, 0});
                pen.close();
                break;
            case 'q':  // like HarfBuzz, which draws the closing line only if it has a length
                pen.move({0, 0});
                pen.line({0, 500});
                pen.line({400, 500});
                pen.line({200.0 * (v + 1.0), 0});
                if (v > -1.0) pen.line({0, 0});
                pen.close();
                break;
            case 's': {
                const double x = 300.0 + 250.0 * v;
                polygon(pen, {{0, 0}, {0, 400}, {600, 400}, {600, 0}, {x + 20.0, 0}, {x, 390}, {x - 20.0, 0}});
                break;
            }
            default: break;
            }
            return {};
        }

        typemesh::axis_coordinate at = 0;

    private:
        template <class Pen>
        static void polygon(Pen& pen, const std::vector<typemesh::point>& p)
        {
            pen.move(p[0]);
            for (std::size_t i = 1; i < p.size(); ++i) pen.line(p[i]);
            pen.close();
        }
        template <class Pen>
        static void box(Pen& pen, double l, double b, double r, double t)
        {
            polygon(pen, {{l, b}, {l, t}, {r, t}, {r, b}});
        }
        template <class Pen>
        static void hole(Pen& pen, double l, double b, double r, double t)
        {
            polygon(pen, {{l, b}, {r, b}, {r, t}, {l, t}});
        }
        template <class Pen>
        static void ring(Pen& pen, double middle, double r, bool ccw)
        {
            const double k = 0.41421356 * r, m = middle;
            std::array<typemesh::point, 16> p = {{{r, 0},
                                                  {r, -k},
                                                  {r * 0.70710678, -r * 0.70710678},
                                                  {k, -r},
                                                  {0, -r},
                                                  {-k, -r},
                                                  {-r * 0.70710678, -r * 0.70710678},
                                                  {-r, -k},
                                                  {-r, 0},
                                                  {-r, k},
                                                  {-r * 0.70710678, r * 0.70710678},
                                                  {-k, r},
                                                  {0, r},
                                                  {k, r},
                                                  {r * 0.70710678, r * 0.70710678},
                                                  {r, k}}};
            for (typemesh::point& q : p) q = {m + q.x, m + (ccw ? -q.y : q.y)};
            pen.move(p[0]);
            for (std::size_t i = 0; i < 16; i += 2) pen.quadratic(p[i + 1], p[(i + 2) % 16]);
            pen.close();
        }
    };

    [[nodiscard]] double low() const noexcept { return -1.0; }
    [[nodiscard]] double usual() const noexcept { return 0.0; }
    [[nodiscard]] double high() const noexcept { return 1.0; }
    [[nodiscard]] typemesh::axis_coordinate coordinate(double value) noexcept
    {
        return static_cast<typemesh::axis_coordinate>(value * 16384.0);
    }
    typemesh::error append_masters(typemesh::buffer<typemesh::axis_coordinate>& out) const noexcept
    {
        for (const typemesh::axis_coordinate c : masters)
            if (!out.push_back(c)) return typemesh::error::out_of_memory;
        return {};
    }
    typemesh::error append_changes(typemesh::buffer<typemesh::axis_coordinate>& out) const noexcept
    {
        return out.push_back(1000) ? typemesh::error{} : typemesh::error{typemesh::error::out_of_memory};
    }
    typemesh::error move_to(typemesh::axis_coordinate c) noexcept
    {
        font_.at = c;
        return {};
    }
    [[nodiscard]] toy_font& font() noexcept { return font_; }

    std::vector<typemesh::axis_coordinate> masters{16384, -16384, 0, 0};

private:
    toy_font font_;
};
static_assert(typemesh::variation_axis<toy_axis>);

}  // namespace test

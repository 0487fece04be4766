// SPDX-License-Identifier: MIT
#pragma once

// Outlines that are hard for moved edges: contours that nearly coincide, crescents, specks and needles beside letters,
// stars, Koch curves, polygons that cross themselves.

#include <typemesh/outline/outline_recorder.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/regions.hpp"

namespace test {

/// One such outline, the same for the same seed.
class random_outline {
public:
    typemesh::outline curves;
    double units_per_em = 1000.0;
    const char* kind = "";

    explicit random_outline(std::uint64_t seed) : d_{seed}, to_{curves}
    {
        units_per_em = d_.roll(2) != 0 ? 1000.0 : 2048.0;
        const auto rule = d_.roll(2) != 0 ? typemesh::fill_rule::even_odd : typemesh::fill_rule::non_zero;
        switch (d_.roll(8)) {
        case 0: same_twice(); break;
        case 1: star(); break;
        case 2: snowflake(); break;
        case 3: letter_with_crescent(); break;
        case 4: letter_with_specks(); break;
        case 5: polygon_across(); break;
        case 6: moons(); break;
        default: letter_with_needles();
        }
        failed_ = to_.finish();
        curves.rule = rule;
    }
    [[nodiscard]] bool is_usable() const { return !failed_ && !curves.curves.empty(); }

private:
    using point = typemesh::point;
    static constexpr double turn = 6.283185307179586, cell = 1.0 / 512.0;

    [[nodiscard]] double between(double low, double high) { return low + (high - low) * d_.fraction(); }
    [[nodiscard]] double em(double low, double high) { return units_per_em * between(low, high); }
    [[nodiscard]] point anywhere() { return {em(-0.5, 1.2), em(-0.5, 1.2)}; }
    /// A few cells, or none.
    [[nodiscard]] double bit()
    {
        static constexpr double sizes[] = {0.5, 1.0, 4.0};
        return (d_.roll(5) - 2) * cell * sizes[d_.roll(3)];
    }

    void polygon(const std::vector<point>& p)
    {
        to_.move(p[0]);
        for (std::size_t i = 1; i < p.size(); ++i) to_.line(p[i]);
        to_.close();
    }
    /// Of four cubics or quadratics.
    void circle(point m, double radius, bool cubic, bool left, double flatness = 1.0)
    {
        const double way = left ? turn / 4 : -turn / 4;
        const auto at = [&](double quarter, double out) {
            return point{m.x + out * radius * std::cos(way * quarter),
                         m.y + flatness * out * radius * std::sin(way * quarter)};
        };
        to_.move(at(0, 1));
        for (int i = 0; i < 4; ++i) {
            const double handle = std::sqrt(1.0 + 0.5522847498307936 * 0.5522847498307936), slant = 0.32129;
            if (cubic)
                to_.cubic(at(i + slant, handle), at(i + 1 - slant, handle), at(i + 1, 1));
            else
                to_.quadratic(at(i + 0.5, std::sqrt(2.0)), at(i + 1, 1));
        }
        to_.close();
    }
    void letter()
    {
        const double h = 0.7 * units_per_em, s = em(0.02, 0.15);
        const int which = d_.roll(3);
        if (which == 0) polygon({{0, 0}, {h, 0}, {h, s}, {s, s}, {s, h}, {0, h}});
        if (which == 1)
            polygon({{0, 0}, {s, 0}, {h / 2, h - 2 * s}, {h - s, 0}, {h, 0}, {(h + s) / 2, h}, {(h - s) / 2, h}});
        if (which != 2) return;
        circle({h / 2, h / 2}, h / 2, true, true);
        circle({h / 2, h / 2}, h / 2 - s, true, false);
    }

    void same_twice()
    {
        kind = "same twice";
        const double radius = em(0.1, 0.8);
        const bool cubic = d_.roll(2) != 0;
        circle({0, 0}, radius, cubic, true);
        circle({bit(), bit()}, radius + bit(), cubic, d_.roll(2) != 0);
        if (d_.roll(2) != 0) circle({0, 0}, radius / 2, true, false);
    }
    void star()
    {
        kind = "star";
        const int n = 3 + d_.roll(60);
        const double outer = em(0.3, 0.7), inner = outer * between(0.01, 0.9);
        std::vector<point> p;
        for (int i = 0; i < 2 * n; ++i) {
            const double radius = (i % 2 != 0 ? inner : outer) * between(0.8, 1.2), angle = turn * i / (2 * n);
            p.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        polygon(p);
    }
    void koch(std::vector<point>& out, point a, point b, int depth)
    {
        if (depth == 0) return out.push_back(a);
        const point third = (1.0 / 3.0) * (b - a), p = a + third, q = p + third;
        const point tip{p.x + 0.5 * third.x + 0.8660254 * third.y, p.y + 0.5 * third.y - 0.8660254 * third.x};
        koch(out, a, p, depth - 1);
        koch(out, p, tip, depth - 1);
        koch(out, tip, q, depth - 1);
        koch(out, q, b, depth - 1);
    }
    void snowflake()
    {
        kind = "Koch curve";
        const int n = 3 + d_.roll(3), depth = 1 + d_.roll(3);
        const double radius = em(0.2, 0.6);
        const auto corner = [&](int i) {
            return point{radius * std::cos(turn * i / n), radius * std::sin(turn * i / n)};
        };
        std::vector<point> p;
        for (int i = 0; i < n; ++i) koch(p, corner(i), corner(i + 1), depth);
        polygon(p);
    }
    void letter_with_crescent()
    {
        kind = "letter with crescent";
        letter();
        const point m = anywhere();
        const double radius = em(0.02, 0.3);
        circle(m, radius, true, true);
        circle({m.x + bit(), m.y + bit()}, radius + bit(), true, false);
    }
    void letter_with_specks()
    {
        kind = "letter with specks";
        letter();
        for (int n = 1 + d_.roll(5); n > 0; --n) {
            const point m = anywhere();
            const double size = cell * (1 + d_.roll(300));
            polygon({m, {m.x + size, m.y + bit()}, {m.x + size * d_.fraction(), m.y + size}});
        }
    }
    void polygon_across()
    {
        kind = "polygon across itself";
        std::vector<point> p;
        for (int n = 3 + d_.roll(30); n > 0; --n) p.push_back({em(-0.5, 0.5), em(-0.5, 0.5)});
        polygon(p);
    }
    void moons()
    {
        kind = "moons";
        for (int n = 2 + d_.roll(4); n > 0; --n) {
            const point m{em(-0.3, 0.3), em(-0.3, 0.3)};
            circle(m, em(0.05, 0.4), d_.roll(2) != 0, d_.roll(2) != 0, between(0.3, 1.0));
        }
    }
    void letter_with_needles()
    {
        kind = "letter with needles";
        letter();
        for (int n = 1 + d_.roll(6); n > 0; --n) {
            const point tip = anywhere();
            polygon({anywhere(), tip, {tip.x + bit(), tip.y + bit() + cell}});
        }
    }

    dice d_;
    typemesh::outline_recorder to_{curves};
    typemesh::error failed_;
};

}  // namespace test

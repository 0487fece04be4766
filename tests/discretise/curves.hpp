// SPDX-License-Identifier: MIT
#pragma once

// Curves that test discretisers: from corpus/curves.txt, random and degenerate. And their distances and counts.

#include <typemesh/core/curve.hpp>

#include "support/segments.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace typemesh {

inline std::ostream& operator<<(std::ostream& out, const curve& c)  // as in the corpus, without the em
{
    out.precision(17);
    out << c.degree;
    for (std::uint32_t i = 0; i <= c.degree; ++i) out << ' ' << c.p[i].x << ' ' << c.p[i].y;
    return out;
}

}  // namespace typemesh

namespace test {

using typemesh::curve;
using typemesh::point;

struct font_curve {
    curve c;
    double units_per_em = 0.0;
};

inline std::vector<font_curve> font_curves(std::uint32_t degree)
{
    std::ifstream in{TYPEMESH_TEST_DATA "/corpus/curves.txt"};
    if (!in) throw std::runtime_error("tests/corpus/curves.txt cannot be read");
    std::vector<font_curve> all;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words{line};
        font_curve f;
        words >> f.c.degree >> f.units_per_em;
        for (std::uint32_t i = 0; i <= f.c.degree && i < 4; ++i) words >> f.c.p[i].x >> f.c.p[i].y;
        if (!words) throw std::runtime_error("tests/corpus/curves.txt contains the broken line " + line);
        if (f.c.degree == degree) all.push_back(f);
    }
    return all;
}

/// Random, nearly closed, on a small lattice (where control points fall in line or together), or all on one line.
inline curve random_curve(std::mt19937& dice, std::uint32_t degree)
{
    std::uniform_real_distribution<double> wide{-1000.0, 1000.0};
    std::uniform_int_distribution<int> lattice{-2, 2}, kind{0, 4};
    const int k = kind(dice);
    const point base{wide(dice), wide(dice)}, along{wide(dice), wide(dice)};
    curve c;
    c.degree = degree;
    for (std::uint32_t i = 0; i <= degree; ++i) {
        if (k == 0 || k == 1)
            c.p[i] = {wide(dice), wide(dice)};
        else if (k == 2)
            c.p[i] = {100.0 * lattice(dice), 100.0 * lattice(dice)};
        else if (k == 3)
            c.p[i] = base + (0.25 * lattice(dice)) * along;
        else
            c.p[i] = base + (0.001 * wide(dice)) * along;
    }
    if (k == 1) c.p[degree] = c.p[0] + point{0.001 * wide(dice), 0.001 * wide(dice)};
    return c;
}

/// How far the piece [u, v] strays from its chord, by dense sampling.
inline double chord_error(const curve& c, double u, double v, int samples = 64)
{
    const point a = c.at(u), b = c.at(v);
    double worst = 0.0;
    for (int i = 1; i < samples; ++i)
        worst = (std::max)(worst, distance_to_segment(c.at(u + (v - u) * i / samples), a, b));
    return worst;
}

template <class D>
std::vector<double> ts_of(const D& how, const curve& c, double tolerance = 1.0)
{
    std::vector<double> ts;
    for (const emitted& e : points_of(how, c, tolerance)) ts.push_back(e.t);
    return ts;
}

/// A greedy count of chords, each as long as the tolerance allows: the least possible for a quadratic.
inline int greedy_count(const curve& c, double tolerance)
{
    double u = 0.0, step = 0.25;
    int count = 0;
    while (u < 1.0) {
        ++count;
        if (chord_error(c, u, 1.0, 48) <= tolerance) break;
        double good = u, bad = 1.0;
        for (double v = (std::min)(1.0, u + step); v < 1.0 && bad == 1.0; v = (std::min)(1.0, v + 0.1 * step))
            (chord_error(c, u, v, 48) > tolerance ? bad : good) = v;
        for (int i = 0; i < 40 && (good == u || bad - good > 1e-6); ++i) {
            const double mid = 0.5 * (good + bad);
            (chord_error(c, u, mid, 48) <= tolerance ? good : bad) = mid;
        }
        step = good - u;
        u = good;
    }
    return count;
}

/// The least number of chords between points at multiples of t = 1/96, at most `limit`.
inline int lattice_count(const curve& c, double tolerance, int limit)
{
    constexpr int nodes = 96, fine = 2;
    const auto at = [&](int i) { return c.at(i / double(nodes * fine)); };
    const auto good = [&](int i, int j) {
        const int step = (std::max)(1, (j - i) * fine / 48);
        for (int k = i * fine + step; k < j * fine; k += step)
            if (distance_to_segment(at(k), at(i * fine), at(j * fine)) > tolerance) return false;
        return true;
    };
    std::vector<bool> reached(nodes + 1, false);
    std::vector<int> front{0};
    for (int count = 1; count < limit; ++count) {
        std::vector<int> next;
        for (const int i : front)
            for (int j = nodes; j > i; --j)
                if (!reached[static_cast<std::size_t>(j)] && good(i, j)) {
                    if (j == nodes) return count;
                    reached[static_cast<std::size_t>(j)] = true;
                    next.push_back(j);
                }
        front = next;
    }
    return limit;
}

inline int least_count(const curve& c, double tolerance)
{
    const int greedy = greedy_count(c, tolerance);
    return c.degree == 2 || greedy <= 2 ? greedy : lattice_count(c, tolerance, greedy);
}

}  // namespace test

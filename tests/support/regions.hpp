// SPDX-License-Identifier: MIT
#pragma once

// Shapes for tests: generators of all sizes, a reader of corpus/regions.txt, and rotations.

#include <typemesh/core/contours.hpp>

#include "support/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

using typemesh::grid_point;
using polyline = std::vector<grid_point>;

struct shape {
    std::string name;
    std::vector<polyline> loops;

    friend std::ostream& operator<<(std::ostream& out, const shape& s)  // as in the corpus
    {
        out << s.name << '\n';
        for (const polyline& l : s.loops) {
            out << "loop";
            if (l.size() > 400)
                out << " (" << l.size() << " points)";
            else
                for (const grid_point p : l) out << "  " << p.x << ' ' << p.y;
            out << '\n';
        }
        return out;
    }
};

/// Edge i gets curve i, so that a test can follow it.
inline typemesh::contours contours_of(const std::vector<polyline>& loops, typemesh::memory source = typemesh::heap())
{
    typemesh::contours c{source};
    std::uint32_t size = 0;
    bool fits = c.starts.push_back(0);
    for (const polyline& l : loops) {
        for (const grid_point p : l) {
            fits = fits && c.points.push_back(p) && c.edges.push_back({size, 0.25f, 0.75f});
            ++size;
        }
        fits = fits && c.starts.push_back(size);
    }
    if (!fits) throw std::runtime_error("no memory for the test's own contours");
    return c;
}
inline typemesh::contours contours_of(const shape& s) { return contours_of(s.loops); }

inline std::vector<oracle::loop> loops_of(const shape& s) { return {s.loops.begin(), s.loops.end()}; }

/// Random numbers that are the same everywhere (the standard's distributions are not). From  S. Vigna, splitmix64
class dice {
public:
    explicit dice(std::uint64_t seed) : state_{seed} {}
    std::uint64_t bits()
    {
        std::uint64_t z = state_ += 0x9E37'79B9'7F4A'7C15u;
        z = (z ^ z >> 30) * 0xBF58'476D'1CE4'E5B9u;
        z = (z ^ z >> 27) * 0x94D0'49BB'1331'11EBu;
        return z ^ z >> 31;
    }
    /// 0 to sides - 1.
    std::int32_t roll(std::int32_t sides)
    {
        return static_cast<std::int32_t>((bits() >> 33) % static_cast<std::uint64_t>(sides));
    }
    double fraction() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

private:
    std::uint64_t state_;
};

// --- one contour -------------------------------------------------------------------------------------------------

inline constexpr double turn_once = 6.283185307179586;

inline grid_point on_circle(double cx, double cy, double radius, double angle)
{
    return {static_cast<std::int32_t>(std::lround(cx + radius * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(cy + radius * std::sin(angle)))};
}

inline polyline circle(int n, double radius, double cx = 0.0, double cy = 0.0)
{
    polyline l;
    for (int i = 0; i < n; ++i) {
        const grid_point p = on_circle(cx, cy, radius, turn_once * i / n);
        if (l.empty() || (!(p == l.back()) && !(p == l.front()))) l.push_back(p);
    }
    return l;
}

inline polyline square(std::int32_t x, std::int32_t y, std::int32_t size)
{
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

inline polyline reversed(polyline l)
{
    std::reverse(l.begin(), l.end());
    return l;
}

/// Teeth that point to the right; rotated by 180 degrees they all start where the sweep begins.
inline polyline comb(int teeth, std::int32_t length = 100'000)
{
    polyline l{{0, 0}};
    for (int i = 0; i < teeth; ++i) {
        l.push_back({length, 8 * i});
        l.push_back({length, 8 * i + 4});
        l.push_back({10 + i % 3, 8 * i + 5});
    }
    l.push_back({0, 8 * teeth});
    return l;
}

inline polyline spiral(int n, double turns, double step)
{
    polyline out, back;
    for (int i = 0; i <= n / 2; ++i) {
        const double angle = turn_once * turns * i / (n / 2), radius = step * (1.0 + angle / turn_once);
        out.push_back(on_circle(0, 0, radius, angle));
        back.push_back(on_circle(0, 0, radius + 0.4 * step, angle));
    }
    out.insert(out.end(), back.rbegin(), back.rend());
    return reversed(out);
}

/// Points at equal angles, distances at random: thousands of starts, ends, splits and merges.
inline polyline star(int n, double radius, std::uint64_t seed)
{
    dice d{seed};
    polyline l;
    for (int i = 0; i < n; ++i) l.push_back(on_circle(0, 0, radius * (0.2 + 0.8 * d.fraction()), turn_once * i / n));
    return l;
}

/// Steps with points in the middle of every edge.
inline polyline staircase(int steps)
{
    polyline l{{0, 0}};
    for (int i = 0; i < steps; ++i) {
        l.push_back({4 * i + 2, 4 * i});
        l.push_back({4 * i + 4, 4 * i});
        l.push_back({4 * i + 4, 4 * i + 2});
        l.push_back({4 * i + 4, 4 * i + 4});
    }
    for (int i = steps - 1; i > 0; --i) l.push_back({4 * i, 4 * steps});
    for (int i = steps; i > 0; --i) l.push_back({0, 4 * i});
    return l;
}

/// A polygon through random points of a grid, uncrossed by reversals between two crossing edges. Mostly simple.
inline polyline random_polygon(int n, std::int32_t width, dice& d)
{
    polyline l;
    n = (std::min)(n, width * width);
    while (static_cast<int>(l.size()) < n) {
        const grid_point p{d.roll(width), d.roll(width)};
        if (std::find(l.begin(), l.end(), p) == l.end()) l.push_back(p);
    }
    for (int round = 0; round < 60; ++round) {
        bool changed = false;
        for (std::size_t i = 0; i + 2 < l.size(); ++i) {
            for (std::size_t j = i + 2; j < l.size(); ++j) {
                if (i == 0 && j + 1 == l.size()) continue;
                if (!oracle::meet(l[i], l[i + 1], l[j], l[(j + 1) % l.size()])) continue;
                std::reverse(l.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             l.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                changed = true;
            }
        }
        if (!changed) break;
    }
    return l;
}

/// So many loops of `fewest` points and up to `more` - 1 besides; `place` makes a point of the loop so far and the
/// number of points that are left.
template <class Place>
shape random_polylines(dice& d, int count, int fewest, int more, const Place& place)
{
    shape s{"polylines", {}};
    for (; count > 0; --count) {
        polyline l;
        for (int n = fewest + d.roll(more); n > 0; --n) l.push_back(place(l, n));
        s.loops.push_back(l);
    }
    return s;
}
inline shape random_polylines(dice& d, int count, int fewest, int more, int width, int scale = 1)
{
    return random_polylines(d, count, fewest, more, [&](const polyline&, int) {
        const std::int32_t x = d.roll(width), y = d.roll(width);
        return grid_point{x * scale, y * scale};
    });
}

// --- whole shapes ------------------------------------------------------------------------------------------------

inline shape square_with_holes(int rows, int corners, std::int32_t pitch = 1000)
{
    shape s{"square with " + std::to_string(rows * rows) + " holes", {square(0, 0, rows * pitch)}};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < rows; ++x)
            s.loops.push_back(reversed(circle(corners, 0.4 * pitch, (x + 0.5) * pitch, (y + 0.5) * pitch)));
    return s;
}

inline shape circle_with_holes(int n, int holes)
{
    shape s{"circle with " + std::to_string(holes) + " holes", {circle(n, 1'000'000)}};
    for (int i = 0; i < holes; ++i) {
        const grid_point c = on_circle(0, 0, 800'000, turn_once * i / holes);
        s.loops.push_back(reversed(circle(5 + i % 7, 1'500'000.0 / holes, c.x, c.y)));
    }
    return s;
}

/// `depth` squares inside each other, alternating in direction or all counter-clockwise.
inline shape nested_squares(int depth, bool alternating)
{
    shape s{alternating ? "nested squares, alternating" : "nested squares, all one way", {}};
    for (int i = 0; i < depth; ++i) {
        const polyline l = square(10 * i, 10 * i, 20 * (depth - i));
        s.loops.push_back(alternating && i % 2 == 1 ? reversed(l) : l);
    }
    return s;
}

/// Shapes whose loops bound a region as they are.
inline std::vector<shape> generated_regions()
{
    std::vector<shape> all;
    all.push_back({"triangle", {{{0, 0}, {5, 1}, {2, 7}}}});
    all.push_back({"largest square", {square(-(1 << 28), -(1 << 28), 1 << 29)}});
    all.push_back(
        {"largest square with a hole up to its edges",
         {square(-(1 << 28), -(1 << 28), 1 << 29), reversed(square(1 - (1 << 28), 1 - (1 << 28), (1 << 29) - 2))}});
    all.push_back({"largest star", {star(2000, 0x1p28 - 1, 7)}});
    all.push_back(square_with_holes(1, 4));
    all.push_back(square_with_holes(5, 16));
    all.push_back(square_with_holes(20, 6));
    all.push_back(circle_with_holes(60, 3));
    all.push_back(circle_with_holes(500, 100));
    all.push_back({"comb", {comb(7)}});
    all.push_back({"comb of 700 teeth", {comb(700)}});
    all.push_back({"staircase", {staircase(1)}});
    all.push_back({"long staircase", {staircase(40)}});
    all.push_back({"spiral", {spiral(100, 4.3, 1000)}});
    all.push_back({"long spiral", {spiral(3000, 40, 10'000)}});
    all.push_back({"circle", {circle(100, 1'000'000)}});
    all.push_back({"star", {star(60, 1'000'000, 1)}});
    all.push_back({"large star", {star(5000, 100'000'000, 2)}});
    all.push_back(nested_squares(12, true));
    all.push_back({"two apart", {square(0, 0, 5), square(7, 1, 5)}});
    return all;
}

// --- turning -----------------------------------------------------------------------------------------------------

/// Rotated about the origin and snapped; quarter turns are exact. Equal neighbours after snapping are dropped.
inline shape turned(const shape& s, double degrees)
{
    const bool quarters = std::fmod(degrees, 90.0) == 0.0;
    const int quarter = static_cast<int>(degrees / 90.0) & 3;
    const double c = std::cos(degrees * turn_once / 360), sn = std::sin(degrees * turn_once / 360);
    shape t{s.name + ", turned by " + std::to_string(degrees) + " degrees", {}};
    const auto snapped = [](double v) {
        return static_cast<std::int32_t>(std::lround((std::max)(-0x1p28, (std::min)(0x1p28, v))));
    };
    for (const polyline& l : s.loops) {
        polyline m;
        for (const grid_point p : l) {
            grid_point q = p;
            if (quarters)
                for (int i = 0; i < quarter; ++i) q = {-q.y, q.x};
            else
                q = {snapped(c * p.x - sn * p.y), snapped(sn * p.x + c * p.y)};
            if (m.empty() || !(q == m.back())) m.push_back(q);
        }
        while (m.size() > 1 && m.back() == m.front()) m.pop_back();
        t.loops.push_back(std::move(m));
    }
    return t;
}

/// Every contour reversed.
inline shape reversed(shape s)
{
    s.name += ", reversed";
    for (polyline& l : s.loops) std::reverse(l.begin(), l.end());
    return s;
}

/// x and y swapped, and every contour reversed, so that the left side stays the left side.
inline shape mirrored(shape s)
{
    s.name += ", mirrored";
    for (polyline& l : s.loops) {
        for (grid_point& p : l) p = {p.y, p.x};
        std::reverse(l.begin(), l.end());
    }
    return s;
}

/// The shape turned by each angle, each time as it is, mirrored and reversed.
inline std::vector<shape> in_positions(const shape& s, const std::vector<double>& degrees = {0.0, 90.0, 180.0, 270.0})
{
    std::vector<shape> all;
    for (const double angle : degrees) {
        const shape t = turned(s, angle);
        for (const shape& position : {t, mirrored(t), reversed(t)}) all.push_back(position);
    }
    return all;
}

/// Contours in another order, each with another first point.
inline shape shuffled(shape s, std::uint64_t seed)
{
    dice d{seed};
    s.name += ", shuffled";
    for (std::size_t i = s.loops.size(); i > 1; --i)
        std::swap(s.loops[i - 1], s.loops[static_cast<std::size_t>(d.roll(static_cast<std::int32_t>(i)))]);
    for (polyline& l : s.loops)
        std::rotate(l.begin(), l.begin() + d.roll(static_cast<std::int32_t>(l.size())), l.end());
    return s;
}

// --- corpus ------------------------------------------------------------------------------------------------------

/// A shape of corpus/regions.txt and its properties.
struct corpus_shape {
    test::shape shape;
    bool is_region = false;  ///< as it is; else the loops meet, or do not have the interior on their left
    bool is_crossing = false;
    std::uint32_t holes = 0, outers = 0;  ///< of the region filled by non-zero winding, if the loops do not meet
    std::size_t triangles = 0;

    friend std::ostream& operator<<(std::ostream& out, const corpus_shape& c) { return out << c.shape; }
};

inline std::vector<corpus_shape> corpus(const std::string& file)
{
#ifdef TYPEMESH_TEST_DATA
    const std::string path = std::string{TYPEMESH_TEST_DATA} + "/corpus/" + file;
#else
    const std::string path = "tests/corpus/" + file;
#endif
    std::ifstream in{path};
    if (!in) throw std::runtime_error("cannot open " + path);
    std::vector<corpus_shape> all;
    std::string line, word;
    while (std::getline(in, line)) {
        std::istringstream words{line};
        if (!(words >> word) || word[0] == '#') continue;
        if (word == "loop") {
            polyline l;
            for (grid_point p; words >> p.x >> p.y;) l.push_back(p);
            all.at(all.size() - 1).shape.loops.push_back(l);
            continue;
        }
        corpus_shape c;
        c.is_region = word == "region";
        c.is_crossing = word == "crossing";
        if (!c.is_region && !c.is_crossing && word != "disjoint") throw std::runtime_error("cannot read: " + line);
        words >> c.shape.name;
        if (!c.is_crossing && !(words >> c.outers >> c.holes >> c.triangles))
            throw std::runtime_error("cannot read: " + line);
        all.push_back(std::move(c));
    }
    return all;
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

#include "contour_laws.hpp"

#include "support/oracle.hpp"

#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/thesis_quality.hpp>
#include <typemesh/discretise/two_lines.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/inspect/curve_distance.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Contours of curves that nearly touch, drawn like a font's -> each discretiser -> the guard against chords that cross
/// although their curves do not.
namespace fuzz {

namespace crossing_laws {

using namespace typemesh;
using path = std::vector<curve>;

/// A closed path of up to 6 curves, between points with 8 bits a coordinate.
inline path read_path(values& in)
{
    const auto read_point = [&] {
        const double x = 4.0 * in.byte();
        return point{x, 4.0 * in.byte()};
    };
    path all;
    const point first = read_point();
    point at = first;
    const std::uint32_t count = 1 + in.below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t degree = 1 + in.below(3);
        const point a = degree > 1 ? read_point() : at, b = degree > 2 ? read_point() : a;
        const point end = i + 1 == count ? first : read_point();
        if (degree == 1) all.push_back(curve::from(at, end));
        if (degree == 2) all.push_back(curve::from(quadratic{at, a, end}));
        if (degree == 3) all.push_back(curve::from(cubic{at, a, b, end}));
        at = end;
    }
    return all;
}

/// The same path slightly moved, slightly smaller, or with one point elsewhere: curves that nearly touch.
inline path read_shadow(values& in, path all)
{
    const std::uint32_t how = in.byte();
    const double near = (how & 1) != 0 ? 1.0 / 64 : (how & 2) != 0 ? 1.0 / 8 : 1.0;  // font units
    const auto step = [&] { return near * (double(in.byte()) - 128.0) / 8.0; };
    const double dx = step(), dy = step(), scale = (how & 4) != 0 ? 1.0 + step() / 512.0 : 1.0;
    for (curve& c : all)
        for (point& p : c.p) p = scale * p + point{dx, dy};
    if ((how & 8) != 0) {
        curve& c = all[in.below(static_cast<std::uint32_t>(all.size()))];
        if (c.degree > 1) c.p[1] = c.p[1] + point{step(), step()};
    }
    if ((how & 16) != 0) {
        std::reverse(all.begin(), all.end());
        for (curve& c : all) std::reverse(c.p, c.p + c.degree + 1);
    }
    return all;
}

/// Paths as read, and as the recorder keeps a font's calls for them: without the last line.
struct drawn_outline {
    outline given, recorded;
    error failure;

    explicit drawn_outline(values& in)
    {
        bool fits = given.starts.push_back(0);
        path all;
        outline_recorder recorder{recorded};
        for (std::uint32_t left = 1 + in.below(3); left > 0; --left) {
            all = !all.empty() && in.flag() ? read_shadow(in, all) : read_path(in);
            recorder.move(all.front().start());
            for (std::size_t i = 0; i < all.size(); ++i) {
                const curve& c = all[i];
                fits = fits && given.curves.push_back(c);
                for (std::uint32_t k = 0; k <= c.degree; ++k) given.bounds.add(c.p[k]);
                if (c.degree == 1 && i + 1 < all.size()) recorder.line(c.end());
                if (c.degree == 2) recorder.quadratic(c.p[1], c.end());
                if (c.degree == 3) recorder.cubic(c.p[1], c.p[2], c.end());
            }
            fits = fits && given.starts.push_back(static_cast<std::uint32_t>(given.curves.size()));
        }
        failure = recorder.finish();
        if (!fits && !failure) failure = error::out_of_memory;
    }
};

/// The result is a region with exact triangles and, if the discretiser keeps a tolerance, near the curves.
template <discretiser Discretiser, triangulator Triangulator>
broken_law of_caps(const drawn_outline& o, double tolerance, fill_rule rule, const Discretiser& flatten,
                   const Triangulator& cut)
{
    const auto cells = grid::fitting(1000.0, o.given.bounds);
    if (!cells) return cells.error().message();
    const flat raise;
    no_observer nobody;
    cap_builder caps;
    const auto made = caps.build(o.recorded, tolerance, *cells, {rule}, policies{flatten, cut, raise, nobody});
    if (!made) return made.error().message();
    const auto kept = inspect::loops_of(*made);
    if (broken_law broken = test::oracle::broken_cycle(kept); !broken.empty()) return broken;
    if (broken_law broken = test::oracle::broken_law(*made, caps.triangles().view()); !broken.empty()) return broken;
    if constexpr (!std::same_as<Discretiser, certified>) return {};

    const double wanted = (std::max)(tolerance * cells->cells, 2.0 * cells->cells * cells->snap_error());
    const double allowed = 1.01 * wanted + 1.5;
    const inspect::curve_chords curves{o.given, cells->cells, 0.01 * wanted};
    if (curves.all().size() > 20'000) return {};  // too slow to compare
    if (inspect::check_distance(*made, curves, allowed).strays != 0) return "a point is far from all curves";
    if (inspect::check_fill(curves, rule, kept, allowed, 60).wrong != 0) return "a place is filled wrongly";
    return {};
}

}  // namespace crossing_laws

inline broken_law crossings(values in)
{
    using namespace typemesh;
    using namespace crossing_laws;
    const fill_rule rule = in.flag() ? fill_rule::even_odd : fill_rule::non_zero;
    const double tolerance = in.one_of({10.0, 6.25, 1.25, 0.5});
    const std::uint32_t bits = in.byte();
    const drawn_outline o{in};
    if (o.failure) return o.failure.message();
    if (broken_law broken = of_contours(o.recorded); !broken.empty()) return broken;
    const auto of = [&](const auto& flatten) {
        return (bits & 1) != 0 ? of_caps(o, tolerance, rule, flatten, constrained_delaunay{})
                               : of_caps(o, tolerance, rule, flatten, monotone{});
    };
    switch (bits >> 4) {
    case 15: return of(two_lines{});
    case 14: return of(adaptive_subdivision{1 + (bits >> 1 & 7), 4.0 * tolerance, 0.02});
    case 13: return of(thesis_quality{static_cast<thesis_quality::preset>(bits >> 1 & 3), 1000.0});
    default: return of(certified{});
    }
}

}  // namespace fuzz

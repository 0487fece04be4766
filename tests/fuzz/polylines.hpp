// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_loops.hpp"

#include "support/delaunay.hpp"

#include <typemesh/fill/resolve.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

/// Closed polylines -> fill -> both triangulators.
namespace fuzz {

namespace polylines_laws {

using namespace typemesh;
using placed_cycles = std::vector<std::vector<std::array<std::int32_t, 2>>>;

/// Each cycle in its smallest rotation, sorted: equal if the regions are equal.
inline placed_cycles cycles_of(const region& r)
{
    placed_cycles all;
    for (const auto l : inspect::loops_of(r)) {
        std::vector<std::array<std::int32_t, 2>> c, best;
        for (const grid_point p : l) c.push_back({p.x, p.y});
        for (std::size_t i = 0; i < c.size(); ++i, std::rotate(c.begin(), c.begin() + 1, c.end()))
            if (best.empty() || c < best) best = c;
        all.push_back(best);
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// The loops that the region is compared with, examined without it.
struct given_loops {
    const std::vector<polyline>& drawn;
    std::vector<inspect::loop> loops{drawn.begin(), drawn.end()};
    bool is_exact = true;  ///< they cross in grid points only

    explicit given_loops(const std::vector<polyline>& all) : drawn{all}
    {
        for (const polyline& l : all)
            for (const grid_point p : l) is_exact = is_exact && std::abs(p.x) < 5000 && std::abs(p.y) < 5000;
        is_exact = is_exact && !(inspect::reroute_through_crossings(loops).bent_length > 0.0);
    }
};

inline broken_law of_region(const region& r, const given_loops& given, fill_rule rule)
{
    const auto kept = inspect::loops_of(r);
    if (broken_law broken = test::oracle::broken_cycle(kept); !broken.empty()) return broken;
    const double wanted = inspect::doubled_filled_area(given.loops, rule),
                 area = static_cast<double>(inspect::doubled_area(kept)), length = inspect::length(given.loops);
    if (std::fabs(area - wanted) > (given.is_exact ? 1e-9 * (wanted + 1.0) : 2.0 * length + 4.0))
        return "the area is " + std::to_string(area / 2) + ", not " + std::to_string(wanted / 2);
    if (inspect::check_fill(given.loops, rule, kept, 12, given.is_exact ? 0.0 : 1.5).wrong != 0)
        return "a place is filled wrongly";
    return {};
}

template <triangulator Triangulator>
broken_law of_caps(const std::vector<polyline>& drawn, const given_loops& given, fill_rule rule,
                   const Triangulator& cut, placed_cycles& cycles)
{
    cap_builder caps;
    caps.loops() = test::contours_of(drawn);
    caps.loops().grid.units_per_em = 2048.0;
    const auto made = caps.fill({rule}, cut);
    if (!made) return made.error().message();
    if (broken_law broken = of_region(*made, given, rule); !broken.empty()) return broken;
    if (broken_law broken = test::oracle::broken_law(*made, caps.triangles().view()); !broken.empty()) return broken;
    if constexpr (std::same_as<Triangulator, constrained_delaunay>)
        if (broken_law broken = test::oracle::broken_delaunay(*made, caps.triangles().view()); !broken.empty())
            return broken;
    cycles = cycles_of(*made);
    return {};
}

/// The region does not depend on the start or order of contours, nor on their direction if all are reversed.
inline broken_law of_resolve(std::vector<polyline> drawn, fill_rule rule, const placed_cycles& wanted)
{
    for (int way = 0; way < 2; ++way) {
        contours loops = test::contours_of(drawn);
        workspace space;
        const auto made = resolve(loops, rule, space);
        if (!made) return made.error().message();
        if (cycles_of(*made) != wanted) return "the region depends on the way or on the order";
        std::reverse(drawn.begin(), drawn.end());
        for (polyline& l : drawn) {
            std::reverse(l.begin(), l.end());
            std::rotate(l.begin(), l.begin() + static_cast<std::ptrdiff_t>(l.size() / 3), l.end());
        }
    }
    return {};
}

}  // namespace polylines_laws

inline broken_law polylines(values in)
{
    using namespace polylines_laws;
    const fill_rule rule = in.flag() ? fill_rule::even_odd : fill_rule::non_zero;
    const std::vector<polyline> drawn = loop_reader{in}.read(64);
    if (drawn.empty()) return {};
    const given_loops given{drawn};
    placed_cycles cycles, of_delaunay;
    if (broken_law broken = of_caps(drawn, given, rule, monotone{}, cycles); !broken.empty())
        return "monotone: " + broken;
    if (broken_law broken = of_caps(drawn, given, rule, constrained_delaunay{}, of_delaunay); !broken.empty())
        return "constrained_delaunay: " + broken;
    if (cycles != of_delaunay) return "two triangulators, two regions";
    return of_resolve(drawn, rule, cycles);
}

}  // namespace fuzz

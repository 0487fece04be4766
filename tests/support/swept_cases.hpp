// SPDX-License-Identifier: MIT
#pragma once

// Regions swept inwards and judged: by their laws, and by the slow wavefront.

#include "support/regions.hpp"
#include "support/slow_wavefront.hpp"
#include "support/swept_laws.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/offset/sweep_inwards.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// How far to sweep a region, and what was found out about it.
struct sweep_case {
    std::vector<double> levels;  ///< cells
    double mitre_limit = 2.0;
    double tolerance = 0.0;    ///< of round joins, in cells
    bool compare_area = true;  ///< with the slow wavefront

    std::string broken;               ///< the first law that is broken; empty: none
    bool refused = false;             ///< as crossing on the grid: neither broken nor judged
    double farthest_off_plane = 0.0;  ///< cells
    double largest_difference = 0.0;  ///< square cells, between a level and the slow wavefront's, beyond rounding: 0
    std::vector<std::int64_t> doubled_areas;
    std::uint32_t cap_outers = 0, cap_holes = 0;

    template <class Triangulator>
    void examine(const typemesh::region& r, const Triangulator& cut)
    {
        using namespace typemesh;
        workspace space;
        triangle_list triangles;
        swept_region swept;
        if (const error e = cut(r, space, triangles)) return void(broken = e.message());
        const sweep_options how = options();
        {
            workspace::scope scratch{space};
            const error e = sweep_inwards(r, triangles.view(), how, scratch, swept);
            refused = e.code == error::crossing_contours;
            if (e && !refused) broken = e.message();
            if (e) return;
        }
        const swept_laws laws{r, swept};
        broken = laws.broken();
        farthest_off_plane = laws.farthest_off_plane();
        doubled_areas = laws.doubled_areas();
        for (const oracle::loop l : oracle::loops_of(swept.cap))
            ++(oracle::doubled_area(l) > 0 ? cap_outers : cap_holes);
        if (broken.empty() && compare_area) compare(r, laws);
    }

    [[nodiscard]] typemesh::sweep_options options() const
    {
        typemesh::sweep_options how;
        how.levels = levels;
        how.mitre_limit = mitre_limit;
        how.tolerance = tolerance;
        return how;
    }

private:
    /// Symmetric differences at all levels. Both are rounded by half a cell.
    void compare(const typemesh::region& r, const swept_laws& laws)
    {
        std::vector<polyline> given;
        for (const oracle::loop l : oracle::loops_of(r)) given.emplace_back(l.begin(), l.end());
        slow_wavefront front{given, {mitre_limit, tolerance, levels.back()}};
        for (std::size_t k = 1; k < levels.size(); ++k) {
            front.advance(levels[k]);
            std::vector<polyline> both = laws.loops_at(k);
            for (const auto& l : front.loops()) {
                polyline& rounded = both.emplace_back();
                for (const real_point p : l)
                    rounded.push_back(
                        {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))});
            }
            const std::vector<oracle::loop> loops{both.begin(), both.end()};
            const double difference = oracle::doubled_filled_area(loops, typemesh::fill_rule::even_odd) / 2;
            if (difference <= oracle::length(loops) + 16.0) continue;
            largest_difference = (std::max)(largest_difference, difference);
            if (broken.empty() && !front.is_doubtful()) broken = "a level is not where the slow wavefront is";
        }
    }
};

/// Levels from 0 to a width, `count` bands of equal height; fewer where they would be finer than four cells.
inline std::vector<double> levels_to(double width, int count)
{
    std::vector<double> levels{0.0};
    for (int k = 1; k <= count; ++k) {
        const double level = k == count ? width : std::floor(width * k / count);
        if (level >= levels.back() + 4.0) levels.push_back(level);
    }
    return levels;
}

}  // namespace test

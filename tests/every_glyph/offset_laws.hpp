// SPDX-License-Identifier: MIT
#pragma once

// Laws of one glyph swept inwards, at all widths.

#include "support/solid_in_cells.hpp"
#include "support/swept_cases.hpp"

#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace test {

/// The findings about one glyph.
struct offset_findings {
    bool blank = false;
    std::size_t points = 0;
    std::size_t sweeps = 0, refused = 0;
    double farthest_off_plane = 0.0;  ///< cells
    std::string wrong;                ///< the first law that is broken, and where, or nothing
};

/// Reuses its memory for one glyph after another. Use each on one thread.
class offset_laws {
public:
    static constexpr double widths[] = {0.005, 0.01, 0.02, 0.03, 0.05, 0.1, 0.3};  // em

    /// The glyph's region, until the next call; without points if there is none.
    template <class Font>
    typemesh::region region_of(Font& font, typemesh::glyph_id id, double tolerance_em)
    {
        if (!record(font, id, outline_) || outline_.curves.empty()) return {};
        return test::region_of(caps_, outline_, font.units_per_em(), tolerance_em);
    }

    /// Sweeps with and without joins, in one band and in four, over both triangulations.
    template <class Font>
    offset_findings examine(Font& font, typemesh::glyph_id id, double tolerance_em, bool compare_area)
    {
        using namespace typemesh;
        offset_findings f;
        const region r = region_of(font, id, tolerance_em);
        f.points = r.points().size();
        f.blank = r.points().empty();
        if (f.blank) return f;
        const double em = em_of(r);
        for (const double width : widths) {
            for (const double limit : {0.0, 2.0}) {
                for (const int bands : {1, 4}) {
                    sweep_case one;
                    one.levels = levels_to(std::floor(width * em), bands);
                    one.mitre_limit = limit;
                    one.tolerance = tolerance_em * em;
                    one.compare_area = compare_area && bands == 4;
                    if (bands == 1)
                        one.examine(r, constrained_delaunay{});
                    else
                        one.examine(r, monotone{});
                    ++f.sweeps;
                    f.refused += one.refused;
                    f.farthest_off_plane = (std::max)(f.farthest_off_plane, one.farthest_off_plane);
                    if (!one.broken.empty() && f.wrong.empty())
                        f.wrong = one.broken + ", at " + std::to_string(width) + " em, mitre limit " +
                                  std::to_string(limit) + ", " + std::to_string(bands) + " bands";
                }
            }
        }
        return f;
    }

private:
    typemesh::outline outline_;
    typemesh::cap_builder caps_;
};

}  // namespace test

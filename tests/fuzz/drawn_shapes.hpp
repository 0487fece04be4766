// SPDX-License-Identifier: MIT
#pragma once

#include "crossings.hpp"
#include "solids.hpp"

#include <cstdlib>
#include <initializer_list>
#include <memory>

namespace fuzz {

/// The region of closed polylines as `solids` draws them, or of curves as `crossings` draws them.
struct drawn_shape : solid_laws::drawn_region {
    broken_law read(values& in)
    {
        using namespace typemesh;
        if (in.flag()) return fill(in);
        const double tolerance = in.one_of({10.0, 6.25, 1.25, 0.5});
        curves = std::make_unique<crossing_laws::drawn_outline>(in);
        if (curves->failure) return curves->failure.message();
        const auto cells = grid::fitting(1000.0, curves->given.bounds);
        if (!cells) return cells.error().message();
        const flat raise;
        no_observer nobody;
        const auto filled = caps.build(curves->recorded, tolerance, *cells, {fill_rule::non_zero},
                                       policies{certified{}, monotone{}, raise, nobody});
        if (!filled) return filled.error().message();
        made = *filled;
        em = 1000.0 * cells->cells;
        return {};
    }

    /// Whether floats can tell all its points apart.
    [[nodiscard]] bool fits_floats() const
    {
        bool all = true;
        for (const typemesh::grid_point p : made.points())
            all = all && std::abs(p.x) < 1 << 23 && std::abs(p.y) < 1 << 23;
        return all;
    }

    std::unique_ptr<crossing_laws::drawn_outline> curves;
};

/// "" if a stage may fail so, otherwise what it says.
inline broken_law unless_one_of(const typemesh::error& e, std::initializer_list<typemesh::error::kind> allowed)
{
    for (const auto kind : allowed)
        if (e == kind) return {};
    return e.message();
}

}  // namespace fuzz

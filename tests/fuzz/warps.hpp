// SPDX-License-Identifier: MIT
#pragma once

#include "crossings.hpp"

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

/// Outlines -> outlines warped in the plane, by each ready warp -> region.
namespace fuzz {

namespace warp_laws {

using namespace typemesh;

/// A closed outline of as many contours, within the tolerance of the ideal one, that the next stages accept. The
/// tolerance is in em, of 1000 font units.
template <class W>
broken_law of_warped(const W& how, const crossing_laws::drawn_outline& o, const drawn_place& at, double tolerance)
{
    constexpr std::uint32_t limit = 3000;
    outline out;
    const warped<W> step{how};
    error refused = step.refused(at.text);
    result<double> rest = refused ? result<double>{refused} : step(o.recorded, at, tolerance, limit, out);
    if (!rest) {
        for (const auto kind :
             {error::bad_option, error::goes_around, error::folds_over, error::bad_tolerance, error::too_many_points})
            if (rest.error() == kind) return {};
        return rest.error().message();
    }
    if (!(*rest > 0.0 && *rest <= tolerance)) return "the tolerance that is left";
    if (out.contour_count() != o.recorded.contour_count()) return "the number of contours";
    if (broken_law broken = of_contours(out); !broken.empty()) return broken;
    const auto cells = grid::fitting(1000.0, out.bounds);
    if (!cells) return cells.error() == error::outline_beyond_grid ? "" : cells.error().message();
    const double reach =
        std::fabs(out.bounds.low.x) + std::fabs(out.bounds.low.y) + out.bounds.width() + out.bounds.height();
    const inspect::curve_chords chords{out, 1.0, 20.0 * tolerance};
    if (chords.all().size() > 20'000) return {};  // too slow to compare
    const W own = fitted_to(how, at.text);
    for (const curve& c : o.recorded.curves)
        for (const double t : {0.0, 0.13, 0.5, 0.81}) {
            const point image = (1.0 / at.em_per_unit) * (own(at.em_per_unit * c.at(t) + at.origin).at - at.origin);
            const double away = std::sqrt(inspect::curve_chords::squared_distance(image, chords.all()));
            if (!(away <= 280.0 * tolerance + 1e-9 * reach)) return "a curve is too far from the ideal one";
        }
    const flat raise;
    no_observer nobody;
    cap_builder caps;
    const auto made = caps.build(out, 1000.0 * *rest, *cells, {fill_rule::non_zero},
                                 policies{certified{}, monotone{}, raise, nobody});
    if (!made) return made.error() == error::too_many_pieces ? "" : made.error().message();  // turns on one circle
    return test::oracle::broken_law(*made, caps.triangles().view());
}

}  // namespace warp_laws

inline broken_law warps(values in)
{
    using namespace typemesh;
    using namespace warp_laws;
    static constexpr double degrees[] = {90.0, -180.0, 360.0, 10.0, 0.0, 1e4}, sizes[] = {0.0, 1.0, 0.1, 30.0, 1e-6},
                            scales[] = {0.5, 2.0, 1.0, 0.001, 100.0},
                            tolerances[] = {1.0 / 800, 1.0 / 160, 1.0 / 16000, 1e-7, 0.01};
    const std::uint32_t kind = in.below(4);
    const double size = in.one_of(sizes), free = in.between(-1.0, 1.0), other = in.between(-1.0, 1.0),
                 tolerance = in.one_of(tolerances);
    drawn_place at;
    at.em_per_unit = 1.0 / 1000;
    at.origin = {in.between(-2.0, 2.0), 0.0};
    at.text = {{0.0, 0.0}, {in.between(0.0, 8.0), 0.0}};
    const double angle = in.one_of(degrees), scale = in.one_of(scales);
    const crossing_laws::drawn_outline o{in};
    if (o.failure) return o.failure.message();
    switch (kind) {
    case 0: return of_warped(arc{.degrees = angle, .width = size, .middle = free}, o, at, tolerance);
    case 1: return of_warped(arch{.rise = free, .baseline = other, .width = size, .middle = free}, o, at, tolerance);
    case 2: return of_warped(flag{.height = free, .length = size, .left = other, .phase = angle}, o, at, tolerance);
    default:
        return of_warped(perspective{.scale = scale, .horizon = free, .width = size, .left = other}, o, at, tolerance);
    }
}

}  // namespace fuzz

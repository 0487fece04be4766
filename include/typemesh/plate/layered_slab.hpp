// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/plate/cell_set.hpp>

#include <cmath>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// The lower side of a layered solid, and how all its rims are made.
struct layered_base {
    float height = 0.0f;       ///< of the lower side of the first slab, in output units
    float bevel = 0.0f;        ///< the width and depth of the bevel along its lower rim, in em; 0: none
    bool round = false;        ///< whether bevels are quarters of a circle; otherwise they are chamfers of 45 degrees
    double unit_per_em = 1.0;  ///< output units per em, for bevels and fillets
    double tolerance = 0.0;    ///< the deviation of round bevels, fillets and corners, in cells; 0: unknown

    /// A bevel's depth in output units.
    [[nodiscard]] float depth(float em) const noexcept { return static_cast<float>(as_double(em) * unit_per_em); }
};

/// A slab of a layered solid, up from the previous one or from the bottom.
struct layered_slab {
    cell_set filled;      ///< the cells that are filled; the set must be bounded
    float top = 0.0f;     ///< the height of its upper side, in output units
    float bevel = 0.0f;   ///< the width and depth of the bevel along its upper rim, in em; 0: none
    float fillet = 0.0f;  ///< the radius of the fillet at its foot, where it stands on the slab below, in em
    cell_set rim = {};    ///< the cells whose outline is bevelled, if it is not the one of `filled`. They contain
                          ///< `filled`; the rims of the pockets that are missing from it stay sharp: what fills the
                          ///< pockets of an inlay meets them there. For the last slab only: inside of a bevel there
                          ///< may be pockets, or the foot of the next slab, but not both

    /// The cells whose outline is bevelled.
    [[nodiscard]] constexpr cell_set outline() const noexcept { return rim.labels != 0 ? rim : filled; }
    /// The cells within this outline that the slab does not fill.
    [[nodiscard]] constexpr cell_set pockets() const noexcept { return outline() & ~filled; }
};

namespace detail {

/// The widths of the bevel of a slab's upper rim and of the fillet at its foot, in em.
struct rim_widths {
    float bevel = 0.0f, fillet = 0.0f;
};

/// The least width of a rim in em: four steps of a float at the greatest height, so that the rim's heights differ.
[[nodiscard]] inline double least_rim_width(const layered_base& base, array_view<const layered_slab> slabs) noexcept
{
    double greatest = std::fabs(as_double(base.height));
    for (const layered_slab& s : slabs)
        if (std::fabs(as_double(s.top)) > greatest) greatest = std::fabs(as_double(s.top));
    return 0x1p-21 * greatest / base.unit_per_em;
}

/// Takes the wanted widths of all rims. A sixteenth of a slab's height stays a wall: the wider one of its bevel and
/// what is at its foot becomes narrower, and both if each needs more than half of the rest. What floats cannot tell
/// from nothing is left out.
///
///     lower     becomes the width of the bevel of the lower side
///     widths    one for each slab
///
/// Fails  error::bad_option: "unit_per_em", "tolerance", "top", "rim", "bevel" as layered_solid::plan() does
[[nodiscard]] inline error settle_widths(const layered_base& base, array_view<const layered_slab> slabs, float& lower,
                                         rim_widths* widths) noexcept
{
    const auto is_width = [](float w) noexcept { return is_finite(as_double(w)) && w >= 0.0f; };
    if (!is_finite(base.unit_per_em) || !(base.unit_per_em > 0.0)) return error::bad("unit_per_em");
    if (!is_finite(base.tolerance) || !(base.tolerance >= 0.0)) return error::bad("tolerance");
    if (!is_width(base.bevel)) return error::bad("bevel");
    const double least = least_rim_width(base, slabs);
    float below = base.height;
    for (std::size_t k = 0; k < slabs.size(); below = slabs[k++].top) {
        const layered_slab& s = slabs[k];
        if (!is_finite(as_double(s.top)) || !(s.top > below)) return error::bad("top");
        if (s.rim.is_unbounded() || (s.rim.labels != 0 && k + 1 != slabs.size())) return error::bad("rim");
        if (!is_width(s.bevel) || !is_width(s.fillet)) return error::bad("bevel");
        const double room = 0.9375 * (as_double(s.top) - as_double(below)) / base.unit_per_em;
        double upper = as_double(s.bevel), foot = as_double(k == 0 ? base.bevel : s.fillet);
        if (upper + foot > room) {
            double &narrow = upper < foot ? upper : foot, &wide = upper < foot ? foot : upper;
            narrow = narrow < 0.5 * room ? narrow : 0.5 * room;
            wide = room - narrow;
        }
        const bool has_wall = room > 8.0 * least;
        if (!has_wall || upper < least) upper = 0.0;
        if (!has_wall || foot < least) foot = 0.0;
        widths[k].bevel = static_cast<float>(upper);
        (k == 0 ? lower : widths[k].fillet) = static_cast<float>(foot);
    }
    return {};
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI

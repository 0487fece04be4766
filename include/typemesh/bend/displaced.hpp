// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/error.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// The height of a surface at a place, and its derivatives there.
struct surface_height {
    double z = 0.0;
    double by_x = 0.0;  ///< its derivative by x
    double by_y = 0.0;  ///< and by y
};

/// A surface z = h(x, y) over the text's plane, in em.
///
///     h(x, y)              the height and its derivatives: surface_height
///     h.bend(box)          bounds of the second derivatives over a box: only xx, yy and xy matter
///     h.refused_options()  the error with which it refuses its options, or none
template <class H>
concept height_surface = std::copyable<H> && requires(const H& h, double x, const box3& b) {
    { h(x, x) } noexcept -> std::same_as<surface_height>;
    { h.bend(b) } noexcept -> std::same_as<bend_bounds>;
    { h.refused_options() } noexcept -> std::same_as<error>;
};

/// The deformation that moves each point of the text towards the reader by the height of a surface, such as a wave:
///
///     displaced<wave>{{.height = 0.1, .length = 2.0}}
///
/// It keeps all volumes, so it folds nothing.
template <height_surface Surface>
struct displaced {
    Surface surface = {};

    static constexpr bool keeps_volume = true;  ///< see deformation.hpp

    [[nodiscard]] error refused_options() const noexcept { return surface.refused_options(); }

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const surface_height h = surface(p.x, p.y);
        return {{p.x, p.y, p.z + h.z}, {1.0, 0.0, h.by_x}, {0.0, 1.0, h.by_y}, {0.0, 0.0, 1.0}};
    }

    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const bend_bounds own = surface.bend(b);
        return {.xx = own.xx, .yy = own.yy, .xy = own.xy};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

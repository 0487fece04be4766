// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The deformation that scales text more and more along an axis, in the two directions across it.
///
///     ---___             axis along    height and depth change along the text; the baseline stays straight
///     text  ---___       axis up       width and depth change upwards; the line x = 0 stays straight
///     _____---         The factor is 1 at the text's origin, and changes by `growth` per em.
///
/// Fails  error::bad_option: the growth is not finite ("growth"); error::folds_over: the factor is not positive
///        everywhere in the text
struct taper {
    double growth = -0.1;               ///< per em
    text_axis axis = text_axis::along;  ///< the direction along which the factor changes

    /// See deformation.
    [[nodiscard]] error refused_options() const noexcept { return is_finite(growth) ? error{} : error::bad("growth"); }

    /// See deformation.
    [[nodiscard]] error refused_text(const box3& text) const noexcept
    {
        const bool along = axis == text_axis::along;
        const double first = factor(along ? text.low.x : text.low.y), last = factor(along ? text.high.x : text.high.y);
        return first > 0.0 && last > 0.0 ? error{} : error{error::folds_over};
    }

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        if (axis == text_axis::along) {
            const double f = factor(p.x);
            return {{p.x, p.y * f, p.z * f}, {1.0, growth * p.y, growth * p.z}, {0.0, f, 0.0}, {0.0, 0.0, f}};
        }
        const double f = factor(p.y);
        return {{p.x * f, p.y, p.z * f}, {f, 0.0, 0.0}, {growth * p.x, 1.0, growth * p.z}, {0.0, 0.0, f}};
    }

    /// See deformation.
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept
    {
        const double change = growth < 0.0 ? -growth : growth;
        if (axis == text_axis::along) return {.xy = change, .xz = change};
        return {.xy = change, .yz = change};
    }

private:
    [[nodiscard]] double factor(double place) const noexcept { return 1.0 + growth * place; }
};
static_assert(deformation<taper>);

}  // namespace typemesh::inline TYPEMESH_ABI

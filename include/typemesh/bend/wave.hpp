// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/displaced.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// A surface of waves, like a flag's: z = height * sin(2 pi (x cos d + y sin d) / length + phase), where d is the
/// waves' direction. Moving waves are phases that change from frame to frame.
///
/// Fails  error::bad_option: a number is not finite, or the length is nearer to 0 than 2^-20 ("height", "length",
///        "direction", "phase")
struct wave {
    double height = 0.1;     ///< of a crest above z = 0, in em
    double length = 2.0;     ///< from crest to crest, in em
    double direction = 0.0;  ///< in which the waves follow each other, in degrees: 0 along the text, 90 up
    double phase = 0.0;      ///< in degrees

    /// See height_surface.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(height)) return error::bad("height");
        if (!is_finite(length) || !(std::fabs(length) >= 0x1p-20)) return error::bad("length");
        if (!is_finite(direction)) return error::bad("direction");
        return is_finite(phase) ? error{} : error::bad("phase");
    }

    [[nodiscard]] surface_height operator()(double x, double y) const noexcept
    {
        const double k = per_em(), turn = radians(direction), cosine = detail::steady_cosine(turn),
                     sine = detail::steady_sine(turn), angle = k * (x * cosine + y * sine) + radians(phase),
                     slope = height * k * detail::steady_cosine(angle);
        return {height * detail::steady_sine(angle), slope * cosine, slope * sine};
    }

    /// See height_surface.
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept
    {
        const double k = per_em(), bent = std::fabs(height) * k * k, turn = radians(direction),
                     cosine = std::fabs(detail::steady_cosine(turn)), sine = std::fabs(detail::steady_sine(turn));
        return {.xx = bent * cosine * cosine, .yy = bent * sine * sine, .xy = bent * cosine * sine};
    }

private:
    [[nodiscard]] static double radians(double degrees) noexcept { return degrees * 0.017453292519943295; }
    [[nodiscard]] double per_em() const noexcept { return 6.283185307179586 / length; }
};
static_assert(height_surface<wave> && deformation<displaced<wave>>);

}  // namespace typemesh::inline TYPEMESH_ABI

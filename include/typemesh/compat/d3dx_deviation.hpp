// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The tolerance in em (the greatest true distance between curve and mesh) that replaces a deviation of D3DXCreateText,
/// also in em: half the deviation, at most 0.0175.
///
/// Direct3D's deviation is the distance at which the control point of a quadratic is drawn instead of the curve. Its
/// polygon therefore runs outside the curve, and its error is nearly the deviation. A deviation that no curve of the
/// font reaches changes nothing. Measured over the letters of Latin-1, mesh against outline (bench/d3dx/run.sh
/// --letters; Wine's implementation, whose tests compare its algorithm with Microsoft's; unit: the cell height):
///
///                    DejaVu Sans             Liberation Sans
///     deviation   Direct3D   typemesh     Direct3D   typemesh      tolerance
///     0.1         0.0276     0.0150       0.0803     0.0154        0.0175      low
///     0.03        0.0259     0.0150       0.0237     0.0147        0.015
///     0.01        0.0099     0.0050       0.0097     0.0050        0.005       normal
///     0.005       0.0050     0.0025       0.0050     0.0025        0.0025      high
///     0.002       0.0022     0.0010       0.0022     0.0010        0.001
///     0.001       0.0014     0.0005       0.0012     0.0005        0.0005      best    (the thesis' four qualities)
///
/// The error is therefore half as large, with about as many triangles. This holds for the worst letter of a text. On
/// single letters Direct3D can be better, if its halving of curves happens to end far below the deviation.
///
/// Needs  deviation > 0, which is not checked here
[[nodiscard]] constexpr double d3dx_tolerance(double deviation) noexcept
{
    constexpr double coarsest = 0.0175;
    return deviation < 2.0 * coarsest ? 0.5 * deviation : coarsest;
}

}  // namespace typemesh::inline TYPEMESH_ABI

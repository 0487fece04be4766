// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/normalised.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A unit vector as two numbers: projected onto the octahedron around the origin, whose lower half is folded out.
///
///       +---+---+        (x, y) = (nx, ny) / (|nx| + |ny| + |nz|); where nz < 0, the corner triangles are folded over:
///       | / | \ |        (1 - |y|, 1 - |x|) with the signs of x and y. The middle is +z, the corners are -z.
///       +---+---+
///       | \ | / |        The result is the closest of the four steps around (x, y): the "precise" encoding, which
///       +---+---+        halves the error of plain rounding at about 4 times its cost.
///
///     octahedral<snorm8>    2 bytes, within 0.64 degrees of the given vector
///     octahedral<snorm16>   4 bytes, within 0.0025 degrees
///
/// A shader decodes with z = 1 - |x| - |y|, t = max(-z, 0), x -= sign(x) * t, y -= sign(y) * t, and normalises.
///
/// From  Z. Cigolle, S. Donow, D. Evangelakos, M. Mara, M. McGuire, Q. Meyer, "A Survey of Efficient Representations
///       for Independent Unit Vectors", Journal of Computer Graphics Techniques 3(2), 2014, oct16P and oct32P
template <class Step>
    requires std::same_as<Step, snorm8> || std::same_as<Step, snorm16>
struct octahedral {
    Step x;
    Step y;

    octahedral() = default;

    /// Encodes any vector except zero; the vector's length does not matter.
    octahedral(float nx, float ny, float nz) noexcept : octahedral{nx, ny, nz, every<1>{}, 0} {}

    /// The unit vector that it encodes.
    [[nodiscard]] vec3 decoded() const noexcept
    {
        const auto end = [](int bits) { return bits < -Step::most ? -1.0 : static_cast<double>(bits) / Step::most; };
        const direction d = unfolded(end(x.bits), end(y.bits));
        const double scale = 1.0 / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        return {static_cast<float>(scale * d.x), static_cast<float>(scale * d.y), static_cast<float>(scale * d.z)};
    }

protected:
    /// A step.
    template <int Apart>
    using every = std::integral_constant<int, Apart>;

    /// Encodes a vector with only some steps of y: the bits of these steps are y_first, y_first + y_apart and so on.
    template <int Apart>
    octahedral(float nx, float ny, float nz, every<Apart> y_apart, int y_first) noexcept
    {
        const direction n{as_double(nx), as_double(ny), as_double(nz)};
        const double whole = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
        double u = n.x / whole, v = n.y / whole;
        if (nz < 0.0f) {
            const double folded = std::copysign(1.0 - std::fabs(v), u);
            v = std::copysign(1.0 - std::fabs(u), v);
            u = folded;
        }
        // Rounds down without a call: an offset makes the numbers positive, and truncation rounds positive numbers
        // down.
        constexpr double step = 1.0 / Step::most;
        const int low_u = static_cast<int>(u * Step::most + Step::most) - Step::most,
                  low_v = (static_cast<int>(v * Step::most + 2 * Step::most + y_apart - y_first) / y_apart) * y_apart -
                          2 * Step::most - y_apart + y_first;
        // The squared cosine is along^2 / length^2. Two of them are compared by cross-multiplication.
        double best_along = 0.0, best_length = 1.0;
        int best_x = 0, best_y = 0;
        for (int i = 0; i < 4; ++i) {
            const int a = low_u + (i & 1), b = low_v + (i >> 1) * y_apart;
            const direction d = unfolded(a * step, b * step);
            const double along = d.x * n.x + d.y * n.y + d.z * n.z, length = d.x * d.x + d.y * d.y + d.z * d.z;
            const bool fits = (a <= Step::most) & (b <= Step::most) & (b >= -Step::most),
                       better = fits & (along * along * best_length > best_along * best_along * length);
            best_along = better ? along : best_along;
            best_length = better ? length : best_length;
            best_x = better ? a : best_x;
            best_y = better ? b : best_y;
        }
        x = Step::from_bits(static_cast<decltype(Step::bits)>(best_x));
        y = Step::from_bits(static_cast<decltype(Step::bits)>(best_y));
    }

private:
    struct direction {
        double x, y, z;
    };

    [[nodiscard]] static direction unfolded(double u, double v) noexcept
    {
        const double a = std::fabs(u), b = std::fabs(v), z = 1.0 - a - b, over = z < 0.0 ? -z : 0.0;
        return {std::copysign(a - over, u), std::copysign(b - over, v), z};
    }
};

using octahedral16 = octahedral<snorm8>;   ///< a direction in 16 bits
using octahedral32 = octahedral<snorm16>;  ///< a direction in 32 bits
static_assert(sizeof(octahedral16) == 2 && sizeof(octahedral32) == 4);

}  // namespace typemesh::inline TYPEMESH_ABI

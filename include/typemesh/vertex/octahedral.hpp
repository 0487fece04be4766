// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/normalised.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>

namespace typemesh {

/// A unit vector as two numbers, by the octahedron around the origin, its lower half folded out:
///
///       +---+---+        (x, y) = (nx, ny) / (|nx| + |ny| + |nz|); where nz < 0, the corners' triangles are turned
///       | / | \ |        over: (1 - |y|, 1 - |x|) with the signs of x and y. The middle is +z, the corners are -z.
///       +---+---+
///       | \ | / |        Of the four steps around (x, y) the one is taken whose vector lies closest: the "precise"
///       +---+---+        encoding, which halves the error of plain rounding at some 4 times its cost.
///
///     octahedral<snorm8>    2 bytes, within 0.64 degrees of the vector given
///     octahedral<snorm16>   4 bytes, within 0.0025 degrees
///
/// A shader decodes with z = 1 - |x| - |y|, t = max(-z, 0), x -= sign(x) * t, y -= sign(y) * t, and normalises.
///
/// From  Z. Cigolle, S. Donow, D. Evangelakos, M. Mara, M. McGuire, Q. Meyer, "A Survey of Efficient Representations for
///       Independent Unit Vectors", Journal of Computer Graphics Techniques 3(2), 2014, oct16P and oct32P
template <class Step>
    requires std::same_as<Step, snorm8> || std::same_as<Step, snorm16>
struct octahedral {
    Step x;
    Step y;

    octahedral() = default;

    /// Of a vector that is not zero; its length does not matter.
    octahedral(float nx, float ny, float nz) noexcept : octahedral{nx, ny, nz, 1, 0} {}

    /// The unit vector that it stands for.
    [[nodiscard]] vec3 decoded() const noexcept
    {
        const auto end = [](int bits) { return bits < -Step::most ? -1.0 : static_cast<double>(bits) / Step::most; };
        const direction d = unfolded(end(x.bits), end(y.bits));
        const double scale = 1.0 / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        return {static_cast<float>(scale * d.x), static_cast<float>(scale * d.y), static_cast<float>(scale * d.z)};
    }

protected:
    /// The same with only every y_apart-th step of y allowed: those whose bits are y_first, and so on.
    octahedral(float nx, float ny, float nz, int y_apart, int y_first) noexcept
    {
        const double whole = std::fabs(static_cast<double>(nx)) + std::fabs(static_cast<double>(ny)) +
                             std::fabs(static_cast<double>(nz));
        double u = nx / whole, v = ny / whole;
        if (nz < 0.0f) {
            const double folded = (1.0 - std::fabs(v)) * sign(u);
            v = (1.0 - std::fabs(u)) * sign(v);
            u = folded;
        }
        const double low_u = std::floor(u * Step::most),
                     low_v = y_apart * std::floor((v * Step::most - y_first) / y_apart) + y_first;
        double closest = -2.0;
        for (int i = 0; i < 4; ++i) {
            const double a = low_u + (i & 1), b = low_v + (i >> 1) * y_apart;
            if (a > Step::most || b > Step::most || b < -Step::most) continue;
            const direction d = unfolded(a / Step::most, b / Step::most);
            const double along = (d.x * nx + d.y * ny + d.z * nz) / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
            if (along <= closest) continue;
            closest = along;
            x = Step::from_bits(static_cast<decltype(Step::bits)>(a));
            y = Step::from_bits(static_cast<decltype(Step::bits)>(b));
        }
    }

private:
    struct direction {
        double x, y, z;
    };

    [[nodiscard]] static double sign(double v) noexcept { return v < 0.0 ? -1.0 : 1.0; }

    [[nodiscard]] static direction unfolded(double u, double v) noexcept
    {
        const double z = 1.0 - std::fabs(u) - std::fabs(v);
        if (z >= 0.0) return {u, v, z};
        return {(1.0 - std::fabs(v)) * sign(u), (1.0 - std::fabs(u)) * sign(v), z};
    }
};

using octahedral16 = octahedral<snorm8>;
using octahedral32 = octahedral<snorm16>;
static_assert(sizeof(octahedral16) == 2 && sizeof(octahedral32) == 4);

}  // namespace typemesh

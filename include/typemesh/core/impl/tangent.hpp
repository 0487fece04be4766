// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The directions in which a curve arrives at t and leaves it, for growing t. Neither has unit length. They are zero
/// only if the curve is a single point.
///
/// The two differ only at a cusp or a reversal, where the curve stops and turns back. The derivative vanishes there,
/// and at handles of zero length. The directions are then its one-sided limits:
///
///        after                B(t) = B + B'h + B''h^2/2 + B'''h^3/6: the first term that does not vanish
///     \  ^  /                 gives the direction; before t, the even terms change sign.
///      \ | /
///       \|/   <- cusp: before and after are opposite
///
/// "Vanishes" means shorter than 2^-20 of the control polygon's longest leg, because t is stored in 32 bits.
struct tangents {
    point before;
    point after;
    bool stops = false;  ///< the derivative vanishes at t
};

/// The derivative of one curve. It is computed once, for the tangents at all t.
class hodograph {
public:
    hodograph() noexcept = default;
    /// Multiplies the derivative by `sign`, 1 or -1.
    explicit hodograph(const curve& c, double sign = 1.0) noexcept : degree_{c.degree}, a_{sign * (c.p[1] - c.p[0])}
    {
        if (degree_ == 1) return;
        b_ = sign * (c.p[2] - c.p[1]);
        least_ = dot(a_, a_) > dot(b_, b_) ? dot(a_, a_) : dot(b_, b_);
        if (degree_ == 3) {
            d_ = sign * (c.p[3] - c.p[2]);
            least_ = dot(d_, d_) > least_ ? dot(d_, d_) : least_;
        }
        least_ *= 0x1p-40;
    }

    [[nodiscard]] tangents at(double t) const noexcept
    {
        const point first = derivative(t);
        return vanishes(first) ? limits(t) : tangents{first, first};
    }

    /// The direction at t if it does not vanish: the derivative, divided by the degree.
    [[nodiscard]] point derivative(double t) const noexcept
    {
        if (degree_ == 1) return a_;
        const point ab = lerp(a_, b_, t);
        return degree_ == 2 ? ab : lerp(ab, lerp(b_, d_, t), t);
    }
    [[nodiscard]] bool vanishes(point derivative) const noexcept { return !(dot(derivative, derivative) > least_); }

    /// Whether the curve is a line: the derivative is then the same at all t.
    [[nodiscard]] bool is_constant() const noexcept { return degree_ == 1; }

private:
    /// The two directions where the derivative vanishes.
    [[nodiscard]] tangents limits(double t) const noexcept
    {
        const point second = degree_ == 2 ? b_ - a_ : lerp(b_, d_, t) - lerp(a_, b_, t);
        if (degree_ == 2 || dot(second, second) > least_) return {-1.0 * second, second, true};
        const point third = d_ - 2.0 * b_ + a_;
        return {third, third, true};
    }

    std::uint32_t degree_ = 1;
    point a_, b_, d_;      // the legs of the control polygon
    double least_ = -1.0;  // a derivative vanishes unless its square is greater; for lines it never vanishes
};

[[nodiscard]] inline tangents tangents_at(const curve& c, double t) noexcept { return hodograph{c}.at(t); }

/// The side of t on which a tangent is taken.
enum class side_of : std::uint8_t { before, after };

/// One of the two directions of tangents_at().
[[nodiscard]] inline point tangent(const curve& c, double t, side_of side) noexcept
{
    const tangents both = tangents_at(c, t);
    return side == side_of::before ? both.before : both.after;
}

}  // namespace typemesh::inline TYPEMESH_ABI

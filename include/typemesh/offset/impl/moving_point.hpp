// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>
#include <typemesh/offset/impl/int128.hpp>

#include <bit>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

// A wavefront moves in fixed-point numbers of 64 bits, so that it moves identically on every compiler. Their units:
//
//     place    2^-16 cells                            below 2^45
//     time     2^-32 cells: the distance swept        below 2^60
//     speed    2^-32                                  below 2^54
//     unit     2^-30: a component of a unit vector
//
// A place stays within its budget: a triangle beside a corner becomes flat long before the corner has moved so far.

inline constexpr std::int64_t place_one = std::int64_t{1} << 16;
inline constexpr std::int64_t time_one = std::int64_t{1} << 32;
inline constexpr std::int64_t unit_one = std::int64_t{1} << 30;

/// Rounding may separate or unite places within a sixteenth of a cell: `slip` in units of place, `slip_along` in place
/// times unit.
inline constexpr int slip_bits = 12;
inline constexpr std::int64_t slip = std::int64_t{1} << slip_bits;
inline constexpr int128 slip_along = static_cast<int128>(unit_one) * slip;
static_assert(16 * slip == place_one);

/// A vector in one of these units.
struct fixed_vector {
    std::int64_t x = 0, y = 0;

    friend constexpr fixed_vector operator+(fixed_vector a, fixed_vector b) noexcept { return {a.x + b.x, a.y + b.y}; }
    friend constexpr fixed_vector operator-(fixed_vector a, fixed_vector b) noexcept { return {a.x - b.x, a.y - b.y}; }
};
[[nodiscard]] constexpr int128 dot(fixed_vector a, fixed_vector b) noexcept
{
    return static_cast<int128>(a.x) * b.x + static_cast<int128>(a.y) * b.y;
}
[[nodiscard]] constexpr int128 cross(fixed_vector a, fixed_vector b) noexcept
{
    return static_cast<int128>(a.x) * b.y - static_cast<int128>(a.y) * b.x;
}
[[nodiscard]] constexpr fixed_vector middle(fixed_vector a, fixed_vector b) noexcept
{
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// The unit vector along v, which is not 0 and below 2^32.
[[nodiscard]] inline fixed_vector unit_along(fixed_vector v) noexcept
{
    const std::int64_t x = v.x < 0 ? -v.x : v.x, y = v.y < 0 ? -v.y : v.y;
    const int above = std::countl_zero(static_cast<std::uint64_t>(x | y)) - 32;
    const std::int64_t scale = std::int64_t{1} << (above > 0 ? above : 0);
    const fixed_vector large{v.x * scale, v.y * scale};
    const std::int64_t size = square_root(dot(large, large));
    return {nearest_quotient(static_cast<int128>(large.x) * unit_one, size),
            nearest_quotient(static_cast<int128>(large.y) * unit_one, size)};
}

/// A straight line that moves to its left with speed 1.
struct moving_line {
    fixed_vector along;  ///< unit
    [[nodiscard]] constexpr fixed_vector inward() const noexcept { return {-along.y, along.x}; }
};

/// Whether the line after a corner turns left, seen from the line before it.
[[nodiscard]] constexpr bool turns_left(const moving_line& before, const moving_line& after) noexcept
{
    return cross(before.along, after.along) > 0;
}

/// The speed of the common point of two moving lines. If they run in nearly opposite directions, so that it would cross
/// the whole grid at once, it is `instant` and has no speed.
struct crossing_speed {
    fixed_vector of;
    bool instant = false;
};

/// The v with v * inward = 1 for both lines: (n1 + n2) / (1 + n1 n2). If they turn by more than a right angle, these
/// terms cancel, and the formula is (d2 - d1) / (d1 x d2).
///
/// A corner that is born during the sweep (`born`) and turns right by nearly half a turn is no needle of the outline:
/// it is the end of an area that lost its last bit of width to rounding, so it is instant as well.
[[nodiscard]] inline crossing_speed speed_of(const moving_line& before, const moving_line& after, bool born) noexcept
{
    constexpr std::int64_t one = unit_one * unit_one, least_sine = one >> 20, needle = one - (one >> 10);
    const auto cosine = static_cast<std::int64_t>(dot(before.along, after.along));
    const auto sine = static_cast<std::int64_t>(cross(before.along, after.along));
    fixed_vector sum = before.inward() + after.inward();
    std::int64_t whole = one + cosine;
    if (cosine < 0) {
        if (sine < least_sine && (sine > -least_sine || (born && cosine < -needle))) return {{}, true};
        sum = after.along - before.along;
        whole = sine;
    }
    constexpr int128 scale = static_cast<int128>(1) << 62;  // from units to speeds: 2 + 60 bits
    return {{nearest_quotient(sum.x * scale, whole), nearest_quotient(sum.y * scale, whole)}, false};
}

/// A corner of the moving boundary.
struct moving_point {
    fixed_vector start;      ///< place
    std::int64_t since = 0;  ///< the time at which the point was at `start`
    crossing_speed speed;

    [[nodiscard]] bool instant() const noexcept { return speed.instant; }
    [[nodiscard]] fixed_vector place(std::int64_t time) const noexcept
    {
        const std::int64_t passed = time - since;
        if (passed == 0) return start;
        return {start.x + shifted_product(speed.of.x, passed, 48), start.y + shifted_product(speed.of.y, passed, 48)};
    }
};

[[nodiscard]] constexpr fixed_vector place_of(grid_point p) noexcept { return {p.x * place_one, p.y * place_one}; }
[[nodiscard]] constexpr grid_point nearest_cell(fixed_vector place) noexcept
{
    return {static_cast<std::int32_t>((place.x + place_one / 2) >> 16),
            static_cast<std::int32_t>((place.y + place_one / 2) >> 16)};
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

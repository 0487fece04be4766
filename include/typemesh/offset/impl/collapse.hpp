// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The ways in which a kinetic triangle becomes flat.
///
///     shrink      the segment on half-edge k loses its length
///     close_up    that segment ends in an instant corner: the area beside it has no width
///     meet        the triangle's apex reaches the line of the segment on half-edge k
///     turn        the triangle has no segment, and one of its corners reaches the opposite diagonal
struct collapse {
    enum class kind : std::uint8_t { shrink, close_up, meet, turn };

    std::int64_t time = 0;
    std::uint32_t triangle = 0;
    std::uint32_t stamp = 0;  ///< the triangle's stamp when this was found; a later stamp makes it void
    kind what = kind::turn;
    std::uint8_t k = 0;
    std::int64_t reach = 0;  ///< only meet and turn: the length of the flat triangle, in units of place

    /// Events within 1/4096 cell happen at one time.
    [[nodiscard]] static constexpr std::int64_t tick(std::int64_t time) noexcept { return time >> 20; }

    /// Of several events at one time, vanishing lengths come first, then the longest triangles. A flip replaces their
    /// longest edge with a shorter one, so the flips at one time come to an end.
    /// From  P. Palfrader, M. Held, S. Huber: On computing straight skeletons by means of kinetic triangulations
    ///       (2012), section 3
    friend bool operator<(const collapse& a, const collapse& b) noexcept
    {
        const std::int64_t a_time = tick(a.time), b_time = tick(b.time);
        if (a_time != b_time) return a_time < b_time;
        const bool a_flat = a.what >= kind::meet, b_flat = b.what >= kind::meet;
        if (a_flat != b_flat) return b_flat;
        if (a.reach != b.reach) return a.reach > b.reach;
        return a.triangle < b.triangle;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The triangles that a triangulator has appended for a region, checked against triangulator.hpp. For TYPEMESH_ASSERT:
/// O(points + triangles), so release builds never use it.
struct appended_triangles {
    const region& filled;
    array_view<const triangle> all;

    [[nodiscard]] bool are_as_many_as_promised() const noexcept { return all.size() == filled.triangle_count(); }
    [[nodiscard]] bool are_over_its_points() const noexcept
    {
        const std::size_t n = filled.points().size();
        for (const triangle t : all)
            if (t.a >= n || t.b >= n || t.c >= n) return false;
        return true;
    }
    [[nodiscard]] bool turn_left() const noexcept
    {
        for (const triangle t : all)
            if (doubled_area(t) <= 0) return false;
        return true;
    }
    /// Whether the triangles have the region's area. Partial sums may wrap; modulo 2^64 the comparison is exact.
    [[nodiscard]] bool have_its_area() const noexcept
    {
        std::uint64_t sum = 0;
        for (const triangle t : all) sum += static_cast<std::uint64_t>(doubled_area(t));
        const auto points = filled.points();
        for (std::uint32_t k = 0; k < filled.loop_count(); ++k)
            for (std::uint32_t i = filled.starts()[k] + 1; i + 1 < filled.starts()[k + 1]; ++i)
                sum -= static_cast<std::uint64_t>(orientation(points[filled.starts()[k]], points[i], points[i + 1]));
        return sum == 0;
    }

private:
    [[nodiscard]] std::int64_t doubled_area(triangle t) const noexcept
    {
        return orientation(filled.points()[t.a], filled.points()[t.b], filled.points()[t.c]);
    }
};

/// Asserts a triangulator's guarantees for the triangles that it appended to `out` after the first `before`. False if
/// this finds them unusable; builds without asserts check nothing.
inline bool assert_triangles([[maybe_unused]] const region& filled, [[maybe_unused]] const triangle_list& out,
                             [[maybe_unused]] std::size_t before) noexcept
{
    [[maybe_unused]] const auto appended = [&]() noexcept {
        return appended_triangles{filled,
                                  before < out.size() ? out.view().subspan(before) : array_view<const triangle>{}};
    };
    bool readable = true;  // otherwise the checks below would read past the points
    [[maybe_unused]] bool enough = true, turned = true;
    TYPEMESH_ASSERT((enough = appended().are_as_many_as_promised()),
                    "a triangulator appended more or fewer triangles than the region's triangle_count()");
    TYPEMESH_ASSERT((readable = appended().are_over_its_points()),
                    "a triangulator appended a triangle with a corner that is not a point of the region");
    TYPEMESH_ASSERT(!readable || (turned = appended().turn_left()),
                    "a triangulator appended a triangle that is flat or clockwise");
    TYPEMESH_ASSERT(!readable || appended().have_its_area(),
                    "a triangulator appended triangles that do not have the region's area");
    return readable && enough && turned;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

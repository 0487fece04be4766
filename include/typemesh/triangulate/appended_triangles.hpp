// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// What a triangulator has appended for a region, held against what triangulator.hpp asks of it. For TYPEMESH_ASSERT:
/// O(points + triangles), so release builds never call it.
struct appended_triangles {
    const region& shape;
    std::span<const triangle> all;

    [[nodiscard]] bool are_as_many_as_promised() const noexcept { return all.size() == shape.triangle_count(); }
    [[nodiscard]] bool are_over_its_points() const noexcept
    {
        const std::size_t n = shape.points().size();
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
    /// Whether the triangles have the region's area. Sums may wrap on the way: modulo 2^64 they stay exact.
    [[nodiscard]] bool have_its_area() const noexcept
    {
        std::uint64_t sum = 0;
        for (const triangle t : all) sum += static_cast<std::uint64_t>(doubled_area(t));
        const auto points = shape.points();
        for (std::uint32_t k = 0; k < shape.loop_count(); ++k)
            for (std::uint32_t i = shape.starts()[k] + 1; i + 1 < shape.starts()[k + 1]; ++i)
                sum -= static_cast<std::uint64_t>(orientation(points[shape.starts()[k]], points[i], points[i + 1]));
        return sum == 0;
    }

private:
    [[nodiscard]] std::int64_t doubled_area(triangle t) const noexcept
    {
        return orientation(shape.points()[t.a], shape.points()[t.b], shape.points()[t.c]);
    }
};

/// Holds a triangulator to its promise of the triangles that it has appended to `out` behind the first `before`. False
/// where that shows them not to be fit for more; builds without asserts believe everything.
inline bool assert_triangles([[maybe_unused]] const region& shape, [[maybe_unused]] const triangle_list& out,
                             [[maybe_unused]] std::size_t before) noexcept
{
    [[maybe_unused]] const auto appended = [&]() noexcept {
        return appended_triangles{shape, before < out.size() ? out.view().subspan(before) : std::span<const triangle>{}};
    };
    bool readable = true;  // the sentences below would read past the points
    [[maybe_unused]] bool enough = true, turned = true;
    TYPEMESH_ASSERT((enough = appended().are_as_many_as_promised()),
                    "a triangulator appended more or fewer triangles than the region's triangle_count()");
    TYPEMESH_ASSERT((readable = appended().are_over_its_points()),
                    "a triangulator appended a triangle with a corner that is no point of the region");
    TYPEMESH_ASSERT(!readable || (turned = appended().turn_left()),
                    "a triangulator appended a triangle that is flat or does not turn counter-clockwise");
    TYPEMESH_ASSERT(!readable || appended().have_its_area(),
                    "a triangulator appended triangles that do not have the region's area");
    return readable && enough && turned;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

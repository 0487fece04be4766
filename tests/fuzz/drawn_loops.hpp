// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include "support/regions.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fuzz {

using test::polyline;
using typemesh::grid_point;

/// Reads closed polylines: on a grid of 16 by 16, on the same grid stretched, on one of 256, of 65,536, over the whole
/// grid, or at the grid's ends and round 0.
///
///     kind | loops as drawn, or uncrossed | for each loop: its points, fewer than 16 or 48 | points
class loop_reader {
public:
    explicit loop_reader(values& in) noexcept
        : in_{in}, kind_{in.below(6)}, stretch_{1 << (kind_ == 1 ? in.below(24) : 0)}
    {
    }

    /// Points are below 2^17 in size, so that floats have plenty of room between them.
    [[nodiscard]] bool is_small() const noexcept { return kind_ == 0 || kind_ == 2 || kind_ == 3; }

    [[nodiscard]] std::vector<polyline> read(std::size_t max_points)
    {
        const std::uint32_t shape = in_.byte();
        std::vector<polyline> loops;
        for (std::size_t left = max_points; left >= 3 && !in_.empty();) {
            const std::size_t count = (std::min)(left, std::size_t{3} + in_.below((shape & 2) != 0 ? 46 : 14));
            polyline l;
            for (std::size_t i = 0; i < count && !in_.empty(); ++i) {
                const grid_point p = point();
                if (l.empty() || !(p == l.back())) l.push_back(p);
            }
            while (l.size() > 1 && l.back() == l.front()) l.pop_back();
            if (l.size() < 3) continue;
            left -= l.size();
            if ((shape & 1) != 0) uncross(l);
            loops.push_back(std::move(l));
        }
        return loops;
    }

private:
    [[nodiscard]] grid_point point() noexcept
    {
        if (kind_ < 2) {
            const auto b = static_cast<std::int32_t>(in_.byte());
            return {((b >> 4) - 8) * stretch_, ((b & 15) - 8) * stretch_};
        }
        const std::int32_t x = coordinate();
        return {x, coordinate()};
    }
    [[nodiscard]] std::int32_t coordinate() noexcept
    {
        constexpr std::int32_t end = 1 << 28, ends[] = {-end, -end + 1, -end + 2, -end / 2, -2,      -1,      0,  1, 2,
                                                        3,    end / 3,  end / 2,  end - 3,  end - 2, end - 1, end};
        if (kind_ == 2) return static_cast<std::int32_t>(in_.byte());
        if (kind_ == 3) return static_cast<std::int32_t>(in_.bits(2)) - 0x8000;
        if (kind_ == 5) return in_.one_of(ends);
        return static_cast<std::int32_t>(in_.bits(4) % (2u * end + 1u)) - end;
    }

    /// Reverses the points between two edges that meet, a few times over: the result is mostly simple.
    static void uncross(polyline& l)
    {
        const auto at = [&](std::size_t i) { return l.begin() + static_cast<std::ptrdiff_t>(i); };
        bool changed = true;
        for (int round = 0; changed && round < 24; ++round) {
            changed = false;
            for (std::size_t i = 0; i + 2 < l.size(); ++i)
                for (std::size_t j = i + 2; j < l.size() - (i == 0 ? 1 : 0); ++j) {
                    if (!test::oracle::meet(l[i], l[i + 1], l[j], l[(j + 1) % l.size()])) continue;
                    std::reverse(at(i + 1), at(j + 1));
                    changed = true;
                }
        }
        l.erase(std::unique(l.begin(), l.end()), l.end());
    }

    values& in_;
    std::uint32_t kind_;
    std::int32_t stretch_;
};

}  // namespace fuzz

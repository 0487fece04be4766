// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/boundary_walk.hpp>
#include <typemesh/fill/resolving_sweep.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh {

[[nodiscard]] inline result<region> resolve(contours& loops, fill_rule rule, workspace& space, std::uint32_t* walks = nullptr) noexcept
{
    constexpr std::uint32_t most_walks = 256;
    const std::size_t n = loops.points.size();
    if (n > 0x3FFF'FFFF) return error::too_large;
    workspace::scope scratch{space};
    detail::arrangement a;
    auto room = static_cast<std::uint32_t>(n + n / 2 + 64);
    if (!a.reserve(scratch, room) || !a.take_apart(loops, space)) return error::out_of_memory;
    for (std::uint32_t walk = 0; walk < most_walks; ++walk) {
        detail::resolving_sweep sweep{a, rule};
        if (!sweep.run(space)) return error::out_of_memory;
        if (walks != nullptr) ++*walks;
        if (sweep.again) {
            if (a.count > a.capacity / 4 * 3 || sweep.full) {
                if (a.capacity > 0x3FFF'FFFF) return error::too_large;
                if (!a.reserve(scratch, 2 * a.capacity)) return error::out_of_memory;
                if (!a.put_in_order(space)) return error::out_of_memory;
            }
            continue;
        }
        detail::boundary_walk boundary;
        bool broken = false;
        if (!boundary.run(a, rule, loops, broken)) return broken ? error::crossing_contours : error::out_of_memory;
        return region::proven(loops, boundary.holes, boundary.outers, sweep.touching);
    }
    return error::crossing_contours;
}

}  // namespace typemesh

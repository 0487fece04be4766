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
#include <typemesh/fill/snap_rounding.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh {

[[nodiscard]] inline result<region> resolve(contours& loops, fill_rule rule, workspace& space, std::uint32_t* walks = nullptr) noexcept
{
    constexpr std::uint32_t most_bends = 2;
    const std::size_t n = loops.points.size();
    if (n > 0x1FFF'FFFF) return error::too_large;
    workspace::scope scratch{space};
    detail::arrangement a;
    if (!a.reserve(scratch, static_cast<std::uint32_t>(n + n / 2 + 64)) || !a.take_apart(loops, space)) return error::out_of_memory;
    bool rounded = false;
    for (std::uint32_t bent = 0;;) {
        detail::resolving_sweep sweep{a, rule};
        if (!sweep.run(space)) return error::out_of_memory;
        if (walks != nullptr) ++*walks;
        if (!sweep.again) {
            detail::boundary_walk boundary;
            bool broken = false;
            if (!boundary.run(a, rule, loops, broken)) return broken ? error::crossing_contours : error::out_of_memory;
            return region::proven(loops, boundary.holes, boundary.outers, sweep.touching);
        }
        if (rounded) {
            if (!sweep.full) return error::crossing_contours;  // not reached
            if (a.capacity > 0x3FFF'FFFF) return error::too_large;
            if (!a.reserve(scratch, 2 * a.capacity) || !a.put_in_order(space)) return error::out_of_memory;
        } else if (sweep.full && !sweep.astray && a.capacity < 12 * n + 256) {
            bent = 0;
            if (!a.reserve(scratch, 2 * a.capacity) || !a.take_apart(loops, space)) return error::out_of_memory;
        } else if (sweep.full || sweep.astray || ++bent == most_bends) {
            if (!a.take_apart(loops, space) || !detail::snap_rounding::run(a, scratch, space)) return error::out_of_memory;
            rounded = true;
        }
    }
}

}  // namespace typemesh

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/crossing.hpp>
#include <typemesh/fill/crossing_sweep.hpp>
#include <typemesh/fill/growing.hpp>
#include <typemesh/fill/hot_cells.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::detail {

/// Cuts all stretches of an arrangement at once where they come through hot cells: snap rounding.
///
///      .   .   .   .   .      The cell round a grid point is hot when a stretch ends or two cross in it. Every
///        +---+   _.-''.       stretch is led through the middle of every hot cell that it comes through. Nothing
///      . | x-+-''  .   .      moves by more than half a cell in x and y, and no two of the new stretches cross: this
///     .-'+---+ `-.            is proven in the second paper. More cells may be hot; each only adds a point. Points may
///      .   .   .   `.  .      come near stretches, or on them; the walk behind it cuts the latter, bending nothing.
///
/// The sweep needs less for what real outlines hold, and may need many rounds for long edges that run together at a
/// distance below a cell; those are for this way. Crossings are found by crossing_sweep, in O((n + k) log n); where it
/// misses one, a walk over what comes out finds it, and its points are hot in the next round. Only to be certain of an
/// end, run_all() finds every crossing by testing all pairs whose boxes meet; no input is known that comes so far.
///
/// Exact in 64 bits: see hot_cells and crossing_of().
/// From   Hobby, Practical segment intersection with finite precision output (1999); Guibas & Marimont, Rounding
///        arrangements dynamically (1998)
class snap_rounding {
public:
    /// Takes the arrangement as take_apart() leaves it and gives it the cut stretches, in order. The cells of its
    /// points, of its crossings and of `more` are hot. False when there is no memory.
    [[nodiscard]] static bool run(arrangement& a, std::span<const grid_point> more, workspace::scope& scratch,
                                  workspace& space) noexcept
    {
        growing<grid_point> hot{scratch};
        for (const grid_point p : more)
            if (!hot.add(p)) return false;
        return crossing_sweep::run(a, scratch, hot) && lead(a, hot, scratch, space);
    }

    /// The same with all crossings in hot cells.
    [[nodiscard]] static bool run_all(arrangement& a, workspace::scope& scratch, workspace& space) noexcept
    {
        growing<grid_point> hot{scratch};
        return all_crossings(a, scratch, hot) && lead(a, hot, scratch, space);
    }

private:
    [[nodiscard]] static bool all_crossings(const arrangement& a, workspace::scope& scratch,
                                            growing<grid_point>& out) noexcept
    {
        auto* const open = scratch.take<std::uint32_t>(a.count);
        if (open == nullptr) return false;
        std::uint32_t open_count = 0;
        for (std::uint32_t v = 0; v < a.point_count; ++v) {
            for (std::uint32_t i = a.first[v]; i != no_number; i = a.stretches[i].next) {
                const stretch& s = a.stretches[i];
                const std::int32_t bottom = s.from.y < s.to.y ? s.from.y : s.to.y,
                                   top = s.from.y < s.to.y ? s.to.y : s.from.y;
                std::uint32_t still = 0;
                for (std::uint32_t k = 0; k < open_count; ++k) {
                    const stretch& o = a.stretches[open[k]];
                    if (o.to.x < s.from.x) continue;
                    open[still++] = open[k];
                    if ((o.from.y > top && o.to.y > top) || (o.from.y < bottom && o.to.y < bottom)) continue;
                    grid_point x;
                    if (crossing_of(s.from, s.to, o.from, o.to, x) && !out.add(x)) return false;
                }
                open_count = still;
                open[open_count++] = i;
            }
        }
        return true;
    }

    /// Leads every stretch through the cells of `hot` and of the ends of all.
    [[nodiscard]] static bool lead(arrangement& a, growing<grid_point>& hot, workspace::scope& scratch,
                                   workspace& space) noexcept
    {
        for (std::uint32_t i = 0; i < a.point_count; ++i)
            if (!hot.add(a.points[i])) return false;
        hot_cells cells;
        if (!cells.open({hot.values, hot.count}, scratch)) return false;
        growing<stretch> cut{scratch};
        for (std::uint32_t i = 0; i < a.count; ++i) {
            const stretch s = a.stretches[i];
            stretch rest = s;
            const auto step = [&](grid_point p) noexcept {
                if (p == s.from || p == s.to) return true;
                stretch part = rest;
                part.to = p;
                part.source.t1 = rest.t_at(p);
                part.bent = rest.bent = 1;
                rest.from = p;
                rest.source.t0 = part.source.t1;
                return cut.add(part);
            };
            if (!cells.along(s.from, s.to, step) || !cut.add(rest)) return false;
        }
        if (cut.count > 0x3FFF'FFFF) return false;
        a.stretches = cut.values;
        a.count = static_cast<std::uint32_t>(cut.count);
        return a.reserve(scratch, a.count + a.count / 4 + 64) && a.put_in_order(space);
    }
};

}  // namespace typemesh::detail

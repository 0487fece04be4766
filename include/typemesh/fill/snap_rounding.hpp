// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/sweep_order.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/crossing.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::detail {

/// Cuts all stretches of an arrangement at once, so that no two cross afterwards: snap rounding.
///
///      .   .   .   .   .      The cell round a grid point is hot when a stretch ends or two cross in it. Every
///        +---+   _.-''.       stretch is led through the middle of every hot cell that it comes through. Nothing
///      . | x-+-''  .   .      moves by more than half a cell's diagonal, no two of the new stretches cross, and none
///     .-'+---+ `-.            comes near a point without ending in it: this is proven in the second paper, and needs
///      .   .   .   `.  .      one round only.
///
/// The sweep needs less for what real outlines hold, and may need many rounds for long edges that run together at a
/// distance below a cell; those are for this way, which is plain: pairs of stretches are tested whose boxes meet.
///
/// Exact: a stretch comes through the half-open cell [-1/2, 1/2)² round p when |2 s| < |dx| + |dy| for s =
/// orientation(from, to, p), or when it touches it in the one corner that belongs to the cell. Below 2^62.
/// From   Hobby, Practical segment intersection with finite precision output (1999); Guibas & Marimont, Rounding
///        arrangements dynamically (1998)
class snap_rounding {
public:
    /// Takes the arrangement as take_apart() leaves it and gives it the cut stretches, in order. False when there is no
    /// memory.
    [[nodiscard]] static bool run(arrangement& a, workspace::scope& scratch, workspace& space) noexcept
    {
        growing<grid_point> hot{scratch};
        if (!find_crossings(a, scratch, hot)) return false;
        for (std::uint32_t i = 0; i < a.point_count; ++i)
            if (!hot.add(a.points[i])) return false;
        auto* const order = scratch.take<std::uint32_t>(hot.count);
        auto* const cells = scratch.take<grid_point>(hot.count);
        auto* const columns = scratch.take<std::uint32_t>(hot.count + 1);
        if (order == nullptr || cells == nullptr || columns == nullptr ||
            !sweep_order({hot.values, hot.count}, space, order))
            return false;
        std::uint32_t count = 0, column_count = 0;
        for (std::size_t i = 0; i < hot.count; ++i) {
            const grid_point p = hot.values[order[i]];
            if (count != 0 && cells[count - 1] == p) continue;
            if (count == 0 || cells[count - 1].x != p.x) columns[column_count++] = count;
            cells[count++] = p;
        }
        columns[column_count] = count;

        growing<stretch> cut{scratch};
        for (std::uint32_t i = 0; i < a.count; ++i)
            if (!lead(a.stretches[i], cells, columns, column_count, cut)) return false;
        a.stretches = cut.values;
        a.count = static_cast<std::uint32_t>(cut.count);
        if (cut.count > 0x3FFF'FFFF || !a.reserve(scratch, a.count + a.count / 4 + 64)) return false;
        return a.put_in_order(space);
    }

private:
    template <class T>
    struct growing {
        workspace::scope& scratch;
        T* values = nullptr;
        std::size_t count = 0;
        std::size_t room = 0;

        [[nodiscard]] bool add(const T& value) noexcept
        {
            if (count == room) {
                const std::size_t more = room == 0 ? 256 : 2 * room;
                T* const larger = scratch.take<T>(more);
                if (larger == nullptr) return false;
                if (count != 0) std::memcpy(static_cast<void*>(larger), values, count * sizeof(T));
                values = larger;
                room = more;
            }
            values[count++] = value;
            return true;
        }
    };

    [[nodiscard]] static bool find_crossings(const arrangement& a, workspace::scope& scratch,
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

    [[nodiscard]] static bool comes_through(const stretch& s, grid_point p) noexcept
    {
        const std::int64_t dx = std::int64_t{s.to.x} - s.from.x, dy = std::int64_t{s.to.y} - s.from.y;
        const std::int64_t side = 2 * orientation(s.from, s.to, p), reach = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
        if (side >= reach || side <= -reach) return side == dx - dy && (side == reach || side == -reach);
        return true;
    }

    /// Leads one stretch through its hot cells.
    [[nodiscard]] static bool lead(const stretch& s, const grid_point* cells, const std::uint32_t* columns,
                                   std::uint32_t column_count, growing<stretch>& out) noexcept
    {
        stretch rest = s;
        const auto step = [&](grid_point p) noexcept {
            if (p == s.from || p == s.to || !comes_through(s, p)) return true;
            stretch part = rest;
            part.to = p;
            part.source.t1 = s.t_at(p);
            part.bent = rest.bent = 1;
            rest.from = p;
            rest.source.t0 = part.source.t1;
            return out.add(part);
        };
        const std::int32_t bottom = s.from.y < s.to.y ? s.from.y : s.to.y, top = s.from.y < s.to.y ? s.to.y : s.from.y;
        const double slope = s.to.x == s.from.x
                                 ? 0.0
                                 : (static_cast<double>(s.to.y) - s.from.y) / (static_cast<double>(s.to.x) - s.from.x);
        std::uint32_t c = 0;  // the first column that is not left of the stretch
        for (std::uint32_t size = column_count; size != 0;) {
            const std::uint32_t half = size / 2;
            if (cells[columns[c + half]].x < s.from.x) {
                c += half + 1;
                size -= half + 1;
            } else {
                size = half;
            }
        }
        for (; c < column_count && cells[columns[c]].x <= s.to.x; ++c) {
            // What is cut off here is 2 cells away at least: rounding does not matter.
            double low = bottom, high = top;
            if (s.to.x != s.from.x) {
                const double middle = s.from.y + slope * (static_cast<double>(cells[columns[c]].x) - s.from.x),
                             reach = std::fabs(slope) + 3.0;
                low = middle - reach > low ? middle - reach : low;
                high = middle + reach < high ? middle + reach : high;
            }
            const std::uint32_t begin = first_from(cells, columns[c], columns[c + 1], low), end = columns[c + 1];
            std::uint32_t past = begin;
            while (past < end && cells[past].y <= high) ++past;
            if (s.to.y >= s.from.y) {
                for (std::uint32_t i = begin; i < past; ++i)
                    if (!step(cells[i])) return false;
            } else {
                for (std::uint32_t i = past; i-- > begin;)
                    if (!step(cells[i])) return false;
            }
        }
        return out.add(rest);
    }

    [[nodiscard]] static std::uint32_t first_from(const grid_point* cells, std::uint32_t begin, std::uint32_t end,
                                                  double y) noexcept
    {
        while (begin < end) {
            const std::uint32_t middle = begin + (end - begin) / 2;
            if (cells[middle].y < y)
                begin = middle + 1;
            else
                end = middle;
        }
        return begin;
    }
};

}  // namespace typemesh::detail

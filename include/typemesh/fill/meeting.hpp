// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh {

/// Two edges of the contours, and the grid point where they cross or where one of them ends on the other.
///
///     a.from ---.__                        The edges are the contours' own, not the pieces that they are cut into.
///     b.from ____  '--.__                  Where edges only share an end there is no meeting to tell of: that point
///                '-----x-------- b.to      lies on the curves of both.
///                        '---.__ a.to
struct meeting {
    struct edge {
        grid_point from, to;
        contour_edge source;
        [[nodiscard]] bool ends_in(grid_point p) const noexcept { return from == p || to == p; }
    };
    edge a, b;
    grid_point at;
};

/// Told of meetings: judge(m) is whether this one may stand. It is asked of all, also when one does not.
template <class J>
concept meeting_judge = requires(J& judge, const meeting& m) {
    { judge(m) } noexcept -> std::same_as<bool>;
};

/// The judge that lets all pass.
struct every_meeting_stands {
    constexpr bool operator()(const meeting&) const noexcept { return true; }
};

namespace detail {

[[nodiscard]] inline meeting::edge edge_of(const arrangement& a, std::uint32_t origin) noexcept
{
    stretch s{};
    s.origin = origin;
    const auto [from, to] = a.home(s);
    return {from, to, a.loops->edges[origin]};
}

/// Asks a judge about all meetings of a finished arrangement; false when there is no memory.
///
/// They are found where more than two stretches end. Where more than 16 edges come through one point all stand: nothing
/// there is made by chance, and the pairs would be many.
template <meeting_judge Judge>
[[nodiscard]] bool judge_meetings(const arrangement& a, workspace& space, Judge& judge, bool& all_stand) noexcept
{
    constexpr std::uint32_t most = 16;
    workspace::scope scratch{space};
    auto* const ends = scratch.take<std::uint32_t>(a.point_count);  // how many; then where the next is listed
    if (ends == nullptr) return false;
    for (std::uint32_t i = 0; i < a.point_count; ++i) ends[i] = 0;
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const stretch& s = a.stretches[i];
        if (s.turn == 0) continue;
        ++ends[s.start];
        ++ends[s.end];
    }
    std::uint32_t places = 0, total = 0;
    for (std::uint32_t i = 0; i < a.point_count; ++i) {
        if (ends[i] <= 2) continue;
        ++places;
        total += ends[i];
    }
    if (places == 0) return true;
    auto* const place = scratch.take<std::uint32_t>(places);
    auto* const origin = scratch.take<std::uint32_t>(total);
    if (place == nullptr || origin == nullptr) return false;
    places = total = 0;
    for (std::uint32_t i = 0; i < a.point_count; ++i) {
        const std::uint32_t count = ends[i];
        ends[i] = count > 2 ? total : no_number;
        if (count <= 2) continue;
        place[places++] = i;
        total += count;
    }
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const stretch& s = a.stretches[i];
        if (s.turn == 0) continue;
        if (ends[s.start] != no_number) origin[ends[s.start]++] = s.origin;
        if (ends[s.end] != no_number) origin[ends[s.end]++] = s.origin;
    }

    for (std::uint32_t k = 0, begin = 0; k < places; ++k) {
        const grid_point at = a.points[place[k]];
        std::uint32_t edges[most + 1], count = 0;
        for (; begin < ends[place[k]]; ++begin) {
            std::uint32_t i = 0;
            while (i < count && edges[i] != origin[begin]) ++i;
            if (i == count && count <= most) edges[count++] = origin[begin];
        }
        if (count > most) continue;
        for (std::uint32_t i = 1; i < count; ++i) {
            const meeting::edge e = edge_of(a, edges[i]);
            for (std::uint32_t j = 0; j < i; ++j) {
                const meeting m{e, edge_of(a, edges[j]), at};
                if (m.a.ends_in(at) && m.b.ends_in(at)) continue;
                if (!judge(m)) all_stand = false;
            }
        }
    }
    return true;
}

}  // namespace detail

}  // namespace typemesh

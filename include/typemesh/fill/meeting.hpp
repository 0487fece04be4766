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
    struct visit {
        std::uint32_t place, origin, before;
    };
    workspace::scope scratch{space};
    auto* const ends = scratch.take<std::uint32_t>(a.point_count);  // how many; beyond 2: 3 and the last visit's number
    auto* const two = scratch.take<std::uint32_t>(2 * std::size_t{a.point_count});  // who comes first and second
    auto* const more = scratch.take<visit>(2 * std::size_t{a.count});               // and who else
    auto* const crowd = scratch.take<std::uint8_t>(a.point_count);  // how many at least: most points are left here
    if (ends == nullptr || two == nullptr || more == nullptr || crowd == nullptr) return false;
    for (std::uint32_t i = 0; i < a.point_count; ++i) crowd[i] = 0;
    const auto counted = [&](std::uint32_t place) noexcept {
        crowd[place] = static_cast<std::uint8_t>(crowd[place] + (crowd[place] < 3));
        if (crowd[place] == 3) ends[place] = 0;
    };
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const stretch& s = a.stretches[i];
        if (s.turn == 0) continue;
        counted(s.start);
        counted(s.end);
    }
    std::uint32_t count = 0;
    const auto visited = [&](std::uint32_t place, std::uint32_t origin) noexcept {
        const std::uint32_t n = ends[place];
        if (n < 2) {
            two[2 * std::size_t{place} + n] = origin;
            ends[place] = n + 1;
        } else {
            more[count] = {place, origin, n};
            ends[place] = 3 + count++;
        }
    };
    for (std::uint32_t i = 0; i < a.count; ++i) {
        const stretch& s = a.stretches[i];
        if (s.turn == 0) continue;
        if (crowd[s.start] == 3) visited(s.start, s.origin);
        if (crowd[s.end] == 3) visited(s.end, s.origin);
    }

    for (std::uint32_t v = 0; v < count; ++v) {
        const std::uint32_t place = more[v].place;
        if (ends[place] != 3 + v) continue;  // a later visit will tell of all
        std::uint32_t edges[most + 1] = {two[2 * std::size_t{place}]}, size = 1;
        const auto add = [&](std::uint32_t origin) noexcept {
            std::uint32_t i = 0;
            while (i < size && edges[i] != origin) ++i;
            if (i == size && size <= most) edges[size++] = origin;
        };
        add(two[2 * std::size_t{place} + 1]);
        for (std::uint32_t k = 3 + v; k > 2; k = more[k - 3].before) add(more[k - 3].origin);
        if (size > most) continue;
        const grid_point at = a.points[place];
        for (std::uint32_t i = 1; i < size; ++i) {
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

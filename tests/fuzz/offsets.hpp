// SPDX-License-Identifier: MIT
#pragma once

#include "solids.hpp"
#include "support/emboldened.hpp"

#include <typemesh/extrude/outlined.hpp>

/// Closed polylines -> region -> bolder, thinner and hollow letters, extruded or bevelled.
namespace fuzz {

namespace offset_laws {

using namespace typemesh;
using namespace solid_laws;

/// A planned and written solid; none if its options, or the glyph, are refused.
template <class Extruder>
struct made_solid {
    plan_data_of<Extruder> data;
    solid_plan plan;
    mesh m;
    error failed;
    bool exists = false;

    broken_law make(const Extruder& how, drawn_region& from)
    {
        const auto planned = test::write_in_cells(how, from.made, from.caps, from.em, data, m);
        if (!planned) {
            const error e = failed = planned.error();
            const bool refused = e == error::bad_option || e == error::outline_beyond_grid ||
                                 e == error::nothing_left || e == error::edges_not_moved ||
                                 e == error::crossing_contours;
            return refused ? "" : e.message();
        }
        exists = true;
        plan = *planned;
        return of_mesh(m, how, from, plan.sizes);
    }
};

/// Places all over: a letter whose edges have moved by a distance, outwards if it is positive, contains everything
/// nearer than that, and nothing farther than the mitre limit lets corners reach.
inline broken_law of_places(const drawn_region& from, const std::vector<inspect::loop>& moved, double distance,
                            double limit)
{
    const auto before = inspect::loops_of(from.made);
    constexpr double all_joins = 1.0013;  // 31 joins turn a corner by half a turn: 1 / cos(180 degrees / 64)
    const double slack = 4.0 + 1e-6 * std::fabs(distance) + from.made.tolerance();
    const auto at = [&](std::int32_t low, std::int32_t high, int i) {
        const double margin = std::fabs(distance);
        const double v = double(low) - margin + (double(high) - low + 2.0 * margin) * i / 13.0;
        return static_cast<std::int32_t>((std::max)(-0x1p28, (std::min)(0x1p28, v)));
    };
    std::int32_t left = 1 << 29, right = -left, bottom = left, top = -left;
    for (const grid_point p : from.made.points()) {
        left = (std::min)(left, p.x), right = (std::max)(right, p.x);
        bottom = (std::min)(bottom, p.y), top = (std::max)(top, p.y);
    }
    for (int i = 0; i <= 13; ++i)
        for (int k = 0; k <= 13; ++k) {
            const grid_point p{at(left, right, i), at(bottom, top, k)};
            if (!(inspect::distance(moved, p) > slack) || !(inspect::distance(before, p) > 0.0)) continue;
            const double away = inspect::distance(before, p) * (inspect::winding(before, p) != 0 ? -1.0 : 1.0);
            const bool within = inspect::winding(moved, p) == 1;
            if (!within && inspect::winding(moved, p) != 0) return "a place is covered twice";
            // A bolder letter contains all places nearer than the distance. For a thinner one that is true of its outside.
            const double way = distance < 0.0 ? -away : away, far = std::fabs(distance);
            const bool reached = distance < 0.0 ? !within : within;
            if (way < far - slack && !reached) return "an edge has not moved as far as it should";
            if (limit > 0.0 && way > far * (std::max)(limit, all_joins) + slack && reached)
                return "an edge has moved farther than it should";
        }
    return {};
}

/// The volume is the moved area times the depth.
inline broken_law of_volume(const mesh& m, const std::vector<inspect::loop>& loops, double depth)
{
    const double area = 0.5 * static_cast<double>(inspect::doubled_area(loops)),
                 volume = inspect::measure(m.view()).volume;
    return std::fabs(volume - area * depth) <= 1e-5 * area * depth + 1e-3 * (1.0 + depth)
               ? ""
               : "the volume is not area times depth";
}

inline broken_law of_bolder(const test::emboldened<>& how, drawn_region& from)
{
    made_solid<test::emboldened<>> s;
    if (broken_law broken = s.make(how, from); !broken.empty() || !s.exists) return broken;
    const auto view = s.data.read();
    const auto loops = inspect::loops_of(view.points, view.starts);
    if (broken_law broken = test::oracle::broken_cycle(loops); !broken.empty()) return broken;
    const double distance = double(how.by) * from.em, depth = double(how.solid.depth) * from.em;
    if (from.is_small && distance < 0x1p17)
        if (broken_law broken = of_volume(s.m, loops, depth); !broken.empty()) return broken;
    if (s.plan.narrowed || std::fabs(distance) < 8.0 || how.joins != bevel_joins::round) return {};
    return of_places(from, loops, distance, double(how.mitre_limit));
}

/// Ring and letter lie beside each other, and together are the original letter and the ring around it.
inline broken_law of_hollow(const outlined<extruded<>, extruded<>>& how, drawn_region& from)
{
    made_solid<outlined<extruded<>, extruded<>>> s;
    if (broken_law broken = s.make(how, from); !broken.empty() || !s.exists) return broken;
    const auto view = s.data.read();
    const auto ring = inspect::loops_of(view.ring.points, view.ring.starts),
               letter = inspect::loops_of(view.letter.points, view.letter.starts);
    for (const auto* loops : {&ring, &letter})
        if (broken_law broken = test::oracle::broken_cycle(*loops); !broken.empty()) return broken;
    if (how.place != outline_place::inner) return {};
    const auto both = inspect::doubled_area(ring) + inspect::doubled_area(letter),
               whole = inspect::doubled_area(inspect::loops_of(from.made));
    return both == whole ? "" : "ring and letter are not the letter";
}

template <class Extruder>
broken_law of_any(const Extruder& how, drawn_region& from)
{
    made_solid<Extruder> s;
    return s.make(how, from);
}

}  // namespace offset_laws

inline broken_law offsets(values in)
{
    using namespace typemesh;
    using namespace offset_laws;
    static constexpr float widths[] = {0.0f, 1e-5f, 0.001f, 0.005f, 0.02f, 0.05f, 0.1f, 0.3f, 1.0f};
    const std::uint32_t bits = in.byte();
    const float width = in.one_of(widths) * float(in.between(0.5, 1.5));
    const auto joins = (bits & 8) != 0 ? bevel_joins::bevelled : bevel_joins::round;
    const float limit = in.one_of({0.0f, 1.0f, 1.5f, 2.0f, 4.0f, 100.0f});
    const float by = (bits & 16) != 0 ? 0.0f - width : width;
    const auto place = static_cast<outline_place>((bits >> 5) % 3);
    const bevelled bevel = read_bevel(in, bits >> 5);
    drawn_region from;
    if (broken_law broken = from.fill(in); !broken.empty()) return broken;
    if (from.made.points().empty()) return {};
    switch (bits & 7) {
    case 0:
    case 1:
    case 2: return of_bolder({.by = by, .joins = joins, .mitre_limit = limit}, from);
    case 3:
    case 4: return of_hollow({.width = width, .place = place, .joins = joins, .mitre_limit = limit}, from);
    case 5:
        return of_any(
            outlined<bevelled>{.width = width, .place = place, .joins = joins, .mitre_limit = limit, .ring = bevel},
            from);
    default:
        return of_any(test::emboldened<bevelled>{.by = by, .joins = joins, .mitre_limit = limit, .solid = bevel}, from);
    }
}

}  // namespace fuzz

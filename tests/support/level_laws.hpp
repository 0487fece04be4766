// SPDX-License-Identifier: MIT
#pragma once

// Laws of levels of detail: loops that have lost points within runs of one curve.

#include <typemesh/core/contours.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/inspect/simplicity.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace test {

/// Loops with memory of their own.
using loop_points = std::vector<std::vector<typemesh::grid_point>>;

/// The loops of a region or of contours.
template <class Points, class Starts>
loop_points loops_with(const Points& points, const Starts& starts)
{
    loop_points all;
    for (std::size_t k = 0; k + 1 < starts.size(); ++k)
        all.emplace_back(points.begin() + starts[k], points.begin() + starts[k + 1]);
    return all;
}

/// Whether a loop is another one without some of its points.
inline bool is_thinned(const std::vector<typemesh::grid_point>& some, std::vector<typemesh::grid_point> all)
{
    for (std::size_t turn = 0; turn < all.size(); ++turn, std::rotate(all.begin(), all.begin() + 1, all.end())) {
        if (!(all[0] == some[0])) continue;
        std::size_t found = 0;
        for (std::size_t i = 0; i < all.size() && found < some.size(); ++i) found += all[i] == some[found];
        if (found == some.size()) return true;
    }
    return false;
}

/// Whether the loops are those of the finer level, in any order, each without some of its points.
inline bool is_nested_in(const loop_points& coarse, const loop_points& fine)
{
    return coarse.size() == fine.size() && std::all_of(coarse.begin(), coarse.end(), [&](const auto& some) {
               return some.size() >= 3 &&
                      std::any_of(fine.begin(), fine.end(), [&](const auto& all) { return is_thinned(some, all); });
           });
}

/// Whether loops bound a region without touching: see inspect::is_region().
inline bool bound_a_region(const loop_points& loops)
{
    std::vector<typemesh::inspect::loop> views;
    for (const auto& l : loops) views.emplace_back(l.data(), l.size());
    return typemesh::inspect::is_region(views);
}

/// The edges of loops, by their ends.
using edge_set = std::set<std::pair<std::uint64_t, std::uint64_t>>;
inline edge_set edges_in(const loop_points& loops)
{
    edge_set all;
    for (const auto& l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) all.emplace(l[i].word(), l[(i + 1) % l.size()].word());
    return all;
}

/// The greatest distance of a place of a curve from the edge that stands for it, in cells, without the edges of the
/// finest level: where contours cross, the parameters of these may be far off.
template <class Edges>
double farthest_curve_place(const loop_points& loops, const Edges& edges,
                            typemesh::array_view<const typemesh::curve> curves, double cells,
                            const edge_set& finest = {})
{
    double farthest = 0.0;
    std::size_t next = 0;
    for (const auto& l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) {
            const typemesh::grid_point p = l[i], q = l[(i + 1) % l.size()];
            const typemesh::contour_edge e = edges[next++];
            if (finest.count({p.word(), q.word()}) != 0) continue;
            for (int k = 1; k < 8; ++k) {
                const double t = double{e.t0} + k / 8.0 * (double{e.t1} - double{e.t0});
                farthest = (std::max)(farthest, typemesh::inspect::curve_chords::squared_distance(
                                                    cells * curves[e.curve].at(t), {double(p.x), double(p.y)},
                                                    {double(q.x), double(q.y)}));
            }
        }
    return std::sqrt(farthest);
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

// CGAL's interior straight skeleton (GPL), to compare offsets with: its faces cut at a distance. Only the programs
// every_offset and bench_offset include this, on demand.
//
// Its own two answers differ now and then: the level sets of the faces are the ones to compare with. It gives none for
// some outlines, and does not come to an end on others.

#include <typemesh/core/region.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <utility>
#include <vector>

namespace test {

class skeleton_peer {
    using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using polygon = CGAL::Polygon_2<kernel>;

    struct place {
        double x = 0, y = 0;
    };
    struct face {
        place origin, along;  // of its edge
        std::vector<place> ring;
    };

public:
    /// Builds the skeletons of all outer loops; false when CGAL gives none. No two loops may touch.
    [[nodiscard]] bool build(const typemesh::region& r)
    {
        faces_.clear();
        seconds_ = 0.0;
        const auto loops = typemesh::inspect::loops_of(r);
        const auto polygon_of = [](typemesh::inspect::loop l) {
            polygon p;
            for (const auto q : l) p.push_back({double(q.x), double(q.y)});
            return p;
        };
        for (std::size_t l = 0; l < loops.size(); ++l) {
            if (typemesh::inspect::doubled_area(loops[l]) < 0) continue;
            CGAL::Polygon_with_holes_2<kernel> outer{polygon_of(loops[l])};
            for (std::size_t h = 0; h < loops.size(); ++h)
                if (typemesh::inspect::doubled_area(loops[h]) < 0 && outer_of(loops, h) == l)
                    outer.add_hole(polygon_of(loops[h]));
            const std::clock_t start = std::clock();
            const auto skeleton = CGAL::create_interior_straight_skeleton_2(outer, kernel{});
            seconds_ += double(std::clock() - start) / CLOCKS_PER_SEC;
            if (!skeleton) return false;
            for (auto f = skeleton->faces_begin(); f != skeleton->faces_end(); ++f) add_face(f->halfedge());
        }
        return true;
    }

    /// The processor's time that the skeletons took.
    [[nodiscard]] double seconds() const { return seconds_; }

    /// What of each face is farther than `distance` from its edge, on the grid.
    [[nodiscard]] std::vector<std::vector<typemesh::grid_point>> beyond(double distance) const
    {
        std::vector<std::vector<typemesh::grid_point>> all;
        for (const face& f : faces_) {
            std::vector<typemesh::grid_point> kept;
            const auto keep = [&](double x, double y) {
                kept.push_back({static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))});
            };
            const auto height = [&](place p) {
                return f.along.x * (p.y - f.origin.y) - f.along.y * (p.x - f.origin.x) - distance;
            };
            for (std::size_t i = 0; i < f.ring.size(); ++i) {
                const place p = f.ring[i], q = f.ring[(i + 1) % f.ring.size()];
                const double hp = height(p), hq = height(q), s = hp / (hp - hq);
                if (hp >= 0) keep(p.x, p.y);
                if ((hp >= 0) != (hq >= 0)) keep(p.x + s * (q.x - p.x), p.y + s * (q.y - p.y));
            }
            if (kept.size() > 2) all.push_back(std::move(kept));
        }
        return all;
    }

private:
    /// The smallest outer loop around a hole.
    [[nodiscard]] static std::size_t outer_of(const std::vector<typemesh::inspect::loop>& loops, std::size_t hole)
    {
        namespace inspect = typemesh::inspect;
        std::size_t best = loops.size();
        for (std::size_t l = 0; l < loops.size(); ++l)
            if (inspect::doubled_area(loops[l]) > 0 && inspect::winding(loops[l], loops[hole][0]) != 0 &&
                (best == loops.size() || inspect::doubled_area(loops[l]) < inspect::doubled_area(loops[best])))
                best = l;
        return best;
    }

    template <class Halfedge>
    void add_face(Halfedge h)
    {
        while (h->is_bisector()) h = h->next();
        const auto first = h;
        const auto a = h->opposite()->vertex()->point(), b = h->vertex()->point();
        const double length = std::hypot(b.x() - a.x(), b.y() - a.y());
        face made{{a.x(), a.y()}, {(b.x() - a.x()) / length, (b.y() - a.y()) / length}, {}};
        do {
            made.ring.push_back({h->vertex()->point().x(), h->vertex()->point().y()});
            h = h->next();
        } while (h != first);
        faces_.push_back(std::move(made));
    }

    std::vector<face> faces_;
    double seconds_ = 0.0;
};

}  // namespace test

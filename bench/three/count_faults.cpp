// SPDX-License-Identifier: MIT
//
// Counts, exactly, what is wrong with each of some meshes: triangles that meet where they share neither corner nor edge, or
// beyond what they share; edges that are not run through as often in one direction as in the other; triangles of faces and
// bevels that look to the wrong side. Points at one place are one.
//
//     count_faults FILE.obj...

#include "obj_triangles.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using corners = std::array<std::size_t, 3>;

struct faults {
    std::size_t triangles = 0, crossings = 0, open_edges = 0, turned_over = 0;
};

class counter {
public:
    explicit counter(const three::obj_triangles& mesh)
    {
        std::map<std::array<float, 3>, std::size_t> known;
        std::vector<std::size_t> welded;
        for (const std::array<float, 3>& p : mesh.points) {
            const auto [it, is_new] = known.try_emplace(p, points_.size());
            if (is_new) points_.emplace_back(p[0], p[1], p[2]);
            welded.push_back(it->second);
        }
        for (const three::obj_triangles::triangle& t : mesh.triangles) {
            const corners c{welded[t.corners[0]], welded[t.corners[1]], welded[t.corners[2]]};
            for (std::size_t i = 0, j = 2; i < 3; j = i++)
                if (c[i] != c[j]) balance_[std::minmax(c[i], c[j])] += c[i] < c[j] ? 1 : -1;
            if (CGAL::collinear(points_[c[0]], points_[c[1]], points_[c[2]])) continue;
            triangles_.push_back(c);
            const CGAL::Orientation turn = CGAL::orientation(flat(c[0]), flat(c[1]), flat(c[2]));
            if (t.part.starts_with("front") && turn == CGAL::RIGHT_TURN) ++found_.turned_over;
            if (t.part.starts_with("back") && turn == CGAL::LEFT_TURN) ++found_.turned_over;
        }
        found_.triangles = triangles_.size();
    }

    faults count()
    {
        for (const auto& [edge, more] : balance_) found_.open_edges += static_cast<std::size_t>(std::labs(more));

        using box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, corners>;
        std::vector<box> boxes;
        for (const corners& t : triangles_) boxes.emplace_back(solid(t).bbox(), t);
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const box& a, const box& b) {
            if (meet_beyond_what_they_share(a.info(), b.info())) ++found_.crossings;
        });
        return found_;
    }

private:
    kernel::Point_2 flat(std::size_t i) const { return {points_[i].x(), points_[i].y()}; }
    kernel::Triangle_3 solid(const corners& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }

    bool meet_beyond_what_they_share(corners a, corners b) const
    {
        const std::size_t shared = shared_first(a, b);
        if (shared == 0) return CGAL::do_intersect(solid(a), solid(b));
        if (shared == 1)
            return CGAL::do_intersect(kernel::Segment_3(points_[a[1]], points_[a[2]]), solid(b)) ||
                   CGAL::do_intersect(kernel::Segment_3(points_[b[1]], points_[b[2]]), solid(a));
        if (shared == 3) return true;
        const kernel::Point_3 &p = points_[a[0]], &q = points_[a[1]], &r = points_[a[2]], &s = points_[b[2]];
        return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }

    /// Puts the corners that both have first, in the same order, and says how many.
    static std::size_t shared_first(corners& a, corners& b)
    {
        std::size_t shared = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = shared; j < 3; ++j) {
                if (a[i] != b[j]) continue;
                std::swap(a[i], a[shared]);
                std::swap(b[j], b[shared]);
                ++shared;
                break;
            }
        }
        return shared;
    }

    std::vector<kernel::Point_3> points_;
    std::vector<corners> triangles_;                               ///< those with an area
    std::map<std::pair<std::size_t, std::size_t>, long> balance_;  ///< of an edge's two directions
    faults found_;
};

}  // namespace

int main(int argc, char** argv)
{
    faults all;
    int faulty = 0;
    for (int i = 1; i < argc; ++i) {
        const faults one = counter(three::obj_triangles(argv[i])).count();
        faulty += one.crossings + one.open_edges + one.turned_over > 0 ? 1 : 0;
        all.triangles += one.triangles;
        all.crossings += one.crossings;
        all.open_edges += one.open_edges;
        all.turned_over += one.turned_over;
    }
    std::printf("%d of %d meshes have faults; %zu triangles, %zu pairs cross, %zu edges open, %zu turned over\n",
                faulty, argc - 1, all.triangles, all.crossings, all.open_edges, all.turned_over);
}

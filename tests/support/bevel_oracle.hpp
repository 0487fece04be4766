// SPDX-License-Identifier: MIT
#pragma once

// The volume and heights that a bevel must have, found without the code that makes it.

#include "support/bevel_surface.hpp"
#include "support/slow_wavefront.hpp"

#include <typemesh/core/region.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test {

/// A rising profile: t as a share of the width, and h as a share of the bevel's depth.
struct plain_profile {
    std::vector<std::pair<double, double>> points;

    [[nodiscard]] static plain_profile chamfer() { return {{{0.0, 0.0}, {1.0, 1.0}}}; }
    [[nodiscard]] static plain_profile round(int steps)
    {
        plain_profile made;
        for (int i = 0; i <= steps; ++i) {
            const double angle = std::acos(0.0) * i / steps;
            made.points.emplace_back(1.0 - std::cos(angle), std::sin(angle));
        }
        return made;
    }

    [[nodiscard]] double height(double t) const
    {
        std::size_t k = 1;
        while (k + 1 < points.size() && points[k].first < t) ++k;
        const auto [t0, h0] = points[k - 1];
        const auto [t1, h1] = points[k];
        return h0 + (h1 - h0) * (t - t0) / (t1 - t0);
    }
    [[nodiscard]] double distance(double h) const
    {
        std::size_t k = 1;
        while (k + 1 < points.size() && points[k].second < h) ++k;
        const auto [t0, h0] = points[k - 1];
        const auto [t1, h1] = points[k];
        return t0 + (t1 - t0) * (h - h0) / (h1 - h0);
    }
    /// The rise over the run at t, both as shares.
    [[nodiscard]] double slope(double t) const
    {
        std::size_t k = 1;
        while (k + 1 < points.size() && points[k].first < t) ++k;
        return (points[k].second - points[k - 1].second) / (points[k].first - points[k - 1].first);
    }
};

/// What the slow wavefront leaves of a region on its way to a width, in cells.
class bevel_oracle {
public:
    struct place {
        double x, y;
        double distance;  ///< of the wavefront when it was here
    };

    /// Stops where these profiles bend. Corners get the joins that they need at `joins_at`: the width, or the width that a
    /// narrowed bevel should have had.
    bevel_oracle(const typemesh::region& r, double width, double joins_at, double mitre_limit,
                 const std::vector<const plain_profile*>& profiles)
        : width_{width}
    {
        namespace inspect = typemesh::inspect;
        std::vector<std::vector<typemesh::grid_point>> given;
        for (const inspect::loop l : inspect::loops_of(r)) given.emplace_back(l.begin(), l.end());
        std::vector<double> stops{0.15, 0.45, 0.8};
        const std::vector<double> seen = stops;
        for (const plain_profile* p : profiles)
            for (const auto& point : p->points) stops.push_back(point.first);
        std::sort(stops.begin(), stops.end());
        slow_wavefront front{given, {mitre_limit, r.tolerance(), joins_at}};
        for (const double t : stops) {
            front.advance(t * width);
            swept_.emplace_back(t, static_cast<double>(front.swept_volume()));
            if (std::find(seen.begin(), seen.end(), t) != seen.end()) look_at(front, t * width);
        }
        cap_area_ = static_cast<double>(front.area());
        is_doubtful_ = front.is_doubtful();
    }

    [[nodiscard]] bool is_doubtful() const { return is_doubtful_; }
    [[nodiscard]] double cap_area() const { return cap_area_; }
    /// Some places on its way, in the middle of its edges.
    [[nodiscard]] const std::vector<place>& places() const { return places_; }

    /// The volume of a bevel with one of the profiles, from the wall to the cap: the integral of the levels' areas.
    [[nodiscard]] double volume(const plain_profile& p, double depth) const
    {
        double sum = 0.0;
        for (std::size_t k = 1; k < p.points.size(); ++k) {
            const auto [t0, h0] = p.points[k - 1];
            const auto [t1, h1] = p.points[k];
            sum += (h1 - h0) * depth * (swept_to(t1) - swept_to(t0)) / ((t1 - t0) * width_);
        }
        return sum;
    }

private:
    [[nodiscard]] double swept_to(double t) const
    {
        return std::lower_bound(swept_.begin(), swept_.end(), std::pair{t, -1.0})->second;
    }

    void look_at(const slow_wavefront& front, double distance)
    {
        constexpr std::size_t most = 24;
        constexpr double shortest = 32.0;  // cells
        std::vector<place> all;
        for (const auto& l : front.loops()) {
            for (std::size_t i = 0; i < l.size(); ++i) {
                const real_point a = l[i], b = l[(i + 1) % l.size()];
                if (length(b - a) < shortest) continue;
                all.push_back({static_cast<double>((a.x + b.x) / 2), static_cast<double>((a.y + b.y) / 2), distance});
            }
        }
        for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / most) places_.push_back(all[i]);
    }

    double width_;
    std::vector<std::pair<double, double>> swept_;  // t; the integral of the area up to it
    std::vector<place> places_;
    double cap_area_ = 0.0;
    bool is_doubtful_ = false;
};

/// The height of a mesh's front bevel over a place, in a triangle at least 3 cells wide there. Nodes are rounded by up to
/// two cells, so narrower triangles may lean anywhere. False if there is none.
[[nodiscard]] inline bool height_over(const bevel_surface& s, double x, double y, double& height)
{
    const auto all = s.triangles_of(typemesh::part::front_bevel);
    for (std::size_t t = all.begin; t < all.end; ++t) {
        const auto a = s.corner(t, 0), b = s.corner(t, 1), c = s.corner(t, 2);
        if ((a.x < x && b.x < x && c.x < x) || (a.x > x && b.x > x && c.x > x) || (a.y < y && b.y < y && c.y < y) ||
            (a.y > y && b.y > y && c.y > y))
            continue;
        const auto left_of = [&](const auto& p, const auto& q) {
            return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        };
        const double of_a = left_of(b, c), of_b = left_of(c, a), of_c = left_of(a, b), area = of_a + of_b + of_c;
        if (of_a < 0.0 || of_b < 0.0 || of_c < 0.0) continue;
        const double longest = (std::max)(
            {std::hypot(b.x - a.x, b.y - a.y), std::hypot(c.x - b.x, c.y - b.y), std::hypot(a.x - c.x, a.y - c.y)});
        if (!(area > 3.0 * longest)) continue;
        height = (of_a * a.z + of_b * b.z + of_c * c.z) / area;
        return true;
    }
    return false;
}

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

// Distances from an outline, and the laws of ridges, by brute force.

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/offset/find_ridges.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// The edges of a region's outline.
class plain_outline {
public:
    struct foot {
        double distance, x, y;
    };

    explicit plain_outline(const typemesh::region& r)
    {
        for (std::uint32_t k = 0; k < r.loop_count(); ++k)
            for (std::uint32_t i = r.starts()[k], end = r.starts()[k + 1]; i < end; ++i) {
                const auto a = r.points()[i], b = r.points()[i + 1 == end ? r.starts()[k] : i + 1];
                edges_.push_back({double(a.x), double(a.y), double(b.x), double(b.y)});
                const auto before = r.points()[i == r.starts()[k] ? end - 1 : i - 1];
                if (typemesh::orientation(before, a, b) > 0) convex_.insert({a.x, a.y});
            }
    }

    /// The distance of a point from the nearest edge.
    [[nodiscard]] double distance(double x, double y) const
    {
        double best = 1e300;
        for (const edge& e : edges_) best = (std::min)(best, foot_on(e, x, y).distance);
        return best;
    }
    /// Whether two different points of the outline are this near.
    [[nodiscard]] bool has_two_feet(double x, double y, double near_enough) const
    {
        std::vector<foot> found;
        for (const edge& e : edges_) {
            const foot f = foot_on(e, x, y);
            if (f.distance > near_enough) continue;
            for (const foot& other : found)
                if (std::hypot(other.x - f.x, other.y - f.y) > 0.5) return true;
            found.push_back(f);
        }
        return false;
    }
    [[nodiscard]] bool is_convex_corner(typemesh::grid_point p) const { return convex_.count({p.x, p.y}) != 0; }

private:
    struct edge {
        double ax, ay, bx, by;
    };
    static foot foot_on(const edge& e, double px, double py)
    {
        const double x = e.bx - e.ax, y = e.by - e.ay;
        const double t = ((px - e.ax) * x + (py - e.ay) * y) / (x * x + y * y), on = (std::clamp)(t, 0.0, 1.0);
        const double fx = e.ax + on * x, fy = e.ay + on * y;
        return {std::hypot(px - fx, py - fy), fx, fy};
    }

    std::vector<edge> edges_;
    std::set<std::pair<std::int32_t, std::int32_t>> convex_;
};

/// Checks the ridges of a region.
///
///     tolerance    of the round joins, in cells
///     floor        the distance of the floor's outlines, in cells; 0: there are none
class ridge_laws {
public:
    static constexpr double slack = 4.0;  ///< cells

    std::size_t points = 0, lines = 0, lone = 0, valleys = 0, closed = 0;
    std::size_t soft_ends = 0;  ///< ends inside the region with no other line
    double too_deep = 0.0;      ///< the worst, in cells: deeper than the distance
    double too_shallow = 0.0;   ///< the worst, in cells: shallower by so much more than the tolerance

    ridge_laws(const typemesh::region& r, typemesh::array_view<const typemesh::ridge_point> all, double tolerance,
               double floor)
        : outline_{r}, tolerance_{tolerance}, floor_{floor}
    {
        using namespace typemesh;
        for (std::size_t i = 0; i < all.size();) {
            std::size_t end = i + 1;
            while (end < all.size() && all[end].step == ridge_step::on) ++end;
            law(all[i].step != ridge_step::on, "the first point begins nothing");
            take(all.subspan(i, end - i), all[i].step == ridge_step::floor);
            i = end;
        }
        check_ends();
        const long want = long(r.outers()) - long(r.holes());
        if (euler() != want)
            law(false, "the ridges are not connected as the region is: " + std::to_string(euler()) + " instead of " +
                           std::to_string(want));
    }

    /// The first law that is broken, in words, or "".
    [[nodiscard]] const std::string& broken() const { return broken_; }

    /// Points less lines, with the areas of the floor as points: 1 for each component without a hole, and so on. Where
    /// lines begin at the outline, each has a point of its own.
    [[nodiscard]] long euler() const { return own_ends_ + long(places_.size()) - long(segments_.size()) + caps_; }

private:
    using place = std::pair<std::int32_t, std::int32_t>;
    static place at(const typemesh::ridge_point& p) { return {p.at.x, p.at.y}; }

    void law(bool holds, const std::string& sentence)
    {
        if (!holds && broken_.empty()) broken_ = sentence;
    }

    void take(typemesh::array_view<const typemesh::ridge_point> line, bool is_floor)
    {
        using namespace typemesh;
        ++lines;
        lone += line.size() == 1;
        for (const ridge_point& p : line) check(p);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const place a = at(line[i]), b = at(line[i + 1]);
            law(segments_.insert(a < b ? std::pair{a, b} : std::pair{b, a}).second, "a line is written twice");
            if (is_floor) floor_places_.insert(a);
            if (!is_floor) count_valley(line[i], line[i + 1]);
        }
        if (is_floor) {
            law(line.size() > 3 && line[0].at == line.back().at, "an outline of the floor is not closed");
            double area = 0.0;
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                area += double(line[i].at.x) * line[i + 1].at.y - double(line[i].at.y) * line[i + 1].at.x;
            caps_ += area > 0.0 ? 1 : -1;
            return;
        }
        if (line.size() > 1 && line[0].at == line.back().at && line[0].distance > 0.0f) ++closed;
        if (line.size() == 1) return;
        ++ends_[at(line[0])];
        ++ends_[at(line.back())];
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            law(!is_corner(line[i]), "a line goes on across the outline");
            inner_.insert(at(line[i]));
        }
    }
    [[nodiscard]] static bool is_corner(const typemesh::ridge_point& p) { return !(p.distance > 0.0f); }

    void check(const typemesh::ridge_point& p)
    {
        ++points;
        if (is_corner(p)) {
            ++own_ends_;
            law(outline_.is_convex_corner(p.at), "a ridge begins on the outline where no convex corner is");
            return;
        }
        places_.insert(at(p));
        const double x = p.at.x, y = p.at.y, away = outline_.distance(x, y);
        const double depth = double(p.distance), right = floor_ > 0.0 ? (std::min)(away, floor_) : away;
        too_deep = (std::max)(too_deep, depth - right);
        too_shallow = (std::max)(too_shallow, right - depth - tolerance_);
        law(depth <= right + slack, "a ridge is deeper than the distance to the outline");
        law(depth >= right - tolerance_ - slack, "a ridge is shallower than the distance to the outline");
        law(floor_ <= 0.0 || depth <= floor_ * (1.0 + 1e-6), "a ridge is deeper than the floor");
        if (away < floor_ - slack || floor_ <= 0.0)
            law(outline_.has_two_feet(x, y, away + 2.0 * tolerance_ + 2.0 * slack),
                "a ridge has one nearest edge only");
    }

    /// Whether the surface rises beside the middle of a line, instead of falling.
    void count_valley(const typemesh::ridge_point& a, const typemesh::ridge_point& b)
    {
        const double x = double(b.at.x) - a.at.x, y = double(b.at.y) - a.at.y, size = std::hypot(x, y);
        const double mx = 0.5 * (double(a.at.x) + b.at.x), my = 0.5 * (double(a.at.y) + b.at.y);
        const double away = outline_.distance(mx, my), step = 0.1 * away;
        if (size < 64.0 || step < 64.0) return;
        for (const double side : {-step, step})
            if (outline_.distance(mx - side * y / size, my + side * x / size) > away + tolerance_ + slack) ++valleys;
    }

    void check_ends()
    {
        for (const auto& [p, count] : ends_) {
            if (outline_.is_convex_corner({p.first, p.second})) continue;
            law(inner_.count(p) == 0, "a line passes through the end of another");
            if (floor_places_.count(p) != 0 || count >= 3) continue;
            law(count != 2 || closed != 0, "a line ends where one other begins");
            soft_ends += count == 1;
        }
    }

    plain_outline outline_;
    double tolerance_, floor_;
    std::set<place> places_, floor_places_, inner_;
    std::set<std::pair<place, place>> segments_;
    std::map<place, int> ends_;
    long own_ends_ = 0, caps_ = 0;
    std::string broken_;
};

}  // namespace test

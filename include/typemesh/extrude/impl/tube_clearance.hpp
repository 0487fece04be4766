// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/impl/box_tree.hpp>
#include <typemesh/extrude/impl/half_turn_tangent.hpp>
#include <typemesh/extrude/impl/path_pairs.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Polylines on the grid, like contours; neighbouring points are distinct. `open` says of each whether it is open;
/// if `open` is empty, all are closed.
struct tube_paths {
    array_view<const grid_point> points;
    array_view<const std::uint32_t> starts;
    array_view<const std::uint8_t> open = {};

    [[nodiscard]] std::size_t count() const noexcept { return starts.empty() ? 0 : starts.size() - 1; }
    [[nodiscard]] bool is_open(std::size_t k) const noexcept { return k < open.size() && open[k] != 0; }
};

/// A radius in cells as one in em that is not larger; 0 if it is less than four cells. `wanted` is the option, in em.
[[nodiscard]] inline float tube_radius(double cells, double em, float wanted) noexcept
{
    if (!(cells >= 4.0)) return 0.0f;
    if (cells >= as_double(wanted) * em) return wanted;
    const float nearest = static_cast<float>(cells / em);
    return as_double(nearest) * em <= cells ? nearest : std::nextafter(nearest, 0.0f);
}

/// Finds how thick the tube along each of several paths may be.
///
///         right side                The strip of an edge lies between the mitres at its ends. Seen from above, a tube
///     ---------------.              is the union of its strips. So tubes do not meet as long as no strip is turned
///       edge        / mitre         inside out, and no corner of a strip enters another strip:
///     -------.     /
///     left    \                     edge     radius * (lean at the end - lean at the start) along the edge stays below
///     side     |                             the edge's length, and each of both alone does
///                                   corner   moves along a line while the radius grows, and so does the side of the
///                                            other strip; both are linear, so the radius where they meet is a quotient
///
/// These are the events of the straight skeleton, on both sides of the paths at once. At an open end the strip reaches
/// one radius beyond the end. Two paths that meet are not kept apart from each other, but from all others; a path that
/// meets itself is not kept apart from itself.
///
/// Cost   O(n log n), and O(log m) for each corner near a strip, if m pairs of paths meet; O(n^2 log n) at worst.
///        Memory O(n + m)
class tube_clearance {
public:
    /// What a radius is multiplied with if it is at its limit, so that the tubes keep a gap that floats can express.
    static constexpr double kept = 63.0 / 64.0;

    explicit tube_clearance(memory source = heap()) noexcept
        : leans_{source},
          radii_{source},
          meets_{source},
          pairs_{source},
          strips_{source},
          corners_{source},
          tree_{source}
    {
    }

    /// Finds the radii, in cells; none is larger than `radius`. Fails with error::out_of_memory.
    [[nodiscard]] error find(const tube_paths& paths, double radius) noexcept
    {
        leans_.clear();
        radii_.clear();
        meets_.clear();
        strips_.clear();
        corners_.clear();
        if (!trace(paths, radius) || !plant()) return error::out_of_memory;
        if (!find_meetings()) return error::out_of_memory;
        return keep_apart(true) && plant() && keep_apart(false) ? error{} : error{error::out_of_memory};
    }

    /// For each point: the way of the right corner of its mitre while the radius grows by 1.
    [[nodiscard]] array_view<const point> leans() const noexcept { return leans_.view(); }
    /// For each path.
    [[nodiscard]] array_view<const double> radii() const noexcept { return radii_.view(); }
    /// Whether a path crosses or touches another one, or itself.
    [[nodiscard]] bool meets(std::size_t path) const noexcept { return meets_[path] != 0; }
    /// The pairs of paths that cross or touch.
    [[nodiscard]] const path_pairs& meetings() const noexcept { return pairs_; }

private:
    /// The strip of an edge; or, with one side, the end of an open path, whose edge lies across the path.
    struct strip {
        grid_point a, b;
        point along;  // of unit length
        double length;
        double shift[2];  // of its ends, along it, on its right side, while the radius grows by 1
        bool open[2];
        bool one_side;
        std::uint32_t path;
        std::uint32_t joint[2];
    };
    /// A corner of strips, on the right, and if it has two sides, on the left.
    struct corner {
        grid_point at;
        point lean;
        bool one_side;
        std::uint32_t path, joint;
    };

    [[nodiscard]] bool trace(const tube_paths& paths, double radius) noexcept
    {
        for (std::size_t k = 0; k < paths.count(); ++k) {
            const std::uint32_t first = paths.starts[k], count = paths.starts[k + 1] - first;
            const std::size_t first_strip = strips_.size();
            if (!radii_.push_back(radius) || !meets_.push_back(0)) return false;
            const bool open = paths.is_open(k);
            if (!add_edges(paths, k, first, open ? count - 1 : count) || !add_joints(first, count, first_strip, open))
                return false;
            if (open && (!add_end(first_strip, 0) || !add_end(first_strip + count - 2, 1))) return false;
            limit(first_strip);
        }
        return true;
    }

    [[nodiscard]] bool add_edges(const tube_paths& paths, std::size_t path, std::uint32_t first,
                                 std::uint32_t edges) noexcept
    {
        const std::uint32_t end = paths.starts[path + 1];
        for (std::uint32_t i = first; i < first + edges; ++i) {
            const std::uint32_t next = i + 1 == end ? first : i + 1;
            strip s{};
            s.a = paths.points[i];
            s.b = paths.points[next];
            s.path = static_cast<std::uint32_t>(path);
            s.length = length(delta(s.a, s.b));
            s.along = (1.0 / s.length) * delta(s.a, s.b);
            s.joint[0] = i;
            s.joint[1] = next;
            if (!strips_.push_back(s)) return false;
        }
        return true;
    }

    /// The mitres at the points of a path, whose strips exist.
    [[nodiscard]] bool add_joints(std::uint32_t first, std::uint32_t count, std::size_t first_strip, bool open) noexcept
    {
        for (std::uint32_t i = 0; i < count; ++i) {
            strip* const before = open && i == 0 ? nullptr : &strips_[first_strip + (i == 0 ? count : i) - 1];
            strip* const after = open && i + 1 == count ? nullptr : &strips_[first_strip + i];
            const bool is_end = before == nullptr || after == nullptr;
            const strip &in = *(before != nullptr ? before : after), &out = *(after != nullptr ? after : before);
            const double turn = is_end ? 0.0 : half_turn_tangent(in.a, out.a, out.b);
            const bool returns = turn >= turned_back;
            const point lean =
                returns ? point{} : 0.5 * (outward(in.along) + outward(out.along) + turn * (in.along - out.along));
            if (before != nullptr) before->shift[1] = turn;
            if (after != nullptr) after->shift[0] = returns ? turn : -turn;
            if (!leans_.push_back(lean)) return false;
            if (is_end) continue;
            if (!corners_.push_back({after->a, lean, false, after->path, first + i})) return false;
        }
        return true;
    }

    /// The end of an open path: side 0 of its first strip or side 1 of its last one.
    [[nodiscard]] bool add_end(std::size_t of, int side) noexcept
    {
        strips_[of].open[side] = true;
        const strip s = strips_[of];
        const point away = side == 0 ? -1.0 * s.along : s.along, right = outward(away);
        const grid_point at = side == 0 ? s.a : s.b;
        const std::uint32_t joint = s.joint[side];
        const strip end{at, at, -1.0 * right, 0.0, {0.0, 0.0}, {true, true}, true, s.path, {joint, joint}};
        return strips_.push_back(end) && corners_.push_back({at, away + right, true, s.path, joint}) &&
               corners_.push_back({at, away - right, true, s.path, joint});
    }

    /// Reduces the radius of the last path so that none of its strips is turned inside out.
    void limit(std::size_t first_strip) noexcept
    {
        double& radius = radii_.back();
        for (std::size_t i = first_strip; i < strips_.size(); ++i) {
            const strip& s = strips_[i];
            const double a = std::fabs(s.shift[0]), b = std::fabs(s.shift[1]), sum = std::fabs(s.shift[1] - s.shift[0]);
            const double largest = a > b ? (a > sum ? a : sum) : (b > sum ? b : sum);
            if (largest * radius > kept * s.length) radius = kept * s.length / largest;
        }
    }

    [[nodiscard]] static std::int32_t in_range(double v) noexcept
    {
        constexpr double far_away = 0x1p30;
        return static_cast<std::int32_t>(v < -far_away ? -far_away : v > far_away ? far_away : v);
    }
    [[nodiscard]] static grid_box box_around(grid_point a, double x, double y) noexcept
    {
        return {{in_range(std::floor(a.x - x)), in_range(std::floor(a.y - y))},
                {in_range(std::ceil(a.x + x)), in_range(std::ceil(a.y + y))}};
    }

    /// The boxes of all strips.
    [[nodiscard]] bool plant() noexcept
    {
        if (!tree_.open(strips_.size())) return false;
        for (std::size_t i = 0; i < strips_.size(); ++i) {
            const strip& s = strips_[i];
            double reach = 1.0;  // of its corners from its edge
            for (const double shift : s.shift) reach = std::fabs(shift) > reach ? std::fabs(shift) : reach;
            reach = (1.0 + reach) * radii_[s.path];
            grid_box b = box_around(s.a, reach, reach);
            b.merge(box_around(s.b, reach, reach));
            tree_.set(i, b);
        }
        tree_.close();
        return true;
    }

    [[nodiscard]] static bool have_a_joint_in_common(const strip& s, const strip& t) noexcept
    {
        return s.joint[0] == t.joint[0] || s.joint[0] == t.joint[1] || s.joint[1] == t.joint[0] ||
               s.joint[1] == t.joint[1];
    }

    /// Whether two edges have a point in common; exact.
    [[nodiscard]] static bool meet(const strip& s, const strip& t) noexcept
    {
        const auto side = [](std::int64_t v) noexcept { return v < 0 ? -1 : v > 0 ? 1 : 0; };
        grid_box b{}, c{};
        b.add(s.a);
        b.add(s.b);
        c.add(t.a);
        c.add(t.b);
        return b.meets(c) && side(orientation(s.a, s.b, t.a)) * side(orientation(s.a, s.b, t.b)) <= 0 &&
               side(orientation(t.a, t.b, s.a)) * side(orientation(t.a, t.b, s.b)) <= 0;
    }

    [[nodiscard]] bool find_meetings() noexcept
    {
        pairs_.clear();
        bool enough = true;
        for (const strip& s : strips_) {
            if (s.one_side) continue;
            grid_box around;
            around.add(s.a);
            around.add(s.b);
            tree_.each_meeting(around, [&](std::size_t i) noexcept {
                const strip& t = strips_[i];
                if (t.one_side || have_a_joint_in_common(s, t) || !meet(s, t)) return;
                meets_[s.path] = meets_[t.path] = 1;
                enough = enough && pairs_.add(s.path, t.path);
            });
        }
        pairs_.close();
        return enough;
    }

    /// The radii of a corner's path and a strip's path while they grow: linear, from the first to the last.
    struct growth {
        double corner[2], strip[2];
    };

    /// Reduces the radii so that no corner enters a strip. First both paths grow from 0 at one speed, up to the smaller
    /// of their radii. Then only the thicker one grows, from there to its own radius.
    [[nodiscard]] bool keep_apart(bool both) noexcept
    {
        const std::size_t paths = radii_.size();
        double* const allowed = radii_.append(paths);  // for each path, behind its radius
        if (allowed == nullptr && paths != 0) return false;
        for (std::size_t k = 0; k < paths; ++k) allowed[k] = radii_[k] / kept;
        for (const corner& c : corners_) {
            const double reach = radii_[c.path];
            const grid_box way = box_around(c.at, std::fabs(reach * c.lean.x), std::fabs(reach * c.lean.y));
            tree_.each_meeting(way, [&](std::size_t i) noexcept {
                const strip& s = strips_[i];
                if (s.joint[0] == c.joint || s.joint[1] == c.joint) return;
                if (meets_[s.path] != 0 && meets_[c.path] != 0 && pairs_.has(s.path, c.path)) return;
                const double of_corner = radii_[c.path], of_strip = radii_[s.path];
                const double smaller = of_corner < of_strip ? of_corner : of_strip;
                if (both) {
                    const double share = first_contact(c, s, {{0.0, smaller / kept}, {0.0, smaller / kept}});
                    if (share > 1.0) return;
                    reduce(allowed[c.path], share * smaller / kept);
                    reduce(allowed[s.path], share * smaller / kept);
                } else if (of_corner > smaller || of_strip > smaller) {
                    const double to = (of_corner > smaller ? of_corner : of_strip) / kept;
                    const growth grow{{smaller, of_corner > smaller ? to : smaller},
                                      {smaller, of_strip > smaller ? to : smaller}};
                    const double share = first_contact(c, s, grow);
                    if (share > 1.0) return;
                    reduce(allowed[of_corner > smaller ? c.path : s.path], share * to + (1.0 - share) * smaller);
                }
            });
        }
        for (std::size_t k = 0; k < paths; ++k) reduce(radii_[k], kept * allowed[k]);
        radii_.truncate(paths);
        return true;
    }
    static void reduce(double& radius, double to) noexcept { radius = to < radius ? to : radius; }

    /// The part of the growth after which a corner meets a side of a strip; 2 if they do not meet.
    [[nodiscard]] static double first_contact(const corner& c, const strip& s, const growth& grow) noexcept
    {
        const point apart = delta(s.a, c.at), right = outward(s.along);
        const double off = dot(apart, right), on = dot(apart, s.along);
        const double to_right = dot(c.lean, right), forwards = dot(c.lean, s.along);
        // For rounding; less than a cell, or a point of the path just beyond the strip would count as in it.
        const double slack = s.length < 0x1p18 ? 0x1p-20 * (1.0 + s.length) : 0.25;
        const double corner_grows = grow.corner[1] - grow.corner[0], strip_grows = grow.strip[1] - grow.strip[0];
        double first = 1.0;
        bool met = false;
        for (const double side : {1.0, -1.0}) {  // of the corner
            if (side < 0.0 && c.one_side) break;
            for (const double of : {1.0, -1.0}) {  // of the strip
                if (of < 0.0 && s.one_side) break;
                const double gap = off + side * grow.corner[0] * to_right - of * grow.strip[0];
                const double f = gap / (of * strip_grows - side * corner_grows * to_right);
                if (!(f >= 0.0 && f < first)) continue;
                const double at = on + side * (grow.corner[0] + f * corner_grows) * forwards;
                const double wide = grow.strip[0] + f * strip_grows;
                const double begin = wide * (s.open[0] ? -1.0 : of * s.shift[0]),
                             end = s.length + wide * (s.open[1] ? 1.0 : of * s.shift[1]);
                if (at < begin - slack || at > end + slack) continue;
                first = f;
                met = true;
            }
        }
        return met ? first : 2.0;
    }

    buffer<point> leans_;
    buffer<double> radii_;
    buffer<std::uint8_t> meets_;
    path_pairs pairs_;
    buffer<strip> strips_;
    buffer<corner> corners_;
    box_tree tree_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

// SPDX-License-Identifier: MIT
#pragma once

// Laws of one glyph that is refined: its caps, and solids of them that are extruded, bevelled, hollow, and merged with a
// moved copy.

#include "support/bevel_surface.hpp"
#include "support/refined_cap.hpp"
#include "support/solid_in_cells.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test {

/// The findings about one glyph, for one refiner.
struct refined_findings {
    std::size_t caps = 0, solids = 0, triangles = 0, refused = 0, narrowed = 0;
    std::size_t at_corners = 0;       ///< triangles below the least angle between the edges of a sharp corner
    std::size_t crowded = 0;          ///< other ones, whose shortest edge is below 8 cells
    std::size_t small = 0;            ///< all other ones below the least angle
    std::size_t small_in_bevels = 0;  ///< likewise, in caps within bevels
    std::size_t wide = 0;             ///< corners above 90 degrees that rounding does not explain
    std::size_t wide_in_bevels = 0;   ///< likewise, in caps within bevels, without the next two
    std::size_t wide_crowded = 0;     ///< there, those of triangles that are lower than 8 cells
    std::size_t wide_at_slopes = 0;   ///< there, those at edges of slopes without room for the foot of the corner
    std::size_t long_edges = 0;
    double greatest = 0.0;  ///< of non_obtuse: the greatest angle, in degrees
    double area_off = 0.0;  ///< the worst difference of area, as a share of tolerance x boundary
    std::string wrong;      ///< the first law that is broken, and where, or nothing

    void add(const refined_findings& f)
    {
        caps += f.caps, solids += f.solids, triangles += f.triangles, refused += f.refused, narrowed += f.narrowed;
        at_corners += f.at_corners, crowded += f.crowded, small += f.small, small_in_bevels += f.small_in_bevels;
        wide += f.wide, wide_in_bevels += f.wide_in_bevels, long_edges += f.long_edges;
        wide_crowded += f.wide_crowded, wide_at_slopes += f.wide_at_slopes;
        greatest = (std::max)(greatest, f.greatest);
        area_off = (std::max)(area_off, f.area_off);
        if (wrong.empty()) wrong = f.wrong;
    }
};

/// The triangles of a refined cap whose least angle is too small.
class small_angles {
public:
    std::size_t at_corners = 0, crowded = 0, other = 0;

    small_angles(const typemesh::region& before, const refined_result& cap, double degrees)
        : points_{cap.points()}, loops_{cap.loops}
    {
        find_sources(before);
        const double least = std::tan(degrees * 3.14159265358979323846 / 180.0);
        for (const typemesh::triangle t : cap.triangles) look_at(t, least);
    }

private:
    struct angle {
        double sine, cosine;
    };
    [[nodiscard]] angle at(std::uint32_t v, std::uint32_t from, std::uint32_t to) const
    {
        const typemesh::grid_point p = points_[v], a = points_[from], b = points_[to];
        const double ax = double(a.x) - p.x, ay = double(a.y) - p.y, bx = double(b.x) - p.x, by = double(b.y) - p.y;
        return {ax * by - ay * bx, ax * bx + ay * by};
    }

    /// On which edge of the region each boundary point lies, and the angle at each of the region's own points.
    void find_sources(const typemesh::region& before)
    {
        source_.assign(points_.size(), none);
        own_.assign(points_.size(), false);
        next_.assign(before.points().size(), 0);
        corners_.assign(before.points().size(), {0.0, -1.0});
        for (std::uint32_t loop = 0; loop < before.loop_count(); ++loop) {
            const std::uint32_t first = before.starts()[loop], end = before.starts()[loop + 1],
                                begin = loops_.starts[loop], last = loops_.starts[loop + 1];
            std::uint32_t on = first;
            for (std::uint32_t i = begin; i < last; ++i) {
                if (i != begin && on + 1 < end && points_[i] == before.points()[on + 1]) ++on;
                own_[i] = points_[i] == before.points()[on];
                source_[i] = on;
                next_[on] = on + 1 < end ? on + 1 : first;
                if (own_[i]) corners_[on] = at(i, i + 1 < last ? i + 1 : begin, i > begin ? i - 1 : last - 1);
            }
        }
    }

    [[nodiscard]] bool is_sharp(std::uint32_t corner) const
    {
        const angle c = corners_[corner];
        return c.cosine > 0.0 && c.sine > 0.0 && c.sine < 1.7320508075688772 * c.cosine;
    }
    /// Whether a corner explains a least angle, whose tangent is given: arctan(sin c / (2 - cos c)), less a fiftieth.
    [[nodiscard]] bool explains(std::uint32_t corner, double tangent) const
    {
        const angle c = corners_[corner];
        return is_sharp(corner) && tangent * (2.0 * std::hypot(c.sine, c.cosine) - c.cosine) >= (0.98 - 1e-6) * c.sine;
    }

    void look_at(typemesh::triangle t, double least)
    {
        const std::uint32_t v[] = {t.a, t.b, t.c};
        std::size_t apex = 0;
        double tangent = 1e300;
        for (std::size_t k = 0; k < 3; ++k) {
            const angle a = at(v[k], v[(k + 1) % 3], v[(k + 2) % 3]);
            if (a.cosine > 0.0 && a.sine < tangent * a.cosine) {
                tangent = a.sine / a.cosine;
                apex = k;
            }
        }
        if (!(tangent < (1.0 - 1e-6) * least)) return;
        const std::uint32_t a = v[(apex + 1) % 3], b = v[(apex + 2) % 3];
        // One with the corner itself, or between cuts of its two edges.
        if (source_[a] != none && source_[b] != none && source_[a] != source_[b] && !own_[a] && !own_[b])
            for (const auto& [from, to] : {std::pair{source_[a], source_[b]}, {source_[b], source_[a]}})
                if (next_[from] == to && explains(to, tangent)) return void(++at_corners);
        for (const std::uint32_t at : v)
            if (source_[at] != none && own_[at] && explains(source_[at], tangent)) return void(++at_corners);
        ++(typemesh::squared_distance(points_[a], points_[b]) < 64 ? crowded : other);
    }

    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::vector<typemesh::grid_point> points_;
    const typemesh::contours& loops_;
    std::vector<std::uint32_t> source_, next_;
    std::vector<bool> own_;
    std::vector<angle> corners_;
};

/// Reuses its memory for one glyph after another. Use each on one thread.
class refined_laws {
public:
    static constexpr float sizes[] = {0.3f, 0.1f, 0.04f};  ///< em; the first one is no limit for two of the refiners
    static constexpr double least_angle = 26.45;

    /// Makes the glyph's region; false if there is none. `merged`: together with a copy of the glyph that overlaps it.
    template <class Font>
    [[nodiscard]] bool take(Font& font, typemesh::glyph_id id, double tolerance_em, bool merged)
    {
        using namespace typemesh;
        region_ = {};
        if (!record(font, id, outline_) || outline_.curves.empty()) return false;
        if (merged && !add_copy({0.11 * font.units_per_em(), 0.07 * font.units_per_em()})) return false;
        region_ = region_of(caps_, outline_, font.units_per_em(), tolerance_em, constrained_delaunay{});
        return !region_.points().empty();
    }

    [[nodiscard]] refined_findings examine_delaunay(float longest)
    {
        return examine(typemesh::delaunay_refined{.min_angle = float(least_angle),
                                                  .max_edge = longest < sizes[0] ? longest : 0.0f},
                       longest);
    }
    [[nodiscard]] refined_findings examine_quadtree(float longest)
    {
        return examine(typemesh::quadtree_refined{.max_edge = longest}, longest);
    }
    [[nodiscard]] refined_findings examine_non_obtuse(float longest)
    {
        return examine(typemesh::non_obtuse{.max_edge = longest < sizes[0] ? 2.0f * longest : 0.0f}, longest);
    }

private:
    template <class Refiner>
    [[nodiscard]] refined_findings examine(const Refiner& how, float longest)
    {
        using namespace typemesh;
        refined_findings f;
        check_cap(how, f);
        const float width = longest < sizes[1] ? 0.01f : 0.02f;
        check_solid(refined<extruded<>, Refiner>{.how = how}, f, "extruded");
        bevelled bevel{.width = width, .profile = longest < sizes[0] ? round_profile(3) : bevel_profile{}};
        check_solid(refined<bevelled, Refiner>{bevel, how}, f, "bevelled");
        bevel.sides = bevel_sides::front;
        bevel.mode = bevel_mode::fit;
        check_solid(refined<bevelled, Refiner>{bevel, how}, f, "bevelled in front, fit");
        bevel.outward = true;
        check_solid(refined<bevelled, Refiner>{bevel, how}, f, "bevelled outwards");
        check_solid(outlined<refined<extruded<>, Refiner>>{.width = width, .ring = {.how = how}}, f, "hollow");
        bevel = {.width = 0.3f * width};
        check_solid(outlined<refined<bevelled, Refiner>>{.width = width, .ring = {bevel, how}}, f, "hollow, bevelled");
        return f;
    }

    /// The cap as the refiner makes it.
    template <class Refiner>
    void check_cap(const Refiner& how, refined_findings& f)
    {
        typename Refiner::scratch working{typemesh::heap()};
        if (const auto e = how(region_, caps_.triangles().view(), working, cap_.out()); e) {
            ++f.refused;
            return law(f, e == typemesh::error::bad_option || e == typemesh::error::too_many_points, "cap",
                       e.message());
        }
        ++f.caps;
        f.triangles += cap_.triangles.size();
        check_angles(how, region_, f);
        double area = 0.0;
        for (const auto& loop : typemesh::inspect::loops_of(cap_.boundary(region_)))
            area += 0.5 * double(typemesh::inspect::doubled_area(loop));
        const auto before = typemesh::inspect::loops_of(region_);
        area -= 0.5 * double(typemesh::inspect::doubled_area(before));
        // A cell for the rounding of points.
        const double most = (region_.tolerance() + 1.0) * typemesh::inspect::length(before);
        f.area_off = (std::max)(f.area_off, std::fabs(area) / most);
        law(f, std::fabs(area) <= most, "cap", "the area differs by more than the tolerance allows");
        if constexpr (std::is_same_v<Refiner, typemesh::quadtree_refined>)
            law(f, unbalanced_sides(working.tree()) == 0, "cap", "squares are not balanced");
    }

    template <class Refiner>
    void check_angles(const Refiner& how, const typemesh::region& before, refined_findings& f,
                      const typemesh::swept_region* swept = nullptr)
    {
        using namespace typemesh;
        const bool in_bevel = swept != nullptr;
        const char* const where = in_bevel ? "cap within a bevel" : "cap";
        if (const std::string broken = broken_refinement(before, cap_); !broken.empty())
            return law(f, false, where, broken.c_str());
        const double longest = double(how.max_edge) * em_of(region_);
        if (longest > 0.0) {
            const std::vector<grid_point> p = cap_.points();
            for (const triangle t : cap_.triangles) {
                const std::int64_t most =
                    (std::max)({squared_distance(p[t.a], p[t.b]), squared_distance(p[t.b], p[t.c]),
                                squared_distance(p[t.c], p[t.a])});
                f.long_edges += double(most) > longest * longest;
            }
        }
        if constexpr (std::is_same_v<Refiner, delaunay_refined>) {
            const small_angles small{before, cap_, least_angle};
            f.at_corners += small.at_corners;
            f.crowded += small.crowded;
            (in_bevel ? f.small_in_bevels : f.small) += small.other;
            law(f, is_delaunay(cap_), where, "an inner edge is not Delaunay");
        } else if constexpr (std::is_same_v<Refiner, quadtree_refined>) {
            law(f, is_delaunay(cap_), where, "an inner edge is not Delaunay");
        } else {
            const wide_corners wide = wide_corners_of(cap_);
            f.greatest = (std::max)(f.greatest, wide.greatest);
            if (!in_bevel) return void(f.wide += wide.above);
            f.wide_crowded += wide.crowded;
            const auto points = cap_.points();
            for (const auto& [corner, edge] : wide.others)
                ++(is_without_room(*swept, corner, points[edge.first], points[edge.second]) ? f.wide_at_slopes
                                                                                            : f.wide_in_bevels);
        }
    }

    /// Whether the edge from p to q is the edge of a slope, and the slope's triangle allows no point of the grid around
    /// the foot of the perpendicular from a corner to the edge: on the cap's side, its parts would be turned.
    [[nodiscard]] static bool is_without_room(const typemesh::swept_region& swept, typemesh::grid_point corner,
                                              typemesh::grid_point p, typemesh::grid_point q)
    {
        using namespace typemesh;
        const double x = double(q.x) - p.x, y = double(q.y) - p.y;
        const double share = ((double(corner.x) - p.x) * x + (double(corner.y) - p.y) * y) / (x * x + y * y);
        const std::int32_t column = p.x + std::int32_t(std::floor(share * x)),
                           row = p.y + std::int32_t(std::floor(share * y));
        const auto allows = [&](grid_point r, grid_point foot) {
            const bool is_left = orientation(p, q, r) > 0;
            const std::int64_t before = orientation(p, foot, r), after = orientation(foot, q, r);
            return orientation(p, q, foot) >= 0 && (is_left ? before > 0 && after > 0 : before < 0 && after < 0);
        };
        bool is_slope = false;
        for (const triangle& t : swept.triangles) {
            const grid_point c[] = {swept.nodes[t.a].at, swept.nodes[t.b].at, swept.nodes[t.c].at};
            for (std::size_t k = 0; k < 3; ++k) {
                const grid_point a = c[k], b = c[(k + 1) % 3], r = c[(k + 2) % 3];
                if (!(a == p && b == q) && !(a == q && b == p)) continue;
                is_slope = true;
                for (const grid_point foot : {grid_point{column, row}, grid_point{column + 1, row},
                                              grid_point{column, row + 1}, grid_point{column + 1, row + 1}})
                    if (allows(r, foot)) return false;
            }
        }
        return is_slope;
    }

    template <class Solid>
    void check_solid(const Solid& how, refined_findings& f, const char* name)
    {
        using namespace typemesh;
        plan_data_of<Solid> data{heap()};
        const auto plan = write_in_cells(how, region_, caps_, em_of(region_), data, mesh_, constrained_delaunay{});
        if (!plan) {
            ++f.refused;
            const error e = plan.error();
            return law(f,
                       e == error::bad_option || e == error::too_many_points || e == error::edges_not_moved ||
                           e == error::crossing_contours || e == error::outline_beyond_grid,
                       name, e.message());
        }
        ++f.solids;
        f.narrowed += plan->narrowed;
        if constexpr (requires { data.ring; })
            check_surface(how, data.ring.data, f, name, how.ring);
        else
            check_surface(how, data, f, name, how);
    }

    template <class Solid, class Data, class Refined>
    void check_surface(const Solid&, Data& data, refined_findings& f, const char* name, const Refined& how)
    {
        using namespace typemesh;
        for (const std::uint32_t i : mesh_.indices)
            if (i >= mesh_.vertices.size()) return law(f, false, name, "a corner is no vertex");
        contours boundary;
        const std::size_t own = data.loops.starts.empty() ? 0 : data.loops.starts.back();
        if (!boundary.points.append(data.loops.points.view().first(own)) ||
            !boundary.starts.append(data.loops.starts.view()) || boundary.edges.append(own) == nullptr)
            return law(f, false, name, "out of memory");
        const region of_solid = region::proven(boundary, 0, 0);
        constexpr bool has_bevel = requires { data.data.swept; };
        bool is_outward = false, is_narrow = false;
        if constexpr (has_bevel) {
            is_outward = how.solid.outward;
            is_narrow = data.data.swept.levels.empty() || data.data.swept.levels.back() < 64.0;
        }
        if (is_outward) {
            const inspect::mesh_view view{mesh_.vertices, mesh_.indices};
            law(f, inspect::check_closedness(view).is_closed(), name, "the mesh is not closed");
        } else {  // closed, and more
            const surface_laws laws{mesh_, of_solid, is_narrow};
            law(f, laws.broken().empty(), name, laws.broken().c_str());
        }
        if constexpr (has_bevel) {
            // The cap within the bevel, beside what the sweep has left.
            bevel_data& bevel = data.data;
            if (bevel.of<triangle>().empty()) return;
            cap_.loops.clear();
            cap_.inner.clear();
            cap_.triangles.clear();
            const auto all = bevel.of<grid_point>().view();
            const std::size_t count = bevel.of<std::uint32_t>().back();
            if (!cap_.loops.points.append(all.first(count)) || !cap_.loops.edges.append(count) ||
                !cap_.loops.starts.append(bevel.of<std::uint32_t>().view()) || !cap_.inner.append(all.subspan(count)) ||
                !cap_.triangles.append(bevel.of<triangle>().view()))
                return law(f, false, name, "out of memory");
            std::uint32_t holes = 0, outers = 0;
            region left = region::proven(bevel.swept.cap, 0, 0);
            for (const auto& loop : inspect::loops_of(left)) ++(inspect::doubled_area(loop) > 0 ? outers : holes);
            left = region::proven(bevel.swept.cap, holes, outers);
            f.triangles += cap_.triangles.size();
            check_angles(how.how, left, f, &bevel.swept);
        }
    }

    /// The number of sides on whose other side lies a square of more than twice the width.
    [[nodiscard]] static std::size_t unbalanced_sides(const typemesh::detail::balanced_quadtree& tree)
    {
        std::size_t count = 0;
        for (std::uint32_t n = 0; n < tree.square_count(); ++n) {
            if (!tree.is_leaf(n)) continue;
            const auto [x, y] = tree.corner(n);
            const std::int32_t width = tree.width(tree.at(n).level);
            for (const auto& [beyond_x, beyond_y] : {std::pair{x - 1, y}, {x + width, y}, {x, y - 1}, {x, y + width}})
                count += tree.level_at(beyond_x, beyond_y) + 1 < tree.at(n).level;
        }
        return count;
    }

    [[nodiscard]] bool add_copy(typemesh::point by)
    {
        using namespace typemesh;
        const auto curves = static_cast<std::uint32_t>(outline_.curves.size());
        const std::uint32_t contours = outline_.contour_count();
        outline_.rule = fill_rule::non_zero;
        for (std::uint32_t i = 0; i < curves; ++i) {
            curve c = outline_.curves[i];
            for (point& p : c.p) p = p + by;
            if (!outline_.curves.push_back(c)) return false;
        }
        for (std::uint32_t k = 1; k <= contours; ++k)
            if (!outline_.starts.push_back(curves + outline_.starts[k])) return false;
        outline_.bounds.add(outline_.bounds.low + by);
        outline_.bounds.add(outline_.bounds.high + by);
        return true;
    }

    static void law(refined_findings& f, bool holds, const char* where, const char* sentence)
    {
        if (!holds && f.wrong.empty()) f.wrong = std::string{where} + ": " + sentence;
    }

    typemesh::outline outline_;
    typemesh::cap_builder caps_;
    typemesh::region region_;
    refined_result cap_;
    bevel_surface mesh_;
};

}  // namespace test

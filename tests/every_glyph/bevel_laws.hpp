// SPDX-License-Identifier: MIT
#pragma once

// Laws of one bevelled glyph, at all widths: of its mesh, and in comparison with the slow wavefront.

#include "support/bevel_oracle.hpp"
#include "support/bevel_surface.hpp"
#include "support/solid_in_cells.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// The findings about one glyph at one width.
struct bevel_findings {
    std::size_t meshes = 0;
    std::size_t narrowed = 0;   ///< bevels of the front: see solid_plan
    std::size_t compared = 0;   ///< with the slow wavefront
    double volume_error = 0.0;  ///< the worst, as a share of perimeter x 2 cells x depth
    double height_error = 0.0;  ///< the worst: the error of a height, in cells in the plane
    std::string wrong;          ///< the first law that is broken, and where, or nothing
};

/// Reuses its memory for one glyph after another. Use each on one thread.
class bevel_laws {
public:
    static constexpr double widths[] = {0.005, 0.01, 0.02, 0.03, 0.05, 0.1, 0.3};  // em

    static constexpr double max_off_distance = 8.0;  ///< cells, of a height in the plane

    std::size_t max_compared = 0;  ///< points of a region for the slow wavefront, which takes n^2 an event
    bool delaunay = false;         ///< instead of monotone

    /// Makes the glyph's region; false if there is none.
    template <class Font>
    [[nodiscard]] bool take(Font& font, typemesh::glyph_id id, double tolerance_em)
    {
        using namespace typemesh;
        region_ = {};
        if (!record(font, id, outline_) || outline_.curves.empty()) return false;
        with_triangulator([&](const auto& cut) {
            region_ = region_of(caps_, outline_, font.units_per_em(), tolerance_em, cut);
            return 0;
        });
        return !region_.points().empty();
    }

    /// Bevels of one width (em): chamfers and rounds of four steps, closing in ridges and fitting, in front and on both
    /// sides.
    [[nodiscard]] bevel_findings examine(double width)
    {
        using namespace typemesh;
        bevel_findings f;
        oracle_.reset();
        examine(bevelled{}, chamfer_, width, f);
        examine(bevelled{.profile = round_profile(4)}, round_, width, f);
        return f;
    }

private:
    template <class F>
    auto with_triangulator(const F& f)
    {
        return delaunay ? f(typemesh::constrained_delaunay{}) : f(typemesh::monotone{});
    }

    template <class Bevel>
    void examine(Bevel how, const plain_profile& profile, double width, bevel_findings& f)
    {
        using namespace typemesh;
        how.width = static_cast<float>(width);
        how.bevel_depth = 0.04f;
        const double wanted = double(how.width) * em();
        for (const bevel_mode mode : {bevel_mode::clip, bevel_mode::fit}) {
            for (const bevel_sides sides : {bevel_sides::front, bevel_sides::both}) {
                how.mode = mode;
                how.sides = sides;
                std::string wrong = build(how);
                const double reached = data_.swept.levels.empty() ? 0.0 : data_.swept.levels.back();
                const bool narrower = reached < wanted;
                if (mode == bevel_mode::fit && !narrower && wrong.empty()) return;  // this mesh has been examined
                const bool reported = mode == bevel_mode::clip ? narrower : reached < 0.5 * wanted;
                if (wrong.empty() && reported && !narrowed_) wrong = "narrowed, but not said so";
                if (wrong.empty() && !reported && narrowed_ && mode == bevel_mode::clip)
                    wrong = "said to be narrowed, and is not";
                if (sides == bevel_sides::front && mode == bevel_mode::clip && narrowed_) ++f.narrowed;
                if (wrong.empty()) wrong = broken_law(how, profile, reached, f);
                ++f.meshes;
                if (!wrong.empty() && f.wrong.empty())
                    f.wrong = std::string{&profile == &chamfer_ ? "chamfer" : "round"} +
                              (mode == bevel_mode::fit ? ", fit, " : ", clip, ") +
                              (sides == bevel_sides::both ? "both: " : "front: ") + wrong;
            }
        }
    }

    /// Makes the mesh, in cells.
    [[nodiscard]] std::string build(const typemesh::bevelled& how)
    {
        const auto plan = with_triangulator(
            [&](const auto& cut) { return write_in_cells(how, region_, caps_, em(), data_, mesh_, cut); });
        if (!plan) return plan.error().message();
        narrowed_ = plan->narrowed;
        lost_caps_ = plan->lost_caps;
        return {};
    }

    template <class Bevel>
    [[nodiscard]] std::string broken_law(const Bevel& how, const plain_profile& profile, double width,
                                         bevel_findings& f)
    {
        constexpr double narrowest = 64.0;  // cells: in narrower profiles steps are merged, and specks have no cap
        const surface_laws laws{mesh_, region_, width < narrowest};
        if (!laws.broken().empty() || width < narrowest) return laws.broken();
        if (how.mode == typemesh::bevel_mode::fit && !keeps_caps())
            return "a part has lost a cap that should fit, or that is no speck, or is not counted";
        if (std::string wrong = reached_too_late(how, profile, width); !wrong.empty()) return wrong;
        if (region_.points().size() > max_compared) return {};
        return compare(how, profile, width, laws.doubled_cap_area() / 2, f);
    }

    /// Compares with the slow wavefront.
    template <class Bevel>
    [[nodiscard]] std::string compare(const Bevel& how, const plain_profile& profile, double width, double cap_area,
                                      bevel_findings& f)
    {
        namespace inspect = typemesh::inspect;
        const double joins_at = how.mode == typemesh::bevel_mode::fit ? double(how.width) * em() : width;
        if (!oracle_ || oracle_widths_ != std::pair{width, joins_at})
            oracle_.emplace(region_, width, joins_at, double(how.mitre_limit),
                            std::vector<const plain_profile*>{&chamfer_, &round_});
        oracle_widths_ = {width, joins_at};
        if (oracle_->is_doubtful()) return {};
        ++f.compared;
        const auto loops = inspect::loops_of(region_);
        const double rounding = 2.0 * inspect::length(loops), depth = double(how.depth) * em(),
                     rise = double(how.bevel_depth) * em();
        if (std::fabs(cap_area - oracle_->cap_area()) > rounding) return "the cap's area is not the level's";
        const double bevels = how.sides == typemesh::bevel_sides::both ? 2.0 : 1.0;
        const double whole = static_cast<double>(inspect::doubled_area(loops)) / 2;
        const double volume = whole * (depth - bevels * rise) + bevels * oracle_->volume(profile, rise);
        const double off = std::fabs(mesh_.volume() - volume) / (rounding * depth);
        f.volume_error = (std::max)(f.volume_error, off);
        if (off > 1.0) return "the volume does not fit the levels";
        double worst = 0.0;
        for (const bevel_oracle::place& p : oracle_->places()) {
            double z = 0.0;
            if (!height_over(mesh_, p.x, p.y, z)) continue;
            const double t = p.distance / width;
            worst =
                (std::max)(worst, std::fabs(z + rise - profile.height(t) * rise) / (profile.slope(t) * rise) * width);
        }
        f.height_error = (std::max)(f.height_error, worst);
        return worst > max_off_distance ? "a height does not fit its distance" : std::string{};
    }

    /// Whether a place was reached later than its distance from the boundary: edges move at speed 1.
    template <class Bevel>
    [[nodiscard]] std::string reached_too_late(const Bevel& how, const plain_profile& profile, double width) const
    {
        using namespace typemesh;
        const auto loops = inspect::loops_of(region_);
        const double rise = double(how.bevel_depth) * em();
        const auto all = mesh_.triangles_of(part::front_bevel);
        constexpr std::size_t most = 40;
        for (std::size_t t = all.begin; t < all.end; t += 1 + (all.end - all.begin) / most) {
            const auto p = mesh_.corner(t, t % 3);
            const double swept = profile.distance(p.z / rise + 1.0) * width;
            const grid_point at{static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)};
            if (swept > inspect::distance(loops, at) + max_off_distance)
                return "a place is reached later than its distance from the boundary says";
        }
        return {};
    }

    /// Whether a point of the front lies within each outer loop, except for specks, which are counted. If no circle of the
    /// tolerance fits, the area is less than the tolerance times the length of the boundary, holes included.
    [[nodiscard]] bool keeps_caps() const
    {
        namespace inspect = typemesh::inspect;
        const auto cap = mesh_.triangles_of(typemesh::part::front);
        std::size_t lost = 0;
        for (const inspect::loop l : inspect::loops_of(region_)) {
            if (inspect::doubled_area(l) < 0) continue;
            bool found = false;
            for (std::size_t t = cap.begin; t < cap.end && !found; ++t) {
                const auto p = mesh_.corner(t, 0);
                found = inspect::winding(l, {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)}) > 0;
            }
            if (found) continue;
            ++lost;
            const std::vector<inspect::loop> boundary = with_its_holes(l);
            double area = 0.0;
            for (const inspect::loop b : boundary) area += 0.5 * static_cast<double>(inspect::doubled_area(b));
            if (area > (region_.tolerance() + 1.0) * inspect::length(boundary)) return false;
        }
        return lost == lost_caps_;
    }

    /// An outer loop, and the holes that lie directly within it.
    [[nodiscard]] std::vector<typemesh::inspect::loop> with_its_holes(typemesh::inspect::loop outer) const
    {
        namespace inspect = typemesh::inspect;
        const auto all = inspect::loops_of(region_);
        std::vector<inspect::loop> found{outer};
        for (const inspect::loop hole : all) {
            if (inspect::doubled_area(hole) > 0) continue;
            const inspect::loop* nearest = nullptr;
            for (const inspect::loop& l : all)
                if (inspect::doubled_area(l) > 0 && inspect::winding(l, hole[0]) > 0 &&
                    (nearest == nullptr || inspect::doubled_area(l) < inspect::doubled_area(*nearest)))
                    nearest = &l;
            if (nearest != nullptr && nearest->data() == outer.data()) found.push_back(hole);
        }
        return found;
    }

    [[nodiscard]] double em() const { return em_of(region_); }

    typemesh::outline outline_;
    typemesh::cap_builder caps_;
    typemesh::region region_;
    typemesh::bevel_data data_;
    bevel_surface mesh_;
    bool narrowed_ = false;
    std::size_t lost_caps_ = 0;
    const plain_profile chamfer_ = plain_profile::chamfer(), round_ = plain_profile::round(4);
    std::optional<bevel_oracle> oracle_;  // at these
    std::pair<double, double> oracle_widths_;
};

}  // namespace test

// SPDX-License-Identifier: MIT

// Bevels of shapes with corners within a few cells of each other, or that all but touch themselves, beside the slow
// wavefront.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/bevel_oracle.hpp"
#include "support/bevel_surface.hpp"
#include "support/catch.hpp"
#include "support/shape_file.hpp"

using namespace typemesh;

namespace {

using loops = std::vector<std::vector<grid_point>>;

loops loops_of(const region& r)
{
    loops all;
    for (const inspect::loop l : inspect::loops_of(r)) all.emplace_back(l.begin(), l.end());
    return all;
}

/// A region, and what an outward sweep of it sweeps.
class bevelled_shape {
public:
    bevelled_shape(const recorded_outlines& font, double tolerance)
    {
        outline drawn;
        REQUIRE(record(font, 0, drawn));
        curves_ = std::move(drawn);
        const auto cells = grid::fitting(font.units_per_em(), curves_.bounds);
        REQUIRE(cells);
        const auto made = caps_.build(curves_, tolerance * font.units_per_em(), *cells, {curves_.rule}, with_);
        REQUIRE(made);
        region_ = *made;
        em_ = cells->cells * font.units_per_em();
    }

    [[nodiscard]] double em() const { return em_; }
    [[nodiscard]] const region& filled() const { return region_; }

    void raise(const bevelled& how)
    {
        how_ = how;
        data_.clear();
        region_caps caps{caps_, further_, cut_};
        const auto plan = plan_solid(how, region_, data_, caps);
        REQUIRE(plan);
        CHECK_FALSE(plan->narrowed);
        mesh_.sizes = plan->sizes;
        const solid_of<bevelled> form{{region_.points(), region_.starts(), caps_.triangles().view()}, data_.read()};
        placement at;
        at.unit_per_depth = em_;
        REQUIRE(write_solid<bevelled>({form, *plan}, how, at, mesh_));
    }

    /// What the edges sweep, in the order that the sweep follows: of an outward bevel the loops of its surroundings.
    [[nodiscard]] loops swept_loops()
    {
        if (!how_.outward) return loops_of(region_);
        const double reach = farthest_way(region_, width(), double(how_.mitre_limit));
        REQUIRE_FALSE(surround(region_, reach, around_.loops()));
        const auto filled = around_.fill({}, cut_);
        REQUIRE(filled);
        return loops_of(*filled);
    }
    /// The surroundings with each loop as the letter has it, though two of them touch.
    [[nodiscard]] loops own_loops()
    {
        REQUIRE_FALSE(surround(region_, farthest_way(region_, width(), double(how_.mitre_limit)), around_.loops()));
        loops all;
        const auto starts = around_.loops().starts.view();
        const auto points = around_.loops().points.view();
        for (std::size_t k = 0; k + 1 < starts.size(); ++k)
            all.emplace_back(points.begin() + starts[k], points.begin() + starts[k + 1]);
        return all;
    }

    struct comparison {
        std::size_t places = 0;
        double worst = 0.0;  ///< cells in the plane
        bool doubtful = false;
    };
    /// The mesh's heights over edges of the wavefront, wherever a triangle of at least three cells lies there.
    [[nodiscard]] comparison compare(const loops& swept) const
    {
        const double rise = double(how_.bevel_depth) * em_;
        comparison found;
        test::slow_wavefront front{swept, {double(how_.mitre_limit), region_.tolerance(), width()}};
        for (const double share : {0.1, 0.4, 0.7, 0.97}) {
            front.advance(share * width());
            for (const auto& l : front.loops()) {
                for (std::size_t i = 0; i < l.size(); ++i) {
                    const auto a = l[i], along = l[(i + 1) % l.size()] - a;
                    const double length = double(test::length(along));
                    if (length < 16.0) continue;
                    const int steps = 1 + std::min(20, int(length / 2000.0));
                    for (int k = 0; k < steps; ++k) {
                        const auto p = a + (k + 0.5L) / steps * along;
                        double z = 0.0;
                        if (!test::height_over(mesh_, double(p.x), double(p.y), z)) continue;
                        const double t = how_.outward ? -z / rise : z / rise + 1.0;
                        found.worst = std::max(found.worst, std::fabs(t - share) * width());
                        ++found.places;
                    }
                }
            }
        }
        found.doubtful = front.is_doubtful();
        return found;
    }

private:
    [[nodiscard]] double width() const { return double(how_.width) * em_; }

    certified flatten_;
    monotone cut_;
    no_observer nobody_;
    const cap_policies with_{flatten_, cut_, nobody_};
    outline curves_;
    cap_builder caps_, further_, around_;
    region region_;
    double em_ = 0.0;
    bevelled how_;
    bevel_data data_;
    test::bevel_surface mesh_;
};

/// A star of sharp tips, some of which are cut off so short that two corners are at most three cells apart.
recorded_outlines blunt_star(std::uint32_t seed)
{
    std::mt19937 random{seed};
    const auto below = [&](std::uint32_t n) { return double(random() % n); };
    recorded_outlines drawn{1000.0};
    const int tips = 3 + int(below(4));
    constexpr double turn = 6.283185307179586, cell = 1.0 / 1024.0;
    REQUIRE(drawn.add([&](auto& pen) {
        for (int i = 0; i < 2 * tips; ++i) {
            const bool is_tip = i % 2 == 0;
            const double angle = turn * (i + 0.3 * below(100) / 100.0) / (2 * tips),
                         far = is_tip ? 480.0 : 90.0 + below(150);
            const point p{500.0 + far * std::cos(angle), 500.0 + far * std::sin(angle)};
            if (i == 0)
                pen.move(p);
            else
                pen.line(p);
            if (is_tip) pen.line(p + point{cell * (below(7) - 3.0), cell * (below(7) - 3.0)});
        }
        pen.close();
    }));
    return drawn;
}

}  // namespace

TEST_CASE("near double corners bevels have the heights that the slow wavefront gives them", "[every_glyph][bevel]")
{
    std::size_t places = 0, compared = 0;
    const auto examine = [&](const std::string& name, const recorded_outlines& font, double tolerance, float width) {
        bevelled_shape shape{font, tolerance};
        for (const bool outward : {false, true}) {
            INFO(name << " at " << width << (outward ? " outwards, tolerance " : ", tolerance ") << tolerance);
            shape.raise({.width = width, .outward = outward});
            const auto found = shape.compare(shape.swept_loops());
            if (found.doubtful) continue;
            CHECK(found.worst < 4.0);
            places += found.places;
            ++compared;
        }
    };
    for (const test::named_shape& s : test::shapes_of("double_corners.txt"))
        for (const double tolerance : {quality::low, quality::normal, quality::high})
            for (const float width : {0.02f, 0.05f}) examine(s.name, s.font, tolerance, width);
    for (std::uint32_t seed = 0; seed < 40; ++seed)
        examine("star " + std::to_string(seed), blunt_star(seed), quality::normal, 0.04f);
    CHECK(compared > 80);
    CHECK(places > 20'000);
}

TEST_CASE("where two corners touch, the heights around depend on how they are linked", "[every_glyph][bevel]")
{
    const auto shapes = test::shapes_of("double_corners.txt");
    bevelled_shape shape{shapes[0].font, quality::normal};
    REQUIRE(shape.filled().is_touching());
    shape.raise({.width = 0.05f, .outward = true});
    const auto linked = shape.compare(shape.swept_loops()), apart = shape.compare(shape.own_loops());
    CHECK(linked.worst < 4.0);
    CHECK(apart.worst > 0.02 * shape.em());
}

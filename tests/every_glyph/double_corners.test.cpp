// SPDX-License-Identifier: MIT

// Bevels of shapes with corners a few cells apart, or that nearly touch themselves, compared with the slow wavefront.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
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
#include "support/required.hpp"
#include "support/shape_file.hpp"
#include "support/solid_in_cells.hpp"

using namespace typemesh;

namespace {

using loops = std::vector<std::vector<grid_point>>;

loops loops_of(const region& r)
{
    loops all;
    for (const inspect::loop l : inspect::loops_of(r)) all.emplace_back(l.begin(), l.end());
    return all;
}

/// A region, and the loops that an outward sweep of it sweeps.
class bevelled_shape {
public:
    bevelled_shape(const recorded_outlines& font, double tolerance)
    {
        REQUIRE(record(font, 0, curves_));
        region_ = test::region_of(caps_, curves_, font.units_per_em(), tolerance);
        REQUIRE_FALSE(region_.points().empty());
        em_ = test::em_of(region_);
    }

    [[nodiscard]] double em() const { return em_; }
    [[nodiscard]] const region& filled() const { return region_; }

    void raise(const bevelled& how)
    {
        how_ = how;
        CHECK_FALSE(test::required(test::write_in_cells(how, region_, caps_, em_, data_, mesh_))->narrowed);
    }

    /// The loops that the sweep moves, in its order: for an outward bevel, the loops of the surroundings.
    [[nodiscard]] loops swept_loops()
    {
        if (!how_.outward) return loops_of(region_);
        const double reach = farthest_way(region_, width(), double(how_.mitre_limit));
        REQUIRE_FALSE(surround(region_, reach, around_.loops()));
        return loops_of(*test::required(around_.fill({}, monotone{})));
    }
    /// The surroundings with each loop as in the letter, even if two of them touch.
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
    /// The mesh's heights over edges of the wavefront, wherever a triangle at least three cells wide lies there.
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

    outline curves_;
    cap_builder caps_, around_;
    region region_;
    double em_ = 0.0;
    bevelled how_;
    bevel_data data_;
    test::bevel_surface mesh_;
};

/// A star of sharp tips. Some are cut off so closely that two corners are at most three cells apart.
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

TEST_CASE("bevels near double corners have the heights of the slow wavefront", "[every_glyph][bevel]")
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

TEST_CASE("where two corners touch, the heights around them depend on how they are linked", "[every_glyph][bevel]")
{
    const auto shapes = test::shapes_of("double_corners.txt");
    bevelled_shape shape{shapes[0].font, quality::normal};
    REQUIRE(shape.filled().is_touching());
    shape.raise({.width = 0.05f, .outward = true});
    const auto linked = shape.compare(shape.swept_loops()), apart = shape.compare(shape.own_loops());
    CHECK(linked.worst < 4.0);
    CHECK(apart.worst > 0.02 * shape.em());
}

// SPDX-License-Identifier: MIT

#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <set>

using namespace typemesh;

namespace {

/// One glyph with every kind of curve, two contours, and no two coordinates alike in the first.
recorded_outlines drawing()
{
    recorded_outlines made{1000.0, fill_rule::even_odd};
    REQUIRE(made.add([](auto& pen) {
        pen.move({1, 2}), pen.line({300, 5}), pen.quadratic({350, 120}, {310, 250});
        pen.cubic({200, 330}, {90, 280}, {11, 260}), pen.close();
        pen.move({10, 10}), pen.line({20, 10}), pen.line({10, 20}), pen.close();
    }));
    return made;
}

}  // namespace

TEST_CASE("a transformed source draws every point where its map puts it", "[outline][transformed_outlines]")
{
    recorded_outlines source = drawing();
    outline plain;
    REQUIRE(record(source, 0, plain));
    for (const affine& map : {affine{}, affine{.xy = 0.2}, affine{.xx = -1.0}, affine{.dx = 40.0, .dy = -7.0},
                              affine{0.6, -0.8, 3.0, 0.8, 0.6, -5.0}, affine{2.0, 0.25, -3.0, 0.0, -1.0, 7.0}}) {
        transformed_outlines moved{source, map};
        outline made;
        REQUIRE(record(moved, 0, made));
        REQUIRE(made.curves.size() == plain.curves.size());
        CHECK(std::ranges::equal(made.starts, plain.starts));
        for (std::size_t k = 0; k < made.curves.size(); ++k) {
            REQUIRE(made.curves[k].degree == plain.curves[k].degree);
            for (std::uint32_t i = 0; i <= made.curves[k].degree; ++i) {
                const point p = plain.curves[k].p[i];
                CHECK(made.curves[k].p[i] ==
                      point{map.xx * p.x + map.xy * p.y + map.dx, map.yx * p.x + map.yy * p.y + map.dy});
            }
        }
        CHECK(made.rule == fill_rule::even_odd);
        CHECK(moved.units_per_em() == 1000.0);
        CHECK(moved.fill() == fill_rule::even_odd);
    }
    transformed_outlines moved{source, affine{}};
    outline none;
    CHECK(record(moved, 7, none) == error::unknown_glyph);
}

TEST_CASE("two transformations, and one on top of another, have different variation keys",
          "[outline][transformed_outlines]")
{
    recorded_outlines source = drawing();
    std::set<std::uint64_t> keys{variation_of(source)};
    std::size_t made = 1;
    for (const double by : {0.0, 0.25, -0.25}) {
        for (double affine::* const number :
             {&affine::xx, &affine::xy, &affine::dx, &affine::yx, &affine::yy, &affine::dy}) {
            affine map;
            map.*number += by;
            if (by == 0.0 && number != &affine::xx) continue;  // the identity, once
            transformed_outlines once{source, map};
            CHECK(variation_of(once) == variation_of(transformed_outlines{source, map}));
            keys.insert(variation_of(once));
            keys.insert(variation_of(transformed_outlines{once, map}));
            made += 2;
        }
    }
    CHECK(keys.size() == made);
}

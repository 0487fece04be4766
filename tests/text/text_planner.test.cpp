// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_runs.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <utility>

using namespace typemesh;

namespace {

struct unkeyed_steps {
    int steps = 4;
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        for (int i = 1; i <= steps; ++i) put(c.at(double(i) / steps), double(i) / steps);
    }
};

/// A mesher is a member, made before there is a font.
struct hud {
    text_mesher<flat> mesher;
    text_mesher<> titles{heap()};
};

}  // namespace

TEST_CASE("what a mesher lacks is said when it is to plan", "[text][text_planner]")
{
    hud owns;
    CHECK(owns.mesher.plan("o").error() == error::no_font);
    const glyph_run nothing;
    CHECK(owns.titles.plan(nothing).error() == error::no_font);
    recorded_outlines icons{1000.0};
    owns.mesher.use(icons);
    CHECK(owns.mesher.plan("o").error() == error::not_a_shaper);
    test::toy_font font;
    owns.mesher.use(font);
    CHECK(owns.mesher.plan("o"));
    glyph_cache cache;
    auto kept = text_mesher{font}.with(unkeyed_steps{}).with(cached_in{cache, 1});
    CHECK(kept.plan("o").error() == error::no_cache_key);
    text_mesher unlocked{font, cached_in{cache, 1}};
    test::scrambled_workers several{2};
    auto workers = test::toy_team(several);
    CHECK(unlocked.plan("o", {}, *workers).error() == error::unlocked_cache);
    CHECK(unlocked.plan("o"));
}

TEST_CASE("two meshers swapped go on as each other", "[text][text_planner]")
{
    test::toy_font font;
    text_mesher one{font, two_lines{}}, two{font, constrained_delaunay{}, extruded<>{.depth = 1.0f}};
    test::full_mesh before_one, before_two, after_one, after_two;
    REQUIRE(one.build("oE", into(before_one.vertices, before_one.indices)));
    REQUIRE(two.build("oE", into(before_two.vertices, before_two.indices)));
    std::swap(one, two);
    REQUIRE(two.build("oE", into(after_one.vertices, after_one.indices)));
    REQUIRE(one.build("oE", into(after_two.vertices, after_two.indices)));
    CHECK(test::same_bits(before_one, after_one));
    CHECK(test::same_bits(before_two, after_two));
    one.use(two_lines{});
    one.use(monotone{});
    one.use(extruded<>{});
    REQUIRE(one.build("oE", into(after_two.vertices, after_two.indices)));
    CHECK(test::same_bits(before_one, after_two));
}

// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/non_obtuse_refinement.hpp>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::non_obtuse_refinement;
using detail::refinement_limits;

namespace {

/// As non_obtuse has them.
constexpr refinement_limits coarse{0.364, 2.694, 0, 100'000};

}  // namespace

TEST_CASE("features of a few cells end, and their obtuse triangles are counted", "[refine]")
{
    // Narrow teeth, down to the width of a cell.
    for (const std::int32_t width : {1, 2, 3, 5, 9, 30}) {
        CAPTURE(width);
        test::shape s{"comb", {{{0, 0}, {100'000, 0}}}};
        for (std::int32_t x = 100'000; x > 5000; x -= 5000) {
            s.loops[0].push_back({x, 20'000});
            s.loops[0].push_back({x - width, 300});
        }
        s.loops[0].push_back({0, 20'000});
        if (!inspect::is_region(test::loops_of(s))) continue;
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(shape.filled, space, given));
        non_obtuse_refinement refinement;
        test::refined_result out;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), coarse));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        const test::wide_corners wide = test::wide_corners_of(out);
        CHECK(wide.above == refinement.kept());  // a triangle has one obtuse corner at most
        CHECK(100 * wide.above <= out.triangles.size());
    }
}

TEST_CASE("division without memory says so, and asks for none once it is warm", "[refine]")
{
    const test::filled_shape shape{test::circle_with_holes(30, 2)};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        non_obtuse_refinement refinement{memory.source()};
        test::refined_result out{memory.source()};
        error e = refinement.run(shape.filled, given.view(), coarse);
        if (!e) e = refinement.write(out.out());
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
        memory.fail_at = 0;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), coarse));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        CHECK(test::wide_corners_of(out).rounded > 0);  // it was divided
        const std::size_t warm = memory.requests;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), coarse));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(memory.requests == warm);
    }
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/emboldened.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/impl/solid_ref.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

TEMPLATE_TEST_CASE("a reference to a solid has the solid's own key, heights and errors", "[glyph]", flat, extruded<>,
                   bevelled, test::emboldened<>, outlined<>)
{
    const TestType how;
    const solid_ref refers{how};
    CHECK(refers.key() == key_of(how));
    CHECK(refers.heights().low == how.heights().low);
    CHECK(refers.heights().high == how.heights().high);
    CHECK(refers.refused_options() == refused_options(how).code);
    CHECK(refers.has_heights_of_each() == has_heights<TestType>);
}

TEST_CASE("planning a region reports a lack of memory for plan data", "[glyph]")
{
    no_observer nobody;
    const certified flatten;
    const monotone cut;
    const extruded<> raise;
    const policies with{flatten, cut, raise, nobody};
    test::counting_memory nothing{.fail_at = 1};
    plan_scratch data{nothing.source()};
    cap_builder caps, further;
    CHECK(with.raise.plan(region{}, data, {caps, further, with.cut}).error() == error::out_of_memory);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/embolden.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/impl/region_step_ref.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

TEST_CASE("an empty reference to a step is none, and has a key of its own", "[glyph]")
{
    const region_step_ref none;
    const embolden bolder, boldest{.by = 0.03f};
    const region_step_ref one{bolder}, other{boldest};
    CHECK(none.is_none());
    CHECK_FALSE(one.is_none());
    CHECK(none.key().type != nullptr);
    CHECK_FALSE(none.key() == one.key());
    CHECK_FALSE(one.key() == other.key());
    CHECK(one.key() == key_of(bolder));
    CHECK_FALSE(none.refused_options());
    CHECK_FALSE(one.refused_options());
    const embolden bad{.mitre_limit = 0.5f};
    CHECK(region_step_ref{bad}.refused_options() == error::bad_option);
}

TEST_CASE("a step reports a lack of memory for its scratch", "[glyph]")
{
    const embolden bolder;
    test::counting_memory nothing{.fail_at = 1};
    plan_scratch scratch{nothing.source()};
    cap_builder caps, further;
    const monotone cut;
    region_caps maker{caps, further, cut};
    CHECK(region_step_ref{bolder}(region{}, scratch, maker).error() == error::out_of_memory);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/glyph/impl/outline_step_ref.hpp>

using namespace typemesh;

TEST_CASE("an empty reference to an outline step is none and refuses nothing", "[glyph][warp]")
{
    const box text_of_steps{{-1.0, 0.0}, {4.0, 0.0}};
    const outline_step_ref none;
    const warped<arc> round{{.degrees = 400.0}}, fair;
    CHECK(none.is_none());
    CHECK_FALSE(none.refused({}));
    const outline_step_ref one{round}, other{fair};
    CHECK_FALSE(one.is_none());
    CHECK(one.refused(text_of_steps) == error::goes_around);
    CHECK_FALSE(other.refused(text_of_steps));
    outline drawn, out;
    const auto rest = other(drawn, {}, 0.25, 10, out);
    REQUIRE(rest);
    CHECK(*rest == 0.25);
}

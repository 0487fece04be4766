// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/typemesh.hpp>

#include <vector>

using namespace typemesh;

namespace {

/// Cannot be copied: it writes down what it is passed.
struct stage_list {
    std::vector<stage> seen;

    stage_list() = default;
    stage_list(const stage_list&) = delete;
    void operator()(stage now) noexcept { seen.push_back(now); }
};

}  // namespace

TEST_CASE("policies refer to the objects that they are made of", "[glyph]")
{
    const certified flatten;
    const monotone cut;
    const extruded<> raise{.depth = 0.5f};
    stage_list observe;
    const policies with{flatten, cut, raise, observe};
    CHECK(with.flatten.key() == key_of(flatten));
    CHECK(with.cut.key() == key_of(cut));
    CHECK(with.raise.key() == key_of(raise));
    CHECK(with.raise.heights().low == raise.heights().low);

    test::toy_font font;
    glyph_builder builder;
    REQUIRE(builder.build(font, 2, {.tolerance = 0.01}, with));
    CHECK(observe.seen == std::vector{stage::outline, stage::discretise, stage::triangulate, stage::extrude});
}

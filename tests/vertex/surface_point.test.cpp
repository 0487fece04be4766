// SPDX-License-Identifier: MIT

#include <typemesh/vertex/surface_point.hpp>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

template <attribute Wants>
concept tells_uv = requires(const surface_point<Wants>& s)
{
    s.uv.x;
};

template <attribute Wants>
concept tells_position = requires(const surface_point<Wants>& s)
{
    s.position.x;
};

}  // namespace

static_assert(tells_uv<attribute::uv>);
static_assert(tells_uv<attribute::position | attribute::uv>);
static_assert(!tells_uv<attribute::position | attribute::normal>);
static_assert(!tells_position<attribute::none>);
static_assert(sizeof(surface_point<attribute::position | attribute::normal | attribute::uv>) == 32);

TEST_CASE("a set of attributes holds what was put into it", "[vertex]")
{
    constexpr attribute two = attribute::position | attribute::uv;
    CHECK(has(two, attribute::position));
    CHECK(has(two, attribute::uv));
    CHECK_FALSE(has(two, attribute::normal));
    CHECK_FALSE(has(attribute::none, attribute::position));
}

TEST_CASE("a point with fewer attributes keeps those it has", "[vertex]")
{
    const surface_point<attribute::position | attribute::normal | attribute::uv> full{{1, 2, 3}, {0, 1, 0}, {4, 5}};
    CHECK(only<attribute::position>(full).position == vec3{1, 2, 3});
    CHECK(only<attribute::uv>(full).uv == vec2{4, 5});
    const auto both = only<attribute::normal | attribute::uv>(full);
    CHECK(both.normal == vec3{0, 1, 0});
    CHECK(both.uv == vec2{4, 5});
}

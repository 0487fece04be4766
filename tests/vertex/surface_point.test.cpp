// SPDX-License-Identifier: MIT

#include <typemesh/vertex/surface_point.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

template <attribute Wants>
concept tells_uv = requires(const surface_point<Wants>& s) { s.uv.x; };

template <attribute Wants>
concept tells_position = requires(const surface_point<Wants>& s) { s.position.x; };

}  // namespace

static_assert(tells_uv<attribute::uv>);
static_assert(tells_uv < attribute::position | attribute::uv >);
static_assert(!tells_uv < attribute::position | attribute::normal >);
static_assert(!tells_position<attribute::none>);
// A point is as large as what it holds, for every set of attributes: 12 + 12 + 8 + 16 + 12 + 4 + 4 + 4 + 1 bytes, the last
// filled up to 4.
template <std::uint32_t Set>
constexpr bool takes_no_more_room_than_wanted()
{
    constexpr auto wants = static_cast<attribute>(Set);
    constexpr std::size_t bytes = (has(wants, attribute::position) ? 12u : 0u) +
                                  (has(wants, attribute::normal) ? 12u : 0u) + (has(wants, attribute::uv) ? 8u : 0u) +
                                  (has(wants, attribute::tangent) ? 16u : 0u) +
                                  (has(wants, attribute::curve) ? 12u : 0u) + (has(wants, attribute::glyph) ? 4u : 0u) +
                                  (has(wants, attribute::cluster) ? 4u : 0u) +
                                  (has(wants, attribute::style) ? 4u : 0u) + (has(wants, attribute::part) ? 4u : 0u);
    constexpr bool lonely_part = wants == attribute::part;
    static_assert(std::is_trivially_copyable_v<surface_point<wants>>);
    return sizeof(surface_point<wants>) == (bytes == 0 || lonely_part ? 1 : bytes);
}
template <std::uint32_t First>
constexpr bool takes_no_more_from = []<std::uint32_t... Sets>(std::integer_sequence<std::uint32_t, Sets...>) {
    return (takes_no_more_room_than_wanted<First + Sets>() && ...);
}(std::make_integer_sequence<std::uint32_t, 128>{});
static_assert(takes_no_more_from<0> && takes_no_more_from<128> && takes_no_more_from<256> && takes_no_more_from<384>);
// Letter data come in addition: 4 + 4 + 4 + 12 + 12 bytes.
constexpr attribute few = attribute::position | attribute::part;
static_assert(sizeof(surface_point<attribute::letter>) == 4 && sizeof(surface_point<attribute::extent>) == 12);
static_assert(sizeof(surface_point < few | attribute::word | attribute::pivot >) == 16 + 4 + 12);
static_assert(sizeof(surface_point < few | letter_attributes >) == 16 + 36);

TEST_CASE("a set of attributes contains the attributes that were added", "[vertex]")
{
    constexpr attribute two = attribute::position | attribute::uv;
    CHECK(has(two, attribute::position));
    CHECK(has(two, attribute::uv));
    CHECK_FALSE(has(two, attribute::normal));
    CHECK_FALSE(has(attribute::none, attribute::position));
}

TEST_CASE("a point with fewer attributes keeps the attributes that it has", "[vertex]")
{
    surface_point<static_cast<attribute>(511)> full;
    full.position = {1, 2, 3};
    full.normal = {0, 1, 0};
    full.uv = {4, 5};
    full.tangent = {1, 0, 0, -1};
    full.curve = {9, 10, 11};
    full.glyph = 6;
    full.cluster = 7;
    full.part = part::side;
    full.style = style_id{8};
    CHECK(only<attribute::position>(full).position == vec3{1, 2, 3});
    CHECK(only<attribute::uv>(full).uv == vec2{4, 5});
    CHECK(only<attribute::curve>(full).curve == vec3{9, 10, 11});
    const auto both = only < attribute::normal | attribute::uv > (full);
    CHECK(both.normal == vec3{0, 1, 0});
    CHECK(both.uv == vec2{4, 5});
    const auto five =
        only < attribute::tangent | attribute::glyph | attribute::cluster | attribute::part | attribute::style > (full);
    CHECK(five.tangent == vec4{1, 0, 0, -1});
    CHECK(five.glyph == 6);
    CHECK(five.cluster == 7);
    CHECK(five.part == part::side);
    CHECK(five.style == style_id{8});
}

TEST_CASE("a point belongs to no glyph, no cluster and no style by default", "[vertex]")
{
    const surface_point<attribute::glyph | attribute::cluster | attribute::style> unnamed;
    CHECK(unnamed.style == no_style);
    CHECK(unnamed.glyph == no_glyph);
    CHECK(unnamed.cluster == no_cluster);
}

TEST_CASE("a point lies inside of every curve by default", "[vertex]")
{
    const surface_point<attribute::curve> inside;
    CHECK(inside.curve == vec3{-1, 0, 0});
}

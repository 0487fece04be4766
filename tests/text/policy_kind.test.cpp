// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <type_traits>
#include <utility>

using namespace typemesh;

namespace {

struct nothing {};

struct cuts_and_observes {
    error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        return monotone{}(r, space, out);
    }
    void operator()(stage) const noexcept {}
};

struct throwing_observer {
    void operator()(stage) const {}
};

template <class Policy>
using with_policy = decltype(std::declval<text_mesher<test::toy_font>>().with(std::declval<Policy>()));

template <class D, class T, class E, class O, class C>
using mesher_of = text_mesher<test::toy_font, D, T, E, O, C>;

}  // namespace

TEST_CASE("a policy is what its one concept says", "[text][policies]")
{
    const auto observer = [](stage) noexcept {};
    const auto anything = [](auto&&...) noexcept {};
    STATIC_REQUIRE(kind_of<certified>() == policy_kind::discretiser);
    STATIC_REQUIRE(kind_of<two_lines>() == policy_kind::discretiser);
    STATIC_REQUIRE(kind_of<monotone>() == policy_kind::triangulator);
    STATIC_REQUIRE(kind_of<constrained_delaunay>() == policy_kind::triangulator);
    STATIC_REQUIRE(kind_of<flat>() == policy_kind::extruder);
    STATIC_REQUIRE(kind_of<extruded<shared_normals>>() == policy_kind::extruder);
    STATIC_REQUIRE(kind_of<no_observer>() == policy_kind::observer);
    STATIC_REQUIRE(kind_of<decltype(observer)>() == policy_kind::observer);
    STATIC_REQUIRE(kind_of<no_cache>() == policy_kind::cache);
    STATIC_REQUIRE(kind_of<cached_in<no_lock>>() == policy_kind::cache);

    STATIC_REQUIRE(kind_of<nothing>() == policy_kind::none);
    STATIC_REQUIRE(kind_of<throwing_observer>() == policy_kind::none);
    STATIC_REQUIRE(kind_of<decltype(anything)>() == policy_kind::several);
    STATIC_REQUIRE(kind_of<cuts_and_observes>() == policy_kind::several);
}

TEST_CASE("with() exchanges the policy of that kind and no other", "[text][policies]")
{
    using mesher = mesher_of<certified, monotone, extruded<>, no_observer, no_cache>;
    STATIC_REQUIRE(std::is_same_v<mesher, text_mesher<test::toy_font>>);
    STATIC_REQUIRE(
        std::is_same_v<with_policy<two_lines>, mesher_of<two_lines, monotone, extruded<>, no_observer, no_cache>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<constrained_delaunay>,
                                  mesher_of<certified, constrained_delaunay, extruded<>, no_observer, no_cache>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<flat>, mesher_of<certified, monotone, flat, no_observer, no_cache>>);
    const auto observer = [](stage) noexcept {};
    using observing = std::remove_const_t<decltype(observer)>;
    STATIC_REQUIRE(
        std::is_same_v<with_policy<observing>, mesher_of<certified, monotone, extruded<>, observing, no_cache>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<cached_in<no_lock>>,
                                  mesher_of<certified, monotone, extruded<>, no_observer, cached_in<no_lock>>>);
}

TEST_CASE("what is nearly a policy is known for the one that it was meant to be", "[text][policies]")
{
    STATIC_REQUIRE(detail::nearly_observer<throwing_observer>);
    STATIC_REQUIRE(!detail::nearly_discretiser<throwing_observer>);
    STATIC_REQUIRE(!detail::nearly_triangulator<throwing_observer>);
    STATIC_REQUIRE(!detail::nearly_extruder<throwing_observer>);
    STATIC_REQUIRE(detail::nearly_discretiser<certified>);
    STATIC_REQUIRE(detail::nearly_triangulator<monotone>);
    STATIC_REQUIRE(detail::nearly_extruder<flat>);
    STATIC_REQUIRE(!detail::nearly_observer<nothing>);
}

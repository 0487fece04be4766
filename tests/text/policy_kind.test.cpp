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
using with_policy = decltype(std::declval<text_mesher<>>().with(std::declval<Policy>()));

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
    STATIC_REQUIRE(kind_of<cached_in>() == policy_kind::cache);

    STATIC_REQUIRE(kind_of<nothing>() == policy_kind::none);
    STATIC_REQUIRE(kind_of<throwing_observer>() == policy_kind::none);
    STATIC_REQUIRE(kind_of<decltype(anything)>() == policy_kind::several);
    STATIC_REQUIRE(kind_of<cuts_and_observes>() == policy_kind::several);
}

TEST_CASE("the type of a mesher names its solid and nothing else", "[text][policies]")
{
    test::toy_font font;
    const auto observer = [](stage) noexcept {};
    using observing = std::remove_const_t<decltype(observer)>;
    STATIC_REQUIRE(std::is_same_v<decltype(text_mesher{font}), text_mesher<extruded<>>>);
    STATIC_REQUIRE(std::is_same_v<decltype(text_mesher{font, two_lines{}, heap()}), text_mesher<>>);
    STATIC_REQUIRE(std::is_same_v<decltype(text_mesher{font, two_lines{}, flat{}, heap()}), text_mesher<flat>>);
    STATIC_REQUIRE(std::is_same_v<decltype(text_mesher{}), text_mesher<>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<two_lines>, text_mesher<>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<constrained_delaunay>, text_mesher<>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<flat>, text_mesher<flat>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<observing>, text_mesher<>>);
    STATIC_REQUIRE(std::is_same_v<with_policy<cached_in>, text_mesher<>>);
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

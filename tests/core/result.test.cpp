// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/result.hpp>

#include <memory>
#include <type_traits>
#include <utility>

using namespace typemesh;

TEST_CASE("a result contains its value, or the error that prevented it", "[core][result]")
{
    const result<int> made = 7;
    REQUIRE(made);
    CHECK(*made == 7);
    CHECK(made.error() == error::none);

    const result<int> refused = error{error::no_such_face, 3};
    CHECK(!refused);
    CHECK(refused.error() == error::no_such_face);
    CHECK(refused.error().count == 3);
    CHECK(result<int>{error::bad_option}.error() == error::bad_option);
}

TEST_CASE("a result carries values that can only be moved", "[core][result]")
{
    result<std::unique_ptr<int>> made = std::make_unique<int>(5);
    REQUIRE(made);
    CHECK(*made->get() == 5);
    **made = 6;
    const std::unique_ptr<int> out = std::move(*made);
    CHECK(*out == 6);
    const std::unique_ptr<int> direct = *result<std::unique_ptr<int>>{std::make_unique<int>(8)};
    CHECK(*direct == 8);
}

// What treated an error as true when something was wrong does not compile.
static_assert(!std::is_convertible_v<result<void>, error> && !std::is_constructible_v<error, result<void>>);
static_assert(!std::is_constructible_v<bool, result<void>> && std::is_constructible_v<bool, result<void>&>);
static_assert(!std::is_convertible_v<result<void>&, bool>);

TEST_CASE("a result without a value is true if all is well, and and_then() stops at an error", "[core]")
{
    const result<void> good, also_good = error{}, bad = error::too_large;
    CHECK(good);
    CHECK(good.has_value());
    CHECK(also_good);
    CHECK(good == error::none);
    CHECK_FALSE(bad);
    CHECK(!bad);
    CHECK(bad == error::too_large);
    CHECK(bad.error() == error::too_large);
    CHECK_FALSE(result<void>{error::out_of_memory});
    int calls = 0;
    const auto next = [&]() noexcept -> result<void> { return ++calls, error::bad_outline; };
    CHECK(bad.and_then(next) == error::too_large);
    CHECK(calls == 0);
    CHECK(good.and_then(next) == error::bad_outline);
    CHECK(calls == 1);
    CHECK(*good.and_then([]() noexcept { return result<int>{3}; }) == 3);
}

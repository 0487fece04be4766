// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/result.hpp>

#include <memory>
#include <utility>

using namespace typemesh;

TEST_CASE("a result holds its value or the error that kept it from being made", "[core][result]")
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

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/impl/taken.hpp>

#include <memory>

using namespace typemesh;

TEST_CASE("taken() leaves the default of its type", "[core][taken]")
{
    int number = 7;
    CHECK(taken(number) == 7);
    CHECK(number == 0);

    int* pointer = &number;
    CHECK(taken(pointer) == &number);
    CHECK(pointer == nullptr);

    auto owner = std::make_unique<int>(3);
    const std::unique_ptr<int> other = taken(owner);
    CHECK(owner == nullptr);
    CHECK(*other == 3);
}

TEST_CASE("swap_values() exchanges values that can only be moved", "[core][taken]")
{
    auto a = std::make_unique<int>(1), b = std::make_unique<int>(2);
    swap_values(a, b);
    CHECK(*a == 2);
    CHECK(*b == 1);
    swap_values(a, a);
    CHECK(*a == 2);
}

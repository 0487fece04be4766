// SPDX-License-Identifier: MIT

#include <typemesh/outline/impl/path_numbers.hpp>

#include <limits>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("powers of ten are exact as far as doubles have them", "[outline][svg]")
{
    double power = 1.0;
    for (int e = 0; e <= 22; ++e, power *= 10.0) CHECK(detail::power_of_ten(e) == power);
    CHECK(detail::power_of_ten(300) == Approx(1e300));
    CHECK(detail::power_of_ten(400) > (std::numeric_limits<double>::max)());
}

TEST_CASE("numbers, commas and flags are read one after the other", "[outline][svg]")
{
    detail::path_numbers in{"-1.5.25 , 3e2 01x"};
    double value = 0.0;
    REQUIRE(in.read(value));
    CHECK(value == -1.5);
    REQUIRE(in.read(value));
    CHECK(value == 0.25);
    CHECK(in.skip_comma());
    REQUIRE(in.read(value));
    CHECK(value == 300.0);
    CHECK(!in.skip_comma());
    bool flag = true;
    REQUIRE(in.read_flag(flag));
    CHECK(!flag);
    REQUIRE(in.read_flag(flag));
    CHECK(flag);
    CHECK(!in.read_flag(flag));
    CHECK(!in.read(value));
    CHECK(in.place() == 16);
    CHECK(in.next() == 'x');
}

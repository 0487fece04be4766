// SPDX-License-Identifier: MIT
#include <typemesh/outline/impl/fixed_point.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("numbers with a fixed number of digits are those of printf", "[outline]")
{
    for (int decimals = 0; decimals <= 9; ++decimals) {
        detail::fixed_point numbers{decimals};
        std::uint64_t state = 1;
        for (std::uint64_t i = 1; i < 400; ++i) {
            state = state * 6364136223846793005u + i;
            const auto number = static_cast<std::int64_t>((state >> 8) % 999'999'999'999'999u);
            const std::int64_t n = i % 2 == 0 ? number : -number >> (i % 40);
            const std::string all{numbers.text(n, true)};
            char wanted[64];
            const std::int64_t scale = static_cast<std::int64_t>(std::pow(10.0, decimals)), size = n < 0 ? -n : n;
            if (decimals > 0)
                std::snprintf(wanted, sizeof wanted, "%s%lld.%0*lld", n < 0 ? "-" : "",
                              static_cast<long long>(size / scale), decimals, static_cast<long long>(size % scale));
            else
                std::snprintf(wanted, sizeof wanted, "%lld", static_cast<long long>(n));
            CHECK_QUICKLY(all == wanted);
            const std::string few{numbers.text(n, false)};
            CHECK_QUICKLY(all.starts_with(few));
            CHECK_QUICKLY(all.find_first_not_of("0.", few.size()) == std::string::npos);
            CHECK_QUICKLY((decimals == 0 || n == 0 || few.find('.') == std::string::npos || few.back() != '0'));
            std::int64_t again = 0;
            CHECK_QUICKLY(numbers.round(std::strtod(few.c_str(), nullptr), again) == error::none);
            CHECK_QUICKLY(again == n);
        }
    }
}

TEST_CASE("numbers that have no text are refused", "[outline]")
{
    detail::fixed_point numbers{3};
    std::int64_t number = 7;
    CHECK(numbers.round(std::nan(""), number) == error::outline_not_finite);
    CHECK(numbers.round(1e308, number) == error::outline_not_finite);
    CHECK(numbers.round(1e12, number) == error::too_large);
    CHECK(number == 7);
    CHECK(numbers.round(0.0005, number) == error::none);
    CHECK(number == 1);
    CHECK(std::string{numbers.text(-1, false)} == "-0.001");
    CHECK(std::string{numbers.text(0, true)} == "0.000");
    CHECK(std::string{numbers.text(-12000, false)} == "-12");
}

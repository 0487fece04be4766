// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/collapse.hpp>

#include "support/catch.hpp"

#include <vector>

using namespace typemesh;
using detail::collapse;
using kind = detail::collapse::kind;

TEST_CASE("collapses are sorted by time, lengths before triangles, then longest first", "[offset][collapse]")
{
    constexpr std::int64_t step = std::int64_t{1} << 20;  // the resolution of times: 1/4096 cell
    const std::vector<collapse> ordered{
        {5 * step - 1, 9, 0, kind::turn, 0, 1},    {5 * step, 3, 0, kind::close_up, 0, 0},
        {5 * step, 4, 0, kind::shrink, 0, 0},      {5 * step, 5, 0, kind::close_up, 0, 0},
        {6 * step - 1, 8, 0, kind::meet, 0, 900},  // later, but longer than the next ones
        {5 * step + 1, 6, 0, kind::turn, 0, 800},  {5 * step, 7, 0, kind::meet, 0, 800},
        {5 * step + 9, 2, 0, kind::turn, 0, 0},    {6 * step, 1, 0, kind::shrink, 0, 0},
        {1000 * step, 0, 0, kind::turn, 0, 5'000},
    };
    for (std::size_t i = 0; i < ordered.size(); ++i)
        for (std::size_t j = 0; j < ordered.size(); ++j) CHECK((ordered[i] < ordered[j]) == (i < j));
}

TEST_CASE("the order of collapses ignores stamp and corner", "[offset][collapse]")
{
    const collapse a{5, 3, 1, kind::meet, 0, 7}, b{5, 3, 2, kind::meet, 2, 7};
    CHECK_FALSE(a < b);
    CHECK_FALSE(b < a);
}

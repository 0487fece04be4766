// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/wall_rows.hpp>

#include <cmath>
#include <initializer_list>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("rows lie at equal distances, exactly at both ends, and a centred solid's rows are symmetric", "[wall_rows]")
{
    for (const float depth : {0.2f, 1.0f, 0.3333333f, 1e-7f, 12345.678f})
        for (const bool centred : {false, true})
            for (const std::uint32_t segments : {1u, 2u, 3u, 5u, 7u, 64u, 1000u, 1023u, 1024u}) {
                CAPTURE(depth, centred, segments);
                const double top = centred ? 0.5 * double(depth) : 0.0, bottom = top - double(depth);
                const wall_rows rows{top, bottom, segments};
                REQUIRE(rows.height(0) == top);
                REQUIRE(rows.height(segments) == bottom);
                std::uint32_t uneven = 0, rising = 0, askew = 0;
                for (std::uint32_t k = 1; k <= segments; ++k) {
                    const double expected = top - double(depth) * k / segments;
                    uneven += std::abs(rows.height(k) - expected) > 0x1p-50 * double(depth);
                    rising += rows.height(k) >= rows.height(k - 1);
                    askew += centred && rows.height(k) != -rows.height(segments - k);  // NOLINT: to the bit
                }
                CHECK(uneven == 0);
                CHECK(rising == 0);
                CHECK(askew == 0);
            }
}

TEST_CASE("walls have 1 to 1024 segments", "[wall_rows]")
{
    for (const std::uint32_t segments : {1u, 2u, 1023u, 1024u}) CHECK(wall_rows::is_valid(segments));
    for (const std::uint32_t segments : {0u, 1025u, 0x8000'0001u, 0xFFFF'FFFFu})
        CHECK_FALSE(wall_rows::is_valid(segments));
}

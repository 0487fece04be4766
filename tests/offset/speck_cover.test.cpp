// SPDX-License-Identifier: MIT

#include <typemesh/offset/speck_cover.hpp>

#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"
#include "support/swept_laws.hpp"

#include <cstdint>

using namespace typemesh;

namespace {

/// A square, and the slivers between two circles that differ by a cell or two.
test::shape square_with_slivers(int seed)
{
    test::dice d{static_cast<std::uint64_t>(seed)};
    const int n = 90 + d.roll(300);
    const double radius = 2e5 + d.roll(100'000);
    return {"square with slivers",
            {test::square(-1'000'000, -1'000'000, 400'000), test::circle(n, radius),
             test::reversed(test::circle(n + d.roll(3), radius + d.roll(3) - 1, d.roll(5) - 2, d.roll(5) - 2))}};
}

struct swept_slivers {
    workspace space;
    contours loops;
    region filled;
    triangle_list triangles;
    swept_region out;
    error failed;

    swept_slivers(const test::shape& s, std::span<const double> levels, memory source = heap(), bool only_cap = false)
        : space{source}, loops{test::contours_of(s)}, out{source}
    {
        workspace own;
        const auto made = fill(loops, fill_rule::non_zero, own);
        REQUIRE(made);
        filled = *made;
        REQUIRE(!monotone{}(filled, own, triangles));
        workspace::scope scratch{space};
        sweep_options how{.levels = levels};
        how.only_cap = only_cap;
        failed = sweep_inwards(filled, triangles.view(), how, scratch, out);
    }
};

}  // namespace

TEST_CASE("slivers that cannot be cut on the grid get their own triangles, and the rest is swept",
          "[offset][speck_cover]")
{
    constexpr double levels[] = {0.0, 1000.0, 50'000.0};
    std::size_t covered = 0;
    for (int seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        const swept_slivers s{square_with_slivers(seed), levels};
        REQUIRE(!s.failed);
        const test::swept_laws laws{s.filled, s.out};
        CHECK(laws.broken() == "");
        CHECK(s.out.lost + 1 >= s.filled.loop_count() / 2);
        const swept_slivers square{{"square", {test::square(-1'000'000, -1'000'000, 400'000)}}, levels};
        CHECK(inspect::doubled_area(region::proven(s.out.cap, 0, 0)) ==
              inspect::doubled_area(region::proven(square.out.cap, 0, 0)));
        for (std::size_t i = 0; i + 1 < s.out.cells.size() && s.out.cells[i].band == 0; ++i) {
            const triangle& t = s.out.triangles[s.out.cells[i].first_triangle];
            const auto n = s.filled.points().size();
            covered +=
                s.out.cells[i + 1].first_triangle == s.out.cells[i].first_triangle + 1 && t.a < n && t.b < n && t.c < n;
        }
        const swept_slivers cap{square_with_slivers(seed), levels, heap(), true};
        CHECK(!cap.failed);
        CHECK(cap.out.cap.points.size() == s.out.cap.points.size());
    }
    CHECK(covered > 100);
}

TEST_CASE("a cover reports that memory ran out", "[offset][speck_cover]")
{
    constexpr double levels[] = {0.0, 50'000.0};
    const test::shape s = square_with_slivers(1);
    test::counting_memory counted;
    REQUIRE(!swept_slivers{s, levels, counted.source()}.failed);
    for (std::size_t at = 1; at < counted.requests; ++at) {  // the last is the one block of a warm workspace
        test::counting_memory limited{.fail_at = at};
        CHECK(swept_slivers{s, levels, limited.source()}.failed.code == error::out_of_memory);
    }
}

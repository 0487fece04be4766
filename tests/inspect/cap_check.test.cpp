// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/cap_check.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <string>
#include <utility>
#include <vector>

using namespace typemesh;
using inspect::cap_check;

namespace {

/// A square with a hole, filled and cut: 8 triangles.
struct ring {
    contours loops = test::contours_of(test::square_with_holes(1, 4));
    workspace space;
    region filled;
    std::vector<triangle> cut;

    ring()
    {
        const auto r = fill(loops, fill_rule::non_zero, space);
        REQUIRE(r);
        filled = *r;
        triangle_list out;
        REQUIRE_FALSE(monotone{}(filled, space, out));
        cut.assign(out.begin(), out.end());
    }
    [[nodiscard]] cap_check check() const { return inspect::check_cap(filled, cut); }
    [[nodiscard]] std::string broken() const { return check().broken(); }
};

}  // namespace

TEST_CASE("a cap that covers its region passes, and each planted fault is found", "[inspect]")
{
    const ring right;
    CHECK(right.broken() == "");
    CHECK(right.check().wanted == 8);
    for (std::size_t t = 0; t < 8; ++t) {
        ring missing;
        missing.cut.erase(missing.cut.begin() + static_cast<std::ptrdiff_t>(t));
        CHECK(missing.broken() == "not n + 2h - 2c triangles");
        CHECK(missing.check().doubled_excess < 0);
        CHECK(missing.check().uncovered_edges + missing.check().open_edges > 0);
        ring turned;
        std::swap(turned.cut[t].a, turned.cut[t].b);
        CHECK(turned.broken() == "a triangle is not strictly counter-clockwise");
        ring flat;
        flat.cut[t].a = flat.cut[t].b;
        CHECK(flat.check().turned == 1);
        ring wild;
        wild.cut[t].c = 8;
        CHECK(wild.broken() == "a corner is not a point of the region");
        ring twice;
        twice.cut[t] = twice.cut[(t + 1) % 8];
        CHECK_FALSE(twice.broken().empty());
        CHECK(twice.check().repeated_edges == 3);
    }

    // The diagonal of a quadrilateral exchanged is no fault here; a triangle across the hole is.
    ring across;
    across.cut = {{0, 1, 2},    {0, 2, 3},    right.cut[2], right.cut[3],
                  right.cut[4], right.cut[5], right.cut[6], right.cut[7]};
    CHECK_FALSE(across.broken().empty());
    CHECK(across.check().doubled_excess != 0);

    const region miscounted = region::proven(right.loops, 0, 1);
    CHECK(std::string{inspect::check_cap(miscounted, right.cut).broken()} == "holes and outer loops are miscounted");
}

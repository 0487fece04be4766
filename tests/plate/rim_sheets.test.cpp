// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/plate/impl/rim_offset.hpp>
#include <typemesh/plate/impl/rim_sheets.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "plate/rim_boxes.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <cstdint>

using namespace typemesh;
using detail::rim_offset;
using detail::rim_section;
using detail::rim_sheets;

TEST_CASE("the strips of a sheet reach both heights to the bit, with the circle's normals", "[rim_sheets]")
{
    test::rim_boxes boxes;
    contours loops;
    rim_offset made;
    rim_sheets sheets;
    const auto box = boxes.cells.trace(test::rim_boxes::plate, boxes.space, loops);
    REQUIRE(box);
    for (const rim_section section : {rim_section::chamfer, rim_section::round, rim_section::fillet}) {
        REQUIRE(made.plan(*box, section, 0.1f, 1.0, monotone{}));
        sheets.clear();
        CHECK_FALSE(sheets.add(made, {3, section, true, 0.3f, 0.7f}));
        REQUIRE(sheets.all().size() == 1);
        const rim_sheets::sheet& s = sheets.all()[0];
        std::size_t lower = 0, upper = 0, wrong = 0;
        for (const rim_sheets::vertex& v : sheets.vertices(s)) {
            const float z = rim_sheets::height(s, v);
            lower += same(z, 0.3f);
            upper += same(z, 0.7f);
            wrong += z < 0.3f || z > 0.7f;
            // The circle has its centre at the wall's foot for a bevel, above the floor's edge for a fillet.
            const double t = as_double(v.t), h = as_double(v.h), out = as_double(v.out), up = as_double(v.up);
            const double root = std::sqrt(0.5);
            const bool fillet = section == rim_section::fillet;
            const double x = section == rim_section::chamfer ? root : fillet ? t : 1.0 - t;
            const double y = section == rim_section::chamfer ? root : fillet ? 1.0 - h : h;
            // Points within four cells of an end are moved to it.
            wrong += std::fabs(out - x) > 0.04 || std::fabs(up - y) > 0.04;
            wrong += std::fabs(out * out + up * up - 1.0) > 1e-6;
        }
        CHECK(lower >= 4);
        CHECK(upper >= 4);
        CHECK(wrong == 0);
        // A chamfer leaves a frustum of a pyramid.
        const double outer = 1000.0 * 1000.0, inner = 800.0 * 800.0;
        if (section == rim_section::chamfer)
            CHECK(sheets.volume(s) == Catch::Approx((outer + inner + 1000.0 * 800.0) / 3.0 - inner));
    }
}

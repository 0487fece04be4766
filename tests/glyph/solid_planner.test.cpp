// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/embolden.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/solid_planner.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

namespace {

/// A ring of the toy font, 500 units high, and its caps.
struct ring {
    outline drawn;
    cap_builder caps;
    region filled;

    explicit ring(const policies& with)
    {
        test::toy_font font;
        REQUIRE(record(font, 1, drawn));
        const auto cells = grid::fitting(1000.0, drawn.bounds);
        REQUIRE(cells);
        const auto made = caps.build(drawn, 1.0, *cells, {}, with);
        REQUIRE(made);
        filled = *made;
    }
};

}  // namespace

TEST_CASE("without a step the draft has the region's own points, and parted corners are counted", "[glyph]")
{
    no_observer nobody;
    const policies with{certified{}, monotone{}, flat{}, nobody};
    ring r{with};
    solid_planner planner;
    corner_parting parted;
    parted.corners = 3;
    parted.still_touching = true;
    const auto made = planner.plan({r.filled, r.caps.triangles(), parted}, r.caps, with);
    REQUIRE(made);
    CHECK(made->draft.form.points.data() == r.filled.points().data());
    CHECK(made->draft.form.triangles.size() == r.filled.triangle_count());
    CHECK(made->draft.drawn.points.empty());
    CHECK_FALSE(made->draft.merged_as_drawn);
    CHECK(made->draft.plan.corners_moved == 3);
    CHECK(made->draft.plan.touching);
}

TEST_CASE("after a step the draft has the new region's points, and refers to the drawn region", "[glyph]")
{
    no_observer nobody;
    for (const float by : {0.02f, -0.02f}) {
        const embolden step{.by = by};
        const certified flatten;
        const monotone cut;
        const flat raise;
        const policies with{flatten, cut, raise, nobody, step};
        ring r{with};
        solid_planner planner;
        const auto made = planner.plan({r.filled, r.caps.triangles(), {}}, r.caps, with);
        REQUIRE(made);
        CHECK(made->draft.form.points.data() == made->filled.points().data());
        CHECK(made->draft.form.triangles.size() == made->filled.triangle_count());
        CHECK(made->draft.drawn.points.data() == r.filled.points().data());
        CHECK(made->draft.merged_as_drawn == (by < 0.0f));

        std::vector<std::uint64_t> block(built_glyph::bytes_for(made->draft) / 8 + 1);
        const built_glyph& kept = *built_glyph::make(block.data(), made->draft);
        CHECK(kept.merged_as_drawn().points.size() == (by < 0.0f ? r.filled.points().size() : 0));
        const double wider = 2.0 * static_cast<double>(by) * 1000.0;
        CHECK(kept.ink().width() - r.drawn.bounds.width() == Catch::Approx(wider).margin(2.0));
        planner.trim();
    }
}

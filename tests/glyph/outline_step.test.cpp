// SPDX-License-Identifier: MIT

#include <typemesh/extrude/flat.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/outline_step.hpp>
#include <typemesh/typemesh.hpp>

#include <cstring>
#include <vector>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

/// A step that moves every outline to the right by its place in the text, and leaves half of the tolerance.
struct moved_right {
    result<double> operator()(const outline& drawn, const drawn_place& at, double tolerance, std::uint32_t,
                              outline& out) const noexcept
    {
        for (curve c : drawn.curves) {
            for (point& p : c.p) p = p + (1.0 / at.em_per_unit) * at.origin;
            if (!out.curves.push_back(c)) return error::out_of_memory;
        }
        if (!out.starts.append(drawn.starts.view())) return error::out_of_memory;
        out.bounds = drawn.bounds;
        out.bounds.high = out.bounds.high + (1.0 / at.em_per_unit) * at.origin;
        out.rule = drawn.rule;
        return 0.5 * tolerance;
    }
    [[nodiscard]] error refused(const box&) const noexcept { return {}; }
};
static_assert(outline_step<moved_right> && !outline_step<no_outline_step> && !outline_step<flat>);

std::vector<grid_point> points_with(const outline_step_ref& step, const solid_place& place)
{
    test::toy_font font;
    static const certified flatten;
    static const monotone cut;
    static const flat raise;
    static no_observer nobody;
    glyph_builder builder;
    const auto draft = builder.build(font, test::toy_font::glyph_of('o'), {.tolerance = 0.01},
                                     policies{flatten, cut, raise, nobody, {}, step}, place);
    REQUIRE(draft);
    REQUIRE_FALSE(draft->refusal);
    return {draft->form.points.begin(), draft->form.points.end()};
}

}  // namespace

TEST_CASE("a step gets each outline at its place, and what it makes is flattened more finely", "[glyph][warp]")
{
    const auto plain = points_with({}, {{0.5, 0.0}, 1.0});
    const moved_right step;
    const auto there = points_with(step, {{0.5, 0.0}, 1.0}), here = points_with(step, {});
    CHECK(here.size() > plain.size());
    REQUIRE(there.size() == here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        CHECK(there[i].x - here[i].x == 256000);  // half an em of 1000 units of 512 cells
        CHECK(there[i].y == here[i].y);
    }
}

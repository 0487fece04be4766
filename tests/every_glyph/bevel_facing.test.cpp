// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/bevel_surface.hpp"
#include "support/catch.hpp"
#include "support/shape_file.hpp"

using namespace typemesh;

namespace {

/// The corners of a shape's bevel and walls that are lit from behind.
template <class Bevel>
std::size_t lit_from_behind(cap_builder& caps, const region& r, const Bevel& how)
{
    bevel_data data;
    cap_builder further;
    const monotone cut;
    region_caps maker{caps, further, cut};
    const auto plan = plan_solid(how, r, data, maker);
    REQUIRE(plan);
    placement at;
    at.unit_per_depth = r.grid().units_per_em * r.grid().cells;
    at.em_per_cell = 1.0 / at.unit_per_depth;
    test::bevel_surface mesh;
    mesh.sizes = plan->sizes;
    const solid_of<Bevel> form{{r.points(), r.starts(), caps.triangles().view()}, data.read()};
    REQUIRE(write_solid<Bevel>({form, *plan}, how, at, mesh));
    std::vector<bool> used(mesh.vertices.size());
    for (const std::uint32_t i : mesh.indices) used[i] = true;
    CHECK(std::all_of(used.begin(), used.end(), [](bool each) { return each; }));
    return mesh.lit_from_behind();
}

}  // namespace

TEST_CASE("no corner of a bevel is lit from behind, at any crease angle, profile or way", "[every_glyph]")
{
    for (const test::named_shape& s : test::shapes_of("shapes.txt")) {
        for (const double tolerance : {quality::normal, quality::high, quality::best}) {
            outline drawn;
            REQUIRE(record(s.font, 0, drawn));
            const auto cells = grid::fitting(s.font.units_per_em(), drawn.bounds);
            REQUIRE(cells);
            cap_builder caps;
            no_observer nobody;
            const auto made = caps.build(drawn, tolerance * s.font.units_per_em(), *cells, {drawn.rule},
                                         policies{certified{}, monotone{}, flat{}, nobody});
            REQUIRE(made);
            for (const float crease : {0.0f, 15.0f, 30.0f, 120.0f, 180.0f}) {
                for (const float width : {0.01f, 0.05f, 0.1f}) {
                    for (const bool outward : {false, true}) {
                        INFO(s.name << ", tolerance " << tolerance << ", crease angle " << crease << ", width " << width
                                    << (outward ? ", outward" : ""));
                        const bevelled chamfer{.width = width, .outward = outward, .crease_degrees = crease};
                        CHECK(lit_from_behind(caps, *made, chamfer) == 0);
                        const bevelled round{
                            .width = width, .outward = outward, .crease_degrees = crease, .profile = round_profile(4)};
                        CHECK(lit_from_behind(caps, *made, round) == 0);
                        const bevelled steps{.width = width,
                                             .outward = outward,
                                             .crease_degrees = crease,
                                             .profile_crease_degrees = 120.0f,
                                             .profile = {{0, 0}, {0.2f, 0.5f}, {0.2f, 0.8f}, {0.6f, 0.4f}, {1, 1}}};
                        CHECK(lit_from_behind(caps, *made, steps) == 0);
                    }
                }
            }
        }
    }
}

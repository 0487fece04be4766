// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/bevel_surface.hpp"
#include "support/catch.hpp"
#include "support/shape_file.hpp"
#include "support/solid_in_cells.hpp"

using namespace typemesh;

namespace {

/// The number of corners of a shape's bevel and walls that are lit from behind.
std::size_t lit_from_behind(cap_builder& caps, const region& r, const bevelled& how)
{
    bevel_data data;
    test::bevel_surface mesh;
    REQUIRE(test::write_in_cells(how, r, caps, test::em_of(r), data, mesh));
    std::vector<bool> used(mesh.vertices.size());
    for (const std::uint32_t i : mesh.indices) used[i] = true;
    CHECK(std::ranges::count(used, false) == 0);
    return mesh.lit_from_behind();
}

}  // namespace

TEST_CASE("no corner of a bevel is lit from behind, for any crease angle, profile and direction", "[every_glyph]")
{
    for (const test::named_shape& s : test::shapes_of("shapes.txt")) {
        for (const double tolerance : {quality::normal, quality::high, quality::best}) {
            outline drawn;
            REQUIRE(record(s.font, 0, drawn));
            cap_builder caps;
            const region made = test::region_of(caps, drawn, s.font.units_per_em(), tolerance);
            REQUIRE_FALSE(made.points().empty());
            for (const float crease : {0.0f, 15.0f, 30.0f, 120.0f, 180.0f}) {
                for (const float width : {0.01f, 0.05f, 0.1f}) {
                    for (const bool outward : {false, true}) {
                        INFO(s.name << ", tolerance " << tolerance << ", crease angle " << crease << ", width " << width
                                    << (outward ? ", outward" : ""));
                        bevelled how{.width = width, .outward = outward, .crease_degrees = crease};
                        CHECK(lit_from_behind(caps, made, how) == 0);
                        how.profile = round_profile(4);
                        CHECK(lit_from_behind(caps, made, how) == 0);
                        how.profile = {{0, 0}, {0.2f, 0.5f}, {0.2f, 0.8f}, {0.6f, 0.4f}, {1, 1}};  // with steps
                        how.profile_crease_degrees = 120.0f;
                        CHECK(lit_from_behind(caps, made, how) == 0);
                    }
                }
            }
        }
    }
}

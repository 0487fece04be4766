// SPDX-License-Identifier: MIT
//
// Bevels of a few glyphs of the smoke fonts; the program every_bevel takes all of them. And tests of the checkers, which
// must notice planted faults.

#include "bevel_laws.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/regions.hpp"
#include "support/shape_file.hpp"
#include "support/smoke_glyphs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// A ring of 100,000 cells to the em, with a chamfer.
struct bevelled_ring {
    std::vector<curve> curves;
    cap_builder caps;
    region of;
    test::bevel_surface mesh;

    bevelled_ring()
    {
        const std::vector<test::polyline> square_ring{test::square(0, 0, 100'000),
                                                      test::reversed(test::square(40'000, 40'000, 20'000))};
        caps.loops() = test::contours_of(square_ring);
        caps.loops().grid = {100.0, 1000.0};
        for (const test::polyline& l : square_ring)
            for (std::size_t i = 0; i < l.size(); ++i)
                curves.push_back(curve::from(placement::exact(l[i]), placement::exact(l[(i + 1) % l.size()])));
        caps.loops().curves = curves;
        const auto made = caps.fill({}, monotone{});
        REQUIRE(made);
        of = *made;
        const bevelled how{.width = 0.1f, .bevel_depth = 0.04f, .sides = bevel_sides::front};
        bevel_data data;
        REQUIRE(test::write_in_cells(how, of, caps, 100'000.0, data, mesh));
    }
    [[nodiscard]] std::string broken(const test::bevel_surface& m) const
    {
        return test::surface_laws{m, of, false}.broken();
    }
};

}  // namespace

TEST_CASE("every 3000th glyph of the smoke fonts has valid bevels at every width", "[every_glyph][bevel]")
{
    test::bevel_laws laws;
    std::size_t meshes = 0, narrowed = 0;
    test::each_smoke_glyph(3000, [&](auto& font, glyph_id g, const std::string& name) {
        laws.delaunay = g % 2 == 0;
        if (!laws.take(font, g, quality::high)) return;
        for (const double width : laws.widths) {
            const test::bevel_findings f = laws.examine(width);
            meshes += f.meshes;
            narrowed += f.narrowed;
            INFO(name << " at " << width);
            CHECK(f.wrong == "");
        }
    });
    CHECK(meshes > 1'500);
    CHECK(narrowed == 0);
}

TEST_CASE("icons whose chords turn by more than 90 degrees have valid bevels", "[every_glyph][bevel]")
{
    test::bevel_laws laws;
    for (const test::named_shape& s : test::shapes_of("shapes.txt")) {
        for (const double tolerance : {quality::low, quality::normal, quality::high}) {
            REQUIRE(laws.take(s.font, 0, tolerance));
            for (const double width : laws.widths) {
                INFO(s.name << " at " << width << ", tolerance " << tolerance);
                const test::bevel_findings f = laws.examine(width);
                CHECK(f.wrong == "");
                CHECK(f.narrowed == 0);
            }
        }
    }
}

TEST_CASE("bevels of letters have the volume and heights of the slow wavefront", "[every_glyph][bevel]")
{
    test::bevel_laws laws;
    laws.max_compared = 100;
    std::size_t compared = 0;
    for (const char* file : {"truetype/liberation/LiberationSerif-Regular.ttf", "truetype/dejavu/DejaVuSans.ttf"}) {
        auto font = harfbuzz_font::open(font_file(file).c_str());
        REQUIRE(font);
        for (glyph_id g = 36; g < 92; g += 11) {
            laws.delaunay = g % 2 == 0;
            REQUIRE(laws.take(*font, g, quality::normal));
            for (const double width : {0.01, 0.03, 0.1}) {
                INFO(file << ", glyph " << g << ", at " << width);
                const test::bevel_findings f = laws.examine(width);
                CHECK(f.wrong == "");
                CHECK(f.volume_error < 0.2);
                CHECK(f.height_error < 2.0);
                compared += f.compared;
            }
        }
    }
    CHECK(compared > 150);
}

TEST_CASE("surface_laws notice each fault of a bevelled mesh", "[every_glyph][bevel]")
{
    const bevelled_ring ring;
    REQUIRE(ring.broken(ring.mesh) == "");
    const auto bevels = ring.mesh.triangles_of(part::front_bevel), walls = ring.mesh.triangles_of(part::side);
    REQUIRE(bevels.end > bevels.begin);
    const auto with = [&](auto&& fault) {
        test::bevel_surface m = ring.mesh;
        fault(m, &m.indices[3 * bevels.begin], m.vertices[m.indices[3 * walls.begin]]);
        return ring.broken(m);
    };
    using indices = std::uint32_t*;
    using mesh = test::bevel_surface;

    const std::string turned = "a triangle of a cap or bevel is flat or turned over";
    CHECK(with([](mesh&, indices t, vec3&) { std::swap(t[0], t[1]); }) == turned);
    CHECK(with([](mesh&, indices t, vec3&) { t[0] = t[1]; }) == turned);
    CHECK(with([](mesh&, indices t, vec3&) { std::copy_n(t, 3, t + 3); }) != "");
    CHECK(with([](mesh& m, indices t, vec3&) {
              vec3& n = m.normals[t[1]];
              n = {-n.x, -n.y, 0.0f};
          }) == "a normal is 90 degrees or more off its face");
    CHECK(with([](mesh&, indices, vec3& foot) { foot.x += 1.0f, foot.y += 1.0f; }) == "a wall is not upright");
    CHECK(with([](mesh& m, indices t, vec3&) { m.vertices[t[0]].z -= 1.0f; }) == "the mesh is not closed");
    CHECK(with([](mesh& m, indices, vec3&) { m.vertices[0].x += 1.0f; }) == "a side does not lie over the region once");
    CHECK(with([](mesh& m, indices t, vec3&) {  // a fin of two sides that hangs on a point
              const auto first = static_cast<std::uint32_t>(m.vertices.size());
              const vec3 a = m.vertices[t[0]];
              m.vertices.insert(m.vertices.end(), {a, {a.x, a.y + 9.0f, a.z}, {a.x, a.y + 9.0f, a.z - 9.0f}});
              m.indices.insert(m.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 1});
          }) == "a point has two fans of triangles");
    CHECK(with([](mesh& m, indices t, vec3&) {  // a fin that hangs on an edge
              const auto first = static_cast<std::uint32_t>(m.vertices.size());
              const vec3 a = m.vertices[t[0]], b = m.vertices[t[1]];
              m.vertices.insert(m.vertices.end(), {a, b, {a.x, a.y, a.z + 9.0f}});
              m.indices.insert(m.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 1});
          }) == "more than two triangles meet at an edge");
}

TEST_CASE("a bevel_oracle has the volume and the places of a ring with chamfers", "[every_glyph][bevel]")
{
    const bevelled_ring ring;
    const auto chamfer = test::plain_profile::chamfer(), round = test::plain_profile::round(4);
    const test::bevel_oracle oracle{ring.of, 10'000.0, 10'000.0, 2.0, {&chamfer, &round}};
    CHECK_FALSE(oracle.is_doubtful());
    CHECK(oracle.cap_area() == Catch::Approx(80'000.0 * 80'000.0 - 40'000.0 * 40'000.0));
    const auto frustum = [](double a, double b) { return (a * a + a * b + b * b) / 3.0; };
    const double chamfered = 4'000.0 * (frustum(1e5, 8e4) - frustum(2e4, 4e4));
    CHECK(oracle.volume(chamfer, 4'000.0) == Catch::Approx(chamfered));
    CHECK(oracle.volume(round, 4'000.0) > 1.01 * chamfered);
    CHECK_FALSE(oracle.places().empty());
    for (const test::bevel_oracle::place& p : oracle.places()) {
        double z = 0.0;
        REQUIRE(test::height_over(ring.mesh, p.x, p.y, z));
        CHECK(z + 4'000.0 == Catch::Approx(p.distance * 0.4).margin(0.01));
    }
    CHECK(round.height(1.0) == Catch::Approx(1.0));
    for (const double t : {0.0, 0.1, 0.5, 0.9})
        CHECK(round.distance(round.height(t)) == Catch::Approx(t).margin(1e-12));
}

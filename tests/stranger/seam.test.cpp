// SPDX-License-Identifier: MIT

// An extruder of five parts, with points, records and caps of its own, works wherever the library's own do: in caches,
// merged letters, chunks, instances, teams and partial writes.

#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "flared.hpp"
#include "support/catch.hpp"
#include "support/text_laws.hpp"
#include "tapering_twist.hpp"

using namespace typemesh;
using Catch::Approx;
using test::lawful;
using test::written;
using mesh = test::lit_mesh;
using vertex = test::lit_vertex;

namespace {

struct own_lock {
    int held = 0;
    void lock() noexcept { ++held; }
    void unlock() noexcept { --held; }
};

}  // namespace

TEST_CASE("a stranger's extruder of five parts makes closed solids of exact size, volume and bounds", "[stranger]")
{
    test::toy_font font;
    const stranger::flared how;
    auto mesher = text_mesher{font}.with(how);
    const auto alone = test::required(mesher.plan("i"));
    CHECK(alone->parts().size() == 5);
    const std::uint32_t vertices[] = {4, 4, 16, 16, 16}, triangles[] = {2, 2, 8, 8, 8};
    for (const part p : alone->parts()) {
        CHECK(alone->range(p).vertex_count == vertices[static_cast<std::size_t>(p)]);
        CHECK(alone->range(p).index_count == 3 * triangles[static_cast<std::size_t>(p)]);
    }
    CHECK(alone->hard_edges() == 4);

    const double area = 0.1 * 0.5, rim = double{how.rim}, between = double{how.depth} - 2.0 * rim;
    CHECK(inspect::measure(lawful(*alone).view()).volume ==
          Approx(area * (between + 2.0 * rim * 7.0 / 3.0)).epsilon(1e-5));
    CHECK(alone->bounds().low == vec3{0.05f, -0.25f, -0.3f});
    CHECK(alone->bounds().high == vec3{0.25f, 0.75f, 0.0f});

    frame turned = left_handed_y_up;
    turned.winding = -1;
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up, turned}) {
        const text_options options{.frame = f};
        (void)lawful(*test::required(mesher.plan(test::crossed_word, options)), f);
    }
    // Its own box is fitted.
    const text_options fitted{.unit = output_unit::unit_box};
    const auto fits = test::required(mesher.plan(test::crossed_word, fitted));
    (void)lawful(*fits);
    CHECK(fits->bounds().low.x == -1.0f);
    CHECK(fits->bounds().high.x == 1.0f);
}

TEST_CASE("a stranger's five parts are the same through caches, teams and constrained Delaunay", "[stranger]")
{
    test::check_everywhere<glyph_cache<own_lock>>(
        [](auto& font, const stranger::flared& how) { return text_mesher{font}.with(how); }, stranger::flared{},
        stranger::flared{.rim = 0.1f});
}

TEST_CASE("a stranger's five parts are merged, cut into chunks, instanced and written in part", "[stranger]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(stranger::flared{});
    const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});  // two rings that meet
    const auto joined = test::required(mesher.plan(run, {.merge = true}));
    CHECK(joined->glyphs().size() == 2);
    (void)lawful(*joined);
    CHECK(joined->owner(0, stranger::flared::front_slope, 0) == shared_glyph);
    test::check_pieces(*test::required(mesher.plan(test::crossed_word)), {65'535, 200, 30});  // all glyphs, one, pieces
}

TEST_CASE("letters that twist and taper stay within their stated bounds", "[stranger]")
{
    test::toy_font font;
    for (const double turn : {0.0, 0.2, -1.5}) {
        for (const double taper : {0.5, 1.0, 1.3}) {
            auto mesher = text_mesher{font}.with(stranger::tapering_twist{.turn = turn, .taper = taper});
            for (const output_unit unit : {output_unit::em, output_unit::unit_box}) {
                const text_options options{.unit = unit};
                const auto plan = test::required(mesher.plan(test::crossed_word, options));
                const mesh m = written(*plan);
                bounds3 seen{m.vertices[0].place, m.vertices[0].place};
                for (const vertex& v : m.vertices) seen.add(v.place);
                CHECK(plan->bounds().low == seen.low);
                CHECK(plan->bounds().high == seen.high);
            }
        }
    }
}

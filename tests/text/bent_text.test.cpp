// SPDX-License-Identifier: MIT

// Bent letters go wherever all others do, each planned where it stands: through teams, chunks, instances, merged letters,
// units and textures.

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/taper.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/wave.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <string>

#include "support/catch.hpp"
#include "support/text_laws.hpp"

using namespace typemesh;

namespace {

using cup = bent<on_cylinder>;

/// A plan's mesh, which is closed, right side out, lit from outside and within its bounds, which it nearly fills.
template <class Plan>
test::lit_mesh lawfully_bent(const Plan& plan)
{
    const test::lit_mesh m = test::written(plan);
    CHECK(inspect::check_closedness(m.view()).is_closed());
    CHECK(inspect::check_normals(m.view(), &test::lit_vertex::normal, 1).is_right());
    CHECK(inspect::measure(m.view()).volume > 0.0);
    REQUIRE_FALSE(m.vertices.empty());
    bounds3 seen{m.vertices[0].place, m.vertices[0].place};
    for (const test::lit_vertex& v : m.vertices) {
        seen.add(v.place);
        CHECK(plan.bounds().holds(v.place));
    }
    const double margin = 1e-6 * (double{seen.high.x} - double{seen.low.x});
    for (const auto axis : {&vec3::x, &vec3::y, &vec3::z}) {
        CHECK(plan.bounds().low.*axis == Catch::Approx(seen.low.*axis).margin(margin));
        CHECK(plan.bounds().high.*axis == Catch::Approx(seen.high.*axis).margin(margin));
    }
    return m;
}

template <class Solid>
test::lit_mesh mesh_of(const Solid& how, const char* text, const text_options& options = {})
{
    test::toy_font font;
    text_mesher mesher{font, how};
    const auto plan = test::required(mesher.plan(text, options));
    CHECK(plan->report().complete());
    return lawfully_bent(*plan);
}

}  // namespace

TEST_CASE("bent letters are the same through teams, pieces and another plan, and no cache is used", "[text][bent]")
{
    test::toy_font font;
    const cup how{.how = {1.5}, .tolerance = 1.0 / 2000};
    text_mesher mesher{font, how};
    const auto plan = test::required(mesher.plan(test::crossed_word));
    const test::lit_mesh expected = lawfully_bent(*plan);

    glyph_cache<> cache;
    text_mesher cached{font, how, cached_in{cache, 1}};
    CHECK(lawfully_bent(*test::required(cached.plan(test::crossed_word))) == expected);
    CHECK(cache.statistics().entries == 0);

    test::scrambled_workers pool;
    auto team = test::toy_team(pool);
    for (int i = 0; i < 2; ++i) {
        const auto shared = test::required(mesher.plan(test::crossed_word, {}, *team));
        test::lit_mesh m;
        REQUIRE(shared->write(into(m.vertices, m.indices), pool));
        CHECK(m == expected);
    }
    const auto again = test::required(mesher.plan(test::crossed_word));
    CHECK(lawfully_bent(*again) == expected);

    // Chunks and partial writes.
    text_chunks chunks;
    REQUIRE(chunks.cut(*again, 400));
    std::vector<test::lit_vertex> vertices;
    std::vector<std::uint16_t> indices;
    REQUIRE(chunks.write(*again, into(vertices, indices)));
    CHECK(indices.size() == expected.indices.size());
    test::lit_mesh some = expected;
    for (const part p : again->parts()) {
        const mesh_range r = again->range(1, p);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) some.vertices[r.first_vertex + i] = {};
    }
    REQUIRE(again->write(glyph_span{1, 2}, into(std::span{some.vertices}, std::span{some.indices})));
    CHECK(some == expected);
}

TEST_CASE("every occurrence of a bent letter is an instance of its own, where it stands", "[text][bent]")
{
    test::toy_font font;
    text_mesher mesher{font, cup{.how = {1.0}}};
    const auto plan = test::required(mesher.plan("oo o"));
    const test::lit_mesh whole = lawfully_bent(*plan);
    CHECK(plan->meshes().size() == 3);
    test::lit_mesh once;
    REQUIRE(plan->write_meshes(into(once.vertices, once.indices)));
    CHECK(once.vertices.size() == whole.vertices.size());
    CHECK(inspect::measure(once.view()).volume == Catch::Approx(inspect::measure(whole.view()).volume));
    plan->write_instances([&](const glyph_instance& i) { CHECK(i.translation == vec3{}); });
    // The second letter is the first one, turned about the cylinder's axis.
    const mesh_range a = plan->range(0, part::front), b = plan->range(1, part::front);
    REQUIRE(a.vertex_count != 0);
    const double turn = (plan->glyphs()[1].origin.x - plan->glyphs()[0].origin.x) / 1000.0;
    if (a.vertex_count == b.vertex_count)
        for (std::uint32_t i = 0; i < a.vertex_count; ++i) {
            const vec3 p = whole.vertices[a.first_vertex + i].place, q = whole.vertices[b.first_vertex + i].place;
            const double x = double{p.x}, z = double{p.z} + 1.0;
            CHECK(double{q.x} == Catch::Approx(x * std::cos(turn) + z * std::sin(turn)).margin(1e-5));
            CHECK(double{q.z} == Catch::Approx(z * std::cos(turn) - x * std::sin(turn) - 1.0).margin(1e-5));
        }
    CHECK(a.vertex_count == b.vertex_count);
}

TEST_CASE("bent letters merge, and their groups are bent where they stand", "[text][bent]")
{
    const text_options merged{.merge = true};
    for (const char* text : {"oxo", test::crossed_word}) {
        const test::lit_mesh apart = mesh_of(cup{.how = {1.2}}, text), one = mesh_of(cup{.how = {1.2}}, text, merged);
        CHECK(inspect::measure(one.view()).volume <= inspect::measure(apart.view()).volume * 1.0001);
        bounds3 of_apart{apart.vertices[0].place, apart.vertices[0].place}, of_one = of_apart;
        of_one = {one.vertices[0].place, one.vertices[0].place};
        for (const auto& v : apart.vertices) of_apart.add(v.place);
        for (const auto& v : one.vertices) of_one.add(v.place);
        CHECK(of_one.high.x == Catch::Approx(of_apart.high.x).margin(0.002));
        CHECK(of_one.low.z == Catch::Approx(of_apart.low.z).margin(0.002));
    }
}

TEST_CASE("units, sizes and depths scale bent letters as a whole", "[text][bent]")
{
    const char* text = "oE";
    const cup how{.solid = {.depth = 0.1f}, .how = {0.7}};
    const test::lit_mesh em = mesh_of(how, text);
    const auto check_scaled = [&](const test::lit_mesh& m, double scale) {
        REQUIRE(m.vertices.size() == em.vertices.size());
        for (std::size_t i = 0; i < m.vertices.size(); ++i) {
            const vec3 p = em.vertices[i].place, q = m.vertices[i].place;
            CHECK(double{q.x} == Catch::Approx(scale * double{p.x}).epsilon(1e-5).margin(1e-5 * scale));
            CHECK(double{q.z} == Catch::Approx(scale * double{p.z}).epsilon(1e-5).margin(1e-5 * scale));
        }
    };
    check_scaled(mesh_of(how, text, {.size = 12.0}), 12.0);
    check_scaled(mesh_of(how, text, {.unit = output_unit::font_units}), 1000.0);
    check_scaled(mesh_of(how, text, {.unit = output_unit::pixels, .pixels_per_em = 32.0}), 32.0);
    // A depth of 1.2 output units is 0.1 em at this size.
    check_scaled(
        mesh_of(cup{.solid = {.depth = 1.2f}, .how = {0.7}}, text, {.size = 12.0, .depth_in = depth_unit::output}),
        12.0);

    // The bent text fills the box.
    test::toy_font font;
    text_mesher mesher{font, how};
    const auto boxed = test::required(mesher.plan(text, {.unit = output_unit::unit_box}));
    lawfully_bent(*boxed);
    const bounds3 b = boxed->bounds();
    CHECK((std::max)(b.high.x - b.low.x, b.high.y - b.low.y) == Catch::Approx(2.0f).epsilon(1e-5));
    CHECK(b.high.x == Catch::Approx(-b.low.x).epsilon(1e-5));
    const auto refused = mesher.plan(text, {.unit = output_unit::unit_box, .depth_in = depth_unit::output});
    REQUIRE_FALSE(refused);
    CHECK(refused.error() == error::bad_option);
    CHECK(std::string{refused.error().option} == "depth_in");
}

TEST_CASE("textures lie on bent letters as on flat ones", "[text][bent]")
{
    test::toy_font font;
    for (const texture_box over : {texture_box::text, texture_box::line, texture_box::glyph}) {
        text_mesher mesher{font, cup{.solid = {.texture = texture_mapping::box}, .how = {0.6}}};
        const auto plan = test::required(mesher.plan("oE", {.texture_over = over}));
        const test::lit_mesh m = lawfully_bent(*plan);
        vec2 low{2.0f, 2.0f}, high{-1.0f, -1.0f};
        for (const auto& v : m.vertices) {
            low = {(std::min)(low.x, v.uv.x), (std::min)(low.y, v.uv.y)};
            high = {(std::max)(high.x, v.uv.x), (std::max)(high.y, v.uv.y)};
        }
        CHECK(low.x == Catch::Approx(0.0f).margin(1e-5));
        CHECK(low.y == Catch::Approx(0.0f).margin(1e-5));
        CHECK(high.x == Catch::Approx(1.0f).epsilon(1e-5));
        CHECK(high.y == Catch::Approx(1.0f).epsilon(1e-5));
    }
}

TEST_CASE("a text that goes around or folds is refused, with its sentence", "[text][bent]")
{
    test::toy_font font;
    const auto refusal = [&](const auto& how, const char* text) {
        text_mesher mesher{font, how};
        return mesher.plan(text).error();
    };
    CHECK(refusal(cup{.how = {0.5}}, "ooooooooooooooo") == error::goes_around);
    CHECK(refusal(bent<on_sphere>{.how = {0.5}}, "ooooooooooooooo") == error::goes_around);
    CHECK(refusal(bent<on_sphere>{.how = {0.2}}, "E") == error::folds_over);
    const error folded = refusal(bent<taper>{.how = {-0.4}}, "oooooooo");
    CHECK(folded == error::folds_over);
    CHECK(folded.glyph != no_glyph);
    CHECK(folded.cluster != no_cluster);
    CHECK(folded.cluster > 0);
    CHECK_FALSE(refusal(bent<twist>{.how = {90.0}}, "oooooooooo"));
    CHECK_FALSE(refusal(bent<displaced<wave>>{}, ""));
    CHECK_FALSE(refusal(bent<taper>{}, ""));
    CHECK_FALSE(refusal(bent<on_sphere>{}, " "));
    CHECK(refusal(bent<on_cylinder>{.how = {0.0}}, "") == error::bad_option);
}

TEST_CASE("one_of chooses between bent and flat letters", "[text][bent]")
{
    test::toy_font font;
    text_mesher<one_of<extruded<>, cup>> mesher{font};
    const auto flat_plan = test::required(mesher.plan("oo"));
    const test::lit_mesh straight = lawfully_bent(*flat_plan);
    CHECK(flat_plan->meshes().size() == 1);
    const float lowest = flat_plan->bounds().low.z;
    mesher.solid() = cup{.how = {1.0}};
    const auto plan = test::required(mesher.plan("oo"));
    const test::lit_mesh round = lawfully_bent(*plan);
    CHECK(plan->meshes().size() == 2);
    CHECK_FALSE(round == straight);
    CHECK(plan->bounds().low.z < lowest - 0.01f);
    CHECK(mesher.plan("ooooooooooooooooo").error() == error::goes_around);
}

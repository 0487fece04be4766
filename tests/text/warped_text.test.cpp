// SPDX-License-Identifier: MIT

// Warped letters go wherever all others do, each built where it stands: through teams, chunks, instances, merged letters,
// bevels, outlines, bent solids, units and textures.

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/outline/transformed_outlines.hpp>
#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/each_failure.hpp"
#include "support/text_laws.hpp"

using namespace typemesh;

namespace {

/// Moves and slants; x stays the text's own.
struct slanting {
    double slant = 0.0;

    [[nodiscard]] error refused_options() const noexcept { return {}; }
    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        return {{p.x + slant * p.y, p.y}, {1.0, 0.0}, {slant, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box&) const noexcept { return {}; }
};

/// A mesh that is closed, right side out and lit from outside.
template <class... Option>
test::lit_mesh mesh_of_warped(const char* text, const text_options& options, Option... option)
{
    test::toy_font font;
    text_mesher mesher{font, option...};
    const auto plan = test::required(mesher.plan(text, options));
    CHECK(plan->report().complete());
    return test::lawful(*plan);
}

const auto round_text = warped{arc{.degrees = 100}};

}  // namespace

TEST_CASE("a warp that changes nothing gives bit-identical meshes", "[text][warp]")
{
    const auto same_text = [](const char* text, const text_options& options) {
        CHECK(mesh_of_warped(text, options, warped{slanting{}}) == mesh_of_warped(text, options));
        CHECK(mesh_of_warped(text, options, warped{arc{.degrees = 0}}, bevelled{}) ==
              mesh_of_warped(text, options, bevelled{}));
        CHECK(mesh_of_warped(text, options, warped{perspective{.scale = 1.0}}) == mesh_of_warped(text, options));
    };
    same_text(test::crossed_word, {});
    same_text("oxo\nEx", {.merge = true});
    same_text("oxo", {.unit = output_unit::unit_box, .texture_over = texture_box::line});
}

TEST_CASE("an affine warp gives what transformed outlines give", "[text][warp]")
{
    test::toy_font font;
    transformed_outlines slanted{font, affine{.xy = 0.25}};
    const glyph_run run = test::row_of(1, {0.0, 600.0, 1250.0});
    text_mesher outlines{slanted, bevelled{.width = 0.01f}};
    text_mesher warps{font, bevelled{.width = 0.01f}, warped{slanting{0.25}}};
    const auto a = test::required(outlines.plan(run)), b = test::required(warps.plan(run));
    const test::lit_mesh one = test::lawful(*a), other = test::lawful(*b);
    REQUIRE(one.vertices.size() == other.vertices.size());
    CHECK(one.indices == other.indices);
    for (std::size_t i = 0; i < one.vertices.size(); ++i) {
        const vec3 p = one.vertices[i].place, q = other.vertices[i].place;
        CHECK(std::hypot(double{p.x} - double{q.x}, double{p.y} - double{q.y}) < 3e-6);  // a cell
    }
}

TEST_CASE("warped letters are the same through teams, pieces and another plan, and no cache is used", "[text][warp]")
{
    test::toy_font font;
    const auto check = [&](auto solid) {
        text_mesher mesher{font, solid, round_text};
        const auto plan = test::required(mesher.plan(test::crossed_word));
        const test::lit_mesh expected = test::lawful(*plan);

        glyph_cache<> cache;
        text_mesher cached{font, solid, round_text, cached_in{cache, 1}};
        CHECK(test::lawful(*test::required(cached.plan(test::crossed_word))) == expected);
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
        CHECK(test::lawful(*again) == expected);
        text_chunks chunks;
        REQUIRE(chunks.cut(*again, 400));
        std::vector<test::lit_vertex> vertices;
        std::vector<std::uint16_t> indices;
        REQUIRE(chunks.write(*again, into(vertices, indices)));
        CHECK(indices.size() == expected.indices.size());
    };
    check(extruded<>{});
    check(bevelled{.width = 0.01f});
}

TEST_CASE("every occurrence of a warped letter is a mesh of its own: the first one turned", "[text][warp]")
{
    test::toy_font font;
    text_mesher mesher{font, round_text};
    const auto plan = test::required(mesher.plan("ooo"));
    const test::lit_mesh whole = test::lawful(*plan);
    CHECK(plan->meshes().size() == 3);
    plan->write_instances([&](const glyph_instance& i) { CHECK(i.translation == vec3{}); });
    test::lit_mesh once;
    REQUIRE(plan->write_meshes(into(once.vertices, once.indices)));
    CHECK(test::volume_of(once) == Catch::Approx(test::volume_of(whole)));
    // Rings at equal distances along the arc have equal volumes, and their middles lie on one circle.
    const double width = 1.8, radius = width / (100.0 * 0.017453292519943295);
    for (std::uint32_t g = 0; g < 3; ++g) {
        bounds3 around;
        bool first = true;
        const mesh_range r = plan->range(g, part::front);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) {
            const vec3 p = whole.vertices[r.first_vertex + i].place;
            if (first) around = {p, p};
            first = false;
            around.add(p);
        }
        const double x = 0.5 * (double{around.low.x} + double{around.high.x}) - 0.5 * width,
                     y = 0.5 * (double{around.low.y} + double{around.high.y}) + radius;
        CHECK(std::hypot(x, y) == Catch::Approx(radius + 0.25).margin(0.02));
    }
}

TEST_CASE("warped letters are bevelled, outlined, bold, refined, merged and bent", "[text][warp]")
{
    const auto check = [](const auto& how) {
        for (const bool merged : {false, true}) {
            const text_options options{.merge = merged};
            for (const char* text : {"oxo", test::crossed_word}) {
                const test::lit_mesh plain = mesh_of_warped(text, options, warped{how});
                mesh_of_warped(text, options, warped{how}, bevelled{.width = 0.01f});
                mesh_of_warped(text, options, warped{how}, outlined<extruded<>, extruded<>>{.width = 0.02f});
                const test::lit_mesh bold = mesh_of_warped(text, options, warped{how}, embolden{.by = 0.01f});
                CHECK(test::volume_of(bold) > test::volume_of(plain));
                mesh_of_warped(text, options, warped{how}, refined<extruded<>>{});
            }
        }
    };
    check(arc{.degrees = 100});
    check(arch{.rise = 0.2, .baseline = -0.1});
    check(flag{.height = 0.15});
    check(perspective{.scale = 0.6});

    // The depth of solids that are bent afterwards is kept by the cylinder's radius.
    test::toy_font font;
    text_mesher mesher{font, bent<on_cylinder>{.how = {1.5}}, warped{flag{}}};
    const auto plan = test::required(mesher.plan("oxE"));
    const test::lit_mesh m = test::written(*plan);
    CHECK(inspect::check_closedness(m.view()).is_closed());
    for (const auto& v : m.vertices)
        if (v.of == part::front)
            CHECK(std::hypot(double{v.place.x}, double{v.place.z} + 1.5) == Catch::Approx(1.5).epsilon(0.002));
}

TEST_CASE("letters that meet stay where they are when they are merged after a warp", "[text][warp]")
{
    test::toy_font font;
    const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});  // two rings that meet
    text_mesher mesher{font, flat{}, round_text};
    const auto apart = test::required(mesher.plan(run));
    const auto before = apart->bounds();
    CHECK(apart->glyphs().size() == 3);
    const auto one = test::required(mesher.plan(run, {.merge = true}));
    CHECK(one->glyphs().size() == 2);
    for (const auto axis : {&vec3::x, &vec3::y}) {
        CHECK(one->bounds().low.*axis == Catch::Approx(before.low.*axis).margin(1e-5));
        CHECK(one->bounds().high.*axis == Catch::Approx(before.high.*axis).margin(1e-5));
    }
}

TEST_CASE("walls and bevels of warped letters have the normals of their curves", "[text][warp]")
{
    // A rotation by an arc of constant curvature: the ring's normals are the Jacobian's cofactors times the flat ones.
    test::toy_font font;
    const arc how{.degrees = 80, .width = 1.2, .middle = 0.3};
    text_mesher mesher{font, extruded<>{}, warped{how}};
    const text_options fine{.tolerance = 1.0 / 20'000};
    const auto plan = test::required(mesher.plan("oo", fine));
    const test::lit_mesh m = test::lawful(*plan);
    const point middles[] = {{0.25, 0.25}, {0.85, 0.25}};
    double worst = 0.0;
    std::size_t seen = 0;
    for (const auto& v : m.vertices) {
        if (v.of != part::side) continue;
        // The place before the warp, by Newton's method.
        const point wanted{double{v.place.x}, double{v.place.y}};
        point p = wanted;
        for (int i = 0; i < 50; ++i) {
            const warped_point w = how(p);
            const point off = wanted - w.at;
            const double det = cross(w.x, w.y);
            p = p + point{cross(off, w.y) / det, cross(w.x, off) / det};
        }
        const point from = p - middles[p.x < 0.55 ? 0 : 1];
        const point outward = (length(from) > 0.2 ? 1.0 : -1.0) / length(from) * from;
        const warped_point w = how(p);
        const point along = -outward.y * w.x + outward.x * w.y;  // the image of the tangent
        const point normal{along.y / length(along), -along.x / length(along)};
        const point given{double{v.normal.x}, double{v.normal.y}};
        worst = (std::max)(worst, std::fabs(std::atan2(cross(normal, given), dot(normal, given))));
        ++seen;
    }
    CHECK(seen > 100);
    // The drawn ring is a circle of four cubics, whose tangents are up to 0.06 degrees off.
    CHECK(worst * 57.29577951308232 < 0.15);
}

TEST_CASE("texture boxes span warped letters as if they were drawn so", "[text][warp]")
{
    for (const texture_box over : {texture_box::text, texture_box::line, texture_box::glyph}) {
        const test::lit_mesh m =
            mesh_of_warped("oE", {.texture_over = over}, round_text, extruded<>{.texture = texture_mapping::box});
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

TEST_CASE("units and depths of warped text are those of other text", "[text][warp]")
{
    const test::lit_mesh em = mesh_of_warped("oE", {}, round_text);
    const test::lit_mesh twelve = mesh_of_warped("oE", {.size = 12.0}, round_text);
    const test::lit_mesh boxed = mesh_of_warped("oE", {.unit = output_unit::unit_box, .depth_in = depth_unit::output},
                                                round_text, extruded<>{.depth = 0.3f});
    REQUIRE(em.vertices.size() == twelve.vertices.size());
    CHECK(em.vertices.size() == boxed.vertices.size());
    for (std::size_t i = 0; i < em.vertices.size(); ++i)
        CHECK(double{twelve.vertices[i].place.y} ==
              Catch::Approx(12.0 * double{em.vertices[i].place.y}).epsilon(1e-5).margin(1e-5));
}

TEST_CASE("every line of a text is warped, and a mesher takes, keeps and forgets its warp", "[text][warp]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    const auto straight = test::written(*test::required(mesher.plan("oo\nE")));
    mesher.use(warped{arc{.degrees = 20}});
    REQUIRE(mesher.policy<warped<arc>>() != nullptr);
    const auto plan = test::required(mesher.plan("oo\nE"));
    const test::lit_mesh m = test::written(*plan);
    CHECK_FALSE(m == straight);
    mesher.use(no_outline_step{});
    CHECK(test::written(*test::required(mesher.plan("oo\nE"))) == straight);
    CHECK(mesher.policy<warped<arc>>() == nullptr);
    auto solid = std::move(mesher).with(warped{flag{}}).with(extruded<>{});
    const auto waving = test::lawful(*test::required(solid.plan("oo")));
    CHECK(waving == mesh_of_warped("oo", {}, warped{flag{}}));
}

TEST_CASE("a text that a warp folds or closes to more than a circle is refused", "[text][warp]")
{
    test::toy_font font;
    const auto refusal = [&](const auto& how, const char* text) {
        text_mesher mesher{font, how};
        return mesher.plan(text).error();
    };
    CHECK(refusal(warped{arc{.degrees = 361}}, "oo") == error::goes_around);
    CHECK(refusal(warped{arc{.degrees = 90, .width = 1.0}}, "ooooooo") == error::goes_around);
    CHECK_FALSE(refusal(warped{arc{.degrees = 90, .width = 1.0}}, "oooooo"));
    const error folded = refusal(warped{arc{.degrees = -350}}, "oE");
    CHECK(folded == error::folds_over);
    CHECK(folded.glyph != no_glyph);
    CHECK(refusal(warped{perspective{.scale = 0.0}}, "") == error::bad_option);
    CHECK(refusal(warped{flag{.height = 1e300}}, "oo") != error::none);
    CHECK_FALSE(refusal(warped{arc{}}, ""));
    CHECK_FALSE(refusal(warped{arc{}}, " "));
}

TEST_CASE("warped text survives each failure of memory", "[text][warp]")
{
    const std::size_t requests = test::check_each_failure([](memory source) {
        test::toy_font font;
        text_mesher mesher{font, round_text, source};
        return mesher.plan("oE", {.merge = true}).error();
    });
    CHECK(requests > 10);
}

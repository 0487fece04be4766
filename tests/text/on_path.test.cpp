// SPDX-License-Identifier: MIT

// Text on a path through the whole chain: turned and warped letters are closed and lit from outside, in every kind of
// output.

#include "support/catch.hpp"
#include "support/each_failure.hpp"
#include "support/text_laws.hpp"

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/text/picked_character.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

constexpr const char* path_word = "oExi Eo";

void draw_ring(plane_path& way) { way.circle({0, 0}, 1.5); }

void draw_wave(plane_path& way)
{
    way.move({0, 0});
    way.cubic({1, 1.2}, {2, 1.2}, {3, 0});
    way.cubic({4, -1.2}, {5, -1.2}, {6, 0});
}

/// A mesh that is closed, right side out, lit from outside and within its bounds.
test::lit_mesh lawful_on_path(const auto& plan, const frame& f = right_handed_y_up)
{
    const test::lit_mesh m = test::written(plan);
    const int depth_axis = f.toward.x != 0.0f ? 0 : f.toward.y != 0.0f ? 1 : 2;
    CHECK(inspect::check_closedness(m.view(), depth_axis).is_closed());
    CHECK(inspect::check_normals(m.view(), &test::lit_vertex::normal, f.winding).is_right());
    CHECK(inspect::measure(m.view()).volume * f.winding > 0.0);
    for (const test::lit_vertex& v : m.vertices)
        for (const auto axis : {&vec3::x, &vec3::y, &vec3::z}) {
            REQUIRE(plan.bounds().low.*axis <= v.place.*axis);
            REQUIRE(plan.bounds().high.*axis >= v.place.*axis);
        }
    return m;
}

test::lit_mesh mesh_on_path(const on_path& way, const text_options& options, const auto& solid,
                            const char* text = path_word)
{
    test::toy_font font;
    text_mesher mesher{font, solid, way};
    const auto plan = test::required(mesher.plan(text, options));
    CHECK(plan->report().complete());
    return lawful_on_path(*plan, options.frame);
}

/// Turns each letter by a quarter and lets it fall; leaves out blanks.
struct falling_letters {
    [[nodiscard]] error refused(const box&) const noexcept { return {}; }
    [[nodiscard]] result<double> operator()(const outline&, const drawn_place&, double, std::uint32_t,
                                            outline&) const noexcept
    {
        return error::refused_by_user;  // no letter is warped
    }
    [[nodiscard]] error place(const glyph_run& run, double, glyph_stand* stands) const noexcept
    {
        for (const placed_glyph& g : run.glyphs)
            *stands++ = {.origin = g.origin + point{0.0, -100.0}, .right = {0.0, -1.0}, .left_out = g.id == 4};
        return {};
    }
};

}  // namespace

TEST_CASE("on a line along x from the origin a text is the plain text, bit for bit", "[text][path]")
{
    plane_path way;
    way.move({0, 0});
    way.line({50, 0});
    test::toy_font font;
    const auto check = [&](const auto& solid, const text_options& options) {
        text_mesher plain{font, solid};
        const test::lit_mesh expected = test::written(*test::required(plain.plan("oExi\nEo", options)));
        for (const path_warp warp : {path_warp::never, path_warp::always}) {
            text_mesher mesher{font, solid, on_path{&way, {.warp = warp}}};
            CHECK(test::written(*test::required(mesher.plan("oExi\nEo", options))) == expected);
        }
    };
    check(extruded<>{.texture = texture_mapping::box}, {});
    check(bevelled{.width = 0.01f}, {.size = 3.0, .texture_over = texture_box::line, .frame = left_handed_z_up});
    check(flat{}, {.unit = output_unit::unit_box});
    check(extruded<>{}, {.corners = touching::part});

    // Warped letters on a bent path whose curvature is 0 are bit-identical, too: all outlines go through the warp.
    plane_path two;
    two.move({0, 0});
    two.line({1.3, 0});
    two.line({50, 0});
    text_mesher plain{font};
    const test::lit_mesh expected = test::written(*test::required(plain.plan("oExi")));
    CHECK(mesh_on_path({&two, {.warp = path_warp::always}}, {}, extruded<>{}, "oExi") == expected);
}

TEST_CASE("turned letters have the plain text's volume, closed, lit and within bounds, for any frame and solid",
          "[text][path]")
{
    plane_path ring, wave;
    draw_ring(ring);
    draw_wave(wave);
    test::toy_font font;
    for (const plane_path* way : {&ring, &wave})
        for (const path_side side : {path_side::left, path_side::right})
            for (const frame& f : {right_handed_y_up, left_handed_z_up}) {
                const text_options options{.size = 2.0, .frame = f};
                const on_path on{way, {.anchor = path_anchor::middle, .side = side}};
                const auto check = [&](const auto& solid) {
                    text_mesher plain{font, solid};
                    const double volume =
                        test::volume_of(test::written(*test::required(plain.plan(path_word, options))));
                    CHECK(test::volume_of(mesh_on_path(on, options, solid)) == Catch::Approx(volume).epsilon(1e-5));
                };
                check(extruded<>{});
                check(bevelled{.width = 0.01f});
                mesh_on_path({way, {.anchor = path_anchor::middle, .side = side, .warp = path_warp::always}}, options,
                             bevelled{.width = 0.01f});
            }
}

TEST_CASE("letters that are turned when written and outlines that are turned before agree", "[text][path]")
{
    plane_path ring;
    draw_ring(ring);
    test::toy_font font;
    const on_path way{&ring, {.anchor = path_anchor::middle}};
    text_mesher mesher{font, way};
    const auto late = test::required(mesher.plan(path_word));
    CHECK(late->meshes().size() == 4);
    const auto expected = test::written(*late);
    text_mesher early{font, way};
    const auto merged = test::required(early.plan(path_word, {.merge = true}));  // builds each letter at its place
    CHECK(merged->meshes().size() == 6);
    CHECK(test::volume_of(lawful_on_path(*merged)) == Catch::Approx(test::volume_of(expected)).epsilon(1e-4));
    REQUIRE(late->glyphs().size() == merged->glyphs().size());
    for (std::size_t g = 0; g < late->glyphs().size(); ++g) {
        const auto box_of = [&](const auto& plan) {
            test::lit_mesh m = test::written(plan);
            const mesh_range r = plan.range(g, part::front);
            bounds3 b{m.vertices[r.first_vertex].place, m.vertices[r.first_vertex].place};
            for (std::uint32_t i = 0; i < r.vertex_count; ++i) b.add(m.vertices[r.first_vertex + i].place);
            return b;
        };
        const bounds3 a = box_of(*late), b = box_of(*merged);
        for (const auto axis : {&vec3::x, &vec3::y}) {
            CHECK(a.low.*axis == Catch::Approx(b.low.*axis).margin(2e-3));  // flattening may choose other points
            CHECK(a.high.*axis == Catch::Approx(b.high.*axis).margin(2e-3));
        }
    }
    mesh_on_path(way, {.corners = touching::part}, extruded<>{});

    // In a bent solid, letters are turned before they are bent: their fronts lie on the cylinder.
    text_mesher around{font, bent<on_cylinder>{.how = {2.5}}, way};
    const auto plan = test::required(around.plan("oxE"));
    const test::lit_mesh m = test::written(*plan);
    CHECK(inspect::check_closedness(m.view()).is_closed());
    for (const auto& v : m.vertices)
        if (v.of == part::front)
            CHECK(std::hypot(double{v.place.x}, double{v.place.z} + 2.5) == Catch::Approx(2.5).epsilon(0.002));
}

TEST_CASE("turned letters are cached, shared by workers, chunked and instanced, and warped ones are built one by one",
          "[text][path]")
{
    plane_path ring;
    draw_ring(ring);
    test::toy_font font;
    for (const path_warp warp : {path_warp::never, path_warp::always}) {
        const on_path way{&ring, {.anchor = path_anchor::middle, .warp = warp}};
        text_mesher mesher{font, way};
        const auto plan = test::required(mesher.plan(path_word));
        const test::lit_mesh expected = lawful_on_path(*plan);
        CHECK(plan->meshes().size() == (warp == path_warp::never ? 4u : 6u));

        // Each instance turns and moves its mesh to where the letter stands.
        test::lit_mesh once;
        REQUIRE(plan->write_meshes(into(once.vertices, once.indices)));
        std::size_t instances = 0;
        plan->write_instances([&](const glyph_instance& i) {
            ++instances;
            const mesh_range to = plan->range(i.glyph, part::side), from = plan->mesh_part(i.mesh, part::side);
            for (std::uint32_t k = 0; k < to.vertex_count; ++k) {
                const test::lit_vertex &a = expected.vertices[to.first_vertex + k],
                                       &b = once.vertices[from.first_vertex + k];
                const auto turn = [&i](vec3 v) {
                    return vec3{i.x.x * v.x + i.y.x * v.y + i.z.x * v.z, i.x.y * v.x + i.y.y * v.y + i.z.y * v.z,
                                i.x.z * v.x + i.y.z * v.y + i.z.z * v.z};
                };
                const vec3 p = turn(b.place), n = turn(b.normal);
                REQUIRE(std::hypot(p.x + i.translation.x - a.place.x, p.y + i.translation.y - a.place.y,
                                   p.z + i.translation.z - a.place.z) < 1e-6f);
                REQUIRE(std::hypot(n.x - a.normal.x, n.y - a.normal.y, n.z - a.normal.z) < 1e-6f);
            }
        });
        CHECK(instances == plan->glyphs().size());

        glyph_cache<> cache;
        text_mesher cached{font, way, cached_in{cache, 1}};
        text_mesher plain{font, cached_in{cache, 1}};
        REQUIRE(plain.plan(path_word));
        CHECK(test::written(*test::required(cached.plan(path_word))) == expected);
        CHECK((cache.statistics().hits > 0) == (warp == path_warp::never));

        test::scrambled_workers pool;
        auto team = test::toy_team(pool);
        const auto shared = test::required(mesher.plan(path_word, {}, *team));
        test::lit_mesh m;
        REQUIRE(shared->write(into(m.vertices, m.indices), pool));
        CHECK(m == expected);

        text_chunks chunks;
        const auto again = test::required(mesher.plan(path_word));
        REQUIRE(chunks.cut(*again, 400));
        std::vector<test::lit_vertex> vertices;
        std::vector<std::uint16_t> indices;
        REQUIRE(chunks.write(*again, into(vertices, indices)));
        CHECK(indices.size() == expected.indices.size());
        for (const test::lit_vertex& v : vertices) REQUIRE(std::hypot(v.place.x, v.place.y) < 2.8f);
    }
}

TEST_CASE("textures cover the flat text and turn with its letters", "[text][path]")
{
    plane_path ring;
    draw_ring(ring);
    test::toy_font font;
    for (const texture_mapping mapping : {texture_mapping::box, texture_mapping::em}) {
        const extruded<> solid{.texture = mapping};
        text_mesher plain{font, solid}, turned{font, solid, on_path{&ring}};
        const auto flat_plan = test::required(plain.plan(path_word));
        const test::lit_mesh expected = test::written(*flat_plan);
        const auto plan = test::required(turned.plan(path_word));
        const test::lit_mesh m = test::written(*plan);
        REQUIRE(m.vertices.size() == expected.vertices.size());
        for (std::size_t i = 0; i < m.vertices.size(); ++i) REQUIRE(m.vertices[i].uv == expected.vertices[i].uv);
    }
}

TEST_CASE("warped letters on a path of lines, arcs and curves keep their tolerance", "[text][path]")
{
    // A wall's points, led back to the flat text, lie on the letter's own outline: on the ring of the o.
    plane_path way;
    way.move({0, 0});
    way.line({0.45, 0});
    way.arc({0.45, 1.4}, 60.0);
    const plane_path::place end = way.at(way.length());
    way.cubic(end.at + 0.8 * end.tangent, end.at + point{0.0, 2.0}, end.at + point{1.0, 2.4});
    test::toy_font font;
    constexpr double tolerance = 1.0 / 800;
    text_mesher mesher{font, on_path{&way, {.warp = path_warp::always}}};
    const auto plan = test::required(mesher.plan("oooo", {.tolerance = tolerance}));
    const test::lit_mesh m = lawful_on_path(*plan);
    const along_path w{&way};
    double worst = 0.0;
    for (const test::lit_vertex& v : m.vertices) {
        if (v.of != part::side) continue;
        const point wanted{double{v.place.x}, double{v.place.y}};
        double least = 1.0;
        for (int o = 0; o < 4; ++o)
            for (const double radius : {0.25, 0.15}) {
                const auto at = [&](double angle) {
                    return length(w(point{0.6 * o + 0.25, 0.25} + radius * point{std::cos(angle), std::sin(angle)}).at -
                                  wanted);
                };
                int best = 0;
                for (int k = 1; k < 64; ++k) best = at(k * 0.0981748) < at(best * 0.0981748) ? k : best;
                double low = (best - 1) * 0.0981748, high = (best + 1) * 0.0981748;
                while (high - low > 1e-6) {
                    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
                    (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
                }
                least = std::fmin(least, at(low));
            }
        worst = std::fmax(worst, least);
    }
    CAPTURE(worst);
    CHECK(worst < 0.25 * tolerance + 1e-4);  // the drawn ring is a circle up to 0.7e-4
}

TEST_CASE("letters without a place are left out and counted, and the others are where they would be", "[text][path]")
{
    plane_path bow;
    bow.move({0, 0});
    bow.arc({0, -1.2}, -90.0);  // 1.885 em: three letters
    test::toy_font font;
    text_mesher mesher{font, on_path{&bow}};
    const auto plan = test::required(mesher.plan("oEoEE "));
    CHECK(plan->glyphs().size() == 3);
    CHECK(plan->report().off_path == 2);
    CHECK(plan->report().first_off_path == 3);
    CHECK_FALSE(plan->report().complete());
    const test::lit_mesh some = lawful_on_path(*plan);
    CHECK(some == mesh_on_path({&bow}, {}, extruded<>{}, "oEo"));
    const auto merged = test::required(mesher.plan("oEoEE ", {.merge = true}));
    CHECK(merged->report().off_path == 2);
    lawful_on_path(*merged);
}

TEST_CASE("a point of a letter on a path leads to the letter and to its place in the flat text", "[text][path]")
{
    plane_path ring;
    draw_ring(ring);
    test::toy_font font;
    text_mesher mesher{font, on_path{&ring}};
    for (const text_options& how : {text_options{}, text_options{.merge = true}}) {
        const auto plan = test::required(mesher.plan("oEo", how));
        const test::lit_mesh m = test::written(*plan);
        for (std::uint32_t t = 0; t < plan->range(part::front).index_count / 3; ++t) {
            const mesh_hit hit = plan->hit(part::front, t);
            const vec3 p = m.vertices[m.indices[plan->range(part::front).first_index + 3 * t]].place;
            const point flat = plan->place_of(p, hit);
            const double left = 0.6 * hit.of_run;
            REQUIRE((flat.x > left - 1e-3 && flat.x < left + 0.6 && flat.y > -1e-3 && flat.y < 0.71));
            CHECK(character_at(*plan, hit, p, "oEo", font).text.first == hit.cluster);
        }
    }
}

TEST_CASE("bad paths and options are refused, and a warped letter on a corner", "[text][path]")
{
    test::toy_font font;
    plane_path nothing, failed, corner;
    failed.move({0, 0}), failed.arc({0, 0}, 10.0);
    corner.move({0, 0}), corner.line({0.2, 0}), corner.line({0.2, 3});
    const auto refusal = [&](const on_path& way) {
        text_mesher mesher{font, way};
        auto plan = mesher.plan("oo");
        return plan ? error{} : plan.error();
    };
    CHECK(refusal({}).option == std::string_view{"path"});
    CHECK(refusal({&nothing}).option == std::string_view{"path"});
    CHECK(refusal({&failed}).option == std::string_view{"path"});
    CHECK(refusal({&corner, {.offset = 1e300}}).option == std::string_view{"offset"});
    CHECK_FALSE(refusal({&corner}));
    const error folded = refusal({&corner, {.warp = path_warp::always}});
    CHECK(folded == error::folds_over);
    CHECK(folded.cluster == 0);
    text_mesher mesher{font, on_path{&corner}};
    const auto column = mesher.plan("oo", {.shape = {.direction = direction::top_to_bottom}});
    REQUIRE_FALSE(column);
    CHECK(column.error().option == std::string_view{"direction"});
}

TEST_CASE("a step of one's own may also say where letters stand", "[text][path]")
{
    test::toy_font font;
    text_mesher plain{font}, falling{font, falling_letters{}};
    const auto flat_plan = test::required(plain.plan(path_word));
    const auto plan = test::required(falling.plan(path_word));
    CHECK(plan->meshes().size() == flat_plan->meshes().size());
    CHECK(plan->report().off_path == 1);  // the blank
    const test::lit_mesh m = lawful_on_path(*plan);
    CHECK(test::volume_of(m) == Catch::Approx(test::volume_of(test::written(*flat_plan))).epsilon(1e-5));
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        CHECK(plan->glyphs()[g].right == point{0.0, -1.0});
        CHECK(plan->glyphs()[g].origin == flat_plan->glyphs()[g].origin + point{0.0, -100.0});
    }
}

TEST_CASE("text on a path fails without memory, and holds nothing then", "[text][path]")
{
    plane_path ring;
    draw_ring(ring);
    for (const path_warp warp : {path_warp::never, path_warp::always})
        CHECK(test::check_each_failure([&](memory source) {
                  test::toy_font font;
                  text_mesher mesher{font, on_path{&ring, {.warp = warp}}, source};
                  auto plan = mesher.plan("oE");
                  return plan ? error{} : plan.error();
              }) > 10);
}

TEST_CASE("in a text with turned and warped letters the turned ones are cached, and all are those of their own texts",
          "[text][path]")
{
    plane_path ring;
    draw_ring(ring);
    test::toy_font font;
    glyph_run run = test::run_of({{1, 0, {0, 0}}, {2, 1, {600, 0}}, {1, 2, {1200, 0}}, {2, 3, {1800, 0}}});
    for (placed_glyph& g : run.glyphs) g.to_middle = 300.0f;
    run.glyphs[1].joined = true;
    const on_path way{&ring, {.anchor = path_anchor::middle}};
    text_mesher mesher{font, way};
    const auto plan = test::required(mesher.plan(run));
    const test::lit_mesh mixed = lawful_on_path(*plan);
    REQUIRE(plan->meshes().size() == 3);  // the first and the third letter, the second, the fourth
    CHECK(plan->meshes()[0].glyph_count == 2);
    std::vector<test::lit_mesh> alone;
    for (const path_warp warp : {path_warp::never, path_warp::always}) {
        text_mesher one{font, on_path{&ring, {.anchor = path_anchor::middle, .warp = warp}}};
        const auto all = test::required(one.plan(run));
        const test::lit_mesh m = test::written(*all);
        for (std::size_t g = 0; g < 4; ++g) {
            if ((g == 1) != (warp == path_warp::always)) continue;
            for (const part p : plan->parts()) {
                const mesh_range to = plan->range(g, p), from = all->range(g, p);
                REQUIRE(to.vertex_count == from.vertex_count);
                std::size_t others = 0;
                for (std::uint32_t k = 0; k < to.vertex_count; ++k) {
                    const test::lit_vertex &a = mixed.vertices[to.first_vertex + k],
                                           &b = m.vertices[from.first_vertex + k];
                    const vec3 d{a.place.x - b.place.x, a.place.y - b.place.y, a.place.z - b.place.z};
                    others += !(std::hypot(d.x, d.y, d.z) < 1e-6f) || !(a.normal == b.normal) ? 1u : 0u;
                }
                CHECK(others == 0);
            }
        }
    }
    glyph_cache<> cache;
    {
        text_mesher cached{font, way, cached_in{cache, 1}};
        CHECK(test::written(*test::required(cached.plan(run))) == mixed);
        const auto before = cache.statistics();
        CHECK(before.entries == 2);  // the warped one is not among them
        CHECK(test::written(*test::required(cached.plan(run))) == mixed);
        CHECK(cache.statistics().hits >= before.hits + 2);
        test::scrambled_workers pool;
        auto team = test::toy_team(pool);
        CHECK(test::written(*test::required(mesher.plan(run, {}, *team))) == mixed);
    }
    CHECK(cache.statistics().pinned == 0);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

/// Memory that can only be assigned to; every assignment is written down.
struct written_once {
    static inline std::vector<const written_once*> log;

    written_once() = default;
    written_once(const written_once&) = delete;
    void operator=(const written_once&) = delete;
    void operator=(const test::full_vertex&) noexcept { log.push_back(this); }
};

/// A sink that writes indices through such memory, as array_sink does.
struct index_log {
    static constexpr attribute wants = attribute::none;
    std::vector<std::uint32_t> numbers;
    mesh_size expected;
    std::uint64_t vertices = 0;
    bool triangles_last = true;

    error begin(mesh_size exact) noexcept { return expected = exact, error{}; }
    void vertex(const surface_point<wants>&) noexcept
    {
        triangles_last = triangles_last && numbers.empty();
        ++vertices;
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        numbers.insert(numbers.end(), {a, b, c});
    }
    void end() noexcept {}
};

/// A run of `count` glyphs, each `step` font units behind the one before.
glyph_run run_of(std::size_t count, double step, auto id_of, double start = 0.0)
{
    glyph_run run;
    for (std::size_t i = 0; i < count; ++i) {
        const point origin{start + step * static_cast<double>(i), 0};
        REQUIRE(run.glyphs.push_back({id_of(i), static_cast<cluster_id>(i), origin}));
    }
    return run;
}

}  // namespace

TEMPLATE_TEST_CASE("each vertex is written once, in ascending order, and nothing is read back", "[text]", extruded<>,
                   extruded<shared_normals>, flat)
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(TestType{});
    const auto plan = test::required(mesher.plan("oEx oo\nEE"));
    std::vector<written_once> vertices(plan->size().vertices);
    std::vector<std::uint32_t> indices(plan->size().indices());
    written_once::log.clear();
    REQUIRE(plan->write(into(std::span{vertices}, std::span{indices}, vertex_traits<test::full_vertex>{})));
    REQUIRE(written_once::log.size() == vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) REQUIRE(written_once::log[i] == &vertices[i]);

    index_log log;
    REQUIRE(plan->write(log));
    CHECK(log.expected == plan->size());
    CHECK(log.vertices == plan->size().vertices);
    CHECK(log.triangles_last);
    CHECK(log.numbers == indices);
}

TEST_CASE("a plan writes the same mesh every time", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = mesher.plan("oEx oo");
    const auto a = test::written<full_mesh>(*plan), b = test::written<full_mesh>(*plan);
    CHECK(test::same_bits(a.vertices, b.vertices));
    CHECK(a.indices == b.indices);
}

TEST_CASE("neighbouring glyphs lie in one piece of each part, and so do the glyphs of a cluster", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    glyph_run run;
    const cluster_id clusters[] = {7, 3, 3, 3, 0};  // right to left, as it were
    for (std::size_t i = 0; i < 5; ++i)
        REQUIRE(run.glyphs.push_back(
            {static_cast<glyph_id>(i == 2 ? 4 : 1 + i % 2), clusters[i], {600.0 * static_cast<double>(i), 0}}));
    const auto plan = test::required(mesher.plan(run));
    REQUIRE(plan->glyphs().size() == 4);  // the blank one is no part of the mesh
    const glyph_span three = plan->glyphs_of(3);
    CHECK(three.first == 1);
    CHECK(three.last == 3);
    for (const part p : all_parts) {
        const mesh_range both = plan->range(three, p), first = plan->range(1, p), second = plan->range(2, p);
        CHECK(both.first_vertex == first.first_vertex);
        CHECK(first.first_vertex + first.vertex_count == second.first_vertex);
        CHECK(both.vertex_count == first.vertex_count + second.vertex_count);
        CHECK(both.first_index == first.first_index);
        CHECK(both.index_count == first.index_count + second.index_count);
        CHECK(plan->range(glyph_span{0, 4}, p) == plan->range(p));
    }
    CHECK(plan->glyphs_of(0).first == 3);
    const glyph_span none = plan->glyphs_of(5);
    CHECK(none.first == none.last);
    CHECK(plan->range(none, part::side).vertex_count == 0);
}

TEST_CASE("glyphs that changed are written into the old mesh, and nothing else is touched", "[text]")
{
    test::toy_font font;
    const bool packed = GENERATE(false, true);
    text_mesher mesher{font};
    const text_options options{.texture_over = texture_box::glyph};
    full_mesh m;
    std::array<mesh_range, max_parts> before;
    {
        const auto old = mesher.plan("oEiE", options);
        m = test::written<full_mesh>(*old);
        for (const part p : all_parts) before[static_cast<std::size_t>(p)] = old->range(2, p);
    }
    // A square of the same counts as 'i', shaped otherwise: .notdef is not one, so move the pen instead.
    glyph_run run;
    for (const auto& [id, x] : {std::pair{1u, 0.0}, {2u, 600.0}, {5u, 1250.0}, {2u, 1800.0}})
        REQUIRE(run.glyphs.push_back({id, 0, {x, 0}}));
    const auto plan = mesher.plan(run, options);
    const auto whole = test::written<full_mesh>(*plan);
    for (const part p : all_parts) REQUIRE(plan->range(2, p) == before[static_cast<std::size_t>(p)]);
    REQUIRE_FALSE(test::same_bits(whole.vertices, m.vertices));

    if (packed) {
        std::vector<vec3> positions(m.vertices.size()), expected(m.vertices.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            positions[i] = m.vertices[i].position;
            expected[i] = whole.vertices[i].position;
        }
        stream_sink sink{std::span{m.indices}, stream<attribute::position, vec3>{std::span{positions}}};
        REQUIRE(plan->write(glyph_span{2, 3}, sink));
        CHECK(positions == expected);
    } else {
        auto copy = m;
        REQUIRE(plan->write(glyph_span{2, 3}, into(std::span{copy.vertices}, std::span{copy.indices})));
        CHECK(test::same_bits(copy.vertices, whole.vertices));
        CHECK(copy.indices == whole.indices);

        const test::full_vertex untouched{{9, 9, 9}, {9, 9, 9}, {9, 9}};
        std::fill(copy.vertices.begin(), copy.vertices.end(), untouched);
        std::fill(copy.indices.begin(), copy.indices.end(), 77777u);
        REQUIRE(plan->write(glyph_span{2, 3}, into(std::span{copy.vertices}, std::span{copy.indices})));
        std::size_t changed = 0, expected = 0;
        for (const auto& v : copy.vertices) changed += v.position == untouched.position ? 0u : 1u;
        for (const part p : all_parts) expected += plan->range(2, p).vertex_count;
        CHECK(changed == expected);
        CHECK(static_cast<std::size_t>(std::count(copy.indices.begin(), copy.indices.end(), 77777u)) ==
              copy.indices.size() - plan->range(2, part::front).index_count * 2 -
                  plan->range(2, part::side).index_count);

        const auto short_one = plan->write(
            glyph_span{0, 1}, into(std::span{copy.vertices}.first(whole.vertices.size() - 1), std::span{copy.indices}));
        CHECK(short_one == error::buffer_too_small);
    }
}

TEST_CASE("instances of meshes are the placed glyphs, up to rounding", "[text]")
{
    test::toy_font font;
    const auto frame = GENERATE(right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up);
    const auto unit = GENERATE(output_unit::em, output_unit::font_units, output_unit::unit_box);
    auto mesher = text_mesher{font}.with(extruded<>{.texture = texture_mapping::box});
    const auto plan = mesher.plan("oEx oo\nEiE", {.unit = unit, .texture_over = texture_box::glyph, .frame = frame});
    REQUIRE(plan);
    const auto placed = test::written<full_mesh>(*plan);
    full_mesh meshes;
    REQUIRE(plan->write_meshes(into(meshes.vertices, meshes.indices)));
    CHECK(meshes.vertices.size() == plan->meshes_size().vertices);
    CHECK(meshes.indices.size() == plan->meshes_size().indices());
    CHECK(plan->meshes().size() == 4);

    std::vector<glyph_instance> instances;
    plan->write_instances([&](const glyph_instance& i) noexcept { instances.push_back(i); });
    REQUIRE(instances.size() == plan->glyphs().size());
    const float step = static_cast<float>(4.0 * plan->position_step()) * (unit == output_unit::font_units ? 1000.0f
                                                                          : unit == output_unit::unit_box ? 2.0f
                                                                                                          : 1.0f);
    std::vector<std::size_t> seen(plan->glyphs().size());
    for (std::size_t k = 0; k < instances.size(); ++k) {
        const glyph_instance& i = instances[k];
        const glyph_mesh& mesh = plan->meshes()[i.mesh];
        REQUIRE(k >= mesh.first_instance);
        REQUIRE(k < mesh.first_instance + mesh.glyph_count);
        CHECK(i.id == plan->glyphs()[i.glyph].id);
        CHECK(i.cluster == plan->glyphs()[i.glyph].cluster);
        ++seen[i.glyph];
        for (const part p : all_parts) {
            const mesh_range here = plan->range(i.glyph, p), alone = plan->mesh_part(i.mesh, p);
            REQUIRE(here.vertex_count == alone.vertex_count);
            REQUIRE(here.index_count == alone.index_count);
            for (std::uint32_t v = 0; v < here.vertex_count; ++v) {
                const test::full_vertex& a = placed.vertices[here.first_vertex + v];
                const test::full_vertex& b = meshes.vertices[alone.first_vertex + v];
                const vec3 moved = {b.position.x + i.translation.x, b.position.y + i.translation.y,
                                    b.position.z + i.translation.z};
                const vec3 off = test::subtract(a.position, moved);
                REQUIRE((std::fabs(off.x) <= step && std::fabs(off.y) <= step && std::fabs(off.z) <= step));
                REQUIRE(a.normal == b.normal);
                REQUIRE(std::fabs(a.uv.x - b.uv.x) + std::fabs(a.uv.y - b.uv.y) < 1e-6f);
            }
            for (std::uint32_t n = 0; n < here.index_count; ++n)
                REQUIRE(placed.indices[here.first_index + n] - here.first_vertex ==
                        meshes.indices[alone.first_index + n] - alone.first_vertex);
        }
    }
    CHECK(seen == std::vector<std::size_t>(seen.size(), 1));
}

TEST_CASE("the meshes of a run of some glyphs are the meshes of every text with these glyphs", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    glyph_run run;
    full_mesh meshes;
    std::vector<mesh_range> fronts;
    const auto of_text = mesher.plan("x oE");
    REQUIRE(of_text);
    REQUIRE(of_text->write_meshes(into(meshes.vertices, meshes.indices)));
    for (std::size_t k = of_text->meshes().size(); k-- > 0;) {  // in another order
        REQUIRE(run.glyphs.push_back({of_text->meshes()[k].id}));
        fronts.push_back(of_text->mesh_part(k, part::front));
    }
    full_mesh letters;
    const auto of_run = mesher.plan(run);
    REQUIRE(of_run);
    REQUIRE(of_run->write_meshes(into(letters.vertices, letters.indices)));
    REQUIRE(of_run->meshes().size() == fronts.size());
    for (std::size_t k = 0; k < fronts.size(); ++k) {
        CHECK(of_run->meshes()[k].id == run.glyphs[k].id);
        const mesh_range here = of_run->mesh_part(k, part::front);
        REQUIRE(here.vertex_count == fronts[k].vertex_count);
        for (std::uint32_t v = 0; v < here.vertex_count; ++v)
            REQUIRE(letters.vertices[here.first_vertex + v].position ==
                    meshes.vertices[fronts[k].first_vertex + v].position);
    }
}

TEST_CASE("without reuse every glyph is a mesh of its own", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = mesher.plan("oooE", {.reuse = false});
    CHECK(plan->meshes().size() == 4);
    CHECK(plan->meshes_size() == plan->size());
}

TEST_CASE("the step between positions grows with the distance from the origin", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    CHECK(mesher.plan("i")->position_step() == std::ldexp(1.0, -24));  // 0.25 <= 0.5 em high, at most
    double last = 0.0;
    for (const double start : {0.0, 2e3, 2e4, 2e6, 2e9}) {
        const glyph_run run = run_of(3, 600.0, [](std::size_t) { return glyph_id{1}; }, start);
        const auto plan = mesher.plan(run);
        CHECK(plan->position_step() > last);
        CHECK(plan->position_step() <= (start / 1000.0 + 2.0) * std::ldexp(1.0, -23));
        last = plan->position_step();
    }
    // The same in every unit, but for the place within a power of two.
    const double em = mesher.plan("EEEE")->position_step();
    const double pixels = mesher.plan("EEEE", {.unit = output_unit::pixels, .pixels_per_em = 1024.0})->position_step();
    CHECK(em == pixels);
}

TEST_CASE("triangles higher than two steps are never flipped by rounding, and all flipped ones are counted", "[text]")
{
    test::toy_font font;
    const auto frame = GENERATE(right_handed_y_up, left_handed_z_up);
    text_mesher mesher{font};
    bool some_flipped = false;
    for (double start = 1.0; start < 1e13; start *= 7.0) {
        const glyph_run run = run_of(2, 700.0, [](std::size_t i) { return static_cast<glyph_id>(1 + i); }, start);
        const auto plan = test::required(mesher.plan(run, {.frame = frame}));
        std::uint64_t thin = 0;
        for (const drawn_glyph& s : plan->glyphs()) {
            const solid& shape = s.built->form();
            for (const triangle t : shape.triangles) {
                const point a = grid{s.built->cells()}.place(shape.points[t.a]),
                            b = grid{s.built->cells()}.place(shape.points[t.b]),
                            c = grid{s.built->cells()}.place(shape.points[t.c]);
                const double longest = std::fmax(length(b - a), std::fmax(length(c - b), length(a - c)));
                thin += cross(b - a, c - a) / longest / 1000.0 <= 2.0 * plan->position_step() ? 1u : 0u;
            }
        }
        const std::uint64_t flipped = flipped_triangles(*plan);
        CHECK(flipped <= thin);
        some_flipped = some_flipped || flipped != 0;
        if (start < 1e3) CHECK(flipped == 0);

        std::uint64_t counted = 0;  // from the mesh as it is written
        const auto m = test::written<full_mesh>(*plan);
        const mesh_range front = plan->range(part::front);
        for (std::uint32_t i = front.first_index; i < front.first_index + front.index_count; i += 3) {
            const auto& a = m.vertices[m.indices[i]];
            const test::cross_product n{test::subtract(m.vertices[m.indices[i + 1]].position, a.position),
                                        test::subtract(m.vertices[m.indices[i + 2]].position, a.position)};
            counted += n.along(a.normal) > 0.0 ? 0u : 1u;
        }
        CHECK(flipped == counted);
    }
    CHECK(some_flipped);
}

TEST_CASE("10,000 different glyphs need memory in proportion, less than half of the mesh's", "[text]")
{
    recorded_outlines font{1000.0};
    for (std::size_t i = 0; i < 10'000; ++i) {
        REQUIRE(font.add([&](auto& pen) {
            const double corners = 5.0 + static_cast<double>(i % 60);
            pen.move({500.0, 0.0});
            for (double k = 1.0; k < corners; ++k) {
                const double turn = 6.28318530717958648 * k / corners, r = 400.0 + 0.01 * static_cast<double>(i);
                pen.line({r * std::cos(turn), r * std::sin(turn)});
            }
            pen.close();
        }));
    }
    const auto peak_of = [&](std::size_t count) {
        test::counting_memory counted;
        text_mesher mesher{font, counted.source()};
        const glyph_run run = run_of(count, 1000.0, [](std::size_t i) { return static_cast<glyph_id>(i); });
        std::size_t first_peak = 0;
        for (int i = 0; i < 3; ++i) {
            const auto plan = test::required(mesher.plan(run));
            CHECK(plan->meshes().size() == count);
            const double output = static_cast<double>(plan->size().vertices * 32 + plan->size().indices() * 4);
            CHECK(static_cast<double>(counted.peak) <= 0.5 * output);
            if (i == 0) first_peak = counted.peak;
            CHECK(counted.peak <= first_peak + first_peak / 100);
        }
        return static_cast<double>(counted.peak);
    };
    const double few = peak_of(2'500), many = peak_of(10'000);
    CHECK(many < 4.8 * few);
}

TEST_CASE("100,000 characters draw each glyph once and need memory in proportion", "[text]")
{
    test::counting_memory counted;
    test::toy_font font;
    text_mesher mesher{font, counted.source()};
    std::string text;
    for (std::size_t i = 0; i < 100'000; ++i) text += "oEixo E"[i * 31 % 7];
    const auto plan = test::required(mesher.plan(text));
    CHECK(plan->meshes().size() == 4);
    CHECK(plan->report().complete());
    const std::uint64_t output = plan->size().vertices * 32 + plan->size().indices() * 4;
    CHECK(counted.peak * 2 <= output);
    std::uint64_t instances = 0;
    for (const glyph_mesh& m : plan->meshes()) instances += m.glyph_count;
    CHECK(instances == plan->glyphs().size());
}

TEST_CASE("each triangle's hit is the glyph and the cluster that it was written for", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(bevelled{.width = 0.01f});
    for (const bool merge : {false, true}) {
        auto plan = test::required(mesher.plan("oEi x~o\noEq oooo", {.merge = merge}));
        for (const part p : plan->parts()) {
            std::uint32_t triangle = 0;
            for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
                for (std::uint32_t t = 0; t < plan->range(g, p).index_count / 3; ++t, ++triangle) {
                    const mesh_hit hit = plan->hit(p, triangle);
                    const mesh_hit whole = plan->hit(plan->range(p).first_index / 3 + triangle);
                    CHECK((whole.glyph == g && whole.of_run == hit.of_run && whole.cluster == hit.cluster));
                    CHECK(hit.glyph == g);
                    CHECK(hit.of_run == plan->owner(g, p, t));
                    if (hit.of_run == shared_glyph)
                        CHECK(hit.cluster == plan->glyphs()[g].cluster);
                    else
                        CHECK(hit.cluster == plan->run().glyphs[hit.of_run].cluster);
                }
            }
            CHECK(triangle == plan->range(p).index_count / 3);
        }
    }
}

TEST_CASE("the whole range is the size, and a triangle of it is found in flat text too", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    auto plan = mesher.plan("oE x");
    REQUIRE(plan);
    CHECK(plan->range() == plan->range(part::front));
    CHECK(plan->range().vertex_count == plan->size().vertices);
    CHECK(plan->range().index_count == plan->size().indices());
    CHECK(plan->hit(0u).glyph == 0);
    CHECK(plan->hit(plan->range().index_count / 3 - 1).glyph == plan->glyphs().size() - 1);
    CHECK(mesher.plan(" ")->range() == mesh_range{});
}

TEST_CASE("each instance's hit is its glyph and cluster, as in the whole mesh", "[text]")
{
    test::toy_font font;
    for (const bool merge : {false, true}) {
        text_mesher mesher{font};
        glyph_run run;
        REQUIRE(layout(font, "oEi x~o\noEq oooo", {}, {}, run));
        run.glyphs[0].origin.x += run.glyphs[1].origin.x * 0.5;  // onto its neighbour
        auto plan = test::required(mesher.plan(run, {.merge = merge}));
        REQUIRE(plan->meshes().size() < plan->glyphs().size());
        REQUIRE((plan->members(0).size() == 2) == merge);
        std::size_t instances = 0;
        plan->write_instances([&](const glyph_instance& i) noexcept {
            ++instances;
            for (const part p : plan->parts()) {
                const std::uint32_t before = (plan->range(i.glyph, p).first_index - plan->range(p).first_index) / 3;
                for (std::uint32_t t = 0; t < plan->mesh_part(i.mesh, p).index_count / 3; ++t) {
                    const mesh_hit hit = plan->hit(i, p, t), whole = plan->hit(p, before + t);
                    CHECK(hit.glyph == i.glyph);
                    CHECK(hit.of_run == whole.of_run);
                    CHECK(hit.cluster == whole.cluster);
                    if (!merge) CHECK(hit.cluster == i.cluster);
                }
            }
        });
        CHECK(instances == plan->glyphs().size());
    }
}

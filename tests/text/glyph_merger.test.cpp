// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/oracle.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/extrude/cap_normals.hpp>
#include <typemesh/extrude/shared_normals.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstring>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

/// The toy font's glyphs at pens of our own, in thousandths of an em.
glyph_run run_of(std::vector<placed_glyph> glyphs)
{
    glyph_run run;
    run.units_per_em = 1000.0;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        glyphs[i].cluster = static_cast<cluster_id>(i);
        REQUIRE(run.glyphs.push_back(glyphs[i]));
    }
    return run;
}

constexpr glyph_id ring_glyph = 1, bars_glyph = 2, star = 3, blank = 4, stick = 5, broken = 6;

std::vector<std::uint32_t> indices_of(const full_mesh& m, const auto& plan, std::size_t glyph)
{
    std::vector<std::uint32_t> own;
    for (const part p : all_parts) {
        const mesh_range r = plan.range(glyph, p);
        own.insert(own.end(), m.indices.begin() + r.first_index, m.indices.begin() + r.first_index + r.index_count);
    }
    return own;
}

double volume_of(text_mesher<>& mesher, const glyph_run& run, bool merge)
{
    auto plan = test::required(mesher.plan(run, {.unit = output_unit::font_units, .merge = merge}));
    const full_mesh m = test::written<full_mesh>(*plan);
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        const auto own = indices_of(m, *plan, g);
        const auto c = test::examine(m.vertices, own);
        CHECK(c.unmatched_edges == 0);
        CHECK(c.crowded_slanted == 0);
        CHECK(c.zero_area == 0);
    }
    return test::volume(m.vertices, m.indices);
}

template <class T>
std::vector<T> list(std::span<const T> s)
{
    return {s.begin(), s.end()};
}

/// Refuses what has more than a number of points.
struct few_points : flat {
    std::size_t most = 0;

    option_bits cache_key() const noexcept { return {static_cast<std::uint32_t>(most)}; }
    result<part_sizes> plan(const region& r) const noexcept
    {
        if (r.points().size() > most) return error::refused_by_user;
        return flat::plan(r);
    }
};

}  // namespace

TEST_CASE("A group that a policy refuses is left out as a glyph is, and the text goes on", "[text][merge]")
{
    test::toy_font font;
    text_mesher measured{font};
    const glyph_run apart = run_of({{ring_glyph, 0, {0, 0}}, {ring_glyph, 0, {9000, 0}}});
    const std::size_t points = static_cast<std::size_t>(test::required(measured.plan(apart, {}))->contour_points()) / 2;

    auto mesher = text_mesher{font}.with(few_points{{}, points});
    const glyph_run run = run_of({{ring_glyph, 0, {0, 0}}, {ring_glyph, 0, {150, 0}}, {ring_glyph, 0, {9000, 0}}});
    auto unmerged = test::required(mesher.plan(run, {}));
    CHECK(unmerged->glyphs().size() == 3);
    auto plan = test::required(mesher.plan(run, {.merge = true}));
    CHECK(plan->glyphs().size() == 1);
    CHECK(plan->glyphs()[0].glyph == 2);
    CHECK(plan->report().first_refusal == error::refused_by_user);
    CHECK(plan->report().refused != 0);
}

TEST_CASE("glyphs that overlap become one solid with the volume of their union", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    // i is a box of 100 x 500; these three overlap by 50 x 500 and 100 x 400
    const glyph_run run =
        run_of({{stick, 0, {0, 0}}, {stick, 0, {50, 0}}, {stick, 0, {50, 100}}, {stick, 0, {1000, 0}}});
    const double depth = 200.0, box = 100.0 * 500.0;
    CHECK(volume_of(mesher, run, false) == Catch::Approx(4 * box * depth));
    CHECK(volume_of(mesher, run, true) == Catch::Approx((2 * box + 150.0 * 500.0 + 100.0 * 100.0 - box) * depth));
}

TEST_CASE("merging lists every glyph that is drawn once, and groups are chains of meeting outlines", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const glyph_run run = run_of({{stick, 0, {0, 0}},          // 0: touches 3 along an edge
                                  {ring_glyph, 0, {1000, 0}},  // 1: holds 4 in its hole
                                  {blank, 0, {0, 0}},          // 2: blank
                                  {stick, 0, {100, 0}},        // 3
                                  {stick, 0, {1100, -0}},      // 4: crosses the ring of 1
                                  {broken, 0, {0, 0}},         // 5: refused
                                  {bars_glyph, 0, {3000, 0}},  // 6: alone
                                  {star, 0, {3100, 150}}}      // 7: inside the bays of 6 and over its stem
    );
    auto plan = test::required(mesher.plan(run, {.merge = true}));
    REQUIRE(plan->glyphs().size() == 3);
    using numbers = std::vector<std::uint32_t>;
    CHECK(list(plan->members(0)) == numbers{0, 3});
    CHECK(list(plan->members(1)) == numbers{1, 4});
    CHECK(list(plan->members(2)) == numbers{6, 7});
    CHECK(plan->report().blank == 1);
    CHECK(plan->report().refused == 1);
    CHECK(plan->glyphs()[1].id == ring_glyph);
}

TEST_CASE("a glyph in another's hole, and one in its bay, stay alone while they do not touch it", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const glyph_run run =
        run_of({{0, 0, {0, 0}}, {stick, 0, {100, 100}}, {bars_glyph, 0, {1000, 0}}, {stick, 0, {1100, 150}}});
    auto plan = test::required(mesher.plan(run, {.merge = true, .draw_missing = true}));
    CHECK(plan->glyphs().size() == 3);  // the last i crosses the E's middle bar; the first stands in the box of .notdef
    CHECK(list(plan->members(2)) == std::vector<std::uint32_t>{2, 3});
}

TEST_CASE("a text whose outlines do not meet is the same with and without merging, bit by bit", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    full_mesh apart, merged;
    REQUIRE(mesher.build("oEi oxE\nEio", into(apart.vertices, apart.indices)));
    REQUIRE(mesher.build("oEi oxE\nEio", into(merged.vertices, merged.indices), {.merge = true}));
    CHECK(apart.indices == merged.indices);
    REQUIRE(apart.vertices.size() == merged.vertices.size());
    const std::size_t bytes = apart.vertices.size() * sizeof(test::full_vertex);
    CHECK(std::memcmp(apart.vertices.data(), merged.vertices.data(), bytes) == 0);
}

TEST_CASE("a triangle's owner has its corners on its outline, and what two share is nobody's", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const glyph_run run = run_of({{ring_glyph, 0, {0, 0}}, {ring_glyph, 0, {400, 30}}, {bars_glyph, 0, {700, 20}}});
    auto plan = test::required(mesher.plan(run, {.unit = output_unit::font_units, .merge = true}));
    REQUIRE(plan->glyphs().size() == 1);
    const full_mesh m = test::written<full_mesh>(*plan);

    std::vector<std::vector<typemesh::point>> outlines;  // each glyph's own points, placed
    for (const placed_glyph& g : run.glyphs) {
        glyph_run alone = run_of({g});
        text_mesher other{font};
        full_mesh own;
        REQUIRE(other.build(alone, into(own.vertices, own.indices), {.unit = output_unit::font_units}));
        outlines.emplace_back();
        for (const auto& v : own.vertices) outlines.back().push_back({v.position.x, v.position.y});
    }
    std::uint32_t shared = 0, owned = 0;
    for (const part p : all_parts) {
        const mesh_range r = plan->range(0, p);
        for (std::uint32_t t = 0; t < r.index_count / 3; ++t) {
            const std::uint32_t whose = plan->owner(0, p, t);
            if (whose == shared_glyph) {
                ++shared;
                CHECK(p != part::side);
                continue;
            }
            ++owned;
            REQUIRE(whose < 3);
            if (p == part::side) continue;
            int on_outline = 0;
            for (int c = 0; c < 3; ++c) {
                const auto at = m.vertices[m.indices[r.first_index + 3 * t + std::uint32_t(c)]].position;
                on_outline += std::any_of(outlines[whose].begin(), outlines[whose].end(), [&](typemesh::point q) {
                    return std::fabs(q.x - at.x) < 0.01 && std::fabs(q.y - at.y) < 0.01;
                });
            }
            CHECK(on_outline == 3);
        }
    }
    CHECK(shared > 0);
    CHECK(owned > shared);
}

TEST_CASE("the triangles of a merged wall in segments all have the owner of the whole wall", "[text][merge]")
{
    const glyph_run run = run_of({{ring_glyph, 0, {0, 0}}, {ring_glyph, 0, {400, 30}}, {bars_glyph, 0, {700, 20}}});
    const auto check = [&run]<class Normals>(Normals normals, std::uint32_t segments) {
        CAPTURE(segments);
        test::toy_font font;
        text_mesher whole{font, extruded<Normals>{.normals = normals}};
        text_mesher divided{font, extruded<Normals>{.normals = normals, .segments = segments}};
        const text_options merged{.unit = output_unit::font_units, .merge = true};
        auto one = test::required(whole.plan(run, merged)), many = test::required(divided.plan(run, merged));
        REQUIRE(many->glyphs().size() == 1);
        const full_mesh a = test::written<full_mesh>(*one), b = test::written<full_mesh>(*many);
        const auto corner = [](const full_mesh& m, std::uint32_t index) {
            const auto p = m.vertices[m.indices[index]].position;
            return typemesh::point{p.x, p.y};
        };
        const mesh_range walls = one->range(0, part::side), pieces = many->range(0, part::side);
        REQUIRE(pieces.index_count == segments * walls.index_count);
        std::uint32_t owners[3] = {}, astray = 0, others = 0;
        for (std::uint32_t t = 0; t < pieces.index_count / 3; ++t) {
            const std::uint32_t wall = t / (2 * segments), whose = many->owner(0, part::side, t);
            REQUIRE(whose < 3);
            ++owners[whose];
            others += whose != one->owner(0, part::side, 2 * wall) || whose != one->owner(0, part::side, 2 * wall + 1);
            others += many->hit(part::side, t).of_run != whose;
            for (std::uint32_t c = 0; c < 3; ++c) {  // each corner is above one of the wall's two points
                const auto at = corner(b, pieces.first_index + 3 * t + c);
                const auto from = corner(a, walls.first_index + 6 * wall),
                           to = corner(a, walls.first_index + 6 * wall + 2);
                astray += !(at == from) && !(at == to);
            }
        }
        CHECK(astray == 0);
        CHECK(others == 0);
        for (const std::uint32_t triangles : owners) CHECK(triangles != 0);
    };
    for (const std::uint32_t segments : {1u, 2u, 5u}) {
        check(curve_normals{}, segments);
        check(shared_normals{}, segments);
        check(cap_normals{}, segments);
    }
}

TEST_CASE("merging far from the origin gives the same solid, moved", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan_at = [&](double far_off) {
        const glyph_run run = run_of({{ring_glyph, 0, {far_off, 0}}, {ring_glyph, 0, {far_off + 400, 30}}});
        auto plan = test::required(mesher.plan(run, {.merge = true}));
        REQUIRE(plan->glyphs().size() == 1);
        return plan->size();
    };
    CHECK(plan_at(0).vertices == plan_at(0x1p30).vertices);
    CHECK(plan_at(0).triangles == plan_at(-0x1p36).triangles);
}

TEST_CASE("a group too wide for the fine grid is merged on a coarser one", "[text][merge]")
{
    test::toy_font font;
    text_mesher mesher{font};
    std::vector<placed_glyph> glyphs;
    // 1,050,000 units: 2^29 cells of 1/512
    for (int k = 0; k < 14'000; ++k) glyphs.push_back({stick, 0, {k * 75.0, 0}});
    const glyph_run run = run_of(glyphs);
    auto plan = test::required(mesher.plan(run, {.merge = true}));
    REQUIRE(plan->glyphs().size() == 1);
    CHECK(plan->glyphs()[0].built->cells() < 512.0);
    CHECK(plan->members(0).size() == glyphs.size());
    const full_mesh m = test::written<full_mesh>(*plan);
    CHECK(test::examine(m.vertices, m.indices).unmatched_edges == 0);
}

TEST_CASE("merging reports that memory ran out at whichever request, and the mesher works afterwards", "[text][merge]")
{
    test::toy_font font;
    const glyph_run run = run_of(
        {{ring_glyph, 0, {0, 0}}, {ring_glyph, 0, {400, 30}}, {bars_glyph, 0, {700, 20}}, {stick, 0, {5000, 0}}});
    std::size_t failures = 0;
    for (std::size_t fail_at = 1;; ++fail_at) {
        test::counting_memory counted;
        counted.fail_at = fail_at;
        counted.fail_once = true;
        text_mesher mesher{font, counted.source()};
        auto plan = mesher.plan(run, {.merge = true});
        if (plan && counted.requests < fail_at) break;
        if (!plan) {
            CHECK(plan.error().code == error::out_of_memory);
            ++failures;
        }
        auto again = test::required(mesher.plan(run, {.merge = true}));
        CHECK(again->glyphs().size() == 2);
    }
    CHECK(failures > 10);
}

TEST_CASE("merging allocates nothing once it has seen a text of that size", "[text][merge]")
{
    test::toy_font font;
    test::counting_memory counted;
    text_mesher mesher{font, counted.source()};
    const glyph_run run = run_of(
        {{ring_glyph, 0, {0, 0}}, {ring_glyph, 0, {400, 30}}, {bars_glyph, 0, {700, 20}}, {stick, 0, {5000, 0}}});
    for (int warm = 0; warm < 3; ++warm) REQUIRE(mesher.plan(run, {.merge = true}));
    const auto before = counted.requests;
    REQUIRE(mesher.plan(run, {.merge = true}));
    CHECK(counted.requests == before);
}

TEST_CASE("regions of fonts of different units per em are joined on the finer grid", "[text][merge]")
{
    const auto square_region = [](contours& loops, workspace& space, std::int32_t size) {
        loops.clear();
        loops.tolerance = 0.001 * size;
        REQUIRE((loops.starts.push_back(0) && loops.starts.push_back(4)));
        for (const grid_point p : {grid_point{0, 0}, {size, 0}, {size, size}, {0, size}})
            REQUIRE((loops.points.push_back(p) && loops.edges.push_back({})));
        static const curve line[1] = {};
        loops.curves = line;
        return *test::required(fill(loops, fill_rule::non_zero, space));
    };
    workspace space;
    contours of_1000, of_2048;
    region_union group;
    group.begin(grid{512.0});  // of 2048 units per em; a thousandth of an em is 2.048 of these
    REQUIRE(group.add(square_region(of_2048, space, 1024 * 512), 1.0, 0, 0));
    REQUIRE(group.add(square_region(of_1000, space, 500 * 512), 2.048, 1024 * 256, 1024 * 256));
    const auto joined = test::required(group.join(space));
    CHECK(joined->points().size() == 8);
    CHECK(joined->outers() == 1);
    CHECK(joined->tolerance() == (std::max)(0.001 * 1024 * 512, 2.048 * (0.001 * 500 * 512)));
    grid_point high{0, 0};
    for (const grid_point p : joined->points()) high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
    CHECK(high == grid_point{1024 * 768, 1024 * 768});  // half an em and a quarter, exactly

    CHECK(group.add(square_region(of_1000, space, 1 << 20), 1024.0, 0, 0).error().code == error::outline_beyond_grid);
}

TEST_CASE("no triangle of merged glyphs is low where other diagonals avoid it", "[text][merge][low]")
{
    // Two glyphs that overlap. The first has a long edge with a corner a hair below it: cut off along that edge, the
    // corner's triangle is lower than 2^-20 em; cut to the far corner, it is not.
    recorded_outlines drawings{1000.0};
    const point corners[] = {{0, 0}, {100'001 / 512.0, 1 / 512.0}, {200'001 / 512.0, 2 / 512.0}, {0, 200}};
    std::size_t low_otherwise = 0;
    for (int k = 0; k < 8; ++k) {
        const auto place = [k](point p) {
            if (k & 1) p = {-p.x, p.y};
            if (k & 2) p = {p.x, -p.y};
            return k & 4 ? point{p.y, p.x} : p;
        };
        const bool mirrored = (k == 1 || k == 2 || k == 4 || k == 7);
        REQUIRE(drawings.add([&](auto& pen) {
            for (int i = 0; i < 4; ++i) {
                const point p = place(corners[mirrored ? 3 - i : i]);
                i == 0 ? pen.move(p) : pen.line(p);
            }
            pen.close();
        }));
        REQUIRE(drawings.add([&](auto& pen) {  // over the corner that is far from all the others
            const point m = place(corners[3]);
            pen.move(m + point{-20, -20});
            for (const point by : {point{20, -20}, point{20, 20}, point{-20, 20}}) pen.line(m + by);
            pen.close();
        }));
    }
    text_mesher mesher = text_mesher{drawings}.with(flat{});
    for (glyph_id k = 0; k < 16; k += 2) {
        const glyph_run run = run_of({{k, 0, {0, 0}}, {k + 1, 0, {0, 0}}});
        const auto plan = test::required(mesher.plan(run, {.merge = true}));
        REQUIRE(plan->glyphs().size() == 1);
        const built_glyph& merged = *plan->glyphs()[0].built;
        const solid& form = merged.form();
        const triangle_heights heights{{.cells = merged.cells(), .units_per_em = 1000.0}};
        const auto low_of = [&](std::span<const triangle> triangles) {
            return std::count_if(triangles.begin(), triangles.end(), [&](const triangle& t) {
                return heights.is_low(form.points[t.a], form.points[t.b], form.points[t.c]);
            });
        };
        INFO("pair " << k / 2);
        CHECK(low_of(form.triangles) == 0);

        contours loops;  // the same region, of which nobody knows the em
        for (const grid_point p : form.points) REQUIRE((loops.points.push_back(p) && loops.edges.push_back({})));
        for (const std::uint32_t start : form.starts) REQUIRE(loops.starts.push_back(start));
        workspace space;
        triangle_list plain;
        REQUIRE(monotone{}.prove(loops, space, plain));
        low_otherwise += static_cast<std::size_t>(low_of(plain.view()));
    }
    CHECK(low_otherwise > 0);
}

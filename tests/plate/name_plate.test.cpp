// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/plate/impl/rim_offset.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/typemesh.hpp>

#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

struct corner {
    vec3 position, normal;
    part of = {};
};
struct corner_mesh {
    std::vector<corner> vertices;
    std::vector<std::uint32_t> indices;
};

}  // namespace

template <>
struct typemesh::vertex_traits<corner> {
    static constexpr attribute wants = attribute::position | attribute::normal | attribute::part;
    corner operator()(const surface_point<wants>& p) const noexcept { return {p.position, p.normal, p.part}; }
};

namespace {

corner_mesh written(const name_plate& plate, std::size_t k)
{
    corner_mesh m;
    REQUIRE(plate.write(k, into(m.vertices, m.indices)));
    REQUIRE(m.vertices.size() == plate.solid(k).size().vertices);
    REQUIRE(m.indices.size() == plate.solid(k).size().indices());
    return m;
}

inspect::mesh_measure measured(const corner_mesh& m)
{
    return inspect::measure(inspect::mesh_view{m.vertices, m.indices});
}

/// The laws of every plate: closed, strictly 2-manifold, with the volume of its slabs, normals that agree with the
/// triangles.
void check_solid(const name_plate& plate, std::size_t k)
{
    const corner_mesh m = written(plate, k);
    const auto faults = inspect::check_manifoldness(inspect::mesh_view{m.vertices, m.indices});
    CHECK(faults.open_edges == 0);
    CHECK(faults.crowded_edges == 0);
    CHECK(faults.pinched_points == 0);
    CHECK(faults.bad_triangles == 0);
    const double unit = plate.placement().at.unit_per_cell;
    const double volume = unit * unit * plate.solid(k).volume();
    CHECK(volume > 0.0);
    CHECK(measured(m).volume == Catch::Approx(volume).epsilon(1e-5));
    std::size_t long_or_short = 0, inward = 0;
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3) {
        const corner &a = m.vertices[m.indices[i]], &b = m.vertices[m.indices[i + 1]],
                     &c = m.vertices[m.indices[i + 2]];
        const auto normal = inspect::cross(inspect::to_place(b.position) - inspect::to_place(a.position),
                                           inspect::to_place(c.position) - inspect::to_place(a.position));
        for (const corner& v : {a, b, c}) {
            const double length = std::sqrt(inspect::dot(inspect::to_place(v.normal), inspect::to_place(v.normal)));
            long_or_short += !(std::fabs(length - 1.0) <= 1e-5);
            inward += !(inspect::dot(normal, inspect::to_place(v.normal)) >= 0.0);
        }
    }
    CHECK(long_or_short == 0);
    CHECK(inward == 0);
}

/// Texts in Latin, Arabic and Han.
const struct {
    const char* font;
    const char* text;
} plate_texts[] = {
    {test::dejavu, "B8g&%@\xC3\x84i"},
    {"truetype/liberation/LiberationSerif-Italic.ttf", "fAffi Qg"},
    {test::amiri, "\xD8\xA7\xD9\x84\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85 \xD8\xB9\xD9\x84\xD9\x8A\xD9\x83\xD9\x85"},
    {test::sawarabi, "\xE5\x9B\xBD\xE9\xBE\x8D\xE6\xB0\xB8"}};

/// Ten thousand units per em.
struct fine_font : test::toy_font {
    [[nodiscard]] double units_per_em() const noexcept { return 10000.0; }
};

/// The exact areas of the plate's caps, by its own triangles: doubled.
std::int64_t area(const name_plate& plate, cell_set cells) { return plate.cells().doubled_area(cells); }

constexpr plate_style all_styles[] = {plate_style::standing, plate_style::engraved, plate_style::cut,
                                      plate_style::inlay};

}  // namespace

TEST_CASE("a plate of every style is closed, strictly 2-manifold, and has the volume of its slabs", "[plate]")
{
    name_plate plate;
    for (const auto& c : plate_texts) {
        auto font = test::opened(c.font);
        text_mesher mesher{font, flat{}};
        for (const float size : {1.0f, 12.0f}) {
            auto text = test::required(mesher.plan(c.text, {.size = size}));
            for (const plate_style style : all_styles) {
                for (const float margin : {0.2f, -0.1f}) {
                    INFO(c.font << " " << size << " style " << static_cast<int>(style) << " margin " << margin);
                    const auto done = plate.plan(*text, {.style = style, .margin = margin}, constrained_delaunay{});
                    INFO(done.error().message());
                    REQUIRE(done);
                    REQUIRE(plate.solid_count() == (style == plate_style::inlay ? 2u : 1u));
                    CHECK(plate.is_manifold());
                    for (std::size_t k = 0; k < plate.solid_count(); ++k) check_solid(plate, k);
                    constexpr cell_set body = name_plate::body(), letters = name_plate::text();
                    CHECK(area(plate, body & letters) > 0);
                    CHECK(area(plate, body & ~letters) + area(plate, body & letters) == area(plate, body));
                }
            }
        }
    }
}

TEST_CASE("bevels and fillets leave plates closed and strictly 2-manifold, with the volume of their sections",
          "[plate]")
{
    name_plate plate;
    detail::rim_offset offset;
    workspace space;
    contours loops;
    const char* const texts[] = {"R&", "fQ", "\xD8\xB3\xD9\x84\xD8\xA7", "\xE9\xBE\x8D"};
    const char* const* own = texts;
    for (const auto& c : plate_texts) {
        auto font = test::opened(c.font);
        text_mesher mesher{font, flat{}};
        const char* const short_text = *own++;
        for (const float size : {1.0f, 12.0f}) {
            auto text = test::required(mesher.plan(short_text, {.size = size}));
            for (const plate_style style : all_styles) {
                INFO(c.font << " " << size << " style " << static_cast<int>(style));
                constexpr float bevel = 0.008f;
                plate_options how{.style = style, .bevel = bevel, .fillet = 0.02f, .round_bevels = true};
                if (size < 2.0f) how.round_bevels = false;
                REQUIRE(plate.plan(*text, how, constrained_delaunay{}));
                CHECK(plate.is_manifold());
                for (std::size_t k = 0; k < plate.solid_count(); ++k) check_solid(plate, k);
                CHECK(same(plate.rims().bevel, bevel));
                CHECK(same(plate.rims().fillet, style == plate_style::standing ? 0.02f : 0.0f));
                if (how.round_bevels) continue;
                // A chamfer's section is the offset at half its width: Simpson's rule, by offsets made for this alone.
                const double cell = plate.placement().at.em_per_cell;
                const auto area_within = [&](cell_set cells, float by) {
                    const auto r = plate.cells().trace(cells, space, loops);
                    REQUIRE(r);
                    REQUIRE(offset.plan(*r, detail::rim_section::chamfer, by, 0.0, monotone{}));
                    return 0.5 * cell * cell * static_cast<double>(offset.doubled_area());
                };
                const auto em_area = [&](cell_set cells) {
                    return 0.5 * cell * cell * static_cast<double>(area(plate, cells));
                };
                const auto of_bevel = [&](cell_set cells) {
                    return as_double(bevel) / 6.0 *
                           (em_area(cells) + 4.0 * area_within(cells, 0.5f * bevel) + area_within(cells, bevel));
                };
                constexpr cell_set body = name_plate::body(), letters = name_plate::text(), rest = body & ~letters;
                const double wide = as_double(bevel);
                double wanted = 0.0;
                if (style == plate_style::engraved)
                    wanted =
                        of_bevel(body) + (0.05 - wide) * em_area(body) + (0.05 - wide) * em_area(rest) + of_bevel(rest);
                if (style == plate_style::cut) wanted = 2.0 * of_bevel(rest) + (0.1 - 2.0 * wide) * em_area(rest);
                if (style == plate_style::inlay)
                    wanted = 2.0 * of_bevel(body) + (0.1 - 2.0 * wide) * em_area(body) - 0.05 * em_area(body & letters);
                const double volume = cell * cell * plate.solid(0).volume();
                if (style != plate_style::standing) CHECK(volume == Catch::Approx(wanted).epsilon(1e-4));
            }
        }
    }
}

TEST_CASE("the smallest plate with bevels and a fillet has the volume that is worked out by hand", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    glyph_run run;
    run.units_per_em = 1000.0;
    REQUIRE(run.glyphs.push_back({5, 0, {0, 0}}));  // 100 by 500
    auto text = test::required(mesher.plan(run, {}));
    name_plate plate;
    const auto prism = [](double x, double y, double w) {  // a chamfer of width w on a box
        return w / 6.0 * (x * y + 4.0 * (x - w) * (y - w) + (x - 2.0 * w) * (y - 2.0 * w));
    };
    REQUIRE(plate.plan(
        *text, {.margin = 0.2f, .radius = 0.0f, .thickness = 0.2f, .depth = 0.1f, .bevel = 0.02f, .fillet = 0.05f},
        monotone{}));
    check_solid(plate, 0);
    const double cell = plate.placement().at.em_per_cell;
    // Around the stick, at the distance t from its wall, the fillet is h(t) high: the integral of h(t) (P + 2 pi t).
    double fillet = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.05 * (i + 0.5) / 1000.0, down = 0.05 - t;
        fillet += 0.05 / 1000.0 * (0.05 - std::sqrt(0.05 * 0.05 - down * down)) * (1.2 + 2.0 * 3.14159265358979 * t);
    }
    const double wanted =
        2.0 * prism(0.5, 0.9, 0.02) + 0.16 * 0.5 * 0.9 + 0.08 * 0.1 * 0.5 + prism(0.1, 0.5, 0.02) + fillet;
    CHECK(cell * cell * plate.solid(0).volume() == Catch::Approx(wanted).epsilon(1e-3));
    for (const plate_part p : all_plate_parts) CHECK(plate.solid(0).size(p).triangles != 0);
}

TEST_CASE("bevels and fillets that do not fit become narrower, and the plate says how wide they are", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("oi", {}));
    name_plate plate;
    // A sixteenth of each height stays: 0.1 and 0.05.
    REQUIRE(plate.plan(*text, {.margin = 0.4f, .bevel = 0.2f, .fillet = 0.2f}, monotone{}));
    check_solid(plate, 0);
    CHECK(plate.rims().bevels == 3);
    CHECK(plate.rims().bevel == Catch::Approx(0.5 * 0.05 * 15.0 / 16.0));
    CHECK(plate.rims().fillet == Catch::Approx(0.5 * 0.05 * 15.0 / 16.0));
    // Heights that floats cannot tell apart: no rims.
    REQUIRE(plate.plan(*text, {.margin = 0.4f, .thickness = 1000.0f, .depth = 0.001f, .bevel = 0.01f, .fillet = 0.01f},
                       monotone{}));
    CHECK(same(plate.rims().fillet, 0.0f));
    // A fillet as wide as fits leaves a narrow bevel as it is.
    REQUIRE(plate.plan(*text, {.margin = 0.4f, .bevel = 0.01f, .fillet = 10.0f}, monotone{}));
    check_solid(plate, 0);
    CHECK(same(plate.rims().bevel, 0.01f));
    CHECK(plate.rims().fillet == Catch::Approx(0.05 * 15.0 / 16.0 - 0.01));
    REQUIRE(plate.plan(*text, {.margin = 0.02f, .radius = 0.0f, .bevel = 0.01f, .fillet = 0.03f}, monotone{}));
    check_solid(plate, 0);
    CHECK(same(plate.rims().bevel, 0.01f));
    CHECK(plate.rims().fillet > 0.004f);
    CHECK(plate.rims().fillet < 0.01f);
    REQUIRE(plate.plan(*text, {.margin = -0.05f, .bevel = 0.01f, .fillet = 0.03f}, monotone{}));  // beyond the plate
    check_solid(plate, 0);
    CHECK(plate.rims().bevel == 0.0f);
    CHECK(plate.rims().fillet == 0.0f);
    CHECK(plate.solid(0).size(plate_part::front_bevel).triangles != 0);  // the letters' own
    CHECK(plate.solid(0).size(plate_part::floor_bevel).triangles == 0);
}

TEST_CASE("an inlay and its plate tile the full plate exactly", "[plate]")
{
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("R&B 80%", {}));
    name_plate plate;
    for (const auto& [depth, bevel] : {std::pair{0.04f, 0.0f}, {0.1f, 0.0f}, {0.04f, 0.02f}}) {  // 0.1: through it
        REQUIRE(plate.plan(*text, {.style = plate_style::inlay, .depth = depth, .bevel = bevel}, monotone{}));
        constexpr cell_set body = name_plate::body(), letters = name_plate::text();
        CHECK(area(plate, body & ~letters) + area(plate, body & letters) == area(plate, body));
        CHECK(area(plate, body & letters) > 0);
        const std::array<corner_mesh, 2> m{written(plate, 0), written(plate, 1)};
        // Every wall of a pocket is a wall of the inlay, turned round.
        std::array<std::set<std::array<float, 9>>, 2> walls;
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < m[k].indices.size(); i += 3) {
                if (m[k].vertices[m[k].indices[i]].of != static_cast<part>(plate_part::wall)) continue;
                std::array<std::array<float, 3>, 3> t;
                for (std::size_t j = 0; j < 3; ++j) {
                    const vec3 p = m[k].vertices[m[k].indices[i + j]].position;
                    t[j] = {p.x, p.y, p.z};
                }
                std::sort(t.begin(), t.end());
                walls[k].insert({t[0][0], t[0][1], t[0][2], t[1][0], t[1][1], t[1][2], t[2][0], t[2][1], t[2][2]});
            }
        CHECK_FALSE(walls[0].empty());
        CHECK(walls[0] == walls[1]);
        CHECK(plate.solid(0).size(plate_part::wall) == plate.solid(1).size(plate_part::wall));
        const double full = plate.solid(0).volume() + plate.solid(1).volume();
        const double whole = 0.5 * static_cast<double>(area(plate, body)) * 0.1 * plate.unit_per_em();
        if (bevel > 0.0f) continue;
        CHECK(full == Catch::Approx(whole).epsilon(1e-6));
        const double mesh = measured(m[0]).volume + measured(m[1]).volume;
        const double unit = plate.placement().at.unit_per_cell;
        CHECK(mesh == Catch::Approx(unit * unit * whole).epsilon(1e-5));
    }
}

TEST_CASE("a mirrored plate is the plate's mirror image", "[plate]")
{
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("Rz", {}));
    name_plate plain, stamp;
    REQUIRE(plain.plan(*text, {}, monotone{}));
    REQUIRE(stamp.plan(*text, {.mirrored = true}, monotone{}));
    check_solid(stamp, 0);
    const corner_mesh a = written(plain, 0), b = written(stamp, 0);
    REQUIRE(a.vertices.size() == b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        const vec3 p = a.vertices[i].position, q = b.vertices[i].position;
        CHECK((same(p.x, -q.x) && same(p.y, q.y) && same(p.z, q.z)));
    }
}

TEST_CASE("plates stand in any frame, and their area does not depend on it", "[plate]")
{
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    name_plate plate;
    std::int64_t doubled = 0;
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, frame{.winding = -1}}) {
        auto text = test::required(mesher.plan("a&B", {.frame = f}));
        REQUIRE(plate.plan(*text, {.style = plate_style::inlay}, constrained_delaunay{}));
        for (std::size_t k = 0; k < 2; ++k) {
            const corner_mesh m = written(plate, k);
            CHECK(inspect::check_manifoldness(inspect::mesh_view{m.vertices, m.indices}).is_manifold());
            CHECK(f.winding * measured(m).volume > 0.0);
        }
        const std::int64_t own = area(plate, name_plate::body() & ~name_plate::text());
        CHECK((doubled == 0 || own == doubled));
        doubled = own;
    }
}

TEST_CASE("letters that a path turns stand on a plate, with the areas of letters in a line", "[plate]")
{
    auto font = test::opened(test::dejavu);
    plane_path circle;
    circle.circle({0.0, 0.0}, 4.0);
    text_mesher mesher{font, flat{}};
    name_plate plate;
    double areas[2];
    for (const bool turned : {false, true}) {
        if (turned) mesher.use(on_path{&circle, {}});
        auto text = test::required(mesher.plan("A&B C", {}));
        REQUIRE(plate.plan(*text, {.style = plate_style::inlay}, constrained_delaunay{}));
        CHECK(plate.is_manifold());
        for (std::size_t k = 0; k < 2; ++k) check_solid(plate, k);
        const double cell = plate.placement().at.em_per_cell;
        areas[turned] = 0.5 * cell * cell * static_cast<double>(area(plate, name_plate::text()));
    }
    CHECK(areas[1] == Catch::Approx(areas[0]).epsilon(1e-4));
}

TEST_CASE("no part of a plate without bevels is a bevel", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("oi", {}));
    name_plate plate;
    for (const plate_style style : all_styles) {
        REQUIRE(plate.plan(*text, {.style = style}, monotone{}));
        std::size_t bevels = 0;
        for (const corner& v : written(plate, 0).vertices)
            bevels += v.of == part::front_bevel || v.of == part::back_bevel;
        CHECK(bevels == 0);
    }
}

TEST_CASE("lengths of a thousand em are no larger than the plate", "[plate]")
{
    fine_font font;  // a thousand of its em are more cells than an integer holds
    text_mesher mesher{font, flat{}};
    glyph_run run;
    run.units_per_em = 10000.0;
    REQUIRE(run.glyphs.push_back({1, 0, {0, 0}}));  // round, with a round hole
    auto text = test::required(mesher.plan(run, {}));
    name_plate plate;
    const auto doubled = [&](const plate_options& how) {
        REQUIRE(plate.plan(*text, how, monotone{}));
        check_solid(plate, 0);
        return area(plate, name_plate::body());
    };
    CHECK(doubled({.radius = 1000.0f}) == doubled({.radius = 1.0f}));
    plate_options stencil{.style = plate_style::cut, .bridge_width = 1000.0f};
    (void)doubled(stencil);
    CHECK(plate.stencil().islands == 1);
    CHECK(std::string{plate.plan(*text, {.margin = -1000.0f}, monotone{}).error().option} == "margin");
}

TEST_CASE("letters that touch are parted, and a plate that keeps them says so", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    glyph_run run;
    run.units_per_em = 1000.0;
    // Sticks of 100 by 500 that touch in a corner.
    REQUIRE(run.glyphs.push_back({5, 0, {0, 0}}));
    REQUIRE(run.glyphs.push_back({5, 1, {100, 500}}));
    auto text = test::required(mesher.plan(run, {}));
    name_plate plate;
    for (const plate_style style : all_styles) {
        REQUIRE(plate.plan(*text, {.style = style, .corners = touching::keep}, monotone{}));
        CHECK_FALSE(plate.is_manifold());
        CHECK(plate.solid(0).touching() == 1);
        CHECK(plate.corners_touching() >= 1);
        CHECK(plate.corners_parted() == 0);
        REQUIRE(plate.plan(*text, {.style = style}, monotone{}));
        CHECK(plate.is_manifold());
        CHECK(plate.corners_touching() == 0);
        for (std::size_t k = 0; k < plate.solid_count(); ++k) check_solid(plate, k);
    }
    // The upper stick touches the rim: with a margin of 0 it ends on the plate's edge.
    for (const float margin : {0.0f, -0.05f})
        for (const plate_style style : all_styles) {
            INFO(margin << " " << static_cast<int>(style));
            REQUIRE(plate.plan(*text, {.style = style, .margin = margin, .radius = 0.0f}, monotone{}));
            CHECK(plate.is_manifold());
            for (std::size_t k = 0; k < plate.solid_count(); ++k) check_solid(plate, k);
        }
}

TEST_CASE("a plate follows an outline, with counters or without, mirrored or not, and has a keyring's hole", "[plate]")
{
    name_plate plate;
    for (const auto& c : plate_texts) {
        auto font = test::opened(c.font);
        text_mesher mesher{font, flat{}};
        auto bolder = text_mesher{font, embolden{.by = 0.08f}, flat{}};
        for (const float size : {1.0f, 12.0f}) {
            auto text = test::required(mesher.plan(c.text, {.size = size}));
            auto outline = test::required(bolder.plan(c.text, {.size = size}));
            std::int64_t areas[2];
            for (const bool filled : {false, true}) {
                INFO(c.font << " " << size << (filled ? " filled" : ""));
                const plate_options how{.mirrored = filled, .fill_counters = filled, .ring_hole = 0.05f};
                REQUIRE(plate.plan(*text, *outline, how, constrained_delaunay{}));
                CHECK(plate.is_manifold());
                check_solid(plate, 0);
                areas[filled] = area(plate, name_plate::body());
                // All letters stand on the plate: nothing of them lies beside it.
                CHECK(area(plate, name_plate::text() & ~name_plate::body()) == 0);
                CHECK(area(plate, name_plate::plate & name_plate::holes) > 0);
            }
            CHECK(areas[1] >= areas[0]);
        }
    }
}

TEST_CASE("the smallest plates have the sizes that are worked out by hand", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    glyph_run run;
    run.units_per_em = 1000.0;
    REQUIRE(run.glyphs.push_back({5, 0, {0, 0}}));  // 100 by 500
    auto text = test::required(mesher.plan(run, {}));
    name_plate plate;
    const plate_options sharp{.margin = 0.1f, .radius = 0.0f, .thickness = 0.2f, .depth = 0.1f};
    const auto volume = [&] {
        const double unit = plate.placement().at.em_per_cell;
        return unit * unit * plate.solid(0).volume() / plate.unit_per_em();
    };
    plate_options how = sharp;
    REQUIRE(plate.plan(*text, how, monotone{}));
    // A box of 12 triangles; its front has 8 triangles instead of 2, and 2 + 8 lead up to the letter's top.
    CHECK(plate.solid(0).size().triangles == 2 + 8 + 8 + 8 + 2);
    CHECK(volume() == Catch::Approx(0.3 * 0.7 * 0.2 + 0.1 * 0.5 * 0.1));
    how.style = plate_style::engraved;
    REQUIRE(plate.plan(*text, how, monotone{}));
    CHECK(plate.solid(0).size().triangles == 2 + 8 + 8 + 8 + 2);
    CHECK(volume() == Catch::Approx(0.3 * 0.7 * 0.2 - 0.1 * 0.5 * 0.1));
    how.style = plate_style::cut;
    REQUIRE(plate.plan(*text, how, monotone{}));
    CHECK(plate.solid(0).size().triangles == 8 + 8 + 8 + 8);
    CHECK(volume() == Catch::Approx(0.3 * 0.7 * 0.2 - 0.1 * 0.5 * 0.2));
}

TEST_CASE("options outside their ranges and texts without letters are refused in a sentence", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    name_plate plate;
    auto text = test::required(mesher.plan("i", {}));
    const auto refusal = [&](const plate_options& how) {
        return std::string{plate.plan(*text, how, monotone{}).error().option};
    };
    REQUIRE(plate.plan(*text, {}, monotone{}));
    CHECK(refusal({.margin = std::numeric_limits<float>::quiet_NaN()}) == "margin");
    CHECK(plate.solid_count() == 0);
    CHECK(refusal({.radius = -1.0f}) == "radius");
    CHECK(refusal({.thickness = 0.0f}) == "thickness");
    CHECK(refusal({.depth = -0.1f}) == "depth");
    CHECK(refusal({.bevel = -0.1f}) == "bevel");
    CHECK(refusal({.fillet = std::numeric_limits<float>::infinity()}) == "fillet");
    for (const plate_style style : {plate_style::standing, plate_style::engraved, plate_style::inlay})
        CHECK(refusal({.style = style, .thickness = 1000.0f, .depth = 1e-5f}) == "depth");
    CHECK(refusal({.ring_hole = std::numeric_limits<float>::infinity()}) == "ring_hole");
    CHECK(refusal({.ring_width = 0.0f}) == "ring_width");
    CHECK(refusal({.bridge_width = 1e9f}) == "bridge_width");
    CHECK(refusal({.bridges = 9}) == "bridges");
    auto blank = test::required(mesher.plan("", {}));
    CHECK(std::string{plate.plan(*blank, {}, monotone{}).error().option} == "text");
}

TEST_CASE("whichever request for memory fails, a plate says so, and then it is made as before", "[plate]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("oi", {}));
    for (const bool stands : {false, true}) {
        const plate_options how{.style = stands ? plate_style::standing : plate_style::cut,
                                .bevel = stands ? 0.01f : 0.0f,
                                .fillet = 0.02f,
                                .ring_hole = 0.05f,
                                .bridge_width = 0.02f};
        std::size_t needed = 0;
        {
            test::counting_memory counted;
            name_plate plate{counted.source()};
            REQUIRE(plate.plan(*text, how, monotone{}));
            needed = counted.requests;
            // After warm-up, a plate takes nothing.
            REQUIRE(plate.plan(*text, how, monotone{}));
            const std::size_t warm = counted.requests;
            for (int i = 0; i < 3; ++i) REQUIRE(plate.plan(*text, how, monotone{}));
            CHECK(counted.requests == warm);
        }
        REQUIRE(needed > 20);
        for (std::size_t k = 1; k <= needed; k += stands ? 17 : 1) {
            test::counting_memory counted;
            {
                name_plate plate{counted.source()};
                counted.fail_at = k;
                const auto done = plate.plan(*text, how, monotone{});
                CHECK(done.error() == error::out_of_memory);
                CHECK(plate.solid_count() == 0);
                counted.fail_at = 0;
                REQUIRE(plate.plan(*text, how, monotone{}));
                CHECK(plate.is_manifold());
            }
            CHECK(counted.bytes_held == 0);
        }
    }
}

TEST_CASE("a picture lies on a plate as on its letters: u and v are the text's own, to the bit", "[plate]")
{
    struct textured {
        vec3 position;
        vec2 uv;
    };
    constexpr auto as_textured = [](const surface_point<attribute::position | attribute::uv>& p) noexcept {
        return textured{p.position, p.uv};
    };
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    for (const uv_origin origin : {uv_origin::top_left, uv_origin::bottom_left}) {
        auto text = test::required(mesher.plan("B8\ng", {.size = 3.0, .frame = {.uv = origin}}));
        std::vector<textured> letters, vertices;
        std::vector<std::uint32_t> indices;
        REQUIRE(text->write(into(letters, indices, as_textured)));
        std::map<std::pair<float, float>, vec2> of_letters;
        for (const textured& v : letters) of_letters[{v.position.x, v.position.y}] = v.uv;
        name_plate plate;
        REQUIRE(plate.plan(*text, {}, monotone{}));
        REQUIRE(plate.write(0, into(vertices, indices, as_textured)));
        std::size_t found = 0, wrong = 0;
        for (const textured& v : vertices) {
            const auto letter = of_letters.find({v.position.x, v.position.y});
            if (letter == of_letters.end()) continue;
            ++found;
            wrong += !(letter->second == v.uv);
        }
        CHECK(found >= letters.size());
        CHECK(wrong == 0);
    }
}

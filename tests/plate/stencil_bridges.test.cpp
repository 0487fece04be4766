// SPDX-License-Identifier: MIT
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/typemesh.hpp>

#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/required.hpp"

#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// The number of components of a set of cells, counted by the region's outer loops.
std::uint32_t components(name_plate& plate, cell_set cells)
{
    workspace space;
    contours loops;
    const auto made = plate.cells().trace(cells, space, loops);
    REQUIRE(made);
    return made->outers();
}

struct place {
    float x, y, z;
};

}  // namespace

template <>
struct typemesh::vertex_traits<place> {
    static constexpr attribute wants = attribute::position;
    place operator()(const surface_point<wants>& p) const noexcept
    {
        return {p.position.x, p.position.y, p.position.z};
    }
};

namespace {

bool is_manifold(const name_plate& plate)
{
    std::vector<place> vertices;
    std::vector<std::uint32_t> indices;
    REQUIRE(plate.write(0, into(vertices, indices)));
    return inspect::check_manifoldness(inspect::mesh_view{vertices, indices}).is_manifold();
}

}  // namespace

TEST_CASE("no island of a stencil is loose, in any script", "[plate][stencil]")
{
    const struct {
        const char* font;
        const char* text;
    } cases[] = {{test::dejavu, "ABQR 8&%"},
                 {test::dejavu, "eg@\xC3\x98\xC3\x85"},
                 {"truetype/liberation/LiberationSerif-BoldItalic.ttf", "BR aegq8"},
                 {"truetype/liberation/LiberationSerif-BoldItalic.ttf", "&%@"},
                 {test::amiri, "\xD8\xB5\xD9\x88\xD9\x85 \xD9\x81\xD9\x82\xD9\x87 \xD9\x85\xD8\xB7\xD8\xB9\xD9\x85"},
                 {test::sawarabi, "\xE5\x9B\xBD\xE5\x9B\x9E\xE7\x94\xB0\xE9\xBE\x8D\xE6\x97\xA5"}};
    name_plate plate;
    for (const auto& c : cases) {
        auto font = test::opened(c.font);
        text_mesher mesher{font, flat{}};
        for (const std::uint32_t bridges : {1u, 2u, 3u}) {
            auto text = test::required(mesher.plan(c.text, {.size = bridges == 2 ? 12.0f : 1.0f}));
            for (const float width : {0.02f, 0.05f}) {
                if (bridges == 2 && width < 0.05f) continue;
                INFO(c.font << " " << bridges << " of " << width);
                REQUIRE(plate.plan(*text, {.style = plate_style::cut, .bridge_width = width, .bridges = bridges},
                                   monotone{}));
                CHECK(plate.stencil().islands > 3);
                CHECK(plate.stencil().loose == 0);
                CHECK(plate.stencil().bridges >= plate.stencil().islands);
                CHECK(components(plate, name_plate::body() & ~name_plate::text()) == 1);
                CHECK(components(plate, name_plate::body() & ~name_plate::letters) == plate.stencil().islands + 1);
                CHECK(is_manifold(plate));
            }
        }
    }
}

TEST_CASE("each bridge is as wide as asked, and both of its ends lie in solid plate", "[plate][stencil]")
{
    // Only letters whose counters are wider than the bridges.
    const struct {
        const char* font;
        const char* text;
    } cases[] = {{test::dejavu, "ABQ 0dp"},
                 {"truetype/liberation/LiberationSerif-BoldItalic.ttf", "AOQ bp"},
                 {test::sawarabi, "\xE5\x9B\x9E\xE7\x94\xB0\xE6\x97\xA5"}};
    name_plate plate;
    for (const auto& c : cases) {
        auto font = test::opened(c.font);
        text_mesher mesher{font, flat{}};
        auto text = test::required(mesher.plan(c.text, {}));
        for (const float width : {0.01f, 0.04f}) {
            INFO(c.font << " " << width);
            REQUIRE(plate.plan(*text, {.style = plate_style::cut, .bridge_width = width, .bridges = 2}, monotone{}));
            REQUIRE_FALSE(plate.stencil_bars().empty());
            std::size_t ends = 0;
            for (const stencil_bar& b : plate.stencil_bars()) {
                CHECK(b.width() * plate.placement().at.em_per_cell >= static_cast<double>(width) * 0.9999);
                for (std::size_t i = 0; i < plate.cells().piece_count(); ++i) {
                    const auto s = plate.cells()[i];
                    const auto on_end = [&](grid_point p) {
                        const std::int32_t at = b.upright ? p.y : p.x, along = b.upright ? p.x : p.y;
                        const std::int32_t low = b.upright ? b.low.y : b.low.x, high = b.upright ? b.high.y : b.high.x;
                        const std::int32_t from = b.upright ? b.low.x : b.low.y, to = b.upright ? b.high.x : b.high.y;
                        return (at == low || at == high) && from <= along && along <= to;
                    };
                    const bool same_end = b.upright ? s.from.y == s.to.y : s.from.x == s.to.x;
                    if (!same_end || !on_end(s.from) || !on_end(s.to)) continue;
                    ++ends;
                    CHECK_FALSE(name_plate::letters.contains(s.below));
                    CHECK_FALSE(name_plate::letters.contains(s.above));
                }
            }
            CHECK(ends >= 2 * plate.stencil_bars().size());
        }
    }
}

TEST_CASE("an island with a hole of the plate in it is tied as well", "[plate][stencil]")
{
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    text_mesher bolder{font, embolden{.by = 0.05f}, flat{}};
    auto text = test::required(mesher.plan("Oo", {}));
    auto outline = test::required(bolder.plan("Oo", {}));
    name_plate plate;
    REQUIRE(plate.plan(*text, *outline, {.style = plate_style::cut, .bridge_width = 0.03f}, monotone{}));
    CHECK(plate.stencil().islands == 2);  // rings around the plate's open counters
    CHECK(plate.stencil().loose == 0);
    CHECK(components(plate, name_plate::body() & ~name_plate::text()) == components(plate, name_plate::body()));
    CHECK(is_manifold(plate));
}

TEST_CASE("after the last bars, the islands that are loose are counted anew", "[plate][stencil]")
{
    workspace space;
    silhouette plate, outer, inner, bars;
    layer_arrangement cells;
    for (silhouette* s : {&plate, &outer, &inner, &bars}) s->begin({});
    REQUIRE(plate.add_rectangle({0, 0}, {9000, 9000}, 0.0, 1.0));
    REQUIRE(outer.add_rectangle({2000, 2000}, {7000, 7000}, 0.0, 1.0));
    REQUIRE(inner.add_rectangle({4000, 4000}, {5000, 5000}, 0.0, 1.0));
    const auto arrange = [&] {
        cells.begin({});
        std::uint32_t layer = 0;
        for (const silhouette* s : {&plate, &outer, &inner, &bars})
            REQUIRE(cells.add(s->points(), s->starts(), layer++));
        REQUIRE(cells.cut(space));
    };
    const cell_set cut = cells_of_layer(1) & ~cells_of_layer(2) & ~cells_of_layer(3), solid = cells_of_layer(0) & ~cut;
    arrange();
    stencil_bridges bridges;
    const auto added = bridges.tie(cells, solid, 4, {200, 2}, bars, space);
    REQUIRE(added);
    CHECK(*added);
    REQUIRE(bars.fill(space));
    arrange();
    CHECK(bridges.report().loose == 1);  // as it was before the bars
    REQUIRE(bridges.count(cells, solid, 4, space));
    CHECK(bridges.report().loose == 0);
    CHECK(bridges.report().islands == 1);
    CHECK(bridges.report().bridges == 2);
}

TEST_CASE("the bridges of an island are the same wherever it lies among others", "[plate][stencil]")
{
    workspace space;
    layer_arrangement cells;
    silhouette plate, outer, inner, bars;
    stencil_bridges bridges;
    const cell_set solid = cells_of_layer(0) & ~(cells_of_layer(1) & ~cells_of_layer(2));
    for (const std::int32_t width : {1, 300, 1500}) {  // the last one is wider than the islands
        std::vector<stencil_bar> alone;
        for (const std::int32_t count : {1, 7}) {
            for (silhouette* s : {&plate, &outer, &inner, &bars}) s->begin({});
            REQUIRE(plate.add_rectangle({0, 0}, {9000 * count, 9000 * count}, 0.0, 1.0));
            for (std::int32_t k = 0; k < count * count; ++k) {
                const std::int32_t x = 9000 * (k % count), y = 9000 * (k / count);
                REQUIRE(outer.add_rectangle({x + 2000, y + 2000}, {x + 7100, y + 6000}, 700.0, 9.0));
                REQUIRE(inner.add_rectangle({x + 4000, y + 3900}, {x + 5000, y + 4900}, 300.0, 9.0));
            }
            cells.begin({});
            std::uint32_t layer = 0;
            for (const silhouette* s : {&plate, &outer, &inner}) REQUIRE(cells.add(s->points(), s->starts(), layer++));
            REQUIRE(cells.cut(space));
            bridges.clear();
            CHECK(std::string{bridges.tie(cells, solid, 4, {width, 9}, bars, space).error().option} == "per_island");
            CHECK((bridges.bars().empty() && bars.empty()));
            REQUIRE(bridges.tie(cells, solid, 4, {width, 3}, bars, space));
            CHECK(bridges.report().islands == static_cast<std::uint32_t>(count * count));
            std::vector<stencil_bar> made{bridges.bars().begin(), bridges.bars().end()};
            if (count == 1) alone = made;
            REQUIRE((alone.size() >= 2 && made.size() == alone.size() * bridges.report().islands));
            std::size_t others = 0;
            for (std::size_t i = 0; i < made.size(); ++i) {
                const stencil_bar &own = made[i], &one = alone[i % alone.size()];
                const std::int32_t x = own.low.x - one.low.x, y = own.low.y - one.low.y;
                others += x % 9000 != 0 || y % 9000 != 0 || own.upright != one.upright ||
                          own.high.x - one.high.x != x || own.high.y - one.high.y != y;
            }
            CHECK(others == 0);
        }
    }
}

TEST_CASE("bridges that are wanted narrower than a cell still tie", "[plate][stencil]")
{
    auto font = test::opened(test::dejavu);
    text_mesher mesher{font, flat{}};
    auto text = test::required(mesher.plan("O", {}));
    name_plate plate;
    REQUIRE(plate.plan(*text, {.style = plate_style::cut, .bridge_width = 1e-9f}, monotone{}));
    CHECK(plate.stencil().islands == 1);
    CHECK(plate.stencil().loose == 0);
}

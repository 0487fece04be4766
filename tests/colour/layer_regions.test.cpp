// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/colour_font.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"

#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/colour/read_colour_glyph.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace typemesh;
using namespace test;

namespace {

constexpr double cells = 512.0 * 512.0;  // in a square unit

/// The areas of all layers of glyph 1, in font units, and that of the silhouette if they are visible.
struct areas {
    std::vector<double> layers;
    double silhouette = 0.0;
    bool add_up = false;  ///< as integers
};
template <class Source>
areas areas_of(Source& outlines, const colour_font& font, layer_cut cut)
{
    colour_glyph g;
    const auto found = read_colour_glyph(font.tables(), 1, {}, g);
    REQUIRE(found);
    REQUIRE(*found);
    layer_regions regions;
    const auto built = regions.build(outlines, 0, g, 1.0 / 800, cut);
    INFO((built ? "" : built.error().message()));
    REQUIRE(built);
    REQUIRE(regions.layer_count() >= g.layers.size());
    areas all;
    all.layers.resize(g.layers.size());
    contours loops;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < regions.layer_count(); ++i) {
        const auto r = regions.layer(i, loops);
        REQUIRE(r);
        CHECK(regions.is_empty(i) == r->points().empty());
        sum += inspect::doubled_area(*r);
        all.layers[regions.number_in_glyph(i)] += static_cast<double>(inspect::doubled_area(*r)) / 2.0 / cells;
    }
    const auto whole = regions.silhouette(loops);
    REQUIRE(whole);
    all.silhouette = static_cast<double>(inspect::doubled_area(*whole)) / 2.0 / cells;
    all.add_up = sum == inspect::doubled_area(*whole);
    return all;
}

bool are(const std::vector<double>& found, const std::vector<double>& expected, double error = 0.0)
{
    if (found.size() != expected.size()) return false;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (std::fabs(found[i] - expected[i]) > error) return false;
    return true;
}

/// Squares as in squares(), and glyph 10, a disc of radius 200 around (500, 500), of cubics.
recorded_outlines squares_and_disc()
{
    recorded_outlines font = squares();
    REQUIRE(font.add([](auto& pen) {
        constexpr double k = 0.5522847498 * 200;
        pen.move({700, 500});
        pen.cubic({700, 500 + k}, {500 + k, 700}, {500, 700});
        pen.cubic({500 - k, 700}, {300, 500 + k}, {300, 500});
        pen.cubic({300, 500 - k}, {500 - k, 300}, {500, 300});
        pen.cubic({500 + k, 300}, {700, 500 - k}, {700, 500});
        pen.close();
    }));
    return font;
}

}  // namespace

TEST_CASE("each visible layer is what those above it leave of it", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font nested = flat_font({{1, {{9, 0}, {5, 1}, {2, 2}}}});
    const areas visible = areas_of(outlines, nested, layer_cut::visible);
    CHECK(are(visible.layers, {810'000.0 - 250'000.0, 250'000.0 - 40'000.0, 40'000.0}));
    CHECK(are({visible.silhouette}, {810'000.0}));
    CHECK(visible.add_up);
    const areas stacked = areas_of(outlines, nested, layer_cut::stacked);
    CHECK(are(stacked.layers, {810'000.0, 250'000.0, 40'000.0}));

    const areas hidden = areas_of(outlines, flat_font({{1, {{5, 0}, {5, 1}, {3, 2}, {9, 3}}}}), layer_cut::visible);
    CHECK(are(hidden.layers, {0.0, 0.0, 0.0, 810'000.0}));
    CHECK(hidden.add_up);
    const areas blank = areas_of(outlines, flat_font({{1, {{0, 0}, {0, 1}}}}), layer_cut::visible);
    CHECK(are(blank.layers, {0.0, 0.0}));
}

TEST_CASE("of hundreds of layers each is what those above it leave of it", "[colour]")
{
    recorded_outlines outlines = squares();
    for (const bool clipped : {false, true}) {
        // Rectangles of whole squares of 50 units: the uppermost one that covers a square is seen there.
        constexpr std::uint32_t count = 300, side = 12;
        colour_glyph g;
        std::vector<double> expected(count, 0.0);
        std::vector<std::uint32_t> seen(side * side, count);
        std::uint32_t state = 7;
        const auto roll = [&state] { return state = state * 1'103'515'245u + 12'345u, state >> 20; };
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t x = roll() % side, y = roll() % side, w = 1 + roll() % (side - x),
                                h = 1 + roll() % (i < count / 2 ? side - y : 1);
            REQUIRE(g.shapes.push_back({.is = layer_shape::kind::rectangle,
                                        .map = {.xx = 50.0 * w, .dx = 50.0 * x, .yy = 50.0 * h, .dy = 50.0 * y}}));
            REQUIRE(g.layers.push_back({i, {}}));
            for (std::uint32_t k = y; k < y + h; ++k)
                for (std::uint32_t j = x; j < x + w; ++j) seen[k * side + j] = i;
        }
        if (clipped) g.clip = {{100.0, 100.0}, {500.0, 550.0}};
        double whole = 0.0;
        for (std::uint32_t k = 0; k < side * side; ++k) {
            const std::uint32_t x = k % side, y = k / side;
            if (seen[k] == count || (clipped && (x < 2 || x >= 10 || y < 2 || y >= 11))) continue;
            expected[seen[k]] += 2500.0;
            whole += 2500.0;
        }
        layer_regions regions;
        REQUIRE(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::visible));
        REQUIRE(regions.layer_count() == count);
        contours loops;
        std::vector<double> found;
        for (std::uint32_t i = 0; i < count; ++i) {
            CHECK(regions.number_in_glyph(i) == i);
            found.push_back(static_cast<double>(inspect::doubled_area(*regions.layer(i, loops))) / 2.0 / cells);
        }
        CHECK(are(found, expected));
        CHECK(are({static_cast<double>(inspect::doubled_area(*regions.silhouette(loops))) / 2.0 / cells}, {whole}));
    }
}

TEST_CASE("transforms, clips and composites give the areas of plane geometry", "[colour]")
{
    recorded_outlines outlines = squares_and_disc();
    const auto one = [&](const paint& root, const std::vector<clip_box>& clips = {}) {
        return areas_of(outlines, painted_font({{1, root}}, {}, clips), layer_cut::visible);
    };
    const double disc = 200.0 * 200.0 * 3.14159265358979, rough = 0.009 * disc;
    const paint square = test::glyph(solid_paint(0), 5), round = test::glyph(solid_paint(1), 10);
    const double quarter = disc / 4;  // of the disc lies in the square

    CHECK(are(one(moved(26, {0.125}, {250, 250}, square)).layers, {250'000.0}, 1.0));
    CHECK(are(one(moved(16, {0.5, -0.5}, {}, square)).layers, {62'500.0}));
    CHECK(are(one(moved(28, {0.125, 0.0}, {}, square)).layers, {250'000.0}, 1.0));
    CHECK(are(one(moved(14, {}, {700, 0}, square), {{1, 1, 0, 0, 800, 100}}).layers, {10'000.0}));  // clipped
    CHECK(are(one(solid_paint(2), {{1, 1, 10, 20, 110, 70}}).layers, {5'000.0}));

    CHECK(are(one(composite(round, 3, square)).layers, {250'000.0 - quarter, disc}, rough));
    CHECK(are(one(composite(round, 4, square)).layers, {disc - quarter, 250'000.0}, rough));
    CHECK(are(one(composite(round, 5, square)).layers, {quarter}, rough));
    CHECK(are(one(composite(round, 6, square)).layers, {quarter}, rough));
    CHECK(are(one(composite(round, 7, square)).layers, {disc - quarter}, rough));
    CHECK(are(one(composite(round, 8, square)).layers, {250'000.0 - quarter}, rough));
    CHECK(are(one(composite(round, 9, square)).layers, {250'000.0 - quarter, quarter}, rough));
    CHECK(are(one(composite(round, 10, square)).layers, {disc - quarter, quarter}, rough));
    CHECK(are(one(composite(round, 11, square)).layers, {250'000.0 - quarter, disc - quarter}, rough));
    CHECK(
        are(one(composite(solid_paint(2), 7, round), {{1, 1, 0, 0, 1000, 1000}}).layers, {1'000'000.0 - disc}, rough));
    for (const unsigned mode : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u, 11u, 23u})
        CHECK(one(moved(24, {0.03}, {}, composite(round, mode, moved(24, {0.01}, {}, square)))).add_up);
}

TEST_CASE("the clip box of a glyph within a glyph limits it, with its transform", "[colour]")
{
    recorded_outlines outlines = squares();
    const paint square = test::glyph(solid_paint(0), 5);
    const auto one = [&](const paint& root, const std::vector<clip_box>& clips) {
        return areas_of(outlines, painted_font({{1, root}, {2, square}, {3, solid_paint(1)}}, {}, clips),
                        layer_cut::visible);
    };
    CHECK(are(one(colr_glyph(2), {{2, 2, 0, 0, 200, 300}}).layers, {60'000.0}));
    CHECK(are(one(moved(16, {0.5, 1.5}, {}, colr_glyph(2)), {{2, 2, 0, 0, 200, 300}}).layers, {45'000.0}));
    CHECK(are(one(colr_glyph(2), {{1, 1, 0, 0, 100, 100}, {2, 2, 50, 0, 200, 300}}).layers, {5'000.0}));
    CHECK(are(one(colr_glyph(3), {{3, 3, 10, 10, 30, 20}}).layers, {200.0}));  // the whole box
    colour_glyph g;
    const colour_font none = painted_font({{1, colr_glyph(3)}, {3, solid_paint(1)}}, {}, {{3, 3, 10, 10, -30, 20}});
    REQUIRE(read_colour_glyph(none.tables(), 1, {}, g));
    CHECK(g.layers.empty());
}

TEST_CASE("a translucent layer is divided by what shines through it, and takes its colours", "[colour]")
{
    recorded_outlines outlines = squares();
    // Entry 3 is white with an alpha of 128/255.
    struct part {
        std::uint32_t number;
        double area;
        palette_colour colour;
        std::uint16_t entry;
    };
    const auto parts_of = [&](const colour_font& font) {
        colour_glyph g;
        REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
        layer_regions regions;
        REQUIRE(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::visible));
        std::vector<part> all;
        contours loops;
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < regions.layer_count(); ++i) {
            const std::int64_t area = inspect::doubled_area(*regions.layer(i, loops));
            const glyph_paint paint = regions.paint(i, g);
            sum += area;
            if (area == 0) continue;
            all.push_back(
                {regions.number_in_glyph(i), static_cast<double>(area) / 2.0 / cells, paint.colour, paint.entry});
        }
        CHECK(sum == inspect::doubled_area(*regions.silhouette(loops)));
        return all;
    };
    const auto two = parts_of(flat_font({{1, {{5, 0}, {9, 3}}}}));  // red below a larger square
    REQUIRE(two.size() == 2);
    for (const part& p : two) {
        CHECK(p.number == 1);
        const bool on_red = p.entry == mixed_colour_entry;
        CHECK(std::fabs(p.area - (on_red ? 250'000.0 : 560'000.0)) < 1e-6);
        CHECK(p.colour == (on_red ? palette_colour{255, 128, 128, 1.0f}
                                  : palette_colour{255, 255, 255, static_cast<float>(128 / 255.0)}));
    }
    const auto three = parts_of(flat_font({{1, {{9, 0}, {7, 3}, {4, 3}}}}));  // two panes on red
    REQUIRE(three.size() == 3);
    CHECK((three[0].number == 0 && three[1].number == 1 && three[2].number == 2));
    CHECK(std::fabs(three[2].area - 160'000.0) < 1e-6);
    CHECK((three[1].colour == palette_colour{255, 128, 128, 1.0f}));
    CHECK((three[2].colour == palette_colour{255, 192, 192, 1.0f}));
    // Red multiplied by green is black, also if both are opaque.
    const auto black =
        parts_of(painted_font({{1, composite(test::glyph(solid_paint(1), 4), 23, test::glyph(solid_paint(0), 9))}}));
    REQUIRE(black.size() == 2);
    CHECK((black[0].colour == palette_colour{255, 0, 0, 1.0f}));
    CHECK((black[1].colour == palette_colour{0, 0, 0, 1.0f}));
    // A pane that hides another one with an opaque layer between them does not mix with it.
    const auto hidden = parts_of(flat_font({{1, {{6, 3}, {6, 2}, {6, 3}}}}));
    REQUIRE(hidden.size() == 1);
    CHECK((hidden[0].colour == palette_colour{128, 128, 255, 1.0f}));
    // Panes on each other are divided at most 16 deep.
    std::vector<std::pair<unsigned, unsigned>> panes{{9, 0}};
    for (unsigned i = 0; i < 20; ++i) panes.emplace_back(9 - i % 2, 3);
    CHECK(parts_of(flat_font({{1, panes}})).size() == 2);
}

TEST_CASE("the layers of a glyph together have a limit, of memory and of work", "[colour]")
{
    recorded_outlines outlines{1000.0};
    REQUIRE(outlines.add([](auto& pen) {  // a comb
        pen.move({0, 0});
        pen.line({900, 0});
        for (int i = 30; i-- > 0;) {
            pen.line({10.0 * i + 10.0, 500});
            pen.line({10.0 * i + 5.0, 500});
            pen.line({10.0 * i + 5.0, 100});
            pen.line({10.0 * i, 100});
        }
        pen.close();
    }));
    std::vector<std::pair<unsigned, unsigned>> layers;
    for (unsigned i = 0; i < 100; ++i) layers.emplace_back(0, i % 3);
    colour_glyph g;
    REQUIRE(read_colour_glyph(flat_font({{1, layers}}).tables(), 1, {}, g));
    counting_memory counted;
    layer_regions regions{counted.source()};
    REQUIRE(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::visible));
    CHECK(regions.layer_count() == 100);
    CHECK(counted.peak < 300'000);
    CHECK(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::visible, 500).error() == error::too_many_pieces);
    CHECK(regions.layer_count() == 0);
    CHECK(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::stacked, 500).error() == error::too_many_points);
    CHECK(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::stacked, 100'000));

    // Curves are limited before they are flattened: 300 times the comb, each turned differently.
    std::vector<paint> turned;
    for (unsigned i = 0; i < 250; ++i) turned.push_back(moved(24, {i / 500.0}, {}, test::glyph(solid_paint(0), 0)));
    const colour_font many = painted_font({{1, colr_layers(250, 0)}}, turned);
    REQUIRE(read_colour_glyph(many.tables(), 1, {}, g));
    CHECK(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::stacked, 10'000).error() == error::too_many_points);
}

TEST_CASE("neighbouring layers share every point of their common boundary", "[colour]")
{
    recorded_outlines outlines = squares_and_disc();
    // A turned square, a disc over its corner and a slanted square over both.
    const colour_font font =
        painted_font({{1, colr_layers(3, 0)}},
                     {moved(24, {0.03}, {}, test::glyph(solid_paint(0), 7)), test::glyph(solid_paint(1), 10),
                      moved(28, {0.11, 0.07}, {}, test::glyph(solid_paint(2), 4))});
    colour_glyph g;
    REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
    layer_regions regions;
    REQUIRE(regions.build(outlines, 0, g, 1.0 / 800, layer_cut::visible));
    contours loops;
    struct edge {
        std::uint64_t from, to;
    };
    std::vector<edge> all, rim;
    const auto collect = [](const region& r, std::vector<edge>& into) {
        for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
            grid_point a = r.points()[r.starts()[loop + 1] - 1];
            for (std::uint32_t i = r.starts()[loop]; i < r.starts()[loop + 1]; ++i) {
                into.push_back({a.word(), r.points()[i].word()});
                a = r.points()[i];
            }
        }
    };
    for (std::size_t i = 0; i < 3; ++i) collect(*regions.layer(i, loops), all);
    collect(*regions.silhouette(loops), rim);
    // Every edge of a layer is the reverse of an edge of another layer, or an edge of the silhouette.
    std::size_t shared = 0, outer = 0, loose = 0;
    for (const edge& e : all) {
        std::size_t twins = 0, at_rim = 0;
        for (const edge& f : all) twins += e.from == f.to && e.to == f.from ? 1u : 0u;
        for (const edge& f : rim) at_rim += e.from == f.from && e.to == f.to ? 1u : 0u;
        shared += twins == 1 && at_rim == 0 ? 1u : 0u;
        outer += twins == 0 && at_rim == 1 ? 1u : 0u;
        loose += twins + at_rim != 1 ? 1u : 0u;
    }
    CHECK(loose == 0);
    CHECK(outer == rim.size());
    CHECK(shared > 20);
}

TEST_CASE("layers that cannot be built leave none, and the next glyph is built", "[colour]")
{
    recorded_outlines outlines = squares();
    const colour_font font = flat_font({{1, {{9, 0}, {77, 1}}}, {2, {{9, 0}, {3, 3}}}});
    colour_glyph g;
    layer_regions regions;
    REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
    CHECK(regions.build(outlines, 0, g, 1.0 / 160, layer_cut::visible).error() == error::unknown_glyph);
    CHECK(regions.layer_count() == 0);
    REQUIRE(read_colour_glyph(font.tables(), 2, {}, g));
    CHECK(regions.build(outlines, 0, g, 0.0, layer_cut::visible).error() == error::bad_tolerance);
    CHECK(regions.build(outlines, 0, g, 1.0 / 160, layer_cut::visible, 3).error() == error::too_many_points);
    CHECK(regions.layer_count() == 0);
    REQUIRE(regions.build(outlines, 0, g, 1.0 / 160, layer_cut::visible));
    CHECK(regions.layer_count() == 2);
    const std::size_t requests = check_each_failure([&](memory source) -> error {
        layer_regions own{source};
        contours loops{source};
        if (const auto built = own.build(outlines, 0, g, 1.0 / 160, layer_cut::visible); !built) {
            CHECK(own.layer_count() == 0);
            return built.error();
        }
        return own.layer(0, loops).error();
    });
    CHECK(requests > 8);
}

// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/colour_font.hpp"
#include "support/each_failure.hpp"

#include <typemesh/colour/read_colour_glyph.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace typemesh;
using namespace test;

namespace {

constexpr auto outline_kind = layer_shape::kind::outline;

bool is_near(double a, double b, double error = 1e-3) { return std::fabs(a - b) <= error; }

bool has_colour(const palette_colour& c, int red, int green, int blue, double alpha)
{
    return c.red == red && c.green == green && c.blue == blue && is_near(as_double(c.alpha), alpha);
}

/// The one layer of glyph 1 painted by `root`; its map must move (x, y) to (to_x, to_y).
void check_map(const paint& root, point from, point to)
{
    const colour_font font = painted_font({{1, root}});
    colour_glyph g;
    const auto found = read_colour_glyph(font.tables(), 1, {}, g);
    REQUIRE(found);
    REQUIRE(*found);
    REQUIRE(g.layers.size() == 1);
    const point p = g.shapes[g.layers[0].shape].map(from);
    CHECK(is_near(p.x, to.x, 0.05));
    CHECK(is_near(p.y, to.y, 0.05));
}

}  // namespace

TEST_CASE("layers of version 0 come in order with their palette's colours", "[colour]")
{
    const colour_font font = flat_font({{3, {{7, 0}, {8, 0xFFFF}, {9, 3}}}, {5, {}}, {6, {{2, 1}, {1, 9}}}});
    colour_glyph g;
    REQUIRE(read_colour_glyph(font.tables(), 3, {.foreground = {10, 20, 30, 0.5f}}, g));
    REQUIRE(g.layers.size() == 3);
    CHECK(g.shapes[g.layers[0].shape].id == 7);
    CHECK(g.shapes[g.layers[1].shape].id == 8);
    CHECK(g.shapes[g.layers[2].shape].id == 9);
    CHECK(has_colour(g.layers[0].paint.colour, 255, 0, 0, 1.0));
    CHECK(g.layers[1].paint.is_text_colour());
    CHECK(has_colour(g.layers[1].paint.colour, 10, 20, 30, 0.5));
    CHECK(g.layers[2].paint.entry == 3);
    CHECK(has_colour(g.layers[2].paint.colour, 255, 255, 255, 128.0 / 255));

    REQUIRE(read_colour_glyph(font.tables(), 6, {.palette = 1}, g));
    REQUIRE(g.layers.size() == 2);
    CHECK(has_colour(g.layers[0].paint.colour, 255, 0, 255, 1.0));
    CHECK(has_colour(g.layers[1].paint.colour, 0, 0, 0, 1.0));  // the palette has no entry 9

    REQUIRE(read_colour_glyph(font.tables(), 6, {.palette = 7}, g));  // no such palette: the first
    CHECK(has_colour(g.layers[0].paint.colour, 0, 255, 0, 1.0));

    const auto blank = read_colour_glyph(font.tables(), 5, {}, g);
    REQUIRE(blank);
    CHECK(*blank);
    CHECK(g.layers.empty());
    for (const glyph_id id : {0u, 4u, 7u, 0x10003u}) {
        const auto other = read_colour_glyph(font.tables(), id, {}, g);
        REQUIRE(other);
        CHECK_FALSE(*other);
    }
    CHECK_FALSE(*read_colour_glyph({}, 3, {}, g));
}

TEST_CASE("each transform paint maps as it says", "[colour]")
{
    const paint inner = test::glyph(solid_paint(0), 4);
    const double half = std::sqrt(0.5);
    check_map(inner, {3, 5}, {3, 5});
    check_map(transformed({1, 2, 3, 4, 5, 6}, inner), {10, 100}, {10 + 300 + 5, 20 + 400 + 6});
    check_map(moved(14, {}, {30, -40}, inner), {1, 1}, {31, -39});
    check_map(moved(16, {0.5, -1.5}, {}, inner), {100, 200}, {50, -300});
    check_map(moved(18, {0.5, 2.0 - 1.0 / 16384}, {100, 100}, inner), {200, 200}, {150, 300});
    check_map(moved(20, {0.25}, {}, inner), {100, 200}, {25, 50});
    check_map(moved(22, {0.5}, {100, 0}, inner), {200, 200}, {150, 100});
    check_map(moved(24, {0.25}, {}, inner), {100, 0}, {100 * half, 100 * half});
    check_map(moved(26, {0.5}, {100, 100}, inner), {200, 100}, {100, 200});
    check_map(moved(28, {0.25, 0.0}, {}, inner), {10, 100}, {-90, 100});
    check_map(moved(28, {0.0, 0.25}, {}, inner), {100, 10}, {100, 110});
    check_map(moved(30, {0.25, 0.0}, {0, 100}, inner), {10, 200}, {-90, 200});
    // The outer transform comes last.
    check_map(moved(14, {}, {100, 0}, moved(24, {0.5}, {}, inner)), {10, 0}, {100, 10});
    check_map(moved(24, {0.5}, {}, moved(14, {}, {100, 0}, inner)), {10, 0}, {0, 110});
}

TEST_CASE("turns and skews are the same with every standard library", "[colour]")
{
    for (int i = -16384; i <= 16384; i += 97) {
        const double half_turns = i / 32768.0;
        for (const std::uint32_t format : {24u, 28u}) {
            const affine m = detail::transform_of(format, {{half_turns, half_turns / 3.0}});
            for (const double v : {m.xx, m.xy, m.yx, m.yy}) CHECK(detail::steady(v) == v);
        }
    }
}

TEST_CASE("gradients come with their stops, their geometry and their mean colour", "[colour]")
{
    const paint root = colr_layers(3, 0);
    const std::vector<paint> layers = {
        test::glyph(linear({0, 10, 100, 20, 5, 300}, colour_line(1, {{0.75, 1}, {0.25, 0, 0.5}})), 1),
        moved(14, {}, {7, 8}, test::glyph(radial({1, 2, 3, 4, 5, 6}, colour_line(2, {{0, 2}, {1, 0xFFFF}})), 2)),
        test::glyph(sweep(50, 60, 0.25, 1.5, colour_line(0, {{0, 0}, {0.5, 1}, {1, 2}})), 3)};
    const colour_font font = painted_font({{1, root}}, layers);
    colour_glyph g;
    REQUIRE(read_colour_glyph(font.tables(), 1, {.foreground = {100, 0, 0, 1.0f}}, g));
    REQUIRE(g.layers.size() == 3);
    const glyph_paint &a = g.layers[0].paint, &b = g.layers[1].paint, &c = g.layers[2].paint;
    CHECK(a.kind == paint_kind::linear);
    CHECK(a.extend == gradient_extend::repeat);
    CHECK((a.from == point{0, 10} && a.to == point{100, 20} && a.across == point{5, 300}));
    REQUIRE(g.stops_of(a).size() == 2);
    CHECK(is_near(g.stops_of(a)[0].at, 0.25));  // stops ascend
    CHECK(has_colour(g.stops_of(a)[0].colour, 255, 0, 0, 0.5));
    CHECK(has_colour(a.colour, 128, 128, 0, 0.75));
    CHECK(b.kind == paint_kind::radial);
    CHECK(b.extend == gradient_extend::reflect);
    CHECK((b.from == point{1, 2} && is_near(b.from_radius, 3) && b.to == point{4, 5} && is_near(b.to_radius, 6)));
    CHECK(b.placed(point{0, 0}) == point{7, 8});
    CHECK(has_colour(g.stops_of(b)[1].colour, 100, 0, 0, 1.0));
    CHECK(c.kind == paint_kind::sweep);
    CHECK((is_near(c.from_turn, 0.25) && is_near(c.to_turn, 1.5)));
    CHECK(g.stops_of(c).size() == 3);
}

TEST_CASE("glyphs within glyphs, layers and clips nest", "[colour]")
{
    // Glyph 1 is glyph 2's layers, moved, within glyph 9.
    const colour_font font = painted_font(
        {{1, test::glyph(moved(14, {}, {100, 0}, colr_glyph(2)), 9)}, {2, colr_layers(2, 0)}, {3, solid_paint(1)}},
        {test::glyph(solid_paint(0), 5), test::glyph(solid_paint(1, 0.5), 6)}, {{3, 4, -1, -2, 30, 40}});
    colour_glyph g;
    REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
    REQUIRE(g.layers.size() == 2);
    CHECK(g.clip.empty());
    for (std::uint32_t i = 0; i < 2; ++i) {
        const layer_shape& s = g.shapes[g.layers[i].shape];
        REQUIRE(s.is == layer_shape::kind::both);
        CHECK(g.shapes[s.a].id == 9);
        CHECK(g.shapes[s.b].id == 5 + i);
        CHECK(g.shapes[s.b].map(point{0, 0}) == point{100, 0});
        CHECK(g.shapes[s.a].map(point{0, 0}) == point{0, 0});
    }
    REQUIRE(read_colour_glyph(font.tables(), 3, {}, g));  // the whole clip box
    REQUIRE(g.layers.size() == 1);
    CHECK(g.shapes[g.layers[0].shape].is == layer_shape::kind::rectangle);
    CHECK((g.clip.low == point{-1, -2} && g.clip.high == point{30, 40}));

    const colour_font endless = painted_font({{1, solid_paint(0)}});
    REQUIRE(read_colour_glyph(endless.tables(), 1, {}, g));
    CHECK(g.layers.empty());
    CHECK(g.unbounded == 1);
}

TEST_CASE("paints of version 1 precede layers of version 0", "[colour]")
{
    colour_font font = painted_font({{1, test::glyph(solid_paint(2), 5)}});
    table_writer both = table_writer{}.u16(1).u16(2).u32(font.colr.size()).u32(font.colr.size() + 12).u16(2);
    both.bytes.insert(both.bytes.end(), font.colr.bytes.begin() + 14, font.colr.bytes.end());
    both.u16(1).u16(0).u16(1).u16(4).u16(1).u16(1).u16(7).u16(0).u16(8).u16(1);
    font.colr = both;
    colour_glyph g;
    REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
    REQUIRE(g.layers.size() == 1);
    CHECK(g.shapes[g.layers[0].shape].id == 5);
    REQUIRE(read_colour_glyph(font.tables(), 4, {}, g));
    REQUIRE(g.layers.size() == 1);
    CHECK(g.shapes[g.layers[0].shape].id == 8);
}

TEST_CASE("composites keep what their mode says, in its order", "[colour]")
{
    struct expected {
        unsigned mode;
        const char* layers;  // S, B: whole; s, b: within the other; -: without the other
    };
    const expected all[] = {{0, ""},     {1, "S"},      {2, "B"},    {3, "B S"},  {4, "S B"},
                            {5, "s"},    {6, "b"},      {7, "-S"},   {8, "-B"},   {9, "B s"},
                            {10, "S b"}, {11, "-B -S"}, {12, "B S"}, {23, "B S"}, {27, "B S"}};
    for (const expected& e : all) {
        INFO("mode " << e.mode);
        const colour_font font =
            painted_font({{1, composite(test::glyph(solid_paint(0), 5), e.mode, test::glyph(solid_paint(1), 6))}});
        colour_glyph g;
        REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
        std::string found;
        for (const colour_layer& l : g.layers) {
            const layer_shape& s = g.shapes[l.shape];
            const glyph_id own = s.is == outline_kind ? s.id : g.shapes[s.a].id;
            if (!found.empty()) found += ' ';
            if (s.is == layer_shape::kind::without) found += '-';
            const bool within = s.is == layer_shape::kind::both;
            found += own == 5 ? (within ? 's' : 'S') : (within ? 'b' : 'B');
            CHECK(l.paint.entry == (own == 5 ? 0 : 1));
        }
        CHECK(found == e.layers);
        CHECK(g.blended == (e.mode >= 12 ? 1 : 0));
    }
    const colour_font font = painted_font({{1, composite(solid_paint(0), 28, solid_paint(1))}});
    colour_glyph g;
    CHECK(read_colour_glyph(font.tables(), 1, {}, g).error() == error::bad_colours);
}

TEST_CASE("a source without bounds fills what its backdrop covers", "[colour]")
{
    const colour_font font = painted_font({{1, composite(solid_paint(0), 5, test::glyph(solid_paint(1, 0.5), 6))},
                                           {2, composite(solid_paint(0), 7, test::glyph(solid_paint(1), 6))},
                                           {3, composite(solid_paint(0), 7, test::glyph(solid_paint(1), 6))}},
                                          {}, {{3, 3, 0, 0, 900, 900}});
    colour_glyph g;
    REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
    REQUIRE(g.layers.size() == 1);
    CHECK(g.shapes[g.layers[0].shape].id == 6);
    CHECK(g.layers[0].paint.entry == 0);
    CHECK(g.translucent == 1);
    REQUIRE(read_colour_glyph(font.tables(), 2, {}, g));  // all but the glyph, and no clip box
    CHECK(g.layers.empty());
    CHECK(g.unbounded == 1);
    REQUIRE(read_colour_glyph(font.tables(), 3, {}, g));
    REQUIRE(g.layers.size() == 1);
    CHECK(g.shapes[g.layers[0].shape].is == layer_shape::kind::without);
}

TEST_CASE("variable paints are read at the place on the axes", "[colour]")
{
    // One axis; one region that peaks at 1; deltas of 100, -50 and 4096 (a quarter of a 2.14 number).
    table_writer store = table_writer{}.u16(1).u32(12).u16(1).u32(22);
    store.u16(1).u16(1).fraction(0.0).fraction(1.0).fraction(1.0);
    store.u16(3).u16(1).u16(1).u16(0).i16(100).i16(-50).i16(4096);
    const paint inner = test::glyph(solid_paint(0), 4);
    colour_font font = painted_font(
        {{1, moved(15, {}, {10, 20}, inner, 0)}, {2, test::glyph(paint{}.u8(3).u16(0).fraction(0.5).u32(2), 4)}}, {},
        {}, store);
    const auto place = [&](double axis) {
        font.axes = {static_cast<std::int32_t>(axis * 16384)};
        colour_glyph g;
        REQUIRE(read_colour_glyph(font.tables(), 1, {}, g));
        return g.shapes[g.layers[0].shape].map(point{0, 0});
    };
    CHECK(place(0.0) == point{10, 20});
    CHECK(place(1.0) == point{110, -30});
    CHECK(place(0.5) == point{60, -5});
    CHECK(place(-1.0) == point{10, 20});
    colour_glyph g;
    font.axes = {16384};
    REQUIRE(read_colour_glyph(font.tables(), 2, {}, g));
    CHECK(is_near(as_double(g.layers[0].paint.colour.alpha), 0.75));
    font.axes = {};
    REQUIRE(read_colour_glyph(font.tables(), 2, {}, g));
    CHECK(is_near(as_double(g.layers[0].paint.colour.alpha), 0.5));
}

TEST_CASE("cycles, endless nesting and too many layers are refused", "[colour]")
{
    colour_glyph g;
    const auto refused = [&](const colour_font& font, const colour_choice& how = {}) {
        const auto found = read_colour_glyph(font.tables(), 1, how, g);
        return !found && found.error() == error::bad_colours && g.layers.empty();
    };
    CHECK(refused(painted_font({{1, colr_glyph(1)}})));
    CHECK(refused(painted_font({{1, colr_glyph(2)}, {2, test::glyph(colr_glyph(1), 3)}})));
    CHECK(refused(painted_font({{1, colr_glyph(7)}})));
    CHECK(refused(painted_font({{1, colr_layers(1, 0)}}, {colr_layers(1, 0)})));
    // Each layer list doubles the paints: 2^40 of them.
    std::vector<paint> doubling;
    for (unsigned i = 0; i < 40; ++i) doubling.push_back(composite(colr_layers(1, i + 1), 3, colr_layers(1, i + 1)));
    doubling.push_back(test::glyph(solid_paint(0), 1));
    CHECK(refused(painted_font({{1, colr_layers(1, 0)}}, doubling)));
    CHECK(refused(
        painted_font({{1, colr_layers(2, 0)}}, {test::glyph(solid_paint(0), 3), test::glyph(solid_paint(0), 4)}),
        {.max_layers = 1}));
    CHECK(refused(painted_font({{1, colr_layers(3, 0)}}, {test::glyph(solid_paint(0), 3)})));
    CHECK(refused(painted_font({{1, paint{}.u8(33)}})));
    CHECK(refused(painted_font({{1, test::glyph(linear({0, 0, 1, 1, 2, 2}, colour_line(0, {})), 2)}})));
    paint deep = test::glyph(solid_paint(0), 4);
    for (int i = 0; i < 62; ++i) deep = moved(14, {}, {1, 0}, deep);
    CHECK_FALSE(refused(painted_font({{1, deep}})));
    CHECK(refused(painted_font({{1, moved(14, {}, {1, 0}, deep)}})));
}

TEST_CASE("damaged colour tables end in layers or in one error", "[colour]")
{
    table_writer store = table_writer{}.u16(1).u32(12).u16(1).u32(22);
    store.u16(1).u16(1).fraction(0.0).fraction(1.0).fraction(1.0);
    store.u16(3).u16(1).u16(1).u16(0).i16(100).i16(-50).i16(4096);
    colour_font fonts[] = {
        flat_font({{3, {{7, 0}, {8, 0xFFFF}, {9, 3}}}, {6, {{2, 1}, {1, 9}}}}),
        painted_font({{3, composite(moved(27, {0.5}, {3, 4}, test::glyph(solid_paint(0), 5), 0), 5, colr_layers(2, 0))},
                      {6, test::glyph(sweep(1, 2, 0.0, 1.0, colour_line(1, {{0, 0}, {1, 1}})), 4)}},
                     {test::glyph(linear({0, 0, 1, 1, 2, 2}, colour_line(0, {{0, 1}, {1, 2}})), 2), colr_glyph(6)},
                     {{3, 6, 0, 0, 500, 500}}, store)};
    std::mt19937 random{34};
    colour_glyph g;
    unsigned refused = 0, sound = 0;
    for (colour_font& whole : fonts) {
        whole.axes = {8192};
        for (int round = 0; round < 4000; ++round) {
            colour_font font = whole;
            for (unsigned n = random() % 4 + 1; n-- > 0;)
                font.colr.bytes[random() % font.colr.size()] =
                    static_cast<std::byte>(random() % 3 == 0 ? 0xFF : random());
            if (round % 4 == 0) font.colr.bytes.resize(random() % font.colr.size());
            if (round % 5 == 0) font.cpal.bytes.resize(random() % font.cpal.size());
            for (const glyph_id id : {3u, 6u}) {
                const auto found = read_colour_glyph(font.tables(), id, {}, g);
                if (!found) {
                    ++refused;
                    REQUIRE(found.error() == error::bad_colours);
                    REQUIRE(g.layers.empty());
                    continue;
                }
                ++sound;
                for (const colour_layer& l : g.layers) REQUIRE(l.shape < g.shapes.size());
                for (std::size_t i = 0; i < g.shapes.size(); ++i)
                    REQUIRE((g.shapes[i].is == outline_kind || (g.shapes[i].a <= i && g.shapes[i].b <= i)));
            }
        }
    }
    CHECK(refused > 1000);
    CHECK(sound > 1000);
}

TEST_CASE("colour glyphs are read with failing memory", "[colour]")
{
    const colour_font font =
        painted_font({{1, composite(test::glyph(solid_paint(0), 5), 5, colr_layers(1, 0))}},
                     {test::glyph(linear({0, 0, 1, 1, 2, 2}, colour_line(0, {{0, 1}, {1, 2}})), 2)});
    const std::size_t requests = check_each_failure([&](memory source) {
        colour_glyph g{source};
        const auto found = read_colour_glyph(font.tables(), 1, {}, g);
        if (!found) CHECK(g.layers.empty());
        return found ? error{} : found.error();
    });
    CHECK(requests == 3);
}

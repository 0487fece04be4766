// SPDX-License-Identifier: MIT

#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/filled_shape.hpp"
#include "support/letters.hpp"
#include "support/swept_cases.hpp"

#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// A shape's size: the largest of its extents.
double size_of(const test::shape& s)
{
    box around;
    for (const auto& l : s.loops)
        for (const grid_point p : l) around.add({double(p.x), double(p.y)});
    return (std::max)(around.high.x - around.low.x, around.high.y - around.low.y);
}

std::size_t points_of(const test::shape& s)
{
    std::size_t n = 0;
    for (const auto& l : s.loops) n += l.size();
    return n;
}

/// A shape enlarged to twice the usual size of an em: strokes of a few cells would be lost between grid points.
test::shape enlarged(test::shape s)
{
    for (double size = size_of(s); size <= 0x1p20; size *= 2)
        for (auto& l : s.loops)
            for (grid_point& p : l) p = {2 * p.x, 2 * p.y};
    return s;
}

/// Fills a shape and sweeps it inwards by a share of its size, over both triangulations. Returns the number of refusals.
int check_sweep(const test::shape& s, double share, double mitre_limit, double tolerance)
{
    CAPTURE(s, share, mitre_limit, tolerance);
    const test::filled_shape f{s};
    test::sweep_case by_monotone;
    by_monotone.levels = test::levels_to(std::floor(share * size_of(s)), 3);
    by_monotone.mitre_limit = mitre_limit;
    by_monotone.tolerance = tolerance;
    by_monotone.compare_area = points_of(s) < 130;
    test::sweep_case by_delaunay = by_monotone;
    by_monotone.examine(f.filled, monotone{});
    CHECK(by_monotone.broken == "");
    by_delaunay.compare_area = false;
    by_delaunay.examine(f.filled, constrained_delaunay{});
    CHECK(by_delaunay.broken == "");
    return int{by_monotone.refused} + int{by_delaunay.refused};
}

/// One shape, swept to these levels with mitred corners; triangles by monotone.
test::sweep_case swept(const std::vector<test::polyline>& given, std::vector<double> levels, double mitre_limit = 0.0)
{
    const test::filled_shape f{{"", given}};
    test::sweep_case how;
    how.levels = std::move(levels);
    how.mitre_limit = mitre_limit;
    how.examine(f.filled, monotone{});
    CHECK(how.broken == "");
    CHECK_FALSE(how.refused);
    return how;
}

using areas = std::vector<std::int64_t>;

std::vector<test::shape> letters_and_ties()
{
    std::vector<test::shape> all;
    all.push_back({"L", {{{0, 0}, {3000, 0}, {3000, 1000}, {1000, 1000}, {1000, 3000}, {0, 3000}}}});
    all.push_back({"T", {test::letter_tee(1000)}});
    all.push_back({"H", {test::letter_aitch(1000)}});
    const test::polyline plus{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                              {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    all.push_back({"plus of nine squares", {test::scaled(plus, 1000)}});
    all.push_back({"angle quote",
                   {{{0, 35600}, {33500, 0}, {41600, 0}, {18800, 38900}, {41600, 77800}, {33500, 77800}, {0, 42200}}}});
    all.push_back({"slit", {{{0, 0}, {1000, 0}, {1000, 1000}, {501, 1000}, {500, 10}, {499, 1000}, {0, 1000}}}});
    all.push_back(
        {"points on straight edges",
         {{{0, 0}, {300, 0}, {700, 0}, {1000, 0}, {1000, 500}, {1000, 1000}, {500, 1000}, {0, 1000}, {0, 999}}}});
    all.push_back({"squares that touch", {test::square(0, 0, 1000), test::square(1000, 1000, 1000)}});
    all.push_back({"square ring", {test::square(0, 0, 10000), test::reversed(test::square(4000, 4000, 2000))}});
    all.push_back(
        {"hole that touches", {test::square(0, 0, 10000), {{5000, 0}, {2500, 5000}, {5000, 7500}, {7500, 5000}}}});
    all.push_back({"hole that touches twice",
                   {test::square(0, 0, 10000), {{5000, 0}, {2500, 5000}, {5000, 10000}, {7500, 5000}}}});
    all.push_back(test::chess_board(6));
    for (const int corners : {3, 4, 5, 6, 7, 8, 12, 16, 17, 32, 64, 100, 128})
        all.push_back({"regular polygon of " + std::to_string(corners), {test::circle(corners, 1e6)}});
    all.push_back({"ring of two polygons", {test::circle(48, 1e6), test::reversed(test::circle(48, 6e5))}});
    return all;
}

}  // namespace

TEST_CASE("sweep_inwards() leaves the right parts of rectangles and rings", "[offset]")
{
    CHECK(swept({test::square(0, 0, 1000)}, {0, 100, 300}).doubled_areas ==
          areas{2 * 1000 * 1000, 2 * 800 * 800, 2 * 400 * 400});
    CHECK(swept({{{0, 0}, {3000, 0}, {3000, 1000}, {0, 1000}}}, {0, 400}).doubled_areas ==
          areas{2 * 3000 * 1000, 2 * 2200 * 200});

    const auto ring =
        std::vector<test::polyline>{test::square(0, 0, 1000), test::reversed(test::square(400, 400, 200))};
    const auto some = swept(ring, {0, 100});
    CHECK(some.doubled_areas == areas{2 * 960'000, 2 * (800 * 800 - 400 * 400)});
    CHECK(some.cap_outers == 1);
    CHECK(some.cap_holes == 1);
    const auto none = swept(ring, {0, 200});  // exactly where it closes
    CHECK(none.doubled_areas == areas{2 * 960'000, 0});
    CHECK(none.cap_outers == 0);
    CHECK(none.cap_holes == 0);
    CHECK(swept(ring, {0, 100, 400}).doubled_areas == areas{2 * 960'000, 2 * 480'000, 0});
}

TEST_CASE("sweep_inwards() splits letters at thin strokes", "[offset]")
{
    const auto all = letters_and_ties();
    const auto& h = all[2];
    CHECK(h.name == "H");
    const auto before = swept(h.loops, {0, 290}), at = swept(h.loops, {0, 300}), after = swept(h.loops, {0, 310});
    CHECK(before.cap_outers == 1);
    CHECK(before.doubled_areas.back() == 2 * (2 * 420 * 2420 + 1580 * 20));
    CHECK(at.cap_outers == 2);
    CHECK(at.doubled_areas.back() == 2 * (2 * 400 * 2400));
    CHECK(after.cap_outers == 2);
    CHECK(after.doubled_areas.back() == 2 * (2 * 380 * 2380));
    const auto touching = swept(all[7].loops, {0, 100});
    CHECK(touching.cap_outers == 2);
    CHECK(touching.doubled_areas.back() == 2 * 2 * 800 * 800);
}

TEST_CASE("sweep_inwards() obeys its laws on letters, ties and touching loops at every width", "[offset]")
{
    const double mitre_limit = GENERATE(0.0, 2.0), tolerance = GENERATE(0.0, 2.0);
    int refused = 0;
    for (const test::shape& given : letters_and_ties()) {
        const test::shape s = enlarged(given);
        for (const double share : {0.01, 0.03, 0.1, 0.2, 0.35, 0.6})
            for (const test::shape& t : {s, test::mirrored(s), test::turned(s, 30.0), test::shuffled(s, 5)})
                refused += check_sweep(t, share, mitre_limit, tolerance);
    }
    CHECK(refused == 0);
}

TEST_CASE("sweep_inwards() obeys its laws on stars, combs, spirals and smooth curves", "[offset]")
{
    const double mitre_limit = GENERATE(0.0, 2.0);
    std::vector<test::shape> shapes = test::delaunay_shapes();
    for (std::uint64_t seed = 10; seed < 25; ++seed)
        shapes.push_back({"star of seed " + std::to_string(seed), {test::star(20 + 3 * int(seed), 1e6, seed)}});
    int refused = 0;
    for (const test::shape& given : shapes) {
        if (points_of(given) > 3000 || size_of(given) > 0x1p26) continue;  // larger than any glyph
        const test::shape s = enlarged(given);
        for (const double share : {0.005, 0.02, 0.05, 0.3})
            for (const test::shape& t : {s, test::mirrored(s)}) refused += check_sweep(t, share, mitre_limit, 0.0);
    }
    CHECK(refused == 0);
}

TEST_CASE("sweep_inwards() obeys its laws on random polygons", "[offset]")
{
    int refused = 0;
    for (int i = 0; i < 150; ++i) {
        test::dice d{static_cast<std::uint64_t>(1000 + i)};
        test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(8 + i / 2, 40, d)}};
        for (const double share : {0.01, 0.05, 0.2})
            refused += check_sweep(enlarged(s), share, i % 2 == 0 ? 0.0 : 2.0, 0.0);
    }
    CHECK(refused == 0);
}

TEST_CASE("sweep_inwards() sweeps glyphs whose strokes close at one distance or beside a corner", "[offset]")
{
    const test::polyline arrow{{362240, 42496},  {332288, 0},     {476416, 55296}, {338176, 187392},
                               {332288, 129024}, {362240, 86528}, {0, 86528},      {0, 42496}};
    const test::polyline blunt_arrow{{392192, 42496},  {362240, 0},     {506368, 55296}, {466560, 97024},
                                     {362240, 129024}, {392192, 86528}, {0, 86528},      {0, 42496}};
    const struct {
        const char* name;
        double width;
        std::vector<test::polyline> loops;
    } glyphs[] = {
        {"window with bars as thick as twice the width",
         5120,
         {{{307200, 0}, {307200, 240640}, {0, 240640}, {0, 0}},
          {{158720, 128000}, {296960, 128000}, {296960, 35840}},
          {{158720, 138240}, {158720, 230400}, {296960, 138240}},
          {{10240, 128000}, {148480, 128000}, {148480, 35840}},
          {{10240, 230400}, {148480, 230400}, {148480, 138240}, {10240, 138240}}}},
        {"window with thinner bars",
         15360,
         {{{307200, 0}, {307200, 240640}, {0, 240640}, {0, 0}},
          {{158720, 35840}, {158720, 128000}, {296960, 128000}},
          {{158720, 138240}, {158720, 230400}, {296960, 230400}, {296960, 138240}},
          {{10240, 128000}, {148480, 35840}, {10240, 35840}},
          {{10240, 230400}, {148480, 230400}, {148480, 138240}}}},
        {"arrow whose stem closes before its head", 31457, {arrow}},
        {"arrow with a blunt head", 30712, {blunt_arrow}},
        {"thin hole in a thin wedge",
         9000,
         {{{0, 0}, {15809, 60691}, {17427, 73152}, {18523, 85670}, {14063, 160737}},
          {{9542, 86266}, {8480, 74124}, {6910, 62037}}}},
    };
    for (const auto& g : glyphs) {
        const test::shape s{g.name, g.loops};
        for (const double mitre_limit : {0.0, 2.0})
            for (const double share : {0.5, 1.0, 2.0, 8.0})
                for (const test::shape& t : {s, test::mirrored(s), test::turned(s, 180.0), test::turned(s, 12.0)})
                    CHECK(check_sweep(t, share * g.width / size_of(s), mitre_limit, 0.0) == 0);
    }
}

TEST_CASE("sweep_inwards() keeps faces in their planes when nearly parallel edges close", "[offset]")
{
    // Corners between such edges are a million times as fast as the edges.
    const test::polyline strip{{1249621, 0},    {1252529, 12596},  {1279854, 130955}, {1281308, 137253},
                               {31673, 428841}, {1278085, 137800}, {30234, 422605},   {1440, 297886},
                               {1247852, 6845}, {0, 291650}};
    const struct {
        double width;
        double mitre_limit;
        std::vector<test::polyline> loops;
    } shapes[] = {
        {117'898,
         0.0,
         {{{700059, 847276}, {221136, 957844}, {184280, 798203}, {147424, 638563}, {36856, 159640}, {0, 0}},
          {{98249, 61392}, {135105, 221033}, {294746, 184177}},
          {{245673, 699955}, {282529, 859596}, {405313, 663099}}}},
        {30'750, 2.0, {strip}},
    };
    for (const auto& s : shapes) CHECK(swept(s.loops, {0, s.width}, s.mitre_limit).farthest_off_plane < 2.0);
}

TEST_CASE("sweep_inwards() sweeps rings that close everywhere at about one distance", "[offset]")
{
    for (const double radius : {3e4, 3e5, 1e6, 4e6})
        for (const int corners : {8, 12, 20, 32})
            for (const double hole : {0.6, 0.9})
                for (const double degrees : {0.0, 11.3}) {
                    const auto ring = test::turned(
                        {"ring", {test::circle(corners, radius), test::reversed(test::circle(corners, radius * hole))}},
                        degrees);
                    const double closes = radius * (1.0 - hole) / 2.0;
                    for (const double share : {0.9, 1.0, 2.0}) {
                        CAPTURE(radius, corners, hole, degrees, share);
                        CHECK(swept(ring.loops, {0, std::floor(share * closes)}).farthest_off_plane < 2.0);
                    }
                }
}

TEST_CASE("sweep_inwards() sweeps needles narrower than a cell, and fast tips", "[offset]")
{
    const struct {
        double width;
        std::vector<test::polyline> loops;
    } needles[] = {
        {25, {{{0, 0}, {500, 0}, {250, 500}, {250, 5}, {249, 500}}}},
        {320, {{{0, 0}, {64000, 2}, {6, 3}, {64000, 7}, {0, 35}}}},
        {3947, {{{440, 0}, {313, 21}, {180200, 779444}, {253, 43}, {179950, 779501}, {0, 85}}}},
    };
    for (const auto& n : needles)
        for (const double mitre_limit : {0.0, 2.0})
            CHECK(swept(n.loops, {0, n.width}, mitre_limit).farthest_off_plane < 3.0);
    test::polyline comb{{0, 0}};
    for (int i = 0; i < 7; ++i) {
        comb.push_back({1'600'000, 128 * i});
        comb.push_back({1'600'000, 128 * i + 64});
        comb.push_back({160 + 16 * (i % 3), 128 * i + 80});
    }
    comb.push_back({0, 880});
    const test::shape upright{"comb of needles", {comb}};
    for (const double degrees : {0.0, 12.0, 77.0})
        for (const double mitre_limit : {0.0, 2.0})
            for (const double width : {20.0, 79.0, 8000.0})
                CHECK(swept(test::turned(upright, degrees).loops, {0, width}, mitre_limit).farthest_off_plane < 3.0);
}

TEST_CASE("sweep_inwards() sweeps strokes that close at a level, and caps that touch a hole there", "[offset]")
{
    CHECK(swept({{{211672, 280872}, {219200, 322368}, {223752, 365496}, {0, 0}},
                 {{213504, 365496}, {208896, 322368}, {201216, 280872}}},
                {0, 5120, 10240})
              .farthest_off_plane < 3.0);
    const auto touching = swept(
        {{{281, 440}, {133, 407}, {133, 358}, {0, 358}, {133, 0}}, {{189, 337}, {153, 317}, {153, 337}}}, {0, 10});
    CHECK(touching.doubled_areas.back() > 0);
}

TEST_CASE("sweep_inwards() joins several nodes where a round shape closes in its centre", "[offset]")
{
    // Over the Delaunay triangles the corners of this shape meet one by one, a few cells apart.
    const test::polyline small{{34187, 45641}, {38730, 48263}, {40524, 53193}, {38730, 58123}, {34187, 60745},
                               {29021, 59835}, {25648, 55816}, {25648, 50570}, {29020, 46551}};
    const test::filled_shape f{
        {"two polygons",
         {{{59228, -5021},   {66417, -14257},  {76215, -20658}, {87561, -23532}, {99225, -22565}, {104374, -20307},
           {105146, -20378}, {124915, -14754}, {141317, -2368}, {152136, 15107}, {155913, 35310}, {152136, 55513},
           {141317, 72988},  {124915, 85374},  {105146, 90998}, {84681, 89102},  {66282, 79941},  {52436, 64752},
           {45011, 45587},   {45011, 25033},   {52436, 5868},   {57335, 494}},
          {{60103, 89222},  {59579, 93205},  {58041, 96916},  {55596, 100103}, {52409, 102548}, {48698, 104086},
           {44715, 104610}, {40732, 104086}, {37021, 102548}, {33834, 100103}, {31389, 96916},  {29851, 93205},
           {29327, 89222},  {29851, 85239},  {31389, 81528},  {33834, 78341},  {37021, 75896},  {40732, 74358},
           {44715, 73834},  {48698, 74358},  {52409, 75896},  {55596, 78341},  {58041, 81528},  {59579, 85239}},
          small}}};
    test::sweep_case how;
    how.levels = {0.0, 6559.868, 12672.694, 17921.894, 21949.748, 24481.762, 25345.386};
    how.examine(f.filled, constrained_delaunay{});
    CHECK(how.broken == "");
    CHECK_FALSE(how.refused);
}

TEST_CASE("sweep_inwards() allocates nothing once warm, and reports that memory ran out", "[offset]")
{
    test::filled_shape f{{"star", {test::star(60, 1e6, 1)}}};
    triangle_list triangles;
    REQUIRE_FALSE(monotone{}(f.filled, f.space, triangles));
    const double levels[] = {0.0, 10'000.0, 40'000.0};
    const sweep_options how{.levels = levels, .mitre_limit = 2.0, .tolerance = 10.0};
    const auto sweep = [&](workspace& space, swept_region& out) {
        out.clear();
        workspace::scope scratch{space};
        return sweep_inwards(f.filled, triangles.view(), how, scratch, out);
    };

    test::counting_memory memory;
    {
        workspace space{memory.source()};
        swept_region out{memory.source()};
        for (int i = 0; i < 3; ++i) REQUIRE_FALSE(sweep(space, out));
        CHECK(test::swept_laws{f.filled, out}.broken() == "");
        const std::size_t warm = memory.requests;
        REQUIRE_FALSE(sweep(space, out));
        CHECK(memory.requests == warm);
    }
    CHECK(memory.bytes_held == 0);

    for (std::size_t n = 1;; ++n) {
        test::counting_memory failing{.fail_at = n};
        bool done = false;
        {
            workspace space{failing.source()};
            swept_region out{failing.source()};
            const error e = sweep(space, out);
            done = !e;
            CHECK((!e || e.code == error::out_of_memory));
        }
        CHECK(failing.bytes_held == 0);
        if (done) break;
        REQUIRE(n < 10'000);
    }
}

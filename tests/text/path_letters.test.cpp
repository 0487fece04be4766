// SPDX-License-Identifier: MIT

// Where letters stand on a path, before there is a mesh: in double precision.

#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/layout/layout.hpp>
#include <typemesh/text/on_path.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr double path_pi = 3.141592653589793;

/// A line of letters with these advances, in thousandths of an em.
void set_letters(glyph_run& run, const std::vector<double>& advances, point origin = {})
{
    run.units_per_em = 1000.0;
    double pen = origin.x;
    const auto first = static_cast<std::uint32_t>(run.glyphs.size());
    for (const double a : advances) {
        const auto n = static_cast<std::uint32_t>(run.glyphs.size());
        REQUIRE(run.glyphs.push_back({1, n, {pen, origin.y}, false, 0, static_cast<float>(0.5 * a)}));
        pen += a;
    }
    REQUIRE(
        run.lines.push_back({first, static_cast<std::uint32_t>(run.glyphs.size()) - first, origin, pen - origin.x}));
}

std::vector<glyph_stand> stand(const glyph_run& run, const on_path& way)
{
    REQUIRE_FALSE(way.refused({}));
    std::vector<glyph_stand> stands(run.glyphs.size());
    REQUIRE_FALSE(way.place(run, run.units_per_em, stands.data()));
    return stands;
}

/// The middle of a letter's advance on its baseline, in em.
point middle_of(const glyph_run& run, const std::vector<glyph_stand>& stands, std::size_t i)
{
    return 1e-3 * (stands[i].origin + double{run.glyphs[i].to_middle} * stands[i].right);
}

}  // namespace

TEST_CASE("letters on a circle touch it, and their advances are the way between their middles", "[text][path]")
{
    const std::vector<double> advances = {600, 313.7, 1000, 278, 555.25, 12, 700};
    for (const double radius : {0.7, 2.0, 30.0})
        for (const path_side side : {path_side::left, path_side::right})
            for (const path_anchor anchor : {path_anchor::start, path_anchor::middle, path_anchor::end}) {
                plane_path ring;
                ring.circle({0.25, -1.0}, radius);
                glyph_run run;
                set_letters(run, advances);
                const auto stands = stand(run, {&ring, {.anchor = anchor, .side = side}});
                double before = 0.0;
                for (std::size_t i = 0; i < advances.size(); ++i) {
                    const point arm = middle_of(run, stands, i) - point{0.25, -1.0};
                    CHECK(std::fabs(length(arm) - radius) < 1e-6);
                    CHECK(std::fabs(dot(arm, stands[i].right)) < 1e-6);                       // the tangent
                    CHECK((cross(arm, stands[i].right) < 0.0) == (side == path_side::left));  // stands outside, inside
                    CHECK(std::fabs(length(stands[i].right) - 1.0) < 1e-11);
                    const double angle = std::atan2(arm.y, arm.x);
                    if (i > 0) {
                        double turn = side == path_side::left ? before - angle : angle - before;
                        turn -= 2.0 * path_pi * std::floor(turn / (2.0 * path_pi));
                        CHECK(std::fabs(radius * turn - 5e-4 * (advances[i - 1] + advances[i])) < 1e-6);
                    }
                    before = angle;
                    CHECK_FALSE(stands[i].warped);
                    CHECK_FALSE(stands[i].left_out);
                }
                // The anchor: the middle of the text is on top of the circle, or its start or end at the bottom.
                const point first = middle_of(run, stands, 0) - point{0.25, -1.0};
                const double s = side == path_side::left ? 1.0 : -1.0, all = 3.45895;
                const double start = anchor == path_anchor::start    ? 0.0
                                     : anchor == path_anchor::middle ? path_pi * radius - 0.5 * all
                                                                     : 2.0 * path_pi * radius - all;
                const double at = -0.5 * path_pi - s * (start + 0.3) / radius;
                CHECK(length(first - radius * point{std::cos(at), std::sin(at)}) < 1e-6);
            }
}

TEST_CASE("on a line from the origin letters stay where they are, bit for bit", "[text][path]")
{
    plane_path way;
    way.move({0, 0});
    way.line({49, 0});
    glyph_run run;
    set_letters(run, {600, 313.7, 1000.0 / 3.0, 278}, {0.0, 0.0});
    set_letters(run, {611.1, 313.7, 99}, {0.0, -1234.5});
    for (const path_warp warp : {path_warp::never, path_warp::always}) {
        const auto stands = stand(run, {&way, {.warp = warp}});
        for (std::size_t i = 0; i < stands.size(); ++i) {
            CHECK(stands[i].origin == run.glyphs[i].origin);
            CHECK(stands[i].right == point{1.0, 0.0});
            CHECK_FALSE((stands[i].warped || stands[i].left_out));
        }
    }
}

TEST_CASE("a circle that is exactly full has room for all its letters, and for none more", "[text][path]")
{
    for (const int count : {7, 12, 100}) {
        plane_path ring;
        ring.circle({0, 0}, count * 0.6 / (2.0 * path_pi));
        glyph_run run;
        set_letters(run, std::vector<double>(static_cast<std::size_t>(count), 600.0));
        const auto stands = stand(run, {&ring, {.anchor = path_anchor::middle, .offset = 0.37}});
        for (std::size_t i = 0; i < stands.size(); ++i) {
            CHECK_FALSE(stands[i].left_out);
            const std::size_t next = (i + 1) % stands.size();
            const double turn =
                std::atan2(cross(stands[i].right, stands[next].right), dot(stands[i].right, stands[next].right));
            CHECK(turn == Catch::Approx(-2.0 * path_pi / count).epsilon(1e-6));
        }
        glyph_run more;
        set_letters(more, std::vector<double>(static_cast<std::size_t>(count) + 3, 600.0));
        const auto crowded = stand(more, {&ring});
        for (std::size_t i = 0; i < crowded.size(); ++i)
            CHECK(crowded[i].left_out == (i >= static_cast<std::size_t>(count)));
        const auto spread = stand(more, {&ring, {.fit = path_fit::spread}});
        for (std::size_t i = 0; i < spread.size(); ++i) {
            CHECK_FALSE(spread[i].left_out);
            const std::size_t next = (i + 1) % spread.size();
            const double turn =
                std::atan2(cross(spread[i].right, spread[next].right), dot(spread[i].right, spread[next].right));
            CHECK(turn == Catch::Approx(-2.0 * path_pi / (count + 3)).epsilon(1e-6));
        }
    }
}

TEST_CASE("letters whose middles lie beyond an open path are left out, hanging spaces are not", "[text][path]")
{
    plane_path way;
    way.move({0, 0});
    way.arc({0, -1}, -90.0);  // 1.5708 em
    glyph_run run;
    set_letters(run, {600, 600, 600, 600, 600});
    run.lines[0].advance = 2400.0;  // the last one hangs
    const auto out = [&](const path_options& how) {
        std::string shown;
        for (const glyph_stand& s : stand(run, {&way, how})) shown += s.left_out ? '-' : '+';
        return shown;
    };
    CHECK(out({}) == "+++-+");
    CHECK(out({.offset = -0.31}) == "-++-+");
    CHECK(out({.anchor = path_anchor::middle}) == "-++-+");
    CHECK(out({.anchor = path_anchor::end}) == "-++++");
    CHECK(out({.anchor = path_anchor::end, .side = path_side::right}) == "-++++");
    CHECK(out({.fit = path_fit::spread}) == "+++++");
}

TEST_CASE("marks turn with their base, lines keep their distance from the path", "[text][path]")
{
    plane_path way;
    way.move({0, 0});
    way.cubic({1, 2}, {3, 1}, {4, -1});
    glyph_run run;
    set_letters(run, {600, 700, 600}, {0.0, 0.0});
    set_letters(run, {600, 700, 600}, {0.0, 1500.0});
    REQUIRE(run.glyphs.push_back({1, 4, {900.0, 2222.0}, false, 0, 50.0f}));  // over the second letter of that line
    run.glyphs[4].to_middle = static_cast<float>(950.0 + 1e-5) - 600.0f;      // as a sum of floats gives it
    ++run.lines[1].glyph_count;
    const auto stands = stand(run, {&way});
    for (std::size_t i = 0; i < 3; ++i) {
        const double s = 1e-3 * (run.glyphs[i].origin.x + double{run.glyphs[i].to_middle});
        const plane_path::place on = way.at(s);
        CHECK(length(middle_of(run, stands, i) - on.at) < 1e-9);
        CHECK(stands[i].right == on.tangent);
        const point left{-on.tangent.y, on.tangent.x};
        CHECK(length(middle_of(run, stands, 3 + i) - (on.at + 1.5 * left)) < 1e-7);
    }
    const point mark = stands[6].origin - stands[4].origin, right = stands[4].right;
    CHECK(stands[6].right == right);
    CHECK(dot(mark, right) == Catch::Approx(300.0));
    CHECK(cross(right, mark) == Catch::Approx(722.0));
}

TEST_CASE("joined letters and bars are warped unless they must not be, and nothing is on a line", "[text][path]")
{
    plane_path bow, line;
    bow.circle({0, 0}, 2.0);
    line.move({0, 0});
    line.line({1, 1});
    glyph_run run;
    set_letters(run, {600, 600, 600});
    run.glyphs[1].joined = true;
    run.glyphs[2].cluster = no_cluster;
    const auto warped_with = [&](const plane_path& way, path_warp warp) {
        std::string seen;
        for (const glyph_stand& s : stand(run, {&way, {.warp = warp}})) seen += s.warped ? 'w' : 't';
        return seen;
    };
    CHECK(warped_with(bow, path_warp::automatic) == "tww");
    CHECK(warped_with(bow, path_warp::never) == "ttw");
    CHECK(warped_with(bow, path_warp::always) == "www");
    CHECK(warped_with(line, path_warp::always) == "ttt");
}

TEST_CASE("a layout knows the middle of each cluster, and which scripts join letters", "[layout][path]")
{
    test::toy_font font;
    plain_layout layout;
    glyph_run run;
    REQUIRE(layout(font, "oE o\nxx", {.letter_spacing = 0.1}, {.align = alignment::centre}, run));
    REQUIRE(run.glyphs.size() == 6);
    for (const placed_glyph& g : run.glyphs) {
        CHECK(std::fabs(g.to_middle - 300.0f) <= 50.0f);  // letter spacing belongs to the advance
        CHECK_FALSE(g.joined);
    }
    for (std::size_t i = 0; i + 1 < 4; ++i)
        CHECK(double{run.glyphs[i].to_middle} * 2.0 ==
              Catch::Approx(run.glyphs[i + 1].origin.x - run.glyphs[i].origin.x));
    REQUIRE(layout(font, "\u0628\u0627", {}, {}, run));
    for (const placed_glyph& g : run.glyphs) CHECK(g.joined);
}

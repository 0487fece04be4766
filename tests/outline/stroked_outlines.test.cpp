// SPDX-License-Identifier: MIT

// Strokes beside an oracle that knows only distances: with round caps and joins a stroke is what is nearer to the path
// than half of its width. Other caps and joins beside shapes in closed form.

#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/stroked.hpp>
#include <typemesh/outline/stroked_outlines.hpp>
#include <typemesh/outline/svg_path.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

namespace {

outline stroke_of(const char* data, const stroke_style& style, double tolerance)
{
    svg_path path{data, 100.0};
    stroked_outlines lines{path, style, tolerance / 100.0};
    outline out;
    const auto done = record(lines, 0, out);
    INFO(data);
    REQUIRE(done);
    return out;
}
/// Whether a place is covered, by the rule non_zero; `places` may hold any.
double covered(const outline& stroke, const std::vector<point>& places, std::vector<bool>& in)
{
    const inspect::curve_chords chords{stroke, 1.0, 1e-3};
    in.clear();
    double most = 0.0;
    for (const point p : places) {
        const auto w = chords.winding(p);
        in.push_back(w != 0);
        most = std::fmax(most, w);  // contours wind clockwise
    }
    return most;
}
std::vector<point> around(const std::vector<point>& some, double reach, unsigned seed, int count)
{
    std::mt19937 d{seed};
    const auto fraction = [&] { return static_cast<double>(d() % 1'000'003) / 1'000'003.0; };
    std::vector<point> all;
    for (int i = 0; i < count; ++i) {
        const point p = some[d() % some.size()];
        const double angle = 6.2831853 * fraction(), r = reach * fraction();
        all.push_back(p + r * point{std::cos(angle), std::sin(angle)});
    }
    return all;
}

/// One open path, there and back; without a move it ends in another mistake.
struct there_and_back {
    std::uint32_t lines = 0;
    bool headless = false;

    [[nodiscard]] double units_per_em() const noexcept { return 1000.0; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }
    template <outline_sink Sink>
    error outline(glyph_id, Sink& sink) const noexcept
    {
        if (!headless) sink.move({0.0, 0.0});
        for (std::uint32_t i = 1; i <= lines; ++i) sink.line({static_cast<double>(i % 2), 0.0});
        if (headless) sink.line({std::nan(""), 0.0});  // the second error
        return {};
    }
};

}  // namespace

TEST_CASE("a round stroke is what is near the path, however tightly that turns", "[outline][stroke]")
{
    const char* paths[] = {
        "M10 10L90 20L30 80L30 20",
        "M20 20C120 80 -20 80 80 20",
        "M50 50C51 49 53 50 52 52S48 53 49 49S55 46 56 54",  // radii far below the width
        "M20 50Q50 -40 80 50T80 90",
        "M10 50C60 50 40 50 90 50.5",
        "M10 50C90 50 10 50 60 50",  // turns back on itself
        "M50 20Q50 80 50 20",        // and without area
        "M50 50a20 20 0 1 1 0.1 0z",
        "M30 30h40v40h-40z",
        "M20 80C20 20 20 20 80 20",
        "M10 10C10 10 50 60 90 10",  // a handle of no length
        "M10 90C90 10 90 90 10 10",
        "M20 20C80 80 20 80 80 20z",  // a cusp, nearly
        "M50 50m-30 0A30 10 30 1 0 80 50",
    };
    int looked = 0;
    for (const char* data : paths)
        for (const double width : {0.5, 6.0, 25.0})
            for (const double tolerance : {0.5, 0.02}) {
                if (tolerance > 0.2 * width) continue;
                const outline stroke =
                    stroke_of(data, {width / 100.0, stroke_cap::round, stroke_join::round}, tolerance);
                svg_path source{data, 100.0};
                outline path;
                struct open_path {  // the path itself, not closed
                    std::vector<curve> all;
                    point at;
                    point start;
                    void move(point p) noexcept { at = start = p; }
                    void line(point p) noexcept { all.push_back(curve::from(at, p)), at = p; }
                    void quadratic(point c, point p) noexcept { all.push_back(curve::from(quadratic_(c, p))), at = p; }
                    void cubic(point a, point b, point p) noexcept
                    {
                        all.push_back(curve::from(typemesh::cubic{at, a, b, p})), at = p;
                    }
                    void close() noexcept { line(start); }
                    typemesh::quadratic quadratic_(point c, point p) const { return {at, c, p}; }
                } own;
                REQUIRE(source.outline(0, own) == error::none);
                for (const curve& c : own.all) REQUIRE(path.curves.push_back(c));
                const inspect::curve_chords chords{path, 1.0, 1e-4};
                std::vector<point> on;
                for (const curve& c : own.all)
                    for (int k = 0; k <= 20; ++k) on.push_back(c.at(k / 20.0));
                const auto places = around(on, 0.8 * width, 17, 600);
                std::vector<bool> in;
                const double most = covered(stroke, places, in);
                INFO(data << ", width " << width << ", tolerance " << tolerance);
                CHECK(most <= 0.0);
                std::size_t wrong = 0;
                for (std::size_t i = 0; i < places.size(); ++i) {
                    const double away =
                        std::sqrt(inspect::curve_chords::squared_distance(places[i], chords.all())) - 0.5 * width;
                    if (std::fabs(away) <= tolerance + 1e-3) continue;
                    ++looked;
                    if (in[i] == (away < 0.0)) continue;
                    if (wrong++ == 0) UNSCOPED_INFO(places[i].x << ", " << places[i].y << ": " << away);
                }
                CHECK(wrong == 0);
            }
    CHECK(looked > 20000);
}

TEST_CASE("caps and joins have the areas of their shapes", "[outline][stroke]")
{
    const auto area = [](const char* data, stroke_cap cap, stroke_join join, double limit = 4.0) {
        const outline stroke = stroke_of(data, {0.1, cap, join, limit}, 1e-3);
        const inspect::curve_chords chords{stroke, 1.0, 1e-3};
        double inside = 0.0;  // by counting: contours overlap
        constexpr int n = 400;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k)
                if (chords.winding({(i + 0.5) * 100.0 / n, (k + 0.5) * 100.0 / n}) != 0) inside += 1e4 / (n * n);
        return inside;
    };
    const double disc = 78.5398;  // of radius 5
    CHECK(area("M20 50H80", stroke_cap::butt, stroke_join::mitre) == Approx(600.0).epsilon(3e-3));
    CHECK(area("M20 50H80", stroke_cap::square, stroke_join::mitre) == Approx(700.0).epsilon(3e-3));
    CHECK(area("M20 50H80", stroke_cap::round, stroke_join::mitre) == Approx(600.0 + disc).epsilon(3e-3));
    // A right angle: two strokes of 60, whose common quarter is counted once.
    CHECK(area("M20 20H80V80", stroke_cap::butt, stroke_join::bevel) == Approx(1200.0 - 25 + 12.5).epsilon(3e-3));
    CHECK(area("M20 20H80V80", stroke_cap::butt, stroke_join::mitre) == Approx(1200.0).epsilon(3e-3));
    CHECK(area("M20 20H80V80", stroke_cap::butt, stroke_join::mitre, 1.4) == Approx(1187.5).epsilon(3e-3));
    CHECK(area("M20 20H80V80", stroke_cap::butt, stroke_join::round) ==
          Approx(1200.0 - 25 + 0.25 * disc).epsilon(3e-3));
    CHECK(area("M20 20H80V80H20z", stroke_cap::round, stroke_join::mitre) == Approx(2400.0).epsilon(3e-3));
    CHECK(area("M50 50h0", stroke_cap::round, stroke_join::mitre) == Approx(disc).epsilon(1e-2));
    CHECK(area("M50 50z", stroke_cap::square, stroke_join::mitre) == Approx(100.0).epsilon(1e-2));
    CHECK(area("M50 50h0", stroke_cap::butt, stroke_join::mitre) < 1e-9);
}

TEST_CASE("dashes and gaps lie along the path as their lengths say", "[outline][stroke]")
{
    const auto lit = [](const char* data, std::initializer_list<double> dashes, double offset, stroke_cap cap,
                        point p) {
        const std::vector<double> lengths(dashes);
        stroke_style style{0.04, cap};
        style.dashes = lengths;
        style.dash_offset = offset;
        std::vector<bool> in;
        (void)covered(stroke_of(data, style, 1e-3), {p}, in);
        return bool(in[0]);
    };
    // Along a line of 80 with a corner, dashes of 10, gaps of 5.
    for (int k = 0; k < 160; ++k) {
        const double s = k / 2.0 + 0.25;
        const point p = s < 40.0 ? point{20.0 + s, 60.0} : point{60.0, 60.0 + 40.0 - s};
        for (const double offset : {0.0, 0.07, -0.04, 3.13}) {
            double phase = std::fmod(s + 100.0 * offset, 15.0);
            if (phase < 0.0) phase += 15.0;
            INFO(s << " " << offset);
            CHECK(lit("M20 40h40v40", {0.1, 0.05}, offset, stroke_cap::butt, p) == (phase < 10.0));
        }
    }
    // A gap that ends at a corner: the dash after it begins with the next line.
    for (const char* const path : {"M20 40h20v20", "M20 40h20v20h-20z"}) {
        CHECK(lit(path, {0.1, 0.1}, 0.0, stroke_cap::butt, {25.0, 60.0}));
        CHECK_FALSE(lit(path, {0.1, 0.1}, 0.0, stroke_cap::butt, {35.0, 60.0}));
        CHECK(lit(path, {0.1, 0.1}, 0.0, stroke_cap::butt, {40.0, 55.0}));
        CHECK_FALSE(lit(path, {0.1, 0.1}, 0.0, stroke_cap::butt, {40.0, 45.0}));
    }
    // Along a circle, measured by the angle.
    const double radius = 30.0, around = 2.0 * 3.14159265358979 * radius;
    for (int k = 0; k < 90; ++k) {
        const double s = (k + 0.5) * around / 90.0, angle = s / radius;
        const point p{50.0 + radius * std::cos(angle), 50.0 - radius * std::sin(angle)};
        const double phase = std::fmod(s, 21.0);  // 7 on, 7 off, 7 on, and the other way round
        if (std::fabs(std::remainder(phase, 7.0)) < 0.05) continue;
        const bool on = std::fmod(s, 42.0) < 7.0 || (std::fmod(s, 42.0) > 14.0 && std::fmod(s, 42.0) < 21.0) ||
                        (std::fmod(s, 42.0) > 28.0 && std::fmod(s, 42.0) < 35.0);
        INFO(s);
        CHECK(lit("M80 50A30 30 0 1 1 20 50A30 30 0 1 1 80 50z", {0.07}, 0.0, stroke_cap::butt, p) == on);
    }
    // Dashes of no length are dots, if their caps are.
    CHECK(lit("M20 50h40", {0.0, 0.2}, 0.0, stroke_cap::round, {41.0, 51.0}));
    CHECK_FALSE(lit("M20 50h40", {0.0, 0.2}, 0.0, stroke_cap::round, {45.0, 50.0}));
    CHECK_FALSE(lit("M20 50h40", {0.0, 0.2}, 0.0, stroke_cap::butt, {40.0, 50.0}));
    CHECK(lit("M20 50h40", {0.0, 0.0}, 0.0, stroke_cap::butt, {40.0, 50.0}));
}

TEST_CASE("strokes refuse options, and what their source refuses", "[outline][stroke]")
{
    svg_path path{"M4 12l5 5L20 6", 24.0};
    outline out;
    const auto refused = [&](const stroke_style& style, double tolerance = 1e-4) {
        stroked_outlines lines{path, style, tolerance};
        const error e = record(lines, 0, out).error();
        CHECK(e == error::bad_option);
        return std::string{e.option};
    };
    CHECK(refused({.width = 0.0}) == "width");
    CHECK(refused({.width = std::nan("")}) == "width");
    CHECK(refused({.mitre_limit = 0.5}) == "mitre_limit");
    CHECK(refused({}, 0.0) == "tolerance");
    const double negative[] = {0.1, -0.1}, tiny[] = {1e-9};
    CHECK(refused({.dashes = negative}) == "dashes");
    CHECK(refused({.dashes = tiny}) == "dashes");
    CHECK(refused({.dash_offset = std::nan("")}) == "dash_offset");
    stroked_outlines lines{path};
    CHECK(record(lines, 5, out) == error::unknown_glyph);
    path.data = "M1 1L2";
    CHECK(record(lines, 0, out) == error::bad_path);
    path.data = "M1 1L1e308 2e308 -1e308 -1e308";
    CHECK_FALSE(record(lines, 0, out).has_value());
    path.data = "M1 1C1e150 2e150 -1e150 1e150 3 3";
    CHECK(record(lines, 0, out) == error::outline_beyond_grid);
    path.data = "M1 1L5 5L8 1Q3 3 9 9";
    test::counting_memory none{.fail_at = 1}, counted;
    stroked_outlines poor{path, {}, 1e-4, none.source()};
    CHECK(record(poor, 0, out) == error::out_of_memory);
    stroked_outlines warm{path, {}, 1e-4, counted.source()};
    REQUIRE(record(warm, 0, out));
    const std::size_t before = counted.requests;
    REQUIRE(record(warm, 0, out));
    CHECK(counted.requests == before);
}

TEST_CASE("strokes keep the first error of a drawing, and refuse a path of too many curves", "[outline][stroke]")
{
    outline out;
    there_and_back headless{1, true}, longest{decltype(stroked_outlines{headless})::max_curves + 1};
    stroked_outlines lines{headless};
    CHECK(record(lines, 0, out) == error::bad_outline);
    test::counting_memory counted;
    stroked_outlines bounded{longest, {}, 1e-4, counted.source()};
    const auto refused = record(bounded, 0, out);
    REQUIRE(refused == error::too_many_points);
    CHECK(refused.error().count == bounded.max_curves);
}

TEST_CASE("each option of a stroke and each state of its source has a key of its own, so no cache confuses them",
          "[outline][stroke]")
{
    svg_path tick{"M4 12l5 5L20 6"}, other{"M4 12l5 5L20 7"};
    const double pattern[] = {0.1, 0.05}, longer[] = {0.1, 0.06};
    std::vector<std::uint64_t> keys;
    const auto add = [&](svg_path& path, const stroke_style& style, double tolerance) {
        keys.push_back(stroked_outlines{path, style, tolerance}.variation_key());
    };
    const stroke_style plain;
    stroke_style wide = plain, round = plain, joined = plain, sharp = plain, moved = plain, dashed = plain,
                 spread = plain;
    wide.width = 0.06;
    round.cap = stroke_cap::round;
    joined.join = stroke_join::round;
    sharp.mitre_limit = 5.0;
    moved.dash_offset = 0.1;
    dashed.dashes = pattern;
    spread.dashes = longer;
    for (const stroke_style& style : {plain, wide, round, joined, sharp, moved, dashed, spread}) add(tick, style, 1e-4);
    add(tick, plain, 1e-3);
    add(other, plain, 1e-4);
    for (std::size_t i = 0; i < keys.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK(keys[i] != keys[k]);
    add(tick, plain, 1e-4);
    CHECK(keys.back() == keys.front());
}

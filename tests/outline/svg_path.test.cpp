// SPDX-License-Identifier: MIT

// Paths that are drawn at random and printed in every way that SVG allows are read as they were drawn; arcs follow their
// ellipses; what is wrong is refused at its place.

#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/svg_path.hpp>

#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "outline/same_curves.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

constexpr double pi = 3.14159265358979323846;

/// The calls of a sink, word for word.
struct written {
    std::string calls;

    void put(const char* name, std::initializer_list<point> points)
    {
        calls += name;
        for (const point p : points) {
            char text[64];
            const auto seen = [](double v) { return std::fabs(v) < 1e-11 ? 0.0 : v; };  // sines are not exact
            std::snprintf(text, sizeof text, " %.10g,%.10g", seen(p.x), seen(p.y));
            calls += text;
        }
        calls += ' ';
    }
    void move(point p) noexcept { put("m", {p}); }
    void line(point p) noexcept { put("l", {p}); }
    void quadratic(point c, point p) noexcept { put("q", {c, p}); }
    void cubic(point c1, point c2, point p) noexcept { put("c", {c1, c2, p}); }
    void close() noexcept { put("z", {}); }
};

std::string calls_of(const char* data)
{
    written all;
    const auto done = draw_svg_path(data, 1e-3, all);
    CHECK(done);
    return all.calls;
}

/// Draws at random, and prints what it draws: coordinates are multiples of 1/8, so everything is exact.
class random_path {
public:
    std::string text;
    outline drawn;

    explicit random_path(unsigned seed) : d_{seed}, to_{drawn}
    {
        for (int n = 1 + roll(3); n > 0; --n) subpath();
        REQUIRE(to_.finish() == error::none);
    }

private:
    int roll(int n) { return static_cast<int>(d_() % static_cast<unsigned>(n)); }
    point anywhere() { return {(roll(1600) - 800) / 8.0, (roll(1600) - 800) / 8.0}; }

    /// A command, or nothing if it may be left out.
    void command(char upper)
    {
        relative_ = roll(2) != 0;
        const char c = static_cast<char>(relative_ ? upper - 'A' + 'a' : upper);
        const char implied = last_ == 'M' ? 'L' : last_ == 'm' ? 'l' : last_;
        implicit_ = c == implied && c != 'z' && c != 'Z' && upper != 'M' && roll(3) != 0;
        if (!implicit_) {
            spaces();
            text += c;
            spaces();
            number_ends_ = point_seen_ = false;
        }
        last_ = c;
    }
    void spaces()
    {
        for (int n = roll(4) - 2; n > 0; --n) text += " \t\n\f\r"[roll(5)];
    }
    void number(double value)
    {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.17g", value);
        std::string s = digits;
        const auto dot = s.find('.');
        if (roll(3) == 0 && dot != std::string::npos && s[dot - 1] == '0' && (dot == 1 || s[dot - 2] == '-'))
            s.erase(dot - 1, 1);  // .5, -.5
        if (roll(6) == 0) {
            std::snprintf(digits, sizeof digits, "%.17ge%s2", value * 100.0, "-");
            s = digits;
        }
        if (roll(8) == 0 && s[0] != '-') s = "+" + s;
        if (roll(8) == 0 && s.find('.') != std::string::npos && s.find('e') == std::string::npos) s += "000";
        const bool free = s[0] == '-' || s[0] == '+' || (s[0] == '.' && point_seen_);
        if (number_ends_ && !(free && roll(2) != 0)) {
            const int kind = roll(3);
            if (kind == 0)
                text += ' ';
            else if (kind == 1)
                text += ',';
            else
                spaces(), text += ',', spaces();
        }
        text += s;
        number_ends_ = true;
        point_seen_ = s.find('.') != std::string::npos || s.find('e') != std::string::npos;
    }
    void numbers(point p)
    {
        number(relative_ ? p.x - at_.x : p.x);
        number(relative_ ? p.y - at_.y : p.y);
    }
    void subpath()
    {
        if (last_ != 'z' && last_ != 'Z')
            start_ = anywhere(), command('M'), numbers(start_), at_ = start_;
        else if (roll(2) != 0)
            command('M'), start_ = anywhere(), numbers(start_);
        at_ = start_;
        to_.move(at_);
        point control = at_;
        char kind = 'M';
        for (int n = roll(6); n > 0; --n) {
            const point a = anywhere(), b = anywhere(), p = anywhere();
            const point mirrored = at_ + (at_ - control);
            switch (roll(7)) {
            case 0: command('L'), numbers(p), go(p), kind = 'L'; break;
            case 1: command('H'), number(relative_ ? p.x - at_.x : p.x), go({p.x, at_.y}), kind = 'H'; break;
            case 2: command('V'), number(relative_ ? p.y - at_.y : p.y), go({at_.x, p.y}), kind = 'V'; break;
            case 3:
                command('C'), numbers(a), numbers(b), numbers(p);
                to_.cubic(a, b, p), at_ = p, control = b, kind = 'C';
                break;
            case 4:
                command('S'), numbers(b), numbers(p);
                to_.cubic(kind == 'C' ? mirrored : at_, b, p), at_ = p, control = b, kind = 'C';
                break;
            case 5: command('Q'), numbers(a), numbers(p), to_.quadratic(a, p), at_ = p, control = a, kind = 'Q'; break;
            default: {
                const point c = kind == 'Q' ? mirrored : at_;
                command('T'), numbers(p), to_.quadratic(c, p), at_ = p, control = c, kind = 'Q';
            }
            }
        }
        if (roll(3) != 0) command('Z'), to_.close(), at_ = start_;
        spaces();
    }
    void go(point p) { to_.line(p), at_ = p; }

    std::mt19937 d_;
    outline_recorder to_;
    point at_, start_;
    char last_ = '\0';
    bool relative_ = false, implicit_ = false, number_ends_ = false, point_seen_ = false;
};

}  // namespace

TEST_CASE("a path is read as it was drawn, in whichever way it is printed", "[outline][svg]")
{
    for (unsigned seed = 0; seed < 4000; ++seed) {
        const random_path path{seed};
        outline read;
        outline_recorder to{read};
        const auto done = draw_svg_path(path.text, 1e-3, to);
        INFO(seed << ": " << path.text);
        CHECK_QUICKLY(done);
        CHECK_QUICKLY(to.finish() == error::none);
        CHECK_QUICKLY(test::same_curves(read, path.drawn));
    }
}

TEST_CASE("numbers of path data need no separators", "[outline][svg]")
{
    CHECK(calls_of("M1.5.5-2-3+4+5") == "m 1.5,0.5 l -2,-3 l 4,5 ");
    CHECK(calls_of("m.5.5.5.5") == "m 0.5,0.5 l 1,1 ");
    CHECK(calls_of("M1e2-1E-1") == "m 100,-0.1 ");
    CHECK(calls_of("M-.5e+1,1.") == "m -5,1 ");
    CHECK(calls_of("M 0 0,10,10, 20 , 20") == "m 0,0 l 10,10 l 20,20 ");
    CHECK(calls_of("M0 0a1 1 0 01.5.5") == calls_of("M0 0a1,1,0,0,1,.5,.5"));
    CHECK(calls_of("M0 0a1 1 0 1110-2 1 1 0 0 0 1 1") == calls_of("M0 0A1 1 0 1 1 10-2A1 1 0 0 0 11-1"));
    CHECK(calls_of("M1 1zm1 1zL5 5") == "m 1,1 z m 2,2 z m 2,2 l 5,5 ");
    CHECK(calls_of("M1 1ZZ") == "m 1,1 z ");
    CHECK(calls_of(" \n\t ").empty());
    CHECK(calls_of("M3.0000000000000000000000000000000000000001 12345678901234567890123e-20") == "m 3,123.456789 ");
    CHECK(calls_of("M1e-999999999999 0e999999999999") == "m 0,0 ");
}

TEST_CASE("numbers of path data are as exact as the compiler's", "[outline][svg]")
{
    std::mt19937_64 d{7};
    for (int i = 0; i < 20000; ++i) {
        char text[64];
        const double value = std::ldexp(static_cast<double>(d() % 100'000'000), -static_cast<int>(d() % 30));
        std::snprintf(text, sizeof text, i % 2 == 0 ? "%.6f" : "%.15g", value);
        const double wanted = std::strtod(text, nullptr);
        detail::path_numbers in{text};
        double read = -1.0;
        CHECK_QUICKLY(in.read(read));
        CHECK_QUICKLY(in.at_end());
        CHECK_QUICKLY(std::fabs(read - wanted) <= 0x1p-52 * wanted);
    }
}

TEST_CASE("an arc's cubics are no farther from its ellipse than the tolerance", "[outline][svg]")
{
    std::mt19937 d{11};
    const auto from = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(d() % 100'001) / 100'000.0;
    };
    for (int i = 0; i < 3000; ++i) {
        // The ellipse's own form: the ends are computed from the angles, and must give the angles again.
        const double rx = from(0.5, 50.0), ry = from(0.5, 50.0), turn = from(-400.0, 400.0), begin = from(0.0, 6.28);
        const double sweep = (d() % 2 != 0 ? 1.0 : -1.0) * from(0.05, 6.2);
        if (std::fabs(std::fabs(sweep) - pi) < 0.01) continue;  // either of two arcs
        const point centre{from(-20.0, 20.0), from(-20.0, 20.0)};
        const double c = std::cos(turn * pi / 180.0), s = std::sin(turn * pi / 180.0);
        const auto place = [&](double a) {
            const double x = rx * std::cos(a), y = ry * std::sin(a);
            return centre + point{c * x - s * y, s * x + c * y};
        };
        const point first = place(begin), last = place(begin + sweep);
        char text[400];
        std::snprintf(text, sizeof text, "M%.17g,%.17gA%.17g %.17g %.17g %d%d%.17g,%.17g", first.x, first.y, rx, -ry,
                      turn, std::fabs(sweep) > pi ? 1 : 0, sweep > 0.0 ? 1 : 0, last.x, last.y);
        outline drawn;
        outline_recorder to{drawn};
        const double tolerance = std::pow(10.0, -from(1.0, 6.0));
        REQUIRE(draw_svg_path(text, tolerance, to));
        REQUIRE(to.finish() == error::none);
        double angle = 0.0;  // how far the cubics go around
        point before{};
        bool within = true;
        for (const curve& q : drawn.curves) {
            if (q.degree != 3) continue;  // closes the contour
            for (int k = 0; k <= 16; ++k) {
                const point p = q.at(k / 16.0) - centre;
                const point unit{(c * p.x + s * p.y) / rx, (c * p.y - s * p.x) / ry};
                within = within && std::fabs(length(unit) - 1.0) * std::fmax(rx, ry) <= tolerance + 1e-7;
                if (!(before == point{})) angle += std::atan2(cross(before, unit), dot(before, unit));
                before = unit;
            }
        }
        INFO(text);
        CHECK_QUICKLY(within);
        CHECK_QUICKLY(std::fabs(angle - sweep) < 1e-5);
    }
}

TEST_CASE("degenerate arcs are lines, or larger, or nothing, as SVG says", "[outline][svg]")
{
    CHECK(calls_of("M1 2A0 5 0 0 1 7 8") == "m 1,2 l 7,8 ");
    CHECK(calls_of("M1 2A5 0 0 1 0 7 8") == "m 1,2 l 7,8 ");
    CHECK(calls_of("M1 2A5 5 0 1 0 1 2L3 3") == "m 1,2 l 3,3 ");
    // Radii that are too small: half a circle over the chord, whichever the flags.
    CHECK(calls_of("M0 0A1 1 30 0 1 10 0") == calls_of("M0 0A5 5 30 1 1 10 0"));
    CHECK(calls_of("M0 0A-5 -5 0 0 1 10 0") == calls_of("M0 0A5 5 0 0 1 10 0"));
    outline half;
    outline_recorder to{half};
    REQUIRE(draw_svg_path("M0 0A1 1 0 0 1 10 0", 1e-4, to));
    REQUIRE(to.finish() == error::none);
    CHECK(half.curves[0].p[0] == point{0.0, 0.0});
    CHECK(half.bounds.low.y == Approx(-5.0).margin(0.3));  // y grows downwards: clockwise is positive
    CHECK(half.bounds.high.y == Approx(0.0).margin(1e-9));
}

TEST_CASE("a mistake in path data is refused at its place, and what stands before it is drawn", "[outline][svg]")
{
    const struct {
        const char* data;
        std::uint64_t place;  // 1: the first byte
        const char* drawn;
    } wrong[] = {
        {"L1 1", 1, ""},
        {"z", 1, ""},
        {"M", 2, ""},
        {"M1", 3, ""},
        {"M1 ", 4, ""},
        {"M,1 1", 2, ""},
        {"M1 1,", 6, "m 1,1 "},
        {"M1 1,L2 2", 6, "m 1,1 "},
        {"M1 1L2 2 3", 11, "m 1,1 l 2,2 "},
        {"M1 1L2 2X", 9, "m 1,1 l 2,2 "},
        {"M1 1 L2 2 e", 11, "m 1,1 l 2,2 "},
        {"M1 1L 2 2LL3 3", 11, "m 1,1 l 2,2 "},
        {"M1 1L2 -", 9, "m 1,1 "},
        {"M1 1L2 .", 8, "m 1,1 "},
        {"M1 1L2 1e", 10, "m 1,1 "},
        {"M1 1L2 1ex", 10, "m 1,1 "},
        {"M1 1L1e309 2", 6, "m 1,1 "},
        {"M1 1a1 1 0 2 0 5 5", 12, "m 1,1 "},
        {"M1 1a1 1 0 00 5", 16, "m 1,1 "},
        {"M1 1z5 5", 6, "m 1,1 z "},
        {"M1,,1", 4, ""},
        {"M1;1", 3, ""},
        {"M1 1H\xC3", 6, "m 1,1 "},
    };
    for (const auto& w : wrong) {
        written all;
        const auto done = draw_svg_path(w.data, 1e-3, all);
        INFO(w.data);
        CHECK(done == error::bad_path);
        CHECK(done.error().count == w.place);
        CHECK(done.error().option != nullptr);
        CHECK(all.calls == w.drawn);
        char words[200];
        INFO(describe(done.error(), words));
        CHECK(std::string{words}.find("(byte " + std::to_string(w.place) + ": ") != std::string::npos);

        written refusing, lenient;
        svg_path source{w.data, 10.0};
        CHECK(source.outline(0, refusing) == error::bad_path);
        source.mistakes = path_mistakes::draw_up_to_it;
        CHECK(source.outline(0, lenient) == error::none);
    }
}

TEST_CASE("path data with a zero byte is refused there", "[outline][svg]")
{
    ignore_outline nowhere;
    const std::string_view zero{"M1 1\0L2 2", 9};
    CHECK(draw_svg_path(zero, 1e-3, nowhere).error().count == 5);
    CHECK(draw_svg_path("M1 1", 0.0, nowhere) == error::bad_tolerance);
    CHECK(draw_svg_path("M1 1", std::nan(""), nowhere) == error::bad_tolerance);
}

TEST_CASE("a path is a font with one glyph, upright on its baseline", "[outline][svg]")
{
    svg_path square{"M4 4h16v16H4z", 24.0};
    outline drawn;
    REQUIRE(record(square, 0, drawn));
    CHECK(drawn.bounds.low == point{4.0, 4.0});
    CHECK(drawn.bounds.high == point{20.0, 20.0});
    CHECK(record(square, 1, drawn) == error::unknown_glyph);
    square.size = -1.0;
    CHECK(record(square, 0, drawn) == error::bad_option);
    square.size = 24.0;
    square.tolerance = 0.0;
    CHECK(record(square, 0, drawn) == error::bad_option);

    svg_path triangle{"M0 20L20 20L0 0z", 20.0};
    REQUIRE(record(triangle, 0, drawn));
    CHECK(drawn.curves[1].p[1] == point{0.0, 20.0});  // the top

    const svg_path other{"M0 20L20 20L1 0z", 20.0};
    svg_path even = triangle;
    even.rule = fill_rule::even_odd;
    CHECK(triangle.variation_key() != other.variation_key());
    CHECK(triangle.variation_key() != even.variation_key());
    CHECK(triangle.variation_key() == svg_path{"M0 20L20 20L0 0z", 20.0}.variation_key());
}

TEST_CASE("no last bits of the system's sine reach the cubics of an arc", "[outline][svg]")
{
    for (double degrees = 1.0; degrees < 360.0; degrees += 7.3) {
        const auto arc = detail::elliptical_arc::between({1.25, 2.5}, {30.0, 17.0}, {40.0, 22.0}, degrees,
                                                         degrees > 180.0, degrees < 90.0);
        CHECK(detail::steady(arc.start) == arc.start);
        detail::elliptical_arc unit;
        unit.radius = 1.0;
        unit.start = arc.start;
        unit.sweep = arc.sweep;
        const point at = unit.at(degrees);
        CHECK(detail::steady(at.x) == at.x);
        CHECK(detail::steady(at.y) == at.y);
    }
    // A chord that is tiny beside its radius has a tiny arc, or nearly a whole turn.
    for (const bool large : {false, true}) {
        const auto arc = detail::elliptical_arc::between({0.0, 0.0}, {1e-13, 0.0}, {1.0, 1.0}, 0.0, large, true);
        CHECK(arc.sweep == Approx(large ? 2.0 * detail::half_turn : 1e-13).epsilon(1e-9));
    }
}

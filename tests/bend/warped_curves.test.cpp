// SPDX-License-Identifier: MIT

// The curves of warped outlines: how far they are from the ideal image, how many they are, and what is mapped exactly.

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/arch.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/core/affine.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

/// An affine map as a warp, in em.
struct affine_warp {
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;

    [[nodiscard]] error refused_options() const noexcept { return {}; }
    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        return {{xx * p.x + xy * p.y, yx * p.x + yy * p.y}, {xx, yx}, {xy, yy}};
    }
    [[nodiscard]] bend_bounds bend(const box&) const noexcept { return {}; }
};

outline glyph_of(std::uint32_t id)
{
    test::toy_font font;
    outline drawn;
    REQUIRE(record(font, id, drawn));
    return drawn;
}

/// A hook with cusps, a loop, an inflection and a curve of length zero at its end.
outline nasty_glyph()
{
    outline drawn;
    outline_recorder pen{drawn};
    pen.move({0, 0});
    pen.cubic({0, 0}, {700, 100}, {700, 600});
    pen.cubic({-300, 900}, {1300, 900}, {300, 600});
    pen.quadratic({900, 300}, {300, 600});
    pen.cubic({300, 200}, {100, 800}, {100, 300});
    pen.line({100, 299});
    pen.line({-4000, 150});
    pen.close();
    REQUIRE_FALSE(pen.finish());
    return drawn;
}

outline turned(const outline& drawn, const affine& map)
{
    outline out;
    for (curve c : drawn.curves) {
        for (point& p : c.p) p = map(p);
        for (std::uint32_t i = 0; i <= c.degree; ++i) out.bounds.add(c.p[i]);
        REQUIRE(out.curves.push_back(c));
    }
    for (const std::uint32_t s : drawn.starts) REQUIRE(out.starts.push_back(s));
    return out;
}

const box wide{{-2.0, 0.0}, {4.0, 0.0}};  // of the text, in em

/// The distance of a point from a line, or from its ends.
double from_line(point p, const curve& line)
{
    const point v = line.end() - line.start();
    const double along = dot(p - line.start(), v) / dot(v, v);
    return length(p - line.at((std::max)(0.0, (std::min)(1.0, along))));
}

/// The greatest distance between an outline's ideal image and the curves of its warped one, over about so many samples,
/// by the parameters with which the warped pieces follow each other. Checks that the contours are closed bit for bit.
template <class W>
double farthest(const W& how, const outline& drawn, const drawn_place& at, double tolerance, std::size_t samples,
                std::size_t& pieces)
{
    outline out;
    const auto rest = warped<W>{how}(drawn, at, tolerance, 100'000, out);
    REQUIRE(rest);
    const W own = fitted_to(how, at.text);
    REQUIRE(out.starts.size() == drawn.starts.size());
    pieces = out.curves.size();
    const auto image = [&](point p) {
        return (own(at.em_per_unit * p + at.origin).at - at.origin) * (1.0 / at.em_per_unit);
    };
    for (std::uint32_t c = 0; c < out.contour_count(); ++c)
        for (std::uint32_t i = out.starts[c]; i < out.starts[c + 1]; ++i) {
            const std::uint32_t next = i + 1 == out.starts[c + 1] ? out.starts[c] : i + 1;
            CHECK(out.curves[i].end() == out.curves[next].start());
        }
    // Walk along the curves and their pieces.
    double worst = 0.0;
    std::uint32_t i = 0;
    for (const curve& c : drawn.curves) {
        const point end = image(c.end());
        double t = 0.0;
        for (bool last = false; !last; ++i) {
            REQUIRE(i < out.curves.size());
            const curve& piece = out.curves[i];
            last = piece.end() == end;
            double next = 1.0;
            if (!last) {  // parameters are binary fractions; where the curve crosses itself, the middle decides
                double least = 1e300;
                for (double size = 0.5; size > 1e-4; size *= 0.5) {
                    const double at_k = t + size;
                    if (at_k > 1.0 || length(image(c.at(at_k)) - piece.end()) > 1e-6) continue;
                    const double off = length(image(c.at(t + 0.5 * size)) - piece.at(0.5));
                    if (off < least) least = off, next = at_k;
                }
                REQUIRE(least < 1e300);
            }
            const auto here = static_cast<int>(static_cast<double>(samples) * (next - t) / 12.0) + 16;
            for (int k = 0; k <= here; ++k) {
                const double u = static_cast<double>(k) / here;
                const point ideal = image(c.at(t + (next - t) * u));
                const double off = piece.degree == 1 ? from_line(ideal, piece) : length(ideal - piece.at(u));
                worst = off > worst ? off : worst;
            }
            t = next;
        }
    }
    CHECK(i == out.curves.size());
    return worst * at.em_per_unit;
}

}  // namespace

TEST_CASE("cubics of a warped outline stay within a quarter of the tolerance, at 10^5 places", "[bend][warp]")
{
    for (const double tolerance : {1.0 / 100, 1.0 / 800, 1.0 / 20'000}) {
        const auto check = [&](const auto& how) {
            for (const outline& glyph : {glyph_of(1), glyph_of(2), nasty_glyph()})
                for (const affine& turn : {affine{}, affine{0.6, -0.8, 0.8, 0.6}, affine{-1.0, 0.0, 0.0, 1.0}}) {
                    const outline drawn = turned(glyph, turn);
                    std::size_t pieces = 0;
                    const drawn_place at{{1.25, 0.1}, 1e-3, wide};
                    const double off = farthest(how, drawn, at, tolerance, 100'000, pieces);
                    CHECK(off <= 0.25 * tolerance + 1e-12);
                    CHECK(pieces >= drawn.curves.size());
                }
        };
        check(arc{.degrees = 40});
        check(arch{.rise = 0.1, .baseline = 0.2, .top = 3.0});
        check(flag{.height = 0.3, .phase = 20});
        check(perspective{.scale = 0.9});
    }
}

TEST_CASE("affine warps map curves of every degree exactly and leave the whole tolerance", "[bend][warp]")
{
    const outline drawn = nasty_glyph();
    const drawn_place at{{0.5, 0.25}, 1e-3, wide};
    outline out;
    const auto rest = warped{affine_warp{0.8, 0.3, -0.1, 1.2}}(drawn, at, 0.01, 1000, out);
    REQUIRE(rest);
    CHECK(*rest == 0.01);
    REQUIRE(out.curves.size() == drawn.curves.size());
    for (std::size_t i = 0; i < out.curves.size(); ++i) {
        REQUIRE(out.curves[i].degree == drawn.curves[i].degree);
        for (std::uint32_t k = 0; k <= out.curves[i].degree; ++k) {
            const point p = 1e-3 * drawn.curves[i].p[k] + at.origin,
                        q = (point{0.8 * p.x + 0.3 * p.y, -0.1 * p.x + 1.2 * p.y} - at.origin) * 1000.0;
            CHECK(length(q - out.curves[i].p[k]) < 1e-9);
            CHECK(out.bounds.low.x <= q.x + 1e-9);
            CHECK(out.bounds.high.y >= q.y - 1e-9);
        }
    }
    const auto bent_rest = warped{arc{.degrees = 40}}(drawn, at, 0.01, 1000, out);
    REQUIRE(bent_rest);
    CHECK(*bent_rest == 0.0075);
}

TEST_CASE("lines that a warp keeps straight stay one line each", "[bend][warp]")
{
    const outline drawn = glyph_of(2);
    const drawn_place at{{0.5, 0.0}, 1e-3, wide};
    outline out;
    REQUIRE(warped{perspective{.scale = 0.3}}(drawn, at, 1e-5, 1000, out));
    CHECK(out.curves.size() == drawn.curves.size());
    for (const curve& c : out.curves) CHECK(c.degree == 1);

    // An E on an arc has 6 stems, which point to the centre.
    REQUIRE(warped{arc{.degrees = 200}}(drawn, at, 1.0 / 800, 1000, out));
    std::size_t lines = 0;
    for (const curve& c : out.curves) lines += c.degree == 1 ? 1 : 0;
    CHECK(lines == 6);
    CHECK(out.curves.size() == drawn.curves.size());
}

TEST_CASE("a circle on an arc needs few cubics", "[bend][warp]")
{
    const outline drawn = glyph_of(1);
    outline out;
    REQUIRE(warped{arc{.degrees = 120}}(drawn, {{0.5, 0.0}, 1e-3, wide}, 1.0 / 800, 1000, out));
    CHECK(out.curves.size() <= 2 * drawn.curves.size());
    // The error is of fourth order: 1/4096 of the tolerance needs 8 times as many.
    const std::size_t before = out.curves.size();
    REQUIRE(warped{arc{.degrees = 120}}(drawn, {{0.5, 0.0}, 1e-3, wide}, 1.0 / 800 / 4096, 1000, out));
    CHECK(out.curves.size() <= 8 * before);
    CHECK(out.curves.size() >= 4 * before);
}

TEST_CASE("a warp whose image is not a number is refused", "[bend][warp]")
{
    const outline drawn = nasty_glyph();
    const drawn_place at{{}, 1e-3, {{0, 0}, {1, 0}}};
    outline out;
    // The angle is infinite there, although the option is a number.
    const warped<flag> step{{.length = 2.0, .left = 1.7e308}};
    CHECK_FALSE(step.refused(at.text));
    CHECK(step(drawn, at, 1.0 / 800, 1000, out).error() == error::outline_not_finite);
    struct lost : affine_warp {
        [[nodiscard]] warped_point operator()(point p) const noexcept
        {
            return {{p.x > 0.3 ? std::sqrt(-1.0) : p.x, p.y}, {1.0, 0.0}, {0.0, 1.0}};
        }
    };
    CHECK(warped<lost>{}(drawn, at, 1.0 / 800, 1000, out).error() == error::outline_not_finite);
}

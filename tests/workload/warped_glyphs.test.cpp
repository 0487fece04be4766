// SPDX-License-Identifier: MIT

// Glyphs of the smoke fonts that a step warps before everything else.

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/flag.hpp>
#include <typemesh/bend/perspective.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/outline_step.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

const box text_of_warps{{-1.0, 0.0}, {4.0, 0.0}};
const point place_of_warps{1.25, 0.125};  // of the glyph

/// A glyph's ideal image, in cells, as short chords.
template <class W>
std::vector<std::vector<point>> image_of(const W& w, const outline& drawn, double units_per_em, double cells)
{
    std::vector<std::vector<point>> all;
    for (std::uint32_t c = 0; c < drawn.contour_count(); ++c) {
        auto& loop = all.emplace_back();
        for (std::uint32_t i = drawn.starts[c]; i < drawn.starts[c + 1]; ++i)
            for (int k = 0; k < 64; ++k) {
                const point p = drawn.curves[i].at(k / 64.0) * (1.0 / units_per_em) + place_of_warps;
                loop.push_back((w(p).at - place_of_warps) * (units_per_em * cells));
            }
    }
    return all;
}

double area_of(const std::vector<point>& loop)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
    return 0.5 * twice;
}

/// The distance from a point to a chain of chords that is searched within a window of the bounding boxes.
double distance_to(point p, const std::vector<std::vector<point>>& loops, double enough)
{
    double nearest = 1e300;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            nearest = (std::min)(
                nearest, inspect::curve_chords::squared_distance(p, loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]));
            if (nearest <= enough * enough) return std::sqrt(nearest);
        }
    return std::sqrt(nearest);
}

struct counts {
    std::size_t glyphs = 0, compared = 0, refused = 0;
};

template <class W>
void check_warped(const W& how, std::size_t step, counts& seen)
{
    constexpr double tolerance = 1.0 / 800;
    glyph_builder builder;
    const certified flatten;
    const monotone cut;
    const flat raise;
    no_observer nobody;
    const warped<W> warps{how};
    const policies with{flatten, cut, raise, nobody, {}, warps};
    const W own = fitted_to(how, text_of_warps);
    glyph_settings settings{.tolerance = tolerance};
    settings.text = text_of_warps;
    test::each_smoke_glyph(step, [&](auto& font, glyph_id g, const std::string& name) {
        INFO(name);
        const auto filled = builder.build_region(font, g, settings, with, with.warp, place_of_warps);
        ++seen.glyphs;
        if (!filled) {
            ++seen.refused;
            CHECK(filled.error() == error::folds_over);  // deeper than the centre of an arc
            return;
        }
        if (filled->points().empty()) return;
        outline drawn;
        REQUIRE(record(font, g, drawn));
        const double cells = filled->grid().cells, em = cells * font.units_per_em();
        const auto ideal = image_of(own, drawn, font.units_per_em(), cells);
        std::vector<std::vector<point>> made;
        double area = 0.0, area_of_ideal = 0.0, around = 0.0;
        for (std::uint32_t l = 0; l < filled->loop_count(); ++l) {
            auto& loop = made.emplace_back();
            for (std::uint32_t i = filled->starts()[l]; i < filled->starts()[l + 1]; ++i)
                loop.push_back(
                    {static_cast<double>(filled->points()[i].x), static_cast<double>(filled->points()[i].y)});
            area += area_of(loop);
            for (std::size_t i = 0; i < loop.size(); ++i) around += length(loop[i] - loop[(i + 1) % loop.size()]);
        }
        for (const auto& loop : ideal) area_of_ideal += area_of(loop);
        // Every point of the region lies near the image of the outline. The chords of the image are off by little.
        const double allowed = tolerance * em * 1.02 + 2.0;
        for (const auto& loop : made)
            for (const point p : loop) CHECK(distance_to(p, ideal, 0.9 * allowed) <= allowed);
        // Vice versa, where nothing overlaps or crosses, so that the whole of every curve is in the boundary.
        double used = 0.0;
        for (const auto& e : filled->edges()) used += std::fabs(static_cast<double>(e.t1) - static_cast<double>(e.t0));
        if (std::fabs(used - static_cast<double>(filled->curves().size())) > 1e-3) return;
        ++seen.compared;
        CHECK(std::fabs(std::fabs(area) - std::fabs(area_of_ideal)) <= 0.7 * around * tolerance * em + around);
        for (const auto& loop : ideal)
            for (std::size_t i = 0; i < loop.size(); i += 7)
                CHECK(distance_to(loop[i], made, 0.9 * allowed) <= allowed);
    });
}

}  // namespace

TEST_CASE("glyphs of the smoke fonts stay within the tolerance of their warped curves", "[workload]")
{
    const auto check = [](const auto& how, std::size_t step) {
        counts seen;
        check_warped(how, step, seen);
        CHECK(seen.glyphs > 30);
        CHECK(3 * seen.compared > seen.glyphs);
        CHECK(10 * seen.refused < seen.glyphs);
    };
    check(arc{.degrees = 100}, 1009);
    check(flag{.height = 0.2}, 997);
    check(perspective{.scale = 0.5}, 1013);
}

TEST_CASE("a builder asks for no memory when it warps a glyph again, and returns it all", "[workload]")
{
    test::counting_memory memory;
    {
        glyph_builder builder{memory.source()};
        test::each_smoke_glyph(40'009, [&](auto& font, glyph_id g, const std::string&) {
            const certified flatten;
            const monotone cut;
            no_observer nobody;
            const warped<arc> warps;
            const auto built = [&] {
                return builder.build_region(font, g, {.tolerance = quality::best}, cap_policies{flatten, cut, nobody},
                                            warps, {});
            };
            REQUIRE(built());
            const std::size_t warm = memory.requests;
            REQUIRE(built());
            CHECK(memory.requests == warm);
        });
        builder.trim();
        CHECK(memory.bytes_held == 0);
    }
}

// SPDX-License-Identifier: MIT

// Levels of detail of glyphs of all smoke fonts: laws of each level, and its count beside a fresh flattening.

#include "support/catch.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/inspect/curve_distance.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/inspect/simplicity.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// A copy of a region's boundary.
struct kept_level {
    std::vector<grid_point> points;
    std::vector<std::uint32_t> starts;
    std::uint32_t holes = 0, outers = 0;

    explicit kept_level(const region& r)
        : points(r.points().begin(), r.points().end()),
          starts(r.starts().begin(), r.starts().end()),
          holes{r.holes()},
          outers{r.outers()}
    {
    }
};

/// Whether each loop of the coarse level is a loop of the fine one without some of its points.
bool is_nested_in(const kept_level& coarse, const kept_level& fine)
{
    if (coarse.starts.size() != fine.starts.size()) return false;
    std::vector<std::vector<grid_point>> loops;
    for (std::size_t k = 0; k + 1 < fine.starts.size(); ++k)
        loops.emplace_back(fine.points.begin() + fine.starts[k], fine.points.begin() + fine.starts[k + 1]);
    for (std::size_t k = 0; k + 1 < coarse.starts.size(); ++k) {
        const std::vector<grid_point> some(coarse.points.begin() + coarse.starts[k],
                                           coarse.points.begin() + coarse.starts[k + 1]);
        const bool found = std::any_of(loops.begin(), loops.end(), [&](std::vector<grid_point>& all) {
            for (std::size_t turn = 0; turn < all.size(); ++turn, std::rotate(all.begin(), all.begin() + 1, all.end())) {
                if (!(all[0] == some[0])) continue;
                auto at = all.begin();
                for (const grid_point& p : some) {
                    at = std::find(at, all.end(), p);
                    if (at == all.end()) break;
                    ++at;
                    if (&p == &some.back()) return true;
                }
            }
            return false;
        });
        if (!found) return false;
    }
    return true;
}

/// The greatest distance of a place of a curve from the edge that stands for it, in cells.
double farthest_curve_place(const region& r)
{
    double farthest = 0.0;
    for (std::uint32_t l = 0; l < r.loop_count(); ++l)
        for (std::uint32_t i = r.starts()[l]; i < r.starts()[l + 1]; ++i) {
            const grid_point p = r.points()[i], q = r.points()[i + 1 < r.starts()[l + 1] ? i + 1 : r.starts()[l]];
            const contour_edge e = r.edges()[i];
            for (int k = 1; k < 8; ++k) {
                const point at = r.grid().cells * r.curves()[e.curve].at(e.t0 + k / 8.0 * (double{e.t1} - e.t0));
                farthest = std::max(farthest, inspect::curve_chords::squared_distance(
                                                  at, {double(p.x), double(p.y)}, {double(q.x), double(q.y)}));
            }
        }
    return std::sqrt(farthest);
}

}  // namespace

TEST_CASE("every smoke font's levels keep their tolerance, loops and points of the finer level", "[workload]")
{
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    glyph_builder builder, fresh_builder;
    cap_builder own, further;
    coarsened::scratch scratch;
    outline drawn;
    inspect::curve_chords chords;
    constexpr double finest = quality::high;
    coarsened how{.tolerances = {quality::normal, 1.0 / 60, 1.0 / 25}};
    std::size_t glyphs = 0, touching_glyphs = 0, points[4] = {}, fresh[4] = {};
    test::each_smoke_glyph(211, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        const auto filled = builder.build_region(font, glyph, {.tolerance = finest}, cap_policies{flatten, cut, nobody});
        if (!filled || filled->points().empty()) return;
        INFO(name);
        REQUIRE(record(font, glyph, drawn));
        const double em = filled->grid().cells * font.units_per_em();
        chords.take(drawn, filled->grid().cells, 0.002 * em / 800);
        kept_level finer{*filled};
        ++glyphs;
        touching_glyphs += filled->is_touching();
        for (how.level = 0; how.level <= 3; ++how.level) {
            INFO("level " << how.level);
            const double tolerance = how.level == 0 ? finest : how.tolerances[how.level - 1];
            scratch.clear();
            region_caps caps{own, further, cut, {}};
            const auto made = how(*filled, scratch, caps);
            REQUIRE(made);
            const region& r = made->filled;
            kept_level level{r};
            CHECK(level.holes == finer.holes);
            CHECK(level.outers == finer.outers);
            CHECK(is_nested_in(level, finer));
            if (how.level != 0) CHECK(made->triangles.size() == r.triangle_count());
            if (!r.is_touching()) {
                std::vector<inspect::loop> loops;
                for (std::uint32_t k = 0; k < r.loop_count(); ++k)
                    loops.emplace_back(r.points().subspan(r.starts()[k], r.starts()[k + 1] - r.starts()[k]));
                CHECK(inspect::is_region(loops));
            }
            const double allowed = 1.0001 * tolerance * em + 2.0;  // 2: crossings are rounded to the grid
            if (how.level != 0) CHECK(farthest_curve_place(r) <= allowed);
            CHECK(inspect::check_distance(r, chords, allowed).strays == 0);
            points[how.level] += r.points().size();
            const auto same = fresh_builder.build_region(font, glyph, {.tolerance = tolerance},
                                                         cap_policies{flatten, cut, nobody});
            REQUIRE(same);
            fresh[how.level] += same->points().size();
            finer = level;
        }
    });
    CAPTURE(glyphs, touching_glyphs, points[0], points[1], points[2], points[3], fresh[1], fresh[2], fresh[3]);
    CHECK(glyphs > 500);
    CHECK(touching_glyphs > 0);
    CHECK(points[0] == fresh[0]);
    for (int level = 1; level <= 3; ++level) CHECK(double(points[level]) < 1.1 * double(fresh[level]));
}

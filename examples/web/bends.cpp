// SPDX-License-Identifier: MIT
#include "bends.hpp"

#include <typemesh/bend/plane_path.hpp>
#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/box.hpp>

namespace typemesh_web {
namespace {

using namespace typemesh;

/// The box of a text's baselines, in em; columns have upright ones.
box baselines_of(const glyph_run& run)
{
    box all;
    const double em = run.units_per_em > 0.0 ? 1.0 / run.units_per_em : 1.0;
    for (const placed_glyph& glyph : run.glyphs) all.add(em * glyph.origin);
    for (const text_line& line : run.lines) {
        const auto glyphs = run.letters_of(line);
        const bool is_column = !glyphs.empty() && glyphs.front().origin.y > glyphs.back().origin.y;
        all.add(em * (line.origin + (is_column ? point{0.0, -line.advance} : point{line.advance, 0.0})));
    }
    return all;
}

}  // namespace

const char* bends::refused() const noexcept
{
    if (radius && cylinder != 0.0) return "A cylinder has degrees or a radius: leave out one of them.";
    const int ways = (cylinder != 0.0 || radius) + (twist != 0.0) + (wave != 0.0);
    if (ways > 1) return "A text bends in one way at a time: leave out all but one of cylinder, twist and wave.";
    const int warps = (arc != 0.0) + (flag != 0.0) + (ring != 0.0) + (path_wave != 0.0);
    if (warps > 1) return "A text has one warp or path at a time: leave out all but one of arc, flag, ring and wave.";
    return nullptr;
}

std::shared_ptr<const plane_path> bends::path() const
{
    if (ring == 0.0 && path_wave == 0.0) return nullptr;
    auto way = std::make_shared<plane_path>();
    constexpr double step = 3.0;  // em, half of a wave
    if (ring > 0.0) way->circle({0.0, 0.0}, ring);
    if (ring < 0.0) {  // inside, the other way round
        way->move({0.0, -ring});
        way->arc({0.0, 0.0}, 360.0);
        way->close();
    }
    if (ring != 0.0) return way;
    way->move({-16.0 * step, 0.0});
    for (int i = -16; i < 16; ++i)
        way->quadratic({(i + 0.5) * step, i % 2 == 0 ? 2.0 * path_wave : -2.0 * path_wave}, {(i + 1) * step, 0.0});
    return way;
}

text_to_mesh::bend_options bends::choose(const glyph_run* run) const
{
    text_to_mesh::bend_options made;
    if (arc != 0.0) made.warp = typemesh::arc{.degrees = arc};
    if (flag != 0.0) made.warp = typemesh::flag{.height = flag};
    made.is_on = in_space();
    if (radius) made.how.of = on_cylinder{.radius = *radius};
    if (!fit_text() || run == nullptr) return made;
    const box text = baselines_of(*run);
    const text_span span = text_span::of(text);
    made.how.middle = span.middle();
    constexpr double degrees_per_radian = 57.29577951308232;
    if (cylinder != 0.0) made.how.of = on_cylinder{.radius = span.width * degrees_per_radian / cylinder};
    if (twist != 0.0) {
        constexpr double half_capital = 0.35;  // em
        const double middle = text.empty() ? 0.0 : 0.5 * (text.low.y + text.high.y);
        made.how.of = typemesh::twist{.degrees_per_em = twist / span.width, .across = middle + half_capital};
    }
    if (wave != 0.0) made.how.of = displaced<typemesh::wave>{{.height = wave, .length = span.width}};
    return made;
}

}  // namespace typemesh_web

// SPDX-License-Identifier: MIT
//
// The same glyphs through DirectWrite, HarfBuzz and FreeType, drawn by the latter two on the machine itself.
//
// Tolerated differences, each with a law of its own:
//
//   hints       Wine loads glyphs with the font's instructions at one pixel a unit.
//               Where instructions still act at that size, or round a component's place, Wine must agree with
//               FreeType's hinted outline instead.
//   thirds      Wine makes cubics of quadratics in 26.6 fixed point and rounds down twice on the way, so a control
//               point that is no whole number (a scaled component, a hinted point) may lie up to 6/64 unit off.
//   fractions   FreeType rounds unhinted CFF outlines with fractions down to whole units; see tests/conformance.
#include "support/catch.hpp"
#include "windows/reference.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

constexpr double tolerance = 1.0 / 64;

double farthest(const std::vector<curve>& a, const std::vector<curve>& b, std::size_t start)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const curve &c = a[i], &d = b[(start + i) % b.size()];
        if (c.degree != d.degree) return 1e300;
        for (std::uint32_t k = 0; k <= c.degree; ++k)
            most = (std::max)({most, std::fabs(c.p[k].x - d.p[k].x), std::fabs(c.p[k].y - d.p[k].y)});
    }
    return most;
}

/// How far the points of two outlines lie apart at most, whatever point each contour starts with.
double farthest(const test::drawn_contours& a, const test::drawn_contours& b)
{
    if (a.size() != b.size()) return 1e300;
    double most = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (a[k].size() != b[k].size()) return 1e300;
        double best = a[k].empty() ? 0.0 : 1e300;
        for (std::size_t start = 0; start < b[k].size() && best > tolerance; ++start)
            best = (std::min)(best, farthest(a[k], b[k], start));
        most = (std::max)(most, best);
    }
    return most;
}

/// The fonts whose CFF outlines have fractions.
bool rounds_down(const std::string& path)
{
    return path.find("DavidCLM") != std::string::npos || path.find("NachlieliCLM") != std::string::npos;
}

}  // namespace

TEST_CASE(
    "DirectWrite draws the glyphs of the smoke fonts as HarfBuzz and FreeType do, to 1/64 unit, where Wine leaves them "
    "unhinted",
    "[windows]")
{
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(TYPEMESH_REFERENCE_OUTLINES))
        for (const auto& entry : std::filesystem::directory_iterator{TYPEMESH_REFERENCE_OUTLINES})
            if (entry.path().extension() == ".outlines") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    INFO("typemesh_reference_outlines writes them: see tests/run.sh");
    REQUIRE(files.size() > 100);

    std::size_t compared = 0, hinted = 0, faces = 0, exact_faces = 0;
    std::set<std::string> exact;
    for (const auto& file : files) {
        const test::reference_face face = test::reference_file::read(file.string());
        INFO(face.path << ", face " << face.face);
        REQUIRE_FALSE(face.glyphs.empty());
        auto font = directwrite_font::open(test::windows_path(face.path).c_str(), {face.face, {}});
        REQUIRE(font);
        CHECK(font->units_per_em() == face.units_per_em);
        CHECK(font->glyph_count() == face.glyph_count);
        const bool rounds = rounds_down(face.path);
        outline o;
        std::size_t here = 0, wrong = 0;
        glyph_id first_wrong = 0;
        for (const test::reference_glyph& g : face.glyphs) {
            REQUIRE(record(*font, g.id, o));
            CHECK(o.rule == fill_rule::non_zero);
            const auto drawn = test::contours_of(o);
            ++compared;
            if (farthest(drawn, g.harfbuzz) <= tolerance && (rounds || farthest(drawn, g.freetype) <= tolerance))
                continue;
            ++here;
            if (farthest(drawn, g.hinted) > 6 * tolerance && wrong++ == 0) first_wrong = g.id;
        }
        INFO("first difference: glyph " << first_wrong);
        CHECK(wrong == 0);
        hinted += here;
        ++faces;
        if (here == 0) ++exact_faces, exact.insert(std::filesystem::path{face.path}.stem().string());
    }
    std::printf("%u glyphs of %u faces compared, %u differ as hints say; %u faces agree in all\n", unsigned(compared),
                unsigned(faces), unsigned(hinted), unsigned(exact_faces));
    CHECK(compared > 20000);
    CHECK(hinted * 10 < compared);
    for (const char* name : {"DejaVuSans-Bold", "DejaVuSerif", "LiberationSans-Regular", "LiberationSerif-Regular",
                             "LiberationMono-Regular", "ComicNeue-Regular", "Purisa", "Lohit-Devanagari",
                             "DejaVuSerif-Bold", "sawarabi-mincho-medium"}) {
        INFO(name);
        CHECK(exact.count(name) == 1);
    }
}

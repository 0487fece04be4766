// SPDX-License-Identifier: MIT
//
// Joined scripts, merged to solids without inner walls: Arabic, and Latin whose letters run into each other.

#include "opened_font.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"
#include "support/oracle.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <set>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct joined_text {
    std::string font, text;
};

std::vector<joined_text> joined_texts()
{
    const std::string fonts = font_folder().string();
    std::vector<joined_text> all;
    for (const std::string& phrase : test::workload_texts("arabic"))
        for (const char* font : {"/opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
                                 "/truetype/awami/AwamiNastaliq-Regular.ttf", "/truetype/dejavu/DejaVuSans.ttf"})
            all.push_back({fonts + font, phrase});
    for (const std::string& phrase : test::workload_texts("latin"))
        all.push_back({fonts + "/truetype/GreatVibes-Regular.ttf", phrase.substr(0, 200)});
    return all;
}

/// The outlines of all glyphs of the plan at their places, on a grid of 512 cells a unit. Empty where one does not fit.
std::vector<std::vector<grid_point>> placed_outlines(const auto& plan)
{
    std::vector<std::vector<grid_point>> loops;
    for (const drawn_glyph& s : plan.glyphs()) {
        const auto& form = s.built->form();
        for (std::size_t l = 0; l + 1 < form.starts.size(); ++l) {
            loops.emplace_back();
            for (std::uint32_t k = form.starts[l]; k < form.starts[l + 1]; ++k) {
                loops.back().push_back({form.points[k].x + static_cast<std::int32_t>(std::lround(s.origin.x * 512.0)),
                                        form.points[k].y + static_cast<std::int32_t>(std::lround(s.origin.y * 512.0))});
            }
        }
    }
    return loops;
}

}  // namespace

TEST_CASE("merged texts are closed and as large as the union of their glyphs, and each glyph is in one group",
          "[workload]")
{
    std::size_t groups = 0, texts = 0;
    for (const joined_text& subject : joined_texts()) {
        auto font = test::opened(subject.font);
        INFO(subject.font << ": " << subject.text);
        for (const double tolerance : {quality::low, quality::high}) {
            text_mesher apart_mesher{font}, mesher{font};
            auto apart = apart_mesher.plan(subject.text, {.tolerance = tolerance});
            REQUIRE(apart);
            const auto outlines = placed_outlines(*apart);
            const std::vector<test::oracle::loop> given{outlines.begin(), outlines.end()};
            const double filled = test::oracle::doubled_filled_area(given, fill_rule::non_zero) / (2 * 512.0 * 512.0);

            auto merged =
                mesher.plan(subject.text, {.tolerance = tolerance, .unit = output_unit::font_units, .merge = true});
            REQUIRE(merged);
            const auto m = test::written<test::full_mesh>(*merged);
            std::set<std::uint32_t> drawn;
            for (std::size_t g = 0; g < merged->glyphs().size(); ++g) {
                groups += merged->members(g).size() > 1;
                for (const std::uint32_t member : merged->members(g)) CHECK(drawn.insert(member).second);
                const auto c = test::examine(m.vertices, test::indices_of(*merged, g, m));
                CHECK(c.unmatched_edges == 0);
                CHECK(c.crowded_slanted == 0);
            }
            CHECK(drawn.size() == apart->glyphs().size());

            const double depth = 0.2 * font.units_per_em(), bent = test::oracle::length(given) / 512.0 * 2.0 / 512.0;
            const double area = test::volume(m.vertices, m.indices) / depth;
            CHECK(std::fabs(area - filled) <= 1e-5 * filled + bent);  // floats, and crossings that lie on the grid
            ++texts;
        }
    }
    CHECK(texts > 50);
    CHECK(groups > 200);
}

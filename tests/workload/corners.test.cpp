// SPDX-License-Identifier: MIT
//
// text_options::corners with real fonts: texts of every script, merged, plain, bevelled and hollow, have edges with two faces only.

#include "opened_font.hpp"
#include "support/lit_mesh.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/typemesh.hpp>

#include <string>

using namespace typemesh;

namespace {

struct found_corners {
    std::size_t texts = 0;
    std::uint64_t corners = 0;
};

template <class Mesher>
void check_text(Mesher& mesher, const std::string& text, touching way, found_corners& all)
{
    const auto plan = mesher.plan(text, {.tolerance = quality::low, .merge = true, .corners = way});
    REQUIRE(plan);
    if (plan->size().triangles == 0) return;
    CHECK(plan->report().touching == 0);
    CHECK(inspect::check_manifoldness(test::written(*plan).view()).is_manifold());
    ++all.texts;
    all.corners += plan->report().corners_moved;
}

}  // namespace

TEST_CASE("every edge of a text has two faces, in all fonts and scripts of the workload", "[workload]")
{
    found_corners all;
    test::for_each_script([&all](harfbuzz_font& font, const std::string& path, const std::string& script) {
        auto plain = text_mesher{font};
        auto stepped = text_mesher{font}.with(bevelled{.width = 0.03f, .profile = stepped_profile()});
        auto hollow =
            text_mesher{font}.with(outlined<extruded<>, extruded<>>{.width = 0.02f, .place = outline_place::centre});
        for (const std::string& text : test::workload_texts(script))
            for (const touching way : {touching::part, touching::join}) {
                INFO(path << ", " << text << (way == touching::part ? ", parted" : ", joined"));
                check_text(plain, text, way, all);
                check_text(stepped, text, way, all);
                check_text(hollow, text, way, all);
            }
    });
    CHECK(all.texts > 300);
    // Blocks touch themselves and each other.
    auto font = test::opened("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf");
    auto plain = text_mesher{font};
    for (const touching way : {touching::part, touching::join}) check_text(plain, "▚▞▙▟▚▚\n▞▚█▛▞▞\n▒▚▞▜▗▘", way, all);
    CHECK(all.corners > 30);
}

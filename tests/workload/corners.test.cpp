// SPDX-License-Identifier: MIT
//
// text_options::corners with real fonts: texts of every script, merged, plain, bevelled and hollow, have edges with two faces only.

#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/workload.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
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
    for (const test::workload_font& file : test::workload_fonts()) {
        if (!file.available()) continue;
        auto font = harfbuzz_font::open(file.path.c_str());
        REQUIRE(font);
        auto plain = text_mesher{*font};
        auto stepped = text_mesher{*font}.with(bevelled{.width = 0.03f, .profile = stepped_profile()});
        auto hollow =
            text_mesher{*font}.with(outlined<extruded<>, extruded<>>{.width = 0.02f, .place = outline_place::centre});
        for (const char* const script : {"latin", "arabic", "chinese", "japanese"}) {
            if (!file.serves(script)) continue;
            for (const std::string& text : test::workload_texts(script))
                for (const touching way : {touching::part, touching::join}) {
                    INFO(file.path << ", " << text << (way == touching::part ? ", parted" : ", joined"));
                    check_text(plain, text, way, all);
                    check_text(stepped, text, way, all);
                    check_text(hollow, text, way, all);
                }
        }
    }
    CHECK(all.texts > 300);
    // Blocks touch themselves and each other.
    auto font = harfbuzz_font::open("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf");
    REQUIRE(font);
    auto plain = text_mesher{*font};
    for (const touching way : {touching::part, touching::join}) check_text(plain, "▚▞▙▟▚▚\n▞▚█▛▞▞\n▒▚▞▜▗▘", way, all);
    CHECK(all.corners > 30);
}

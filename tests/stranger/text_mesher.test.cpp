// SPDX-License-Identifier: MIT

// A stranger's policies in the text mesher, one at a time and all together.

#include <typemesh/text/text_mesher.hpp>

#include <typemesh/extrude/flat.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <vector>

#include "strangers.hpp"
#include "support/catch.hpp"
#include "support/required.hpp"

using namespace typemesh;
using Catch::Approx;

TEST_CASE("a text in a stranger's font is meshed with the library's policies", "[stranger]")
{
    stranger::stamps font;
    text_mesher mesher{font};
    std::vector<stranger::vertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto report = test::required(mesher.build("[o ~\n[?", into(vertices, indices)));
    CHECK(report->glyphs == 6);
    CHECK(report->blank == 1);
    CHECK(report->missing == 1);
    CHECK(report->first_missing == 6);
    CHECK(report->refused == 0);
    CHECK_FALSE(vertices.empty());
}

TEST_CASE("each of a stranger's policies works by itself, and all together", "[stranger]")
{
    stranger::stamps font;
    stranger::volume sink;
    const auto volume = [&](auto mesher) {
        CHECK(test::required(mesher.build("[o~", sink))->complete());
        return sink.value();
    };
    const double own = volume(text_mesher{font}.with(stranger::thirds{}));
    CHECK(own == Approx(0.2 * (0.64 + 0.2 + 0.64 - 0.2)).epsilon(0.05));
    CHECK(volume(text_mesher{font}) == Approx(own).epsilon(0.05));
    CHECK(volume(text_mesher{font}.with(stranger::patient{}).with(stranger::thirds{})) == Approx(own));
    CHECK(
        volume(
            text_mesher{font}.with(stranger::thirds{}).with(extruded<stranger::faceted>{}).with(stranger::patient{})) ==
        Approx(own));

    auto mesher = text_mesher{font}
                      .with(stranger::thirds{})
                      .with(stranger::patient{})
                      .with(stranger::fence{})
                      .with(stranger::stage_counter{});
    const auto plan = test::required(mesher.plan("[o~"));
    CHECK(plan->size() == mesh_size{2 * (4 + 16 + 8), 2 * (4 + 16 + 8)});
    REQUIRE(plan->write(sink));
    CHECK(sink.count == 56);
    CHECK(mesher.policy<stranger::stage_counter>()->seen[static_cast<std::size_t>(stage::triangulate)] == 3);
    CHECK(mesher.policy<stranger::stage_counter>()->seen[static_cast<std::size_t>(stage::discretise)] == 3);
}

TEST_CASE("a run made by hand needs no shaper", "[stranger]")
{
    stranger::stamps font;
    glyph_run run;
    run.units_per_em = 100.0;
    for (const glyph_id id : {3u, 1u, 2u})
        REQUIRE(run.glyphs.push_back({.id = id, .cluster = 0, .origin = {200.0 * id, 0.0}}));
    text_mesher mesher{font};
    std::vector<stranger::packed_vertex> packed;
    std::vector<std::uint16_t> indices;
    const auto report = mesher.build(run, into(packed, indices, stranger::packing_writer{-10.0f, 10.0f, 7u}));
    REQUIRE(report);
    CHECK(report->glyphs == 3);
    CHECK(packed.back().colour == 7);
}

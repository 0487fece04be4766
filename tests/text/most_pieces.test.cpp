// SPDX-License-Identifier: MIT
//
// Contours that cross without end: the limit on their pieces, and the memory that they leave behind.

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

constexpr glyph_id letter = 0, star = 1, upright = 2, level = 3;
constexpr std::uint32_t few_pieces = 1000;  // the letter needs four, the star many thousands

/// A font of drawings: a good letter, a star whose edges cross nearly all others, and two combs of 20 teeth which are
/// simple alone and cross 1,600 times where they lie on each other.
recorded_outlines hostile_font()
{
    recorded_outlines font{1000.0};
    const auto box = [](auto& pen, double l, double b, double r, double t) {
        pen.move({l, b}), pen.line({r, b}), pen.line({r, t}), pen.line({l, t}), pen.close();
    };
    REQUIRE(font.add([&](auto& pen) { box(pen, 0, 0, 300, 700); }));
    REQUIRE(font.add([&](auto& pen) {
        for (int i = 0; i < 151; ++i) {
            const double angle = 6.283185307179586 * i * 75 / 151;
            const point p{300 + 300 * std::cos(angle), 300 + 300 * std::sin(angle)};
            i == 0 ? pen.move(p) : pen.line(p);
        }
        pen.close();
    }));
    REQUIRE(font.add([&](auto& pen) {
        for (int i = 0; i < 20; ++i) box(pen, 30 * i, 0, 30 * i + 10, 600);
    }));
    REQUIRE(font.add([&](auto& pen) {
        for (int i = 0; i < 20; ++i) box(pen, 0, 30 * i, 600, 30 * i + 10);
    }));
    return font;
}

glyph_run run_of(const std::vector<placed_glyph>& glyphs)
{
    glyph_run run;
    run.units_per_em = 1000.0;
    for (const placed_glyph& g : glyphs) REQUIRE(run.glyphs.push_back(g));
    return run;
}

const std::vector<placed_glyph> good{{letter, 7, {0, 0}}, {letter, 9, {2000, 0}}};
const std::vector<placed_glyph> with_star{good[0], {star, 8, {1000, 0}}, good[1]};

template <class Mesher>
full_mesh build(Mesher& mesher, const glyph_run& run, const text_options& options, text_report* report = nullptr)
{
    full_mesh m;
    const auto made = test::required(mesher.build(run, into(m.vertices, m.indices), options));
    if (report != nullptr) *report = *made;
    return m;
}

}  // namespace

TEST_CASE("a glyph that falls into more pieces than allowed is refused alone, and the rest is built", "[text]")
{
    recorded_outlines font = hostile_font();
    text_mesher mesher{font};
    const text_options limited{.max_pieces = few_pieces};
    text_report report;
    const full_mesh rest = build(mesher, run_of(with_star), limited, &report);
    CHECK(report.refused == 1);
    CHECK_FALSE(report.complete());
    CHECK(report.first_refusal == error::too_many_pieces);
    CHECK(report.first_refusal.count == few_pieces);
    char words[160];
    CHECK(std::string(describe(report.first_refusal, words)) ==
          "glyph 1, cluster 8: The contours cross more often than max_pieces allows: raise max_pieces. "
          "(the limit: 1000)");
    CHECK(test::same_bits(rest, build(mesher, run_of(good), limited)));

    const full_mesh all = build(mesher, run_of(with_star), {}, &report);
    CHECK(report.complete());
    CHECK(all.vertices.size() > rest.vertices.size() + few_pieces);
}

TEST_CASE("one cache keeps a glyph refused under one limit and built under another", "[text]")
{
    recorded_outlines font = hostile_font();
    const glyph_run run = run_of(with_star);
    text_mesher plain{font};
    const full_mesh whole = build(plain, run, {});
    for (const bool refused_first : {true, false}) {
        glyph_cache cache;
        auto mesher = text_mesher{font}.with(cached_in{cache, 1});
        for (int i = 0; i < 4; ++i) {
            text_report report;
            const bool limits = (i % 2 == 0) == refused_first;
            const full_mesh m =
                build(mesher, run, limits ? text_options{.max_pieces = few_pieces} : text_options{}, &report);
            CHECK(report.refused == (limits ? 1u : 0u));
            if (!limits) CHECK(test::same_bits(m, whole));
        }
        CHECK(cache.statistics().entries == 4);  // both glyphs under both limits
    }
}

TEST_CASE("a group of merged glyphs that falls into more pieces than allowed is refused alone", "[text][merge]")
{
    recorded_outlines font = hostile_font();
    text_mesher mesher{font};
    const glyph_run run =
        run_of({{letter, 0, {0, 0}}, {upright, 1, {1000, 0}}, {level, 2, {1000, 0}}, {letter, 3, {2000, 0}}});
    text_report report;
    (void)build(mesher, run, {.max_pieces = few_pieces}, &report);
    CHECK(report.complete());  // each is simple
    const full_mesh rest = build(mesher, run, {.max_pieces = few_pieces, .merge = true}, &report);
    CHECK(report.refused == 1);
    CHECK(report.first_refusal == error::too_many_pieces);
    CHECK(report.first_refusal.glyph == upright);
    CHECK(report.first_refusal.cluster == 1);
    CHECK(report.first_refusal.count == few_pieces);
    const glyph_run others = run_of({{letter, 0, {0, 0}}, {letter, 3, {2000, 0}}});
    CHECK(test::same_bits(rest, build(mesher, others, {.merge = true})));
    CHECK(build(mesher, run, {.merge = true}, &report).vertices.size() > rest.vertices.size());
    CHECK(report.complete());
}

TEST_CASE("trim() gives back what refused glyphs and groups took, and the next text is the same", "[text][merge]")
{
    recorded_outlines font = hostile_font();
    const glyph_run simple = run_of(good);
    const glyph_run crossing =
        run_of({{star, 0, {0, 0}}, {upright, 1, {1000, 0}}, {level, 2, {1000, 0}}, {letter, 3, {2000, 0}}});
    const text_options limited{.max_pieces = few_pieces, .merge = true};
    test::counting_memory memory, modest_memory;
    text_mesher mesher{font, memory.source()}, modest{font, modest_memory.source()};
    const full_mesh before = build(mesher, simple, limited);
    CHECK(test::same_bits(before, build(modest, simple, limited)));
    modest.trim();
    for (int round = 0; round < 2; ++round) {
        text_report report;
        (void)build(mesher, crossing, limited, &report);
        CHECK(report.refused == 2);
        CHECK(memory.bytes_held > 50'000);
        mesher.trim();
        INFO(memory.bytes_held << " bytes held, " << modest_memory.bytes_held << " where nothing crossed");
        CHECK(memory.bytes_held < modest_memory.bytes_held + 20'000);  // a block more for the plan
        CHECK(test::same_bits(before, build(mesher, simple, limited)));
        const std::size_t warm = memory.requests;
        CHECK(test::same_bits(before, build(mesher, simple, limited)));
        CHECK(memory.requests == warm);
    }
}

TEST_CASE("trim() between planning and writing leaves the plan as it is", "[text]")
{
    recorded_outlines font = hostile_font();
    const glyph_run run = run_of(with_star);
    text_mesher mesher{font};
    const full_mesh expected = build(mesher, run, {.merge = true});
    auto plan = test::required(mesher.plan(run, {.merge = true}));
    mesher.trim();
    const full_mesh m = test::written<full_mesh>(*plan);
    CHECK(test::same_bits(m, expected));
}

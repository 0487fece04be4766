// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "support/laid_paragraph.hpp"
#include "support/text_laws.hpp"

#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/text/letter_motions.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct rectangle {
    double left, right, low, high;
    std::uint32_t line;
    glyph_id id;
    style_id style;
};

/// The backgrounds of a run; they must come before the letters of their lines.
std::vector<rectangle> backgrounds_of(const glyph_run& run)
{
    std::vector<rectangle> all;
    for (std::uint32_t k = 0; k < run.lines.size(); ++k) {
        bool letters = false;
        for (std::uint32_t i = 0; i < run.lines[k].glyph_count; ++i) {
            const placed_glyph& g = run.glyphs[run.lines[k].first_glyph + i];
            const glyph_style& s = run.glyph_styles.empty() ? glyph_style{} : run.glyph_styles[g.glyph_style];
            letters = letters || g.cluster != no_cluster;
            if (s.face != bar_face || letters) continue;
            all.push_back({g.origin.x, g.origin.x + s.map.xx, g.origin.y, g.origin.y + s.map.yy, k, g.id, s.style});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("a background lies behind its text in each line, with padding and round corners", "[paragraph]")
{
    test::laid_paragraph<> p{u"abc def", {.width = 1.8}};
    highlight_writer writer;
    const text_highlight span{1, 6, style_id{3}};
    REQUIRE(writer.write(p.font, p.laid(), {&span, 1}, {.pad_along = 0.1, .pad_across = 0.05, .radius = 0.2}, p.run));
    const auto all = backgrounds_of(p.run);
    REQUIRE(all.size() == 2);
    const double across[] = {500.0 - 100.0, 1500.0 + 100.0, 0.0 - 100.0, 1000.0 + 100.0};  // the space hangs
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(all[k].line == k);
        CHECK(all[k].left == Approx(across[2 * k]));
        CHECK(all[k].right == Approx(across[2 * k + 1]));
        CHECK(all[k].low == Approx(p.words.lines()[k].origin.y - 250.0));
        CHECK(all[k].high == Approx(p.words.lines()[k].origin.y + 750.0));
        CHECK(all[k].id == rounded_bar(200.0 / (all[k].right - all[k].left), 0.2));
        CHECK(all[k].style == style_id{3});
        CHECK(p.run.letters_of(p.run.lines[k]).front().cluster == p.words.lines()[k].first);
    }
}

TEST_CASE("ranges that touch and have one style share a background, over large letters and others", "[paragraph]")
{
    const style_span big{2, 3, {.size = 2.0}};
    test::laid_paragraph<> p{u"abcdef", {}, {.styles = {&big, 1}}};
    highlight_writer writer;
    const text_highlight spans[] = {{0, 2, style_id{1}}, {2, 4, style_id{1}}, {4, 5, style_id{2}}, {5, 6, style_id{1}}};
    REQUIRE(writer.write(p.font, p.laid(), spans, {}, p.run));
    const auto all = backgrounds_of(p.run);
    REQUIRE(all.size() == 3);
    CHECK(all[0].left == 0.0);
    CHECK(all[0].right == 2500.0);
    CHECK(all[0].high == Approx(1400.0));
    CHECK(all[0].low == Approx(-400.0));
    CHECK(all[1].high == Approx(700.0));
    CHECK(all[1].id == 0);
    CHECK(all[2].left == 3000.0);
}

TEST_CASE("a background does not cover the ruby above its text", "[paragraph]")
{
    const text_room room{0, 2, 1.0, 0.5};
    test::laid_paragraph<> p{u"ab", {}, {.rooms = {&room, 1}}};
    highlight_writer writer;
    const text_highlight span{0, 2, style_id{1}};
    REQUIRE(writer.write(p.font, p.laid(), {&span, 1}, {}, p.run));
    CHECK(p.words.lines()[0].metrics.ascender == 1200.0);
    CHECK(backgrounds_of(p.run)[0].high == 700.0);
}

TEST_CASE("in columns a background stands behind its letters", "[paragraph]")
{
    test::laid_paragraph<> p{u"\u6F22\u5B57\u6F22", {}, {.direction = direction::top_to_bottom}};
    highlight_writer writer;
    const text_highlight span{1, 2, style_id{1}};
    REQUIRE(writer.write(p.font, p.laid(), {&span, 1}, {.pad_along = 0.1, .pad_across = 0.2}, p.run));
    const auto all = backgrounds_of(p.run);
    const line_metrics m = line_reach_of(p.font, direction::top_to_bottom);
    REQUIRE(all.size() == 1);
    CHECK(all[0].low == Approx(-1000.0 - 100.0));
    CHECK(all[0].high == Approx(-500.0 + 100.0));
    CHECK(all[0].left == Approx(m.descender - 200.0));
    CHECK(all[0].right == Approx(m.ascender + 200.0));
}

TEST_CASE("in 10000 random texts of two directions backgrounds cover their letters and no others", "[paragraph]")
{
    std::mt19937 random{5};
    const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
    std::size_t parts = 0, several = 0;
    for (int i = 0; i < 10000; ++i) {
        constexpr char16_t letters[] = u"abcd1\u05D0\u05D1\u05D2\u6F22";
        std::u16string text;
        for (std::uint32_t n = 2 + below(12); n > 0; --n) text += letters[below(9)];
        const auto size = static_cast<std::uint32_t>(text.size());
        const std::uint32_t first = below(size), last = first + 1 + below(size - first);
        test::laid_paragraph<> p{text, {.width = 0.6 + 0.5 * below(10), .align = static_cast<alignment>(below(5))}};
        highlight_writer writer;
        const text_highlight span{first, last, style_id{1}};
        REQUIRE(writer.write(p.font, p.laid(), {&span, 1}, {}, p.run));
        const auto all = backgrounds_of(p.run);
        double covered = 0.0, wide = 0.0;
        bool sound = true;
        std::vector<int> in_line(p.run.lines.size());
        for (const rectangle& r : all) {
            wide += r.right - r.left;
            several += ++in_line[r.line] == 2 ? 1u : 0u;
        }
        for (std::uint32_t k = 0; k < p.run.lines.size(); ++k)
            for (const placed_glyph& g : p.run.letters_of(p.run.lines[k])) {
                const double middle = g.origin.x + 250.0;
                std::size_t over = 0;
                for (const rectangle& r : all) over += r.line == k && r.left < middle && middle < r.right ? 1u : 0u;
                const bool chosen = g.cluster >= first && g.cluster < last;
                covered += chosen ? 500.0 : 0.0;
                sound = sound && over == (chosen ? 1u : 0u);
            }
        parts += all.size();
        REQUIRE((sound && std::fabs(covered - wide) < 1e-6));
    }
    CHECK(parts > 15000);
    CHECK(several > 500);
}

TEST_CASE("backgrounds are closed solids of their own, which a motion puts behind the letters", "[paragraph]")
{
    test::toy_font font;
    paragraph words{font};
    glyph_run run;
    REQUIRE(words.set("oEi Eo"));
    REQUIRE(words.lay_out({.width = 2.0}, run));
    const std::size_t lines = run.lines.size();
    highlight_writer writer;
    const text_highlight span{1, 5, style_id{1}};
    REQUIRE(writer.write(font, words.laid(), {&span, 1}, {.pad_along = 0.1, .radius = 0.2}, run));
    text_mesher mesher{font, extruded<>{.depth = 0.25f}};
    const auto plan = test::required(mesher.plan(run));
    CHECK(plan->report().complete());
    const test::lit_mesh flat = test::written(*plan);
    CHECK(inspect::check_closedness(flat.view(), 2).is_closed());
    CHECK(inspect::check_normals(flat.view(), &test::lit_vertex::normal).is_right());
    REQUIRE(plan->find_letters("oEi Eo"));
    CHECK(plan->letters().bars.size() >= lines);
    test::lit_mesh moved;
    const auto back = [](const letter_place& l) noexcept {
        affine3 map{};
        if (l.letter.style == style_id{1}) map.origin.z = -0.5f;
        return map;
    };
    REQUIRE(plan->write(into(moved.vertices, moved.indices), back));
    CHECK(inspect::check_closedness(moved.view(), 2).is_closed());
    std::size_t behind = 0;
    for (std::size_t i = 0; i < moved.vertices.size(); ++i) {
        const float step = flat.vertices[i].place.z - moved.vertices[i].place.z;
        CHECK((step == 0.0f || step == 0.5f));
        behind += step > 0.0f ? 1u : 0u;
    }
    CHECK(behind > 100);
    CHECK(behind < moved.vertices.size());
}

TEST_CASE("backgrounds that cannot be written leave the glyphs as they were", "[paragraph]")
{
    test::laid_paragraph<> p{u"abc\ndef"};
    const text_highlight spans[] = {{0, 5, style_id{1}}, {2, 7, style_id{2}}};
    const auto refused = [&](const highlight_options& how) {
        highlight_writer writer;
        return std::string{writer.write(p.font, p.laid(), spans, how, p.run).error().option};
    };
    CHECK(refused({.radius = -0.1}) == "radius");
    CHECK(refused({.pad_along = std::nan("")}) == "pad_along");
    CHECK(refused({.pad_across = std::nan("")}) == "pad_across");
    CHECK(p.run.glyphs.size() == 6);
    glyph_run other;
    highlight_writer writer;
    CHECK(std::string{writer.write(p.font, p.laid(), spans, {}, other).error().option} == "run");
    CHECK(other.glyphs.empty());
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 20; ++n) {
        test::counting_memory failing{.fail_at = n};
        highlight_writer poor{failing.source()};
        const auto done = poor.write(p.font, p.laid(), spans, {}, p.run);
        if (done) break;
        ++failures;
        CHECK(done == error::out_of_memory);
        CHECK(p.run.glyphs.size() == 6);
        CHECK(p.run.lines[1].first_glyph == 3);
    }
    CHECK(failures > 0);
    p.again({});
    test::counting_memory counted;
    highlight_writer warm{counted.source()};
    REQUIRE(warm.write(p.font, p.laid(), spans, {}, p.run));
    const std::size_t before = counted.requests;
    p.again({});
    REQUIRE(warm.write(p.font, p.laid(), spans, {.pad_along = -9.0}, p.run));
    CHECK(backgrounds_of(p.run).empty());  // a padding that leaves nothing
    REQUIRE(warm.write(p.font, p.laid(), spans, {}, p.run));
    CHECK(counted.requests == before);
    CHECK(backgrounds_of(p.run).size() == 4);
}

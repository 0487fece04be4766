// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <typemesh/text/picked_character.hpp>
#include <typemesh/text/text_mesher.hpp>

#include <string_view>

using namespace typemesh;

namespace {

/// The toy font, whose E is a ligature of as many letters as a text has for it.
struct ligating_font : test::toy_font {
    buffer<double> carets;

    error ligature_carets(std::uint32_t, glyph_id id, bool, buffer<double>& to) const noexcept
    {
        if (id == 2)
            for (const double c : carets) (void)to.push_back(c);
        return {};
    }
};

/// A run of one line: the ligature, which begins at 100 and is 600 wide, then an o.
void make(glyph_run& run, cluster_id next)
{
    run.units_per_em = 1000.0;
    REQUIRE(run.glyphs.push_back({2, 0, {100.0, 50.0}}));
    REQUIRE(run.glyphs.push_back({1, next, {700.0, 50.0}}));
    REQUIRE(run.lines.push_back({0, 2, {100.0, 50.0}, 1200.0}));
}

}  // namespace

TEST_CASE("a point of a ligature's mesh leads to one of its letters, in equal shares or by its font's carets", "[text]")
{
    ligating_font font;
    text_mesher mesher{font};
    glyph_run run;
    constexpr std::string_view text = "abe\xCC\x81o";  // three graphemes and the o
    make(run, 5);
    const std::uint32_t begins[] = {0, 1, 2, 5, 6};
    for (const bool own : {false, true}) {
        if (own) REQUIRE((font.carets.push_back(50.0) && font.carets.push_back(550.0)));
        const double edges[] = {0.1, own ? 0.15 : 0.3, own ? 0.65 : 0.5, 0.7};
        for (const text_options& how : {text_options{}, text_options{.unit = output_unit::unit_box, .size = 3.0},
                                        text_options{.size = 40.0, .frame = right_handed_z_up}}) {
            auto plan = test::required(mesher.plan(run, how));
            const placement at = plan->place(0);
            for (std::size_t k = 0; k < 3; ++k) {
                for (const double share : {0.01, 0.5, 0.99}) {
                    const double x = edges[k] + share * (edges[k + 1] - edges[k]);
                    const point cell = {(1000.0 * x - 100.0) / (at.em_per_cell * 1000.0), 0.0};
                    const vec3 p = at.position(at.foot(cell), 0.0f);
                    CHECK(plan->place_of(p).x == Approx(x).margin(1e-6));
                    CHECK(plan->place_of(p).y == Approx(0.05).margin(1e-6));
                    const picked_character c = character_at(*plan, plan->hit(part::front, 0), p, text, font);
                    CHECK(c.text.first == begins[k]);
                    CHECK(c.text.last == begins[k + 1]);
                    CHECK(c.where.low.x == Approx(edges[k]).margin(1e-9));
                    CHECK(c.where.high.x == Approx(edges[k + 1]).margin(1e-9));
                    CHECK(c.where.low.y == Approx(-0.15));
                    CHECK(c.where.high.y == Approx(0.85));
                }
            }
        }
    }
    font.carets.clear();
    REQUIRE(font.carets.push_back(550.0));  // one too few, then out of order: equal shares again
    for (int k = 0; k < 2; ++k) {
        auto plan = test::required(mesher.plan(run));
        CHECK(character_at(*plan, plan->hit(part::front, 0), {0.31f, 0.0f, 0.0f}, text, font).text.first == 1);
        REQUIRE(font.carets.push_back(50.0));
    }
}

TEST_CASE("a ligature ends with its line, and one letter is all of its cluster", "[text]")
{
    ligating_font font;
    text_mesher mesher{font};
    glyph_run run;
    make(run, 2);
    auto plan = test::required(mesher.plan(run));
    const auto hit = plan->hit(part::front, plan->range(part::front).index_count / 3 - 1);
    REQUIRE(hit.cluster == 2);
    const picked_character last = character_at(*plan, hit, {9.0f, 0.0f, 0.0f}, "abo\r\nnext", font);
    CHECK(last.text.first == 2);
    CHECK(last.text.last == 3);
    CHECK(last.where.high.x == Approx(1.3));
    CHECK(character_at(*plan, hit, {}, "", font).text.last == 0);  // another text
    CHECK(character_at(*plan, {.cluster = no_cluster}, {}, "abo", font).text.last == 0);
}

TEST_CASE("an underline does not change the box of the last letter of a plain line", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const style_span spans[] = {{0, 2, {.decorations = decoration::underline}}};
    for (const std::size_t count : {0u, 1u}) {
        auto plan = test::required(mesher.plan("oE", {.shape = {.styles = std::span{spans}.first(count)}}));
        const picked_character c =
            character_at(*plan, {.glyph = 1, .of_run = 1, .cluster = 1}, {0.7f, 0.3f, 0.0f}, "oE", font);
        CHECK(c.text.first == 1);
        CHECK(c.where.low.x == Approx(0.6));
        CHECK(c.where.high.x == Approx(1.2));
    }
}

// SPDX-License-Identifier: MIT
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/picked_character.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/laid_out.hpp"
#include "support/required.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;

namespace {

struct vertex {
    float x, y, z;
};

}  // namespace

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position;
    vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position.x, s.position.y, s.position.z};
    }
};

namespace {

/// The middle of each triangle of a mesh, with what was hit.
template <class Plan, class With>
void each_middle(const Plan& plan, const With& with)
{
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    REQUIRE(plan.write(into(vertices, indices)));
    for (const part p : plan.parts()) {
        const mesh_range r = plan.range(p);
        for (std::uint32_t t = 0; t < r.index_count / 3; ++t) {
            const std::uint32_t* const corner = &indices[r.first_index + 3 * t];
            const vertex &a = vertices[corner[0]], &b = vertices[corner[1]], &c = vertices[corner[2]];
            with(plan.hit(p, t), vec3{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3});
        }
    }
}

constexpr std::string_view word = "office";

/// What of "office" a triangle at x belongs to: its letter's box holds it.
void check(const picked_character& letter, double x, std::map<std::string, box>& found)
{
    REQUIRE(letter.text.last == letter.text.first + 1);
    CHECK(letter.where.low.x < letter.where.high.x);
    CHECK(letter.where.low.y < -0.1);
    CHECK(letter.where.high.y > 0.6);
    const bool within = x >= letter.where.low.x - 0.1 && x <= letter.where.high.x + 0.1;  // letters overhang
    CHECK(within);
    found.emplace(std::to_string(letter.text.first), letter.where);
}

/// Each letter has a box of its own, the next one's begins where it ends, and the dot of the i is the i.
void check_all(const std::map<std::string, box>& found, double width)
{
    REQUIRE(found.size() == word.size());
    double at = 0.0;
    for (const auto& [place, where] : found) {
        CHECK(where.low.x == Approx(at).margin(1e-9));
        at = where.high.x;
    }
    CHECK(at == Approx(width).margin(1e-9));
}

}  // namespace

TEST_CASE("a triangle of a ligature leads to the letter that it belongs to", "[harfbuzz][picking]")
{
    // A font that says where its ligatures' carets stand, and two that do not.
    const char* const file = GENERATE("opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "truetype/dejavu/DejaVuSans.ttf",
                                      "opentype/mplus/Mplus1-Regular.otf");
    const bool merge = GENERATE(false, true);
    const double size = GENERATE(1.0, 37.0);
    INFO(file << (merge ? " merged " : " ") << size);
    if (!has_font(file)) return;
    auto font = test::required(harfbuzz_font::open(font_file(file).c_str()));
    const text_options how{.size = size, .frame = right_handed_z_up, .merge = merge};

    text_mesher mesher{*font};
    auto plan = test::required(mesher.plan(word, how));
    REQUIRE(plan->run().glyphs.size() == 4);  // the ffi is one
    const double width = plan->run().lines[0].advance / plan->run().units_per_em;
    std::map<std::string, box> plain, laid;
    each_middle(*plan, [&](const mesh_hit& hit, vec3 at) {
        const double x = static_cast<double>(at.x) / size;
        check(character_at(*plan, hit, at, word, *font), x, plain);
    });
    check_all(plain, width);

    paragraph words{*font};
    const glyph_run page = test::laid_out(words, word, {}, {.width = 50.0});
    auto styled = test::required(mesher.plan(page, how));
    each_middle(*styled, [&](const mesh_hit& hit, vec3 at) {
        const picked_character letter = character_at(*styled, hit, at, words.laid());
        check(letter, static_cast<double>(at.x) / size, laid);
        words.laid().boxes_of(letter.text.first, letter.text.last, [&](const box& b) {
            CHECK(b.low.x == letter.where.low.x);
            CHECK(b.high.x == letter.where.high.x);
        });
    });
    check_all(laid, width);
    for (const auto& [place, where] : plain) CHECK(where.low.x == Approx(laid[place].low.x).margin(1e-9));
}

TEST_CASE("a triangle leads to its letter where text is read to the left", "[harfbuzz][picking]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    constexpr std::string_view alef_lam = "لا";  // a ligature: lam on the right, alef on the left
    text_mesher mesher{*font};
    paragraph words{*font};
    const glyph_run page = test::laid_out(words, alef_lam);
    auto plan = test::required(mesher.plan(page));
    REQUIRE(plan->glyphs().size() == 1);
    for (const bool of_paragraph : {true, false}) {
        if (!of_paragraph) plan = mesher.plan(alef_lam);
        const bounds3 all = plan->bounds();
        const mesh_hit hit = plan->hit(part::front, 0);
        const auto at = [&](float share) {
            const vec3 p{all.low.x + share * (all.high.x - all.low.x), 0.1f, 0.0f};
            return (of_paragraph ? character_at(*plan, hit, p, words.laid())
                                 : character_at(*plan, hit, p, alef_lam, *font))
                .text.first;
        };
        CHECK(at(0.95f) == 0);
        CHECK(at(0.05f) == 2);
    }
}

TEST_CASE("marks belong to their letter, and a bar to none", "[harfbuzz][picking]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    constexpr std::string_view text = "xe\xCC\x81\xCC\xA3y";
    text_mesher mesher{*font};
    auto plan = test::required(mesher.plan(text));
    each_middle(*plan, [&](const mesh_hit& hit, vec3 at) {
        const picked_character letter = character_at(*plan, hit, at, text, *font);
        CHECK(letter.text.first == hit.cluster);
        CHECK(letter.text.last == (hit.cluster == 0 ? 1u : hit.cluster == 1 ? 6u : 7u));
    });
    CHECK(character_at(*plan, mesh_hit{}, {}, text, *font).text.last == 0);
    CHECK(character_at(*plan, mesh_hit{}, {}, text, *font).where.empty());
}

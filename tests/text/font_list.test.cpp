// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/required.hpp"
#include "support/toy_covering_font.hpp"

#include <typemesh/text/font_list.hpp>
#include <typemesh/typemesh.hpp>

#include <vector>

using namespace typemesh;
using test::toy_covering_font;

namespace font_list_test {

/// Has fonts of its own, and says what it was asked.
struct toy_provider {
    std::vector<toy_covering_font> fonts;
    std::size_t asked = 0;
    std::uint32_t script = 0;
    std::string_view language = {};
    bool fails = false;

    result<toy_covering_font*> font_for(text_view text, text_range range, std::uint32_t of_script,
                                        std::string_view of_language) noexcept
    {
        ++asked;
        script = of_script;
        language = of_language;
        if (fails) return error::refused_by_user;
        for (toy_covering_font& f : fonts)
            if (f.covers(decode(text, range.first).value)) return &f;
        return nullptr;
    }
};

using plain_list = font_list<toy_covering_font>;
using found_list = font_list<toy_covering_font, toy_provider>;
static_assert(face_source<plain_list> && shaper<plain_list>);
static_assert(face_source<found_list> && shaper<found_list>);

}  // namespace font_list_test

using namespace font_list_test;

TEST_CASE("a list of fonts does what a cascade of them does", "[text][fallback]")
{
    toy_covering_font first{U"a"}, second{U"b", 250.0}, third{U"c"};
    font_list fonts{first};
    const auto face = test::required(fonts.add(second));
    CHECK(*face == 1);
    REQUIRE(fonts.add(third));
    CHECK(fonts.face_count() == 3);
    CHECK(&fonts.font(2) == &third);
    CHECK(fonts.units_per_em(1) == 250.0);
    text_mesher mesher{fonts};
    const auto plan = test::required(mesher.plan("cab!"));
    CHECK(plan->report().missing == 1);
    CHECK(plan->run().lines[0].advance == 2000.0);
    CHECK(plan->bounds().high.x == Catch::Approx(1.1f));

    buffer<shaped_glyph> glyphs;
    CHECK(fonts.shape("a", {.last = 1, .face = 3}, {}, glyphs) == error::no_such_face);
}

TEST_CASE("what no font of a list has a provider finds, once for all texts", "[text][fallback]")
{
    toy_covering_font first{U"a"};
    toy_provider provider{{toy_covering_font{U"\u05D0b"}, toy_covering_font{U"cde"}}};
    font_list fonts{first, provider};
    text_mesher mesher{fonts};
    text_options how;
    how.shape.language = "he";
    auto plan = test::required(mesher.plan("aa", how));
    CHECK(provider.asked == 0);
    plan = mesher.plan("a\xD7\x90", how);
    REQUIRE(plan);
    CHECK(plan->report().missing == 0);
    CHECK(provider.script == script_tag("Hebr"));
    CHECK(provider.language == "he");
    CHECK(fonts.face_count() == 2);
    CHECK(&fonts.font(1) == &provider.fonts[0]);
    plan = mesher.plan("edcb!", how);
    REQUIRE(plan);
    CHECK(plan->report().missing == 1);
    CHECK(fonts.face_count() == 3);
    const std::size_t asked = provider.asked;
    plan = mesher.plan("abcde\xD7\x90", how);
    REQUIRE(plan);
    CHECK(plan->report().missing == 0);
    CHECK(provider.asked == asked);
    provider.fails = true;
    CHECK(mesher.plan("z").error() == error::refused_by_user);
}

TEST_CASE("a list of fonts reports a memory that gives nothing", "[text][fallback]")
{
    toy_covering_font first{U"a"}, second{U"b"};
    test::counting_memory failing{.fail_at = 1};
    font_list fonts{first, failing.source()};
    CHECK(fonts.add(second).error() == error::out_of_memory);
    CHECK(fonts.face_count() == 1);
}

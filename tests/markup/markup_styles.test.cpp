// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/marked_documents.hpp"

#include <typemesh/markup/markup_styles.hpp>

#include <string>
#include <string_view>

using namespace typemesh;

namespace {

/// Two fonts: [font=a] and [font=b]; bold letters take more room.
struct two_fonts {
    template <class Char>
    error operator()(const basic_markup_look<Char>& look, text_style& style) const noexcept
    {
        if (look.has(markup_tag::bold)) style.letter_spacing += 0.03;
        if (!look.has(markup_tag::font)) return {};
        if (look.font.size() != 1 || (look.font[0] != 'a' && look.font[0] != 'b')) return error::no_such_face;
        style.face = look.font[0] == 'b' ? 1 : 0;
        return {};
    }
};

/// Any font.
struct any_font {
    template <class Char>
    error operator()(const basic_markup_look<Char>&, text_style&) const noexcept
    {
        return {};
    }
};

}  // namespace

TEST_CASE("tags become the members of styles", "[markup]")
{
    markup read;
    REQUIRE(
        read.read("x[i][u][o]a[/][/][/][s]b[/][sup]c[/][sub][size=2][rise=-1][spacing=.5]d[/][/][/][/]"
                  "[lang=ja]e[/][font=b][b]f[/b][lang=zh-Hant]g"));
    markup_styles styles;
    REQUIRE(styles.set(read, two_fonts{}));
    REQUIRE(styles.spans().size() == 7);
    const auto style = [&](std::size_t i) { return styles.spans()[i].style; };
    CHECK(styles.spans()[0].first == 1);
    CHECK(styles.spans()[6].last == 8);
    CHECK(style(0).slant == Approx(0.2));
    CHECK(style(0).decorations == (decoration::underline | decoration::overline));
    CHECK(style(1).decorations == decoration::strike_through);
    CHECK(style(2).position == script_position::superscript);
    CHECK(style(3).position == script_position::subscript);
    CHECK(style(3).size == Approx(2.0));
    CHECK(style(3).rise == Approx(-1.0));
    CHECK(style(3).letter_spacing == Approx(0.5));
    CHECK(style(4).language == "ja");
    CHECK(style(5).face == 1);
    CHECK(style(5).letter_spacing == Approx(0.03));
    CHECK(style(6).language == "zh-Hant");
    REQUIRE(styles.paints().size() == 2);  // only bold letters have a solid of their own
    CHECK(style(4).style == style_id{0});
    CHECK(style(5).style == style_id{1});
    CHECK(styles.solids()[1].has(markup_tag::bold));
}

TEST_CASE("a style's number finds its colour and its solid, each of which is listed once", "[markup]")
{
    basic_markup<char16_t> read;
    REQUIRE(
        read.read(u"[colour=#f00]a[depth=0.5]b[i]c[/i][/][/][depth=0.5]d[bevel=.1][style=9]e[/][/][/][colour=#f00]f"));
    markup_styles styles;
    REQUIRE(styles.set(read));
    const auto spans = styles.spans();
    REQUIRE(spans.size() == 6);
    const auto paint = [&](std::size_t i) { return styles.paints()[static_cast<std::size_t>(spans[i].style.style)]; };
    CHECK(styles.paints().size() == 5);
    CHECK(styles.solids().size() == 3);
    CHECK(paint(0).has(markup_tag::colour));
    CHECK(paint(0).colour == 0xff0000);
    CHECK(paint(0).solid == 0);
    CHECK(paint(1) == paint(2));
    CHECK(paint(1).colour == 0xff0000);
    CHECK_FALSE(paint(3).has(markup_tag::colour));
    CHECK(paint(1).solid == paint(3).solid);
    CHECK(styles.solids()[paint(3).solid].depth == Approx(0.5));
    CHECK_FALSE(styles.solids()[paint(3).solid].has(markup_tag::bevel));
    CHECK(paint(4).style == 9);
    CHECK(styles.solids()[paint(4).solid].bevel == Approx(0.1));
    CHECK(styles.solid_of(spans[4].style.style) == paint(4).solid);
    CHECK(styles.solid_of(style_id{77}) == 0);
    CHECK(spans[5].style.style == spans[0].style.style);
}

TEST_CASE("rubies do not divide styles", "[markup]")
{
    markup read;
    REQUIRE(read.read("[ruby=x]a[/][b]b[ruby=y]c[/ruby]d[/b]"));
    markup_styles styles;
    REQUIRE(styles.set(read));
    REQUIRE(styles.spans().size() == 1);
    CHECK(styles.spans()[0].first == 1);
    CHECK(styles.spans()[0].last == 4);
    REQUIRE(read.read("[b]a[/b]b[b]c"));
    REQUIRE(styles.set(read));
    CHECK(styles.spans().size() == 2);
}

TEST_CASE("a font that the map does not have is told at its first text", "[markup]")
{
    markup read;
    REQUIRE(read.read("a[font=b]b[/][font=c]c"));
    markup_styles styles;
    const auto with_map = styles.set(read, two_fonts{});
    CHECK(with_map == error::no_such_face);
    CHECK(with_map.error().cluster == 2);
    CHECK(styles.spans().empty());
    const auto without = styles.set(read);
    CHECK(without == error::no_such_face);
    CHECK(without.error().cluster == 1);
}

TEST_CASE("styles of mark-up allocate nothing after warm-up, and tell when memory fails", "[markup]")
{
    const std::string source = test::utf8_of(test::marked_document{5, 400}.source);
    markup read;
    REQUIRE(read.read(source));
    test::counting_memory counted;
    markup_styles styles{counted.source()};
    REQUIRE(styles.set(read, any_font{}));
    const std::size_t before = counted.requests;
    REQUIRE(styles.set(read, any_font{}));
    CHECK(counted.requests == before);
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 100; ++n) {
        test::counting_memory failing{.fail_at = n};
        markup_styles poor{failing.source()};
        const auto done = poor.set(read, any_font{});
        if (done) break;
        ++failures;
        CHECK(done == error::out_of_memory);
        CHECK(poor.spans().empty());
    }
    CHECK(failures > 5);
}

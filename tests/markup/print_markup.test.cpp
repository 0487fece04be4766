// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/marked_documents.hpp"

#include <typemesh/markup/print_markup.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;

namespace {

template <class Char>
std::basic_string<Char> printed(const basic_markup<Char>& read)
{
    buffer<Char> out;
    REQUIRE(print_markup(read, out));
    return {out.data(), out.size()};
}

template <class A, class B>
bool equal(const A& a, const B& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

template <class Char>
void check_round_trip(const std::basic_string<Char>& source)
{
    basic_markup<Char> first, second;
    REQUIRE(first.read(source));
    const auto once = printed(first);
    REQUIRE(second.read(once));
    CHECK(second.text() == first.text());
    CHECK(equal(second.spans(), first.spans()));
    CHECK(equal(second.looks(), first.looks()));
    CHECK(equal(second.rubies(), first.rubies()));
    CHECK(printed(second) == once);
}

/// Why a text of one span is not printed.
std::string refused(const basic_markup_look<char>& look, markup_span span = {0, 1, 1, 0}, std::string_view ruby = "r")
{
    const basic_markup_look<char> looks[] = {{}, look};
    buffer<char> out;
    const auto done = print_markup<char>(
        {"ab", array_view<const markup_span>{&span, 1}, looks, array_view<const std::string_view>{&ruby, 1}}, out);
    return done ? "" : done.error().option;
}

std::uint32_t only(markup_tag t) { return 1u << static_cast<unsigned>(t); }

}  // namespace

TEST_CASE("what is printed is read as the same text, spans, looks and rubies, in both encodings", "[markup]")
{
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO(seed);
        const test::marked_document d{seed};
        check_round_trip(test::utf8_of(d.source));
        if (seed < 50) check_round_trip(test::utf16_of(d.source));
    }
}

TEST_CASE("mark-up is printed in the shortest form of its numbers, each tag closed", "[markup]")
{
    markup read;
    REQUIRE(read.read("[[[size=01.50][color=#C0F]a[b]b[/][rise=-0.000001][depth=10]c"));
    CHECK(printed(read) ==
          "[[[size=1.5][colour=#cc00ff]a[/colour][/size][b][size=1.5][colour=#cc00ff]b[/colour][/size][/b]"
          "[size=1.5][rise=-0.000001][depth=10][colour=#cc00ff]c[/colour][/depth][/rise][/size]");
    REQUIRE(read.read("[ruby=x]a[i]b[/i][/ruby][ruby=x]c"));
    CHECK(printed(read) == "[ruby=x]a[i]b[/i][/ruby][ruby=x]c[/ruby]");
}

TEST_CASE("what no tag can express is refused by its name", "[markup]")
{
    CHECK(refused({.tags = only(markup_tag::size), .size = 1.5}) == "");
    CHECK(refused({.tags = only(markup_tag::size), .size = 0.0}) == "size");
    CHECK(refused({.tags = only(markup_tag::size), .size = 1.0 / 3.0}) == "size");
    CHECK(refused({.tags = only(markup_tag::rise), .rise = 1000.5}) == "rise");
    CHECK(refused({.tags = only(markup_tag::depth), .depth = -1.0}) == "depth");
    CHECK(refused({.tags = only(markup_tag::colour), .colour = 0x100'0000}) == "colour");
    CHECK(refused({.tags = only(markup_tag::style), .style = 0xFFFF'FFFF}) == "style");
    CHECK(refused({.tags = only(markup_tag::font), .font = ""}) == "font");
    CHECK(refused({.tags = only(markup_tag::font), .font = "]\"'"}) == "font");
    CHECK(refused({.tags = only(markup_tag::font), .font = "a\"'"}) == "");
    CHECK(refused({.tags = only(markup_tag::language), .language = "d e"}) == "lang");
    CHECK(refused({}, {0, 3, 0, 0}) == "spans");
    CHECK(refused({}, {1, 0, 0, 0}) == "spans");
    CHECK(refused({}, {0, 1, 2, 0}) == "look");
    CHECK(refused({}, {0, 1, 0, 2}) == "ruby");
    CHECK(refused({}, {0, 1, 0, 1}, "") == "ruby");
    const markup_span two[] = {{1, 2, 0, 0}, {0, 1, 0, 0}};
    buffer<char> out;
    CHECK(print_markup<char>({"ab", two, {}, {}}, out) == error::bad_option);
}

TEST_CASE("printing tells when memory fails", "[markup]")
{
    const std::string source = test::utf8_of(test::marked_document{3, 200}.source);
    markup read;
    REQUIRE(read.read(source));
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 100; ++n) {
        test::counting_memory failing{.fail_at = n};
        buffer<char> out{failing.source()};
        const auto done = print_markup(read, out);
        if (done) break;
        ++failures;
        CHECK(done == error::out_of_memory);
    }
    CHECK(failures > 3);
}

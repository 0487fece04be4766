// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/marked_documents.hpp"

#include <typemesh/markup/markup.hpp>

#include <string>
#include <string_view>
#include <vector>

using namespace typemesh;

namespace {

/// The values of each unit of a document's text, rubies counted as values_of() counts them.
template <class Text>
std::vector<test::tag_values> expected_values(const test::marked_document& d, const Text& encode)
{
    std::vector<test::tag_values> all;
    std::string last;
    int rubies = 0;
    for (std::size_t i = 0; i < d.text.size(); ++i) {
        test::tag_values v = d.looks[i];
        if (const auto ruby = v.find("ruby"); ruby != v.end()) {
            if (ruby->second != last) ++rubies;
            last = ruby->second;
            ruby->second = std::to_string(rubies) + last.substr(last.find(':'));
        }
        all.insert(all.end(), encode(d.text.substr(i, 1)).size(), v);
    }
    return all;
}

template <class Char, class Encode>
void check_document(const test::marked_document& d, const Encode& encode, basic_markup<Char>& read)
{
    const auto source = encode(d.source);
    REQUIRE(read.read(source));
    CHECK(read.text() == encode(d.text));
    CHECK(test::values_of(read) == expected_values(d, encode));
    std::uint32_t at = 0;
    const markup_span* before = nullptr;
    for (const markup_span& s : read.spans()) {
        CHECK(s.first >= at);
        CHECK(s.last > s.first);
        CHECK((s.look != 0 || s.ruby != 0));
        if (before != nullptr && before->last == s.first)
            CHECK_FALSE((before->look == s.look && before->ruby == s.ruby));
        at = s.last;
        before = &s;
    }
    for (std::size_t i = 0; i < read.looks().size(); ++i)
        for (std::size_t k = i + 1; k < read.looks().size(); ++k) CHECK_FALSE(read.looks()[i] == read.looks()[k]);
}

template <class Text>
constexpr bool is_read = requires(markup& m, Text&& text) { m.read(static_cast<Text&&>(text)); };

std::string mistake_in(std::string_view source)
{
    markup read;
    const auto done = read.read(source);
    if (done) return "none";
    CHECK(done.error() == error::bad_markup);
    CHECK(read.text().empty());
    CHECK(read.spans().empty());
    return std::to_string(done.error().cluster) + " " + done.error().option;
}

}  // namespace

TEST_CASE("each unit has the innermost open tag of each kind, nested or crossed, in both encodings", "[markup]")
{
    basic_markup<char> narrow;
    basic_markup<char16_t> wide;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        INFO(seed);
        const test::marked_document d{seed};
        check_document(d, [](const std::u32string& s) { return test::utf8_of(s); }, narrow);
        if (seed < 100) check_document(d, [](const std::u32string& s) { return test::utf16_of(s); }, wide);
    }
}

TEST_CASE("a mistake in mark-up is told with its place", "[markup]")
{
    CHECK(mistake_in("a[b") == "1 a tag without its ]");
    CHECK(mistake_in("a[") == "1 a tag without its ]");
    CHECK(mistake_in("[size=1") == "0 a tag without its ]");
    CHECK(mistake_in("[font=\"a\"") == "0 a tag without its ]");
    CHECK(mistake_in("[b]x[bold]") == "4 an unknown tag");
    CHECK(mistake_in("[]") == "0 an unknown tag");
    CHECK(mistake_in("[B]") == "0 an unknown tag");
    CHECK(mistake_in("[ b]") == "0 an unknown tag");
    CHECK(mistake_in("[spacings=1]") == "0 an unknown tag");
    CHECK(mistake_in("[size]") == "0 a tag without its value");
    CHECK(mistake_in("[b=1]") == "0 a value for a tag without values");
    CHECK(mistake_in("[size=1]x[/size=1]") == "9 a value in a closing tag");
    CHECK(mistake_in("[font=]") == "6 an empty value");
    CHECK(mistake_in("[font='']") == "6 an empty value");
    CHECK(mistake_in("[font='a]") == "6 a value without its second quotation mark");
    CHECK(mistake_in("[font='a'b]") == "9 something behind a quotation mark");
    CHECK(mistake_in("x[/b]") == "1 a closing tag without its opening tag");
    CHECK(mistake_in("[/]") == "0 a closing tag without its opening tag");
    CHECK(mistake_in("[b]x[/i]") == "4 a closing tag without its opening tag");
    CHECK(mistake_in("[b]x[/b][/b]") == "8 a closing tag without its opening tag");
    CHECK(mistake_in("[ruby=a]x[ruby=b]y") == "9 a ruby within a ruby");
    CHECK(mistake_in("[colour=red]") == "8 a colour that is not like #c33 or #cc3333");
    CHECK(mistake_in("[style=-1]") == "7 a style that is not a whole number below 4294967295");
    CHECK(mistake_in("[lang=d_e]") == "6 a language that is not like ja or zh-Hant");
    CHECK(mistake_in("[[b] [/b") == "5 a tag without its ]");
    CHECK(mistake_in("a]b[[/b]") == "none");
}

TEST_CASE("what cannot be seen leaves no span: tags around nothing, and tags at the end", "[markup]")
{
    markup read;
    REQUIRE(read.read("a[b][/b][ruby=x][/ruby]b[size=2]"));
    CHECK(read.text() == "ab");
    CHECK(read.spans().empty());
    CHECK(read.looks().empty());
    CHECK(read.rubies().empty());
    REQUIRE(read.read("[b][i][/b][/i]a"));  // tags that cross around nothing
    CHECK(read.looks().empty());
    REQUIRE(read.read("a[b]b"));
    CHECK(read.spans().size() == 1);
    CHECK(read.spans()[0] == markup_span{1, 2, 1, 0});
}

TEST_CASE("each ruby has the whole range of its text", "[markup]")
{
    markup read;
    REQUIRE(read.read("a[ruby=x]b[b]c[/b]d[/ruby][b]e[ruby=y]f[/][ruby=z]g"));
    std::string seen;
    read.each_ruby([&](std::uint32_t first, std::uint32_t last, std::string_view ruby, std::uint32_t look) {
        seen += std::to_string(first) + ".." + std::to_string(last) + std::string{ruby} + std::to_string(look) + " ";
    });
    CHECK(seen == "1..4x0 5..6y1 6..7z1 ");
}

TEST_CASE("words of tags are views of the source", "[markup]")
{
    const std::string source = "[font=\"Noto ]\"]x[/font][ruby=abc]y";
    markup read;
    REQUIRE(read.read(source));
    CHECK(read.looks()[1].font == "Noto ]");
    CHECK(read.looks()[1].font.data() == source.data() + 7);
    CHECK(read.rubies()[0].data() == source.data() + 29);
    CHECK(is_read<const std::string&>);
    CHECK_FALSE(is_read<std::string>);  // it would be gone
}

TEST_CASE("a million tags are read, however they are nested and crossed", "[markup]")
{
    constexpr std::size_t count = 250'000;
    std::string source;
    for (std::size_t i = 0; i < count; ++i) source += i % 2 == 0 ? "[b]x" : "[i]y";
    for (std::size_t i = 0; i < count; ++i) source += i < count / 2 ? "[/b]z" : "[/i]z";  // all cross
    for (std::size_t i = 0; i < 2 * count; ++i) source += "[style=" + std::to_string(i) + "]x";
    markup read;
    REQUIRE(read.read(source));
    CHECK(read.text().size() == 4 * count);
    CHECK(read.looks().size() == 2 * count + 4);  // plain, b, b and i, i
    CHECK(read.spans().size() == 2 * count + 3);
    CHECK(read.spans().back().last == 4 * count);
}

TEST_CASE("mark-up allocates nothing after warm-up, and tells when memory fails", "[markup]")
{
    test::counting_memory counted;
    std::string sources[8];
    for (std::uint32_t seed = 0; seed < 8; ++seed)
        sources[seed] = test::utf8_of(test::marked_document{seed, 200}.source);
    {
        markup read{counted.source()};
        for (const std::string& s : sources) REQUIRE(read.read(s));
        const std::size_t before = counted.requests;
        for (const std::string& s : sources) REQUIRE(read.read(s));
        CHECK(counted.requests == before);
    }
    CHECK(counted.bytes_held == 0);
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 100; ++n) {
        test::counting_memory failing{.fail_at = n};
        markup read{failing.source()};
        const auto done = read.read(sources[0]);
        if (done) break;
        ++failures;
        CHECK(done.error() == error::out_of_memory);
        CHECK(read.text().empty());
        failing.fail_at = 0;
        REQUIRE(read.read(sources[0]));
    }
    CHECK(failures >= 6);
}

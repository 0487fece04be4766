// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/laid_paragraph.hpp"

#include <typemesh/paragraph/ruby_writer.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using ruby_page = test::laid_paragraph<>;

ruby_span ruby_on(std::uint32_t first, std::uint32_t last, text_view text) { return {first, last, text, style_id{3}}; }

}  // namespace

TEST_CASE("a ruby is centred above its text, and ideographs and kana are spread", "[paragraph][ruby]")
{
    ruby_page page{u"abcdef"};  // every letter is 500 wide, in a ruby 250
    const std::size_t glyphs = page.run.glyphs.size();
    ruby_writer rubies;
    const ruby_span spans[] = {ruby_on(1, 3, u"xy"), ruby_on(3, 6, u"\u3042\u3044")};
    REQUIRE(rubies.write(page.font, page.laid(), spans, {.gap = 0.1}, page.run));
    REQUIRE(page.run.glyphs.size() == glyphs + 4);
    REQUIRE(page.run.lines.size() == 3);
    CHECK(page.run.lines[1].glyph_count == 2);
    CHECK(page.run.lines[2].first_glyph == glyphs + 2);
    const double x[] = {750.0, 1000.0,    // above 500 to 1500: 250, 250, 250, 250
                        1750.0, 2500.0};  // above 1500 to 3000: 250, 250, 500, 250, 250
    for (std::size_t i = glyphs; i < glyphs + 4; ++i) {
        CHECK(page.run.glyphs[i].origin.x == Approx(x[i - glyphs]));
        CHECK(page.run.glyphs[i].origin.y == Approx(700.0 + 100.0 + 0.5 * 200.0));  // its descender is on the gap
        CHECK(page.style(i).map.xx == Approx(0.5));
        CHECK(page.style(i).style == style_id{3});
        CHECK(page.run.glyphs[i].cluster == (i < glyphs + 2 ? 1 : 3));
    }
    CHECK(rubies.overhanging == 0);
    CHECK(rubies.divided == 0);
}

TEST_CASE("a ruby that is too wide is counted and stays centred, and what has no box has no ruby", "[paragraph][ruby]")
{
    ruby_page page{u"ab cd"};
    const std::size_t glyphs = page.run.glyphs.size();
    ruby_writer rubies;
    const ruby_span wide[] = {ruby_on(1, 2, u"xyzw"), ruby_on(2, 2, u"q")};
    REQUIRE(rubies.write(page.font, page.laid(), wide, {}, page.run));
    CHECK(rubies.overhanging == 1);
    REQUIRE(page.run.glyphs.size() == glyphs + 4);
    CHECK(page.run.glyphs[glyphs].origin.x == Approx(500.0 + 250.0 - 500.0));
    page.again({.width = 1.3});
    REQUIRE(page.lines().size() == 2);
    const ruby_span over_both[] = {ruby_on(1, 4, u"x")};
    REQUIRE(rubies.write(page.font, page.laid(), over_both, {}, page.run));
    CHECK(rubies.divided == 1);
    CHECK(page.run.glyphs.back().origin.y > 0.0);  // above the first line
}

TEST_CASE("a ruby that cannot be set leaves the run as it was", "[paragraph][ruby]")
{
    ruby_page page{u"abc"};
    const std::size_t glyphs = page.run.glyphs.size(), lines = page.run.lines.size();
    const ruby_span bad[] = {ruby_on(0, 1, u"\uFFFF"), ruby_on(1, 2, u"x!")};
    {
        ruby_writer rubies;
        const auto done = rubies.write(page.font, page.laid(), bad, {}, page.run);
        CHECK(done == error::font_library_failed);
        CHECK(done.error().cluster == 1);
    }
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 60; ++n) {
        test::counting_memory failing{.fail_at = n};
        ruby_writer poor{failing.source()};
        const auto done = poor.write(page.font, page.laid(), {bad, 1}, {}, page.run);
        if (done) break;
        ++failures;
        CHECK(done == error::out_of_memory);
        CHECK(page.run.glyphs.size() == glyphs);
        CHECK(page.run.lines.size() == lines);
        CHECK(page.run.missing == 0);
    }
    CHECK(failures > 5);
    CHECK(page.run.missing == 1);
    ruby_writer rubies;
    const ruby_span two_lines = ruby_on(0, 1, u"x\ny");
    CHECK(rubies.write(page.font, page.laid(), {&two_lines, 1}, {}, page.run) == error::bad_option);
    for (const double size : {0.0, -1.0, 1.5})
        CHECK(rubies.write(page.font, page.laid(), bad, {.size = size}, page.run) == error::bad_option);
    test::counting_memory counted;
    ruby_writer warm{counted.source()};
    REQUIRE(warm.write(page.font, page.laid(), {bad, 1}, {}, page.run));
    const std::size_t before = counted.requests;
    REQUIRE(warm.write(page.font, page.laid(), {bad, 1}, {}, page.run));
    CHECK(counted.requests == before);
}

namespace {

/// A text whose rubies have rooms.
struct roomy_page {
    test::toy_shaper font;
    ruby_writer rubies;
    std::vector<ruby_span> spans;
    ruby_options how;
    paragraph<test::toy_shaper> words{font};
    glyph_run run;
    std::size_t letters = 0, lines = 0;

    roomy_page(text_view text, std::vector<ruby_span> above, const ruby_options& options = {},
               const layout_options& layout = {}, shape_options shape = {})
        : spans{std::move(above)}, how{options}
    {
        how.shape.direction = shape.direction == direction::top_to_bottom ? shape.direction : direction::automatic;
        const auto rooms = rubies.rooms(font, text, spans, how);
        REQUIRE(rooms);
        shape.rooms = *rooms;
        REQUIRE(words.set(text, shape));
        again(layout);
    }
    void again(const layout_options& layout)
    {
        REQUIRE(words.lay_out(layout, run));
        letters = run.glyphs.size();
        lines = run.lines.size();
        REQUIRE(rubies.write(font, words.laid(), spans, how, run));
    }
    /// From the left of the first to the right of the last glyph of a range, as they are drawn; y of the last.
    struct extent {
        double low = 1e9, high = -1e9, y = 0.0;
        std::size_t count = 0;
        [[nodiscard]] double middle() const { return 0.5 * (low + high); }
    };
    [[nodiscard]] extent base(const ruby_span& s) const
    {
        extent e;
        for (std::size_t i = 0; i < letters; ++i)
            if (run.glyphs[i].cluster >= s.first && run.glyphs[i].cluster < s.last) add(e, run.glyphs[i], 500.0);
        return e;
    }
    [[nodiscard]] extent ruby(std::size_t number) const
    {
        extent e;
        const text_line& line = run.lines[lines + number];
        for (std::size_t i = 0; i < line.glyph_count; ++i) add(e, run.glyphs[line.first_glyph + i], 250.0);
        return e;
    }
    static void add(extent& e, const placed_glyph& g, double width)
    {
        e.low = std::min(e.low, g.origin.x);
        e.high = std::max(e.high, g.origin.x + width);
        e.y = g.origin.y;
        ++e.count;
    }
};

}  // namespace

TEST_CASE("with rooms a wide ruby spreads its text and its line leaves space for it", "[paragraph][ruby]")
{
    roomy_page p{u"a\u6F22\u5B57b", {ruby_on(1, 3, u"uvwxyz")}, {.gap = 0.1}};  // 1500 above 1000
    const double x[] = {0.0, 625.0, 1375.0, 2000.0, 500.0, 750.0, 1000.0, 1250.0, 1500.0, 1750.0};
    REQUIRE(p.run.glyphs.size() == 10);
    for (std::size_t i = 0; i < 10; ++i) CHECK(p.run.glyphs[i].origin.x == Approx(x[i]));
    CHECK(p.run.glyphs[9].origin.y == Approx(700.0 + 100.0 + 0.5 * 200.0));
    CHECK(p.words.lines()[0].metrics.ascender == Approx(700.0 + 100.0 + 0.5 * 900.0));  // the top of the ruby
    CHECK(p.rubies.overhanging == 0);
}

TEST_CASE("mono rubies let a line end between characters, and a group ruby does not", "[paragraph][ruby]")
{
    const std::u16string text = u"\u6771\u4EAC";
    roomy_page mono{text, {ruby_on(0, 1, u"\u3068\u3046"), ruby_on(1, 2, u"\u304D\u3087\u3046")}, {}, {.width = 0.8}};
    CHECK(mono.words.lines().size() == 2);
    CHECK(mono.ruby(1).middle() == Approx(mono.base({1, 2}).middle()));
    CHECK(mono.ruby(1).y < mono.ruby(0).y);
    CHECK(mono.run.glyphs[mono.letters].origin.x == 0.0);
    roomy_page group{text, {ruby_on(0, 2, u"\u3068\u3046\u304D\u3087\u3046")}, {}, {.width = 0.8}};
    CHECK(group.words.lines().size() == 1);
    CHECK(group.ruby(0).middle() == Approx(group.base({0, 2}).middle()));
}

TEST_CASE("a ruby may reach over kana without rubies, and keeps to its line", "[paragraph][ruby]")
{
    const auto wide = ruby_on(1, 2, u"uvwx");  // 1000 above 500
    const ruby_options over{.overhang = 0.25};
    const auto step = [&](text_view text, const std::vector<ruby_span>& spans) {
        const roomy_page p{text, spans, over};
        CHECK(p.rubies.overhanging == 0);
        const auto base = p.base(wide);
        return std::vector<double>{base.low, p.ruby(spans.size() - 1).low, p.run.glyphs[2].origin.x};
    };
    // between kana it reaches over both; beside a letter, an ideograph or a kana with a ruby it does not
    CHECK(step(u"\u3042\u6F22\u3044", {wide}) == std::vector<double>{500.0, 250.0, 1000.0});
    CHECK(step(u"a\u6F22\u3044", {wide}) == std::vector<double>{625.0, 500.0, 1250.0});
    CHECK(step(u"\u3042\u6F22\u5B57", {wide}) == std::vector<double>{625.0, 250.0, 1250.0});
    CHECK(step(u"\u3042\u6F22\u3044", {ruby_on(0, 1, u"u"), wide}) == std::vector<double>{625.0, 500.0, 1250.0});
    const roomy_page begins{u"\u6F22\u3044", {ruby_on(0, 1, u"uvwx")}, over};
    CHECK(begins.ruby(0).low == 0.0);
    const roomy_page ends{u"\u3042\u6F22", {wide}, over, {.width = 1.25}};
    CHECK(ends.ruby(0).high == Approx(1e3 * 1.25));
    roomy_page parted{u"\u3042\u6F22\u3044", {wide}, over, {.width = 0.9}};  // a line of its own
    CHECK(parted.words.lines().size() == 3);
    CHECK(parted.ruby(0).middle() == Approx(parted.base(wide).middle()));
}

TEST_CASE("in a font that is higher than an em, a ruby stands on the em", "[paragraph][ruby]")
{
    ruby_page p{u"abcdef"};
    p.font.lines = {1100.0, -400.0, 0.0};  // 1.5 em, as M+ has
    const ruby_span spans[] = {ruby_on(1, 3, u"xy")};
    ruby_writer rubies;
    const auto rooms = rubies.rooms(p.font, u"abcdef", spans, {});
    REQUIRE(rooms);
    const double top = (1100.0 + 0.5 * 1500.0) / 1.5;  // of the ruby
    CHECK((*rooms)[0].above == Approx((top - 1100.0) / 1000.0));
    REQUIRE(p.words.set(u"abcdef", {.rooms = *rooms}));
    p.again({});
    REQUIRE(rubies.write(p.font, p.laid(), spans, {}, p.run));
    CHECK(p.run.glyphs.back().origin.y == Approx((1100.0 + 0.5 * 400.0) / 1.5));
    CHECK(p.words.lines()[0].metrics.ascender == Approx(top));
}

TEST_CASE("a ruby stands on its own text, whatever is higher in the line", "[paragraph][ruby]")
{
    const style_span styles[] = {{0, 1, {.size = 3.0}}, {2, 3, {.size = 2.0, .rise = 0.1}}};
    roomy_page p{u"abcd", {ruby_on(1, 2, u"x"), ruby_on(2, 3, u"y")}};
    ruby_writer rubies;
    const auto rooms = rubies.rooms(p.font, u"abcd", p.spans, {});
    REQUIRE(p.words.set(u"abcd", {.styles = styles, .rooms = *rooms}));
    p.again({});
    CHECK(p.ruby(0).y == Approx(700.0 + 100.0));
    CHECK(p.ruby(1).y == Approx(1400.0 + 100.0 + 100.0));
    CHECK(p.words.lines()[0].metrics.ascender == Approx(2100.0));
}

TEST_CASE("in columns rubies stand to the right of their text, from top to bottom", "[paragraph][ruby]")
{
    const roomy_page p{u"a\u6F22\u5B57b",
                       {ruby_on(1, 3, u"\u3042\u3044\u3046\u3048\u304A")},
                       {.gap = 0.1},
                       {},
                       {.direction = direction::top_to_bottom}};
    const line_metrics column = p.font.metrics(direction::top_to_bottom);
    REQUIRE(p.run.glyphs.size() == 9);
    const point from = p.run.glyphs[4].origin, to = p.run.glyphs[8].origin;
    CHECK(from.x == Approx(to.x));
    CHECK(from.x == Approx(column.ascender + 100.0 - 0.5 * column.descender));
    CHECK(from.y - to.y == Approx(4 * 250.0));
    // both have the same middle: the ruby is 1250 long, each of its letters 250, the letters of the text 500
    CHECK(0.5 * (from.y + to.y - 250.0) == Approx(0.5 * (p.run.glyphs[1].origin.y + p.run.glyphs[2].origin.y - 500.0)));
    CHECK(p.words.lines()[0].metrics.ascender ==
          Approx(column.ascender + 100.0 + 0.5 * (column.ascender - column.descender)));
}

TEST_CASE("in 10000 random texts every ruby is centred above its text, in one line with all of it", "[paragraph][ruby]")
{
    std::mt19937 random{11};
    const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
    std::size_t divided = 0, wide = 0;
    for (int i = 0; i < 10000; ++i) {
        constexpr char16_t letters[] = u"abcd  \u6F22\u5B57\u3042\u3044\u05D0\u05D1";
        std::u16string text;
        for (std::uint32_t n = 2 + below(14); n > 0; --n) text += letters[below(12)];
        std::vector<ruby_span> spans;
        const std::u16string above = u"uvwxyz";
        for (std::uint32_t at = below(3); at < text.size();) {
            const std::uint32_t last = at + 1 + below(3);
            if (last > text.size()) break;
            const bool hebrew = text.find_first_of(u"\u05D0\u05D1 ", at) < last && last - at > 1;  // may be divided
            if (text[at] != u' ' && !hebrew)
                spans.push_back({at, last, text_view{std::u16string_view{above}.substr(0, 1 + below(6))}, style_id{1}});
            at = last + below(3);
        }
        const layout_options layout{.width = 0.6 + 0.4 * below(12),
                                    .align = static_cast<alignment>(below(6)),
                                    .justify = static_cast<justification>(below(3))};
        const shape_options shape{.letter_spacing = below(3) == 0 ? 0.1 : 0.0};
        const roomy_page p{text, spans, {}, layout, shape};
        divided += p.rubies.divided;
        REQUIRE(p.rubies.overhanging == 0);
        bool sound = p.run.lines.size() - p.lines == spans.size();
        for (std::size_t k = 0; k < spans.size() && sound; ++k) {
            const auto base = p.base(spans[k]), ruby = p.ruby(k);
            wide += ruby.high - ruby.low > 500.0 * (spans[k].last - spans[k].first) ? 1u : 0u;
            sound = std::fabs(base.middle() - ruby.middle()) < 1e-6 && ruby.y > base.y && base.count != 0;
            for (std::size_t j = 0; j < k; ++j) {
                const auto other = p.ruby(j);
                sound = sound && (std::fabs(other.y - ruby.y) > 1.0 || other.high <= ruby.low + 1e-6 ||
                                  ruby.high <= other.low + 1e-6);
            }
            for (std::size_t g = 0; g < p.letters; ++g)  // all of the text is in one line
                if (p.run.glyphs[g].cluster >= spans[k].first && p.run.glyphs[g].cluster < spans[k].last)
                    sound = sound && std::fabs(p.run.glyphs[g].origin.y - base.y) < 1e-9;
        }
        REQUIRE(sound);
    }
    CHECK(divided == 0);
    CHECK(wide > 5000);
}

TEST_CASE("rooms are refused for what has no room, and allocate nothing after warm-up", "[paragraph][ruby]")
{
    test::toy_shaper font;
    ruby_writer rubies;
    const auto refused = [&](const ruby_span& s, const ruby_options& how = {}) {
        const auto done = rubies.rooms(font, u"abc", {&s, 1}, how);
        return done ? std::string{} : std::string{done.error().option != nullptr ? done.error().option : "shaper"};
    };
    CHECK(refused(ruby_on(1, 3, u"x")).empty());
    CHECK(refused(ruby_on(2, 1, u"x")) == "spans");
    CHECK(refused(ruby_on(1, 4, u"x")) == "spans");
    CHECK(refused(ruby_on(0, 1, u"!")) == "shaper");
    CHECK(refused(ruby_on(0, 1, u"x\ny")) == "spans");
    CHECK(refused(ruby_on(0, 1, u"x"), {.overhang = 1.5}) == "overhang");
    const ruby_span spans[] = {ruby_on(1, 3, u"xyzxyz"), ruby_on(0, 1, u"x")};
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 60; ++n) {
        test::counting_memory failing{.fail_at = n};
        ruby_writer poor{failing.source()};
        const auto done = poor.rooms(font, u"abc", spans, {});
        if (done) break;
        ++failures;
        CHECK((done.error() == error::out_of_memory));
    }
    CHECK(failures > 5);
    test::counting_memory counted;
    ruby_writer warm{counted.source()};
    REQUIRE(warm.rooms(font, u"abc", spans, {}));
    const std::size_t before = counted.requests;
    const auto rooms = warm.rooms(font, u"abc", spans, {});
    REQUIRE(rooms);
    CHECK(counted.requests == before);
    CHECK((*rooms)[0].first == 0);
    CHECK((*rooms)[1].width == Approx(1.5));
}

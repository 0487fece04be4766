// SPDX-License-Identifier: MIT
#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/laid_out.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

using test::amiri;
using test::dejavu;
using test::inter;
using test::microhei;
using test::opened;
using test::sawarabi;

const char* const lohit = "truetype/lohit-devanagari/Lohit-Devanagari.ttf";

glyph_run shaped(harfbuzz_font& font, text_view text, const shape_options& how = {})
{
    return test::shaped(font, text, how, {.align = alignment::left});
}

error refusal(harfbuzz_font& font, text_view text, const shape_options& how = {})
{
    glyph_run run;
    return layout(font, text, how, {}, run).error();
}

std::vector<cluster_id> clusters(const glyph_run& run)
{
    std::vector<cluster_id> all;
    for (const placed_glyph& g : run.glyphs) all.push_back(g.cluster);
    return all;
}

std::vector<glyph_id> ids(const glyph_run& run)
{
    std::vector<glyph_id> all;
    for (const placed_glyph& g : run.glyphs) all.push_back(g.id);
    return all;
}

std::vector<point> points_of(harfbuzz_font& font, glyph_id id)
{
    outline o;
    REQUIRE(record(font, id, o));
    std::vector<point> all;
    for (const curve& c : o.curves) all.insert(all.end(), c.p, c.p + c.degree + 1);
    return all;
}

bool same_run(const glyph_run& a, const glyph_run& b, double within = 0.0)
{
    if (a.glyphs.size() != b.glyphs.size()) return false;
    for (std::size_t i = 0; i < a.glyphs.size(); ++i) {
        const placed_glyph &g = a.glyphs[i], &h = b.glyphs[i];
        if (g.id != h.id || g.cluster != h.cluster || length(g.origin - h.origin) > within) return false;
    }
    return true;
}

template <class Text>
shape_options with(direction d, Text script)
{
    shape_options how;
    how.direction = d;
    how.script = script;
    return how;
}

}  // namespace

TEST_CASE("Latin text is set glyph by glyph, in order, by the font's advances", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    CHECK(font.units_per_em() == 2048.0);
    const glyph_run run = shaped(font, "Hello world!");
    CHECK(clusters(run) == std::vector<cluster_id>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    CHECK(run.missing == 0);
    CHECK(run.invalid_units == 0);
    CHECK(run.glyphs[0].origin == point{0.0, 0.0});
    for (std::size_t i = 1; i < run.glyphs.size(); ++i) CHECK(run.glyphs[i].origin.x > run.glyphs[i - 1].origin.x);
    CHECK(run.lines[0].advance > run.glyphs.back().origin.x);
}

TEST_CASE("lines stand as far apart as the font says", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const line_metrics m = font.metrics(direction::automatic);
    CHECK(m.ascender == 1901.0);
    CHECK(m.descender == -483.0);
    CHECK(m.gap == 0.0);
    CHECK(shaped(font, "a\nb").lines[1].origin == point{0.0, -2384.0});
}

TEST_CASE("Arabic comes in drawing order, its clusters descending, its letters joined", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(amiri);
    const std::u8string text = u8"مرحبا بالعالم!";
    const glyph_run run = shaped(font, text);
    REQUIRE(run.glyphs.size() >= 10);
    for (std::size_t i = 1; i < run.glyphs.size(); ++i) {
        CHECK(run.glyphs[i].cluster < run.glyphs[i - 1].cluster);
        CHECK(run.glyphs[i].origin.x >= run.glyphs[i - 1].origin.x);
    }
    CHECK(run.glyphs[0].cluster == text.size() - 1);  // "!" is drawn leftmost
    CHECK(run.glyphs.back().cluster == 0);
    CHECK(run.missing == 0);

    // Joined: the first letter is not the one that stands alone.
    const glyph_run alone = shaped(font, u8"م");
    REQUIRE(alone.glyphs.size() == 1);
    CHECK(run.glyphs.back().id != alone.glyphs[0].id);

    // In UTF-16 the same glyphs, with clusters in units of 16 bits.
    const glyph_run wide = shaped(font, u"مرحبا بالعالم!");
    CHECK(ids(wide) == ids(run));
    CHECK(wide.glyphs[0].cluster == 13);
}

TEST_CASE("a letter joins across the end of what is shaped, for the text round it is context", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const std::u16string text = u"بب";
    const glyph_run whole = shaped(font, text);
    buffer<shaped_glyph> halves;
    for (const std::uint32_t first : {0u, 1u})
        REQUIRE_FALSE(font.shape(text, {.first = first, .last = first + 1, .script = script_tag("Arab"), .level = 1},
                                 {}, halves));
    REQUIRE(whole.glyphs.size() == 2);
    CHECK(halves[0].id == whole.glyphs[1].id);
    CHECK(halves[1].id == whole.glyphs[0].id);
    CHECK(halves[1].cluster == 1);

    const glyph_run lines = shaped(font, u"ب\nب");  // but not across a line break
    CHECK(lines.glyphs[0].id == lines.glyphs[1].id);
    CHECK(lines.glyphs[0].id != whole.glyphs[0].id);
}

TEST_CASE("ligatures are there by default and go when switched off", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    CHECK(shaped(font, "office").glyphs.size() < 6);
    const feature off[] = {{"liga", 0}};
    shape_options how;
    how.features = off;
    CHECK(shaped(font, "office", how).glyphs.size() == 6);
    CHECK(shaped(font, "office").glyphs.size() < 6);  // no longer

    const feature nonsense[] = {{"\x01iga", 1}};
    how.features = nonsense;
    CHECK(refusal(font, "office", how) == error::bad_feature);
    const feature cut[] = {{"lig", 1}};
    how.features = cut;
    CHECK(refusal(font, "office", how) == error::bad_feature);
}

TEST_CASE("spaced letters have no ligatures unless a feature names them", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    glyph_run run;
    shape_options how{.letter_spacing = 0.1};
    REQUIRE(layout(font, "office", how, {}, run));
    REQUIRE(run.glyphs.size() == 6);
    how.letter_spacing = 0.0;
    how.ligatures = false;
    const glyph_run apart = shaped(font, "office", how);
    for (std::size_t i = 0; i < 6; ++i) {
        const double shift = run.glyphs[i].origin.x - apart.glyphs[i].origin.x;
        CHECK(std::fabs(shift - 0.1 * font.units_per_em() * static_cast<double>(i)) < 1e-9);
    }
    const feature on[] = {{"liga", 1}};
    how.features = on;
    CHECK(shaped(font, "office", how).glyphs.size() < 6);
    const glyph_run joined = shaped(font, u"سلام");
    REQUIRE(layout(font, u"سلام", {.letter_spacing = 0.1}, {}, run));
    CHECK(run.lines[0].advance == joined.lines[0].advance);
}

TEST_CASE("A and V are kerned", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const double a = shaped(font, "A").lines[0].advance, v = shaped(font, "V").lines[0].advance;
    CHECK(shaped(font, "AV").lines[0].advance < a + v);
    const feature off[] = {{"kern", 0}};
    shape_options how;
    how.features = off;
    CHECK(shaped(font, "AV", how).lines[0].advance == a + v);
}

TEST_CASE("marks stand at their base", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const glyph_run run = shaped(font, u"q\u0301\u0323");
    REQUIRE(run.glyphs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(run.glyphs[i].cluster == 0);
    CHECK(run.lines[0].advance == shaped(font, "q").lines[0].advance);
}

TEST_CASE("a line of both directions is drawn in Unicode's order", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    using order = std::vector<cluster_id>;
    CHECK(clusters(shaped(font, u"abc \u05D0\u05D1")) == order{0, 1, 2, 3, 5, 4});
    CHECK(clusters(shaped(font, u"ok\n\u05D0\u05D1 abc")) == order{0, 1, 6, 7, 8, 5, 4, 3});
    CHECK(clusters(shaped(font, u"a\u05D0", with(direction::left_to_right, ""))) == order{0, 1});
    CHECK(clusters(shaped(font, u"a\u05D0", with(direction::right_to_left, ""))) == order{1, 0});
    CHECK(clusters(shaped(font, u"abc \u202Edef\u202C")) == order{0, 1, 2, 3, 4, 7, 6, 5, 8});
    CHECK(clusters(shaped(font, "\xD7\x90 (a) \xD7\x91")) == order{7, 6, 5, 4, 3, 2, 0});
    CHECK(clusters(shaped(font, u"abc\n\u05D0\u05D1")) == order{0, 1, 2, 5, 4});

    // Each stretch has the glyphs that it has alone, and the pen goes through all of them.
    const glyph_run both = shaped(font, u"AV.\u05D0\u05D1"), latin = shaped(font, u"AV."),
                    hebrew = shaped(font, u"\u05D0\u05D1");
    CHECK(both.lines[0].advance == latin.lines[0].advance + hebrew.lines[0].advance);
    for (std::size_t i = 0; i < 3; ++i) CHECK(both.glyphs[i].origin == latin.glyphs[i].origin);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(both.glyphs[3 + i].id == hebrew.glyphs[i].id);
        CHECK(both.glyphs[3 + i].origin.x == latin.lines[0].advance + hebrew.glyphs[i].origin.x);
    }
}

TEST_CASE("numbers in right-to-left lines are read to the right", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(amiri);
    using order = std::vector<cluster_id>;
    CHECK(clusters(shaped(font, u"\u0639\u0627\u0645 2024")) == order{4, 5, 6, 7, 3, 2, 1, 0});
    CHECK(clusters(shaped(font, u"\u0639\u0627\u0645 \u0662\u0660")) == order{4, 5, 3, 2, 1, 0});
    CHECK(clusters(shaped(font, "42", with(direction::right_to_left, ""))) == order{0, 1});
    CHECK(shaped(font, u"عام 7").glyphs[0].cluster == 4);
    CHECK(shaped(font, "1234").glyphs[0].cluster == 0);
    CHECK(shaped(font, u"\u0661\u0662").glyphs[0].cluster == 0);  // digits alone are read to the right
}

TEST_CASE("a mixed line keeps joins, reports what is invalid or missing, and obeys features and script",
          "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(amiri);
    const glyph_run joined = shaped(font, u"\u0628\u0628 12"), plain = shaped(font, u"\u0628\u0628");
    CHECK(joined.glyphs.back().id == plain.glyphs.back().id);
    const glyph_run broken = shaped(font, "\xD7\x90 a\xFF b\xF0\x9F\x9B\xB8");
    CHECK(broken.invalid_units == 1);
    CHECK(broken.first_invalid_unit == 4);
    CHECK(broken.missing > 0);
    const feature cut[] = {{"lig", 1}};
    shape_options how;
    how.features = cut;
    CHECK(refusal(font, u"a\u05D0", how) == error::bad_feature);
    CHECK(refusal(font, u"a\u05D0", with(direction::automatic, "Lat")) == error::bad_option);
}

TEST_CASE("a requested direction is the line's, and letters keep their own", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    using order = std::vector<cluster_id>;
    CHECK(clusters(shaped(font, "abc", with(direction::right_to_left, ""))) == order{0, 1, 2});
    CHECK(clusters(shaped(font, "abc.", with(direction::right_to_left, ""))) == order{3, 0, 1, 2});
    CHECK(clusters(shaped(font, "(?", with(direction::right_to_left, ""))) == order{1, 0});
    CHECK(clusters(shaped(font, u"\u05D0\u05D1", with(direction::left_to_right, ""))) == order{1, 0});
    CHECK(clusters(shaped(font, u"\u05D0\u05D1.", with(direction::left_to_right, ""))) == order{1, 0, 2});
    CHECK(clusters(shaped(font, u"\u05D0\tab.", with(direction::automatic, ""))) == order{4, 2, 3, 0});
    // A line without letters reads to the right, whatever its script.
    CHECK(clusters(shaped(font, "(?", with(direction::automatic, "Hebr"))) == order{0, 1});
    CHECK(clusters(shaped(font, "(?")) == order{0, 1});
}

TEST_CASE("scripts are shaped each by its own rules in one line", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(lohit);
    const glyph_run alone = shaped(font, u"\u0915\u093F");  // the sign i is drawn before its letter
    REQUIRE(alone.glyphs.size() == 2);
    const glyph_run mixed = shaped(font, u"A \u0915\u093F");
    REQUIRE(mixed.glyphs.size() == 4);
    CHECK(mixed.glyphs[2].id == alone.glyphs[0].id);
    CHECK(mixed.glyphs[3].id == alone.glyphs[1].id);
    CHECK(mixed.glyphs[2].origin.x < mixed.glyphs[3].origin.x);

    // Right-to-left pieces follow each other to the left.
    harfbuzz_font both = opened(dejavu);
    const glyph_run rtl = shaped(both, u"\u05D0\u05D1 \u0627\u062F");
    CHECK(clusters(rtl) == std::vector<cluster_id>{4, 3, 2, 1, 0});
    for (std::size_t i = 1; i < rtl.glyphs.size(); ++i) CHECK(rtl.glyphs[i].origin.x > rtl.glyphs[i - 1].origin.x);
}

TEST_CASE("script and language reach the font", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    CHECK(refusal(font, "a", with(direction::automatic, "La")) == error::bad_option);
    CHECK(refusal(font, "a", with(direction::automatic, "L4t!")) == error::bad_option);
    CHECK(refusal(font, "a", with(direction::automatic, "Latin")) == error::bad_option);
    CHECK(shaped(font, "a", with(direction::automatic, "Latn")).glyphs.size() == 1);

    // The Sami form of the capital eng is another than the African; the machine's locale plays no part.
    shape_options sami;
    sami.language = "se";
    CHECK(ids(shaped(font, u"\u014A")) != ids(shaped(font, u"\u014A", sami)));
}

TEST_CASE("missing glyphs are counted, flagged and placed, but not what is never drawn", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(sawarabi);
    const glyph_run run = shaped(font, u"a\u0E01b\u0E02");
    CHECK(run.missing == 2);
    CHECK(run.first_missing == 1);
    REQUIRE(run.glyphs.size() == 4);
    CHECK(run.glyphs[1].missing);
    CHECK(run.glyphs[1].id == 0);
    CHECK(!run.glyphs[2].missing);
    CHECK(shaped(font, u"a\u200D\u2060\uFE0Fb").missing == 0);
}

TEST_CASE("invalid text reads as U+FFFD, once for each maximal subpart", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const glyph_id replacement = shaped(font, u"\uFFFD").glyphs[0].id;
    const glyph_run run = shaped(font, "a\xE2\x82z\xFF\n\xC0");
    CHECK(run.invalid_units == 3);
    CHECK(run.first_invalid_unit == 1);
    CHECK(clusters(run) == std::vector<cluster_id>{0, 1, 3, 4, 6});
    CHECK(run.glyphs[1].id == replacement);
    CHECK(run.glyphs[3].id == replacement);

    const glyph_run wide = shaped(font, std::u16string{u'a', 0xD800, u'z'});
    CHECK(wide.invalid_units == 1);
    CHECK(wide.glyphs[1].id == replacement);

    // Broken Arabic still joins.
    harfbuzz_font arabic = opened(amiri);
    const glyph_run whole = shaped(arabic, u8"بب"), broken = shaped(arabic, "\u0628\u0628\xFF");
    REQUIRE(broken.glyphs.size() == 3);
    CHECK(broken.glyphs[2].id == whole.glyphs[1].id);
}

TEST_CASE("Japanese runs down in columns, centred on the pen", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(sawarabi);
    const glyph_run run = shaped(font, u"こんにちは、\n世界！", with(direction::top_to_bottom, ""));
    REQUIRE(run.lines.size() == 2);
    CHECK(run.lines[0].advance > 0.0);
    CHECK(run.lines[1].origin.x < 0.0);
    for (const text_line& line : run.lines)
        for (std::uint32_t i = 1; i < line.glyph_count; ++i)
            CHECK(run.glyphs[line.first_glyph + i].origin.y < run.glyphs[line.first_glyph + i - 1].origin.y);
    outline o;
    REQUIRE(record(font, run.glyphs[0].id, o));
    const double middle = run.glyphs[0].origin.x + (o.bounds.low.x + o.bounds.high.x) / 2;
    CHECK(std::fabs(middle) < 0.1 * font.units_per_em());
    CHECK(run.glyphs[0].origin.y + o.bounds.high.y <= 0.02 * font.units_per_em());
    CHECK(font.metrics(direction::top_to_bottom).ascender > 0.0);
    CHECK(font.metrics(direction::top_to_bottom).descender < 0.0);
}

TEST_CASE("variations change outlines and advances, and are kept inside their range", "[adapt][harfbuzz]")
{
    const variation bold[] = {{"wght", 900.0f}}, beyond[] = {{"wght", 4000.0f}}, regular[] = {{"wght", 400.0f}};
    harfbuzz_font plain = opened(inter), heavy = opened(inter, {0, bold}), heaviest = opened(inter, {0, beyond}),
                  same = opened(inter, {0, regular});
    const glyph_id h = shaped(plain, "H").glyphs[0].id;
    CHECK(points_of(plain, h) != points_of(heavy, h));
    CHECK(points_of(heavy, h) == points_of(heaviest, h));
    CHECK(points_of(plain, h) == points_of(same, h));
    CHECK(shaped(plain, "HAV").lines[0].advance < shaped(heavy, "HAV").lines[0].advance);

    const variation unknown[] = {{"wght", 500.0f}, {"abcd", 1.0f}},
                    infinite[] = {{"wght", std::numeric_limits<float>::infinity()}};
    CHECK(harfbuzz_font::open(font_file(inter).c_str(), {0, unknown}).error() == error::unknown_variation);
    CHECK(harfbuzz_font::open(font_file(inter).c_str(), {0, unknown}).error().count == error::no_axis("abcd").count);
    CHECK(harfbuzz_font::open(font_file(dejavu).c_str(), {0, bold}).error() == error::unknown_variation);
    CHECK(harfbuzz_font::open(font_file(inter).c_str(), {0, infinite}).error() == error::bad_option);
}

TEST_CASE("a font opens alike from its path and from its bytes", "[adapt][harfbuzz]")
{
    const auto bytes = bytes_of(font_file(amiri));
    auto lent = test::required(harfbuzz_font::open(bytes));
    harfbuzz_font read = opened(amiri);
    CHECK(same_run(shaped(*lent, u8"مرحبا بالعالم!"), shaped(read, u8"مرحبا بالعالم!")));
    for (glyph_id id = 0; id < read.glyph_count(); id += 97) CHECK(points_of(*lent, id) == points_of(read, id));
}

TEST_CASE("the caller's hb_font_t is right at any scale, also with y down, and is left as it was", "[adapt][harfbuzz]")
{
    harfbuzz_font own = opened(dejavu);
    hb_font_t* callers = hb_font_create(hb_font_get_face(own.handle()));
    for (const auto& [x, y] : {std::pair{2048, 2048}, {2048 * 64, -2048 * 64}, {1 << 20, 1 << 20}, {-2048, 4096}}) {
        INFO(x << " x " << y);
        hb_font_set_scale(callers, x, y);
        auto wrapped = test::required(harfbuzz_font::wrap(callers));
        CHECK(wrapped->units_per_em() == 2048.0);
        CHECK(std::fabs(wrapped->metrics(direction::automatic).ascender - 1901.0) < 1.0);
        CHECK(same_run(shaped(*wrapped, u"AVq\u0301"), shaped(own, u"AVq\u0301"), 2.0));
        const auto a = points_of(own, 36), b = points_of(*wrapped, 36);
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(length(a[i] - b[i]) < 0.01);
        int kept_x = 0, kept_y = 0;
        hb_font_get_scale(callers, &kept_x, &kept_y);
        CHECK(kept_x == x);
        CHECK(kept_y == y);
    }
    hb_font_set_scale(callers, 0, 2048);
    CHECK(harfbuzz_font::wrap(callers).error() == error::bad_option);

    hb_font_set_scale(callers, 2048, 2048);
    auto kept = harfbuzz_font::wrap(callers);
    hb_font_destroy(callers);  // the wrapper has its own reference
    REQUIRE(kept);
    CHECK(shaped(*kept, "ab").glyphs.size() == 2);
}

TEST_CASE("a font moves with all it holds", "[adapt][harfbuzz]")
{
    harfbuzz_font first = opened(dejavu);
    const glyph_run before = shaped(first, "Hello");
    harfbuzz_font second = std::move(first);
    CHECK(same_run(shaped(second, "Hello"), before));
    harfbuzz_font third = opened(amiri);
    third = std::move(second);
    CHECK(third.units_per_em() == 2048.0);
    CHECK(same_run(shaped(third, "Hello"), before));
    CHECK(!points_of(third, before.glyphs[0].id).empty());
    auto shared = test::required(harfbuzz_font::wrap(third.handle()));
    CHECK(same_run(shaped(*shared, "Hello"), before));
}

TEST_CASE("glyphs draw into sinks of different types in turn", "[adapt][harfbuzz]")
{
    struct counter {
        int calls = 0;
        void move(point) noexcept { ++calls; }
        void line(point) noexcept { ++calls; }
        void quadratic(point, point) noexcept { ++calls; }
        void cubic(point, point, point) noexcept { ++calls; }
        void close() noexcept { ++calls; }
    };
    harfbuzz_font font = opened(dejavu);
    const glyph_id o = shaped(font, "o").glyphs[0].id;
    const auto points = points_of(font, o);
    counter count;
    REQUIRE(!font.outline(o, count));
    CHECK(count.calls > 4);
    CHECK(points_of(font, o) == points);
    const int once = count.calls;
    REQUIRE(!font.outline(o, count));
    CHECK(count.calls == 2 * once);
}

TEST_CASE("blank glyphs draw nothing, glyphs that do not exist are an error", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    CHECK(points_of(font, shaped(font, " ").glyphs[0].id).empty());
    outline o;
    const error e = record(font, font.glyph_count(), o).error();
    CHECK(e == error::unknown_glyph);
    CHECK(e.glyph == font.glyph_count());
    CHECK(record(font, no_glyph, o) == error::unknown_glyph);
}

TEST_CASE("a font that does not open says why", "[adapt][harfbuzz]")
{
    CHECK(harfbuzz_font::open("/no/such/font.ttf").error() == error::unreadable_file);
    CHECK(std::string{harfbuzz_font::open("/no/such/font.ttf").error().message()} ==
          "The font file cannot be opened or read: check its path and its permissions.");
    CHECK(harfbuzz_font::open(TYPEMESH_TEST_DATA "/workload/README.md").error() == error::not_a_font);
    CHECK(harfbuzz_font::open(std::span<const std::byte>{}).error() == error::not_a_font);
    const auto words = bytes_of(TYPEMESH_TEST_DATA "/workload/README.md");
    CHECK(harfbuzz_font::open(words).error() == error::not_a_font);
    const error face = harfbuzz_font::open(font_file(microhei).c_str(), {2, {}}).error();
    CHECK(face == error::no_such_face);
    CHECK(face.count == 2);
    CHECK(harfbuzz_font::open(font_file(microhei).c_str(), {1, {}}));
    CHECK(harfbuzz_font::open(font_file(dejavu).c_str(), {65536, {}}).error() == error::no_such_face);
    CHECK(harfbuzz_font::open(font_file("../wine/fonts/courier.ttf").c_str()).error() == error::no_outlines);
}

TEST_CASE("empty text is an empty line", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const glyph_run run = shaped(font, "");
    CHECK(run.glyphs.empty());
    CHECK(run.lines.size() == 1);
    CHECK(run.units_per_em == 2048.0);
    buffer<shaped_glyph> direct;
    REQUIRE_FALSE(font.shape("", {}, {}, direct));
    CHECK(direct.empty());
}

TEST_CASE("a tab leads to the next tab stop in lines of both directions, and is not missing", "[adapt][harfbuzz]")
{
    harfbuzz_font font = opened(dejavu);
    const double stop = 4.0 * (shaped(font, "0 0").lines[0].advance - 2 * shaped(font, "0").lines[0].advance),
                 digit = shaped(font, "0").lines[0].advance;
    for (const char* text :
         {"one\ttwo", "\xD7\x90\xD7\x91\t\xD7\x92", "\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85\t\xD8\xA8", "12\t34"}) {
        INFO(text);
        const std::string all = text, before = all.substr(0, all.find('\t')), behind = all.substr(all.find('\t') + 1);
        const glyph_run run = shaped(font, text), first = shaped(font, before), second = shaped(font, behind);
        CHECK(run.missing == 0);
        CHECK(run.glyphs.size() == first.glyphs.size() + second.glyphs.size());
        const double tab = tab_stop_behind(first.lines[0].advance, stop, least_tab(digit));
        CHECK(run.lines[0].advance == tab + second.lines[0].advance);

        const bool to_the_left = static_cast<unsigned char>(text[0]) >= 0x80;
        const std::size_t n = to_the_left ? second.glyphs.size() : 0, m = to_the_left ? 0 : first.glyphs.size();
        for (std::size_t i = 0; i < first.glyphs.size(); ++i) {
            const double moved = to_the_left ? run.lines[0].advance - first.lines[0].advance : 0.0;
            CHECK(run.glyphs[n + i].id == first.glyphs[i].id);
            CHECK(run.glyphs[n + i].origin.x == Approx(first.glyphs[i].origin.x + moved));
        }
        for (std::size_t i = 0; i < second.glyphs.size(); ++i) {
            CHECK(run.glyphs[m + i].id == second.glyphs[i].id);
            CHECK(run.glyphs[m + i].cluster == second.glyphs[i].cluster + before.size() + 1);
            CHECK(run.glyphs[m + i].origin.x == Approx(second.glyphs[i].origin.x + (to_the_left ? 0.0 : tab)));
        }
    }
}

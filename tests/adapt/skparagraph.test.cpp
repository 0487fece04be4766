// SPDX-License-Identifier: MIT
//
// Paragraphs beside SkParagraph's, of the same texts in the same fonts. skparagraph/recorded.txt holds what that made of
// them, skparagraph/record.mjs how it came about. Each difference has a reason, which stands here; what is left of a line
// is compared all the same.

#include "skparagraph/recorded.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/font_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifdef TYPEMESH_TEST_WITH_ICU
#include <unicode/ubrk.h>
#endif

using namespace typemesh;

namespace {

constexpr double em = 64.0;               // in pixels
constexpr double near_enough = 1.0 / 64;  // of a pixel
bool is_within(double a, double b) { return std::fabs(a - b) <= near_enough; }

/// Why a line is not as SkParagraph's. Besides these
/// * a word that is longer than the line begins a line of its own, as in CSS: see record.mjs;
/// * glyphs belong to the first character of their cluster, SkParagraph's marks to themselves;
/// * the glyph of a stretched space stands where its gap begins, SkParagraph's where it ends: nothing is seen of either;
/// * white space that hangs keeps its own width, SkParagraph's is kerned with the next line: boxes end where lines do.
enum class reason {
    none,
    kerned_end,   ///< SkParagraph shapes nothing anew at a break: the line is kerned with what stands behind it
    lone_script,  ///< it finds scripts in each run of one level alone: a full stop behind digits is not Arabic any more
    ideographs,   ///< justified, it makes room at other places beside what is no ideograph
    small_kana,   ///< it lets lines begin with them, UAX #14 as it stands does not: of that ICU is the witness
};

struct difference {
    const char* text;
    double width;        ///< 0: any
    std::uint32_t from;  ///< where the line begins, or the first of several
    std::uint32_t to;    ///< where the last of them does
    reason why;
};

const difference differences[] = {
    {"english", 7, 86, 86, reason::kerned_end},     // "VA-" before "VAT"
    {"long-word", 4, 14, 14, reason::kerned_end},   // ends within "fff"
    {"long-word", 5, 9, 9, reason::kerned_end},     // likewise
    {"long-word", 11, 2, 2, reason::kerned_end},    // likewise
    {"arabic", 0, 114, 213, reason::lone_script},   // the last line
    {"japanese", 5, 117, 163, reason::small_kana},  // from there on lines end elsewhere
    {"japanese", 5, 105, 105, reason::ideographs},  // each of these has a space, or Latin
    {"japanese", 7, 0, 0, reason::ideographs},      {"japanese", 7, 144, 144, reason::ideographs},
    {"japanese", 10, 90, 90, reason::ideographs},   {"japanese", 10, 147, 147, reason::ideographs},
    {"japanese", 14, 126, 126, reason::ideographs}, {"fallback", 6, 88, 88, reason::ideographs},
    {"fallback", 8, 76, 76, reason::ideographs},    {"fallback", 11, 76, 76, reason::ideographs},
    {"fallback", 16, 67, 67, reason::ideographs},
};

reason why_other(const skparagraph::text& t, const skparagraph::layout& l, std::uint32_t line)
{
    for (const difference& d : differences) {
        if (d.why == reason::ideographs && l.align != "justify") continue;
        if (t.name == d.text && (d.width == 0.0 || d.width == l.width) && line >= d.from && line <= d.to) return d.why;
    }
    return reason::none;
}

const skparagraph::record& recorded()
{
    static const skparagraph::record all =
        skparagraph::reader{std::string{TYPEMESH_TEST_DATA} + "/adapt/skparagraph/recorded.txt"}.read();
    return all;
}

/// FNV-1a, 64 bits, and how many bytes.
std::pair<std::uint64_t, std::size_t> checksum_of(const std::string& path)
{
    std::uint64_t sum = 0xCBF29CE484222325u;
    std::size_t size = 0;
    std::ifstream in{path, std::ios::binary};
    std::vector<char> bytes(1u << 16);
    while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || in.gcount() > 0) {
        const auto count = static_cast<std::size_t>(in.gcount());
        const char* byte = bytes.data();
        for (const char* end = byte + count; byte != end; ++byte)
            sum = (sum ^ static_cast<unsigned char>(*byte)) * 0x100000001B3u;
        size += count;
    }
    return {sum, size};
}

/// Whether a font is the one that SkParagraph had. Says so where it is not: the lines of a text in it cannot be compared.
bool is_recorded(const skparagraph::font& f)
{
    static std::map<std::string, bool> known;
    const std::string path = font_file(f.path);
    const auto [at, fresh] = known.insert({path, false});
    if (!fresh) return at->second;
    at->second = checksum_of(path) == std::pair{f.checksum, f.bytes};
    if (!at->second)
        WARN("left out: the texts in " << path
                                       << ", which is not the version that SkParagraph's lines were recorded with ("
                                       << f.bytes
                                       << " bytes): install that one, or run tests/adapt/skparagraph/record.sh");
    return at->second;
}

const skparagraph::font& font_called(const std::string& name)
{
    for (const skparagraph::font& f : recorded().fonts)
        if (f.name == name) return f;
    FAIL("No font of SkParagraph's is called " << name);
    std::abort();
}

const skparagraph::text& text_called(const std::string& name)
{
    for (const skparagraph::text& t : recorded().texts)
        if (t.name == name) return t;
    FAIL("No text of SkParagraph's is called " << name);
    std::abort();
}

bool can_be_compared(const skparagraph::text& t)
{
    return std::all_of(t.fonts.begin(), t.fonts.end(),
                       [](const std::string& name) { return is_recorded(font_called(name)); });
}

/// The share of the texts that can be compared.
double compared_share()
{
    const auto& all = recorded().texts;
    return double(std::count_if(all.begin(), all.end(), can_be_compared)) / double(all.size());
}

/// One of the texts, laid out as it was there.
class laid_out {
public:
    explicit laid_out(const skparagraph::text& t) : text{t}
    {
        for (std::size_t k = 1; k < faces.size(); ++k) REQUIRE(fonts.add(faces[k]));
        shape_options how;
        how.direction = t.right_to_left ? direction::right_to_left : direction::left_to_right;
        REQUIRE(words.set(text_view{t.words}, how));
    }

    void lay_out(const skparagraph::layout& l)
    {
        const alignment align = l.align == "left"     ? alignment::left
                                : l.align == "centre" ? alignment::centre
                                                      : alignment::justify;
        REQUIRE(words.lay_out({.width = l.width, .align = align}, run));
    }

    [[nodiscard]] bool blank(std::uint32_t at) const { return text.words[at] == ' ' || text.words[at] == '\n'; }

    /// Where the white space at the end of a line begins.
    [[nodiscard]] std::uint32_t visible_end(const laid_line& line) const
    {
        std::uint32_t end = line.last;
        while (end > line.first && blank(end - 1)) --end;
        return end;
    }
    [[nodiscard]] std::uint32_t grapheme(std::uint32_t at) const
    {
        while (at > 0 && at < text.words.size() && !has(words.shaped().analysis.marks[at], text_mark::grapheme)) --at;
        return at;
    }

    /// Whether two places lie in one cluster of several characters, or at its sides.
    [[nodiscard]] bool share_cluster(std::uint32_t a, std::uint32_t b) const
    {
        const shaped_text& shaped = words.shaped();
        for (std::uint32_t k = 0; k < shaped.cluster_count(); ++k) {
            const text_cluster& c = shaped.cluster(k);
            if (decode(text_view{text.words}, c.first).next == c.last) continue;
            if (c.first <= std::min(a, b) && c.last >= std::max(a, b)) return true;
        }
        return false;
    }

    /// SkParagraph does not set white space at a line's end to the level of its paragraph, UAX #9's rule L1, for carets and
    /// boxes (the drawing is right): where it has another level they are moved by its width.
    [[nodiscard]] bool without_l1(const laid_line& line) const
    {
        const std::uint32_t end = visible_end(line);
        return end < line.last && text.words[end] == ' ' && end > line.first &&
               words.shaped().analysis.levels[end - 1] != line.level;
    }

    /// A line's glyphs, as SkParagraph's were recorded.
    [[nodiscard]] std::vector<skparagraph::glyph> glyphs_of(std::size_t line) const
    {
        std::vector<skparagraph::glyph> all;
        const laid_line& l = words.lines()[line];
        for (std::uint32_t k = 0; k < run.lines[line].glyph_count; ++k) {
            const placed_glyph& g = run.glyphs[run.lines[line].first_glyph + k];
            if (g.cluster >= visible_end(l)) continue;
            const std::uint32_t face = run.glyph_styles.empty() ? 0 : run.glyph_styles[g.glyph_style].face;
            all.push_back({text.fonts[face], g.id, g.cluster, scale * (g.origin.x - l.left)});
        }
        return all;
    }

    [[nodiscard]] static std::vector<harfbuzz_font> opened(const std::vector<std::string>& names)
    {
        std::vector<harfbuzz_font> all;
        for (const std::string& name : names) {
            auto font = harfbuzz_font::open(font_file(font_called(name).path).c_str());
            REQUIRE(font);
            all.push_back(std::move(*font));
        }
        return all;
    }

    const skparagraph::text& text;
    std::vector<harfbuzz_font> faces = opened(text.fonts);
    font_list<harfbuzz_font> fonts{faces.front()};
    double scale = em / fonts.units_per_em();
    paragraph<font_list<harfbuzz_font>> words{fonts};
    glyph_run run;
};

/// Calls with(ours, layout) for all layouts.
template <class With>
void each_layout(const With& with)
{
    for (const skparagraph::text& t : recorded().texts) {
        if (!can_be_compared(t)) continue;
        laid_out ours{t};
        for (const skparagraph::layout& l : t.layouts) {
            INFO(t.name << ", " << l.width << " em wide, " << l.align);
            ours.lay_out(l);
            with(ours, l);
        }
    }
}

/// The number of SkParagraph's line with the same text, or that of lines.
std::size_t line_like(const laid_line& line, const skparagraph::layout& l)
{
    std::size_t k = 0;
    while (k < l.lines.size() && (l.lines[k].first != line.first || l.lines[k].last != line.last)) ++k;
    return k;
}

/// How much of a line is compared.
enum class law {
    all,
    words,  ///< the same glyphs, at the same distances within each word
    ids,    ///< the same glyphs
};

law law_of(reason why)
{
    if (why == reason::none) return law::all;
    return why == reason::ideographs ? law::ids : law::words;
}

/// Where the cluster of glyphs begins that holds a byte of the text.
std::uint32_t cluster_of(const std::vector<skparagraph::glyph>& glyphs, std::uint32_t at)
{
    std::uint32_t first = 0;
    for (const skparagraph::glyph& g : glyphs)
        if (g.at <= at && g.at > first) first = g.at;
    return first;
}

/// What is wrong with a line, or nothing.
std::string fault_of(const laid_out& ours, std::size_t number, const skparagraph::line& line, law which)
{
    const std::vector<skparagraph::glyph> glyphs = ours.glyphs_of(number);
    std::vector<skparagraph::glyph> others;
    for (const skparagraph::glyph& g : line.glyphs)
        if (g.at < ours.visible_end(ours.words.lines()[number])) others.push_back(g);
    std::ostringstream fault;
    fault << "the line from " << line.first << " to " << line.last << ": ";
    if (glyphs.size() != others.size()) {
        fault << glyphs.size() << " glyphs, not " << others.size();
        return fault.str();
    }
    const double left = ours.scale * ours.words.lines()[number].left;
    if (which == law::all && !is_within(left, line.left)) {
        fault << "begins at " << left << ", not " << line.left;
        return fault.str();
    }
    double moved = 0.0;  // the present word
    bool fresh = which == law::words;
    for (std::size_t k = 0; k < glyphs.size(); ++k) {
        const skparagraph::glyph &a = glyphs[k], &b = others[k];
        if (which == law::words && (ours.blank(a.at) || a.at == ours.text.words.size() - 1)) {
            fresh = true;  // a blank, or the full stop of reason::lone_script
            continue;
        }
        if (fresh) moved = a.x - b.x;
        fresh = false;
        const bool stretched = ours.blank(a.at);
        if (a.font == b.font && a.id == b.id && a.at == cluster_of(glyphs, b.at) &&
            (which == law::ids || stretched || is_within(a.x - b.x, moved)))
            continue;
        fault << "glyph " << k << " is " << a.id << " for " << a.at << " at " << a.x << ", not " << b.id << " for "
              << b.at << " at " << b.x;
        return fault.str();
    }
    return {};
}

/// Whether kerning makes some of a line's gaps wider than others. Justified, SkParagraph makes them all the same; here each
/// is stretched by as much.
bool has_uneven_gaps(const laid_out& ours, const skparagraph::line& unjustified)
{
    std::vector<double> gaps;
    const auto& glyphs = unjustified.glyphs;
    for (std::size_t k = 1; k + 1 < glyphs.size(); ++k)
        if (ours.blank(glyphs[k].at)) gaps.push_back(glyphs[k + 1].x - glyphs[k].x);
    return std::any_of(gaps.begin(), gaps.end(), [&](double gap) { return std::fabs(gap - gaps.front()) > 1e-3; });
}

/// The same text and width, aligned to the left.
const skparagraph::layout& left_of(const skparagraph::text& t, const skparagraph::layout& l)
{
    for (const skparagraph::layout& other : t.layouts)
        if (other.width == l.width && other.align == "left") return other;
    return l;
}

}  // namespace

TEST_CASE("lines end where SkParagraph's do", "[adapt][skparagraph]")
{
    std::size_t compared = 0;
    each_layout([&](laid_out& ours, const skparagraph::layout& l) {
        for (const laid_line& line : ours.words.lines()) {
            if (why_other(ours.text, l, line.first) == reason::small_kana) continue;
            INFO("the line from " << line.first << " to " << line.last);
            CHECK(line_like(line, l) < l.lines.size());
            ++compared;
        }
    });
    CHECK(double(compared) > 500 * compared_share());
}

#ifdef TYPEMESH_TEST_WITH_ICU
TEST_CASE("ICU lets no line begin with a small kana either", "[adapt][skparagraph][icu]")
{
    const std::u16string text = u"コンピューター";
    UErrorCode failed = U_ZERO_ERROR;
    UBreakIterator* lines = ubrk_open(UBRK_LINE, "", text.data(), static_cast<std::int32_t>(text.size()), &failed);
    REQUIRE(U_SUCCESS(failed));
    CHECK(ubrk_isBoundary(lines, 2));        // before U+30D4
    CHECK_FALSE(ubrk_isBoundary(lines, 3));  // before U+30E5, a small one, where SkParagraph ends a line
    ubrk_close(lines);
}
#endif

TEST_CASE("lines have the glyphs of SkParagraph's, within 1/64 pixel of their places", "[adapt][skparagraph]")
{
    each_layout([](laid_out& ours, const skparagraph::layout& l) {
        for (std::size_t k = 0; k < ours.words.lines().size(); ++k) {
            const laid_line& line = ours.words.lines()[k];
            const std::size_t like = line_like(line, l);
            if (like == l.lines.size()) continue;  // the first test
            law which = law_of(why_other(ours.text, l, line.first));
            if (which == law::all && l.align == "justify" && has_uneven_gaps(ours, left_of(ours.text, l).lines[like]))
                which = law::words;
            CHECK(fault_of(ours, k, l.lines[like], which) == "");
        }
    });
}

TEST_CASE("each named difference from SkParagraph is a difference", "[adapt][skparagraph]")
{
    for (const difference& d : differences) {
        if (!can_be_compared(text_called(d.text))) continue;
        bool differs = false;
        each_layout([&](laid_out& ours, const skparagraph::layout& l) {
            for (std::size_t k = 0; k < ours.words.lines().size() && !differs; ++k) {
                const laid_line& line = ours.words.lines()[k];
                if (ours.text.name != d.text || line.first < d.from || line.first > d.to) continue;
                if (why_other(ours.text, l, line.first) != d.why) continue;
                const std::size_t like = line_like(line, l);
                differs = like == l.lines.size() || !fault_of(ours, k, l.lines[like], law::all).empty();
            }
        });
        INFO(d.text << ", " << d.width << " em wide, the lines from " << d.from << " to " << d.to);
        CHECK(differs);
    }
}

TEST_CASE("graphemes stand where SkParagraph has them, and are read the same way", "[adapt][skparagraph]")
{
    std::size_t compared = 0;
    each_layout([&](laid_out& ours, const skparagraph::layout& l) {
        const laid_text laid = ours.words.laid();
        for (const skparagraph::grapheme& g : l.graphemes) {
            const laid_line& line = ours.words.lines()[laid.line_of(g.first)];
            if (why_other(ours.text, l, line.first) != reason::none || ours.without_l1(line)) continue;
            if (g.first >= ours.visible_end(line) && l.align != "justify") continue;
            const caret before = laid.caret_at(g.first), behind = laid.caret_at(g.last, affinity::upstream);
            INFO("the grapheme from " << g.first << " to " << g.last);
            CHECK(is_within(em * before.at.x, g.to_the_left ? g.right : g.left));
            CHECK(is_within(em * behind.at.x, g.to_the_left ? g.left : g.right));
            CHECK(before.to_the_left == g.to_the_left);
            ++compared;
        }
    });
    CHECK(double(compared) > 500 * compared_share());
}

TEST_CASE("a range of the text has SkParagraph's boxes", "[adapt][skparagraph]")
{
    std::size_t compared = 0;
    each_layout([&](laid_out& ours, const skparagraph::layout& l) {
        const laid_text laid = ours.words.laid();
        for (std::size_t k = 0; k < l.boxes.size();) {
            const skparagraph::box& b = l.boxes[k];
            std::vector<std::pair<double, double>> expected, found;
            for (; k < l.boxes.size() && l.boxes[k].first == b.first && l.boxes[k].line == b.line; ++k)
                expected.push_back({l.boxes[k].left, l.boxes[k].right});
            if (b.line >= l.lines.size()) continue;
            const skparagraph::line& other = l.lines[b.line];
            const std::uint32_t number = laid.line_of(other.first);
            const laid_line& line = ours.words.lines()[number];
            if (why_other(ours.text, l, line.first) != reason::none || ours.without_l1(line)) continue;
            if (l.align == "justify" && has_uneven_gaps(ours, left_of(ours.text, l).lines[b.line])) continue;
            const double low = ours.scale * line.left, high = ours.scale * line.right();
            laid.boxes_of((std::max)(b.first, line.first), (std::min)(b.last, line.last),
                          [&](const box& x) { found.push_back({em * x.low.x, em * x.high.x}); });
            INFO("the range from " << b.first << " to " << b.last << " on line " << b.line);
            REQUIRE(found.size() == expected.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                const auto inside = [&](double x) { return std::clamp(x, low, high); };
                CHECK(is_within(inside(found[i].first), inside(expected[i].first)));
                CHECK(is_within(inside(found[i].second), inside(expected[i].second)));
            }
            ++compared;
        }
    });
    CHECK(double(compared) > 300 * compared_share());
}

TEST_CASE("the place below a point is SkParagraph's", "[adapt][skparagraph]")
{
    std::size_t compared = 0;
    each_layout([&](laid_out& ours, const skparagraph::layout& l) {
        const laid_text laid = ours.words.laid();
        for (const skparagraph::hit& h : l.hits) {
            const laid_line& line = ours.words.lines()[h.line];
            if (why_other(ours.text, l, line.first) != reason::none || ours.without_l1(line)) continue;
            const box all = laid.line_box(h.line);
            // To the right of a line that is read to the left it names the place before the line's beginning.
            if (line.level % 2 != 0 && h.x > em * all.high.x) continue;
            if (ours.text.name == "long-word" && h.line == 0) continue;  // a break there, a blank here
            const text_place found = laid.caret_from({h.x / em, (all.low.y + all.high.y) / 2});
            INFO(h.x << " pixels from the left on line " << h.line);
            ++compared;
            // Half-way through a grapheme both of its sides are as near.
            const caret a = laid.caret_at(found.unit, found.side);
            const caret b = laid.caret_at(h.at, h.upstream ? affinity::upstream : affinity::downstream);
            if (is_within(std::fabs(em * a.at.x - h.x), std::fabs(em * b.at.x - h.x))) continue;
            // Over a cluster of several characters it names any of its places, here that is named which is nearest.
            CHECK(ours.share_cluster(found.unit, h.at));
            CHECK(std::fabs(em * a.at.x - h.x) < std::fabs(em * b.at.x - h.x));
        }
    });
    CHECK(double(compared) > 500 * compared_share());
}

// SPDX-License-Identifier: MIT
//
// Bad fonts get a clear error or an outline that is finite and whole; never a crash, a hang, or an index out of range.
//
// The tests damage copies of installed fonts, from fixed seeds. TYPEMESH_HOSTILE_FONTS can name a folder of other people's
// hostile fonts. The tests find most under the sanitizers (g++ -fsanitize=address,undefined); faults inside HarfBuzz or
// FreeType belong to those projects.
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/lit_mesh.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

const char* const texts[] = {"Hello world! AV fi 12,5%",
                             "\u0645\u0631\u062D\u0628\u0627",
                             "\u3053\u3093\u306B\u3061\u306F\u4E16\u754C",
                             "\u0915\u094D\u0937\u093F",
                             "a\u0301\u200D\U0001F468\u200D\U0001F469\uFE0F",
                             "\xFF\xC0\x80 \xED\xA0\x80"};

/// The counts of a run, so that a run without any tries is noticed.
struct tally {
    std::size_t fonts = 0, opened = 0, glyphs = 0, drawn = 0, refused = 0, bevelled = 0;
};

bool is_an_answer(error e)
{
    switch (e.code) {
    case error::not_a_font:
    case error::no_such_face:
    case error::no_outlines:
    case error::font_library_failed:
    case error::unreadable_file: return true;
    default: return false;
    }
}

/// Counts the broken laws of an answer.
template <class Font>
std::size_t try_glyph(Font& font, glyph_id id, outline& out, tally& seen)
{
    ++seen.glyphs;
    if (const auto done = record(font, id, out); !done) {
        ++seen.refused;
        const bool known =
            done == error::unknown_glyph || done == error::outline_not_finite || done == error::out_of_memory;
        return known ? 0 : 1;
    }
    seen.drawn += out.curves.empty() ? 0 : 1;
    std::size_t wrong = 0;
    for (const curve& c : out.curves)
        for (std::uint32_t i = 0; i <= c.degree; ++i) wrong += !is_finite(c.p[i].x) || !is_finite(c.p[i].y);
    for (std::uint32_t k = 0; k < out.contour_count(); ++k)
        wrong += out.starts[k] >= out.starts[k + 1] || out.starts[k + 1] > out.curves.size();
    return wrong;
}

template <class Font>
std::size_t try_text(Font& font, const char* text, direction d, plain_layout& layout, glyph_run& run)
{
    shape_options how;
    how.direction = d;
    if (!layout(font, text, how, {}, run)) return run.glyphs.empty() && run.lines.empty() ? 0 : 1;
    const std::size_t size = std::char_traits<char>::length(text);
    std::size_t wrong = 0;
    for (const placed_glyph& g : run.glyphs)
        wrong += g.cluster >= size || !is_finite(g.origin.x) || !is_finite(g.origin.y);
    for (const text_line& line : run.lines)
        wrong += line.first_glyph + line.glyph_count > run.glyphs.size() || !(line.advance >= 0.0) ||
                 !is_finite(line.advance);
    return wrong;
}

template <class Font>
std::size_t try_font(std::span<const std::byte> bytes, std::uint32_t max_glyphs, std::span<const variation> variations,
                     tally& seen)
{
    ++seen.fonts;
    std::size_t wrong = 0;
    plain_layout layout;
    for (std::uint32_t face = 0; face < 3; ++face) {
        auto font = Font::open(bytes, {face, variations});
        if (!font) {
            wrong += !is_an_answer(font.error()) && !(font.error() == error::unknown_variation && !variations.empty());
            if (face == 0 && font.error() == error::no_such_face) ++wrong;
            continue;
        }
        ++seen.opened;
        wrong += !(font->units_per_em() > 0.0) || font->glyph_count() == 0;
        outline out;
        const std::uint32_t count = font->glyph_count(), step = count / max_glyphs + 1;
        for (glyph_id id = 0; id < count; id += step) wrong += try_glyph(*font, id, out, seen);
        wrong += !(record(*font, count, out) == error::unknown_glyph) +
                 !(record(*font, no_glyph, out) == error::unknown_glyph);
        for (const direction d : {direction::automatic, direction::top_to_bottom}) {
            const line_metrics m = font->metrics(d);
            wrong += !is_finite(m.ascender) || !is_finite(m.descender) || !is_finite(m.gap);
            glyph_run run;
            for (const char* text : texts) wrong += try_text(*font, text, d, layout, run);
        }
    }
    return wrong;
}

/// Bevels at most `most` glyphs of the first face; counts wrong refusals, and meshes that are not closed.
template <class Font>
std::size_t try_bevels(std::span<const std::byte> bytes, std::uint32_t most, tally& seen)
{
    auto font = Font::open(bytes, {});
    if (!font) return 0;
    auto mesher = text_mesher{*font}.with(bevelled{.width = 0.03f, .profile = round_profile(4)});
    std::size_t wrong = 0;
    const std::uint32_t count = font->glyph_count(), step = count / most + 1;
    for (glyph_id id = 0; id < count; id += step) {
        glyph_run run;
        run.units_per_em = font->units_per_em();
        if (!run.glyphs.push_back({id, 0, {}})) return ++wrong;
        const auto plan = mesher.plan(run, {.tolerance = quality::normal, .unit = output_unit::font_units});
        if (!plan) {
            ++wrong;
            continue;
        }
        seen.refused += plan->report().refused;
        if (plan->size().vertices == 0) continue;
        test::lit_mesh m;
        wrong += !plan->write(into(m.vertices, m.indices)) ? 1 : 0;
        const inspect::closedness c = inspect::check_closedness(m.view());  // far out floats cannot tell points apart
        wrong += c.unmatched_edges + c.bad_corners;
        ++seen.bevelled;
    }
    return wrong;
}

/// Both libraries, plain and with a variation that most fonts lack.
std::size_t try_both(std::span<const std::byte> bytes, std::uint32_t max_glyphs, tally& seen)
{
    const variation weight[] = {{"wght", 650.0f}};
    return try_font<harfbuzz_font>(bytes, max_glyphs, {}, seen) + try_font<freetype_font>(bytes, max_glyphs, {}, seen) +
           try_font<harfbuzz_font>(bytes, max_glyphs / 4 + 1, weight, seen) +
           try_font<freetype_font>(bytes, max_glyphs / 4 + 1, weight, seen) +
           try_bevels<harfbuzz_font>(bytes, max_glyphs / 20 + 1, seen);
}

const char* const victims[] = {
    "truetype/liberation/LiberationMono-Regular.ttf", "opentype/comic-neue/ComicNeue-Regular.otf",
    "truetype/lohit-devanagari/Lohit-Devanagari.ttf", "truetype/inter-vf/Inter-roman.var.ttf",
    "opentype/fonts-hosny-amiri/AmiriQuranColored.ttf"};

}  // namespace

TEST_CASE("a font cut short anywhere is refused or partly drawn", "[hostile]")
{
    tally seen;
    for (const char* name : victims) {
        const auto whole = bytes_of(font_file(name));
        for (std::size_t i = 0; i < 40; ++i) {
            // Most cuts are in the table directory, where most decisions are made.
            const std::size_t kept = i < 20 ? i * i : whole.size() - whole.size() * (i - 19) / 21;
            INFO(name << " cut to " << kept << " bytes");
            // A separate copy, so that the sanitizers notice a read past its end.
            const std::vector<std::byte> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(kept));
            CHECK(try_both(cut, 30, seen) == 0);
        }
    }
    CHECK(seen.opened > 50);
    CHECK(seen.opened < seen.fonts);
}

TEST_CASE("a font with damaged bytes is refused or its outlines are finite", "[hostile]")
{
    tally seen;
    std::mt19937 random{20200607};
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    for (const char* name : victims) {
        const auto whole = bytes_of(font_file(name));
        for (int round = 0; round < 40; ++round) {
            INFO(name << ", round " << round);
            auto damaged = whole;
            switch (round % 4) {
            case 0:  // single bits
                for (int k = 0; k < 64; ++k) damaged[below(damaged.size())] ^= static_cast<std::byte>(1u << below(8));
                break;
            case 1:  // a run of noise
                for (std::size_t k = 0, at = below(damaged.size() - 256); k < 256; ++k)
                    damaged[at + k] = static_cast<std::byte>(below(256));
                break;
            case 2:  // extreme numbers
                for (int k = 0; k < 32; ++k) {
                    const std::size_t at = below(damaged.size() - 2);
                    const unsigned extreme = std::vector<unsigned>{0x0000, 0xFFFF, 0x7FFF, 0x8000}[below(4)];
                    damaged[at] = static_cast<std::byte>(extreme >> 8);
                    damaged[at + 1] = static_cast<std::byte>(extreme & 0xFF);
                }
                break;
            default:  // the directory of tables
                for (int k = 0; k < 4; ++k) damaged[below(12 + 16 * 16)] = static_cast<std::byte>(below(256));
            }
            CHECK(try_both(damaged, 60, seen) == 0);
        }
    }
    CHECK(seen.opened > 100);
    CHECK(seen.drawn > 5000);
    CHECK(seen.bevelled > 150);
}

TEST_CASE("random bytes are not a font", "[hostile]")
{
    std::mt19937 random{1};
    tally seen;
    for (std::size_t size = 0; size < 64; ++size) {
        std::vector<std::byte> noise(size * size);
        for (std::byte& b : noise) b = static_cast<std::byte>(random());
        CHECK(try_both(noise, 10, seen) == 0);
        CHECK(seen.opened == 0);
    }
}

TEST_CASE("fuzzing suites' fonts are refused or their outlines are finite", "[hostile]")
{
    const char* folder = std::getenv("TYPEMESH_HOSTILE_FONTS");
    if (folder == nullptr) {
        WARN("Skipped: TYPEMESH_HOSTILE_FONTS names no folder of hostile fonts.");
        return;
    }
    tally seen;
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.is_regular_file()) files.insert(entry.path());
    for (const auto& file : files) {
        INFO(file.filename().string());
        const auto bytes = bytes_of(file.string());
        CHECK(try_both(bytes, 300, seen) == 0);
        auto by_path = harfbuzz_font::open(file.string().c_str());
        auto by_bytes = harfbuzz_font::open(bytes);
        CHECK((by_path.error().code == by_bytes.error().code || bytes.empty()));
    }
    WARN(files.size() << " files, " << seen.opened << " of " << seen.fonts << " tries opened a face, " << seen.glyphs
                      << " glyphs: " << seen.drawn << " drawn, " << seen.refused << " refused, " << seen.bevelled
                      << " bevelled");
    CHECK(!files.empty());
}

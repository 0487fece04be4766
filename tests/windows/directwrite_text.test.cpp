// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/workload.hpp"
#include "windows/inline_object.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/adapt/directwrite_text.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using namespace test;

/// Meshes a text that was read, each glyph against the laws, and gives the mesh.
full_mesh meshed(directwrite_text& text)
{
    text_mesher mesher{text};
    auto plan = mesher.plan(text.run());
    REQUIRE(plan);
    CHECK(plan->report().refused == 0);
    full_mesh m;
    REQUIRE(plan->write(into(m.vertices, m.indices)));
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        std::vector<std::uint32_t> own;
        for (const part p : plan->parts()) {
            const mesh_range r = plan->range(g, p);
            own.insert(own.end(), m.indices.begin() + r.first_index, m.indices.begin() + r.first_index + r.index_count);
        }
        INFO("glyph " << plan->glyphs()[g].id);
        const auto law = examine(m.vertices, own);
        CHECK(law.unmatched_edges == 0);
        CHECK(law.crowded_slanted == 0);
        CHECK(law.zero_area == 0);
        CHECK(volume(m.vertices, own) > 0.0);
    }
    return m;
}

/// An inline object that draws what a test wants.
class box_object final : public inline_object {
public:
    HRESULT answer = E_NOTIMPL;
    bool draws_itself = false;
    void* context = nullptr;

    HRESULT STDMETHODCALLTYPE Draw(void* c, IDWriteTextRenderer* to, FLOAT x, FLOAT y, BOOL, BOOL,
                                   IUnknown*) noexcept override
    {
        context = c;
        return draws_itself ? to->DrawInlineObject(c, x, y, this, FALSE, FALSE, nullptr) : answer;
    }
};

}  // namespace

TEST_CASE("a layout of one font keeps the font's own glyph ids, its baseline and its advances", "[windows]")
{
    const test::font_files files{{dejavu}};
    auto font = directwrite_font::open(windows_path(dejavu).c_str());
    REQUIRE(font);
    const auto layout = files.layout(L"Hello", 64.0f);
    directwrite_text text;
    REQUIRE(text.read(layout.get()));
    const glyph_run& run = text.run();
    REQUIRE(run.glyphs.size() == 5);
    REQUIRE(run.lines.size() == 1);
    CHECK(run.units_per_em == 2048.0);
    CHECK(text.dips_per_unit() == 64.0 / 2048);

    DWRITE_LINE_METRICS line = {};
    UINT32 count = 0;
    REQUIRE(SUCCEEDED(layout->GetLineMetrics(&line, 1, &count)));
    glyph_run plain;
    REQUIRE(typemesh::layout(*font, u"Hello", {}, {}, plain));
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(run.glyphs[i].id == plain.glyphs[i].id);
        CHECK(run.glyphs[i].cluster == i);
        CHECK(std::fabs(run.glyphs[i].origin.x - plain.glyphs[i].origin.x) < 0.01);
        CHECK(std::fabs(run.glyphs[i].origin.y + double{line.baseline} / text.dips_per_unit()) < 0.01);
        CHECK_FALSE(run.glyphs[i].missing);
        const directwrite_glyph g = text.glyph(run.glyphs[i].id);
        CHECK(g.index == run.glyphs[i].id);
        CHECK(g.em_size == 64.0);
        REQUIRE(g.face != nullptr);
    }
    CHECK(std::fabs(run.lines[0].advance - plain.lines[0].advance) < 0.01);
    CHECK(text.glyph(70000).face == nullptr);
    outline a, b;
    REQUIRE(record(text, run.glyphs[1].id, a));
    REQUIRE(record(*font, plain.glyphs[1].id, b));
    REQUIRE(a.curves.size() == b.curves.size());
    for (std::size_t i = 0; i < a.curves.size(); ++i) CHECK(a.curves[i].p[1] == b.curves[i].p[1]);
    CHECK(record(text, 70000, a) == error::unknown_glyph);
    meshed(text);
}

TEST_CASE("every phrase of the four scripts, laid out and meshed, is closed and inside in, with every font",
          "[windows]")
{
    std::size_t phrases = 0;
    for (const workload_font& entry : workload_fonts()) {
        if (entry.optional() && !std::ifstream{entry.path}) continue;
        REQUIRE(entry.available());
        const test::font_files files{{entry.path}};
        for (const char* script : {"latin", "arabic", "chinese", "japanese"}) {
            if (!entry.serves(script)) continue;
            for (const std::string& phrase : workload_lines(std::string{"phrases-"} + script + ".txt")) {
                INFO(entry.name << ": " << phrase);
                const bool to_the_left = script == std::string{"arabic"};
                const auto layout = files.layout(wide(phrase), 32.0f);
                if (to_the_left)
                    REQUIRE(SUCCEEDED(layout->SetReadingDirection(DWRITE_READING_DIRECTION_RIGHT_TO_LEFT)));
                directwrite_text text;
                REQUIRE(text.read(layout.get()));
                CHECK(text.run().missing == 0);
                CHECK(text.run().invalid_units == 0);
                const full_mesh m = meshed(text);
                CHECK(m.indices.size() > 0);
                ++phrases;
                for (std::size_t i = 1; i < text.run().glyphs.size(); ++i) {
                    const placed_glyph &before = text.run().glyphs[i - 1], &g = text.run().glyphs[i];
                    CHECK((to_the_left ? g.cluster <= before.cluster : g.cluster >= before.cluster));
                }
                const auto length = static_cast<cluster_id>(wide(phrase).size());
                CHECK((to_the_left ? text.run().glyphs[0].cluster == length - 1 : text.run().glyphs[0].cluster == 0));
            }
        }
    }
    CHECK(phrases >= 11);
}

TEST_CASE("text of both directions stands in visual order", "[windows]")
{
    const test::font_files files{{dejavu}};
    const auto layout = files.layout(L"ab \x05D0\x05D1\x05D2 cd", 20.0f);
    const auto check_order = [&](const std::vector<cluster_id>& expected) {
        directwrite_text text;
        REQUIRE(text.read(layout.get()));
        std::vector<cluster_id> order;
        for (const placed_glyph& g : text.run().glyphs) order.push_back(g.cluster);
        CHECK(order == expected);
        for (std::size_t i = 1; i < order.size(); ++i)
            CHECK(text.run().glyphs[i].origin.x > text.run().glyphs[i - 1].origin.x);
    };
    check_order({0, 1, 2, 5, 4, 3, 6, 7, 8});
    REQUIRE(SUCCEEDED(layout->SetReadingDirection(DWRITE_READING_DIRECTION_RIGHT_TO_LEFT)));
    check_order({7, 8, 6, 5, 4, 3, 2, 0, 1});
}

TEST_CASE("wrapped lines lie below each other, and stand as they are aligned", "[windows]")
{
    const test::font_files files{{dejavu}};
    const auto layout = files.layout(L"one two three four five six\nseven", 20.0f, 130.0f, 400.0f);
    directwrite_text text;
    REQUIRE(text.read(layout.get()));
    const std::size_t lines = text.run().lines.size();
    REQUIRE(lines >= 4);
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < lines; ++k) {
        const text_line& line = text.run().lines[k];
        CHECK(line.first_glyph == next);
        CHECK(line.glyph_count > 0);
        next += line.glyph_count;
        if (k > 0) CHECK(line.origin.y < text.run().lines[k - 1].origin.y - 0.9 * text.units_per_em());
        for (std::uint32_t i = line.first_glyph; i < next; ++i) {
            CHECK(std::fabs(text.run().glyphs[i].origin.y - line.origin.y) < 0.01);
            CHECK_FALSE(text.run().glyphs[i].missing);  // the line break is no letter that lacks
        }
        CHECK(line.origin.x == Catch::Approx(0.0).margin(1e-6));
    }
    CHECK(next == text.run().glyphs.size());
    CHECK(text.run().missing == 0);

    REQUIRE(SUCCEEDED(layout->SetTextAlignment(DWRITE_TEXT_ALIGNMENT_TRAILING)));
    REQUIRE(SUCCEEDED(layout->SetParagraphAlignment(DWRITE_PARAGRAPH_ALIGNMENT_FAR)));
    const double first_baseline = text.run().lines[0].origin.y;
    REQUIRE(text.read(layout.get()));
    CHECK(text.run().lines[0].origin.x > 0.0);
    CHECK(text.run().lines[0].origin.y < first_baseline - text.units_per_em());
    CHECK(text.run().lines.size() == lines);
    for (const text_line& line : text.run().lines)  // the box is 130 wide; a space may hang over
        CHECK((line.origin.x + line.advance) * text.dips_per_unit() >= 129.9);
    meshed(text);
}

TEST_CASE("fonts and sizes may change inside a layout, and each glyph keeps its own", "[windows]")
{
    const test::font_files files{{dejavu, comic}};
    const std::wstring first = files.family(0), second = files.family(1);
    const auto layout = files.layout(L"aaa aaa aaa", 30.0f);
    REQUIRE(SUCCEEDED(layout->SetFontFamilyName(second.c_str(), range(4, 3))));
    REQUIRE(SUCCEEDED(layout->SetFontSize(60.0f, range(8, 3))));
    directwrite_text text;
    REQUIRE(text.read(layout.get()));
    const glyph_run& run = text.run();
    REQUIRE(run.glyphs.size() == 11);
    std::set<glyph_id> kinds;
    for (const placed_glyph& g : run.glyphs) kinds.insert(g.id);
    const directwrite_glyph a = text.glyph(run.glyphs[0].id), b = text.glyph(run.glyphs[4].id),
                            c = text.glyph(run.glyphs[8].id);
    CHECK(a.face != b.face);
    CHECK(a.em_size == 30.0);
    CHECK(b.em_size == 30.0);
    CHECK(c.em_size == 60.0);
    CHECK(c.index == a.index);
    outline small_a, large_a, other;
    REQUIRE(record(text, run.glyphs[0].id, small_a));
    REQUIRE(record(text, run.glyphs[4].id, other));
    REQUIRE(record(text, run.glyphs[8].id, large_a));
    CHECK(large_a.bounds.height() == Catch::Approx(2.0 * small_a.bounds.height()));
    // The x-height of both fonts is about half an em, whatever their units: 2048 and 1000.
    CHECK(other.bounds.height() / small_a.bounds.height() > 0.7);
    CHECK(other.bounds.height() / small_a.bounds.height() < 1.4);
    meshed(text);
}

TEST_CASE("a fallback font that steps in brings its own outlines", "[windows]")
{
    const test::font_files files{{comic, dejavu}};
    directwrite_text text;
    REQUIRE(text.read(files.layout(L"a", 30.0f).get()));
    REQUIRE(text.read(files.layout(L"a\x05D0", 30.0f).get()));  // a letter that the first font lacks
    REQUIRE(text.run().glyphs.size() == 2);
    // Either another face has it, or it is told to be missing; it is never another face's glyph under this one's name.
    const placed_glyph& g = text.run().glyphs[1];
    const directwrite_glyph one = text.glyph(text.run().glyphs[0].id), two = text.glyph(g.id);
    CHECK((one.face != two.face || g.missing));
    CHECK(text.run().missing == (g.missing ? 1u : 0u));
    meshed(text);
}

TEST_CASE("underlines and strike-throughs are rectangles at their lines' ends", "[windows]")
{
    const test::font_files files{{dejavu}};
    const auto layout = files.layout(L"under struck plain", 50.0f);
    REQUIRE(SUCCEEDED(layout->SetUnderline(TRUE, range(0, 5))));
    REQUIRE(SUCCEEDED(layout->SetStrikethrough(TRUE, range(6, 6))));
    directwrite_text text;
    REQUIRE(text.read(layout.get()));
    const glyph_run& run = text.run();
    REQUIRE(run.glyphs.size() == 20);
    CHECK(run.lines.size() == 1);
    const double baseline = run.lines[0].origin.y;
    bool below = false, above = false;
    for (std::size_t i = 18; i < 20; ++i) {
        const placed_glyph& bar = run.glyphs[i];
        CHECK(bar.cluster == no_cluster);
        CHECK_FALSE(bar.missing);
        CHECK(text.glyph(bar.id).face == nullptr);
        outline o;
        REQUIRE(record(text, bar.id, o));
        REQUIRE(o.curves.size() == 4);
        CHECK(o.bounds.width() > 4.0 * o.bounds.height());
        const double top = bar.origin.y + o.bounds.high.y - baseline, bottom = bar.origin.y + o.bounds.low.y - baseline;
        CHECK(top > bottom);
        const double begin = bar.origin.x + o.bounds.low.x, end = bar.origin.x + o.bounds.high.x;
        const bool under = top <= 0.0;
        (under ? below : above) = true;
        if (!under) CHECK(bottom > 0.0);
        CHECK(begin == Catch::Approx(run.glyphs[under ? 0 : 6].origin.x).margin(1.0));
        CHECK(end == Catch::Approx(run.glyphs[under ? 5 : 12].origin.x).margin(1.0));
    }
    CHECK((below && above));
    meshed(text);
}

TEST_CASE("a trimmed line ends with the ellipsis that the layout draws", "[windows]")
{
    const test::font_files files{{dejavu}};
    const auto layout = files.layout(L"a text that does not fit", 20.0f, 100.0f, 30.0f);
    REQUIRE(SUCCEEDED(layout->SetWordWrapping(DWRITE_WORD_WRAPPING_NO_WRAP)));
    com_ptr<IDWriteInlineObject> sign;
    REQUIRE(SUCCEEDED(files.factory()->CreateEllipsisTrimmingSign(layout.get(), sign.put())));
    DWRITE_TRIMMING how = {DWRITE_TRIMMING_GRANULARITY_CHARACTER, 0, 0};
    REQUIRE(SUCCEEDED(layout->SetTrimming(&how, sign.get())));
    directwrite_text text;
    REQUIRE(text.read(layout.get()));
    const glyph_run& run = text.run();
    REQUIRE(run.lines.size() == 1);
    REQUIRE(run.glyphs.size() > 3);
    CHECK(run.glyphs.size() < 20);
    CHECK(run.glyphs.back().cluster == no_cluster);
    CHECK(run.glyphs.back().origin.y == Catch::Approx(run.lines[0].origin.y));
    CHECK((run.lines[0].origin.x + run.lines[0].advance) * text.dips_per_unit() <= 101.0);
    REQUIRE(text.objects().size() == 1);
    CHECK(text.objects()[0].object == sign.get());
    meshed(text);
}

TEST_CASE("inline objects are reported where they stand, asked to draw, and let go", "[windows]")
{
    const test::font_files files{{dejavu}};
    box_object box;
    {
        const auto layout = files.layout(L"ab*cd", 20.0f);
        REQUIRE(SUCCEEDED(layout->SetInlineObject(&box, range(2, 1))));
        const ULONG held = box.references;
        directwrite_text text;
        int mark = 0;
        REQUIRE(text.read(layout.get(), &mark));
        CHECK(box.references == held + 1);
        CHECK(box.context == &mark);
        REQUIRE(text.objects().size() == 1);
        const directwrite_object& o = text.objects()[0];
        CHECK(o.object == &box);
        CHECK(o.line == 0);
        CHECK((o.high.x - o.low.x) * text.dips_per_unit() == Catch::Approx(30.0));
        CHECK((o.high.y - o.low.y) * text.dips_per_unit() == Catch::Approx(20.0));
        CHECK(text.run().lines[0].origin.y - o.low.y == Catch::Approx(5.0 / text.dips_per_unit()));
        CHECK(text.run().glyphs.size() == 4);
        CHECK(text.run().glyphs[2].origin.x >= o.high.x - 1.0);

        box.draws_itself = true;  // it cannot draw itself for ever
        REQUIRE(text.read(layout.get()));
        CHECK(text.objects().size() > 1);
        box.draws_itself = false;
        box.answer = E_FAIL;
        const error e = text.read(layout.get()).error();
        CHECK(e == error::font_library_failed);
        CHECK(e.count == 0x80004005u);
        CHECK(box.references == held);
        CHECK(text.run().glyphs.empty());
        CHECK(text.objects().empty());
        box.answer = S_OK;
        CHECK(text.read(layout.get()));
    }
    CHECK(box.references == 1);
}

TEST_CASE("lone halves of surrogate pairs are counted", "[windows]")
{
    const test::font_files files{{dejavu}};
    directwrite_text text;
    REQUIRE(text.read(files.layout(L"ab\xD800z", 20.0f).get()));
    CHECK(text.run().invalid_units == 1);
    CHECK(text.run().first_invalid_unit == 2);
}

TEST_CASE("columns are refused", "[windows]")
{
    const test::font_files files{{dejavu}};
    const auto layout = files.layout(L"ab", 20.0f);
    directwrite_text text;
    REQUIRE(SUCCEEDED(layout->SetFlowDirection(DWRITE_FLOW_DIRECTION_RIGHT_TO_LEFT)));
    CHECK(text.read(layout.get()) == error::bad_option);
    REQUIRE(SUCCEEDED(layout->SetReadingDirection(DWRITE_READING_DIRECTION_TOP_TO_BOTTOM)));
    CHECK(text.read(layout.get()) == error::bad_option);
    CHECK(text.run().glyphs.empty());
}

TEST_CASE("an empty layout is one empty line", "[windows]")
{
    const test::font_files files{{dejavu}};
    directwrite_text text;
    REQUIRE(text.read(files.layout(L"", 20.0f).get()));
    CHECK(text.run().glyphs.empty());
    CHECK(text.run().lines.size() == 1);
    text_mesher mesher{text};
    auto plan = mesher.plan(text.run());
    REQUIRE(plan);
    CHECK(plan->size().vertices == 0);
}

TEST_CASE(
    "reading gives back every reference, whether it succeeds or runs out of memory, and allocates no more when warm",
    "[windows]")
{
    const test::font_files files{{dejavu}};
    const auto layout = files.layout(L"some text, \x05D0\x05D1, and more", 20.0f, 90.0f);
    REQUIRE(SUCCEEDED(layout->SetUnderline(TRUE, range(0, 9))));
    counting_memory counted;
    IDWriteFontFace* face = nullptr;
    {
        directwrite_text first;
        REQUIRE(first.read(layout.get()));
        face = first.glyph(first.run().glyphs[0].id).face;
        face->AddRef();
    }
    const ULONG layout_held = references(layout.get()), face_held = references(face);
    {
        directwrite_text text{counted.source()};
        for (int i = 0; i < 5; ++i) REQUIRE(text.read(layout.get()));
        const std::size_t warm = counted.requests;
        REQUIRE(text.read(layout.get()));
        CHECK(counted.requests == warm);
        CHECK(references(layout.get()) == layout_held);
        CHECK(references(face) == face_held + 1);
        directwrite_text moved{std::move(text)};
        CHECK(moved.run().glyphs.size() > 10);
        CHECK(references(face) == face_held + 1);
        text = std::move(moved);
        CHECK(references(face) == face_held + 1);
    }
    CHECK(counted.bytes_held == 0);
    CHECK(references(layout.get()) == layout_held);
    CHECK(references(face) == face_held);
    const std::size_t all = counted.requests;
    REQUIRE(all > 5);
    for (std::size_t at = 1; at <= all; ++at) {
        counting_memory failing{.fail_at = at};
        directwrite_text text{failing.source()};
        CHECK(text.read(layout.get()) == error::out_of_memory);
        CHECK(text.run().glyphs.empty());
        CHECK(references(face) == face_held);
        failing.fail_at = 0;
        CHECK(text.read(layout.get()));
    }
    CHECK(references(face) == face_held);
    CHECK(references(layout.get()) == layout_held);
    face->Release();
}

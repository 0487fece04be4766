// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"
#include "windows/fake_face.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstring>
#include <cwchar>
#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using namespace test;

glyph_run shaped(directwrite_font& font, text_view text, const shape_options& how = {})
{
    glyph_run run;
    REQUIRE(layout(font, text, how, {}, run));
    return run;
}

std::vector<cluster_id> clusters(const glyph_run& run)
{
    std::vector<cluster_id> all;
    for (const placed_glyph& g : run.glyphs) all.push_back(g.cluster);
    return all;
}

LOGFONTW described(const wchar_t* name, LONG weight = FW_NORMAL)
{
    LOGFONTW made = {};
    made.lfHeight = -64;
    made.lfWeight = weight;
    made.lfCharSet = DEFAULT_CHARSET;
    std::wcsncpy(made.lfFaceName, name, LF_FACESIZE - 1);
    return made;
}

/// A device context of memory with a font of GDI's selected, as D3DXCreateText took it.
class gdi_context {
public:
    explicit gdi_context(const LOGFONTW& font) : font_{CreateFontIndirectW(&font)}, before_{SelectObject(dc_, font_)} {}
    gdi_context(const gdi_context&) = delete;
    gdi_context& operator=(const gdi_context&) = delete;
    ~gdi_context()
    {
        SelectObject(dc_, before_);
        DeleteObject(font_);
        DeleteDC(dc_);
    }
    [[nodiscard]] HDC get() const { return dc_; }

private:
    HDC dc_ = CreateCompatibleDC(nullptr);
    HFONT font_;
    HGDIOBJ before_;
};

struct wrapped_fake {
    fake_face face;
    result<directwrite_font> font = directwrite_font::wrap(&face);
};

}  // namespace

TEST_CASE("a font that cannot be opened reports why", "[windows]")
{
    CHECK(opened("/nowhere/at/all.ttf").error() == error::unreadable_file);
    CHECK(opened("/usr/share/fonts/truetype/dejavu").error() == error::unreadable_file);
    CHECK(opened(TYPEMESH_TEST_DATA "/workload/README.md").error() == error::not_a_font);
    CHECK(opened(dejavu, {1, {}}).error() == error::no_such_face);
    CHECK(opened(dejavu, {1, {}}).error().count == 1);
    CHECK(opened(micro_hei, {7, {}}).error().count == 2);
    const variation bold[] = {{"wght", 700.0f}}, bad[] = {{"wght", std::numeric_limits<float>::quiet_NaN()}};
    CHECK(opened(dejavu, {0, bold}).error() == error::unknown_variation);
    CHECK(opened(dejavu, {0, bad}).error() == error::bad_option);
    CHECK(directwrite_font::open_family(L"No Family Of This Name").error() == error::no_such_family);
}

TEST_CASE("an HRESULT becomes its own error, or font_library_failed with its number", "[windows]")
{
    for (const HRESULT success : {S_OK, S_FALSE}) CHECK_FALSE(directwrite_error(success));
    CHECK(directwrite_error(E_OUTOFMEMORY) == error::out_of_memory);
    CHECK(directwrite_error(DWRITE_E_FILEFORMAT) == error::not_a_font);
    CHECK(directwrite_error(DWRITE_E_NOFONT) == error::no_such_family);
    for (const HRESULT unreadable :
         {DWRITE_E_FILENOTFOUND, DWRITE_E_FILEACCESS, HRESULT_FROM_WIN32(ERROR_FILE_NOT_FOUND),
          HRESULT_FROM_WIN32(ERROR_PATH_NOT_FOUND), HRESULT_FROM_WIN32(ERROR_ACCESS_DENIED)}) {
        CAPTURE(unreadable);
        CHECK(directwrite_error(unreadable) == error::unreadable_file);
    }
    const error e = directwrite_error(E_INVALIDARG);
    CHECK(e == error::font_library_failed);
    CHECK(e.count == 0x80070057u);
}

TEST_CASE("a font is opened from a file, from a collection and from a face", "[windows]")
{
    auto file = opened(dejavu);
    REQUIRE(file);
    CHECK(file->units_per_em() == 2048);
    CHECK(file->glyph_count() > 6000);
    const line_metrics m = file->metrics(direction::left_to_right);
    CHECK(m.ascender > 1000.0);
    CHECK(m.descender < -200.0);

    const test::font_files files{{dejavu, comic}};
    for (UINT32 i = 0; i < 2; ++i) {
        auto member = directwrite_font::open_family(files.family(i).c_str(), {}, files.collection(), files.factory());
        REQUIRE(member);
        CHECK(member->units_per_em() == (files.family(i) == L"DejaVu Sans" ? 2048 : 1000));
    }
    auto installed = directwrite_font::open_family(L"DejaVu Sans", {.weight = DWRITE_FONT_WEIGHT_BOLD});
    REQUIRE(installed);
    CHECK(shaped(*installed, "bold").lines[0].advance > shaped(*file, "bold").lines[0].advance);
    auto same = directwrite_font::wrap(file->handle());
    REQUIRE(same);
    CHECK(same->glyph_count() == file->glyph_count());
}

TEST_CASE("the font that GDI has selected is opened, even if its name is no DirectWrite family", "[windows]")
{
    const auto key_of = [](const char* path) { return opened(path)->variation_key(); };
    const struct {
        const wchar_t* name;
        LONG weight;
        const char* path;
        bool is_family;
    } fonts[] = {{L"DejaVu Sans", FW_NORMAL, dejavu, true},
                 {L"DejaVu Sans", FW_BOLD, "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", true},
                 {L"Comic Neue Light", FW_NORMAL, "/usr/share/fonts/opentype/comic-neue/ComicNeue-Light.otf", false}};
    for (const auto& f : fonts) {
        const gdi_context context{described(f.name, f.weight)};
        auto font = directwrite_font::open_selected(context.get());
        REQUIRE(font);
        CHECK(font->variation_key() == key_of(f.path));
        CHECK(bool{directwrite_font::open_family(f.name)} == f.is_family);
        CHECK(shaped(*font, "age").glyphs.size() == 3);
    }
    const gdi_context context{described(L"DejaVu Sans")};
    const test::font_files files{{dejavu}};
    CHECK(directwrite_font::open_selected(context.get(), files.factory()));
    const HDC gone = CreateCompatibleDC(nullptr);
    DeleteDC(gone);
    CHECK(directwrite_font::open_selected(gone).error().code != error::none);
}

TEST_CASE("a LOGFONT is opened by its name, weight and slant", "[windows]")
{
    const auto plain = directwrite_font::open_described(described(L"DejaVu Sans"));
    REQUIRE(plain);
    CHECK(plain->variation_key() == opened(dejavu)->variation_key());
    const auto bold = directwrite_font::open_described(described(L"DejaVu Sans", FW_BOLD));
    REQUIRE(bold);
    CHECK(bold->variation_key() == opened("/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf")->variation_key());
    LOGFONTW slanted = described(L"DejaVu Sans");
    slanted.lfItalic = TRUE;
    const auto oblique = directwrite_font::open_described(slanted);
    REQUIRE(oblique);
    CHECK(oblique->variation_key() != plain->variation_key());
    CHECK(directwrite_font::open_described(described(L"No Family Of This Name")).error() == error::no_such_family);

    // Of an HFONT.
    const HFONT held = CreateFontIndirectW(&slanted);
    LOGFONTW read = {};
    REQUIRE(GetObjectW(held, sizeof read, &read) == sizeof read);
    CHECK(directwrite_font::open_described(read)->variation_key() == oblique->variation_key());
    DeleteObject(held);
}

TEST_CASE("an outline comes y up, at one unit per font unit", "[windows]")
{
    wrapped_fake fake;
    REQUIRE(fake.font);
    fake.face.draws = [](auto& to) { return square(to), S_OK; };
    outline o;
    REQUIRE(record(*fake.font, 3, o));
    CHECK(fake.face.asked_em_size == 1000.0f);
    CHECK(o.bounds.low == point{0.0, 0.0});
    CHECK(o.bounds.high == point{100.0, 100.0});
}

TEST_CASE("an open figure is closed, and a hollow figure is not drawn", "[windows]")
{
    wrapped_fake fake;
    REQUIRE(fake.font);
    outline closed, o;
    fake.face.draws = [](auto& to) { return square(to), S_OK; };
    REQUIRE(record(*fake.font, 3, closed));
    fake.face.draws = [](auto& to) { return square(to, 100.0f, D2D1_FIGURE_END_OPEN), S_OK; };
    REQUIRE(record(*fake.font, 3, o));
    CHECK(o.curves.size() == closed.curves.size());
    CHECK(o.contour_count() == 1);
    fake.face.draws = [](auto& to) {
        square(to, 100.0f, D2D1_FIGURE_END_CLOSED, D2D1_FIGURE_BEGIN_HOLLOW);
        square(to);
        return S_OK;
    };
    REQUIRE(record(*fake.font, 3, o));
    CHECK(o.contour_count() == 1);
}

TEST_CASE("the fill mode of each glyph applies to that glyph only", "[windows]")
{
    wrapped_fake fake;
    REQUIRE(fake.font);
    outline o;
    for (const auto mode : {D2D1_FILL_MODE_ALTERNATE, D2D1_FILL_MODE_WINDING}) {
        fake.face.draws = [mode](auto& to) { return to.SetFillMode(mode), square(to), S_OK; };
        REQUIRE(record(*fake.font, 3, o));
        CHECK(o.rule == (mode == D2D1_FILL_MODE_ALTERNATE ? fill_rule::even_odd : fill_rule::non_zero));
    }
    fake.face.draws = [](auto& to) { return square(to), S_OK; };
    REQUIRE(record(*fake.font, 3, o));
    CHECK(o.rule == fill_rule::non_zero);
}

TEST_CASE("quadratics written as cubics are converted back, and true cubics and CFF's curves are not", "[windows]")
{
    fake_face face;
    const auto draw = [&](point p0, point c1, point c2, point p3) {
        auto font = directwrite_font::wrap(&face);
        REQUIRE(font);
        face.draws = [=](ID2D1SimplifiedGeometrySink& to) {
            const auto at = [](point p) { return D2D1_POINT_2F{float(p.x), float(-p.y)}; };
            to.BeginFigure(at(p0), D2D1_FIGURE_BEGIN_FILLED);
            const D2D1_BEZIER_SEGMENT c{at(c1), at(c2), at(p3)};
            to.AddBeziers(&c, 1);
            to.EndFigure(D2D1_FIGURE_END_CLOSED);
            return S_OK;
        };
        outline o;
        REQUIRE(record(*font, 1, o));
        return curve{o.curves[0]};
    };
    for (int k = 0; k < 200; ++k) {
        const point p0{double(k * 37 % 2048), double(k * 91 % 1500)},
            q{double(k * 53 % 1999), double(k * 17 % 1777) - 300},
            p3{double(k * 29 % 2000) + 0.5, double(k * 71 % 1300) + 0.5};
        const point c1 = p0 + (2.0 / 3) * (q - p0), c2 = p3 + (2.0 / 3) * (q - p3);
        const auto floored = [](point p) { return point{std::floor(p.x * 64) / 64, std::floor(p.y * 64) / 64}; };
        for (const bool wine : {false, true}) {
            const curve lowered = wine ? draw(p0, floored(c1), floored(c2), p3) : draw(p0, c1, c2, p3);
            REQUIRE(lowered.degree == 2);
            CHECK(lowered.p[1] == q);
        }
    }
    CHECK(draw({0, 0}, {0, 552}, {448, 1000}, {1000, 1000}).degree == 3);
    CHECK(draw({0, 0}, {10, 20}, {31, 20}, {40, 0}).degree == 3);
    face.has_glyf = false;
    CHECK(directwrite_font::wrap(&face).error() == error::no_outlines);
}

TEST_CASE("a coordinate that is not a number, or beyond the grid, refuses its glyph with its own error", "[windows]")
{
    wrapped_fake fake;
    REQUIRE(fake.font);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f}) {
        for (int place = 0; place < 5; ++place) {
            fake.face.draws = [=](auto& to) {
                to.BeginFigure({place == 0 ? bad : 0.0f, 0.0f}, D2D1_FIGURE_BEGIN_FILLED);
                const D2D1_POINT_2F line{100.0f, place == 1 ? bad : 0.0f};
                to.AddLines(&line, 1);
                const D2D1_BEZIER_SEGMENT c{{place == 2 ? bad : 9.0f, 1.0f},
                                            {5.0f, place == 3 ? bad : 3.0f},
                                            {place == 4 ? bad : 2.0f, -70.0f}};
                to.AddBeziers(&c, 1);
                to.EndFigure(D2D1_FIGURE_END_CLOSED);
                return S_OK;
            };
            glyph_run run;
            run.units_per_em = 1000;
            REQUIRE(run.glyphs.push_back({4, 17, {}, false}));
            text_mesher mesher{*fake.font};
            auto plan = mesher.plan(run);
            REQUIRE(plan);
            CHECK(plan->report().refused == 1);
            CHECK(plan->report().first_refusal ==
                  (bad == 3e38f ? error::outline_beyond_grid : error::outline_not_finite));
            CHECK(plan->report().first_refusal.glyph == 4);
            CHECK(plan->report().first_refusal.cluster == 17);
        }
    }
}

TEST_CASE("a face that fails, or breaks the sink's rules, gives an error with the glyph", "[windows]")
{
    wrapped_fake fake;
    REQUIRE(fake.font);
    outline o;
    fake.face.draws = [](auto& to) { return square(to), E_FAIL; };
    const error failed = record(*fake.font, 3, o).error();
    CHECK(failed == error::font_library_failed);
    CHECK(failed.count == 0x80004005u);
    CHECK(failed.glyph == 3);
    fake.face.draws = [](auto&) { return E_OUTOFMEMORY; };
    CHECK(record(*fake.font, 3, o) == error::out_of_memory);
    fake.face.draws = [](auto& to) {
        const D2D1_POINT_2F line{1.0f, 1.0f};
        to.AddLines(&line, 1);
        return S_OK;
    };
    CHECK(record(*fake.font, 3, o) == error::bad_outline);
    CHECK(record(*fake.font, 10, o) == error::unknown_glyph);
    fake.face.glyphs = 0;
    CHECK(directwrite_font::wrap(&fake.face).error() == error::not_a_font);
}

TEST_CASE("every reference is released", "[windows]")
{
    SECTION("to a face, by success and by failure")
    {
        fake_face face;
        {
            auto font = directwrite_font::wrap(&face);
            REQUIRE(font);
            CHECK(face.references == 2);
            directwrite_font moved = *std::move(font);
            outline o;
            face.draws = [](auto& to) {
                IUnknown* same = nullptr;
                REQUIRE(SUCCEEDED(to.QueryInterface(__uuidof(IUnknown), reinterpret_cast<void**>(&same))));
                same->Release();
                return E_FAIL;
            };
            CHECK(record(moved, 1, o) == error::font_library_failed);
            CHECK(face.references == 2);
        }
        CHECK(face.references == 1);
        face.glyphs = 0;
        CHECK_FALSE(directwrite_font::wrap(&face));
        CHECK(face.references == 1);
    }
    SECTION("to a factory and a collection")
    {
        const test::font_files files{{dejavu}};
        const std::wstring path = windows_path(dejavu);
        const auto once = [&] {
            auto a = directwrite_font::open(path.c_str(), {}, files.factory());
            auto b = directwrite_font::open_family(L"DejaVu Sans", {}, files.collection(), files.factory());
            CHECK((a && b));
            if (a) CHECK(shaped(*a, "text").glyphs.size() == 4);
            CHECK_FALSE(directwrite_font::open(L"Z:\\nowhere.ttf", {}, files.factory()));
            CHECK_FALSE(directwrite_font::open_family(L"Nobody", {}, files.collection(), files.factory()));
        };
        once();  // DirectWrite keeps what it has opened
        const ULONG factory = references(files.factory()), collection = references(files.collection());
        for (int i = 0; i < 10; ++i) once();
        CHECK(references(files.factory()) == factory);
        CHECK(references(files.collection()) == collection);
    }
}

TEST_CASE("plain text is shaped: clusters of either encoding, kerning on and off, missing glyphs", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    const glyph_run hello = shaped(*font, "A\xCE\xA9 \xF0\x9D\x94\xB8z");
    CHECK(clusters(hello) == std::vector<cluster_id>{0, 1, 3, 4, 8});
    CHECK(clusters(shaped(*font, u"AΩ 𝔸z")) == std::vector<cluster_id>{0, 1, 2, 3, 5});
    for (std::size_t i = 0; i < 5; ++i) CHECK(shaped(*font, u"AΩ 𝔸z").glyphs[i].id == hello.glyphs[i].id);
    CHECK(hello.missing == 0);
    CHECK(hello.lines.size() == 1);
    CHECK(hello.lines[0].advance > 2000.0);

    const glyph_run broken = shaped(*font, "a\xFFz");
    CHECK(broken.invalid_units == 1);
    CHECK(broken.first_invalid_unit == 1);
    CHECK(broken.glyphs.size() == 3);

    const glyph_run lacking = shaped(*font, u"a\U0001F9FFb");
    CHECK(lacking.missing == 1);
    CHECK(lacking.first_missing == 1);
    CHECK(lacking.glyphs[1].missing);
    CHECK(shaped(*font, u"a\u00ADb\u200Bc").missing == 0);

    const feature off[] = {{"liga", 0}}, bad[] = {{"li\1a", 1}};
    CHECK(shaped(*font, "office").glyphs.size() < 6);
    CHECK(shaped(*font, "office", {.features = off}).glyphs.size() == 6);
    glyph_run run;
    CHECK(layout(*font, "x", {.features = bad}, {}, run) == error::bad_feature);
    CHECK(layout(*font, "x", {.script = "Lat"}, {}, run) == error::bad_option);
    CHECK(layout(*font, "x", {.script = "Qqqq"}, {}, run) == error::bad_option);
    CHECK(layout(*font, "x", {.script = "Latn"}, {}, run));
    CHECK(shaped(*font, "").glyphs.empty());
    CHECK(shaped(*font, "a\nb\r\nc").lines.size() == 3);
}

TEST_CASE("spaced letters have no ligatures unless these are requested by name, and are moved by the spacing",
          "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    glyph_run run;
    REQUIRE(layout(*font, "office", {.letter_spacing = 0.125}, {}, run));
    REQUIRE(run.glyphs.size() == 6);
    const glyph_run single = shaped(*font, "office", {.ligatures = false});
    REQUIRE(single.glyphs.size() == 6);
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(run.glyphs[i].origin.x == single.glyphs[i].origin.x + 256.0 * static_cast<double>(i));
    const feature on[] = {{"liga", 1}};
    CHECK(shaped(*font, "office", {.features = on, .ligatures = false}).glyphs.size() < 6);
}

TEST_CASE("right-to-left text comes out from left to right, letters joined", "[windows]")
{
    auto font = opened(amiri);
    REQUIRE(font);
    const glyph_run run = shaped(*font, u"مرحبا");
    REQUIRE(run.glyphs.size() >= 4);
    for (std::size_t i = 1; i < run.glyphs.size(); ++i) {
        CHECK(run.glyphs[i].cluster <= run.glyphs[i - 1].cluster);
        CHECK(run.glyphs[i].origin.x >= run.glyphs[i - 1].origin.x - 1.0);
    }
    CHECK(run.glyphs.back().cluster == 0);
    // The line extends to the left.
    CHECK(std::fabs(run.lines[0].origin.x + run.lines[0].advance) < 1e-6);
    CHECK(run.glyphs[0].origin.x < 0.0);
    // A letter inside a word has another form than alone.
    CHECK(shaped(*font, u"ح").glyphs[0].id != run.glyphs[run.glyphs.size() - 3].id);
}

TEST_CASE("a line of both directions is ordered by its levels", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    // In a left-to-right line: ab, the Arabic word from its end to its beginning with its number before it, cd.
    CHECK(clusters(shaped(*font, u"ab\u05D0\u05D1\u05D2 12 cd")) ==
          std::vector<cluster_id>{0, 1, 6, 7, 5, 4, 3, 2, 8, 9, 10});
    // The same in a right-to-left line.
    CHECK(clusters(shaped(*font, u"\u05D0\u05D1 ab \u05D2")) == std::vector<cluster_id>{6, 5, 3, 4, 2, 1, 0});
    CHECK(clusters(shaped(*font, u"ab \u05D0", {.direction = direction::right_to_left})) ==
          std::vector<cluster_id>{3, 2, 0, 1});
    const glyph_run run = shaped(*font, u"ab\u05D0\u05D1\u05D2 12 cd");
    for (std::size_t i = 1; i < run.glyphs.size(); ++i) CHECK(run.glyphs[i].origin.x > run.glyphs[i - 1].origin.x);
}

TEST_CASE("a tab moves to the next tab stop, and the letters on both sides keep their own direction", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    const double stop = 4.0 * (shaped(*font, "x x").lines[0].advance - shaped(*font, "xx").lines[0].advance);
    const glyph_run right = shaped(*font, u"ab\tc"), left = shaped(*font, u"\u05D0\u05D1\t12");
    for (const glyph_run* run : {&right, &left}) {
        CHECK(run->missing == 0);
        CHECK(run->glyphs.size() == (run == &right ? 3u : 4u));
    }
    CHECK(clusters(right) == std::vector<cluster_id>{0, 1, 3});
    CHECK(right.glyphs[2].origin.x == 2.0 * stop);  // the first stop is nearer than half a digit
    CHECK(clusters(left) == std::vector<cluster_id>{3, 4, 1, 0});
    CHECK(std::fabs(left.glyphs[0].origin.x + left.lines[0].advance) < 1e-6);
    CHECK(std::fabs(left.lines[0].advance - (2.0 * stop + shaped(*font, "12").lines[0].advance)) < 1e-6);
    CHECK(clusters(shaped(*font, u"ab\t\u05D0\u05D1")) == std::vector<cluster_id>{0, 1, 4, 3});
    CHECK(clusters(shaped(*font, u"ab\t\u05D0\u05D1", {.direction = direction::right_to_left})) ==
          std::vector<cluster_id>{4, 3, 0, 1});
}

TEST_CASE("columns run downwards, glyph below glyph, Latin letters on their side", "[windows]")
{
    auto font = opened(micro_hei);
    REQUIRE(font);
    const glyph_run run = shaped(*font, u"世界、こ", {.direction = direction::top_to_bottom});
    REQUIRE(run.glyphs.size() == 4);
    for (std::size_t i = 1; i < 4; ++i) CHECK(run.glyphs[i].origin.y < run.glyphs[i - 1].origin.y);
    CHECK(run.lines[0].advance > 3.0 * font->units_per_em());
    for (const placed_glyph& g : run.glyphs) CHECK(std::fabs(g.origin.x + font->units_per_em() / 2) < 200.0);
    CHECK(run.glyph_styles.empty());
    const shape_options upright{.direction = direction::top_to_bottom, .columns = {.latin = column_latin::upright}};
    CHECK_FALSE(shaped(*font, u"世A", {.direction = direction::top_to_bottom}).glyph_styles.empty());
    CHECK(shaped(*font, u"世A", upright).glyph_styles.empty());
}

TEST_CASE("a text longer than DirectWrite's limit is split and joined", "[windows]")
{
    auto font = opened(dejavu);
    REQUIRE(font);
    std::string text;
    for (int i = 0; i < 70000; ++i) text += i % 7 == 6 ? ' ' : 'x';
    const glyph_run run = shaped(*font, text);
    REQUIRE(run.glyphs.size() == text.size());
    for (std::size_t i = 0; i < text.size(); i += 997) CHECK(run.glyphs[i].cluster == i);
    const glyph_run pair = shaped(*font, "xx");
    CHECK(std::fabs(run.glyphs[69999].origin.x - run.glyphs[69998].origin.x - pair.glyphs[1].origin.x) < 1e-6);
}

TEST_CASE("a word from DirectWrite has a closed mesh that faces outwards, both of TrueType and of CFF", "[windows]")
{
    for (const char* path : {dejavu, comic}) {
        INFO(path);
        auto font = opened(path);
        REQUIRE(font);
        text_mesher mesher{*font};
        full_mesh m;
        auto made = mesher.build(u8"Hello, world! &%$@ äöß", into(m.vertices, m.indices));
        REQUIRE(made);
        CHECK(made->complete());
        CHECK(examine(m).unmatched_edges == 0);
        CHECK(volume(m.vertices, m.indices) > 0.0);
        auto plan = mesher.plan("oO&");
        REQUIRE(plan);
        full_mesh again;
        REQUIRE(plan->write(into(again.vertices, again.indices)));
        for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
            const mesh_range front = plan->range(g, part::front);
            for (std::uint32_t i = front.first_vertex; i < front.first_vertex + front.vertex_count; ++i)
                REQUIRE(again.vertices[i].normal.z > 0.99f);
        }
    }
}

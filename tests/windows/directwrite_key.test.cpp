// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "windows/fake_face.hpp"
#include "windows/fake_varied_face.hpp"
#include "windows/inline_object.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/adapt/directwrite_text.hpp>
#include <typemesh/typemesh.hpp>

#include <set>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using namespace test;
constexpr char serif[] = "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf";  // as many units as dejavu

/// The mesh of a text is the same with the cache, warm or not, as without.
void check_unharmed(directwrite_text& text, glyph_cache<>& cache)
{
    const auto built = [&](bool cached) {
        full_mesh m;
        if (cached)
            REQUIRE(text_mesher{text}.with(cached_in{cache, 1}).build(text.run(), into(m.vertices, m.indices)));
        else
            REQUIRE(text_mesher{text}.build(text.run(), into(m.vertices, m.indices)));
        return m;
    };
    const full_mesh expected = built(false);
    REQUIRE(expected.indices.size() > 0);
    for (int i = 0; i < 2; ++i) {
        const full_mesh m = built(true);
        REQUIRE(m.indices == expected.indices);
        REQUIRE(m.vertices.size() == expected.vertices.size());
        std::size_t others = 0;
        for (std::size_t k = 0; k < m.vertices.size(); ++k)
            others += !(m.vertices[k].position == expected.vertices[k].position);
        CHECK(others == 0);
    }
}

/// An inline object that draws glyph 3 of a face.
class drawn_object final : public inline_object {
public:
    IDWriteFontFace* face = nullptr;

    HRESULT STDMETHODCALLTYPE Draw(void* context, IDWriteTextRenderer* to, FLOAT x, FLOAT y, BOOL, BOOL,
                                   IUnknown*) noexcept override
    {
        const UINT16 glyph = 3;
        const FLOAT advance = 20.0f;
        const DWRITE_GLYPH_RUN run = {face, 20.0f, 1, &glyph, &advance, nullptr, FALSE, 0};
        const DWRITE_GLYPH_RUN_DESCRIPTION of = {};
        return to->DrawGlyphRun(context, x, y, DWRITE_MEASURING_MODE_NATURAL, &run, &of, nullptr);
    }
};

std::uint64_t key_of_face(IDWriteFontFace* face)
{
    const auto font = directwrite_font::wrap(face);
    REQUIRE(font);
    return font->variation_key();
}

}  // namespace

TEST_CASE("a DirectWrite font's key depends on font, face and simulations, and is the same when it is opened again",
          "[windows]")
{
    const auto opened = [](const char* path, std::uint32_t face) {
        auto font = directwrite_font::open(windows_path(path).c_str(), {face, {}});
        REQUIRE(font);
        return font;
    };
    CHECK(opened(dejavu, 0)->variation_key() == opened(dejavu, 0)->variation_key());
    std::set<std::uint64_t> fonts;
    for (const char* path : {dejavu, serif, comic, "/usr/share/fonts/opentype/comic-neue/ComicNeue-Bold.otf"})
        CHECK(fonts.insert(opened(path, 0)->variation_key()).second);
    CHECK(opened(micro_hei, 0)->variation_key() != opened(micro_hei, 1)->variation_key());

    const test::font_files files{{dejavu}};
    com_ptr<IDWriteFontFile> file;
    REQUIRE(SUCCEEDED(files.factory()->CreateFontFileReference(windows_path(dejavu).c_str(), nullptr, file.put())));
    IDWriteFontFile* const one[] = {file.get()};
    std::set<std::uint64_t> keys;
    glyph_cache cache;
    for (const auto how : {DWRITE_FONT_SIMULATIONS_NONE, DWRITE_FONT_SIMULATIONS_BOLD, DWRITE_FONT_SIMULATIONS_OBLIQUE,
                           DWRITE_FONT_SIMULATIONS_BOLD | DWRITE_FONT_SIMULATIONS_OBLIQUE}) {
        com_ptr<IDWriteFontFace> face;
        REQUIRE(SUCCEEDED(files.factory()->CreateFontFace(DWRITE_FONT_FACE_TYPE_TRUETYPE, 1, one, 0, how, face.put())));
        CHECK(keys.insert(key_of_face(face.get())).second);
        CHECK(key_of_face(face.get()) == key_of_face(face.get()));
        auto font = directwrite_font::wrap(face.get());
        full_mesh cached, plain;
        REQUIRE(text_mesher{*font}.with(cached_in{cache, 1}).build("age", into(cached.vertices, cached.indices)));
        REQUIRE(text_mesher{*font}.build("age", into(plain.vertices, plain.indices)));
        REQUIRE(cached.indices == plain.indices);
        for (std::size_t k = 0; k < plain.vertices.size(); ++k)
            REQUIRE(cached.vertices[k].position == plain.vertices[k].position);
    }
}

TEST_CASE("a DirectWrite font's key depends on its axes, and is unique if these are not known", "[windows]")
{
    fake_varied_face a, b;
    a.axes = {{DWRITE_FONT_AXIS_TAG_WEIGHT, 400.0f}, {DWRITE_FONT_AXIS_TAG_WIDTH, 100.0f}};
    b.axes = a.axes;
    CHECK(key_of_face(&a) == key_of_face(&b));
    b.axes[1].value = 99.0f;
    CHECK(key_of_face(&a) != key_of_face(&b));
    std::swap(b.axes[0].value, b.axes[1].value);
    CHECK(key_of_face(&a) != key_of_face(&b));
    b.axes.clear();
    CHECK(key_of_face(&a) != key_of_face(&b));
    a.axes.assign(65, {DWRITE_FONT_AXIS_TAG_WEIGHT, 400.0f});
    b.axes = a.axes;
    CHECK(key_of_face(&a) != key_of_face(&b));
    a.axes.resize(3);
    b.axes.resize(3);
    CHECK(key_of_face(&a) == key_of_face(&b));
    a.answer = b.answer = E_FAIL;
    CHECK(key_of_face(&a) != key_of_face(&b));
}

TEST_CASE("layouts with faces, sizes or lines in different orders share a cache and keep their own letters",
          "[windows]")
{
    const test::font_files files{{dejavu, comic, serif}};
    const std::wstring second = files.family(1), third = files.family(2);
    glyph_cache cache;
    directwrite_text text;
    const auto read = [&](auto&& changes) {
        const auto layout = files.layout(L"aga aga", 30.0f);
        changes(*layout.get());
        REQUIRE(text.read(layout.get()));
        check_unharmed(text, cache);
        return text.variation_key();
    };
    const auto family = [](IDWriteTextLayout& l, const std::wstring& name, UINT32 from) {
        REQUIRE(SUCCEEDED(l.SetFontFamilyName(name.c_str(), range(from, 3))));
    };
    std::vector<std::uint64_t> keys;
    for (int again = 0; again < 2; ++again) {
        keys.push_back(read([](IDWriteTextLayout&) {}));
        keys.push_back(read([&](IDWriteTextLayout& l) { family(l, second, 4); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { family(l, second, 0); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { family(l, third, 4); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { family(l, third, 0); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetFontSize(60.0f, range(4, 3)))); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetFontSize(50.0f, range(4, 3)))); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetFontSize(60.0f, range(0, 3)))); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetUnderline(TRUE, range(0, 3)))); }));
        keys.push_back(read([&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetUnderline(TRUE, range(0, 2)))); }));
        keys.push_back(read(
            [&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetFontWeight(DWRITE_FONT_WEIGHT_BOLD, range(0, 3)))); }));
        keys.push_back(read(  // simulated in all letters: the family has no bold member
            [&](IDWriteTextLayout& l) { REQUIRE(SUCCEEDED(l.SetFontWeight(DWRITE_FONT_WEIGHT_BOLD, range(0, 7)))); }));
    }
    const std::size_t kinds = keys.size() / 2;
    CHECK(std::set<std::uint64_t>(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(kinds)).size() == kinds);
    for (std::size_t i = 0; i < kinds; ++i) CHECK(keys[i] == keys[i + kinds]);  // what was read again is found again
}

TEST_CASE("a layout at another size finds the letters of the same faces", "[windows]")
{
    const test::font_files files{{dejavu}};
    glyph_cache cache;
    directwrite_text one, other;
    REQUIRE(one.read(files.layout(L"abc", 30.0f).get()));
    check_unharmed(one, cache);
    const std::uint64_t misses = cache.statistics().misses;
    CHECK(misses == 3);
    REQUIRE(other.read(files.layout(L"cab", 45.0f).get()));
    CHECK(other.variation_key() == one.variation_key());
    check_unharmed(other, cache);
    CHECK(cache.statistics().misses == misses);
}

TEST_CASE("a face without a system file shares nothing between layouts", "[windows]")
{
    const test::font_files files{{dejavu}};
    glyph_cache cache;
    directwrite_text text;
    std::set<std::uint64_t> keys;
    for (const FLOAT size : {100.0f, 500.0f, 200.0f}) {
        fake_face face;  // at the same address as the one before, mostly
        face.draws = [size](auto& to) { return square(to, size), S_OK; };
        drawn_object object;
        object.face = &face;
        const auto layout = files.layout(L"ab*", 20.0f);
        REQUIRE(SUCCEEDED(layout->SetInlineObject(&object, range(2, 1))));
        REQUIRE(text.read(layout.get()));
        REQUIRE(text.run().glyphs.size() == 3);
        check_unharmed(text, cache);
        CHECK(keys.insert(text.variation_key()).second);
        CHECK(text.variation_key() == text.variation_key());
        REQUIRE(text.read(files.layout(L"ab", 20.0f).get()));  // lets go of the face
        CHECK(face.references == 1);
    }
}

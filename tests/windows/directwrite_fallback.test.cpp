// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "windows/fake_face.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite_fallback.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace directwrite_fallback_test {

/// A Font that opens nothing, and remembers what it was asked to open.
struct path_font {
    std::string path;
    std::uint32_t face;

    static inline std::vector<std::string> opened;
    static inline error refusal;

    static result<path_font> open(const char* path, const font_options& options) noexcept
    {
        opened.emplace_back(path);
        if (refusal) return refusal;
        return path_font{path, options.face};
    }
    static void forget()
    {
        opened.clear();
        refusal = {};
    }
};

static_assert(fallback_provider<directwrite_fallback<directwrite_font>, directwrite_font>);
static_assert(fallback_provider<directwrite_fallback<path_font>, path_font>);

/// A loader of files that are somewhere else than in the file system.
class fake_loader final : public test::counted<IDWriteFontFileLoader> {
public:
    TYPEMESH_TEST_UNUSED(CreateStreamFromKey, const void*, UINT32, IDWriteFontFileStream**);
};

/// A font with its face and its file, which is a real one or one that a fake_loader has. Each counts its references.
class fake_font final : public test::counted<IDWriteFont> {
public:
    class its_face final : public test::fake_face_of<IDWriteFontFace> {
    public:
        fake_font* of = nullptr;
        HRESULT STDMETHODCALLTYPE GetFiles(UINT32* count, IDWriteFontFile** out) noexcept override
        {
            if (of->fails()) return of->failure;
            *count = of->file_count;
            if (out == nullptr) return S_OK;
            *out = &of->file;
            of->file.AddRef();
            return S_OK;
        }
        UINT32 STDMETHODCALLTYPE GetIndex() noexcept override { return of->index; }
    };
    class its_file final : public test::counted<IDWriteFontFile> {
    public:
        fake_font* of = nullptr;
        HRESULT STDMETHODCALLTYPE GetReferenceKey(const void** key, UINT32* size) noexcept override
        {
            if (of->fails()) return of->failure;
            if (of->real) return of->real->GetReferenceKey(key, size);
            *key = this;
            *size = 1;
            return S_OK;
        }
        HRESULT STDMETHODCALLTYPE GetLoader(IDWriteFontFileLoader** out) noexcept override
        {
            if (of->fails()) return of->failure;
            if (of->real) return of->real->GetLoader(out);
            *out = &of->loader;
            of->loader.AddRef();
            return S_OK;
        }
        TYPEMESH_TEST_UNUSED(Analyze, BOOL*, DWRITE_FONT_FILE_TYPE*, DWRITE_FONT_FACE_TYPE*, UINT32*);
    };

    fake_font() { face.of = file.of = this; }

    std::u32string letters;
    UINT32 index = 0, file_count = 1;
    test::com_ptr<IDWriteFontFile> real;
    its_face face;
    its_file file;
    fake_loader loader;
    unsigned calls = 0, fails_at = 0;  // that call, counted from 1
    HRESULT failure = E_FAIL;

    bool fails() { return ++calls == fails_at; }
    [[nodiscard]] bool is_kept() const
    {
        return references != 1 || face.references != 1 || file.references != 1 || loader.references != 1;
    }

    HRESULT STDMETHODCALLTYPE HasCharacter(UINT32 c, BOOL* has) noexcept override
    {
        if (fails()) return failure;
        *has = letters.find(static_cast<char32_t>(c)) != std::u32string::npos ? TRUE : FALSE;
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE CreateFontFace(IDWriteFontFace** out) noexcept override
    {
        if (fails()) return failure;
        *out = &face;
        face.AddRef();
        return S_OK;
    }
    TYPEMESH_TEST_UNUSED(GetFontFamily, IDWriteFontFamily**);
    DWRITE_FONT_WEIGHT STDMETHODCALLTYPE GetWeight() noexcept override { return DWRITE_FONT_WEIGHT_NORMAL; }
    DWRITE_FONT_STRETCH STDMETHODCALLTYPE GetStretch() noexcept override { return DWRITE_FONT_STRETCH_NORMAL; }
    DWRITE_FONT_STYLE STDMETHODCALLTYPE GetStyle() noexcept override { return DWRITE_FONT_STYLE_NORMAL; }
    BOOL STDMETHODCALLTYPE IsSymbolFont() noexcept override { return FALSE; }
    TYPEMESH_TEST_UNUSED(GetFaceNames, IDWriteLocalizedStrings**);
    TYPEMESH_TEST_UNUSED(GetInformationalStrings, DWRITE_INFORMATIONAL_STRING_ID, IDWriteLocalizedStrings**, BOOL*);
    DWRITE_FONT_SIMULATIONS STDMETHODCALLTYPE GetSimulations() noexcept override
    {
        return DWRITE_FONT_SIMULATIONS_NONE;
    }
    void STDMETHODCALLTYPE GetMetrics(DWRITE_FONT_METRICS*) noexcept override {}
};

/// Gives the first of its fonts that has the first letter, and remembers how it was asked.
class fake_fallback final : public test::counted<IDWriteFontFallback> {
public:
    std::vector<fake_font*> fonts;
    std::vector<std::wstring> asked, languages;
    std::wstring family;
    DWRITE_FONT_WEIGHT weight = DWRITE_FONT_WEIGHT_NORMAL;
    HRESULT failure = S_OK;

    HRESULT STDMETHODCALLTYPE MapCharacters(IDWriteTextAnalysisSource* source, UINT32 at, UINT32 length,
                                            IDWriteFontCollection*, const WCHAR* name, DWRITE_FONT_WEIGHT how_heavy,
                                            DWRITE_FONT_STYLE, DWRITE_FONT_STRETCH, UINT32* mapped, IDWriteFont** font,
                                            FLOAT* scale) noexcept override
    {
        if (FAILED(failure)) return failure;
        const WCHAR *units = nullptr, *language = nullptr;
        UINT32 count = 0, same = 0;
        if (FAILED(source->GetTextAtPosition(at, &units, &count)) || count < length) return E_INVALIDARG;
        if (FAILED(source->GetLocaleName(at, &same, &language)) || same < length) return E_INVALIDARG;
        asked.emplace_back(units, length);
        languages.emplace_back(language);
        family = name != nullptr ? name : L"";
        weight = how_heavy;
        *mapped = 1;
        *font = nullptr;
        *scale = 1.0f;
        for (fake_font* f : fonts)
            if (f->letters.find(units[0]) != std::u32string::npos) {
                *font = f;
                f->AddRef();
                break;
            }
        return S_OK;
    }
};

/// A font of the file system, with some letters.
void read(fake_font& font, const std::string& path, const std::u32string& letters)
{
    test::com_ptr<IDWriteFactory> factory;
    IUnknown* made = nullptr;
    REQUIRE(SUCCEEDED(DWriteCreateFactory(DWRITE_FACTORY_TYPE_SHARED, __uuidof(IDWriteFactory), &made)));
    *factory.put() = static_cast<IDWriteFactory*>(made);
    REQUIRE(SUCCEEDED(factory->CreateFontFileReference(test::windows_path(path).c_str(), nullptr, font.real.put())));
    font.letters = letters;
}

template <class Font>
result<Font*> ask(directwrite_fallback<Font>& fallback, text_view text, std::string_view language = {})
{
    return fallback.font_for(text, {0, static_cast<std::uint32_t>(text.size())}, 0, language);
}

template <class Font>
Font* found(directwrite_fallback<Font>& fallback, text_view text, std::string_view language = {})
{
    const result<Font*> answer = ask(fallback, text, language);
    REQUIRE(answer);
    return *answer;
}

/// Answers to no interface but IUnknown, as the factory of an older Windows does to a newer one's.
class older_factory final : public detail::stack_object<IUnknown> {};

}  // namespace directwrite_fallback_test

using namespace directwrite_fallback_test;

TEST_CASE("the system's own fallback takes the named family, if it has the letter", "[windows][fallback]")
{
    directwrite_fallback<directwrite_font> installed{L"DejaVu Sans"};
    directwrite_font* first = found(installed, u"a");
    REQUIRE(first != nullptr);
    auto sans = directwrite_font::open(test::windows_path(font_file("truetype/dejavu/DejaVuSans.ttf")).c_str());
    REQUIRE(sans);
    CHECK(first->variation_key() == sans->variation_key());
    CHECK(found(installed, u8"\u05D0", "he") == first);
    CHECK(found(installed, u"\uFFFE") == nullptr);

    path_font::forget();
    directwrite_fallback<path_font> by_path{L"DejaVu Sans"};
    const path_font* font = found(by_path, u"a");
    REQUIRE(font != nullptr);
    CHECK(font->path.ends_with("DejaVuSans.ttf"));
}

TEST_CASE("a font of the caller's fallback is opened by its file and face, once", "[windows][fallback]")
{
    path_font::forget();
    fake_font latin, hebrew, same;
    read(latin, font_file("truetype/dejavu/DejaVuSans.ttf"), U"ab\u0301");
    read(hebrew, font_file("truetype/wqy/wqy-microhei.ttc"), U"\u05D0\U0001F600");
    read(same, font_file("truetype/wqy/wqy-microhei.ttc"), U"c");
    hebrew.index = 1;
    fake_fallback fakes;
    fakes.fonts = {&latin, &hebrew, &same};
    {
        directwrite_fallback<path_font> fallback{&fakes, L"Segoe UI", {.weight = DWRITE_FONT_WEIGHT_BOLD}};
        CHECK(fakes.references == 2);
        const path_font* first = found(fallback, u"a");
        REQUIRE(first != nullptr);
        CHECK(first->path.ends_with("\\DejaVuSans.ttf"));
        CHECK(first->face == 0);
        CHECK(fakes.family == L"Segoe UI");
        CHECK(fakes.weight == DWRITE_FONT_WEIGHT_BOLD);
        CHECK(found(fallback, u"b\u0301\uFE0F") == first);  // what is not drawn needs no glyph
        const path_font* second = found(fallback, u8"\u05D0", "he");
        REQUIRE(second != nullptr);
        CHECK(second->path.ends_with("\\wqy-microhei.ttc"));
        CHECK(second->face == 1);
        const path_font* third = found(fallback, u"c");
        REQUIRE(third != nullptr);
        CHECK(third != second);  // another face of the same file
        CHECK(third->face == 0);
        CHECK(path_font::opened.size() == 3);
        CHECK(fakes.languages == std::vector<std::wstring>{L"", L"", L"he", L""});
    }
    CHECK(fakes.references == 1);
    for (const fake_font* f : {&latin, &hebrew, &same}) CHECK_FALSE(f->is_kept());
}

TEST_CASE("a font that has only a part of a grapheme is not taken for it", "[windows][fallback]")
{
    path_font::forget();
    fake_font latin;
    read(latin, font_file("truetype/dejavu/DejaVuSans.ttf"), U"a");
    fake_fallback fakes;
    fakes.fonts = {&latin};
    directwrite_fallback<path_font> fallback{&fakes};
    CHECK(found(fallback, u"a\u0301") == nullptr);
    CHECK(found(fallback, u"a") != nullptr);
    CHECK(fakes.asked == std::vector<std::wstring>{L"a\u0301", L"a"});
}

TEST_CASE("a letter that no font has is looked up once per language", "[windows][fallback]")
{
    fake_fallback fakes;
    directwrite_fallback<path_font> fallback{&fakes};
    for (int i = 0; i < 3; ++i)
        for (const char16_t* letter : {u"c", u"a", u"\U0001F600", u"b"})
            CHECK(found(fallback, letter, "en") == nullptr);
    CHECK(fakes.asked == std::vector<std::wstring>{L"c", L"a", L"\U0001F600", L"b"});
    CHECK(found(fallback, u"a", "de") == nullptr);
    CHECK(fakes.asked.size() == 5);
}

TEST_CASE("a font is left out if it is not one local file or cannot be opened", "[windows][fallback]")
{
    path_font::forget();
    fake_font remote, parts, broken;
    remote.letters = U"a";
    read(parts, font_file("truetype/dejavu/DejaVuSans.ttf"), U"b");
    parts.file_count = 2;
    read(broken, font_file("truetype/dejavu/DejaVuSans.ttf"), U"cd");
    fake_fallback fakes;
    fakes.fonts = {&remote, &parts, &broken};
    directwrite_fallback<path_font> fallback{&fakes};
    CHECK(found(fallback, u"a") == nullptr);
    CHECK(found(fallback, u"b") == nullptr);
    CHECK(path_font::opened.empty());
    path_font::refusal = error::no_outlines;
    CHECK(found(fallback, u"c") == nullptr);
    CHECK(found(fallback, u"d") == nullptr);
    CHECK(path_font::opened.size() == 1);
    for (const fake_font* f : {&remote, &parts, &broken}) CHECK_FALSE(f->is_kept());
}

TEST_CASE("a failure in the fallback is an error, and the next look-up succeeds", "[windows][fallback]")
{
    for (unsigned k = 1; k <= 6; ++k) {
        INFO("call " << k);
        path_font::forget();
        fake_font font;
        read(font, font_file("truetype/dejavu/DejaVuSans.ttf"), U"a");
        font.fails_at = k;
        fake_fallback fakes;
        fakes.fonts = {&font};
        directwrite_fallback<path_font> fallback{&fakes};
        const result<path_font*> answer = ask(fallback, u"a");
        REQUIRE_FALSE(answer);
        CHECK(answer.error() == error::font_library_failed);
        CHECK(answer.error().count == static_cast<std::uint32_t>(E_FAIL));
        CHECK_FALSE(font.is_kept());
        CHECK(found(fallback, u"a") != nullptr);
        CHECK_FALSE(font.is_kept());
    }
    path_font::forget();
    fake_font font;
    read(font, font_file("truetype/dejavu/DejaVuSans.ttf"), U"a");
    fake_fallback fakes;
    fakes.fonts = {&font};
    directwrite_fallback<path_font> fallback{&fakes};
    fakes.failure = E_OUTOFMEMORY;
    CHECK(ask(fallback, u"a").error() == error::out_of_memory);
    fakes.failure = S_OK;
    path_font::refusal = error::out_of_memory;
    CHECK(ask(fallback, u"a").error() == error::out_of_memory);
    path_font::refusal = {};
    CHECK(found(fallback, u"a") != nullptr);
}

TEST_CASE("a Windows without a fallback finds no font, which is not an error", "[windows][fallback]")
{
    older_factory factory;
    detail::com_ptr<IDWriteFontFallback> fallback;
    CHECK_FALSE(detail::find_system_fallback(&factory, fallback));
    CHECK_FALSE(fallback);
}

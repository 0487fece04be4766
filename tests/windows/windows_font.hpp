// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "windows/counted.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/unicode/utf.hpp>

#include <dwrite.h>

#include <string>
#include <vector>

namespace test {

inline constexpr char dejavu[] = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
inline constexpr char comic[] = "/usr/share/fonts/opentype/comic-neue/ComicNeue-Regular.otf";
inline constexpr char amiri[] = "/usr/share/fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf";
inline constexpr char micro_hei[] = "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc";

/// A path as Windows and Wine write it, from one of ASCII: Wine shows the root of the host's files as drive Z.
inline std::wstring windows_path(const std::string& path)
{
    std::wstring made{path.begin(), path.end()};
    if (!made.empty() && made[0] == L'/') made = L"Z:" + made;
    for (wchar_t& c : made)
        if (c == L'/') c = L'\\';
    return made;
}

inline typemesh::result<typemesh::directwrite_font> opened(const std::string& path,
                                                           const typemesh::font_options& options = {})
{
    return typemesh::directwrite_font::open(windows_path(path).c_str(), options);
}

/// UTF-8 as DirectWrite wants it.
inline std::wstring wide(const std::string& text)
{
    std::wstring made;
    for (std::size_t i = 0; i < text.size();) {
        const typemesh::code_point c = typemesh::decode(text, i);
        if (c.value >= 0x10000) {
            made += static_cast<wchar_t>(0xD7C0 + (c.value >> 10));
            made += static_cast<wchar_t>(0xDC00 + (c.value & 0x3FF));
        } else
            made += static_cast<wchar_t>(c.value);
        i = c.next;
    }
    return made;
}

inline DWRITE_TEXT_RANGE range(UINT32 first, UINT32 count) { return {first, count}; }

template <class T>
using com_ptr = typemesh::detail::com_ptr<T>;

/// How many references an object has.
template <class T>
ULONG references(T* object)
{
    object->AddRef();
    return object->Release();
}

/// Font files by their paths, as a collection: what DirectWrite offers since Windows 7. Lives longer than what it made.
class font_files final : public counted<IDWriteFontCollectionLoader> {
public:
    explicit font_files(const std::vector<std::string>& paths)
    {
        for (const std::string& p : paths) paths_.push_back(windows_path(p));
        IUnknown* made = nullptr;
        REQUIRE(SUCCEEDED(DWriteCreateFactory(DWRITE_FACTORY_TYPE_ISOLATED, __uuidof(IDWriteFactory), &made)));
        *factory_.put() = static_cast<IDWriteFactory*>(made);
        REQUIRE(SUCCEEDED(factory_->RegisterFontCollectionLoader(this)));
        REQUIRE(SUCCEEDED(factory_->CreateCustomFontCollection(this, "k", 1, collection_.put())));
    }
    ~font_files() { factory_->UnregisterFontCollectionLoader(this); }

    [[nodiscard]] IDWriteFactory* factory() const { return factory_.get(); }
    [[nodiscard]] IDWriteFontCollection* collection() const { return collection_.get(); }

    /// The name of a family in the collection.
    [[nodiscard]] std::wstring family(UINT32 i) const
    {
        com_ptr<IDWriteFontFamily> members;
        com_ptr<IDWriteLocalizedStrings> names;
        REQUIRE(i < collection_->GetFontFamilyCount());
        REQUIRE(SUCCEEDED(collection_->GetFontFamily(i, members.put())));
        REQUIRE(SUCCEEDED(members->GetFamilyNames(names.put())));
        wchar_t name[100] = {};
        REQUIRE(SUCCEEDED(names->GetString(0, name, 100)));
        return name;
    }

    [[nodiscard]] com_ptr<IDWriteTextLayout> layout(const std::wstring& text, FLOAT size, FLOAT width = 1e5f,
                                                    FLOAT height = 1e5f) const
    {
        com_ptr<IDWriteTextFormat> format;
        com_ptr<IDWriteTextLayout> made;
        REQUIRE(SUCCEEDED(factory_->CreateTextFormat(family(0).c_str(), collection_.get(), DWRITE_FONT_WEIGHT_NORMAL,
                                                     DWRITE_FONT_STYLE_NORMAL, DWRITE_FONT_STRETCH_NORMAL, size,
                                                     L"en-us", format.put())));
        REQUIRE(SUCCEEDED(factory_->CreateTextLayout(text.c_str(), static_cast<UINT32>(text.size()), format.get(),
                                                     width, height, made.put())));
        return made;
    }

    HRESULT STDMETHODCALLTYPE QueryInterface(REFIID, void** out) noexcept override
    {
        *out = this;
        AddRef();
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE CreateEnumeratorFromKey(IDWriteFactory* factory, const void*, UINT32,
                                                      IDWriteFontFileEnumerator** out) noexcept override
    {
        *out = new enumerator{*this, factory};
        return S_OK;
    }

private:
    class enumerator final : public counted<IDWriteFontFileEnumerator> {
    public:
        enumerator(const font_files& of, IDWriteFactory* factory) : of_{of}, factory_{factory} {}
        ULONG STDMETHODCALLTYPE Release() noexcept override
        {
            const ULONG left = --references;
            if (left == 0) delete this;
            return left;
        }
        HRESULT STDMETHODCALLTYPE QueryInterface(REFIID, void** out) noexcept override
        {
            *out = this;
            AddRef();
            return S_OK;
        }
        HRESULT STDMETHODCALLTYPE MoveNext(BOOL* there) noexcept override
        {
            *there = next_ < of_.paths_.size() ? TRUE : FALSE;
            ++next_;
            return S_OK;
        }
        HRESULT STDMETHODCALLTYPE GetCurrentFontFile(IDWriteFontFile** out) noexcept override
        {
            return factory_->CreateFontFileReference(of_.paths_[next_ - 1].c_str(), nullptr, out);
        }

    private:
        const font_files& of_;
        IDWriteFactory* factory_;
        std::size_t next_ = 0;
    };

    std::vector<std::wstring> paths_;
    com_ptr<IDWriteFactory> factory_;
    com_ptr<IDWriteFontCollection> collection_;
};

}  // namespace test

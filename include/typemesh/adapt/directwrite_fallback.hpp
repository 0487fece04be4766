// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/adapt/impl/directwrite_analysis.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/fallback_provider.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/outline/font_options.hpp>
#include <typemesh/unicode/utf.hpp>

#include <dwrite_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cwchar>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The system fallback of an IDWriteFactory; empty before Windows 8.1, which has none.
inline error find_system_fallback(IUnknown* factory, com_ptr<IDWriteFontFallback>& found) noexcept
{
    const auto unknown = com_ptr<IUnknown>::share(factory);
    const auto newer = unknown.as<IDWriteFactory2>();
    return newer ? directwrite_error(newer->GetSystemFontFallback(found.put())) : error{};
}

}  // namespace detail

/// A fallback_provider of the fonts that Windows itself would use, opened when they are first needed:
///
///     directwrite_fallback<harfbuzz_font> installed{L"Segoe UI"};
///     font_list list{*font, installed};
///
/// It finds nothing before Windows 8.1. `Font` has an open(path, font_options) with a wchar_t path like
/// directwrite_font's, or with a UTF-8 path, in which older HarfBuzz may read only ASCII. DirectWrite's other results
/// are ignored: a smaller size, simulated bold where the family has no bold, and the instance of a variable font. Not
/// copyable; used by one thread at a time.
template <class Font>
class directwrite_fallback {
public:
    /// The family is searched first, then the system's fallback in the given style. Null: only the fallback. The name
    /// must outlive this object.
    explicit directwrite_fallback(const wchar_t* family = nullptr, const directwrite_style& style = {}) noexcept
        : family_{family}, style_{style}
    {
    }
    /// Uses the caller's fallback, and holds a reference to it.
    explicit directwrite_fallback(IDWriteFontFallback* callers, const wchar_t* family = nullptr,
                                  const directwrite_style& style = {}) noexcept
        : directwrite_fallback{family, style}
    {
        TYPEMESH_ASSERT(callers != nullptr, "a directwrite_fallback was made from a null IDWriteFontFallback*");
        fallback_ = detail::com_ptr<IDWriteFontFallback>::share(callers);
        opened_fallback_ = true;
    }
    directwrite_fallback(const directwrite_fallback&) = delete;
    directwrite_fallback& operator=(const directwrite_fallback&) = delete;
    ~directwrite_fallback()
    {
        while (opened_ != nullptr) delete std::exchange(opened_, opened_->next);
    }

    /// See fallback_provider. A font is ignored if it is not a file of this machine or cannot be opened. The script is
    /// ignored: DirectWrite sees the letters.
    ///
    /// Fails  error::out_of_memory, font_library_failed (count = the HRESULT)
    result<Font*> font_for(text_view text, text_range grapheme, std::uint32_t, std::string_view language) noexcept
    {
        if (error e = open_fallback()) return e;
        if (!fallback_) return nullptr;
        if (error e = take(text, grapheme, language)) return e;
        const code_point c = decode(text, grapheme.first, grapheme.last);
        const bool single = c.next == grapheme.last;
        if (single && std::binary_search(nowhere_.begin(), nowhere_.end(), std::uint32_t{c.value})) return nullptr;

        result<Font*> found = ask(text, grapheme);
        if (found && *found == nullptr && single) note_missing(c.value);
        return found;
    }

private:
    /// A font that was opened, or could not be opened.
    struct opened_font {
        buffer<wchar_t> path;  // ends with a zero
        std::uint32_t face;
        std::optional<Font> font;
        opened_font* next;
    };

    error open_fallback() noexcept
    {
        if (opened_fallback_) return {};
        IUnknown* made = nullptr;
        if (error e =
                directwrite_error(DWriteCreateFactory(DWRITE_FACTORY_TYPE_SHARED, __uuidof(IDWriteFactory), &made)))
            return e;
        detail::com_ptr<IUnknown> factory;
        *factory.put() = made;
        if (error e = detail::find_system_fallback(factory.get(), fallback_)) return e;
        opened_fallback_ = true;
        return {};
    }

    /// Stores text and language in DirectWrite's form. If the language changes, the missing characters are forgotten.
    error take(text_view text, text_range range, std::string_view language) noexcept
    {
        if (language.size() >= LOCALE_NAME_MAX_LENGTH) language = {};
        if (!std::equal(language.begin(), language.end(), language_, language_ + language_length_)) nowhere_.clear();
        language_length_ = language.size();
        for (std::size_t i = 0; i < language.size(); ++i) language_[i] = static_cast<unsigned char>(language[i]);
        language_[language.size()] = L'\0';
        text_.clear();
        for (std::size_t i = range.first; i < range.last;) {
            const code_point c = decode(text, i, range.last);
            const auto v = static_cast<std::uint32_t>(c.value);
            const bool fits = v < 0x10000 ? text_.push_back(static_cast<wchar_t>(v))
                                          : text_.push_back(static_cast<wchar_t>(0xD7C0 + (v >> 10))) &&
                                                text_.push_back(static_cast<wchar_t>(0xDC00 + (v & 0x3FF)));
            if (!fits) return error::out_of_memory;
            i = c.next;
        }
        return {};
    }

    result<Font*> ask(text_view text, text_range grapheme) noexcept
    {
        detail::directwrite_source source{text_.view(), language_, false};
        detail::com_ptr<IDWriteFont> font;
        UINT32 mapped = 0;
        FLOAT scale = 1;
        const auto length = static_cast<UINT32>(text_.size());
        if (error e =
                directwrite_error(fallback_->MapCharacters(&source, 0, length, nullptr, family_, style_.weight,
                                                           style_.style, style_.stretch, &mapped, font.put(), &scale)))
            return e;
        if (!font) return nullptr;
        // A call maps the range that one font supports, which may be shorter than the grapheme.
        for (std::size_t i = grapheme.first; i < grapheme.last;) {
            const code_point c = decode(text, i, grapheme.last);
            BOOL has = FALSE;
            if (!is_default_ignorable(c.value)) {
                if (error e = directwrite_error(font->HasCharacter(c.value, &has))) return e;
                if (has == FALSE) return nullptr;
            }
            i = c.next;
        }
        detail::com_ptr<IDWriteFontFace> face;
        if (error e = directwrite_error(font->CreateFontFace(face.put()))) return e;
        if (error e = find_path(face.get())) return e;
        return path_.empty() ? result<Font*>{nullptr} : open(face->GetIndex());
    }

    /// The path of a face's file; empty unless it is a single file of this machine.
    error find_path(IDWriteFontFace* face) noexcept
    {
        path_.clear();
        UINT32 files = 0;
        if (error e = directwrite_error(face->GetFiles(&files, nullptr))) return e;
        if (files != 1) return {};
        detail::com_ptr<IDWriteFontFile> file;
        detail::com_ptr<IDWriteFontFileLoader> loader;
        if (error e = directwrite_error(face->GetFiles(&files, file.put()))) return e;
        if (error e = directwrite_error(file->GetLoader(loader.put()))) return e;
        const auto local = loader.template as<IDWriteLocalFontFileLoader>();
        if (!local) return {};

        const void* key = nullptr;
        UINT32 size = 0, length = 0;
        if (error e = directwrite_error(file->GetReferenceKey(&key, &size))) return e;
        if (error e = directwrite_error(local->GetFilePathLengthFromKey(key, size, &length))) return e;
        wchar_t* path = path_.append(std::size_t{length} + 1);
        if (path == nullptr) return error::out_of_memory;
        return directwrite_error(local->GetFilePathFromKey(key, size, path, length + 1));
    }

    /// Opens a face of the file at path_, once. Null if it cannot be opened.
    result<Font*> open(std::uint32_t face) noexcept
    {
        for (opened_font* o = opened_; o != nullptr; o = o->next)
            if (o->face == face && std::wcscmp(o->path.data(), path_.data()) == 0) return o->font ? &*o->font : nullptr;
        auto font = open_file(face);
        if (!font && font.error() == error::out_of_memory) return font.error();
        auto* made = new (std::nothrow) opened_font{buffer<wchar_t>{}, face, {}, opened_};
        if (made == nullptr) return error::out_of_memory;
        std::swap(made->path, path_);
        if (font) made->font.emplace(std::move(*font));
        opened_ = made;
        return made->font ? &*made->font : nullptr;
    }

    result<Font> open_file(std::uint32_t face) noexcept
    {
        font_options options;
        options.face = face;
        if constexpr (requires(const wchar_t* path) { Font::open(path, options); })
            return Font::open(static_cast<const wchar_t*>(path_.data()), options);
        else {
            const int size = WideCharToMultiByte(CP_UTF8, 0, path_.data(), -1, nullptr, 0, nullptr, nullptr);
            if (size <= 0) return error::unreadable_file;
            buffer<char> narrow;
            char* path = narrow.append(static_cast<std::size_t>(size));
            if (path == nullptr) return error::out_of_memory;
            WideCharToMultiByte(CP_UTF8, 0, path_.data(), -1, path, size, nullptr, nullptr);
            return Font::open(static_cast<const char*>(path), options);
        }
    }

    /// Remembers a character that no font has, in sorted order, so that its next occurrence costs nothing. If out of
    /// memory, the character is searched for again.
    void note_missing(std::uint32_t c) noexcept
    {
        if (!nowhere_.push_back(c)) return;
        std::rotate(std::lower_bound(nowhere_.begin(), nowhere_.end() - 1, c), nowhere_.end() - 1, nowhere_.end());
    }

    const wchar_t* family_;
    directwrite_style style_;
    detail::com_ptr<IDWriteFontFallback> fallback_;
    bool opened_fallback_ = false;
    wchar_t language_[LOCALE_NAME_MAX_LENGTH] = {};
    std::size_t language_length_ = 0;
    buffer<wchar_t> text_, path_;
    buffer<std::uint32_t> nowhere_;  // characters that no font has, in the last language; sorted
    opened_font* opened_ = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI

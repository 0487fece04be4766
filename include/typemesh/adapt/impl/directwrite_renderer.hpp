// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_com.hpp>

#include <dwrite.h>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The renderer for an IDWriteTextLayout, in device-independent pixels: forwards its input, lets inline objects draw
/// themselves, and keeps the first error.
///
///     to.add_glyphs(x, y, run, of)    `of` is null for text drawn by an inline object: it has no position in the text
///     to.add_bar(x, y, width, thickness, offset)
///                                     an underline or strike-through, its upper edge `offset` below the baseline
///     to.add_object(x, y, object)     before the object draws itself
///
/// Each returns an error, which makes DirectWrite stop.
template <class To>
class directwrite_renderer final : public stack_object<IDWriteTextRenderer> {
public:
    explicit directwrite_renderer(To& to) noexcept : to_{to} {}

    [[nodiscard]] const error& first_error() const noexcept { return first_error_; }

    HRESULT STDMETHODCALLTYPE IsPixelSnappingDisabled(void*, BOOL* disabled) noexcept override
    {
        *disabled = TRUE;
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetCurrentTransform(void*, DWRITE_MATRIX* identity) noexcept override
    {
        *identity = {1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetPixelsPerDip(void*, FLOAT* one) noexcept override
    {
        *one = 1.0f;
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE DrawGlyphRun(void*, FLOAT x, FLOAT y, DWRITE_MEASURING_MODE, const DWRITE_GLYPH_RUN* run,
                                           const DWRITE_GLYPH_RUN_DESCRIPTION* of, IUnknown*) noexcept override
    {
        return said(to_.add_glyphs(x, y, *run, depth_ == 0 ? of : nullptr));
    }
    HRESULT STDMETHODCALLTYPE DrawUnderline(void*, FLOAT x, FLOAT y, const DWRITE_UNDERLINE* u,
                                            IUnknown*) noexcept override
    {
        return said(to_.add_bar(x, y, u->width, u->thickness, u->offset));
    }
    HRESULT STDMETHODCALLTYPE DrawStrikethrough(void*, FLOAT x, FLOAT y, const DWRITE_STRIKETHROUGH* s,
                                                IUnknown*) noexcept override
    {
        return said(to_.add_bar(x, y, s->width, s->thickness, s->offset));
    }
    HRESULT STDMETHODCALLTYPE DrawInlineObject(void* context, FLOAT x, FLOAT y, IDWriteInlineObject* object,
                                               BOOL sideways, BOOL to_the_left, IUnknown* effect) noexcept override
    {
        if (object == nullptr) return S_OK;
        if (error e = to_.add_object(x, y, object)) return said(e);
        if (depth_ >= deepest) return S_OK;  // an object that draws itself recursively without end
        ++depth_;
        const HRESULT code = object->Draw(context, this, x, y, sideways, to_the_left, effect);
        --depth_;
        return code == E_NOTIMPL ? S_OK : said(directwrite_error(code));
    }

private:
    static constexpr int deepest = 8;

    [[nodiscard]] bool is_also(REFIID wanted) const noexcept override
    {
        return IsEqualGUID(wanted, __uuidof(IDWritePixelSnapping)) != 0;
    }
    HRESULT said(error e) noexcept
    {
        if (!e) return S_OK;
        if (!first_error_) first_error_ = e;
        return e == error::out_of_memory ? E_OUTOFMEMORY : E_FAIL;  // Wine continues anyway
    }

    To& to_;
    error first_error_;
    int depth_ = 0;  // of nested inline objects
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

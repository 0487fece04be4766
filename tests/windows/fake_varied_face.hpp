// SPDX-License-Identifier: MIT
#pragma once

#include "windows/fake_face.hpp"

#include <dwrite_3.h>

#include <vector>

namespace test {

/// A fake_face of a variable font, on the axes that a test gives it.
class fake_varied_face final : public fake_face_of<IDWriteFontFace5> {
public:
    std::vector<DWRITE_FONT_AXIS_VALUE> axes;
    HRESULT answer = S_OK;  // when it is asked for them
    BOOL varies = TRUE;
    IDWriteFontResource* resource = nullptr;

    HRESULT STDMETHODCALLTYPE QueryInterface(REFIID wanted, void** out) noexcept override
    {
        *out = nullptr;
        if (!IsEqualGUID(wanted, __uuidof(IDWriteFontFace5))) return E_NOINTERFACE;
        *out = this;
        AddRef();
        return S_OK;
    }
    BOOL STDMETHODCALLTYPE HasVariations() noexcept override { return varies; }
    UINT32 STDMETHODCALLTYPE GetFontAxisValueCount() noexcept override { return static_cast<UINT32>(axes.size()); }
    HRESULT STDMETHODCALLTYPE GetFontAxisValues(DWRITE_FONT_AXIS_VALUE* values, UINT32 count) noexcept override
    {
        for (UINT32 i = 0; i < count; ++i) values[i] = axes[i];
        return answer;
    }

    using fake_face_of::GetGdiCompatibleMetrics;
    using fake_face_of::GetMetrics;
    using fake_face_of::GetRecommendedRenderingMode;
    void STDMETHODCALLTYPE GetMetrics(DWRITE_FONT_METRICS1*) noexcept override {}
    TYPEMESH_TEST_UNUSED(GetGdiCompatibleMetrics, FLOAT, FLOAT, const DWRITE_MATRIX*, DWRITE_FONT_METRICS1*);
    void STDMETHODCALLTYPE GetCaretMetrics(DWRITE_CARET_METRICS*) noexcept override {}
    TYPEMESH_TEST_UNUSED(GetUnicodeRanges, UINT32, DWRITE_UNICODE_RANGE*, UINT32*);
    BOOL STDMETHODCALLTYPE IsMonospacedFont() noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(GetDesignGlyphAdvances, UINT32, const UINT16*, INT32*, BOOL);
    TYPEMESH_TEST_UNUSED(GetGdiCompatibleGlyphAdvances, FLOAT, FLOAT, const DWRITE_MATRIX*, BOOL, BOOL, UINT32,
                         const UINT16*, INT32*);
    TYPEMESH_TEST_UNUSED(GetKerningPairAdjustments, UINT32, const UINT16*, INT32*);
    BOOL STDMETHODCALLTYPE HasKerningPairs() noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(GetRecommendedRenderingMode, FLOAT, FLOAT, FLOAT, const DWRITE_MATRIX*, BOOL,
                         DWRITE_OUTLINE_THRESHOLD, DWRITE_MEASURING_MODE, DWRITE_RENDERING_MODE*);
    TYPEMESH_TEST_UNUSED(GetVerticalGlyphVariants, UINT32, const UINT16*, UINT16*);
    BOOL STDMETHODCALLTYPE HasVerticalGlyphVariants() noexcept override { return {}; }
    BOOL STDMETHODCALLTYPE IsColorFont() noexcept override { return {}; }
    UINT32 STDMETHODCALLTYPE GetColorPaletteCount() noexcept override { return {}; }
    UINT32 STDMETHODCALLTYPE GetPaletteEntryCount() noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(GetPaletteEntries, UINT32, UINT32, UINT32, DWRITE_COLOR_F*);
    TYPEMESH_TEST_UNUSED(GetRecommendedRenderingMode, FLOAT, FLOAT, FLOAT, const DWRITE_MATRIX*, BOOL,
                         DWRITE_OUTLINE_THRESHOLD, DWRITE_MEASURING_MODE, IDWriteRenderingParams*,
                         DWRITE_RENDERING_MODE*, DWRITE_GRID_FIT_MODE*);
    TYPEMESH_TEST_UNUSED(GetFontFaceReference, IDWriteFontFaceReference**);
    void STDMETHODCALLTYPE GetPanose(DWRITE_PANOSE*) noexcept override {}
    DWRITE_FONT_WEIGHT STDMETHODCALLTYPE GetWeight() noexcept override { return {}; }
    DWRITE_FONT_STRETCH STDMETHODCALLTYPE GetStretch() noexcept override { return {}; }
    DWRITE_FONT_STYLE STDMETHODCALLTYPE GetStyle() noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(GetFamilyNames, IDWriteLocalizedStrings**);
    TYPEMESH_TEST_UNUSED(GetFaceNames, IDWriteLocalizedStrings**);
    TYPEMESH_TEST_UNUSED(GetInformationalStrings, DWRITE_INFORMATIONAL_STRING_ID, IDWriteLocalizedStrings**, BOOL*);
    BOOL STDMETHODCALLTYPE HasCharacter(UINT32) noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(GetRecommendedRenderingMode, FLOAT, FLOAT, FLOAT, const DWRITE_MATRIX*, BOOL,
                         DWRITE_OUTLINE_THRESHOLD, DWRITE_MEASURING_MODE, IDWriteRenderingParams*,
                         DWRITE_RENDERING_MODE1*, DWRITE_GRID_FIT_MODE*);
    BOOL STDMETHODCALLTYPE IsCharacterLocal(UINT32) noexcept override { return {}; }
    BOOL STDMETHODCALLTYPE IsGlyphLocal(UINT16) noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(AreCharactersLocal, const WCHAR*, UINT32, BOOL, BOOL*);
    TYPEMESH_TEST_UNUSED(AreGlyphsLocal, const UINT16*, UINT32, BOOL, BOOL*);
    TYPEMESH_TEST_UNUSED(GetGlyphImageFormats_, UINT16, UINT32, UINT32, DWRITE_GLYPH_IMAGE_FORMATS*);
    DWRITE_GLYPH_IMAGE_FORMATS STDMETHODCALLTYPE GetGlyphImageFormats() noexcept override { return {}; }
    TYPEMESH_TEST_UNUSED(GetGlyphImageData, UINT16, UINT32, DWRITE_GLYPH_IMAGE_FORMATS, DWRITE_GLYPH_IMAGE_DATA*,
                         void**);
    void STDMETHODCALLTYPE ReleaseGlyphImageData(void*) noexcept override {}
    HRESULT STDMETHODCALLTYPE GetFontResource(IDWriteFontResource** out) noexcept override
    {
        *out = resource;
        if (resource == nullptr) return E_NOTIMPL;
        resource->AddRef();
        return S_OK;
    }
    BOOL STDMETHODCALLTYPE Equals(IDWriteFontFace*) noexcept override { return {}; }
};

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

#include <d2d1.h>
#include <dwrite.h>

#include <functional>

#include "windows/counted.hpp"

namespace test {

/// A square with its lower left corner at the origin; y grows downwards where it is drawn.
inline void square(ID2D1SimplifiedGeometrySink& to, FLOAT size = 100.0f, D2D1_FIGURE_END end = D2D1_FIGURE_END_CLOSED,
                   D2D1_FIGURE_BEGIN begin = D2D1_FIGURE_BEGIN_FILLED)
{
    to.BeginFigure({0.0f, 0.0f}, begin);
    const D2D1_POINT_2F rest[] = {{size, 0.0f}, {size, -size}, {0.0f, -size}};
    to.AddLines(rest, 3);
    to.EndFigure(end);
}

/// A font face that draws what a test wants, and counts its references. 1000 units to the em, 10 glyphs.
template <class Interface>
class fake_face_of : public counted<Interface> {
public:
    std::function<HRESULT(ID2D1SimplifiedGeometrySink&)> draws = [](ID2D1SimplifiedGeometrySink&) { return S_OK; };
    FLOAT asked_em_size = 0.0f;
    bool has_glyf = true;
    UINT16 glyphs = 10;

    DWRITE_FONT_FACE_TYPE STDMETHODCALLTYPE GetType() noexcept override { return DWRITE_FONT_FACE_TYPE_TRUETYPE; }
    TYPEMESH_TEST_UNUSED(GetFiles, UINT32*, IDWriteFontFile**);
    UINT32 STDMETHODCALLTYPE GetIndex() noexcept override { return 0; }
    DWRITE_FONT_SIMULATIONS STDMETHODCALLTYPE GetSimulations() noexcept override
    {
        return DWRITE_FONT_SIMULATIONS_NONE;
    }
    BOOL STDMETHODCALLTYPE IsSymbolFont() noexcept override { return FALSE; }
    void STDMETHODCALLTYPE GetMetrics(DWRITE_FONT_METRICS* m) noexcept override
    {
        *m = {};
        m->designUnitsPerEm = 1000;
        m->ascent = 800;
        m->descent = 200;
        m->lineGap = -10;
    }
    UINT16 STDMETHODCALLTYPE GetGlyphCount() noexcept override { return glyphs; }
    TYPEMESH_TEST_UNUSED(GetDesignGlyphMetrics, const UINT16*, UINT32, DWRITE_GLYPH_METRICS*, BOOL);
    TYPEMESH_TEST_UNUSED(GetGlyphIndices, const UINT32*, UINT32, UINT16*);
    HRESULT STDMETHODCALLTYPE TryGetFontTable(UINT32, const void** data, UINT32* size, void** context,
                                              BOOL* exists) noexcept override
    {
        *data = this;
        *size = has_glyf ? 4 : 0;
        *context = nullptr;
        *exists = has_glyf ? TRUE : FALSE;
        return S_OK;
    }
    void STDMETHODCALLTYPE ReleaseFontTable(void*) noexcept override {}
    HRESULT STDMETHODCALLTYPE GetGlyphRunOutline(FLOAT em_size, const UINT16*, const FLOAT*, const DWRITE_GLYPH_OFFSET*,
                                                 UINT32, BOOL, BOOL, IDWriteGeometrySink* sink) noexcept override
    {
        asked_em_size = em_size;
        return draws(*sink);
    }
    TYPEMESH_TEST_UNUSED(GetRecommendedRenderingMode, FLOAT, FLOAT, DWRITE_MEASURING_MODE, IDWriteRenderingParams*,
                         DWRITE_RENDERING_MODE*);
    TYPEMESH_TEST_UNUSED(GetGdiCompatibleMetrics, FLOAT, FLOAT, const DWRITE_MATRIX*, DWRITE_FONT_METRICS*);
    TYPEMESH_TEST_UNUSED(GetGdiCompatibleGlyphMetrics, FLOAT, FLOAT, const DWRITE_MATRIX*, BOOL, const UINT16*, UINT32,
                         DWRITE_GLYPH_METRICS*, BOOL);
};

class fake_face final : public fake_face_of<IDWriteFontFace> {};

}  // namespace test

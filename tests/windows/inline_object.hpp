// SPDX-License-Identifier: MIT
#pragma once

#include "windows/counted.hpp"

#include <dwrite.h>

namespace test {

/// An inline object of 30 by 20 pixels with its baseline at 15, whose test draws it.
class inline_object : public counted<IDWriteInlineObject> {
public:
    HRESULT STDMETHODCALLTYPE GetMetrics(DWRITE_INLINE_OBJECT_METRICS* m) noexcept override
    {
        *m = {30.0f, 20.0f, 15.0f, FALSE};
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetOverhangMetrics(DWRITE_OVERHANG_METRICS* m) noexcept override
    {
        *m = {};
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetBreakConditions(DWRITE_BREAK_CONDITION* before,
                                                 DWRITE_BREAK_CONDITION* after) noexcept override
    {
        *before = *after = DWRITE_BREAK_CONDITION_NEUTRAL;
        return S_OK;
    }
};

}  // namespace test

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_com.hpp>

#include <dwrite.h>

#include <cstddef>
#include <span>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The source from which DirectWrite's analyser reads a text: one language, one direction.
class directwrite_source final : public stack_object<IDWriteTextAnalysisSource> {
public:
    directwrite_source(std::span<const wchar_t> text, const wchar_t* language, bool to_the_left) noexcept
        : text_{text}, language_{language}, to_the_left_{to_the_left}
    {
    }
    HRESULT STDMETHODCALLTYPE GetTextAtPosition(UINT32 at, const WCHAR** text, UINT32* count) noexcept override
    {
        const bool inside = at < text_.size();
        *text = inside ? text_.data() + at : nullptr;
        *count = inside ? static_cast<UINT32>(text_.size()) - at : 0;
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetTextBeforePosition(UINT32 at, const WCHAR** text, UINT32* count) noexcept override
    {
        const bool inside = at > 0 && at <= text_.size();
        *text = inside ? text_.data() : nullptr;
        *count = inside ? at : 0;
        return S_OK;
    }
    DWRITE_READING_DIRECTION STDMETHODCALLTYPE GetParagraphReadingDirection() noexcept override
    {
        return to_the_left_ ? DWRITE_READING_DIRECTION_RIGHT_TO_LEFT : DWRITE_READING_DIRECTION_LEFT_TO_RIGHT;
    }
    HRESULT STDMETHODCALLTYPE GetLocaleName(UINT32 at, UINT32* count, const WCHAR** name) noexcept override
    {
        *name = language_;
        *count = at < text_.size() ? static_cast<UINT32>(text_.size()) - at : 0;
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetNumberSubstitution(UINT32 at, UINT32* count,
                                                    IDWriteNumberSubstitution** how) noexcept override
    {
        *how = nullptr;
        *count = at < text_.size() ? static_cast<UINT32>(text_.size()) - at : 0;
        return S_OK;
    }

private:
    std::span<const wchar_t> text_;
    const wchar_t* language_;
    bool to_the_left_;
};

/// The sink for the analyser's results. This class discards them; derived classes keep the ones that they need.
class directwrite_sink : public stack_object<IDWriteTextAnalysisSink> {
public:
    HRESULT STDMETHODCALLTYPE SetScriptAnalysis(UINT32, UINT32, const DWRITE_SCRIPT_ANALYSIS*) noexcept override
    {
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE SetBidiLevel(UINT32, UINT32, UINT8, UINT8) noexcept override { return S_OK; }
    HRESULT STDMETHODCALLTYPE SetLineBreakpoints(UINT32, UINT32, const DWRITE_LINE_BREAKPOINT*) noexcept override
    {
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE SetNumberSubstitution(UINT32, UINT32, IDWriteNumberSubstitution*) noexcept override
    {
        return S_OK;
    }

protected:
    ~directwrite_sink() = default;

    /// The subspan of the text's units that DirectWrite refers to, clipped to the text.
    template <class Unit>
    [[nodiscard]] static std::span<Unit> clipped(std::span<Unit> units, UINT32 at, UINT32 count) noexcept
    {
        if (at >= units.size()) return {};
        const std::size_t left = units.size() - at;
        return units.subspan(at, count < left ? count : left);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

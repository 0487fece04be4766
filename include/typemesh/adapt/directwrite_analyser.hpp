// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_analysis.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/unicode/impl/dictionary_script.hpp>
#include <typemesh/unicode/script.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>
#include <typemesh/unicode/utf.hpp>

#include <dwrite.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// unicode_analyser, with DirectWrite's line breaks within Thai, Lao, Khmer and Burmese: lines may also end between
/// their words. Everything else is equal on every machine, whatever Windows is installed.
///
/// If this DirectWrite does not know the words of a script, its text stays in text_analysis::unbroken. DirectWrite is
/// called with the script's own language; analysis_options::language is ignored. One analyser is used by one thread at
/// a time.
///
/// Also fails with  error::font_library_failed (count = the HRESULT), if a text needs DirectWrite; the next call tries
///                  again
class directwrite_analyser {
public:
    /// Creates DirectWrite's analyser when a text first needs it.
    explicit directwrite_analyser(memory source = heap()) noexcept
        : unicode_{source}, text_{source}, places_{source}, conditions_{source}
    {
    }
    /// Uses the caller's IDWriteTextAnalyzer, and holds a reference to it.
    explicit directwrite_analyser(IDWriteTextAnalyzer* callers, memory source = heap()) noexcept
        : directwrite_analyser{source}
    {
        TYPEMESH_ASSERT(callers != nullptr, "a directwrite_analyser was made from a null IDWriteTextAnalyzer*");
        words_ = detail::com_ptr<IDWriteTextAnalyzer>::share(callers);
    }

    error analyse(text_view text, const analysis_options& how, text_analysis& found) noexcept
    {
        if (error e = unicode_.analyse(text, how, found)) return e;
        if (found.unbroken.empty()) return {};
        const error e = mark_words(text, found);
        if (e) found.clear();
        return e;
    }

private:
    static constexpr std::size_t count = dictionary_script_count;

    /// Stores DirectWrite's result for each unit; no result means DWRITE_BREAK_CONDITION_NEUTRAL.
    class break_sink final : public detail::directwrite_sink {
    public:
        explicit break_sink(std::span<DWRITE_LINE_BREAKPOINT> units) noexcept : units_{units} {}
        HRESULT STDMETHODCALLTYPE SetLineBreakpoints(UINT32 at, UINT32 length,
                                                     const DWRITE_LINE_BREAKPOINT* said) noexcept override
        {
            for (DWRITE_LINE_BREAKPOINT& unit : clipped(units_, at, length)) unit = *said++;
            return S_OK;
        }

    private:
        std::span<DWRITE_LINE_BREAKPOINT> units_;
    };

    /// Marks line breaks within the unbroken ranges. Ranges that DirectWrite does not know stay unbroken.
    error mark_words(text_view text, text_analysis& found) noexcept
    {
        if (error e = open()) return e;
        std::size_t left = 0;
        for (const text_range& range : found.unbroken) {
            const std::uint32_t tag = script_set::of(decode(text, range.first).value).tag();
            const std::size_t k = dictionary_script_number(tag);
            if (k == count || !known_[k]) {
                found.unbroken[left++] = range;
                continue;
            }
            if (error e = find_breaks(text, range, dictionary_scripts[k])) return e;
            for (std::size_t i = 1; i < text_.size(); ++i) {
                text_mark& mark = found.marks[places_[i]];
                if (breaks_before(i) && has(mark, text_mark::grapheme)) mark = mark | text_mark::may_break;
            }
        }
        found.unbroken.truncate(left);
        return {};
    }

    /// Creates the analyser, and finds the scripts whose words it knows. An analyser without dictionaries finds no
    /// breaks, or, equally useless, one at every grapheme.
    error open() noexcept
    {
        if (opened_ && words_) return {};  // a moved-from analyser has none
        if (!words_) {
            detail::com_ptr<IDWriteFactory> factory;
            IUnknown* made = nullptr;
            if (error e =
                    directwrite_error(DWriteCreateFactory(DWRITE_FACTORY_TYPE_SHARED, __uuidof(IDWriteFactory), &made)))
                return e;
            *factory.put() = static_cast<IDWriteFactory*>(made);
            if (error e = directwrite_error(factory->CreateTextAnalyzer(words_.put()))) return e;
        }
        for (std::size_t k = 0; k < count; ++k) {
            const dictionary_script& s = dictionary_scripts[k];
            if (error e = find_breaks(s.words, {0, static_cast<std::uint32_t>(s.words.size())}, s)) return e;
            known_[k] = breaks_before(s.second_word) && !breaks_before(s.second_word - 1);
        }
        opened_ = true;
        return {};
    }

    /// Analyses a range with DirectWrite, for breaks_before(). Units count from the start of the range: one for each
    /// character, because the four scripts lie below U+10000.
    error find_breaks(text_view text, text_range range, const dictionary_script& script) noexcept
    {
        text_.clear();
        places_.clear();
        conditions_.clear();
        for (std::size_t i = range.first; i < range.last;) {
            const code_point c = decode(text, i, range.last);
            if (!text_.push_back(static_cast<wchar_t>(c.value)) || !places_.push_back(static_cast<std::uint32_t>(i)))
                return error::out_of_memory;
            i = c.next;
        }
        DWRITE_LINE_BREAKPOINT* conditions = conditions_.append(text_.size());
        if (conditions == nullptr) return error::out_of_memory;
        for (std::size_t i = 0; i < text_.size(); ++i) conditions[i] = {};
        const wchar_t language[] = {static_cast<wchar_t>(script.language[0]), static_cast<wchar_t>(script.language[1]),
                                    0};
        detail::directwrite_source source{text_.view(), language, false};
        break_sink sink{conditions_.view()};
        const auto length = static_cast<UINT32>(text_.size());
        return directwrite_error(words_->AnalyzeLineBreakpoints(&source, 0, length, &sink));
    }

    /// Whether a line may end before a unit other than the first: one side allows it, and the other does not forbid it.
    [[nodiscard]] bool breaks_before(std::size_t i) const noexcept
    {
        const int after = conditions_[i - 1].breakConditionAfter, before = conditions_[i].breakConditionBefore;
        const auto allows = [](int c) noexcept {
            return c == DWRITE_BREAK_CONDITION_CAN_BREAK || c == DWRITE_BREAK_CONDITION_MUST_BREAK;
        };
        const auto forbids = [](int c) noexcept { return c == DWRITE_BREAK_CONDITION_MAY_NOT_BREAK; };
        return (allows(after) && !forbids(before)) || (allows(before) && !forbids(after));
    }

    unicode_analyser unicode_;
    detail::com_ptr<IDWriteTextAnalyzer> words_;
    bool opened_ = false;
    bool known_[count] = {};  // whether DirectWrite knows the words of each of dictionary_scripts
    buffer<wchar_t> text_;
    buffer<std::uint32_t> places_;  // the position of each unit in the caller's text
    buffer<DWRITE_LINE_BREAKPOINT> conditions_;
};
static_assert(text_analyser<directwrite_analyser>);

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/dictionary_script.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

#include <unicode/ubrk.h>
#include <unicode/utext.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// unicode_analyser, with ICU's dictionaries for Thai, Lao, Khmer and Burmese: lines may also end between their words.
/// Only the words of these scripts come from ICU; everything else is equal on every machine, whatever ICU is installed.
///
/// If this ICU has no dictionary for a script, its text stays in text_analysis::unbroken. ICU's C interface is used,
/// and it allocates from its own heap. One analyser is used by one thread at a time.
class icu_analyser {
public:
    explicit icu_analyser(memory source = heap()) noexcept : unicode_{source} {}
    icu_analyser(icu_analyser&& other) noexcept
        : unicode_{std::move(other.unicode_)},
          words_{std::exchange(other.words_, nullptr)},
          opened_{std::exchange(other.opened_, false)}
    {
        for (std::size_t k = 0; k < count; ++k) known_[k] = other.known_[k];
    }
    icu_analyser& operator=(icu_analyser&& other) noexcept
    {
        std::swap(unicode_, other.unicode_);
        std::swap(words_, other.words_);
        std::swap(opened_, other.opened_);
        std::swap(known_, other.known_);
        return *this;
    }
    ~icu_analyser()
    {
        if (words_ != nullptr) ubrk_close(words_);
    }

    error analyse(text_view text, const analysis_options& how, text_analysis& found) noexcept
    {
        if (error e = unicode_.analyse(text, how, found)) return e;
        if (found.unbroken.empty()) return {};
        if (error e = open()) {
            found.clear();
            return e;
        }
        std::size_t left = 0;
        for (const text_range& range : found.unbroken) {
            const std::uint32_t script = script_set::of(decode(text, range.first).value).tag();
            const std::size_t k = dictionary_script_number(script);
            if (k < count && known_[k] && mark_words(text, range, found.marks.view())) continue;
            found.unbroken[left++] = range;
        }
        found.unbroken.truncate(left);
        return {};
    }

private:
    static constexpr std::size_t count = dictionary_script_count;

    /// Opens ICU when it is first needed, and finds the scripts for which it has a dictionary. A reduced ICU does not
    /// fail without a dictionary, but finds no words.
    error open() noexcept
    {
        if (opened_) return {};
        UErrorCode status = U_ZERO_ERROR;
        words_ = ubrk_open(UBRK_LINE, "", nullptr, 0, &status);
        if (status == U_MEMORY_ALLOCATION_ERROR) return error::out_of_memory;
        opened_ = true;
        if (U_FAILURE(status)) words_ = nullptr;
        for (std::size_t k = 0; k < count && words_ != nullptr; ++k) {
            text_mark marks[16] = {};
            const text_view text{dictionary_scripts[k].words};
            mark_words(text, {0, static_cast<std::uint32_t>(text.size())}, marks);
            for (const text_mark mark : marks) known_[k] = known_[k] || mark != text_mark::none;
        }
        return {};
    }

    /// Marks line breaks inside a range. False if ICU fails, which happens only when out of memory.
    bool mark_words(text_view text, text_range range, std::span<text_mark> marks) noexcept
    {
        UErrorCode status = U_ZERO_ERROR;
        UText units = UTEXT_INITIALIZER;
        if (text.encoding() == encoding::utf8)
            utext_openUTF8(&units, text.utf8() + range.first, range.last - range.first, &status);
        else
            utext_openUChars(&units, text.utf16() + range.first, range.last - range.first, &status);
        ubrk_setUText(words_, &units, &status);
        if (U_SUCCESS(status))
            for (std::int32_t at = ubrk_first(words_); at != UBRK_DONE; at = ubrk_next(words_)) {
                const std::size_t i = range.first + static_cast<std::size_t>(at);
                if (i > range.first && i < range.last) marks[i] = marks[i] | text_mark::may_break;
            }
        utext_close(&units);
        return U_SUCCESS(status) != 0;
    }

    unicode_analyser unicode_;
    UBreakIterator* words_ = nullptr;
    bool opened_ = false;
    bool known_[count] = {};  // whether ICU knows the words of each of dictionary_scripts
};
static_assert(text_analyser<icu_analyser>);

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/unicode/impl/bidi_brackets.hpp>
#include <typemesh/unicode/script.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A part of a text in one script.
struct script_run {
    std::uint32_t first = 0;
    std::uint32_t last = 0;    ///< one past its end
    std::uint32_t script = 0;  ///< ISO 15924, as script_tag(); 'Zyyy' if no letter decides it
};

/// Cuts a paragraph into runs of one script: UAX #24.
///
///     Hello (CCC) 5     C is a Cyrillic letter. Marks, spaces and punctuation belong to the run before them; at the
///     |Latn  |Cy|Latn   start of the paragraph they belong to the next run. A closing bracket belongs to the run of
///                       its opening bracket. A character of several scripts does not end a run of one of them. Scripts
///                       that are set as one (script.hpp) share a run, which has the script of its first letter. A mark
///                       stays with its letter, whatever scripts it belongs to.
///
/// At most 32 brackets are open at a time. The runs are appended to `runs`. Cost: O(n)
class script_itemiser {
public:
    explicit script_itemiser(buffer<script_run>& runs) noexcept : runs_{runs} {}

    /// Adds a character that begins no grapheme. It narrows the run's scripts, and never ends the run.
    void add_mark(char32_t c) noexcept { scripts_.intersect(script_set::numbered(number_of(c))); }

    /// Adds the next character, and its place in the text. Places are in ascending order.
    ///
    /// Fails  error::out_of_memory
    error add(char32_t c, bracket_kind kind, std::uint32_t place) noexcept
    {
        if (!begun_) first_ = place;
        begun_ = true;
        const std::size_t number = number_of(c);
        if (kind == bracket_kind::none && (number == 0 || number == settled_)) return {};
        script_set own = script_set::numbered(number);
        settled_ = number;
        if (kind == bracket_kind::closing) close(opening_bracket(c, kind), own);
        if (!scripts_.intersect(own) && !set_as_one(scripts_.tag(), own.tag())) {
            if (error e = end(place)) return e;
            scripts_ = own;
            first_ = place;
            begun_ = true;
        }
        if (kind == bracket_kind::opening) open(opening_bracket(c, kind));
        return {};
    }

    /// Ends the last run at the end of the paragraph.
    ///
    /// Fails  error::out_of_memory
    error end(std::uint32_t place) noexcept
    {
        if (!begun_) return {};
        begun_ = false;
        for (std::size_t k = 0; k < depth_ && opened(k).in_this_run; ++k) {
            opened(k).scripts = scripts_;
            opened(k).in_this_run = false;
        }
        return runs_.push_back({first_, place, scripts_.tag()}) ? error{} : error{error::out_of_memory};
    }

private:
    struct open_bracket {
        char32_t bracket;
        bool in_this_run;    // its run has not ended yet
        script_set scripts;  // the scripts of its run, set when the run ends
    };

    /// The number of a character's set. Usually it is the set of the neighbouring characters.
    [[nodiscard]] std::size_t number_of(char32_t c) noexcept
    {
        if (c < 0x80) return script_set::range_of(c).number;
        if (c < range_.first || c > range_.last) range_ = script_set::range_of(c);
        return range_.number;
    }

    /// The k-th open bracket, counted outwards from the innermost one, 0. Only the innermost `most` brackets are kept.
    [[nodiscard]] open_bracket& opened(std::size_t k) noexcept { return brackets_[(top_ - 1 - k) % most]; }

    void open(char32_t bracket) noexcept
    {
        ++top_;
        if (depth_ < most) ++depth_;
        opened(0) = {bracket, true, {}};
    }

    /// If the bracket has a partner in an earlier run, returns the scripts of that run.
    void close(char32_t bracket, script_set& scripts) noexcept
    {
        std::size_t k = 0;
        while (k < depth_ && opened(k).bracket != bracket) ++k;
        if (k == depth_) return;
        if (!opened(k).in_this_run) scripts = opened(k).scripts;
        top_ -= k + 1;
        depth_ -= k + 1;
    }

    static constexpr std::size_t most = 32;

    buffer<script_run>& runs_;
    script_set scripts_;                   // of the run so far
    std::size_t settled_ = 0;              // the number of a set that would not narrow the run's scripts
    script_set::range range_ = {1, 0, 0};  // the range of the last character beyond ASCII
    std::uint32_t first_ = 0;
    bool begun_ = false;
    std::size_t top_ = most, depth_ = 0;
    open_bracket brackets_[most];
};

}  // namespace typemesh::inline TYPEMESH_ABI

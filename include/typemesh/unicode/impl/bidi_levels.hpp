// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/unicode/impl/bidi_brackets.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The direction of a whole paragraph.
enum class paragraph_direction : std::uint8_t {
    automatic,  ///< the direction of its first letter; to the right if it has none
    left_to_right,
    right_to_left,
};

namespace detail {

/// Resolves the levels of one paragraph: rules P2 to I2 of UAX #9. It is linear in the length for any nesting.
class bidi_resolver {
    static constexpr std::uint8_t max_level = 125;  // max_depth of BD2
    static constexpr std::uint32_t none = 0xFFFF'FFFF;

    /// Consecutive characters of one level, without the characters that rule X9 removes.
    struct level_run {
        std::uint32_t first, last;  // both are in the run
        std::uint32_t next;         // the next run of its isolating run sequence
        std::uint8_t level;
        bool begins;  // the first run of a sequence
    };

public:
    bidi_resolver(const char32_t* text, const bidi_class* classes, std::size_t size, std::uint8_t* levels) noexcept
        : text_{text}, classes_{classes}, size_{size}, levels_{levels}
    {
    }

    result<std::uint8_t> operator()(paragraph_direction direction, workspace& space) noexcept
    {
        using enum bidi_class;
        const std::size_t n = size_;
        if (n == 0) return static_cast<std::uint8_t>(direction == paragraph_direction::right_to_left ? 1 : 0);
        bidi_classes seen;
        for (std::size_t i = 0; i < n; ++i) seen.add(classes_[i]);
        const bool embedded = seen.meets({lre, lro, rle, rlo, pdf, lri, rli, fsi, pdi});
        if (!embedded && !seen.meets({r, al, an}) && direction != paragraph_direction::right_to_left) {
            std::memset(levels_, 0, n);
            return std::uint8_t{0};
        }

        workspace::scope scratch{space};
        types_ = scratch.take<bidi_class>(n);
        partners_ = scratch.take<std::uint32_t>(n);
        runs_ = scratch.take<level_run>(n);
        places_ = scratch.take<std::uint32_t>(n);
        gathered_ = scratch.take<bidi_class>(n);
        opened_ = scratch.take<opened_bracket>(n);
        if (types_ == nullptr || partners_ == nullptr || runs_ == nullptr || places_ == nullptr ||
            gathered_ == nullptr || opened_ == nullptr)
            return error::out_of_memory;

        std::memcpy(types_, classes_, n * sizeof(bidi_class));
        const std::uint8_t first_letter = match_isolates();
        base_ = direction == paragraph_direction::automatic       ? first_letter
                : direction == paragraph_direction::right_to_left ? std::uint8_t{1}
                                                                  : std::uint8_t{0};
        embed();
        find_runs();
        for (std::size_t i = 0; i < run_count_; ++i)
            if (runs_[i].begins) resolve_sequence(i);
        for (std::size_t i = 0; i < n; ++i)
            if (types_[i] == bn) levels_[i] = i == 0 ? base_ : levels_[i - 1];
        return base_;
    }

private:
    /// One entry of the stack in rules X1 to X8.
    struct status {
        std::uint8_t level;
        bidi_class override_to;  // on: none
        bool isolate;
    };

    /// BD9, P2, P3 and X5c: matches isolates and turns each fsi into an lri or rli. partners_ of a pdi is the start of
    /// its isolate; partners_ of an initiator is `none`. Returns the paragraph's level by its first letter.
    std::uint8_t match_isolates() noexcept
    {
        using enum bidi_class;
        std::uint32_t open = none;  // the innermost open isolate; its partners_ entry is the next outer one
        bidi_class first = on;
        for (std::uint32_t i = 0; i < size_; ++i) {
            const bidi_class c = classes_[i];
            partners_[i] = none;
            if (bidi_classes{lri, rli, fsi}.holds(c)) {
                partners_[i] = open;
                open = i;
            } else if (c == pdi && open != none) {
                const std::uint32_t outer = partners_[open];
                partners_[open] = none;
                partners_[i] = open;
                open = outer;
            } else if (bidi_classes{l, r, al}.holds(c)) {
                if (open == none && first == on) first = c;
                if (open != none && types_[open] == fsi) types_[open] = c == l ? lri : rli;
            }
        }
        while (open != none) {
            const std::uint32_t outer = partners_[open];
            partners_[open] = none;
            open = outer;
        }
        return first == r || first == al ? 1 : 0;
    }

    /// X1 to X8: explicit levels and overrides. Characters that rule X9 removes become bn.
    void embed() noexcept
    {
        using enum bidi_class;
        depth_ = overflow_isolates_ = overflow_embeddings_ = valid_isolates_ = 0;
        stack_[0] = {base_, on, false};
        for (std::size_t i = 0; i < size_; ++i) {
            const bidi_class c = types_[i];
            if (c == pdi) close_isolate();
            levels_[i] = stack_[depth_].level;
            if (c == lre || c == rle || c == lro || c == rlo) {
                const bidi_class override_to = c == lro ? l : c == rlo ? r : on;
                open_embedding(c == rle || c == rlo ? 1 : 0, override_to);
                types_[i] = bn;
            } else if (c == pdf) {
                close_embedding();
                types_[i] = bn;
            } else if (c == b) {
                levels_[i] = base_;
            } else if (c != bn) {
                if (stack_[depth_].override_to != on) types_[i] = stack_[depth_].override_to;
                if (c == lri || c == rli || c == fsi) open_isolate(c == rli ? 1 : 0);
            }
        }
    }

    /// The lowest level above the current one that is odd, or even.
    [[nodiscard]] std::uint8_t next_level(unsigned odd) const noexcept
    {
        const unsigned above = stack_[depth_].level + 1u;
        return static_cast<std::uint8_t>(above + (above + odd) % 2);
    }

    void open_embedding(unsigned odd, bidi_class override_to) noexcept
    {
        const std::uint8_t level = next_level(odd);
        if (level <= max_level && overflow_isolates_ == 0 && overflow_embeddings_ == 0)
            stack_[++depth_] = {level, override_to, false};
        else if (overflow_isolates_ == 0)
            ++overflow_embeddings_;
    }

    void close_embedding() noexcept
    {
        if (overflow_isolates_ > 0) return;
        if (overflow_embeddings_ > 0)
            --overflow_embeddings_;
        else if (depth_ > 0 && !stack_[depth_].isolate)
            --depth_;
    }

    void open_isolate(unsigned odd) noexcept
    {
        const std::uint8_t level = next_level(odd);
        if (level <= max_level && overflow_isolates_ == 0 && overflow_embeddings_ == 0) {
            ++valid_isolates_;
            stack_[++depth_] = {level, bidi_class::on, true};
        } else
            ++overflow_isolates_;
    }

    void close_isolate() noexcept
    {
        if (overflow_isolates_ > 0) {
            --overflow_isolates_;
            return;
        }
        if (valid_isolates_ == 0) return;
        overflow_embeddings_ = 0;
        while (!stack_[depth_].isolate) --depth_;
        --depth_;
        --valid_isolates_;
    }

    /// BD7 and BD13: finds level runs. A run that ends with an isolate initiator is linked to the matching pdi's run.
    void find_runs() noexcept
    {
        using enum bidi_class;
        run_count_ = 0;
        for (std::uint32_t i = 0; i < size_; ++i) {
            if (types_[i] == bn) continue;
            if (run_count_ > 0 && runs_[run_count_ - 1].level == levels_[i]) {
                runs_[run_count_ - 1].last = i;
                continue;
            }
            if (run_count_ > 0) note_end(run_count_ - 1);
            level_run& run = runs_[run_count_] = {i, i, none, levels_[i], true};
            // partners_ of an initiator is the run that ends with it, after that run has ended.
            const std::uint32_t before = classes_[i] == pdi && partners_[i] != none ? partners_[partners_[i]] : none;
            if (before != none) {
                runs_[before].next = static_cast<std::uint32_t>(run_count_);
                run.begins = false;
            }
            ++run_count_;
        }
    }

    void note_end(std::size_t run) noexcept
    {
        if (is_initiator(runs_[run].last)) partners_[runs_[run].last] = static_cast<std::uint32_t>(run);
    }

    [[nodiscard]] bool is_initiator(std::uint32_t i) const noexcept
    {
        return bidi_classes{bidi_class::lri, bidi_class::rli, bidi_class::fsi}.holds(classes_[i]);
    }

    /// X10: gathers the sequence that begins with a run, and applies the rules W1 to I2 to it.
    void resolve_sequence(std::size_t first_run) noexcept
    {
        using enum bidi_class;
        std::size_t count = 0, last_run = first_run;
        bidi_classes seen;
        for (std::uint32_t run = static_cast<std::uint32_t>(first_run); run != none; run = runs_[run].next) {
            for (std::uint32_t i = runs_[run].first; i <= runs_[run].last; ++i) {
                if (types_[i] == bn) continue;
                places_[count] = i;
                gathered_[count++] = types_[i];
                seen.add(types_[i]);
            }
            last_run = run;
        }
        const std::uint8_t level = runs_[first_run].level;
        const bool open_end = is_initiator(runs_[last_run].last) || last_run + 1 == run_count_;
        const auto letter = [level](std::uint8_t beside) noexcept {
            return (beside > level ? beside : level) % 2 == 0 ? l : r;
        };
        const bidi_sequence sequence{gathered_,
                                     places_,
                                     count,
                                     level,
                                     letter(first_run == 0 ? base_ : runs_[first_run - 1].level),
                                     letter(open_end ? base_ : runs_[last_run + 1].level)};
        if (seen.meets({nsm, al})) resolve_marks(sequence);
        if (seen.meets({en, an, es, et, cs})) resolve_numbers(sequence);
        if (seen.holds(on)) resolve_brackets(sequence, classes_, opened_, pair_brackets(sequence, text_, opened_));
        resolve_neutrals(sequence);
        for (std::size_t k = 0; k < count; ++k) levels_[places_[k]] = implicit_level(level, gathered_[k]);
    }

    const char32_t* text_;
    const bidi_class* classes_;
    std::size_t size_;
    std::uint8_t* levels_;
    std::uint8_t base_ = 0;

    bidi_class* types_ = nullptr;
    std::uint32_t* partners_ = nullptr;
    level_run* runs_ = nullptr;
    std::size_t run_count_ = 0;
    std::uint32_t* places_ = nullptr;
    bidi_class* gathered_ = nullptr;
    opened_bracket* opened_ = nullptr;

    status stack_[max_level + 2];
    std::size_t depth_ = 0;
    std::size_t overflow_isolates_ = 0, overflow_embeddings_ = 0, valid_isolates_ = 0;
};

}  // namespace detail

/// Resolves the embedding levels of one paragraph: the bidirectional algorithm, rules P2 to I2 of UAX #9.
///
///     text      the characters of the paragraph; the last one may be a paragraph separator
///     classes   one for each character: character_of(c).bidi
///     levels    gets a level for each character: even levels are read to the right, odd ones to the left. Characters
///               that rule X9 removes get the previous level. Rule L1 is applied line by line: see visual_order.hpp.
///
/// Returns the level of the paragraph, 0 or 1.
///
/// Fails  error::out_of_memory
/// Cost   O(n) time for any nesting; 42 n bytes of `space`, none if the whole text is read to the right
[[nodiscard]] inline result<std::uint8_t> bidi_levels(std::span<const char32_t> text,
                                                      std::span<const bidi_class> classes,
                                                      paragraph_direction direction, workspace& space,
                                                      std::span<std::uint8_t> levels) noexcept
{
    TYPEMESH_ASSERT(text.size() == classes.size() && text.size() == levels.size(),
                    "bidi_levels() needs a class and a level for each character");
    return detail::bidi_resolver{text.data(), classes.data(), text.size(), levels.data()}(direction, space);
}

}  // namespace typemesh::inline TYPEMESH_ABI

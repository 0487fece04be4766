// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/paragraph/first_fit.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// Chooses all line ends of a paragraph together, so that the lines are filled as evenly as possible. The sum of their
/// demerits is minimal: D. Knuth and M. Plass, "Breaking paragraphs into lines" (1981), without their classes of
/// fitness.
///
///     stretch     the growth of a line's spaces that fills the line, as a fraction of their own width
///     badness     100 (2 stretch)^3; if spaces shrink, 100 (fraction of the maximum shrink)^3; 0 for a line that ends
///                 at a line break of the text
///     demerits    (10 + badness)^2, and at a hyphen hyphen_penalty^2
///
/// If no choice of lines is within the tolerance, first_fit makes one line, from the last place where a line may still
/// begin.
///
/// At most 32 starts of lines are compared at a time. If more starts are possible, as in lines of hundreds of words,
/// the least promising starts are dropped. Lines still keep the tolerance, but may not be the best.
///
/// Cost  O(n) for n pieces, with at most 32 comparisons per piece; twice as much if emergency_stretch is needed
struct total_fit {
    double tolerance = 1.0;          ///< the greatest stretch of a line: 1 lets spaces double
    double hyphen_penalty = 50.0;    ///< the penalty for a hyphen; 0: hyphens are as good as spaces; infinite: only
                                     ///< first_fit uses hyphens
    double emergency_stretch = 0.0;  ///< if no lines are within the tolerance, try again with each line allowed to
                                     ///< stretch further, by this fraction of the width

    error break_lines(std::span<const break_piece> pieces, const line_room& room,
                      buffer<std::uint32_t>& ends) const noexcept;
};

namespace detail {

/// The line ends of a range of pieces, which ends with a line break of the text.
class best_lines {
public:
    best_lines(const total_fit& how, std::span<const break_piece> pieces, const line_room& room, bool fresh,
               std::size_t first, std::size_t last) noexcept
        : how_{how}, pieces_{pieces}, room_{room}, fresh_{fresh}, first_{first}, last_{last}
    {
    }

    /// Appends the ends.
    ///
    /// Fails  error::out_of_memory
    error operator()(buffer<std::uint32_t>& ends) noexcept
    {
        const std::size_t base = ends.size();
        if (ends.append(last_ - first_) == nullptr) return error::out_of_memory;
        begins_ = ends.view().subspan(base);
        const double emergency = how_.emergency_stretch * room_.width;
        if (!search(0.0, !(emergency > 0.0))) (void)search(emergency, true);
        ends.truncate(base + list_ends());
        return {};
    }

private:
    /// A place where a line may begin, with the best lines before it. Lengths are measured along the pieces since
    /// begin_at().
    struct start {
        std::uint32_t piece = 0;
        double origin = 0.0;   // the pen's sum at x = 0 of the line
        double before = 0.0;   // the stretch before the line's own
        double width = 0.0;    // the width of the line up to the current piece, without hanging white space
        double stretch = 0.0;  // the stretch of the line up to the current piece
        double demerits = 0.0;
        double forecast = 0.0;  // demerits minus the minimum of the lines before
    };

    static constexpr double infinite = std::numeric_limits<double>::infinity();
    static constexpr double least = 100.0;  // demerits of a perfect line
    static constexpr std::size_t most = 32;

    /// Fills in begins_. If there is no solution, `always` lets first_fit help; without it, the result is false.
    bool search(double emergency, bool always) noexcept
    {
        emergency_ = emergency;
        begin_at(first_, 0.0);
        for (std::size_t k = first_; k < last_;) {
            const start best = pass(k);
            ++k;
            if (best.demerits < infinite) {
                begins_[k - 1 - first_] = best.piece;
                add(k, best.demerits);
            }
            if (from_ != to_ || (k == last_ && best.demerits < infinite)) continue;
            if (!always) return false;
            const std::size_t end = first_fit::end_of(pieces_, lost_.piece, pen_at(lost_.piece), room_);
            begins_[end - 1 - first_] = lost_.piece;
            begin_at(end, lost_.demerits);
            k = end;
        }
        return true;
    }

    [[nodiscard]] double pen_at(std::size_t piece) const noexcept { return room_.start(fresh_ && piece == first_); }

    /// Makes `piece` the only start of lines.
    void begin_at(std::size_t piece, double demerits) noexcept
    {
        pen_ = stretch_ = 0.0;
        from_ = to_ = 0;
        if (piece < last_) add(piece, demerits);
    }

    /// Adds a start. If there are too many, it replaces the least promising one.
    void add(std::size_t piece, double demerits) noexcept
    {
        if (piece == last_) return;
        const start s{.piece = static_cast<std::uint32_t>(piece),
                      .origin = pen_ - pen_at(piece) - pieces_[piece].begin_change,
                      .before = stretch_,
                      .demerits = demerits,
                      .forecast = demerits - least * pen_ / room_.width};
        if (to_ - from_ == most) {
            std::size_t worst = from_;
            for (std::size_t i = from_; i < to_; ++i)
                if (starts_[i].forecast > starts_[worst].forecast) worst = i;
            if (!(s.forecast < starts_[worst].forecast)) return;
            std::copy(starts_ + worst + 1, starts_ + to_, starts_ + worst);
            --to_;
        }
        if (to_ == 2 * most) {
            std::copy(starts_ + from_, starts_ + to_, starts_);
            to_ -= from_;
            from_ = 0;
        }
        starts_[to_++] = s;
    }

    /// Processes piece k. Returns the best line that ends after it, with infinite demerits if there is none. Starts of
    /// lines that are now too long are dropped; lost_ gets the last dropped start.
    start pass(std::size_t k) noexcept
    {
        const break_piece& p = pieces_[k];
        const bool visible = p.is_visible(), ends = k + 1 == last_;
        const double width = pen_ + p.width, stretch = stretch_;
        const double change = visible ? p.end_change : 0.0;
        start best{.demerits = infinite};
        std::size_t kept = from_;
        pen_ += p.width + p.space;
        stretch_ += p.stretch;
        const bool may_end = ends || p.end == piece_end::allowed;
        for (std::size_t i = from_; i < to_; ++i) {
            start& s = starts_[i];
            const double line = visible ? width - s.origin : s.width;
            const double spaces = visible ? stretch - s.before : s.stretch;
            if (p.width > 0.0) {
                s.width = line;
                s.stretch = spaces;
            }
            const double spare = room_.width - line - change, shrink = room_.shrink * spaces;
            if (may_end && (ends || !(spare > how_.tolerance * (spaces + emergency_)))) {
                const double sum = s.demerits + demerits_of(spare, spaces, shrink, ends, p.hyphen);
                if (sum < best.demerits) best = {.piece = s.piece, .demerits = sum};
            }
            if (ends || (spare < 0.0 - shrink && spare + change < 0.0 - shrink)) {
                lost_ = s;
                if (kept == from_) kept = from_ = i + 1;
                continue;
            }
            if (p.tab) {
                s.origin = pen_ - room_.after_tab(pen_ - s.origin);
                s.before = stretch_;
            }
            if (kept != i) starts_[kept] = s;
            ++kept;
        }
        to_ = kept;
        return best;
    }

    /// The demerits of a line with this much spare width; infinite if its spaces cannot shrink so far.
    [[nodiscard]] double demerits_of(double spare, double stretch, double shrink, bool ends, bool hyphen) const noexcept
    {
        double share = 0.0;
        if (spare < 0.0) {
            if (spare < 0.0 - shrink) return infinite;
            share = 0.0 - spare / shrink;
        } else if (spare > 0.0 && !ends) {
            const double all = stretch + emergency_;
            share = 2.0 * spare / all;
        }
        const double bad = 10.0 + 100.0 * share * share * share;
        return bad * bad + (hyphen && !ends ? how_.hyphen_penalty * how_.hyphen_penalty : 0.0);
    }

    /// Turns the chain of starts into the list of ends, in place. Returns their number.
    std::size_t list_ends() noexcept
    {
        auto next = static_cast<std::uint32_t>(last_);
        for (auto end = next; end > first_;) {
            std::uint32_t& link = begins_[end - 1 - first_];
            const std::uint32_t begin = link;
            link = next;
            next = end;
            end = begin;
        }
        std::size_t lines = 0;
        for (std::uint32_t end = next;;) {
            const std::uint32_t behind = begins_[end - 1 - first_];
            begins_[lines++] = end;
            if (end == last_) return lines;
            end = behind;
        }
    }

    const total_fit& how_;
    std::span<const break_piece> pieces_;
    const line_room& room_;
    bool fresh_;
    std::size_t first_, last_;
    std::span<std::uint32_t> begins_;  // for each piece: the start of the best line that ends after it
    double emergency_ = 0.0;
    double pen_ = 0.0, stretch_ = 0.0;  // sums since begin_at()
    start starts_[2 * most];
    std::size_t from_ = 0, to_ = 0;  // the starts in use, in the order of the text
    start lost_;
};

}  // namespace detail

inline error total_fit::break_lines(std::span<const break_piece> pieces, const line_room& room,
                                    buffer<std::uint32_t>& ends) const noexcept
{
    if (!(tolerance >= 0.0)) return error::bad("tolerance");
    if (!(hyphen_penalty >= 0.0)) return error::bad("hyphen_penalty");
    if (!is_finite(emergency_stretch) || emergency_stretch < 0.0) return error::bad("emergency_stretch");
    const std::size_t before = ends.size();
    bool fresh = true;
    for (std::size_t first = 0; first < pieces.size() && ends.size() - before < room.max_lines;) {
        std::size_t last = first + 1;
        while (last < pieces.size() && !pieces[last - 1].ends_line()) ++last;
        if (error e = detail::best_lines{*this, pieces, room, fresh, first, last}(ends)) return e;
        fresh = pieces[last - 1].end == piece_end::paragraph;
        first = last;
    }
    if (ends.size() - before > room.max_lines) ends.truncate(before + room.max_lines);
    return {};
}

static_assert(line_breaker<total_fit>);

}  // namespace typemesh::inline TYPEMESH_ABI

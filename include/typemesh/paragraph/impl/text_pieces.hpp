// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/layout/impl/shaped_text.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/paragraph/break_piece.hpp>
#include <typemesh/paragraph/impl/line_cut.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The source of a piece in its shaped text.
struct shaped_piece {
    std::uint32_t cluster = 0;   ///< the cluster of its first unit; for an empty piece, the index after the last one
    std::uint32_t cut = no_cut;  ///< the changes if a line ends with the piece
};

/// A shaped text's words. On demand, also the graphemes of words that must be broken. Lengths are in font units.
///
/// Functions that make pieces fail with error::out_of_memory, and as the shaper does.
class text_pieces {
public:
    explicit text_pieces(memory source = heap()) noexcept
        : words_{source}, graphemes_{source}, gathered_{source}, elided_{source}, expansions_{source}, cuts_{source}
    {
    }

    /// Pieces, and the source of each.
    struct list {
        explicit list(memory source) noexcept : pieces{source}, sources{source} {}
        buffer<break_piece> pieces;
        buffer<shaped_piece> sources;      ///< of each piece
        std::uint32_t begin_cut = no_cut;  ///< the changes if a line begins with the first piece

        void clear() noexcept
        {
            begin_cut = no_cut;
            pieces.clear();
            sources.clear();
        }
        [[nodiscard]] bool push_back(const break_piece& piece, shaped_piece source) noexcept
        {
            return pieces.push_back(piece) && sources.push_back(source);
        }
        [[nodiscard]] bool append(const list& other, std::size_t first, std::size_t count) noexcept
        {
            return pieces.append(other.pieces.view().subspan(first, count)) &&
                   sources.append(other.sources.view().subspan(first, count));
        }
    };

    void clear() noexcept
    {
        words_.clear();
        graphemes_.clear();
        expansions_.clear();
        cuts_.clear();
        widest_ = 0.0;
        joined_ = false;
    }

    /// The words in the order of the text; there is at least one.
    [[nodiscard]] const list& words() const noexcept { return words_; }
    /// The cut with this number, which is not no_cut.
    [[nodiscard]] const line_cut& cut(std::uint32_t number) const noexcept { return cuts_[number]; }

    /// Splits a shaped text into words: at all places where Unicode allows a line to end, and after tabs.
    template <shaper Shaper>
    error find_words(shaped_text& shaped, Shaper& shaper) noexcept
    {
        clear();
        const auto size = static_cast<std::uint32_t>(shaped.text().size());
        open_piece now;
        for (std::uint32_t c = 0; c < shaped.cluster_count(); ++c) {
            const text_cluster cluster = shaped.cluster(c);
            now.begin(c);
            for (std::uint32_t u = cluster.first + 1; u <= cluster.last; ++u) {
                const bool tab = u == cluster.last && has(cluster.flags, cluster_flags::tab);
                if (u < size && !tab && !may_end(shaped.analysis.marks[u])) continue;
                const bool never = u < size && !may_end(shaped.analysis.marks[u]);  // a tab before a bracket
                const piece_end end = never ? piece_end::never : end_at(shaped, cluster, u);
                joined_ = joined_ || never;
                if (error e = close(shaped, shaper, {c, u, end, tab}, now, words_)) return e;
            }
            now.add_rest(shaped, cluster);
        }
        const bool more = words_.pieces.empty() || shaped.cluster_count() == 0 || ends_with_break(shaped);
        if (more && !words_.push_back({.first = size, .last = size, .end = piece_end::paragraph},
                                      {shaped.cluster_count(), no_cut}))
            return error::out_of_memory;
        expansion* all = expansions_.append(words_.pieces.size());
        if (all == nullptr) return error::out_of_memory;
        for (std::size_t i = 0; i < words_.pieces.size(); ++i) all[i] = {};
        return {};
    }

    /// The pieces for a wrap mode: the words, or all graphemes, or words, broken if they do not fit into `narrowest`.
    /// The list lives until the next call. It shapes only text that no earlier call has shaped.
    template <shaper Shaper>
    result<const list*> pieces_for(wrap_mode wrap, double narrowest, shaped_text& shaped, Shaper& shaper) noexcept
    {
        const bool all = wrap == wrap_mode::grapheme;
        if (!all && (wrap != wrap_mode::word_or_grapheme || !(joined_ || widest_ > narrowest))) return &words_;
        gathered_.clear();
        for (std::size_t i = 0; i < words_.pieces.size(); ++i) {
            const break_piece& word = words_.pieces[i];
            const std::size_t before = gathered_.pieces.size();
            const bool hemmed =
                i > 0 && words_.pieces[i - 1].end == piece_end::never && !begins_line(shaped, word.first);
            if (all || hemmed || word.room() > narrowest) {
                if (error e = expand(i, shaped, shaper)) return e;
                if (!gathered_.append(graphemes_, expansions_[i].first, expansions_[i].count))
                    return error::out_of_memory;
            } else if (!gathered_.append(words_, i, 1)) {
                return error::out_of_memory;
            }
            if (word.end == piece_end::never && begins_line(shaped, word.last))
                gathered_.pieces.back().end = piece_end::in_need;
            if (!all) continue;
            for (break_piece& p : gathered_.pieces.view().subspan(before))
                if (p.end == piece_end::in_need) p.end = piece_end::allowed;
        }
        return &gathered_;
    }

    /// The graphemes of text[first, last), whose ends are ends of words or graphemes. The list lives until the next
    /// call.
    template <shaper Shaper>
    result<const list*> graphemes_of(std::uint32_t first, std::uint32_t last, shaped_text& shaped,
                                     Shaper& shaper) noexcept
    {
        elided_.clear();
        const array_view<const break_piece> words = words_.pieces.view();
        for (std::size_t i =
                 first_where(0, words.size(), [&](std::size_t k) noexcept { return words[k].last > first; });
             i < words.size() && words[i].first < last; ++i) {
            if (error e = expand(i, shaped, shaper)) return e;
            if (i > 0 && words[i].first == first) elided_.begin_cut = words_.sources[i - 1].cut;
            for (std::uint32_t g = expansions_[i].first; g < expansions_[i].first + expansions_[i].count; ++g) {
                const break_piece& p = graphemes_.pieces[g];
                if (p.last == first) elided_.begin_cut = graphemes_.sources[g].cut;
                if (p.first >= first && p.last <= last && !elided_.append(graphemes_, g, 1))
                    return error::out_of_memory;
            }
        }
        return &elided_;
    }

private:
    /// UAX #14 lets a line end between a space and a mark on it, but they are one grapheme.
    static bool may_end(text_mark marks) noexcept
    {
        return has(marks, text_mark::may_break | text_mark::must_break) && has(marks, text_mark::grapheme);
    }

    struct expansion {
        std::uint32_t first = 0, count = 0;  // of graphemes_; count 0: not made yet
    };

    /// A piece that is being gathered.
    struct open_piece {
        std::uint32_t cluster = 0, first = 0;  // the start of the piece
        double width = 0.0, space = 0.0, stretch = 0.0, begin_change = 0.0;
        bool empty = true;
        bool drawn = false;
        double spacing = 0.0;  // of its last visible cluster
        double taken = 0.0;    // the part of the current cluster that earlier pieces have taken

        void begin(std::uint32_t c) noexcept
        {
            if (empty) cluster = c;
            taken = 0.0;
        }
        void add(const shaped_text& shaped, const text_cluster& c, double share) noexcept
        {
            empty = false;
            const double advance = share * c.advance;
            if (has(c.flags, cluster_flags::hangs)) {
                space += advance;
                if (has(c.flags, cluster_flags::stretches)) stretch += advance;
                return;
            }
            if (has(c.flags, cluster_flags::unseen)) return;  // it has no advance, and spaces before it may hang
            drawn = true;
            width += space + advance;
            space = 0.0;
            spacing = shaped.spacing_of(c);
        }
        void add_rest(const shaped_text& shaped, const text_cluster& c) noexcept
        {
            if (taken < 1.0) add(shaped, c, 1.0 - taken);
        }
    };

    /// The end of a piece: in a cluster or after it.
    struct ending {
        std::uint32_t cluster, unit;
        piece_end end;
        bool tab;
    };

    template <shaper Shaper>
    error close(shaped_text& shaped, Shaper& shaper, const ending& at, open_piece& now, list& out) noexcept
    {
        const text_cluster cluster = shaped.cluster(at.cluster);
        const double share = at.unit >= cluster.last
                                 ? 1.0
                                 : static_cast<double>(at.unit - cluster.first) / (cluster.last - cluster.first);
        now.add(shaped, cluster, share - now.taken);
        now.taken = share;
        const bool parts = at.end != piece_end::never && at.unit < shaped.text().size();
        shaped_piece where{now.cluster, no_cut};
        break_piece piece{.first = now.first,
                          .last = at.unit,
                          .width = now.width,
                          .space = now.space,
                          .stretch = now.stretch,
                          .begin_change = now.begin_change,
                          .end_change = 0.0 - now.spacing,
                          .end = at.end,
                          .hyphen = parts && shaped.hyphenates(at.unit),
                          .tab = at.tab,
                          .drawn = now.drawn};
        double next_change = 0.0;
        if (parts) {
            line_cut cut;
            const auto changes = make_cut(shaped, shaper, at.cluster, at.unit, share, cut);
            if (!changes) return changes.error();
            if (*changes) {
                where.cut = static_cast<std::uint32_t>(cuts_.size());
                if (!cuts_.push_back(cut)) return error::out_of_memory;
                piece.end_change += cut.end_change;
                if (piece.hyphen) piece.end_change += before_hyphen(shaped, at.cluster, cut.before_from, now);
                next_change = cut.begin_change;
            }
        }
        if (!out.push_back(piece, where)) return error::out_of_memory;
        if (&out == &words_ && piece.room() > widest_) widest_ = piece.room();
        const double taken = now.taken;
        now = {.cluster = at.cluster, .first = at.unit, .begin_change = next_change};
        now.taken = taken;
        return {};
    }

    /// The width that remains at a line's end before a hyphen in a separate item with clusters [from, c]: the spacing
    /// of the last letter, and white space after it, which does not hang before a hyphen.
    static double before_hyphen(const shaped_text& shaped, std::uint32_t c, std::uint32_t from,
                                const open_piece& now) noexcept
    {
        const auto unshown = [&shaped](std::uint32_t k) noexcept {
            return has(shaped.cluster(k).flags, cluster_flags::unshown);
        };
        for (std::uint32_t k = from; k <= c; ++k)
            if (!unshown(k)) return 0.0;
        double left = now.spacing;
        for (; from > now.cluster && unshown(from - 1); --from) left += shaped.cluster(from - 1).advance;
        return left;
    }

    /// Makes the graphemes of a word, only once. On failure there are none.
    template <shaper Shaper>
    error expand(std::size_t number, shaped_text& shaped, Shaper& shaper) noexcept
    {
        if (expansions_[number].count != 0) return {};
        const std::size_t before = graphemes_.pieces.size(), cuts = cuts_.size();
        const std::size_t clusters = shaped.all_clusters(), glyphs = shaped.all_glyphs();
        if (error e = add_graphemes(words_.pieces[number], words_.sources[number], shaped, shaper)) {
            graphemes_.pieces.truncate(before);
            graphemes_.sources.truncate(before);
            cuts_.truncate(cuts);
            shaped.truncate(clusters, glyphs);
            return e;
        }
        expansions_[number] = {static_cast<std::uint32_t>(before),
                               static_cast<std::uint32_t>(graphemes_.pieces.size() - before)};
        return {};
    }
    template <shaper Shaper>
    error add_graphemes(break_piece word, shaped_piece home, shaped_text& shaped, Shaper& shaper) noexcept
    {
        open_piece now;
        now.cluster = home.cluster;
        now.first = word.first;
        now.begin_change = word.begin_change;
        for (std::uint32_t c = home.cluster; c < shaped.cluster_count(); ++c) {
            const text_cluster cluster = shaped.cluster(c);
            if (cluster.first >= word.last) break;
            now.begin(c);
            if (cluster.first < word.first)
                now.taken = static_cast<double>(word.first - cluster.first) / (cluster.last - cluster.first);
            const std::uint32_t from = cluster.first < word.first ? word.first : cluster.first;
            for (std::uint32_t u = from + 1; u <= cluster.last && u < word.last; ++u)
                if (begins_line(shaped, u))
                    if (error e = close(shaped, shaper, {c, u, piece_end::in_need, false}, now, graphemes_)) return e;
            if (cluster.last <= word.last)
                now.add_rest(shaped, cluster);
            else
                now.add(shaped, cluster,
                        static_cast<double>(word.last - cluster.first) / (cluster.last - cluster.first) - now.taken);
        }
        const break_piece last{.first = now.first,
                               .last = word.last,
                               .width = now.width,
                               .space = now.space,
                               .stretch = now.stretch,
                               .begin_change = now.begin_change,
                               .end_change = word.end_change,
                               .end = word.end,
                               .hyphen = word.hyphen,
                               .tab = word.tab,
                               .drawn = now.drawn};
        return graphemes_.push_back(last, {now.cluster, home.cut}) ? error{} : error::out_of_memory;
    }

    /// Whether a line may begin with a unit if necessary. A grapheme must begin there, and not white space, which stays
    /// with the text before it.
    static bool begins_line(const shaped_text& shaped, std::uint32_t unit) noexcept
    {
        const array_view<const text_mark> marks = shaped.analysis.marks.view();
        if (!has(marks[unit], text_mark::grapheme) || shaped.insets.keeps(unit)) return false;
        if (!has(marks[unit], text_mark::space | text_mark::separator)) return true;
        return !is_blank(shaped.text(), marks, unit, grapheme_end(marks, unit));
    }

    static piece_end end_at(const shaped_text& shaped, const text_cluster& cluster, std::uint32_t unit) noexcept
    {
        if (unit < shaped.text().size() && !has(shaped.analysis.marks[unit], text_mark::must_break))
            return piece_end::allowed;
        const bool silent = has(cluster.flags, cluster_flags::silent) && !has(cluster.flags, cluster_flags::tab);
        if (!silent) return unit < shaped.text().size() ? piece_end::line : piece_end::paragraph;
        return ends_paragraph(decode(shaped.text(), cluster.first).value) ? piece_end::paragraph : piece_end::line;
    }

    static bool ends_with_break(const shaped_text& shaped) noexcept
    {
        const cluster_flags flags = shaped.cluster(shaped.cluster_count() - 1).flags;
        return has(flags, cluster_flags::silent) && !has(flags, cluster_flags::tab);
    }

    list words_, graphemes_, gathered_, elided_;
    buffer<expansion> expansions_;  // of the words
    buffer<line_cut> cuts_;
    double widest_ = 0.0;  // the smallest width into which every word fits
    bool joined_ = false;  // some words must not be separated: text after a tab from the text before it
};

}  // namespace typemesh::inline TYPEMESH_ABI

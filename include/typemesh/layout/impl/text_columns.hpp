// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/impl/column_glyphs.hpp>
#include <typemesh/layout/impl/column_runs.hpp>
#include <typemesh/layout/impl/itemise.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/layout/style_spans.hpp>
#include <typemesh/unicode/text_analysis.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The orientation of a paragraph's text in columns. It keeps its memory for the next text.
class text_columns {
public:
    explicit text_columns(memory source = heap()) noexcept : spans_{source}, runs_{source} {}

    void clear() noexcept { runs_.clear(); }

    /// Finds the orientation of an analysed text; does nothing for lines. Combined text becomes one grapheme, in which
    /// no line ends.
    ///
    /// Fails  error::out_of_memory
    template <shaper Shaper>
    error find(Shaper& shaper, text_view text, const shape_options& how, const style_spans& styles,
               text_analysis& found) noexcept
    {
        runs_.clear();
        if (how.direction != direction::top_to_bottom) return {};
        const double em = shaper.units_per_em();
        metrics_ = {column_middle_of(shaper), em, how.columns.combined_gap * em};
        spans_.clear();
        for (const style_span& s : styles.spans()) {
            if (s.style.column == column_style::automatic) continue;
            if (!spans_.push_back({s.first, s.last, s.style.column})) return error::out_of_memory;
        }
        const auto has_form = [&shaper](char32_t c) noexcept { return vertical_form_of(shaper, c); };
        if (error e = find_column_runs(text, found.marks.view(), how.columns, spans_.view(), has_form, runs_)) return e;
        for (const column_run& run : runs_)
            if (run.orientation == glyph_orientation::combined) join(text, run, found);
        return {};
    }

    /// The runs; there are none for lines.
    [[nodiscard]] std::span<const column_run> runs() const noexcept { return runs_.view(); }
    [[nodiscard]] const column_metrics& metrics() const noexcept { return metrics_; }

private:
    /// Makes the text between tabs and line breaks one grapheme.
    static void join(text_view text, const column_run& run, text_analysis& found) noexcept
    {
        constexpr text_mark within = text_mark::grapheme | text_mark::may_break | text_mark::hyphen;
        bool behind = true;  // after a tab, a break or the start
        for (std::uint32_t u = run.first; u < run.last; ++u) {
            if (!has(found.marks[u], text_mark::grapheme)) continue;
            const bool silent = silent_at(text, u) != 0;
            if (!silent && !behind) found.marks[u] = without(found.marks[u], within);
            behind = silent;
        }
    }

    column_metrics metrics_;
    buffer<column_span> spans_;
    buffer<column_run> runs_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/impl/column_progress.hpp>
#include <typemesh/layout/impl/line_break.hpp>
#include <typemesh/layout/impl/line_places.hpp>
#include <typemesh/layout/impl/shape_line.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// layout() whose lines are shaped by several workers, each with its own shaper and run. The result is the same. The
/// error is the error of the first line that has one. It keeps its memory for the next text.
class shared_layout {
public:
    explicit shared_layout(memory source = heap()) noexcept : lines_{source}, blocks_{source} {}

    /// `shaper_of(worker)` and `run_of(worker)` return the worker's shaper and run. The content of this run is
    /// meaningless before and after. `shaper` is used only for units and metrics.
    ///
    /// Fails  as layout() does
    template <executor Executor, shaper Shaper, class ShaperOf, class RunOf>
    result<void> operator()(Executor& workers, const ShaperOf& shaper_of, const RunOf& run_of, Shaper& shaper,
                            text_view text, const shape_options& how, const layout_options& options,
                            glyph_run& run) noexcept
    {
        run.clear();
        if (error e = refused_option(options)) return e;
        if (const std::uint64_t length = text.size(); length > 0xFFFF'FFFFu) return error::too_large;
        const std::size_t count = workers.workers();
        if (error e = find_lines(text, 8 * count)) return e;

        run.units_per_em = shaper.units_per_em();
        const line_places places{line_reach_of(shaper, how.direction), run.units_per_em, how.direction, options,
                                 columns_go_right(text, how)};
        for (std::size_t w = 0; w < count; ++w) {
            run_of(w).clear();
            run_of(w).units_per_em = run.units_per_em;
        }
        workers.run(blocks_.size(), [&, this](std::size_t b, std::size_t worker) noexcept {
            glyph_run& own = run_of(worker);
            own.missing = own.parted = own.invalid_units = 0;  // otherwise a shaper could mistake its own first place
                                                               // for the first of all
            own.first_missing = own.first_parted = own.first_invalid_unit = no_cluster;
            for (line& l : lines_of(b)) {
                l.worker = static_cast<std::uint32_t>(worker);
                l.first = own.glyphs.size();
                if (l.begin == l.end) continue;
                auto&& with = shaper_of(worker);
                const auto advance = shape_line(with, text, l.begin, l.end, how, options, own);
                if (!advance) {
                    l.failure = advance.error();
                    return;  // later lines of this block do not matter
                }
                l.count = own.glyphs.size() - l.first;
                l.advance = places.advance(*advance);
            }
            block& of_it = blocks_[b];
            of_it.missing = own.missing;
            of_it.first_missing = own.first_missing;
            of_it.parted = own.parted;
            of_it.first_parted = own.first_parted;
            of_it.invalid_units = own.invalid_units;
            of_it.first_invalid_unit = own.first_invalid_unit;
        });
        for (const line& l : lines_)
            if (l.failure) return l.failure;

        if (error e = number_looks(run_of, count, run)) return e;
        if (error e = place_lines(places, run)) return e;
        workers.run(blocks_.size(), [&, this](std::size_t b, std::size_t) noexcept {
            for (const line& l : lines_of(b)) copy(l, run_of(l.worker), run);
        });
        for (const block& b : blocks_) b.report(run);
        return {};
    }

private:
    struct line {
        std::size_t begin, end;    // in the text
        std::size_t number;        // among the lines
        std::size_t first, count;  // the glyphs of the line in the worker's run
        std::uint32_t worker;
        double advance;
        error failure;
    };

    /// Consecutive lines that one worker shapes, and its counts.
    struct block {
        std::size_t first_line;
        std::uint32_t missing, parted, invalid_units;
        cluster_id first_missing, first_parted, first_invalid_unit;

        void report(glyph_run& run) const noexcept
        {
            run.missing += missing;
            run.parted += parted;
            run.invalid_units += invalid_units;
            if (first_missing < run.first_missing) run.first_missing = first_missing;
            if (first_parted < run.first_parted) run.first_parted = first_parted;
            if (first_invalid_unit < run.first_invalid_unit) run.first_invalid_unit = first_invalid_unit;
        }
    };

    /// Finds the lines, and groups them into about `wanted` blocks of equal length. Very short blocks are avoided.
    error find_lines(text_view text, std::size_t wanted) noexcept
    {
        lines_.clear();
        blocks_.clear();
        const std::size_t most = text.size() / wanted > 256 ? text.size() / wanted : 256;
        std::size_t begin = 0, block_begin = 0;
        for (bool more = true; more;) {
            std::size_t end = begin, broken = 0;
            while (end < text.size() && (broken = line_break_at(text, end)) == 0) ++end;
            more = end < text.size();
            const std::size_t number = lines_.size();
            if (number == 0 || begin - block_begin >= most) {
                if (!blocks_.push_back({number, 0, 0, 0, no_cluster, no_cluster, no_cluster}))
                    return error::out_of_memory;
                block_begin = begin;
            }
            if (!lines_.push_back({begin, end, number, 0, 0, 0, 0.0, {}})) return error::out_of_memory;
            begin = end + broken;
        }
        return {};
    }

    [[nodiscard]] array_view<line> lines_of(std::size_t b) noexcept
    {
        const std::size_t last = b + 1 < blocks_.size() ? blocks_[b + 1].first_line : lines_.size();
        return lines_.view().subspan(blocks_[b].first_line, last - blocks_[b].first_line);
    }

    /// Renumbers the looks of the workers' runs for the whole run, in the order of use by its glyphs.
    template <class RunOf>
    error number_looks(const RunOf& run_of, std::size_t workers, glyph_run& run) noexcept
    {
        bool plain = true;
        for (std::size_t w = 0; w < workers; ++w) plain = plain && run_of(w).looks.empty();
        if (plain) return {};
        for (const line& l : lines_) {
            glyph_run& own = run_of(l.worker);
            for (placed_glyph& g : own.glyphs.view().subspan(l.first, l.count)) {
                const bool known = g.look < own.looks.size(), plain_one = g.look == 0 && own.looks.empty();
                const auto number = known       ? run.number_of(own.looks[g.look])
                                    : plain_one ? run.number_of({})
                                                : result<std::uint32_t>{error::no_such_look};
                if (!number) {
                    run.clear();
                    return number.error().at(g.id, g.cluster);
                }
                g.look = *number;
            }
        }
        return {};
    }

    /// Positions each line, and reserves space in the run for all glyphs.
    error place_lines(const line_places& places, glyph_run& run) const noexcept
    {
        const auto fail = [&run](error e) noexcept {
            run.clear();
            return e;
        };
        std::uint64_t glyphs = 0;
        text_line* out = run.lines.append(lines_.size());
        if (out == nullptr) return fail(error::out_of_memory);
        for (const line& l : lines_) {
            out[l.number] = {static_cast<std::uint32_t>(glyphs), static_cast<std::uint32_t>(l.count),
                             places.origin(l.number, l.advance), l.advance};
            glyphs += l.count;
            if (glyphs > 0xFFFF'FFFFu) return fail(error::too_large);
        }
        if (run.glyphs.append(static_cast<std::uint32_t>(glyphs)) == nullptr && glyphs != 0)
            return fail(error::out_of_memory);
        return {};
    }

    static void copy(const line& from, const glyph_run& own, glyph_run& run) noexcept
    {
        const text_line& to = run.lines[from.number];
        const bool moved = !(to.origin == point{});
        for (std::size_t i = 0; i < from.count; ++i) {
            placed_glyph g = own.glyphs[from.first + i];
            if (moved) g.origin = g.origin + to.origin;
            run.glyphs[to.first_glyph + i] = g;
        }
    }

    buffer<line> lines_;
    buffer<block> blocks_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/glyph_store.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/layout/shaper.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The task that the concept `plan_workers` is checked with.
struct ignore_glyphs {
    template <class Font, class Observer>
    error operator()(std::size_t, Font&, glyph_builder&, glyph_store&, Observer&) const noexcept
    {
        return {};
    }
};

/// What carries out a plan: shapes the lines of a text and builds its glyphs. lone_worker, or glyph_workers.
///
///     w.layout(font, text, how, options, run)    layout(), with the same result; required of shapers only
///     w.units_per_em()    of the sources that glyphs come from
///     w.begin_plan()      removes the glyphs that were built for the previous plan. Null if they lie in the plan
///                         itself; else the address of a number that the next begin_plan() changes
///     w.each(n, task)     calls task(k, font, builder, store, observe) for each k < n, each with per-worker state.
///                         Returns the error of the lowest k that has one; above it not all may have been called
///     W::is_alone         one worker: k ascends, the observer is the mesher's, a cache needs no lock
template <class W, class Font>
concept plan_workers =
    requires(W& w, std::size_t n, const ignore_glyphs& task) {
        { W::is_alone } -> std::convertible_to<bool>;
        { w.units_per_em() } noexcept -> std::same_as<double>;
        { w.begin_plan() } noexcept -> std::same_as<const std::uint64_t*>;
        { w.each(n, task) } noexcept -> std::same_as<error>;
    } && (!shaper<Font> || requires(W& w, Font& font, text_view text, const shape_options& how,
                                    const layout_options& options, glyph_run& run) {
        { w.layout(font, text, how, options, run) } noexcept -> std::same_as<error>;
    });

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_report.hpp>
#include <typemesh/unicode/text_view.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

// The compiler names these types where a temporary is refused.
struct keep_the_font_in_a_variable {};
struct keep_the_mesher_in_a_variable;
struct keep_the_run_in_a_variable;

/// The overloads of text_mesher that exist only to refuse common mistakes, each in one sentence.
template <class Mesher, class Plan>
struct mesher_refusals {
    // with() turns an rvalue into another mesher; a cache is passed with the font's number.
    template <class Policy>
    Mesher&& with(Policy) & noexcept
    {
        static_assert(sizeof(Policy) == 0,
                      "typemesh: with() makes another mesher and empties this one: write "
                      "`text_mesher{font}.with(...)`, or `std::move(mesher).with(...)`.");
        return static_cast<Mesher&&>(*this);
    }
    template <class Lock>
    Mesher&& with(glyph_cache<Lock>&) && noexcept
    {
        static_assert(sizeof(Lock) == 0,
                      "typemesh: several fonts share a glyph_cache, so give with() a number of your own for "
                      "this font too: `with(cached_in{cache, 1})`.");
        return static_cast<Mesher&&>(*this);
    }

    // A plan refers to its run and to its mesher; temporaries would leave it dangling.
    keep_the_run_in_a_variable plan(glyph_run&& run, const text_options& options = {}) & = delete;
    keep_the_mesher_in_a_variable plan(text_view text, const text_options& options = {}) && = delete;
    keep_the_mesher_in_a_variable plan(const glyph_run& run, const text_options& options = {}) && = delete;
    template <class Workers>
    keep_the_run_in_a_variable plan(glyph_run&& run, const text_options& options, Workers& workers) & = delete;
    template <class Text, class Workers>
    keep_the_mesher_in_a_variable plan(const Text& text, const text_options& options, Workers& workers) && = delete;

    // UTF-32 and wchar_t; workers that are still a result.
    template <foreign_text Text, class... Workers>
    result<Plan> plan(const Text&, const text_options& = {}, Workers&...) & noexcept
    {
        return refuse_text<Text>();
    }
    template <class Text, class Workers>
    result<Plan> plan(const Text&, const text_options&, result<Workers>&) & noexcept
    {
        return refuse_result<Workers>();
    }

    // Arrays without their into(); workers that are still a result.
    template <class Text, array_without_sink Vertices, array_without_sink Indices, class... Workers>
    result<text_report> build(const Text&, Vertices&&, Indices&&, const text_options& = {}, Workers&...) noexcept
    {
        return refuse_arrays<Vertices>();
    }
    template <class Text, class Sink, class Workers>
    result<text_report> build(const Text&, Sink&&, const text_options&, result<Workers>&) noexcept
    {
        return refuse_result<Workers>();
    }
};

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI

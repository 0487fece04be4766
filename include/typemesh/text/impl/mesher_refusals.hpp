// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_report.hpp>
#include <typemesh/unicode/text_view.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <concepts>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

// The compiler names these types where a temporary is refused.
struct keep_the_font_in_a_variable {};
struct keep_the_mesher_in_a_variable;
struct keep_the_run_in_a_variable;

/// Any text or run. Every other parameter for them is a better match, so that `{}` remains an empty text_options.
struct any_text {
    template <class Text>
    any_text(const Text&) noexcept
    {
    }
};

/// A function for a run that is not noexcept.
template <class E>
concept throwing_edit = std::is_invocable_v<E&, glyph_run&> && !std::is_nothrow_invocable_v<E&, glyph_run&>;

/// Says where options belong that were given instead of text_options.
template <class Options>
constexpr error refuse_options() noexcept
{
    static_assert(!std::same_as<Options, layout_options>,
                  "typemesh: these are layout_options: write `{.layout = {...}}` around them.");
    static_assert(!std::same_as<Options, shape_options>,
                  "typemesh: these are shape_options: write `{.shape = {...}}` around them.");
    static_assert(!std::same_as<Options, extruded<>>,
                  "typemesh: these are options of the solid, which the mesher takes: "
                  "`text_mesher{font, extruded<>{.depth = 0.5f}}`, or later `mesher.solid().depth = 0.5f`.");
    return error::bad_option;
}

/// Says what is wrong with a function for a run.
template <class Edit>
constexpr error refuse_edit() noexcept
{
    static_assert(!throwing_edit<Edit>,
                  "typemesh: the function that edits a run must be noexcept: `[](glyph_run& run) noexcept { ... }`.");
    static_assert(throwing_edit<Edit>,
                  "typemesh: the function that edits a run follows the options: `plan(text, {}, edit)`.");
    return error::bad_option;
}

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

    // Functions for a run that may throw, or that stand in place of the options. The text is a `const text_view&`,
    // because clang hides a function template that has exactly the parameters of another one in text_mesher.
    template <throwing_edit Edit>
    result<Plan> plan(const text_view&, const text_options&, Edit&&) & noexcept
    {
        return refuse_edit<Edit>();
    }
    template <class Workers, throwing_edit Edit>
    result<Plan> plan(text_view, const text_options&, Workers&, Edit&&) & noexcept
    {
        return refuse_edit<Edit>();
    }
    template <class Edit>
        requires std::is_invocable_v<Edit&, glyph_run&>
    result<Plan> plan(text_view, Edit&&) & noexcept
    {
        return refuse_edit<Edit>();
    }

    // Options that belong one level deeper, or to the solid.
    template <std::same_as<layout_options> Options = layout_options>
    result<Plan> plan(any_text, const Options&) & noexcept
    {
        return refuse_options<Options>();
    }
    template <std::same_as<shape_options> Options = shape_options>
    result<Plan> plan(any_text, const Options&) & noexcept
    {
        return refuse_options<Options>();
    }
    template <std::same_as<extruded<>> Options = extruded<>>
    result<Plan> plan(any_text, const Options&) & noexcept
    {
        return refuse_options<Options>();
    }
    template <class Sink, std::same_as<layout_options> Options = layout_options>
    result<text_report> build(any_text, Sink&&, const Options&) noexcept
    {
        return refuse_options<Options>();
    }
    template <class Sink, std::same_as<shape_options> Options = shape_options>
    result<text_report> build(any_text, Sink&&, const Options&) noexcept
    {
        return refuse_options<Options>();
    }
    template <class Sink, std::same_as<extruded<>> Options = extruded<>>
    result<text_report> build(any_text, Sink&&, const Options&) noexcept
    {
        return refuse_options<Options>();
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

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/memory.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/discretise/discretiser.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/region_step.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/glyph/outline_step.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/triangulate/triangulator.hpp>

#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The concept of text_mesher::with() that a type models.
enum class policy_kind : std::uint8_t {
    none,
    discretiser,
    triangulator,
    step,
    outline_step,
    extruder,
    observer,
    cache,
    several
};

/// The kind of a policy.
template <class P>
[[nodiscard]] constexpr policy_kind kind_of() noexcept
{
    policy_kind kind = policy_kind::none;
    const auto models = [&kind](bool it, policy_kind one) noexcept {
        if (it) kind = kind == policy_kind::none ? one : policy_kind::several;
    };
    models(discretiser<P>, policy_kind::discretiser);
    models(triangulator<P>, policy_kind::triangulator);
    models(region_step<P> || std::is_same_v<P, no_step>, policy_kind::step);
    models(outline_step<P> || std::is_same_v<P, no_outline_step>, policy_kind::outline_step);
    models(extruder<P>, policy_kind::extruder);
    models(stage_observer<P>, policy_kind::observer);
    models(std::is_same_v<P, cached_in> || std::is_same_v<P, no_cache>, policy_kind::cache);
    return kind;
}

namespace detail {

/// The extruder among a mesher's options, or the default extruder.
template <class... Option>
struct find_solid {
    using type = extruded<>;
};
template <class First, class... Option>
struct find_solid<First, Option...>
    : std::conditional_t<kind_of<First>() == policy_kind::extruder, std::type_identity<First>, find_solid<Option...>> {
};
template <class... Option>
using solid_among = typename find_solid<Option...>::type;

/// An int if every solid among the options converts to the mesher's solid. Before clang 17, class template argument
/// deduction ignores the requires clauses of constructors, but not their template parameters.
template <class Solid, class... Option>
using takes = std::enable_if_t<
    ((kind_of<Option>() != policy_kind::extruder || std::is_convertible_v<Option, Solid>) && ... && true), int>;

/// Whether all options are of distinct kinds.
template <class... Option>
inline constexpr bool is_given_once = [] {
    int times[static_cast<int>(policy_kind::several) + 1] = {};
    (++times[static_cast<int>(kind_of<Option>())], ...);
    for (int kind = 1; kind < static_cast<int>(policy_kind::several); ++kind)
        if (times[kind] > 1) return false;
    return true;
}();

/// The memory source among a mesher's options, or the heap.
template <class... Option>
[[nodiscard]] memory memory_among(const Option&... options) noexcept
{
    memory found = heap();
    [[maybe_unused]] const auto look = [&found](const auto& option) noexcept {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(option)>, memory>) found = option;
    };
    (look(options), ...);
    return found;
}

/// Whether a glyph_cache can hold glyphs that are built with this option.
template <class Option>
inline constexpr bool cacheable_option =
    cacheable_policy<Option> || std::is_same_v<Option, memory> || kind_of<Option>() == policy_kind::cache ||
    kind_of<Option>() == policy_kind::observer;

// A type that models no concept but was meant to model one: it can be called like a policy, but guarantees less.
template <class P>
concept nearly_discretiser = requires(P& how, const quadratic& q, ignore_points put) { how(q, 1.0, put); } ||
                             requires(P& how, const cubic& c, ignore_points put) { how(c, 1.0, put); };
template <class P>
concept nearly_triangulator =
    requires(P& how, const region& r, workspace& space, triangle_list& out) { how(r, space, out); };
template <class P>
concept nearly_extruder = requires(P& how, const solid_of<P>& s, const placement& at, ignore_surface put) {
    how.template vertices<attribute::position>(part::front, s, at, put);
} || requires(P& how, const solid_of<P>& s, const first_vertices& first, ignore_surface put) {
    how.triangles(part::front, s, first, put);
};
template <class P>
concept nearly_observer = requires(P& observe) { observe(stage::idle); };

/// Says why with() does not accept a type. If the type is nearly a policy, the compiler adds which requirement fails.
template <class P>
constexpr void refuse_policy() noexcept
{
    constexpr bool several = kind_of<P>() == policy_kind::several;
    static_assert(
        !several,
        "typemesh: this type models several of discretiser, triangulator, region_step, outline_step, extruder "
        "and stage_observer, as a call operator for any argument does: name the types of its parameters.");
    if constexpr (several)
        return;
    else if constexpr (nearly_discretiser<P>)
        static_assert(discretiser<P>,
                      "typemesh: this type is nearly a discretiser; the compiler's notes name what is missing.");
    else if constexpr (nearly_triangulator<P>)
        static_assert(triangulator<P>,
                      "typemesh: this type is nearly a triangulator; the compiler's notes name what is missing.");
    else if constexpr (nearly_extruder<P>)
        static_assert(extruder<P>,
                      "typemesh: this type is nearly an extruder; the compiler's notes name what is missing.");
    else if constexpr (nearly_observer<P>)
        static_assert(stage_observer<P>,
                      "typemesh: this type is nearly a stage_observer; the compiler's notes name what is missing.");
    else
        static_assert(sizeof(P) == 0,
                      "typemesh: a mesher takes a discretiser, a triangulator, a region_step, an outline_step, an "
                      "extruder, a stage_observer or cached_in, but this type is none of them: static_assert its "
                      "concept to see what is missing. A deformation goes into bent<>, a warp into warped{}.");
}

}  // namespace detail

}  // namespace typemesh::inline TYPEMESH_ABI

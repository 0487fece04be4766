// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/extrude/solid.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The heights between which a mesh lies, in the unit of the extruder's depths (em, or output units by
/// text_options::depth_in). The front is at the greater height.
struct height_range {
    double low = 0.0;
    double high = 0.0;
};

/// Loops in the plane, like a region's loops: the area that a solid covers.
struct solid_outline {
    array_view<const grid_point> points;
    array_view<const std::uint32_t> starts;
};

/// Whether an extruder accepts points inside the region: see refinable_extruder (refined.hpp).
template <class E>
concept takes_inner_points = requires { requires E::writes_inner_points; };

/// A receiver that discards an extruder's output: the concept `extruder` is checked with it.
struct ignore_surface {
    template <attribute Wants>
    constexpr void operator()(const surface_point<Wants>&) const noexcept
    {
    }
    constexpr void operator()(std::uint32_t, std::uint32_t, std::uint32_t) const noexcept {}
};

/// A receiver that discards triangles: the concept `has_front_triangles` is checked with it.
struct ignore_places {
    constexpr void operator()(grid_point, grid_point, grid_point) const noexcept {}
};

/// The number of parts that an extruder writes: the extruder's part_count, or three.
template <class E>
inline constexpr std::size_t part_count_of = 3;
template <class E>
    requires requires { E::part_count; }
inline constexpr std::size_t part_count_of<E> = E::part_count;

/// The parts that an extruder writes.
template <class E>
inline constexpr array_view<const part> parts_of = {all_parts, part_count_of<E>};

/// The type of an extruder's plan data; no_plan_data if it has none.
template <class E>
using plan_data_of = typename detail::plan_data<E>::type;

/// The input of an extruder's writing: a solid, with its plan data if it has any.
template <class E>
using solid_of = solid_with<plan_data_of<E>>;
/// A solid of an extruder, together with its solid_plan.
template <class E>
using planned_solid_of = planned_solid<plan_data_of<E>>;

namespace detail {

template <class P>
concept planned_result = std::same_as<P, result<part_sizes>> || std::same_as<P, result<solid_plan>>;

template <class E>
concept plans_by_itself = requires(const E& e, const region& r) {
    { e.plan(r) } noexcept -> planned_result;
};
template <class E>
concept plans_with_data = requires(const E& e, const region& r, plan_data_of<E>& data) {
    { e.plan(r, data) } noexcept -> planned_result;
};
template <class E>
concept plans_with_caps = requires(const E& e, const region& r, plan_data_of<E>& data, no_caps& caps) {
    { e.plan(r, data, caps) } noexcept -> planned_result;
};

}  // namespace detail

/// Makes a solid of a filled region.
///
///     e.plan(region)                   counts exactly what the solid needs in each part: part_sizes; or solid_plan, if
///                                      the solid's extent in the plane is larger or smaller than the region's box
///     e.heights()                      the heights between which everything will lie
///     e.vertices<Wants>(part, s, at, put)      put(surface_point<Wants>) as often as plan() said for that part. The
///                                      extruder ignores glyph, cluster, part and style: write_vertices() (extrude.hpp)
///                                      adds them. `at` maps points and directions: placement.hpp
///     e.triangles(part, s, first, put)         put(a, b, c) as often as plan() said: vertex numbers, of any part. Each
///                                      is first[part] + its position in the order in which vertices() emitted it.
///                                      Counter-clockwise seen from outside in a right-handed frame; the extruder
///                                      ignores mirroring.
///
/// A simple extruder needs no more. The rest is optional:
///
///     E::plan_data                     the results of plan() that writing needs, see plan_arrays.hpp: the call is then
///                                      plan(region, data) with `data` empty, and `s` is a solid_with<plan_data>
///     e.plan(region, data, caps)       instead, to make caps of further regions while it plans: cap_maker.hpp
///     E::part_count                    parts 0 to part_count - 1 instead of front, back and side; at most eight
///     e.hard_edges(s)                  the number of contour points that are doubled because their walls meet at a
///                                      hard edge
///     e.cache_key()                    all options that affect plan(), if there are any: option_bits.hpp
///     e.heights(s)                     the heights of a planned solid, if its range may be smaller
///     e.seen_from_front(s, put)        put(a, b, c) with the grid points of every triangle that is neither upright nor
///                                      the mirror image of another triangle; needed if these are not the region's own
///                                      triangles
///     e.outline(s)                     the loops of the whole area that it covers in the plane, if it grows beyond the
///                                      region: glyphs whose outlines meet are merged
///     e.plans_in_place()               whether solids of one glyph differ from place to place. Each glyph of a text is
///                                      then planned at its own place, see solid_place_of() in cap_maker.hpp, and no
///                                      cache is used
///     e.refused_text(box)              the error for a whole text whose solids fill this box (textured in solid.hpp,
///                                      in em), or none
///     e.measures_in_em()               whether its heights only make sense in em: depth_unit::output is then refused
///     e.refit(s)                       adapts the options to a planned solid of the text, if all its solids must agree
///                                      in something; returns whether an option changed. It is called for each solid;
///                                      if one call returned true, all solids are planned again
///
/// If there are several plan() overloads, the one with most arguments is called. text_mesher calls it with an empty
/// region first, so that a text without letters refuses the same options. If plan() fails with error::refused_by_user
/// or another error that concerns only the glyph (glyph_builder::concerns_the_glyph_alone), the glyph is left out.
/// error::bad_option for options out of range, error::too_large and error::out_of_memory end the text. The other
/// functions cannot fail.
///
/// Builds with asserts count the output, discard output that was not planned, and report output outside of heights() or
/// the box.
template <class E>
concept extruder = (detail::plans_by_itself<E> || detail::plans_with_data<E> || detail::plans_with_caps<E>) &&
                   requires(const E& e, const solid_of<E>& s, const placement& at, part p, const first_vertices& first,
                            ignore_surface put) {
                       { e.heights() } noexcept -> std::same_as<height_range>;
                       { e.template vertices<attribute::position>(p, s, at, put) } noexcept;
                       { e.triangles(p, s, first, put) } noexcept;
                       requires part_count_of<E> >= 1 && part_count_of<E> <= max_parts;
                   };

/// An extruder that counts the contour points that are doubled because their walls meet at a hard edge.
template <class E>
concept has_hard_edges = extruder<E> && requires(const E& e, const solid_of<E>& s) {
    { e.hard_edges(s) } noexcept -> std::convertible_to<std::uint64_t>;
};

/// An extruder that reports the heights of each solid.
template <class E>
concept has_heights = extruder<E> && requires(const E& e, const solid_of<E>& s) {
    { e.heights(s) } noexcept -> std::same_as<height_range>;
};

/// An extruder whose caps are not the region's own.
template <class E>
concept has_front_triangles = extruder<E> && requires(const E& e, const solid_of<E>& s, ignore_places put) {
    { e.seen_from_front(s, put) } noexcept;
};

/// An extruder whose solids grow beyond their regions.
template <class E>
concept has_outline = extruder<E> && requires(const E& e, const solid_of<E>& s) {
    { e.outline(s) } noexcept -> std::same_as<solid_outline>;
};

/// An extruder that makes all solids of a text agree in something.
template <class E>
concept refitting_extruder = extruder<E> && requires(E& e, const solid_of<E>& s) {
    { e.refit(s) } noexcept -> std::same_as<bool>;
};

/// An extruder that may refuse a whole text for its size.
template <class E>
concept refuses_texts = extruder<E> && requires(const E& e, const box& text) {
    { e.refused_text(text) } noexcept -> std::same_as<error>;
};

/// An extruder whose plan() takes a cap_maker, to make caps of further regions.
template <class E>
concept capping_extruder = extruder<E> && detail::plans_with_caps<E>;

/// Calls the extruder's plan() overload. `data` is empty.
template <extruder E, cap_maker Caps>
[[nodiscard]] result<solid_plan> plan_solid(const E& how, const region& filled, plan_data_of<E>& data,
                                            Caps& caps) noexcept
{
    const auto made = [&]() noexcept {
        if constexpr (detail::plans_with_caps<E>)
            return how.plan(filled, data, caps);
        else if constexpr (detail::plans_with_data<E>)
            return how.plan(filled, data);
        else
            return how.plan(filled);
    }();
    if (!made) return made.error();
    const solid_plan plan{*made};
    for (std::size_t p = part_count_of<E>; p < max_parts; ++p) {
        TYPEMESH_ASSERT(plan.sizes.vertices.of[p] == 0 && plan.sizes.triangles.of[p] == 0,
                        "an extruder planned vertices or triangles of a part beyond its part_count");
    }
    return plan;
}

/// The heights between which a planned solid lies.
template <extruder E>
[[nodiscard]] height_range heights_of(const E& how, [[maybe_unused]] const solid_of<E>& s) noexcept
{
    if constexpr (has_heights<E>)
        return how.heights(s);
    else
        return how.heights();
}

/// The name of the option that error::bad_option reports if the heights do not fit into floats. It is "depth" if the
/// extruder has such a member.
template <extruder E>
[[nodiscard]] const char* heights_name_of([[maybe_unused]] const E& how) noexcept
{
    if constexpr (requires { how.heights_name(); })
        return how.heights_name();
    else if constexpr (requires { how.depth; })
        return "depth";
    else
        return "heights";
}

/// Whether the triangles of a solid's caps are not the region's own.
template <extruder E>
[[nodiscard]] bool has_own_caps([[maybe_unused]] const E& how) noexcept
{
    if constexpr (requires { how.has_own_caps(); })
        return how.has_own_caps();
    else
        return has_front_triangles<E>;
}

/// Whether an extruder's solids differ from place to place.
template <extruder E>
[[nodiscard]] bool plans_in_place([[maybe_unused]] const E& how) noexcept
{
    if constexpr (requires { how.plans_in_place(); })
        return how.plans_in_place();
    else
        return false;
}

/// Whether an extruder's heights only make sense in em.
template <extruder E>
[[nodiscard]] bool measures_in_em([[maybe_unused]] const E& how) noexcept
{
    if constexpr (requires { how.measures_in_em(); })
        return how.measures_in_em();
    else
        return false;
}

/// The triangles that seen_from_front() reports for a solid, or the region's triangles.
template <extruder E, class Put>
void each_seen_from_front(const E& how, const solid_of<E>& s, Put&& put) noexcept
{
    if constexpr (has_front_triangles<E>)
        how.seen_from_front(s, put);
    else
        for (const triangle t : s.triangles) put(s.points[t.a], s.points[t.b], s.points[t.c]);
}

/// The error with which an extruder refuses its options, or none: the result of its plan() for an empty region.
template <extruder E>
[[nodiscard]] error refused_options(const E& how) noexcept
{
    plan_data_of<E> data{heap()};
    no_caps nothing;
    return plan_solid(how, region{}, data, nothing).error();
}

}  // namespace typemesh::inline TYPEMESH_ABI

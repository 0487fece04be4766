// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/solid.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The heights between which a mesh lies, in em; the front is the higher.
struct height_range {
    double low = 0.0;
    double high = 0.0;
};

/// What an extruder is tried with.
struct ignore_surface {
    template <attribute Wants>
    constexpr void operator()(const surface_point<Wants>&) const noexcept
    {
    }
    constexpr void operator()(std::uint32_t, std::uint32_t, std::uint32_t) const noexcept {}
};

/// How many parts an extruder writes: its part_count, or front, back and side.
template <class E>
inline constexpr std::size_t part_count_of = 3;
template <class E>
    requires requires { E::part_count; }
inline constexpr std::size_t part_count_of<E> = E::part_count;

/// These parts.
template <class E>
inline constexpr std::span<const part> parts_of = std::span{all_parts}.first(part_count_of<E>);

/// Puts a filled region up into space.
///
///     e.plan(region, sides)            counts exactly what the shape will need of each part; appends to `sides` what
///                                      writing will want to know (usually one side_point a contour point, or nothing)
///     e.heights()                      between which heights everything will lie
///     e.vertices<Wants>(part, s, at, emit)     emit(surface_point<Wants>) as often as plan() said for that part; its
///                                      glyph, cluster and part are not the extruder's business: write_vertices()
///                                      (extrude.hpp) fills them in
///     e.triangles(part, s, first, emit)        emit(a, b, c) as often as plan() said: vertex numbers, of any part,
///                                      each being first[part] + the place in which vertices() emitted it.
///                                      Counter-clockwise seen from outside in a right-handed frame; mirroring is not
///                                      its business.
///
/// plan() is asked about an empty region first, so that a text without letters refuses the same options.
/// What is emitted is counted in builds with asserts, and what was not planned is not passed on there.
/// It fails with error::bad_option for options out of range, error::out_of_memory, or an error of its own, `sides`
/// then being as it was. The rest cannot fail.
template <class E>
concept extruder = requires(const E& e, const region& r, buffer<side_point>& sides, const solid& s, const placement& at,
                            part p, const first_vertices& first, ignore_surface emit) {
    { e.plan(r, sides) } noexcept -> std::same_as<result<part_sizes>>;
    { e.heights() } noexcept -> std::same_as<height_range>;
    { e.template vertices<attribute::position>(p, s, at, emit) } noexcept;
    { e.triangles(p, s, first, emit) } noexcept;
};

}  // namespace typemesh::inline TYPEMESH_ABI

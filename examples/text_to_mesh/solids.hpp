// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"

#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/tubed.hpp>
#include <typemesh/markup/markup_styles.hpp>
#include <typemesh/typemesh.hpp>

namespace text_to_mesh {

// What a program that lets its users choose makes its solid of: this one and examples/web.

/// Without bevels; flat where there is no depth.
using plain_solid =
    typemesh::one_of<typemesh::extruded<typemesh::curve_normals>, typemesh::extruded<typemesh::creased_normals>,
                     typemesh::extruded<typemesh::averaged_normals>, typemesh::extruded<typemesh::shared_normals>,
                     typemesh::extruded<typemesh::cap_normals>, typemesh::flat>;
using bent_solid = typemesh::bent<chosen_bend, plain_solid>;
using bent_bevels = typemesh::bent<chosen_bend, typemesh::bevelled>;

[[nodiscard]] plain_solid plain_of(const options& o);
[[nodiscard]] typemesh::bevelled bevelled_of(const options& o);
[[nodiscard]] typemesh::inflated inflated_of(const options& o);
[[nodiscard]] typemesh::tubed tubed_of(const options& o);

/// By how much [b] moves the edges of letters outwards, in em. They stand apart by twice as much.
inline constexpr double bold_growth = 0.015;
/// The options of letters whose tags ask for a solid of their own.
[[nodiscard]] options options_of(const options& o, const typemesh::markup_solid& tags);

/// `solid`, bent as the options have it.
template <class Solid>
[[nodiscard]] typemesh::bent<chosen_bend, Solid> bent_of(const options& o, const Solid& solid)
{
    return {.solid = solid, .how = o.bend.how, .tolerance = o.tolerance};
}

/// A ring along the edges of `letter`. Without the letter in it, that is an extruder whose parts are switched off.
template <class Letter>
[[nodiscard]] typemesh::outlined<Letter, plain_solid> hollow_of(const options& o, const Letter& letter)
{
    typemesh::outlined<Letter, plain_solid> hollow{
        .width = o.outline.width, .place = o.outline.place, .ring = letter, .letter = plain_of(o)};
    if (!o.outline.letter) hollow.letter = typemesh::extruded<>{.front = false, .back = false, .side = false};
    return hollow;
}

}  // namespace text_to_mesh

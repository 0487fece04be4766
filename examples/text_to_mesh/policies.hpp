// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "progress.hpp"
#include "solids.hpp"
#include "stages.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/extrude/tubed.hpp>
#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/typemesh.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace text_to_mesh {

// Solids are compile-time types; a program that reads one from a command line names them all, and so has one type of mesher.
// The other policies are exchanged in it.

using letter_solid = typemesh::one_of<plain_solid, typemesh::bevelled, typemesh::carved>;

/// Letters, or hollow ones.
using hollow_solid = typemesh::outlined<letter_solid, plain_solid>;
using refined_solid = typemesh::refined<plain_solid>;
using squared_solid = typemesh::refined<plain_solid, typemesh::quadtree_refined>;
using right_solid = typemesh::refined<plain_solid, typemesh::non_obtuse>;
using chosen_solid = typemesh::one_of<letter_solid, hollow_solid, refined_solid, squared_solid, right_solid, bent_solid,
                                      bent_bevels, typemesh::inflated, typemesh::tubed>;

using chosen_mesher = typemesh::text_mesher<chosen_solid>;
using chosen_plan = typemesh::text_plan<chosen_solid>;

/// Gives a mesher what the options choose: solid, step before it, discretiser, triangulator.
void choose_policies(const options& o, double units_per_em, chosen_mesher& mesher);

/// Gives a mesher of a text with --lod the step that makes one of its levels, 0 to o.lod.size().
void use_level(const options& o, std::size_t level, chosen_mesher& mesher);

/// Adds up how long each stage took, and counts the letters begun.
struct stage_clock {
    using clock = std::chrono::steady_clock;

    progress* tell = nullptr;
    std::size_t letters = 0;
    std::int64_t nanoseconds[6] = {};
    typemesh::stage now = typemesh::stage::idle;
    clock::time_point since{};

    void operator()(typemesh::stage next) noexcept
    {
        const auto t = clock::now();
        if (now != typemesh::stage::idle)
            nanoseconds[static_cast<int>(now)] +=
                std::chrono::duration_cast<std::chrono::nanoseconds>(t - since).count();
        now = next;
        since = t;
        if (next == typemesh::stage::outline && tell != nullptr) tell->count(++letters);
    }
};

}  // namespace text_to_mesh

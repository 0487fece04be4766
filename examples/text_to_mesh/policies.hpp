// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "progress.hpp"

#include <typemesh/core/option_hash.hpp>
#include <typemesh/extrude/emboldened.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/polyline_profile.hpp>

#include <chrono>
#include <variant>

namespace text_to_mesh {

// Policies are compile-time types; a program that reads them from a command line makes policies which choose. Each
// stage chooses for itself, so the stages add up: 3 + 2 + 6 instantiations instead of 3 x 2 x 6. But what a policy says
// of itself at compile time must hold for all it may choose; where it cannot, a variant of policies is visited.

/// The key of a choice and its options, for caches.
template <class... Policies>
[[nodiscard]] typemesh::option_bits key_of_choice(const std::variant<Policies...>& choice) noexcept
{
    typemesh::option_hash all;
    all.add(choice.index());
    std::visit([&](const auto& p) { all.add_key_of(p); }, choice);
    return {all.first, all.second};
}

/// One of the discretisers that keep no tolerance, chosen at run time.
struct unbounded_discretiser {
    static constexpr bool keeps_no_tolerance = true;
    std::variant<typemesh::two_lines, typemesh::thesis_quality> choice;

    [[nodiscard]] typemesh::option_bits cache_key() const noexcept { return key_of_choice(choice); }

    template <class Curve, class Put>
    void operator()(const Curve& curve, double tolerance, Put&& put) const noexcept
    {
        std::visit([&](const auto& d) { d(curve, tolerance, put); }, choice);
    }
};

/// For std::visit: a mesher for what keeps a tolerance, and one for what keeps none.
using chosen_discretiser = std::variant<typemesh::certified, unbounded_discretiser>;

/// One of the triangulators, chosen at run time. Both prove, and so does the choice; the diagonals of both are final.
struct chosen_triangulator {
    static constexpr bool has_final_diagonals = true;
    std::variant<typemesh::monotone, typemesh::constrained_delaunay> choice;

    [[nodiscard]] typemesh::option_bits cache_key() const noexcept { return key_of_choice(choice); }

    [[nodiscard]] typemesh::error operator()(const typemesh::region& r, typemesh::workspace& space,
                                             typemesh::triangle_list& out) const noexcept
    {
        return std::visit([&](const auto& t) { return t(r, space, out); }, choice);
    }
    [[nodiscard]] typemesh::result<typemesh::region> prove(const typemesh::contours& loops, typemesh::workspace& space,
                                                           typemesh::triangle_list& out) const noexcept
    {
        return std::visit([&](const auto& t) { return t.prove(loops, space, out); }, choice);
    }
};

/// One of the extruders without bevels, chosen at run time.
struct unbevelled_extruder {
    std::variant<typemesh::extruded<typemesh::curve_normals>, typemesh::extruded<typemesh::creased_normals>,
                 typemesh::extruded<typemesh::averaged_normals>, typemesh::extruded<typemesh::shared_normals>,
                 typemesh::extruded<typemesh::cap_normals>, typemesh::flat>
        choice;

    using plan_data = typemesh::extruded<>::plan_data;  // that of all but flat, which has none

    [[nodiscard]] typemesh::option_bits cache_key() const noexcept { return key_of_choice(choice); }

    [[nodiscard]] typemesh::result<typemesh::part_sizes> plan(const typemesh::region& r, plan_data& data) const noexcept
    {
        const auto plan = [&](const auto& e) {
            if constexpr (requires { e.plan(r, data); })
                return e.plan(r, data);
            else
                return e.plan(r);
        };
        return std::visit(plan, choice);
    }
    [[nodiscard]] typemesh::height_range heights() const noexcept
    {
        return std::visit([](const auto& e) { return e.heights(); }, choice);
    }
    template <typemesh::attribute Wants, class Put>
    void vertices(typemesh::part p, const typemesh::solid_with<plan_data>& s, const typemesh::placement& at,
                  Put&& put) const noexcept
    {
        std::visit([&](const auto& e) { e.template vertices<Wants>(p, s, at, put); }, choice);
    }
    template <class Put>
    void triangles(typemesh::part p, const typemesh::solid_with<plan_data>& s, const typemesh::first_vertices& first,
                   Put&& put) const noexcept
    {
        std::visit([&](const auto& e) { e.triangles(p, s, first, put); }, choice);
    }
    [[nodiscard]] std::uint64_t hard_edges(const typemesh::solid_with<plan_data>& s) const noexcept
    {
        const auto count = [&](const auto& e) -> std::uint64_t {
            if constexpr (requires { e.hard_edges(s); })
                return e.hard_edges(s);
            else
                return 0;
        };
        return std::visit(count, choice);
    }
};

/// One of the profiles of a bevel, chosen at run time.
struct chosen_profile {
    std::variant<typemesh::chamfer_profile, typemesh::round_profile, typemesh::concave_profile,
                 typemesh::stepped_profile, typemesh::engraved_profile, typemesh::polyline_profile>
        choice;

    [[nodiscard]] typemesh::option_bits cache_key() const noexcept { return key_of_choice(choice); }

    void operator()(const typemesh::profile_scale& scale, typemesh::profile_points& out) const noexcept
    {
        std::visit([&](const auto& p) { p(scale, out); }, choice);
    }
};

using bevelled_extruder = typemesh::bevelled<chosen_profile>;

/// Bold letters, hollow ones, or both: of an outline without the letter, that is an extruder whose parts are switched
/// off, and `emboldened` by nothing changes nothing.
template <class Solid>
using bold_extruder = typemesh::emboldened<Solid>;
template <class Ring>
using hollow_extruder = typemesh::emboldened<typemesh::outlined<Ring, unbevelled_extruder>>;

/// For std::visit: a mesher for each number of parts and each way to plan them.
using chosen_extruder = std::variant<unbevelled_extruder, bevelled_extruder, bold_extruder<unbevelled_extruder>,
                                     bold_extruder<bevelled_extruder>, hollow_extruder<unbevelled_extruder>,
                                     hollow_extruder<bevelled_extruder>>;

/// What the options choose.
[[nodiscard]] chosen_discretiser discretiser_of(const options& o, double units_per_em);
[[nodiscard]] chosen_triangulator triangulator_of(const options& o);
[[nodiscard]] chosen_extruder extruder_of(const options& o);

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

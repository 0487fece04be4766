// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/policy_key.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/plan_scratch.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/region_caps.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to an extruder of any type, which must outlive it, for all operations per glyph. Writing works per vertex and
/// needs the type: see extrude.hpp.
class solid_ref {
public:
    /// One table for each type of extruder.
    struct calls {
        result<solid_plan> (*plan)(const void* how, const region& filled, plan_scratch& data,
                                   region_caps& caps) noexcept;
        error (*refused_options)(const void* how) noexcept;
        policy_key (*key)(const void* how) noexcept;
        height_range (*heights)(const void* how) noexcept;
        height_range (*heights_of)(const void* how, const built_glyph& built) noexcept;   // null: the heights of all
                                                                                          // solids
        solid_outline (*outline_of)(const void* how, const built_glyph& built) noexcept;  // null: the region's own
        const char* (*heights_name)(const void* how) noexcept;
        bool (*plans_in_place)(const void* how) noexcept;
    };
    template <extruder E>
    struct table {
        static const calls of;
    };

    template <extruder E>
    solid_ref(const E& how) noexcept : how_{&how}, does_{&table<E>::of}
    {
    }

    /// plan_solid() for a region that has been built with these caps; its plan data is then in `data`.
    ///
    /// Fails  error::out_of_memory, and as the extruder's plan() does
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_scratch& data, region_caps caps) const noexcept
    {
        return does_->plan(how_, filled, data, caps);
    }
    [[nodiscard]] error refused_options() const noexcept { return does_->refused_options(how_); }
    [[nodiscard]] policy_key key() const noexcept { return does_->key(how_); }
    [[nodiscard]] height_range heights() const noexcept { return does_->heights(how_); }

    /// The heights of a glyph that it has planned.
    [[nodiscard]] height_range heights_of(const built_glyph& built) const noexcept
    {
        return does_->heights_of == nullptr ? heights() : does_->heights_of(how_, built);
    }
    [[nodiscard]] bool has_heights_of_each() const noexcept { return does_->heights_of != nullptr; }

    /// The loops that decide which glyphs are merged with a glyph that it has planned, which has points. They bound the
    /// whole area that it covers in the plane, or are the drawn loops if these are larger.
    [[nodiscard]] solid_outline outline_of(const built_glyph& built) const noexcept
    {
        const solid_outline drawn = built.merged_as_drawn();
        const solid_outline own{built.form().points, built.form().starts};
        const solid_outline grown = does_->outline_of == nullptr ? own : does_->outline_of(how_, built);
        return drawn.points.empty() || covers(box_of(grown), box_of(drawn)) ? grown : drawn;
    }

    /// Whether its solids differ from place to place.
    [[nodiscard]] bool plans_in_place() const noexcept { return does_->plans_in_place(how_); }

    /// The name of the option that causes heights that cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept { return does_->heights_name(how_); }

private:
    static bool covers(const box& a, const box& b) noexcept
    {
        return a.low.x <= b.low.x && a.low.y <= b.low.y && a.high.x >= b.high.x && a.high.y >= b.high.y;
    }
    static box box_of(const solid_outline& loops) noexcept
    {
        box around;
        for (const grid_point p : loops.points) around.add(placement::exact(p));
        return around;
    }

    const void* how_;
    const calls* does_;
};

template <extruder E>
constinit const solid_ref::calls solid_ref::table<E>::of = [] {
    calls made{[](const void* how, const region& filled, plan_scratch& data,
                  region_caps& caps) noexcept -> result<solid_plan> {
                   auto* fresh = data.fresh<plan_data_of<E>>();
                   if (fresh == nullptr) return error::out_of_memory;
                   return plan_solid(*static_cast<const E*>(how), filled, *fresh, caps);
               },
               [](const void* how) noexcept { return typemesh::refused_options(*static_cast<const E*>(how)); },
               [](const void* how) noexcept { return key_of(*static_cast<const E*>(how)); },
               [](const void* how) noexcept { return static_cast<const E*>(how)->heights(); },
               nullptr,
               nullptr,
               [](const void* how) noexcept { return heights_name_of(*static_cast<const E*>(how)); },
               [](const void* how) noexcept { return typemesh::plans_in_place(*static_cast<const E*>(how)); }};
    if constexpr (has_heights<E>)
        made.heights_of = [](const void* how, const built_glyph& built) noexcept {
            return static_cast<const E*>(how)->heights(built.planned<E>().form);
        };
    if constexpr (has_outline<E>)
        made.outline_of = [](const void* how, const built_glyph& built) noexcept {
            return static_cast<const E*>(how)->outline(built.planned<E>().form);
        };
    return made;
}();

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include "text_to_mesh/policies.hpp"

#include <typemesh/extrude/emboldened.hpp>
#include <typemesh/extrude/outlined.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <variant>

namespace typemesh_web {

/// The plan data of any_solid: that of bevels, or that of plain walls. The other is empty.
struct any_solid_data {
    using wall_data = text_to_mesh::unbevelled_extruder::plan_data;
    /// Bevels are looked up when they are asked for: plain solids are read for each letter of a text, and there are many.
    struct view {
        const typemesh::bevel_data* live = nullptr;  // or stored
        const std::byte* stored = nullptr;
        wall_data::view walls = {};

        [[nodiscard]] typemesh::bevel_data::view bevels() const noexcept
        {
            return live != nullptr ? live->read() : typemesh::bevel_data::read_from(stored);
        }
    };

    typemesh::bevel_data bevels;
    wall_data walls;

    explicit any_solid_data(typemesh::memory source = typemesh::heap()) noexcept : bevels{source}, walls{source} {}
    void clear() noexcept { bevels.clear(), walls.clear(); }
    [[nodiscard]] view read() const noexcept { return {&bevels, nullptr, walls.read()}; }

    // --- as bytes: see plan_arrays

    [[nodiscard]] std::size_t bytes() const noexcept { return 8 + bevels.bytes() + walls.bytes(); }

    ///     block   [ where the bevels begin ][ walls ][ bevels ]
    void copy_to(std::byte* block) const noexcept
    {
        const std::uint64_t of_bevels = 8 + walls.bytes();
        std::memcpy(block, &of_bevels, 8);
        walls.copy_to(block + 8);
        bevels.copy_to(block + of_bevels);
    }
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        std::uint64_t of_bevels = 0;
        std::memcpy(&of_bevels, block, 8);
        return {nullptr, block + of_bevels, wall_data::read_from(block + 8)};
    }
};

/// Solids with bevels or without, chosen at run time: one extruder, and so one mesher, where text_to_mesh has two. The
/// module is a fifth smaller for it.
struct any_solid {
    text_to_mesh::unbevelled_extruder plain;
    std::optional<text_to_mesh::bevelled_extruder> bevels;

    static constexpr std::size_t part_count = 5;
    using plan_data = any_solid_data;
    using solid = typemesh::solid_with<plan_data>;

    [[nodiscard]] typemesh::option_bits cache_key() const noexcept
    {
        typemesh::option_hash all;
        if (bevels) all.add_key_of(*bevels);
        if (!bevels) all.add_key_of(plain);
        return {all.first, all.second, bevels.has_value()};
    }

    template <typemesh::cap_maker Caps>
    [[nodiscard]] typemesh::result<typemesh::solid_plan> plan(const typemesh::region& r, plan_data& data,
                                                              Caps& caps) const noexcept
    {
        if (bevels) return bevels->plan(r, data.bevels, caps);
        const auto sizes = plain.plan(r, data.walls);
        if (!sizes) return sizes.error();
        return typemesh::solid_plan{.sizes = *sizes};
    }

    [[nodiscard]] typemesh::height_range heights() const noexcept
    {
        return bevels ? bevels->heights() : plain.heights();
    }
    [[nodiscard]] typemesh::height_range heights(const solid& s) const noexcept
    {
        return bevels ? bevels->heights(of_bevels(s)) : plain.heights();
    }
    template <class Put>
    void seen_from_front(const solid& s, Put&& put) const noexcept
    {
        if (bevels) return bevels->seen_from_front(of_bevels(s), put);
        for (const typemesh::triangle t : s.triangles) put(s.points[t.a], s.points[t.b], s.points[t.c]);
    }
    [[nodiscard]] typemesh::solid_outline outline(const solid& s) const noexcept
    {
        if (bevels) return bevels->outline(of_bevels(s));
        return {s.points, s.starts};
    }
    [[nodiscard]] bool refit(const solid& s) noexcept { return bevels && bevels->refit(of_bevels(s)); }

    template <typemesh::attribute Wants, class Put>
    void vertices(typemesh::part p, const solid& s, const typemesh::placement& at, Put&& put) const noexcept
    {
        if (bevels)
            bevels->vertices<Wants>(p, of_bevels(s), at, put);
        else if (p <= typemesh::part::side)
            plain.vertices<Wants>(p, of_walls(s), at, put);
    }
    template <class Put>
    void triangles(typemesh::part p, const solid& s, const typemesh::first_vertices& first, Put&& put) const noexcept
    {
        if (bevels)
            bevels->triangles(p, of_bevels(s), first, put);
        else if (p <= typemesh::part::side)
            plain.triangles(p, of_walls(s), first, put);
    }

private:
    static typemesh::solid_with<typemesh::bevel_data> of_bevels(const solid& s) noexcept
    {
        return {s, s.data.bevels()};
    }
    static typemesh::solid_with<any_solid_data::wall_data> of_walls(const solid& s) noexcept
    {
        return {s, s.data.walls};
    }
};
static_assert(typemesh::refitting_extruder<any_solid> && typemesh::tells_outline<any_solid>);

/// For std::visit: letters, bold ones, hollow ones.
using bold_solid = typemesh::emboldened<any_solid>;
using hollow_solid = typemesh::emboldened<typemesh::outlined<any_solid, text_to_mesh::unbevelled_extruder>>;
using web_extruder = std::variant<any_solid, bold_solid, hollow_solid>;

/// What the options choose, as text_to_mesh::extruder_of() does.
[[nodiscard]] inline web_extruder extruder_of(const text_to_mesh::options& o)
{
    text_to_mesh::options unmoved = o;
    unmoved.outline.width = unmoved.embolden = 0.0f;
    any_solid solid;
    if (o.bevel.width > 0.0f)
        solid.bevels = std::get<text_to_mesh::bevelled_extruder>(text_to_mesh::extruder_of(unmoved));
    unmoved.bevel.width = 0.0f;
    solid.plain = std::get<text_to_mesh::unbevelled_extruder>(text_to_mesh::extruder_of(unmoved));
    if (o.outline.width > 0.0f) {
        typemesh::outlined<any_solid, text_to_mesh::unbevelled_extruder> letters{
            .width = o.outline.width, .place = o.outline.place, .ring = solid, .letter = solid.plain};
        if (!o.outline.letter) letters.letter = {typemesh::extruded<>{.front = false, .back = false, .side = false}};
        return hollow_solid{.by = o.embolden, .solid = letters};
    }
    if (o.embolden != 0.0f) return bold_solid{.by = o.embolden, .solid = solid};
    return solid;
}

}  // namespace typemesh_web

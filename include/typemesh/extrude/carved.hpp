// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/profile_levels.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/offset/find_ridges.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The surface that carved makes.
enum class carving : std::uint8_t {
    relief,  ///< letters that rise from z = 0 and stand on a flat back: a closed solid
    groove,  ///< the surface that the tool leaves in a plate whose top is z = 0, seen from above: not closed
    cutter,  ///< the material that the tool removes there: the groove with a lid at z = 0, a closed solid
};

/// The depths of one carved solid.
struct carved_depth {
    float width = 0.0f;   ///< the distance from the outline at which the slopes end, in em
    float depth = 0.0f;   ///< the depth there, in the unit of the extruder's heights
    float reach = 0.0f;   ///< the distance again, in cells
    float height = 0.0f;  ///< the height there: the depth, or for a groove its negative

    /// The height of a ridge's point.
    [[nodiscard]] double height_at(float distance) const noexcept
    {
        return distance < reach ? as_double(height) * (as_double(distance) / as_double(reach)) : as_double(height);
    }
};

/// The plan data of carved: the solid of bevelled, its depths, and the ridges.
struct carved_data {
    using own_arrays = plan_arrays<carved_depth, ridge_point>;  ///< one carved_depth, and the ridges
    /// The parts as their readers see them.
    struct view {
        typename own_arrays::view own;
        bevel_data::view bevel;
    };

    own_arrays own;    ///< its depths and ridges
    bevel_data bevel;  ///< the solid of bevelled

    explicit carved_data(memory source = heap()) noexcept : own{source}, bevel{source} {}
    void clear() noexcept
    {
        own.clear();
        bevel.clear();
    }
    [[nodiscard]] view read() const noexcept { return {own.read(), bevel.read()}; }

    // --- as bytes: see plan_arrays

    [[nodiscard]] std::size_t bytes() const noexcept { return own.bytes() + bevel.bytes(); }

    ///     block   [ own ][ bevel ]
    void copy_to(std::byte* block) const noexcept
    {
        own.copy_to(block);
        bevel.copy_to(block + own.bytes());
    }
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        const typename own_arrays::view own = own_arrays::read_from(block);
        return {own, bevel_data::read_from(block + own.bytes())};
    }
};

/// An extruder of letters carved by a V-bit, a conical tool: the front of a bevelled solid, with the slope of the tool.
///
///     \       /      relief              .---------.  z = max_depth       .
///      \     /                          /           \                    / \      without a floor, the slopes
///       \   /                          /             \                  /   \     meet in a ridge
///        \ /                          '---------------'  z = 0         '-----'
///     tool_angle     groove, cutter    .             .  z = 0         .       .
///                                       \           /                  \     /
///                                        '---------'   z = -max_depth    '.'
///
/// At a distance d from the outline, the depth is d / tan(tool_angle / 2), down to max_depth. Reflex corners are round
/// to the text's tolerance, as the tool's own cone leaves them, so the slopes' ridges are the path of the tool.
///
///     carved{.tool_angle = 60.0f}                                            a relief without a floor
///     carved{.max_depth = 0.05f, .as = carving::groove}                      a groove with a floor
///     carved{.as = carving::groove, .ridges = true}                          and its ridges: text/each_ridge.hpp
///
/// The slopes are part::front_bevel, the floor is part::front, and the flat back of a relief is part::back. A cutter is
/// seen from behind: its slopes are part::back_bevel, its floor is part::back, and its lid is part::front.
///
/// How exact the depth is: the distance to the outline, measured where the depth says, differs by at most the text's
/// tolerance plus 4 cells. At a corner of 180 degrees, which gets 31 joins at most, it is up to 1/800 of the distance
/// instead, if that is more than the tolerance. If a glyph's slopes are not proven simple at their full width, they end
/// sooner, with the same slope, and the plan reports this as solid_plan::narrowed. With text_options::corners, a solid
/// may have low walls (see bevelled), which raise its slopes by up to 4 cells, or by 2^-20 of the planned depth if that
/// is more. The planned depth is max_depth; without a floor, it is the depth of slopes half as wide as the letter's
/// box.
///
/// The depth is in em, so text_options::depth_in must be depth_unit::em (the default): otherwise the slope is another.
///
/// Fails  error::bad_option: "tool_angle", "max_depth" or "crease_degrees" is out of range
///        as bevelled does
/// Cost   O(n log n), as a bevel as wide as half a stroke: 4 times the time of a chamfer of 2 % of the em; with
///        ridges, a fifth more
struct carved {
    float tool_angle = 90.0f;  ///< the angle between the two sides of the tool's section, in degrees, 1 to 179
    float max_depth = 0.0f;    ///< the depth of the floor, in em; 0: no floor, the slopes always meet
    carving as = carving::relief;
    bool ridges = false;           ///< whether the plan keeps the ridges for each_ridge()
    float crease_degrees = 15.0f;  ///< corners of the outline that turn by more are hard edges, and have ridges of
                                   ///< their own; 0 to 180: see curve_normals
    texture_mapping texture = texture_mapping::em;

    static constexpr std::size_t part_count = 5;
    using plan_data = carved_data;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_hash all;
        all.add(option_bits{tool_angle, max_depth, crease_degrees});
        all.add(std::uint64_t{ridges} << 16 | static_cast<std::uint64_t>(as) << 8 |
                static_cast<std::uint64_t>(texture));
        return {all.first, all.second};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (!is_finite(as_double(tool_angle)) || tool_angle < 1.0f || tool_angle > 179.0f)
            return error::bad("tool_angle");
        if (!is_finite(as_double(max_depth)) || max_depth < 0.0f) return error::bad("max_depth");
        if (!is_crease_angle(crease_degrees)) return error::bad("crease_degrees");
        if (filled.points().empty()) return solid_plan{};
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        carved_depth wanted = depth_of(filled, em);
        auto made = plan_slopes(filled, wanted, em, data.bevel, caps);
        const bool narrowed = made && made->narrowed;
        // Low walls are shares of the depth, so narrowed slopes are planned again, for the depth that they reach.
        while (made && shorten(wanted, data.bevel) && made->narrowed && filled.corners() != touching::keep) {
            data.bevel.clear();
            made = plan_slopes(filled, wanted, em, data.bevel, caps);
        }
        if (!made) return made;
        made->narrowed = narrowed;
        wanted.reach = static_cast<float>(data.bevel.swept.levels.back());
        wanted.height = as == carving::relief ? wanted.depth : -wanted.depth;
        if (!data.own.of<carved_depth>().push_back(wanted)) return error::out_of_memory;
        if (as == carving::groove) made->sizes = turned(made->sizes);
        if (!ridges) return made;
        if (error e = keep_ridges(filled, data, caps.space())) return e;
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept
    {
        return range_to(max_depth > 0.0f ? as_double(max_depth) : widest / tangent());
    }
    /// The slope is the tool's only in em.
    [[nodiscard]] bool measures_in_em() const noexcept { return true; }
    /// The name of the option that is at fault if the heights cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept { return "max_depth"; }

    /// The heights of a planned solid: its slopes may meet sooner.
    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
    {
        return s.points.empty() ? heights() : slopes_of(s).heights(inner(s));
    }

    /// The triangles of the slopes and of each cap.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        bevelled slopes = slopes_of(s);
        if (as == carving::groove) slopes.sides = bevel_sides::both;  // without a side that is the region's own
        slopes.seen_from_front(inner(s), put);
    }

    /// The count of hard points, as in extruded.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return s.points.empty() ? 0 : slopes_of(s).hard_edges(inner(s));
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        const bevelled slopes = slopes_of(s);
        const solid_with<bevel_data> form = inner(s);
        if (as == carving::groove)
            return slopes.template vertices<Wants>(behind(p), form, at, [&put](surface_point<Wants> v) noexcept {
                turn_round(v);
                put(v);
            });
        slopes.template vertices<Wants>(p, form, at, put);
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (s.points.empty()) return;
        const bevelled slopes = slopes_of(s);
        if (as != carving::groove) return slopes.triangles(p, inner(s), first, put);
        first_vertices of_inner = first;
        of_inner[behind(p)] = first[p];
        slopes.triangles(behind(p), inner(s), of_inner,
                         [&put](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { put(a, c, b); });
    }

private:
    static constexpr double widest = 0x1p18;  ///< em; no stroke is wider

    /// tan(tool_angle / 2), to 24 bits after the point: the standard libraries' functions differ in the last bits.
    [[nodiscard]] double tangent() const noexcept
    {
        const double angle = as_double(tool_angle) * (0.5 * 3.14159265358979323846 / 180.0);
        return std::floor(std::tan(angle) * 0x1p24 + 0.5) * 0x1p-24;
    }

    /// The depth that the tool reaches on a region. No circle in the region is wider than half of its box, so slopes
    /// without a floor end a little beyond.
    [[nodiscard]] carved_depth depth_of(const region& filled, double em) const noexcept
    {
        constexpr double beyond = 16.0;  // cells
        box around;
        for (const grid_point p : filled.points()) around.add(placement::exact(p));
        const double size = around.width() < around.height() ? around.width() : around.height();
        double most = (0.5 * size + beyond) / em;
        if (most > widest) most = widest;
        const double wanted = as_double(max_depth) * tangent();
        if (max_depth > 0.0f && wanted < most) return {static_cast<float>(wanted), max_depth, 0.0f, 0.0f};
        const auto width = static_cast<float>(most);
        return {width, static_cast<float>(as_double(width) / tangent()), 0.0f, 0.0f};
    }

    /// A profile shallower than profile_levels::finest would not rise. The plan stores shares of the depth, so that a
    /// deeper profile has the same plan.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan_slopes(const region& filled, const carved_depth& to, double em,
                                                 bevel_data& data, Caps& caps) const noexcept
    {
        bevelled slopes = slopes_of(to);
        constexpr double least = 2.0 * profile_levels::finest;
        if (as_double(to.depth) * em < least) slopes.depth = slopes.bevel_depth = static_cast<float>(least / em);
        return slopes.plan(filled, data, caps);
    }

    /// Reduces the wanted depth to what planned slopes reach. Returns whether they end sooner.
    [[nodiscard]] bool shorten(carved_depth& wanted, bevel_data& planned) const noexcept
    {
        const float reached = planned.of<bevel_rims>()[0].width;
        if (!(reached < wanted.width)) return false;
        wanted.width = reached;
        wanted.depth = static_cast<float>(as_double(reached) / tangent());
        return true;
    }

    /// Keeps the ridges, and the outlines of the floor.
    error keep_ridges(const region& filled, plan_data& data, workspace& space) const noexcept
    {
        workspace::scope scratch{space};
        const auto sides = data.bevel.of<side_point>().view();
        const auto is_corner = [&](std::uint32_t i) noexcept {
            return !(crease_degrees > 0.0f) || !(sides[i].before == sides[i].after);
        };
        auto& all = data.own.of<ridge_point>();
        if (error e = find_ridges(filled, data.bevel.swept, crease_cosine(crease_degrees), is_corner, scratch, all))
            return e;
        const auto floor = data.bevel.of<grid_point>().view();
        const auto starts = data.bevel.of<std::uint32_t>().view();
        const auto distance = static_cast<float>(data.bevel.swept.levels.back());
        for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
            for (std::uint32_t i = starts[k]; i < starts[k + 1]; ++i)
                if (!all.push_back({floor[i], distance, i == starts[k] ? ridge_step::floor : ridge_step::on}))
                    return error::out_of_memory;
            if (!all.push_back({floor[starts[k]], distance, ridge_step::on})) return error::out_of_memory;
        }
        return {};
    }

    [[nodiscard]] bevelled slopes_of(const carved_depth& to) const noexcept
    {
        bevelled slopes{.depth = to.depth, .width = to.width, .bevel_depth = to.depth};
        slopes.sides = as == carving::relief ? bevel_sides::front : bevel_sides::back;
        slopes.front = as != carving::groove;
        slopes.standing = as == carving::relief;
        slopes.mitre_limit = 1.0f;
        slopes.crease_degrees = crease_degrees;
        slopes.texture = texture;
        return slopes;
    }
    [[nodiscard]] bevelled slopes_of(const solid_with<plan_data>& s) const noexcept
    {
        return slopes_of(s.data.own.of<carved_depth>()[0]);
    }
    [[nodiscard]] static solid_with<bevel_data> inner(const solid_with<plan_data>& s) noexcept
    {
        return {{s.points, s.starts, s.triangles}, s.data.bevel};
    }

    [[nodiscard]] height_range range_to(double depth) const noexcept
    {
        return as == carving::relief ? height_range{0.0, depth} : height_range{-depth, 0.0};
    }

    /// The part of the cutter that becomes a part of the groove.
    [[nodiscard]] static part behind(part p) noexcept
    {
        if (p == part::front) return part::back;
        if (p == part::back) return part::front;
        if (p == part::front_bevel) return part::back_bevel;
        return p == part::back_bevel ? part::front_bevel : p;
    }
    [[nodiscard]] static part_sizes turned(const part_sizes& sizes) noexcept
    {
        part_sizes all = sizes;
        for (const part p : parts_of<carved>) {
            all.vertices[p] = sizes.vertices[behind(p)];
            all.triangles[p] = sizes.triangles[behind(p)];
        }
        return all;
    }

    /// The same point of the surface, seen from its other side. The textures are not mirrored.
    template <attribute Wants>
    static void turn_round(surface_point<Wants>& v) noexcept
    {
        if constexpr (has(Wants, attribute::normal)) v.normal = {-v.normal.x, -v.normal.y, -v.normal.z};
        if constexpr (has(Wants, attribute::tangent)) v.tangent.w = -v.tangent.w;
    }
};
static_assert(extruder<carved>);

}  // namespace typemesh::inline TYPEMESH_ABI

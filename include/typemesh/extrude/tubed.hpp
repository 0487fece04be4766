// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/impl/tube_clearance.hpp>
#include <typemesh/extrude/impl/tube_fitting.hpp>
#include <typemesh/extrude/impl/tube_surface.hpp>
#include <typemesh/extrude/impl/upright_walls.hpp>
#include <typemesh/extrude/plan_arrays.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The plan data of tubed: for each point of a path its normals, its mitre and the mitre's outer corner; and for each
/// path its start and its radius.
class tubed_data : public plan_arrays<side_point, detail::tube_joint, detail::tube_path, grid_point, std::uint32_t> {
public:
    detail::tube_fitting fitting;  ///< the memory of plan(), which is not stored with the glyph

    explicit tubed_data(memory source = heap()) noexcept : plan_arrays{source}, fitting{source} {}
};

/// An extruder of neon letters: round tubes along the outline, which lies in their middle.
///
///         .-------------.          Each loop becomes a closed tube. Its section is a regular polygon. At each point of
///        /  .---------.  \         the loop, the tube is cut by the plane that bisects the corner, and goes on from
///       |  /           \  |        there. So its volume is exactly the area of the section times the length of the
///       |  |           |  |        path. The middle of the tubes lies at z = 0.
///
///     text_mesher mesher{font, tubed{.radius = 0.02f}};
///     text_mesher mesher{font, tubed{.radius = 0.02f}, embolden{.by = -0.03f}};     along an inset of the outline
///
/// A tube intersects neither itself nor another tube of its solid. If the radius is too large for a loop, the loop gets
/// the largest radius that fits, less 1/64, and solid_plan::narrowed is set. Two rules limit the radius:
///
///     corners      at each end of an edge, radius * tan(turn / 2) fits into the edge. If the path turns to the same
///                  side at both ends, the sum of both fits, too
///     clearance    seen from above, the tubes do not meet
///
/// Sharp corners beside short edges would make most tubes thin. So points next to them are left out: see corner_cut.
/// They stay where the path without them would meet itself or another one, and the tube is then as thin as they make
/// it. A tube cannot follow curves that are narrower than its radius: for thick tubes, choose a font without rounded
/// corners.
/// If less than four cells of the grid are left of the radius, the loop has no tube.
///
/// Letters whose tubes would meet are kept apart, too, if they are merged (text_options::merge). Two loops that touch
/// are not kept apart from each other, nor is a loop that touches itself from itself, and solid_plan::touching is set:
/// text_options::corners separates or joins them.
///
/// Normals follow a round tube along the font's own curves, where points were left out to within 26 degrees of the
/// path's; corners sharper than the crease angle are hard. In
/// texture_mapping::em, u is the distance along the loop, and v the distance around the tube, from its outer side
/// towards the reader, both in em. In cylindrical, both run from 0 to 1; in box they are planar. All tubes belong to
/// part::side; if glyphs are merged, their tubes belong to shared_glyph.
///
/// Fails  error::bad_option: radius is not positive and finite, or 2^28 cells or more ("radius"); sides are not 3 to
///        128 ("sides"); crease_degrees is not 0 to 180; corner_cut is not 0 to 1; depth_in is not depth_unit::em
///        error::outline_beyond_grid: a tube reaches beyond 2^28 cells; error::too_large, error::out_of_memory
/// Cost   O(n log n) for n points of the outline, and O(n * sides) to write; O(n^2 log n) for the plan at worst
struct tubed {
    float radius = 0.02f;          ///< always in em
    std::uint32_t sides = 16;      ///< of the section, 3 to 128
    float crease_degrees = 15.0f;  ///< the crease angle of the outline, 0 to 180: see curve_normals
    texture_mapping texture = texture_mapping::em;

    /// How far the path of a tube may leave the outline beside sharp corners, in one and a half of its own radii, 0 to
    /// 1; points that are too close to a corner are left out. 0: all points stay.
    float corner_cut = 0.5f;

    using plan_data = tubed_data;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_bits bits{radius, sides, crease_degrees, corner_cut};
        bits.words[1] |= static_cast<std::uint64_t>(texture) << 32;
        return bits;
    }

    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data) const noexcept
    {
        if (error e = detail::tube_section::refused(*this)) return e;
        solid_plan made;
        if (filled.points().empty()) return made;
        const double em = filled.grid().cells * filled.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        if (!(as_double(radius) * em < grid::reach)) return error::bad("radius");
        const auto doubled = plan_sides(filled, curve_normals{crease_degrees}, texture, data.of<side_point>());
        if (!doubled) return doubled.error();
        if (error e = data.fitting.fit({filled.points(), filled.starts()}, data.of<side_point>(),
                                       as_double(radius) * em, as_double(corner_cut), crease_cosine(crease_degrees)))
            return e;
        if (!data.of<std::uint32_t>().append(data.fitting.starts())) return error::out_of_memory;
        if (error e = add_joints(em, data, made)) return e;
        return counted(data, made);
    }

    [[nodiscard]] height_range heights() const noexcept { return {-as_double(radius), as_double(radius)}; }
    /// The name of the option that is at fault if the heights cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept { return "radius"; }
    /// See extruder.
    [[nodiscard]] bool measures_in_em() const noexcept { return true; }

    /// The points whose edges meet hard.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return count_hard(s.data.of<side_point>());
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        if (p != part::side) return;
        with_axes(at, [&](const auto& axes) noexcept { surface(s).template vertices<Wants>(axes, at, put); });
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p == part::side) surface(s).triangles(first[part::side], put);
    }

    /// No triangle of a tube has its corners on the grid.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>&, Put&&) const noexcept
    {
    }

    /// The outer sides of the tubes: letters are merged if these meet.
    [[nodiscard]] solid_outline outline(const solid_with<plan_data>& s) const noexcept
    {
        return {s.data.of<grid_point>(), s.data.of<std::uint32_t>()};
    }

    /// The smallest radius of the tubes of a planned solid, in em; 0 if a loop has no tube.
    [[nodiscard]] float smallest_radius(const solid_with<plan_data>& s) const noexcept
    {
        float smallest = radius;
        for (const detail::tube_path& p : s.data.of<detail::tube_path>())
            smallest = p.radius < smallest ? p.radius : smallest;
        return smallest;
    }

private:
    [[nodiscard]] detail::tube_surface surface(const solid_with<plan_data>& s) const noexcept
    {
        detail::tube_surface all{s.data.of<std::uint32_t>(), s.data.of<side_point>(), s.data.of<detail::tube_joint>(),
                                 s.data.of<detail::tube_path>()};
        all.sides_around = sides;
        all.texture = texture;
        return all;
    }

    /// The radii and the mitres, as they are written.
    [[nodiscard]] error add_joints(double em, plan_data& data, solid_plan& made) const noexcept
    {
        const grid cells{.cells = 1.0};
        const detail::tube_clearance& clear = data.fitting.clearance();
        const auto points = data.fitting.points();
        const auto all = data.of<side_point>().view();
        const auto starts = data.of<std::uint32_t>().view();
        for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
            const float own = detail::tube_radius(clear.radii()[k], em, radius);
            made.narrowed = made.narrowed || own < radius;
            made.touching = made.touching || clear.meets(k);
            detail::tube_path path{own};
            for (std::uint32_t i = starts[k]; i < starts[k + 1]; ++i) {
                path.doubled += all[i].doubled ? 1u : 0u;
                const vec2 lean = rounded((as_double(own) * em) * clear.leans()[i]);
                const point p = placement::exact(points[i]), by{as_double(lean.x), as_double(lean.y)};
                const point outer = p + by;
                if (!(std::fabs(outer.x) <= grid::reach && std::fabs(outer.y) <= grid::reach))
                    return error::outline_beyond_grid;
                if (!data.of<detail::tube_joint>().push_back({points[i], lean}) ||
                    !data.of<grid_point>().push_back(cells.snap(outer)))
                    return error::out_of_memory;
                if (!(own > 0.0f)) continue;
                made.around.add(outer);
                made.around.add(p - by);
            }
            if (!data.of<detail::tube_path>().push_back(path)) return error::out_of_memory;
        }
        return {};
    }

    [[nodiscard]] result<solid_plan> counted(plan_data& data, solid_plan& made) const noexcept
    {
        detail::tube_surface all{
            data.of<std::uint32_t>().view(), data.of<side_point>().view(), {}, data.of<detail::tube_path>().view()};
        all.sides_around = sides;
        std::uint64_t vertices = 0, triangles = 0;
        for (std::size_t k = 0; k < all.paths.size(); ++k) {
            vertices += all.vertex_count(k);
            triangles += all.triangle_count(k);
        }
        if (vertices > 0x3FFF'FFFFu || triangles > 0x3FFF'FFFFu) return error::too_large;
        made.sizes.vertices[part::side] = static_cast<std::uint32_t>(vertices);
        made.sizes.triangles[part::side] = static_cast<std::uint32_t>(triangles);
        return made;
    }
};
static_assert(extruder<tubed>);

}  // namespace typemesh::inline TYPEMESH_ABI

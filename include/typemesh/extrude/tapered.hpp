// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/solid.hpp>
#include <typemesh/extrude/texture.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder whose walls lean inwards: letters with a draft angle, as moulds and castings need it.
///
///         .------.         front         z = 0
///        /        \        front_bevel   every wall leans by the draft angle; so the section is the letter moved
///       /          \                     inwards by a distance that grows evenly from the back to the front
///      '------------'      back          z = -depth: the letter as drawn
///
///     text_mesher mesher{*font, tapered{.degrees = 5.0f}};
///
/// A stroke that is thinner than twice the distance closes in a ridge below the front. This is bevelled with one
/// chamfer over the whole depth, so the solid has no part::side, except for low walls with text_options::corners (see
/// bevelled). The normals of the walls are exact: they are the normals of the outline's curves, turned up by the draft
/// angle. A few slivers, less than two cells of the grid wide, may face away from these normals.
///
/// If a glyph's walls are not proven simple up to the front, they lean less. The plan reports this as
/// solid_plan::narrowed.
///
/// The depth is in em, so text_options::depth_in must be depth_unit::em (the default): otherwise the angle is another.
///
/// Fails  error::bad_option: "depth", "degrees", "mitre_limit" or "crease_degrees" is out of range; or the front would
///        lie 2^28 cells or more within the outline ("degrees")
///        as bevelled does
/// Cost   as a bevel of this width: O(n log n)
struct tapered {
    float depth = 0.2f;        ///< in em
    float degrees = 5.0f;      ///< the draft angle between a wall and the depth, 0 to 89; 0: upright walls
    float mitre_limit = 2.0f;  ///< the limit for reflex corners, at least 1: those that are sharper become round; 0:
                               ///< no limit
    float crease_degrees = 15.0f;  ///< corners of the outline that turn by more are hard edges, 0 to 180: see
                                   ///< curve_normals
    bool centred = false;          ///< whether the front is at z = depth / 2 and the back at -depth / 2
    bool front = true;
    bool back = true;
    texture_mapping texture = texture_mapping::em;

    static constexpr std::size_t part_count = 5;
    using plan_data = bevel_data;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return is_valid() ? walls().cache_key() : option_bits{}; }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (!is_valid()) return error::bad("degrees");
        return walls().plan(filled, data, caps, "degrees");
    }

    [[nodiscard]] height_range heights() const noexcept { return walls().heights(); }
    /// The heights of a planned solid: its walls may meet below the front.
    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept { return walls().heights(s); }
    /// The angle is right only in em.
    [[nodiscard]] bool measures_in_em() const noexcept { return true; }

    /// The triangles of the walls and of the front.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        walls().seen_from_front(s, put);
    }

    /// The count of hard points, as in extruded.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return walls().hard_edges(s);
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        walls().template vertices<Wants>(p, s, at, put);
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        walls().triangles(p, s, first, put);
    }

    /// The bevel that is the whole solid: what bent and others that know bevelled take instead. Its width is how far
    /// the front lies within the outline. `degrees` must not be out of range.
    [[nodiscard]] bevelled walls() const noexcept
    {
        // The tangent has 24 bits after the point: the standard libraries' functions differ in the last bits.
        const double angle = as_double(degrees) * (3.14159265358979323846 / 180.0);
        const double tangent = std::floor(std::tan(angle) * 0x1p24 + 0.5) * 0x1p-24;
        bevelled all{.depth = depth, .width = static_cast<float>(as_double(depth) * tangent), .bevel_depth = depth};
        all.sides = bevel_sides::front;
        all.mitre_limit = mitre_limit;
        all.crease_degrees = crease_degrees;
        all.centred = centred;
        all.front = front;
        all.back = back;
        all.texture = texture;
        return all;
    }

private:
    [[nodiscard]] bool is_valid() const noexcept
    {
        return is_finite(as_double(degrees)) && degrees >= 0.0f && degrees <= 89.0f;
    }
};
static_assert(extruder<tapered>);

}  // namespace typemesh::inline TYPEMESH_ABI

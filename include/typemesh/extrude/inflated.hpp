// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/inflated_corners.hpp>
#include <typemesh/extrude/impl/inflated_normals.hpp>
#include <typemesh/extrude/impl/inflated_surface.hpp>
#include <typemesh/extrude/impl/inner_solid.hpp>
#include <typemesh/extrude/impl/pinched_edges.hpp>
#include <typemesh/inflate/membrane.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The plan data of inflated: the refined letter and its membrane.
struct inflated_data : inner_solid<inflated_surface> {
    membrane working;                  ///< the solver's memory, which is not stored with the glyph
    detail::pinched_edges pinches;     ///< likewise
    detail::inflated_corners corners;  ///< likewise
    detail::inflated_normals normals;  ///< likewise
    buffer<grid_point> inner;          ///< the points inside, before they follow the outline's

    explicit inflated_data(memory source = heap()) noexcept
        : inner_solid<inflated_surface>{source},
          working{source},
          pinches{source},
          corners{source},
          normals{source},
          inner{source}
    {
    }
    void clear() noexcept
    {
        inner_solid<inflated_surface>::clear();
        inner.clear();
    }
};

/// The sides of an inflated letter that are round.
enum class inflated_form : std::uint8_t {
    balloon,  ///< front and back, which meet in the outline
    dome,     ///< the front, on upright walls over a flat back
};

/// An extruder of inflated letters, like foil balloons: their height is the root of the solution of a Poisson equation.
///
///       _ - - - _              _ - - - _        A straight stroke becomes half a cylinder on each side, a disc an
///     /           \          /           \      ellipsoid; thick strokes rise higher than thin ones, and where strokes
///    |- - z = 0 - -|        |- - z = 0 - -|     meet the surface is smooth.
///     \           /         |             |
///       - _ _ _ -           +-------------+     The outline lies at z = 0. It stays as it is; the surface is upright
///        balloon                 dome           there, so a dome continues its walls.
///
///     inflated{}                                          balloons with a round section
///     inflated{.height = 0.5f}                            half as high
///     inflated{.limit = 0.05f}                            pillows: wide strokes are flat, less than 0.05 em high
///     inflated{.form = inflated_form::dome, .depth = 0.1f}
///
/// Heights scale with the letters' size. If text_options::depth_in is output, they do not: multiply `height` by the
/// size of an em in output units, text_options::size with output_unit::em, so that 1 times this size is round.
///
/// At the outline the normals are its curve_normals, doubled at hard corners; inside they come from a quadratic fit to
/// the solution. A normal that would point to the back of a triangle is turned to its front. Texture coordinates are
/// planar, as on other caps, with tangents along the text; a dome's walls have the coordinates of other walls.
///
/// It has the parts front, back and side; a balloon's side is empty. All triangles of merged glyphs belong to
/// shared_glyph.
///
/// Fails  error::bad_option: height is not positive and finite; limit is negative or not finite; depth is not positive
///        and finite; crease_degrees is not 0 to 180; edge and max_points as in membrane.hpp
///        error::too_many_points: a glyph's membrane needs more than max_points
///        error::out_of_memory
struct inflated {
    float height = 1.0f;  ///< how high strokes rise on each side, in halves of their width: 1 makes them round
    float edge = 0.03f;   ///< the length of the longest edge, in em; strokes narrower than that get shorter ones
    float limit = 0.0f;   ///< the height that wide strokes tend to, in the unit of depths; 0: none
    inflated_form form = inflated_form::balloon;
    float depth = 0.1f;            ///< the height of a dome's walls, in em or in output units: text_options::depth_in
    float crease_degrees = 15.0f;  ///< the crease angle of the outline, 0 to 180: see curve_normals
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points of one membrane, 2^29 - 1 at
                                                    ///< most, before hard corners are doubled and pinched edges raised
    bool front = true;
    bool back = true;
    bool side = true;
    texture_mapping texture = texture_mapping::em;

    using plan_data = inflated_data;

    /// See option_bits. Heights matter only for writing, unless there is a limit, but those that are refused need a key
    /// of their own.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_bits bits{edge, crease_degrees, max_points};
        const bool flags[] = {front, back, side, form == inflated_form::dome, !refused()};
        for (int i = 0; i < 5; ++i) bits.words[3] |= std::uint64_t{flags[i]} << i;
        bits.words[3] |= static_cast<std::uint64_t>(texture) << 5;
        bits.words[2] |= option_bits{flatness()}.words[0] << 32;
        return bits;
    }

    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data, Caps& caps) const noexcept
    {
        if (error e = refused()) return e;
        if (filled.points().empty()) return data.plan(surface(), filled, caps);
        std::uint32_t kept = 0;
        const refined_cap cap{data.loops, data.inner, data.triangles, kept};
        if (error e = data.working.inflate(filled, caps.triangles(), {edge, max_points}, cap)) return e;
        const std::size_t rim = data.loops.points.size();
        auto made = data.plan(surface(),
                              region::proven(data.loops, filled.holes(), filled.outers(), filled.is_touching()), caps);
        if (!made) return made;
        if (!data.loops.points.append(data.inner.view()) || !collect(data, rim, filled)) return error::out_of_memory;
        for (const part p : {part::front, part::back}) {
            if (!(p == part::front ? front : back)) continue;
            made->sizes.vertices[p] = static_cast<std::uint32_t>(data.loops.points.size());
            made->sizes.triangles[p] = static_cast<std::uint32_t>(data.triangles.size());
        }
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept { return surface().heights(); }
    [[nodiscard]] height_range heights(const solid_with<plan_data>& s) const noexcept
    {
        return surface().heights(s.data);
    }
    /// The name of the option that is at fault if the heights cannot be written.
    [[nodiscard]] const char* heights_name() const noexcept { return "height"; }

    /// The triangles of one side.
    template <class Put>
    void seen_from_front(const solid_with<plan_data>& s, Put&& put) const noexcept
    {
        if (!front && !back) return;
        for (const triangle& t : s.data.triangles) put(s.data.points[t.a], s.data.points[t.b], s.data.points[t.c]);
    }

    /// The hard corners of the outline.
    [[nodiscard]] std::uint64_t hard_edges(const solid_with<plan_data>& s) const noexcept
    {
        return count_hard(s.data.data.of<side_point>());
    }

    template <attribute Wants, class Put>
    void vertices(part p, const solid_with<plan_data>& s, const placement& at, Put&& put) const noexcept
    {
        surface().vertices<Wants>(p, s.data, at, put);
    }

    template <class Put>
    void triangles(part p, const solid_with<plan_data>& s, const first_vertices& first, Put&& put) const noexcept
    {
        surface().triangles(p, s.data, first, put);
    }

private:
    [[nodiscard]] inflated_surface surface() const noexcept
    {
        return {height, limit, depth, form == inflated_form::dome, front, back, side, texture, {crease_degrees}};
    }

    [[nodiscard]] error refused() const noexcept
    {
        if (!is_finite(as_double(height)) || !(height > 0.0f)) return error::bad("height");
        if (error e = membrane_options{edge, max_points}.refused()) return e;
        if (!is_finite(as_double(limit)) || limit < 0.0f) return error::bad("limit");
        if (!is_finite(as_double(depth)) || !(depth > 0.0f)) return error::bad("depth");
        if (!is_crease_angle(crease_degrees)) return error::bad("crease_degrees");
        return {};
    }

    /// `height / limit`, at most 10^30; 0 without a limit.
    [[nodiscard]] float flatness() const noexcept
    {
        constexpr float largest = 1e30f;  // the quotient may overflow
        if (!(limit > 0.0f)) return 0.0f;
        return height / limit < largest ? height / limit : largest;
    }

    /// The membrane's points in the order of the solid's, and those that the outline needs besides. False if out of
    /// memory.
    [[nodiscard]] bool collect(plan_data& data, std::size_t rim, const region& filled) const noexcept
    {
        const double cells_per_em = filled.grid().cells * filled.grid().units_per_em;
        // With `corners` floats distinguish cells, and no two points of the outline have one place. Heights are written
        // times `height`: eight cells of a letter a tenth as high are apart in slanted frames, too.
        const bool apart = filled.corners() != touching::keep;
        const double cells = apart ? 8.0 : 0.0;
        const auto step = static_cast<float>((std::max)(0x1p-22, cells / cells_per_em));
        buffer<membrane_point>& all = data.data.of<membrane_point>();
        const auto sides = data.data.of<side_point>().view();
        for (const side_point& s : sides)
            if (!all.push_back({0.0f, {-s.before.x, -s.before.y}})) return false;
        if (!all.append(data.working.points())) return false;
        // The front and the flat back of a dome share no edge.
        if (form == inflated_form::balloon && !data.pinches(data.loops, rim, data.triangles, all, step, apart))
            return false;
        if (!data.corners(data.loops, rim, sides, data.triangles, all)) return false;
        buffer<membrane_lean>& leans = data.data.of<membrane_lean>();
        if (!data.normals(data.loops, data.triangles, all, leans, cells_per_em, flatness())) return false;
        membrane_top top;
        for (const membrane_point& m : all) top.height = m.height > top.height ? m.height : top.height;
        return data.data.of<membrane_top>().push_back(top);
    }
};
static_assert(extruder<inflated>);

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/bend_error.hpp>
#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/bent_measure.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

[[nodiscard]] constexpr double3 as_double3(vec3 v) noexcept { return {as_double(v.x), as_double(v.y), as_double(v.z)}; }

/// Bends the vertices of a solid that has been placed flat in the deformation's space: in em, relative to the text's
/// own origin, with the text's own axes.
template <deformation D>
class bent_axes {
public:
    /// For the real placement of the solid.
    bent_axes(const D& how, const placement& at) noexcept
        : how_{how},
          frame_{at.frame},
          unit_per_em_{at.unit_per_cell / at.em_per_cell},
          shift_{at.unit_per_cell * (at.pen - at.em_pen)},
          hand_{at.frame.mirrors() ? -1.0f : 1.0f},
          flat_{at}
    {
        flat_.pen = at.em_pen;
        flat_.unit_per_cell = at.em_per_cell;
        flat_.unit_per_depth = at.em_per_depth;
        flat_.frame = {};
        flat_.frame.uv = at.frame.uv;
    }

    /// The placement with which the flat solid must be written.
    [[nodiscard]] const placement& flat() const noexcept { return flat_; }

    /// A vertex of the flat solid, bent and placed.
    template <attribute Wants, attribute Has>
    [[nodiscard]] surface_point<Wants> bend(const surface_point<Has>& v) const noexcept
    {
        surface_point<Wants> out = only<Wants>(v);
        const deformed_point d = how_(as_double3(v.position));
        if constexpr (has(Wants, attribute::position))
            out.position =
                in_frame({d.at.x * unit_per_em_ + shift_.x, d.at.y * unit_per_em_ + shift_.y, d.at.z * unit_per_em_});
        if constexpr (has(Wants, attribute::normal)) {
            // By the cofactors of the Jacobian matrix: its inverse, transposed, times the determinant.
            const double3 n = as_double3(v.normal);
            out.normal = in_frame(unit(n.x * cross(d.y, d.z) + n.y * cross(d.z, d.x) + n.z * cross(d.x, d.y)));
        }
        if constexpr (has(Wants, attribute::tangent)) {
            const double3 t =
                unit(as_double(v.tangent.x) * d.x + as_double(v.tangent.y) * d.y + as_double(v.tangent.z) * d.z);
            const vec3 placed = in_frame(t);
            out.tangent = {placed.x, placed.y, placed.z, hand_ * v.tangent.w};
        }
        return out;
    }

private:
    [[nodiscard]] static double3 unit(double3 a) noexcept { return (1.0 / length(a)) * a; }

    /// A place or a direction of the text's own axes, in the caller's.
    [[nodiscard]] vec3 in_frame(double3 a) const noexcept
    {
        const double3 all =
            a.x * as_double3(frame_.right) + a.y * as_double3(frame_.up) + a.z * as_double3(frame_.toward);
        return {static_cast<float>(all.x), static_cast<float>(all.y), static_cast<float>(all.z)};
    }

    const D& how_;
    frame frame_;
    double unit_per_em_;
    point shift_;
    float hand_;
    placement flat_;
};

/// The surface of a solid as it will be bent: how far its triangles are from the ideal surface, and its bounds.
template <deformation D>
class bent_surface {
public:
    /// `places` is working memory.
    bent_surface(const D& how, buffer<double3>& places) noexcept : how_{how}, places_{places} {}

    /// Reads a planned solid, placed flat in the deformation's space.
    ///
    /// Fails  error::out_of_memory
    template <extruder E>
    [[nodiscard]] error read(const E& solid, const solid_of<E>& s, const solid_plan& plan, const placement& at) noexcept
    {
        places_.clear();
        is_empty_ = true;
        greatest_ = 0.0;
        turns_ = false;
        bool fits = true;
        const auto keep = [&](const surface_point<attribute::position>& v) noexcept {
            fits = fits && places_.push_back(as_double3(v.position));
        };
        for (const part p : parts_of<E>) solid.template vertices<attribute::position>(p, s, at, keep);
        if (!fits) return error::out_of_memory;
        for (const double3& p : places_) add(how_(p).at);
        // Floats move the corners by up to half a step in each direction.
        double farthest = 0.0;
        for (const double3& p : places_)
            farthest = (std::max)({farthest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        const double thin = (std::max)(thinnest * at.em_per_cell, 0x1p-20 * farthest);
        const part_counts first = plan.sizes.vertices.starts();
        for (const part p : parts_of<E>)
            solid.triangles(p, s, first, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
                const double3 corners[] = {places_[a], places_[b], places_[c]};
                const double error_of = error_over(corners);
                turns_ = turns_ || is_turned(how_, corners, thin);
                if (is_finite(greatest_) && !(error_of <= greatest_)) greatest_ = error_of;
            });
        return {};
    }

    /// No point of the bent triangles is farther than this from its place on the bent solid, in em. Not finite
    /// if the deformation's bounds of a triangle are not.
    [[nodiscard]] double greatest_error() const noexcept { return greatest_; }
    /// Whether the image of a triangle turns: see is_turned(). Triangles so thin that their side is a rounding, on the
    /// grid or to floats, do not count.
    [[nodiscard]] bool turns() const noexcept { return turns_; }
    /// The box around all bent vertices, in em.
    [[nodiscard]] box3 bounds() const noexcept { return bounds_; }

private:
    [[nodiscard]] double error_over(const double3 (&corners)[3]) const noexcept
    {
        box3 b{corners[0], corners[0]};
        for (const double3& c : corners) widen(b, c);
        return bend_error(how_.bend(b), b.high - b.low);
    }
    static void widen(box3& b, const double3& p) noexcept
    {
        b.low = {p.x < b.low.x ? p.x : b.low.x, p.y < b.low.y ? p.y : b.low.y, p.z < b.low.z ? p.z : b.low.z};
        b.high = {p.x > b.high.x ? p.x : b.high.x, p.y > b.high.y ? p.y : b.high.y, p.z > b.high.z ? p.z : b.high.z};
    }
    void add(const double3& p) noexcept
    {
        if (is_empty_) bounds_ = {p, p};
        is_empty_ = false;
        widen(bounds_, p);
    }

    const D& how_;
    buffer<double3>& places_;
    box3 bounds_{};
    double greatest_ = 0.0;
    bool is_empty_ = true;
    bool turns_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail

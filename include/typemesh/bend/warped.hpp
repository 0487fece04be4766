// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/impl/warped_curves.hpp>
#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/bend/unfolded.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// A warp as a deformation of space that keeps z.
template <plane_warp W>
struct warp_in_space {
    const W* warps;

    [[nodiscard]] error refused_options() const noexcept { return {}; }
    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const warped_point w = (*warps)({p.x, p.y});
        return {{w.at.x, w.at.y, p.z}, {w.x.x, w.x.y, 0.0}, {w.y.x, w.y.y, 0.0}, {0.0, 0.0, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const bend_bounds own = warps->bend({{b.low.x, b.low.y}, {b.high.x, b.high.y}});
        return {.xx = own.xx, .yy = own.yy, .xy = own.xy, .x_jump = own.x_jump};
    }
};

}  // namespace detail

/// The step that warps outlines in the plane, before anything else happens to them: on an arc, in a wave, in
/// perspective, or by a map of your own (plane_warp.hpp). A mesher takes it besides its solid:
///
///     text_mesher mesher{font, bevelled{}, warped{arc{.degrees = 90}}};
///     mesher.use(warped{flag{.height = 0.1}});
///     mesher.use(no_outline_step{});
///
/// Everything that follows treats the warped outline as if the font had drawn it so: fill rules, normals, bevels,
/// outlined and bold letters, merged letters, texture coordinates and their boxes. So a bevel has the same width
/// everywhere. Every curve becomes cubics; no inner points are needed. Advances do not change: letters are laid out
/// before they are warped.
///
/// Cubics are at most a quarter of the text's tolerance away from the ideal curves, which is proven, not sampled
/// (impl/warped_curves.hpp); the other three quarters are left for flattening. If the warp is affine where a glyph
/// stands, its curves are mapped exactly.
///
/// Every occurrence of a glyph is built at its own place, without a cache, as for bent solids.
///
/// Fails  error::bad_option, error::goes_around: as the warp does
///        error::folds_over: the warp turns a letter inside out, or is not proven not to
///        error::bad_tolerance: the tolerance is so small that no number of pieces suffices
///        error::too_many_points: more curves than max_points
///        error::outline_not_finite: the image of a curve is not a number or infinite; the glyph is left out
/// Cost   a few evaluations of the warp for each point of the flattened curve
template <plane_warp W>
struct warped {
    W how = {};  ///< the warp

    /// See option_bits. Warped glyphs are not cached; this key names the policy.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    /// See outline_step.
    [[nodiscard]] error refused(const box& text) const noexcept
    {
        if (error e = how.refused_options()) return e;
        if constexpr (requires { how.refused_text(text); })
            return fitted_to(how, text).refused_text(text);
        else
            return {};
    }

    /// See outline_step.
    [[nodiscard]] result<double> operator()(const outline& drawn, const drawn_place& at, double tolerance,
                                            std::uint32_t most, outline& out) const noexcept
    {
        out.clear();
        out.rule = drawn.rule;
        if (error e = how.refused_options()) return e;
        if (drawn.curves.empty()) return tolerance;
        if (!is_finite(at.origin.x) || !is_finite(at.origin.y)) return error::outline_not_finite;
        const W own = fitted_to(how, at.text);
        const point low = at.em_per_unit * drawn.bounds.low + at.origin,
                    high = at.em_per_unit * drawn.bounds.high + at.origin;
        if (!is_unfolded_by(own, {low, high})) return error::folds_over;
        detail::curve_warper<W> warp{own, at, share * tolerance, most, out};
        if (!out.starts.push_back(0)) return error::out_of_memory;
        for (std::uint32_t c = 0; c < drawn.contour_count(); ++c) {
            for (std::uint32_t i = drawn.starts[c]; i < drawn.starts[c + 1]; ++i)
                if (error e = warp(drawn.curves[i])) return e;
            if (!out.starts.push_back(static_cast<std::uint32_t>(out.curves.size()))) return error::out_of_memory;
        }
        return warp.is_exact() ? tolerance : (1.0 - share) * tolerance;
    }

private:
    [[nodiscard]] static bool is_unfolded_by(const W& own, const box& b) noexcept
    {
        if constexpr (requires { own.is_unfolded(b); })
            return own.is_unfolded(b);
        else
            return is_unfolded(detail::warp_in_space<W>{&own}, {{b.low.x, b.low.y, 0.0}, {b.high.x, b.high.y, 0.0}});
    }

    static constexpr double share = 0.25;  // of the tolerance
};
template <plane_warp W>
warped(W) -> warped<W>;

}  // namespace typemesh::inline TYPEMESH_ABI

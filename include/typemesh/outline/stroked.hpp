// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/impl/stroker.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/stroke_style.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The step that replaces letters by strokes along their outlines. A mesher takes it besides its solid:
///
///     text_mesher mesher{font, bevelled{}, stroked{{.width = 0.03, .join = stroke_join::round}}};
///
/// Everything that follows treats the strokes as if the font had drawn them. The contours of letters are closed, so the
/// caps do not matter; stroked_outlines strokes open paths.
///
/// A quarter of the text's tolerance is for the sides of the strokes, the rest for flattening.
///
/// Fails  error::bad_option: "width", "mitre_limit", "dashes", "dash_offset"
///        error::too_many_points: more curves than max_points
/// Cost   about 20 evaluations of a curve for each cubic; the strokes overlap, so fill() resolves crossings
struct stroked {
    stroke_style style = {};

    /// See option_bits. Glyphs with an outline step are not cached; this key names the policy.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    /// See outline_step.
    [[nodiscard]] error refused(const box&) const noexcept { return style.refused(); }

    /// See outline_step.
    [[nodiscard]] result<double> operator()(const outline& drawn, const drawn_place& at, double tolerance,
                                            std::uint32_t most, outline& out) const noexcept
    {
        out.clear();
        out.rule = fill_rule::non_zero;
        if (error e = style.refused()) return e;
        outline_recorder to{out, most};
        const double units = 1.0 / at.em_per_unit;
        detail::stroker draw{style, units, share * tolerance * units, to};
        for (std::uint32_t c = 0; c < drawn.contour_count(); ++c)
            if (error e = draw.stroke(
                    drawn.curves.view().subspan(drawn.starts[c], drawn.starts[c + 1] - drawn.starts[c]), true))
                return e;
        if (error e = to.finish()) return e;
        return (1.0 - share) * tolerance;
    }

private:
    static constexpr double share = 0.25;  // of the tolerance
};

}  // namespace typemesh::inline TYPEMESH_ABI

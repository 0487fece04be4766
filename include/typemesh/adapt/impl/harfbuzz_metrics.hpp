// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/layout/face_metrics.hpp>

#include <hb-ot.h>
#include <hb.h>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A number of a font in em, or `otherwise` if the font lacks it. `em`: HarfBuzz's units per em, up or to the right.
[[nodiscard]] inline double metric_of(hb_font_t* font, hb_ot_metrics_tag_t tag, double em, double otherwise) noexcept
{
    hb_position_t found = 0;
    return hb_ot_metrics_get_position(font, tag, &found) != 0 ? found / em : otherwise;
}

/// A font's metrics of bars and small letters, from its tables 'post' and OS/2. If a thickness or size cannot be drawn,
/// values that suit most fonts replace it.
[[nodiscard]] inline face_metrics read_face_metrics(hb_font_t* font) noexcept
{
    int x = 0, y = 0;
    hb_font_get_scale(font, &x, &y);
    const double em = y;
    face_metrics found;
    const auto take_bar = [&](bar_metrics& to, hb_ot_metrics_tag_t top, hb_ot_metrics_tag_t thickness) noexcept {
        const bar_metrics own{metric_of(font, top, em, to.top), metric_of(font, thickness, em, 0.0)};
        if (own.thickness > 0.0) to = own;
    };
    const auto take_small = [&](script_metrics& to, hb_ot_metrics_tag_t size, hb_ot_metrics_tag_t offset,
                                double up) noexcept {
        const script_metrics own{metric_of(font, size, em, 0.0), up * metric_of(font, offset, em, up * to.rise)};
        if (own.size > 0.0 && own.size <= 1.0) to = own;
    };
    take_bar(found.underline, HB_OT_METRICS_TAG_UNDERLINE_OFFSET, HB_OT_METRICS_TAG_UNDERLINE_SIZE);
    take_bar(found.strike_through, HB_OT_METRICS_TAG_STRIKEOUT_OFFSET, HB_OT_METRICS_TAG_STRIKEOUT_SIZE);
    take_small(found.superscript, HB_OT_METRICS_TAG_SUPERSCRIPT_EM_Y_SIZE, HB_OT_METRICS_TAG_SUPERSCRIPT_EM_Y_OFFSET,
               1.0);
    take_small(found.subscript, HB_OT_METRICS_TAG_SUBSCRIPT_EM_Y_SIZE, HB_OT_METRICS_TAG_SUBSCRIPT_EM_Y_OFFSET, -1.0);
    return found;
}

/// Appends the carets within a ligature, from the table GDEF: see ligature_carets.hpp. `unit`: font units per HarfBuzz
/// unit, x and y.
///
/// Fails  error::out_of_memory
inline error append_ligature_carets(hb_font_t* font, point unit, hb_codepoint_t glyph, bool down,
                                    buffer<double>& carets) noexcept
{
    const hb_direction_t way = down ? HB_DIRECTION_TTB : HB_DIRECTION_LTR;
    for (unsigned first = 0;;) {
        hb_position_t some[16];
        unsigned count = 16;
        const unsigned all = hb_ot_layout_get_ligature_carets(font, way, glyph, first, &count, some);
        for (unsigned i = 0; i < count; ++i)
            if (!carets.push_back(down ? 0.0 - unit.y * some[i] : unit.x * some[i])) return error::out_of_memory;
        first += count;
        if (count == 0 || first >= all) return {};
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

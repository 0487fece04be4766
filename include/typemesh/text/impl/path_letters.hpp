// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/along_path.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/layout/glyph_run.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The part of the x axis that a text takes, in font units.
struct text_extent {
    double low = 0.0;
    double high = 0.0;

    void add(double from, double to, bool first) noexcept
    {
        low = first || from < low ? from : low;
        high = first || to > high ? to : high;
    }
};

/// The letters of a run that is put onto a path.
class path_letters {
public:
    path_letters(const glyph_run& run, double units_per_em) noexcept : run_{run}, em_{units_per_em} {}

    /// From the start of the first line to the end of the longest one. Without lines, or if a line has no advance, its
    /// glyphs count, each from its origin to as far behind its middle.
    [[nodiscard]] text_extent extent() const noexcept
    {
        text_extent all;
        bool first = true;
        if (run_.lines.empty()) add_glyphs({.glyph_count = static_cast<std::uint32_t>(run_.glyphs.size())}, all, first);
        for (const text_line& line : run_.lines) add_line(line, all, first);
        return all;
    }

    /// Whether a line is a column, whose glyphs follow each other downwards.
    [[nodiscard]] bool has_columns() const noexcept
    {
        for (const text_line& line : run_.lines)
            if (run_.is_column(line)) return true;
        return false;
    }

    /// Where the glyphs stand.
    void stand(const along_path& way, glyph_stand* stands) const noexcept
    {
        const text_extent text = extent();
        const double all = way.path->length(), slack = 0x1p-30 * all,
                     first = way.start + way.stretch * (text.low / em_);
        const double lowest = way.path->is_closed() ? first : 0.0, highest = lowest + all;
        double middle = 0.0;  // of the cluster so far
        for (std::size_t i = 0; i < run_.glyphs.size(); ++i) {
            const placed_glyph& g = run_.glyphs[i];
            const double own = g.origin.x + as_double(g.to_middle);
            const bool goes_on = i > 0 && run_.glyphs[i - 1].cluster == g.cluster &&
                                 std::fabs(own - middle) <= 0x1p-16 * em_;  // to_middle is rounded
            if (!goes_on) middle = own;
            stands[i] = at(way, g, middle);
            const double distance = way.start + way.stretch * (middle / em_);
            const bool shown = own >= text.low && own <= text.high;  // white space at the end of a line hangs
            stands[i].left_out =
                !is_finite(own) ? false : shown && !(distance >= lowest - slack && distance <= highest + slack);
        }
    }

private:
    [[nodiscard]] glyph_stand at(const along_path& way, const placed_glyph& g, double middle) const noexcept
    {
        glyph_stand s;
        s.start = way.start;
        s.stretch = way.stretch;
        s.origin = g.origin;
        if (!is_finite(middle) || !is_finite(g.origin.y)) return s;
        const plane_path::place on = way.place_at(middle / em_);
        // Where nothing is stretched, no sum is rounded that is not rounded in the flat text.
        const double start = em_ * (way.start - on.from),
                     along = same(way.stretch, 1.0) ? start + g.origin.x
                                                    : start + way.stretch * middle + (g.origin.x - middle);
        const point left{0.0 - on.tangent.y, on.tangent.x};
        s.origin = em_ * on.at + along * on.tangent + g.origin.y * left;
        s.right = on.tangent;
        return s;
    }

    void add_line(const text_line& line, text_extent& all, bool& first) const noexcept
    {
        if (!(line.advance > 0.0) || !is_finite(line.advance) || !is_finite(line.origin.x))
            return add_glyphs(line, all, first);
        all.add(line.origin.x, line.origin.x + line.advance, first);
        first = false;
    }
    void add_glyphs(const text_line& line, text_extent& all, bool& first) const noexcept
    {
        for (const placed_glyph& g : run_.letters_of(line)) {
            const double x = g.origin.x, behind = x + 2.0 * as_double(g.to_middle);
            if (!is_finite(x) || !is_finite(behind)) continue;
            all.add(x < behind ? x : behind, x < behind ? behind : x, first);
            first = false;
        }
    }

    const glyph_run& run_;
    double em_;
};

/// An outline that is turned and moved to its stand, relative to `flat`, its origin in the run.
inline error turn_outline(const outline& drawn, const glyph_stand& stand, point flat, std::uint32_t most,
                          outline& out) noexcept
{
    out.clear();
    out.rule = drawn.rule;
    if (drawn.curves.size() > most) return {error::too_many_points, most};
    if (!is_finite(flat.x) || !is_finite(flat.y)) return error::outline_not_finite;
    if (!out.starts.append(drawn.starts.view())) return error::out_of_memory;
    if (!is_finite(stand.origin.x) || !is_finite(stand.origin.y)) return error::outline_not_finite;
    const point move = stand.origin - flat, right = stand.right, up{0.0 - right.y, right.x};
    for (const curve& c : drawn.curves) {
        curve own = c;
        for (std::uint32_t k = 0; k <= c.degree; ++k) {
            own.p[k] = move + c.p[k].x * right + c.p[k].y * up;
            out.bounds.add(own.p[k]);
        }
        if (!out.curves.push_back(own)) return error::out_of_memory;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail

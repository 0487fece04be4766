// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The error if nothing can be placed there, or none.
[[nodiscard]] inline error misplaced(point origin) noexcept
{
    if (!is_finite(origin.x) || !is_finite(origin.y)) return error::outline_not_finite;
    constexpr double farthest = 0x1p80;  // font units; 32-bit floats do not reach much farther in any unit
    if (std::fabs(origin.x) > farthest || std::fabs(origin.y) > farthest) return error::outline_beyond_grid;
    return {};
}

/// The line of a glyph of the run (the last one, if several begin with it); 0 if there is at most one line.
[[nodiscard]] inline std::uint32_t line_of(const glyph_run& run, std::uint32_t glyph) noexcept
{
    const std::size_t after =
        first_where(1, run.lines.size(), [&](std::size_t k) noexcept { return run.lines[k].first_glyph > glyph; });
    return static_cast<std::uint32_t>(after - 1);
}

/// The group whose first member is this glyph of the run, or drawn_glyph::none.
[[nodiscard]] inline std::uint32_t group_of(const merged_glyphs& merged, std::uint32_t glyph) noexcept
{
    const auto first_of = [&](std::size_t k) noexcept { return merged.members_of(merged.groups[k]).front(); };
    const std::size_t found =
        first_where(0, merged.groups.size(), [&](std::size_t k) noexcept { return first_of(k) >= glyph; });
    if (found == merged.groups.size() || first_of(found) != glyph) return drawn_glyph::none;
    return static_cast<std::uint32_t>(found);
}

/// Counts glyphs for a report, in any order, and finds the first of each kind in the run.
class glyph_counts {
public:
    explicit glyph_counts(text_report& report) noexcept : report_{report} {}

    void refused(std::uint32_t i, const error& refusal) noexcept
    {
        if (report_.refused++ != 0 && i > first_refused_) return;
        first_refused_ = i;
        report_.first_refusal = refusal;
    }
    void drawn(std::uint32_t i, cluster_id cluster, const built_glyph& built) noexcept
    {
        report_.corners_moved += built.corners_moved();
        const place at{i, cluster};
        count(built.is_touching() ? 1 : 0, at, report_.touching, first_touching_, report_.first_touching);
        count(built.is_narrowed() ? 1 : 0, at, report_.narrowed, first_narrowed_, report_.first_narrowed);
        count(built.lost_caps(), at, report_.lost_caps, first_lost_, report_.first_lost_cap);
        count(built.kept_triangles(), at, report_.kept_triangles, first_kept_, report_.first_kept_triangle);
    }

private:
    struct place {
        std::uint32_t glyph;
        cluster_id cluster;
    };

    static void count(std::uint32_t how_many, place at, std::uint32_t& all, std::uint32_t& first,
                      cluster_id& first_cluster) noexcept
    {
        if (how_many == 0) return;
        if (all == 0 || at.glyph < first) {
            first = at.glyph;
            first_cluster = at.cluster;
        }
        all += how_many;
    }

    text_report& report_;
    std::uint32_t first_refused_ = 0, first_touching_ = 0, first_narrowed_ = 0, first_lost_ = 0, first_kept_ = 0;
};

}  // namespace detail

/// Places each glyph of the run, style by style; a merged group is placed at its first member. Needs all.numbers,
/// pinned, glyph styles and merged. Blank glyphs and glyphs that cannot be drawn are counted in the report.
///
///     on_grid    glyphs are placed on the grid, where glyph_merger has compared them: glyphs that do not touch there
///                do not touch when they are written
///
/// Fails  error::too_large, error::out_of_memory
/// Cost   O(glyphs) if there is one style and nothing is merged, otherwise O(glyphs log glyphs)
inline error place_glyphs(text_glyphs& all, const glyph_run& run, bool on_grid = false) noexcept
{
    text_report& report = all.report;
    const merged_glyphs& merged = all.merged;
    report.glyphs = static_cast<std::uint32_t>(run.glyphs.size());
    if (!all.reserve_records(run.glyphs.size())) return error::out_of_memory;
    if (error e = all.glyph_styles.sort(run)) return e;
    const array_view<const std::uint32_t> order = all.glyph_styles.order();
    std::uint32_t line = 0;
    detail::glyph_counts counts{report};
    for (std::uint32_t k = 0; k < run.glyphs.size(); ++k) {
        const std::uint32_t i = order.empty() ? k : order[k];
        if (!order.empty() && !run.lines.empty())
            line = detail::line_of(run, i);
        else
            while (line + 1 < run.lines.size() && i >= run.lines[line + 1].first_glyph) ++line;
        const std::uint32_t number = all.numbers[i];
        if (number == glyph_set::no_room || (!merged.first_of.empty() && merged.first_of[i] != i)) continue;
        const placed_glyph& glyph = run.glyphs[i];
        drawn_glyph s;
        s.built = all.pinned[number];
        s.origin = s.flat = glyph.origin;
        if (all.turned && !all.is_warped(i)) {
            s.origin = all.stands[i].origin;
            s.right = all.stands[i].right;
        }
        s.id = glyph.id;
        s.cluster = glyph.cluster;
        s.style = all.glyph_styles.style_of(glyph.glyph_style);
        s.line = line;
        s.glyph = i;
        if (!merged.groups.empty()) s.merged = detail::group_of(merged, i);
        if (s.merged != drawn_glyph::none) {
            s.built = merged.groups[s.merged].built;
            s.origin = s.flat = merged.groups[s.merged].origin;
        }
        error refusal = detail::misplaced(s.origin);
        if (on_grid && !refusal) s.origin = s.flat = rounded_pen(s.origin, s.built->cells());
        if (!refusal) refusal = s.built->refusal();
        if (refusal) {
            counts.refused(i, refusal.at(glyph.id, glyph.cluster));
        } else if (s.built->is_blank()) {
            ++report.blank;
        } else {
            if (error e = all.place_glyph(s, number)) return e;
            counts.drawn(i, glyph.cluster, *s.built);
        }
    }
    all.number_meshes();
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI

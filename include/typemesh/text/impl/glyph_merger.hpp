// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/fill/impl/group_intersection.hpp>
#include <typemesh/fill/region_union.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/glyph/solid_planner.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Merges the glyphs of a text whose outlines meet, group by group. If a step or the extruder makes them grow
/// (has_outline in extruder.hpp), it merges the glyphs that meet after they have grown:
///
///      .--..-.     .--.                    .-----.     .--.        A group is a chain of glyphs in which each one
///      |a ||b| ..  |d |        ->          |     | ..  |d |        shares a point with the next. All others are
///      '--+' | ||  '--'                    '---. | ||  '--'        unchanged. Here, "c" is in no group.
///         '--' ''c                             '-' ''
///
/// Pens are rounded to the finest grid of the text's glyphs, by at most half a cell (1/1024 font unit in ordinary
/// fonts). A group that does not fit onto this grid uses the finest one that it fits onto. Two kinds of glyphs are
/// never merged: a glyph so large that its grid is coarser than the others' (more than 2^19 font units in ordinary
/// fonts), and a glyph farther than 2^48 cells from the text's origin.
class glyph_merger {
public:
    explicit glyph_merger(memory source = heap()) noexcept : caps_{source}, planner_{source}, union_{source} {}

    /// Returns its scratch memory to its source.
    void trim() noexcept
    {
        caps_.trim();
        planner_.trim();
        union_ = region_union{caps_.source()};
    }

    /// Fills in all.merged; needs all.pinned and all.numbers.
    ///
    /// A group that cannot be built is refused, like a glyph: see glyph_builder::concerns_the_glyph_alone().
    ///
    /// Fails  error::too_large, error::out_of_memory, and errors of policies' own, with the group's first glyph
    /// Cost   as group_intersection() for n glyphs. For every group, its members' outlines are flattened and filled
    ///        once more, and resolve(), the triangulator and the extruder process the points of all of them. Glyphs
    ///        that meet no other cost only the comparison
    error operator()(text_glyphs& all, const glyph_run& run, glyph_builder& builder, font_ref font,
                     const glyph_settings& how, const policies& with) noexcept
    {
        with.observe(stage::fill);
        const std::size_t count = run.glyphs.size();
        workspace::scope scratch{caps_.space()};
        auto* next = scratch.take<std::uint32_t>(count);  // the next glyph of the same group; at its last one: count
        auto* last = scratch.take<std::uint32_t>(count);  // the last glyph so far of the group that begins here
        std::uint32_t* first_of = all.merged.first_of.append(count);
        if (count != 0 && (next == nullptr || last == nullptr || first_of == nullptr)) return error::out_of_memory;
        if (error e = find_groups(all, run, with.raise, {first_of, count})) return e;

        const member_builder members{builder, font, how, with};
        const auto none = static_cast<std::uint32_t>(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            next[i] = none;
            if (first_of[i] != i) next[last[first_of[i]]] = i;
            last[first_of[i]] = i;
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            if (first_of[i] != i || next[i] == none) continue;
            const auto first_member = static_cast<std::uint32_t>(all.merged.members.size());
            for (std::uint32_t k = i; k != none; k = next[k])
                if (!all.merged.members.push_back(k)) return error::out_of_memory;
            merged_group made;
            made.first_member = first_member;
            made.member_count = static_cast<std::uint32_t>(all.merged.members.size()) - first_member;
            if (error e = join(made, all, run, members)) return e.at(run.glyphs[i].id, run.glyphs[i].cluster);
            if (!all.merged.groups.push_back(made)) return error::out_of_memory;
        }
        return {};
    }

private:
    /// Builds the regions of a group's members.
    struct member_builder {
        glyph_builder& by;
        font_ref font;
        const glyph_settings& how;
        const policies& with;
    };

    struct pen {
        std::int64_t x = 0;
        std::int64_t y = 0;
    };

    static pen snapped(point origin, double cells) noexcept
    {
        return {static_cast<std::int64_t>(std::nearbyint(origin.x * cells)),
                static_cast<std::int64_t>(std::nearbyint(origin.y * cells))};
    }

    /// The finest grid, which nearly all glyphs have.
    static double finest(const text_glyphs& all) noexcept
    {
        double cells = 0.0;
        for (std::size_t k = 0; k < all.different.keys().size(); ++k) {
            const built_glyph* s = all.pinned[k];
            if (!s->form().points.empty() && s->cells() > cells) cells = s->cells();
        }
        return cells;
    }

    error find_groups(const text_glyphs& all, const glyph_run& run, solid_ref how,
                      array_view<std::uint32_t> first_of) noexcept
    {
        workspace::scope scratch{caps_.space()};
        auto* loops = scratch.take<placed_loops>(first_of.size());
        if (loops == nullptr && !first_of.empty()) return error::out_of_memory;
        const double cells = finest(all);
        for (std::size_t i = 0; i < first_of.size(); ++i) {
            loops[i] = {};
            if (all.numbers[i] == glyph_set::no_room) continue;
            const built_glyph& s = *all.pinned[all.numbers[i]];
            const point origin = run.glyphs[i].origin;
            constexpr double farthest = 0x1p48;
            const bool stands = std::fabs(origin.x) * cells <= farthest && std::fabs(origin.y) * cells <= farthest;
            if (!is_finite(origin.x) || !is_finite(origin.y) || !stands || !same(s.cells(), cells)) continue;
            const pen at = snapped(origin, cells);
            const auto kind = static_cast<std::uint32_t>(all.glyph_styles.style_of(run.glyphs[i].glyph_style));
            // A blank or refused glyph has no plan data.
            const solid_outline grown = s.form().points.empty() ? solid_outline{} : how.outline_of(s);
            loops[i] = {grown.points, grown.starts, at.x, at.y, kind};
        }
        return group_intersection({loops, first_of.size()}, first_of, caps_.space());
    }

    /// The finest grid onto which all members fit, relative to the first one's pen.
    static result<grid> grid_for(const text_glyphs& all, const glyph_run& run,
                                 array_view<const std::uint32_t> members) noexcept
    {
        const point first = run.glyphs[members[0]].origin;
        box around;
        grid g;
        g.cells = 0.0;
        for (const std::uint32_t m : members) {
            const built_glyph& s = *all.pinned[all.numbers[m]];
            const point offset = run.glyphs[m].origin - first;
            const grid own{s.cells()};
            around.merge({offset + own.place(s.low()), offset + own.place(s.high())});
            g.cells = s.cells() > g.cells ? s.cells() : g.cells;
        }
        g.units_per_em = all.glyph_styles.units_per_em();
        double farthest = 0.0;
        for (const double v : {around.low.x, around.low.y, around.high.x, around.high.y})
            farthest = std::fabs(v) > farthest ? std::fabs(v) : farthest;
        while (farthest * g.cells > grid::reach - 2.0) {
            g.cells *= 0.5;
            if (g.cells < 0x1p-40) return error::outline_beyond_grid;
        }
        g.span_over(around);
        return g;
    }

    /// try_to_join(); a group that cannot be built is refused, like a glyph, and the text continues without it.
    error join(merged_group& made, text_glyphs& all, const glyph_run& run, const member_builder& members) noexcept
    {
        const error e = try_to_join(made, all, run, members);
        if (!e || !glyph_builder::concerns_the_glyph_alone(e)) return e;
        glyph_draft none;
        none.refusal = e;
        made.built = all.store.keep(none);
        return made.built == nullptr ? error{error::out_of_memory} : error{};
    }

    /// Makes one glyph of the group's members.
    error try_to_join(merged_group& made, text_glyphs& all, const glyph_run& run, const member_builder& build) noexcept
    {
        const auto& [by, font, how, with] = build;
        const array_view<const std::uint32_t> members = all.merged.members_of(made);
        const auto onto = grid_for(all, run, members);
        if (!onto) return onto.error();
        union_.begin(*onto, how.corners);
        corner_parting parting;
        std::uint32_t corners = 0;  // parted or joined corners, of the members and of the whole group
        const pen first = snapped(run.glyphs[members[0]].origin, onto->cells);
        for (const std::uint32_t m : members) {
            auto face = all.glyph_styles.face_of(font, run.glyphs[m].glyph_style);
            glyph_settings own = how;
            if (!all.stands.empty()) own.stand = &all.stands[m];
            const auto filled = by.build_region(face, run.glyphs[m].id, own, with, with.warp,
                                                all.place_at(run.glyphs[m].origin).origin);
            corners += by.parting().corners;
            if (!filled) return filled.error();
            const pen at = snapped(run.glyphs[m].origin, onto->cells);
            if (const auto done =
                    union_.add(*filled, onto->cells / filled->grid().cells, at.x - first.x, at.y - first.y);
                !done)
                return done.error();
        }
        with.observe(stage::fill);
        const std::size_t own_curves = union_.curve_count();
        const auto joined = union_.join(caps_.space(), how.max_pieces, parting);
        if (!joined) return joined.error();
        with.observe(stage::triangulate);
        if (const auto done = caps_.cap(*joined, with.cut); !done) return done.error();
        with.observe(stage::extrude);
        parting.corners += corners;
        made.origin = {static_cast<double>(first.x) / onto->cells, static_cast<double>(first.y) / onto->cells};
        const auto planned =
            planner_.plan({*joined, caps_.triangles().view(), parting}, caps_, with, all.place_at(made.origin));
        if (!planned) return planned.error();

        made.built = all.store.keep(planned->draft);
        made.first_owner = static_cast<std::uint32_t>(all.merged.owners.size());
        const auto edges = planned->filled.edges();
        std::uint32_t* owners = all.merged.owners.append(edges.size());
        if (made.built == nullptr || (owners == nullptr && !edges.empty())) return error::out_of_memory;
        for (std::size_t i = 0; i < edges.size(); ++i)
            owners[i] = edges[i].curve < own_curves ? members[union_.member_of(edges[i].curve)] : shared_glyph;
        return {};
    }

    cap_builder caps_;
    solid_planner planner_;
    region_union union_;
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/text/cells_told_apart.hpp>
#include <typemesh/text/impl/arrange.hpp>
#include <typemesh/text/impl/font_ref.hpp>
#include <typemesh/text/impl/glyph_maker.hpp>
#include <typemesh/text/impl/glyph_merger.hpp>
#include <typemesh/text/impl/glyph_team.hpp>
#include <typemesh/text/impl/place_glyphs.hpp>
#include <typemesh/text/impl/refuse_extremes.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/text/text_options.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The part of a text_mesher that does not depend on the type of its solid: shapes and lays out a text, builds its
/// glyphs and places them. Each policy is called once per glyph or outline, through a table.
///
/// A team, if given, shapes and builds in parallel; null: one worker, the caller. It is a glyph_team; its type is a
/// parameter only so that typemesh::compiled can keep the functions out of other units.
class text_planner {
public:
    font_ref font;
    cached_in cache;
    glyph_maker maker;  ///< makes the glyphs instead of the builder, if it is given; then there is no team

    explicit text_planner(memory source) noexcept
        : builder_{source}, merger_{source}, layout_{source}, run_{source}, glyphs_{source}
    {
    }

    /// The glyphs that were planned last.
    [[nodiscard]] text_glyphs& glyphs() noexcept { return glyphs_; }
    /// The run that plan(text) has made.
    [[nodiscard]] glyph_run& run() noexcept { return run_; }

    /// Ends the previous plan.
    void clear() noexcept { glyphs_.clear(); }

    void trim() noexcept
    {
        builder_.trim();
        merger_.trim();
    }

    /// Shapes and lays out a text, into run(); needs a font. Ends the previous plan.
    template <class Team>
    error layout(text_view text, const text_options& options, const policies& with, Team* team) noexcept;

    /// Plans a run, which may be run(); needs a font. Ends the previous plan.
    template <class Team>
    error plan(const glyph_run& run, const text_options& options, const policies& with, Team* team) noexcept;

private:
    struct call {
        const glyph_run& run;
        const text_options& options;
        const policies& with;
        glyph_team* team;
    };

    static error stop(error e, const policies& with) noexcept
    {
        with.observe(stage::idle);
        return e;
    }

    /// Plans for glyphs that are written up to `reach` em from the origin: see glyph_settings::max_cells.
    error plan_once(const call& asked, double reach) noexcept;

    /// The error if no text can be written with these options, or none.
    [[nodiscard]] error refused(const call& now) const noexcept;

    /// Copies the run's reports.
    void report(const glyph_run& run) noexcept;

    /// Asks an outline step that places where the glyphs stand, and counts those that have no place.
    error find_stands(const call& now) noexcept;

    /// Whether an outline step that places warps any glyph.
    [[nodiscard]] bool has_warped() const noexcept;

    /// Prepares the places of glyphs that differ from place to place, and the unit of depths, which matters for these
    /// and for low walls (corners). In a unit_box low walls are as if depths were in em.
    ///
    /// Fails  error::bad_option "depth_in": in a unit_box, a depth in output units depends on the box of all solids
    error find_places(const call& now) noexcept;

    /// The box of a run's pen positions, in em: drawn_place::text. A run without lines ends at its last origin.
    [[nodiscard]] box pens_of(const glyph_run& run) const noexcept;

    /// Numbers the run's different glyphs; glyphs that are not drawn get no_room. Those that differ from place to place
    /// come last, so that none of them is found again.
    error collect(const glyph_run& run, const text_options& options) noexcept;
    error collect_placed(const glyph_run& run, const text_options& options) noexcept;

    [[nodiscard]] bool is_drawn(const glyph_run& run, std::size_t glyph, const text_options& options) const noexcept
    {
        if (run.glyphs[glyph].missing && !options.draw_missing) return false;
        return glyphs_.stands.empty() || !glyphs_.stands[glyph].left_out;
    }

    /// Whether glyphs are written at pens that are rounded to their grids: see place_glyphs().
    static bool rounds_pens(const text_options& options) noexcept
    {
        return options.merge && options.corners != touching::keep;
    }

    static glyph_settings settings_of(const text_options& options, double reach) noexcept;

    /// Finds or builds each different glyph.
    error build_glyphs(const call& now, const glyph_settings& how) noexcept;

    template <class Find, class Keep>
    error each_glyph(const call& now, const glyph_settings& how, const Find& find, const Keep& keep) noexcept;

    glyph_builder builder_;
    glyph_merger merger_;
    plain_layout layout_;
    glyph_run run_;
    text_glyphs glyphs_;
};

template <class Team>
error text_planner::layout(text_view text, const text_options& options, const policies& with, Team* team) noexcept
{
    clear();
    with.observe(stage::shape);
    if (!font.is_shaper()) return stop(error::not_a_shaper, with);
    shaper_ref shaper = font.shaper();
    if (team != nullptr && !team->shapes_for(font)) team = nullptr;
    const auto laid = layout_(shaper, text, options.shape, options.layout, run_, team);
    return laid ? error{} : stop(laid.error(), with);
}

template <class Find, class Keep>
error text_planner::each_glyph(const call& now, const glyph_settings& how, const Find& find, const Keep& keep) noexcept
{
    const auto keys = glyphs_.different.keys();
    const auto build = [&, keys](std::size_t k, font_ref from, glyph_builder& builder, glyph_store& store,
                                 const policies& with) noexcept -> error {
        const text_glyphs::glyph_place* const at = glyphs_.place_of(k);
        const built_glyph* built = at != nullptr ? nullptr : find(keys[k]);
        if (built == nullptr) {
            drawn_face face = glyphs_.glyph_styles.face_of(from, keys[k].glyph_style);
            policies own_policies = with;
            if (at == nullptr) own_policies.warp = {};
            glyph_settings own = how;
            const solid_place place = at != nullptr ? at->place : solid_place{{}, glyphs_.em_per_depth};
            if (at != nullptr && !glyphs_.stands.empty()) own.stand = &glyphs_.stands[at->glyph];
            const auto draft = maker.make == nullptr
                                   ? builder.build(face, keys[k].id, own, own_policies, place)
                                   : maker.make(maker.self, k, builder, {face, keys[k].id, own, own_policies, place});
            if (!draft) return at != nullptr ? draft.error().at(keys[k].id, at->cluster) : draft.error();
            built = at != nullptr ? store.keep(*draft) : keep(keys[k], *draft, store);
            if (built == nullptr) return error::out_of_memory;
        }
        glyphs_.pinned.set(k, built);
        return {};
    };
    if (now.team == nullptr) {
        for (std::size_t k = 0; k < keys.size(); ++k)
            if (error e = build(k, font, builder_, glyphs_.store, now.with)) return e;
        return {};
    }
    return now.team->each(
        keys.size(), [&](std::size_t k, font_ref from, glyph_builder& builder, glyph_store& store) noexcept {
            no_observer nobody;
            return build(k, from, builder, store,
                         {now.with.flatten, now.with.cut, now.with.raise, nobody, now.with.step, now.with.warp});
        });
}

// If floats must distinguish cells, letters that reach farther from their pens than expected are built again. On the
// coarser grid, some letters may fit that were too large before, and reach still farther.
template <class Team>
error text_planner::plan(const glyph_run& run, const text_options& options, const policies& with, Team* team) noexcept
{
    const call now{run, options, with, team};
    clear();
    if (options.corners == touching::keep) return plan_once(now, 0.0);
    const double units_per_em = font.units_per_em();
    const bool along_axes = options.frame.is_along_axes();
    double expected = reach_of(run, units_per_em);
    for (;;) {  // at most 14 times: the cells halve
        if (error e = plan_once(now, expected)) return e;
        const double reach = reach_of(glyphs_.ink, units_per_em);
        if (cells_told_apart(reach, along_axes) >= cells_told_apart(expected, along_axes)) return {};
        expected = reach + 1.0;
        clear();
    }
}

inline error text_planner::plan_once(const call& asked, double reach) noexcept
{
    const auto& [run, options, given, team] = asked;
    error e = refused(asked);
    if (e) return stop(e, given);
    report(run);
    e = given.step.refused_options();
    if (!e) e = given.raise.refused_options();
    if (!e && given.warp.places()) e = find_stands(asked);
    policies with = given;
    if (glyphs_.turned && !has_warped()) with.warp = {};  // glyphs are built as they are
    const call now{run, options, with, team};
    if (!e) e = find_places(now);
    if (!e) e = glyphs_.glyph_styles.read(run, font);
    if (!e) e = collect(run, options);
    glyph_settings how = settings_of(options, reach);
    if (!e && !with.warp.is_none()) e = with.warp.refused(how.text = pens_of(run));
    if (!e) e = build_glyphs(now, how);
    if (!e && options.merge) e = merger_(glyphs_, run, builder_, font, how, with);
    if (!e) e = place_glyphs(glyphs_, run, rounds_pens(options));
    if (!e) e = arrange(glyphs_, run, options, font.units_per_em(), with.raise);
    if (!e) e = refuse_extremes(glyphs_.placed, glyphs_.bounds, with.raise.heights(), with.raise.heights_name());
    if (e) glyphs_.pinned.release();
    return stop(e, with);
}

inline error text_planner::refused(const call& now) const noexcept
{
    const text_options& options = now.options;
    if (!is_finite(options.tolerance) || !(options.tolerance > 0.0)) return error::bad_tolerance;
    if (!is_finite(options.pixels_per_em) || !(options.pixels_per_em > 0.0) || options.pixels_per_em > 0x1p30)
        return error::bad("pixels_per_em");
    const double largest = options.unit == output_unit::pixels ? 0x1p30 / options.pixels_per_em : 0x1p30;
    if (!is_finite(options.size) || !(options.size > 0.0) || options.size > largest) return error::bad("size");
    const double own = font.units_per_em(), units_per_em = now.run.units_per_em;
    for (const double units : {own, is_zero(units_per_em) ? own : units_per_em})
        if (!is_finite(units) || !(units > 0.0)) return error::bad("units_per_em");
    if (!is_zero(units_per_em) && !same(units_per_em, own)) return error::other_units;
    TYPEMESH_ASSERT(options.frame.is_orthonormal(), "a frame's axes must be unit vectors at right angles");
    if (now.team == nullptr) return {};
    font_ref of_team = now.team->members[0].font;
    TYPEMESH_ASSERT(same(of_team.units_per_em(), own), "the sources of a glyph_workers belong to another font");
    if (of_team.face_count() < font.face_count()) return {error::no_such_face, of_team.face_count()};
    return cache.cache && !cache.cache.has_lock() ? error{error::unlocked_cache} : error{};
}

inline void text_planner::report(const glyph_run& run) noexcept
{
    text_report& report = glyphs_.report;
    report.missing = run.missing + run.parted;
    report.parted = run.parted;
    report.first_missing = run.first_missing < run.first_parted ? run.first_missing : run.first_parted;
    report.first_parted = run.first_parted;
    report.invalid_units = run.invalid_units;
    report.first_invalid_unit = run.first_invalid_unit;
    report.unbroken = run.unbroken;
    report.first_unbroken = run.first_unbroken;
}

inline error text_planner::find_stands(const call& now) noexcept
{
    const auto& [run, options, with, team] = now;
    if (error e = with.warp.refused(pens_of(run))) return e;
    const std::size_t count = run.glyphs.size();
    glyph_stand* const stands = glyphs_.stands.append(count);
    if (stands == nullptr && count != 0) return error::out_of_memory;
    if (error e = with.warp.place(run, font.units_per_em(), stands)) return e;
    text_report& report = glyphs_.report;
    glyphs_.turned = !options.merge && options.corners == touching::keep && !with.raise.plans_in_place();
    for (std::size_t i = 0; i < count; ++i) {
        if (!stands[i].left_out) continue;
        ++report.off_path;
        if (run.glyphs[i].cluster < report.first_off_path) report.first_off_path = run.glyphs[i].cluster;
    }
    return {};
}

inline bool text_planner::has_warped() const noexcept
{
    for (const glyph_stand& s : glyphs_.stands)
        if (s.warped && !s.left_out) return true;
    return false;
}

inline error text_planner::find_places(const call& now) noexcept
{
    const bool solids_differ = now.with.raise.plans_in_place();
    const text_options& options = now.options;
    const double units_per_em = font.units_per_em();
    glyphs_.em_per_font_unit = 1.0 / units_per_em;
    glyphs_.in_place = solids_differ || (!now.with.warp.is_none() && !glyphs_.turned);
    glyphs_.em_per_depth = 1.0;
    if (options.depth_in == depth_unit::em || (!solids_differ && options.corners == touching::keep)) return {};
    if (options.unit == output_unit::unit_box) return solids_differ ? error::bad("depth_in") : error{};
    glyphs_.em_per_depth = 1.0 / (unit_per_font_unit(options, units_per_em, {}) * units_per_em);
    return {};
}

inline box text_planner::pens_of(const glyph_run& run) const noexcept
{
    box pens;
    const double em = 1.0 / font.units_per_em();
    for (const placed_glyph& glyph : run.glyphs)
        if (glyph.cluster != no_cluster && is_finite(glyph.origin.x) && is_finite(glyph.origin.y))
            pens.add(em * glyph.origin);
    for (const text_line& line : run.lines) {
        if (!is_finite(line.advance) || !is_finite(line.origin.x) || !is_finite(line.origin.y)) continue;
        if (run.letters_of(line).empty()) continue;
        pens.add(em * line.origin);
        pens.add(em * (line.origin + (run.is_column(line) ? point{0.0, -line.advance} : point{line.advance, 0.0})));
    }
    return pens;
}

inline error text_planner::collect(const glyph_run& run, const text_options& options) noexcept
{
    const std::size_t count = run.glyphs.size();
    if (count >= glyph_set::no_room) return error::too_large;
    std::uint32_t* numbers = glyphs_.numbers.append(count);
    if (numbers == nullptr && count != 0) return error::out_of_memory;
    const std::size_t glyph_styles = run.glyph_styles.empty() ? 1 : run.glyph_styles.size();
    bool has_places = false;
    for (std::size_t i = 0; i < count; ++i) {
        const placed_glyph& glyph = run.glyphs[i];
        numbers[i] = glyph_set::no_room;
        if (glyph.glyph_style >= glyph_styles)
            return error{error::no_such_glyph_style, run.glyph_styles.size()}.at(glyph.id, glyph.cluster);
        if (!is_drawn(run, i, options)) continue;
        if (glyphs_.in_place || glyphs_.is_warped(i)) {
            has_places = true;
            continue;
        }
        const glyph_key key{glyph.id, glyphs_.glyph_styles.outlines_of(glyph.glyph_style)};
        numbers[i] = options.reuse ? glyphs_.different.number_of(key) : glyphs_.different.append(key);
        if (numbers[i] == glyph_set::no_room) return error::out_of_memory;
    }
    return has_places ? collect_placed(run, options) : error{};
}

inline error text_planner::collect_placed(const glyph_run& run, const text_options& options) noexcept
{
    for (std::uint32_t i = 0; i < run.glyphs.size(); ++i) {
        const placed_glyph& glyph = run.glyphs[i];
        if (!glyphs_.in_place && !glyphs_.is_warped(i)) continue;
        if (!is_drawn(run, i, options)) continue;
        solid_place at = glyphs_.place_at(glyph.origin);
        if (rounds_pens(options)) at.pen = glyph.origin;
        if (!glyphs_.places.push_back({at, glyph.cluster, i})) return error::out_of_memory;
        glyphs_.numbers[i] = glyphs_.different.append({glyph.id, glyphs_.glyph_styles.outlines_of(glyph.glyph_style)});
        if (glyphs_.numbers[i] == glyph_set::no_room) return error::out_of_memory;
    }
    return {};
}

inline glyph_settings text_planner::settings_of(const text_options& options, double reach) noexcept
{
    glyph_settings how{.tolerance = options.tolerance,
                       .fill = options.fill,
                       .max_pieces = options.max_pieces,
                       .max_points = options.max_points};
    if (options.corners == touching::keep) return how;
    how.corners = options.corners;
    how.max_cells = cells_told_apart(reach, options.frame.is_along_axes());
    return how;
}

inline error text_planner::build_glyphs(const call& now, const glyph_settings& how) noexcept
{
    const std::size_t count = glyphs_.different.keys().size();
    const bool is_cached = cache.cache && now.options.reuse && !glyphs_.in_place;
    if (now.team != nullptr) now.with.observe(stage::outline);
    if (now.team != nullptr && (!is_cached || !glyphs_.places.empty())) {
        now.team->begin_plan();
        glyphs_.lent = {&now.team->plans, now.team->plans};
    }
    if (is_cached) {
        const cache_ref kept = cache.cache;
        const std::size_t cached = count - glyphs_.places.size();
        if (!glyphs_.pinned.reserve(count, kept, cached)) return error::out_of_memory;
        policies without_warp = now.with;
        without_warp.warp = {};
        const glyph_context plain = context_of(cache.font, font.variation(), how, without_warp, glyphs_.em_per_depth);
        if (!plain.is_complete()) return error::no_cache_key;
        if (error e = glyphs_.glyph_styles.find_contexts(plain, font)) return e;
        const array_view<const hashed_context> of_style = glyphs_.glyph_styles.contexts();
        return each_glyph(
            now, how,
            [kept, of_style](const glyph_key& key) noexcept {
                return kept.find(of_style[key.glyph_style].context, of_style[key.glyph_style].hash, key.id);
            },
            [kept, of_style](const glyph_key& key, const glyph_draft& draft, glyph_store&) noexcept {
                return kept.keep(of_style[key.glyph_style].context, of_style[key.glyph_style].hash, key.id, draft);
            });
    }
    if (!glyphs_.pinned.reserve(count)) return error::out_of_memory;
    return each_glyph(
        now, how, [](const glyph_key&) noexcept { return static_cast<const built_glyph*>(nullptr); },
        [](const glyph_key&, const glyph_draft& draft, glyph_store& store) noexcept { return store.keep(draft); });
}

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>
#include <typemesh/core/same.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/text/arrange.hpp>
#include <typemesh/text/cells_told_apart.hpp>
#include <typemesh/text/glyph_merger.hpp>
#include <typemesh/text/glyph_workers.hpp>
#include <typemesh/text/lone_worker.hpp>
#include <typemesh/text/mesher_refusals.hpp>
#include <typemesh/text/place_glyphs.hpp>
#include <typemesh/text/plan_workers.hpp>
#include <typemesh/text/policy_kind.hpp>
#include <typemesh/text/refuse_extremes.hpp>
#include <typemesh/text/text_glyphs.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_plan.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Connects the stages: text in, mesh out.
///
///     text_mesher mesher{font};                                 // certified, monotone, extruded with curve normals
///     auto made = mesher.build("Hello world!", into(vertices, indices));
///     if (!made) puts(made.error().message());
///
/// Change one policy by naming it:
///
///     auto flat_text = text_mesher{font}.with(flat{});
///     auto deep_text = text_mesher{font}.with(extruded<>{.depth = 0.5f}).with(two_lines{});
///     auto quick_text = text_mesher{font}.with(cached_in{cache, 1});            // see glyph_cache.hpp
///
/// `font` is an outline source and, for plan(text), a shaper as well; it must outlive the mesher. A glyph that occurs
/// more than once in a text is built once. Memory grows to what the largest text needs and is kept: after warm-up a
/// text of the same size allocates nothing here. A mesher serves one thread at a time.
template <outline_source Font, discretiser Discretiser = certified, triangulator Triangulator = monotone,
          extruder Extruder = extruded<>, stage_observer Observer = no_observer, class Cache = no_cache>
class text_mesher
    : public detail::mesher_refusals<text_mesher<Font, Discretiser, Triangulator, Extruder, Observer, Cache>,
                                     text_plan<Extruder>> {
    using refusals = detail::mesher_refusals<text_mesher, text_plan<Extruder>>;

public:
    using plan_type = text_plan<Extruder>;
    using refusals::build;
    using refusals::plan;
    using refusals::with;

    explicit text_mesher(Font& font, memory source = heap()) noexcept
        : font_{&font}, builder_{source}, merger_{source}, run_{source}, glyphs_{source}
    {
    }

    // The mesher refers to its font: neither a temporary nor a result without its `*` will do.
    text_mesher(const Font&&, memory = heap(), detail::keep_the_font_in_a_variable = {}) = delete;
    template <std::same_as<Font> Made>
    explicit text_mesher(const result<Made>&, memory source = heap()) noexcept
        : builder_{source}, merger_{source}, run_{source}, glyphs_{source}
    {
        (void)refuse_result<Made>();
    }

    /// The same mesher with one policy replaced: a discretiser, a triangulator, an extruder or a stage_observer; or
    /// with a cache for its glyphs, as cached_in (no_cache{}: without one).
    template <class Policy>
    [[nodiscard]] auto with(Policy policy) && noexcept
    {
        constexpr policy_kind kind = kind_of<Policy>();
        if constexpr (kind == policy_kind::discretiser)
            return changed(std::move(policy), triangulator_, extruder_, observer_, cache_);
        else if constexpr (kind == policy_kind::triangulator)
            return changed(discretiser_, std::move(policy), extruder_, observer_, cache_);
        else if constexpr (kind == policy_kind::extruder)
            return changed(discretiser_, triangulator_, std::move(policy), observer_, cache_);
        else if constexpr (kind == policy_kind::observer)
            return changed(discretiser_, triangulator_, extruder_, std::move(policy), cache_);
        else if constexpr (kind == policy_kind::cache)
            return changed(discretiser_, triangulator_, extruder_, observer_, policy);
        else
            return detail::refuse_policy<Policy>(), std::move(*this);
    }

    /// The policies, to change their options between texts.
    [[nodiscard]] Discretiser& discretiser_policy() noexcept { return discretiser_; }
    [[nodiscard]] Triangulator& triangulator_policy() noexcept { return triangulator_; }
    [[nodiscard]] Extruder& extruder_policy() noexcept { return extruder_; }
    [[nodiscard]] Observer& observer() noexcept { return observer_; }

    /// Gives the scratch memory for building glyphs back to its source, after a text of unusual glyphs for example.
    /// Plans stay as they are.
    void trim() noexcept
    {
        builder_.trim();
        merger_.trim();
    }

    /// Shapes, lays out and meshes a text: everything except the writing. Ends the previous plan.
    ///
    /// Glyphs that cannot be built are left out and reported by the plan; empty text and blank glyphs give an empty
    /// mesh.
    ///
    /// Fails  as layout() does; error::bad_tolerance, error::bad_option;
    ///        error::too_large; error::out_of_memory
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options = {}) & noexcept
        requires shaper<Font>
    {
        auto worker = alone();
        return plan_text(text, options, worker);
    }

    /// The same from shaped text; needs no shaper. The run must not change while the plan is used.
    [[nodiscard]] result<plan_type> plan(const glyph_run& run, const text_options& options = {}) & noexcept
    {
        glyphs_.clear();
        auto worker = alone();
        return plan_run(run, options, worker);
    }

    /// Both by several workers (see glyph_workers.hpp), whose sources stand in for the mesher's font when lines are
    /// shaped and glyphs built. The plan is the same, to the bit; of several errors that of the lowest glyph is
    /// returned. Its glyphs lie in the workers, which must outlive it. A cache needs a real lock.
    ///
    /// Policies are called by several threads at once, as const. While glyphs are built the observer sees only
    /// stage::outline. Merging (text_options::merge) is done by one worker.
    template <executor Executor, outline_source Source>
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options,
                                         glyph_workers<Executor, Source>& workers) & noexcept
        requires shaper<Font>
    {
        require_faces<Source>();
        return plan_text(text, options, workers);
    }
    template <executor Executor, outline_source Source>
    [[nodiscard]] result<plan_type> plan(const glyph_run& run, const text_options& options,
                                         glyph_workers<Executor, Source>& workers) & noexcept
    {
        require_faces<Source>();
        glyphs_.clear();
        return plan_run(run, options, workers);
    }

    /// plan() and write() in one: returns the report of what was built, or the error. Nothing reaches the sink if the
    /// plan fails.
    template <class Text, class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<text_report> build(const Text& text, Sink&& sink, const text_options& options = {}) noexcept
    {
        auto made = plan(text, options);
        if (!made) return made.error();
        observer_(stage::extrude);
        const error e = made->write(sink);
        observer_(stage::idle);
        if (e) return e;
        return made->report();
    }

    /// The same by several workers. All of them write the sink if it takes subranges (see ranged_sink).
    template <class Text, class Sink, executor Executor, outline_source Source>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<text_report> build(const Text& text, Sink&& sink, const text_options& options,
                              glyph_workers<Executor, Source>& workers) noexcept
    {
        auto made = plan(text, options, workers);
        if (!made) return made.error();
        observer_(stage::extrude);
        error e;
        if constexpr (ranged_sink<std::remove_reference_t<Sink>>)
            e = made->write(sink, workers.pool());
        else
            e = made->write(sink);
        observer_(stage::idle);
        if (e) return e;
        return made->report();
    }

private:
    template <class Source>
    static constexpr void require_faces() noexcept
    {
        static_assert(face_source<Source> || !face_source<Font>,
                      "typemesh: the mesher's font has several faces, so each worker needs a source of as many.");
    }

    template <outline_source, discretiser, triangulator, extruder, stage_observer, class>
    friend class text_mesher;

    /// What `before` holds, with these policies.
    template <class Before>
    text_mesher(Before&& before, Discretiser d, Triangulator t, Extruder e, Observer w, Cache cache) noexcept
        : font_{before.font_},
          builder_{std::move(before.builder_)},
          merger_{std::move(before.merger_)},
          run_{std::move(before.run_)},
          glyphs_{std::move(before.glyphs_)},
          discretiser_{std::move(d)},
          triangulator_{std::move(t)},
          extruder_{std::move(e)},
          observer_{std::move(w)},
          cache_{cache}
    {
    }

    template <class D, class T, class E, class W, class C>
    auto changed(D d, T t, E e, W w, C cache) noexcept
    {
        return text_mesher<Font, D, T, E, W, C>{std::move(*this), std::move(d), std::move(t),
                                                std::move(e),     std::move(w), cache};
    }

    template <class Observing>
    [[nodiscard]] auto policies_for(Observing& observe) const noexcept
    {
        return policies{discretiser_, triangulator_, extruder_, observe};
    }

    error stop(error e) noexcept
    {
        observer_(stage::idle);
        return e;
    }

    [[nodiscard]] lone_worker<Font, Observer> alone() noexcept { return {*font_, builder_, glyphs_.store, observer_}; }

    // Defined after the class, so that typemesh::compiled can keep them out of other units. Workers are plan_workers;
    // compilers have failed to match definitions with constraints of members' own.
    template <class Workers>
    result<plan_type> plan_text(text_view text, const text_options& options, Workers& workers) noexcept;
    template <class Workers>
    result<plan_type> plan_run(const glyph_run& run, const text_options& options, Workers& workers) noexcept;
    template <class Workers>
    result<plan_type> plan_told_apart(const glyph_run& run, const text_options& options, Workers& workers) noexcept;
    template <class Workers>
    result<plan_type> plan_once(const glyph_run& run, const text_options& options, Workers& workers,
                                double reach) noexcept;

    /// The name of the option to blame for heights that cannot be written.
    static constexpr const char* heights_name() noexcept
    {
        if constexpr (requires(const Extruder& e) { e.depth; })
            return "depth";
        else
            return "heights";
    }

    /// Numbers the run's different glyphs; those that are not drawn get no_room.
    error collect(const glyph_run& run, const text_options& options) noexcept
    {
        const std::size_t count = run.glyphs.size();
        if (count >= glyph_set::no_room) return error::too_large;
        std::uint32_t* numbers = glyphs_.numbers.append(count);
        if (numbers == nullptr && count != 0) return error::out_of_memory;
        const std::size_t looks = run.looks.empty() ? 1 : run.looks.size();
        for (std::size_t i = 0; i < count; ++i) {
            const placed_glyph& glyph = run.glyphs[i];
            numbers[i] = glyph_set::no_room;
            if (glyph.look >= looks) return error{error::no_such_look, run.looks.size()}.at(glyph.id, glyph.cluster);
            if (glyph.missing && !options.draw_missing) continue;
            const glyph_key key{glyph.id, glyphs_.looks.outlines_of(glyph.look)};
            numbers[i] = options.reuse ? glyphs_.different.number_of(key) : glyphs_.different.append(key);
            if (numbers[i] == glyph_set::no_room) return error::out_of_memory;
        }
        return {};
    }

    /// `reach`: how far from the origin glyphs are written, in em.
    static glyph_settings settings_of(const text_options& options, double reach) noexcept
    {
        glyph_settings how{.tolerance = options.tolerance,
                           .fill = options.fill,
                           .most_pieces = options.most_pieces,
                           .most_points = options.most_points};
        if (options.corners == touching::keep) return how;
        how.corners = options.corners;
        how.most_cells = cells_told_apart(reach, options.frame.is_along_axes());
        return how;
    }

    /// Finds or builds each different glyph.
    template <plan_workers<Font> Workers>
    error build_glyphs(const text_options& options, const glyph_settings& how, Workers& workers) noexcept
    {
        const auto keys = glyphs_.different.keys();
        TYPEMESH_ASSERT(same(workers.units_per_em(), font_->units_per_em()),
                        "the sources of a glyph_workers are of another font");
        if constexpr (!Workers::is_alone) observer_(stage::outline);
        if constexpr (!std::is_same_v<Cache, no_cache>) {
            static_assert(Workers::is_alone || !std::is_same_v<decltype(cache_), cached_in<no_lock>>,
                          "typemesh: a glyph_workers needs a glyph_cache with a lock: glyph_cache<mutex_lock> (see "
                          "typemesh/adapt/threads.hpp), or a lock of your own.");
            if (options.reuse) {
                auto& cache = *cache_.cache;
                if (!glyphs_.pinned.reserve(keys.size(), &cache)) return error::out_of_memory;
                const glyph_context plain = context_of(cache_.font, *font_, how, policies_for(observer_));
                if (error e = glyphs_.looks.find_contexts(plain, *font_)) return e;
                const std::span<const hashed_context> of_look = glyphs_.looks.contexts();
                return each_shape(
                    keys, how, workers,
                    [&cache, of_look](const glyph_key& key) noexcept {
                        return cache.find(of_look[key.look].context, of_look[key.look].hash, key.id);
                    },
                    [&cache, of_look](const glyph_key& key, const glyph_draft& draft, glyph_store&) noexcept {
                        return cache.keep(of_look[key.look].context, of_look[key.look].hash, key.id, draft);
                    });
            }
        }
        if (!glyphs_.pinned.reserve(keys.size())) return error::out_of_memory;
        glyphs_.lent.now = workers.begin_plan();
        if (glyphs_.lent.now != nullptr) glyphs_.lent.then = *glyphs_.lent.now;
        return each_shape(
            keys, how, workers, [](const glyph_key&) noexcept { return static_cast<const built_glyph*>(nullptr); },
            [](const glyph_key&, const glyph_draft& draft, glyph_store& store) noexcept { return store.keep(draft); });
    }

    template <class Workers, class Find, class Keep>
    error each_shape(std::span<const glyph_key> keys, const glyph_settings& how, Workers& workers, const Find& find,
                     const Keep& keep) noexcept
    {
        return workers.each(keys.size(),
                            [&](std::size_t k, auto& font, glyph_builder& builder, glyph_store& store,
                                auto& observe) noexcept -> error {
                                const built_glyph* built = find(keys[k]);
                                if (built == nullptr) {
                                    auto face = glyphs_.looks.face_of(font, keys[k].look);
                                    const auto draft = builder.build(face, keys[k].id, how, policies_for(observe));
                                    if (!draft) return draft.error();
                                    built = keep(keys[k], *draft, store);
                                    if (built == nullptr) return error::out_of_memory;
                                }
                                glyphs_.pinned.set(k, built);
                                return {};
                            });
    }

    error merge(const glyph_run& run, const glyph_settings& how) noexcept
    {
        return merger_(glyphs_, run, builder_, *font_, how, policies_for(observer_));
    }

    Font* font_;
    glyph_builder builder_;
    glyph_merger merger_;
    glyph_run run_;
    text_glyphs glyphs_;
    Discretiser discretiser_{};
    Triangulator triangulator_{};
    Extruder extruder_{};
    Observer observer_{};
    Cache cache_{};
};

template <outline_source Font, discretiser D, triangulator T, extruder E, stage_observer O, class C>
template <class Workers>
auto text_mesher<Font, D, T, E, O, C>::plan_text(text_view text, const text_options& options, Workers& workers) noexcept
    -> result<plan_type>
{
    glyphs_.clear();
    observer_(stage::shape);
    if (error e = workers.layout(*font_, text, options.shape, options.layout, run_)) return stop(e);
    return plan_run(run_, options, workers);
}

template <outline_source Font, discretiser D, triangulator T, extruder E, stage_observer O, class C>
template <class Workers>
auto text_mesher<Font, D, T, E, O, C>::plan_run(const glyph_run& run, const text_options& options,
                                                Workers& workers) noexcept -> result<plan_type>
{
    auto made = plan_told_apart(run, options, workers);
    if constexpr (refitting_extruder<E>) {
        if (!made) return made;
        const E asked = extruder_;
        bool refitted = false;
        for (const drawn_glyph& s : glyphs_.records)
            refitted = extruder_.refit(s.built->template planned<E>().form) || refitted;
        if (refitted) {
            glyphs_.clear();
            made = plan_told_apart(run, options, workers);
        }
        extruder_ = asked;
    }
    return made;
}

// Where floats are to tell cells apart, letters that reach farther from their pens than was thought are built again.
template <outline_source Font, discretiser D, triangulator T, extruder E, stage_observer O, class C>
template <class Workers>
auto text_mesher<Font, D, T, E, O, C>::plan_told_apart(const glyph_run& run, const text_options& options,
                                                       Workers& workers) noexcept -> result<plan_type>
{
    if (options.corners == touching::keep) return plan_once(run, options, workers, 0.0);
    const double units_per_em = font_->units_per_em(), expected = reach_of(run, units_per_em);
    auto made = plan_once(run, options, workers, expected);
    if (!made) return made;
    const double reach = reach_of(glyphs_.ink, units_per_em);
    const bool along_axes = options.frame.is_along_axes();
    if (cells_told_apart(reach, along_axes) >= cells_told_apart(expected, along_axes)) return made;
    glyphs_.clear();
    return plan_once(run, options, workers, reach + 1.0);
}

template <outline_source Font, discretiser D, triangulator T, extruder E, stage_observer O, class C>
template <class Workers>
auto text_mesher<Font, D, T, E, O, C>::plan_once(const glyph_run& run, const text_options& options, Workers& workers,
                                                 double reach) noexcept -> result<plan_type>
{
    if (!is_finite(options.tolerance) || !(options.tolerance > 0.0)) return stop(error::bad_tolerance);
    if (!is_finite(options.pixels_per_em) || !(options.pixels_per_em > 0.0) || options.pixels_per_em > 0x1p30)
        return stop(error::bad("pixels_per_em"));
    const double largest = options.unit == output_unit::pixels ? 0x1p30 / options.pixels_per_em : 0x1p30;
    if (!is_finite(options.size) || !(options.size > 0.0) || options.size > largest) return stop(error::bad("size"));
    const double units_per_em = font_->units_per_em();
    for (const double units : {units_per_em, is_zero(run.units_per_em) ? units_per_em : run.units_per_em})
        if (!is_finite(units) || !(units > 0.0)) return stop(error::bad("units_per_em"));
    if (!is_zero(run.units_per_em) && !same(run.units_per_em, units_per_em)) return stop(error::other_units);
    TYPEMESH_ASSERT(options.frame.is_orthonormal(), "a frame's axes must be unit vectors at right angles");

    text_report& report = glyphs_.report;
    report.missing = run.missing + run.parted;
    report.parted = run.parted;
    report.first_missing = run.first_missing < run.first_parted ? run.first_missing : run.first_parted;
    report.first_parted = run.first_parted;
    report.invalid_units = run.invalid_units;
    report.first_invalid_unit = run.first_invalid_unit;
    report.unbroken = run.unbroken;
    report.first_unbroken = run.first_unbroken;

    error e = refused_options(extruder_);
    if (!e) e = glyphs_.looks.read(run, *font_);
    if (!e) e = collect(run, options);
    const glyph_settings how = settings_of(options, reach);
    if (!e) e = build_glyphs(options, how, workers);
    if (!e && options.merge) e = merge(run, how);
    if (!e) e = place_glyphs(glyphs_, run, options.merge && options.corners != touching::keep);
    const height_range heights = extruder_.heights();
    if (!e) e = arrange(glyphs_, run, options, units_per_em, extruder_);
    if (!e) e = refuse_extremes(glyphs_.placed, glyphs_.bounds, heights, heights_name());
    if (e) {
        glyphs_.pinned.release();
        return stop(e);
    }
    observer_(stage::idle);
    return plan_type{glyphs_, run, extruder_};
}

template <class Font>
text_mesher(Font&) -> text_mesher<Font>;
template <class Font>
text_mesher(Font&, memory) -> text_mesher<Font>;
template <class Font>
text_mesher(const Font&&) -> text_mesher<Font>;  // chosen only to be refused: see the deleted constructor

template <class Font>
text_mesher(const result<Font>&, memory = heap()) -> text_mesher<Font>;

}  // namespace typemesh::inline TYPEMESH_ABI

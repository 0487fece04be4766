// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/stored_policy.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/text/glyph_workers.hpp>
#include <typemesh/text/impl/mesher_refusals.hpp>
#include <typemesh/text/impl/text_planner.hpp>
#include <typemesh/text/policy_kind.hpp>
#include <typemesh/text/text_plan.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

template <extruder Solid>
class level_mesher;

/// Edits a run between layout and meshing: see text_mesher::plan().
template <class E>
concept run_edit = std::is_nothrow_invocable_v<E&, glyph_run&>;

/// Connects the stages: text in, mesh out.
///
///     text_mesher mesher{font};                                 // certified, monotone, extruded with curve normals
///     auto made = mesher.build("Hello world!", into(vertices, indices));
///     if (!made) puts(made.error().message());
///
/// Policies, a glyph_cache and a memory source follow the font, in any order:
///
///     text_mesher flat_text{font, flat{}};
///     text_mesher deep_text{font, extruded<>{.depth = 0.5f}, two_lines{}};
///     text_mesher bold_text{font, embolden{.by = 0.02f}};       // a step before the solid, see region_step.hpp
///     text_mesher round_text{font, warped{arc{.degrees = 90}}}; // a step before all others, see outline_step.hpp
///     text_mesher ring_text{font, on_path{&ring}};              // likewise, see on_path.hpp
///     text_mesher quick_text{font, cached_in{cache, 1}};        // see glyph_cache.hpp
///
/// The type names only the solid, because the solid writes each vertex. The other policies are called once per glyph
/// and can be replaced at any time:
///
///     struct hud {
///         text_mesher<flat> mesher;                             // has no font yet
///         ...
///         mesher.use(font);
///         mesher.use(constrained_delaunay{});
///
/// one_of.hpp chooses the solid at run time.
///
/// `font` is an outline source and, for plan(text), also a shaper; it must outlive the mesher. A glyph that occurs more
/// than once in a text is built once. Memory grows to the needs of the largest text and is kept: after warm-up, a text
/// of this size allocates nothing here. Policies are stored in the mesher: at most 64 bytes each.
///
/// Move-only. A mesher serves one thread at a time.
template <extruder Solid = extruded<>>
class text_mesher : public detail::mesher_refusals<text_mesher<Solid>, text_plan<Solid>> {
    using refusals = detail::mesher_refusals<text_mesher, text_plan<Solid>>;

public:
    using plan_type = text_plan<Solid>;
    using refusals::build;
    using refusals::plan;
    using refusals::with;

    /// Without a font: plan() fails until use() supplies one.
    explicit text_mesher(memory source = heap()) noexcept : planner_{source} {}

    /// Options follow the font: policies, cached_in, and the memory source.
    template <outline_source Font, class... Option, detail::takes<Solid, Option...> = 0>
    explicit text_mesher(Font& font, Option... options) noexcept : planner_{detail::memory_among(options...)}
    {
        static_assert(!(std::same_as<Option, cached_in> || ...) || (detail::cacheable_option<Option> && ...),
                      "typemesh: a policy with data members needs `typemesh::option_bits cache_key() const noexcept` "
                      "before a glyph_cache can keep its glyphs, which distinguishes glyphs by it; "
                      "see typemesh/core/option_bits.hpp.");
        static_assert(detail::is_given_once<Option...>,
                      "typemesh: this mesher has two policies of one kind (two triangulators, say): leave out one.");
        planner_.font = font_ref{font};
        (take(std::move(options)), ...);
    }

    // The mesher refers to its font: neither a temporary nor a result without its `*` is accepted.
    template <outline_source Font, class... Option>
    explicit text_mesher(const Font&&, Option..., detail::keep_the_font_in_a_variable = {}) = delete;
    template <class Font, class... Option>
    explicit text_mesher(const result<Font>&, Option... options) noexcept : planner_{detail::memory_among(options...)}
    {
        (void)refuse_result<Font>();
    }

    /// Returns the mesher with one option replaced: a policy of any kind, or cached_in (no_cache{} removes the cache).
    /// Another solid changes the mesher's type.
    template <class Option>
    [[nodiscard]] auto with(Option option) && noexcept
    {
        if constexpr (kind_of<Option>() == policy_kind::extruder && !std::same_as<Option, Solid>) {
            return text_mesher<Option>{std::move(*this), std::move(option)};
        } else {
            take(std::move(option));
            return std::move(*this);
        }
    }

    /// Replaces the font, which must outlive the mesher, or one option of the mesher. This invalidates the plan.
    template <outline_source Font>
    void use(Font& font) noexcept
    {
        planner_.clear();
        planner_.font = font_ref{font};
    }
    template <class Option>
        requires(!outline_source<Option> && !is_result<Option>)
    void use(Option option) noexcept
    {
        planner_.clear();
        take(std::move(option));
    }
    template <outline_source Font>
    detail::keep_the_font_in_a_variable use(const Font&&) = delete;
    template <class Font>
    void use(const result<Font>&) noexcept
    {
        (void)refuse_result<Font>();
    }

    /// The solid, for changing its options between texts. A plan keeps the options with which it was made.
    [[nodiscard]] Solid& solid() noexcept { return solid_; }

    /// The discretiser, triangulator, steps or observer, for changing its options between texts or reading the data
    /// that it gathered. Null if the mesher's policy has another type.
    template <class Policy>
    [[nodiscard]] Policy* policy() noexcept
    {
        constexpr policy_kind kind = kind_of<Policy>();
        if constexpr (kind == policy_kind::discretiser)
            return discretiser_.template get<Policy>();
        else if constexpr (kind == policy_kind::triangulator)
            return triangulator_.template get<Policy>();
        else if constexpr (kind == policy_kind::step)
            return step_.template get<Policy>();
        else if constexpr (kind == policy_kind::outline_step)
            return warp_.template get<Policy>();
        else if constexpr (kind == policy_kind::observer)
            return observer_.template get<Policy>();
        else
            return detail::refuse_policy<Policy>(), nullptr;
    }

    /// Returns the scratch memory for building glyphs to its source, for example after a text with unusual glyphs.
    /// Plans stay valid.
    void trim() noexcept { planner_.trim(); }

    /// Shapes, lays out and meshes a text: everything except the writing. This invalidates the previous plan.
    ///
    /// Glyphs that cannot be built are left out, and the plan reports them. Empty text and blank glyphs give an empty
    /// mesh.
    ///
    /// Fails  error::no_font, error::not_a_shaper; as layout() does; error::bad_tolerance, error::bad_option;
    ///        error::no_cache_key; error::too_large; error::out_of_memory
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options = {}) & noexcept
    {
        return plan_text(text, options, nullptr);
    }

    /// Plans a text whose run `edit` may change between layout and meshing: it can move glyphs, remove them, or give
    /// them another style. Everything that layout() reported about the text (missing glyphs and so on) is kept. An
    /// invalid run is refused, like an invalid run of your own.
    ///
    ///     mesher.plan("wave", {}, [](glyph_run& run) noexcept {
    ///         for (placed_glyph& g : run.glyphs) g.origin.y += 50.0 * std::sin(g.origin.x / 100.0);
    ///     });
    template <run_edit Edit>
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options, Edit&& edit) & noexcept
    {
        return plan_text(text, options, nullptr, edit);
    }

    /// Plans shaped text, and needs no shaper. The run must not change while the plan is used.
    [[nodiscard]] result<plan_type> plan(const glyph_run& run, const text_options& options = {}) & noexcept
    {
        return plan_run(run, options, nullptr);
    }

    /// These overloads plan with several workers (see glyph_workers.hpp). The workers' sources replace the mesher's
    /// font for shaping lines and building glyphs. The plan is bit for bit the plan of one worker. If several glyphs
    /// fail, the error of the first of these glyphs is returned. The workers store the plan's glyphs and must outlive
    /// the plan.
    ///
    /// Several threads call the policies, which are const, at once. While glyphs are built, the observer sees only
    /// stage::outline. One worker merges glyphs (text_options::merge).
    ///
    /// Fails  also with error::unlocked_cache, and with error::no_such_face if the sources have fewer faces than the
    ///        font
    template <executor Executor, outline_source Source>
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options,
                                         glyph_workers<Executor, Source>& workers) & noexcept
    {
        return plan_text(text, options, &workers.team());
    }
    template <executor Executor, outline_source Source, run_edit Edit>
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options,
                                         glyph_workers<Executor, Source>& workers, Edit&& edit) & noexcept
    {
        return plan_text(text, options, &workers.team(), edit);
    }
    template <executor Executor, outline_source Source>
    [[nodiscard]] result<plan_type> plan(const glyph_run& run, const text_options& options,
                                         glyph_workers<Executor, Source>& workers) & noexcept
    {
        return plan_run(run, options, &workers.team());
    }

    /// plan() and write() in one: returns the report of the built text, or the error. If the plan fails, nothing
    /// reaches the sink. Finds letters if the sink wants letter data.
    template <class Text, class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<text_report> build(const Text& text, Sink&& sink, const text_options& options = {}) noexcept
    {
        auto made = plan(text, options);
        if (!made) return made.error();
        if (error e = letters_for<std::remove_reference_t<Sink>::wants>(*made, text, options)) return e;
        return finish(*made, made->write(observed(sink)));
    }

    /// plan() and write() in one with several workers. All workers write the sink if the sink takes subranges (see
    /// ranged_sink).
    template <class Text, class Sink, executor Executor, outline_source Source>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<text_report> build(const Text& text, Sink&& sink, const text_options& options,
                              glyph_workers<Executor, Source>& workers) noexcept
    {
        auto made = plan(text, options, workers);
        if (!made) return made.error();
        if (error e = letters_for<std::remove_reference_t<Sink>::wants>(*made, text, options)) return e;
        if constexpr (ranged_sink<std::remove_reference_t<Sink>>)
            return finish(*made, made->write(observed(sink), workers.pool()));
        else
            return finish(*made, made->write(observed(sink)));
    }

private:
    template <extruder>
    friend class text_mesher;
    template <extruder>
    friend class level_mesher;

    /// A mesher with the font and the options of `before`, and this solid.
    template <class Before>
    text_mesher(text_mesher<Before>&& before, Solid solid) noexcept
        : planner_{std::move(before.planner_)},
          discretiser_{std::move(before.discretiser_)},
          triangulator_{std::move(before.triangulator_)},
          step_{std::move(before.step_)},
          warp_{std::move(before.warp_)},
          observer_{std::move(before.observer_)},
          solid_{std::move(solid)}
    {
    }

    struct leave_run {
        void operator()(glyph_run&) const noexcept {}
    };

    template <class Option>
    void take(Option option) noexcept
    {
        constexpr policy_kind kind = kind_of<Option>();
        if constexpr (kind == policy_kind::discretiser)
            discretiser_ = std::move(option);
        else if constexpr (kind == policy_kind::triangulator)
            triangulator_ = std::move(option);
        else if constexpr (kind == policy_kind::step)
            step_ = std::move(option);
        else if constexpr (kind == policy_kind::outline_step)
            warp_ = std::move(option);
        else if constexpr (kind == policy_kind::observer)
            observer_ = std::move(option);
        else if constexpr (kind == policy_kind::extruder) {
            static_assert(std::is_convertible_v<Option, Solid>,
                          "typemesh: the type of this mesher names another solid. To choose one while the program "
                          "runs, name all of them: text_mesher<one_of<flat, extruded<>>>.");
            if constexpr (std::is_convertible_v<Option, Solid>) solid_ = std::move(option);
        } else if constexpr (std::same_as<Option, cached_in>)
            planner_.cache = option;
        else if constexpr (std::same_as<Option, no_cache>)
            planner_.cache = {};
        else if constexpr (!std::same_as<Option, memory>)
            detail::refuse_policy<Option>();
    }

    [[nodiscard]] policies all_policies() noexcept
    {
        return {discretiser_.ref(), triangulator_.ref(), solid_, observer_.ref(), step_.ref(), warp_.ref()};
    }

    /// Finds the letters if the vertices want to know them.
    template <attribute Wants, class Text>
    [[nodiscard]] static error letters_for(const plan_type& made, const Text& text,
                                           const text_options& options) noexcept
    {
        if constexpr (has(Wants, letter_attributes)) {
            static_assert(std::is_convertible_v<const Text&, text_view>,
                          "typemesh: a vertex wants letter data, and a run does not have its text: make a plan, call "
                          "find_letters(text), then write().");
            return made.find_letters(text, {.down = options.shape.direction == direction::top_to_bottom}).error();
        } else {
            return {};
        }
    }

    template <class Sink>
    [[nodiscard]] Sink& observed(Sink& sink) noexcept
    {
        observer_.ref()(stage::extrude);
        return sink;
    }
    [[nodiscard]] result<text_report> finish(const plan_type& made, const result<void>& written) noexcept
    {
        observer_.ref()(stage::idle);
        if (!written) return written.error();
        return made.report();
    }

    template <class Edit = leave_run>
    result<plan_type> plan_text(text_view text, const text_options& options, glyph_team* team,
                                Edit&& edit = {}) noexcept
    {
        if (!planner_.font) return error::no_font;
        if (error e = planner_.layout(text, options, all_policies(), team)) return e;
        edit(planner_.run());
        return plan_run(planner_.run(), options, team);
    }

    result<plan_type> plan_run(const glyph_run& run, const text_options& options, glyph_team* team) noexcept
    {
        if (!planner_.font) return error::no_font;
        if (options.depth_in == depth_unit::output && measures_in_em(solid_)) return error::bad("depth_in");
        if (error e = planner_.plan(run, options, all_policies(), team)) return e;
        if constexpr (refuses_texts<Solid>)
            if (!planner_.glyphs().records.empty())
                if (error e = solid_.refused_text(planner_.glyphs().textured_in_em())) return e;
        if constexpr (refitting_extruder<Solid>) {
            const Solid wanted = solid_;
            bool refitted = false;
            for (const drawn_glyph& s : planner_.glyphs().records)
                refitted = solid_.refit(s.built->template planned<Solid>().form) || refitted;
            const error e = refitted ? planner_.plan(run, options, all_policies(), team) : error{};
            plan_type made{planner_.glyphs(), run, std::exchange(solid_, wanted)};
            if (e) return e;
            return made;
        } else {
            return plan_type{planner_.glyphs(), run, solid_};
        }
    }

    text_planner planner_;
    stored_policy<discretiser_ref> discretiser_{certified{}};
    stored_policy<triangulator_ref> triangulator_{monotone{}};
    stored_policy<region_step_ref> step_{no_step{}};
    stored_policy<outline_step_ref> warp_{no_outline_step{}};
    stored_policy<observer_ref> observer_{no_observer{}};
    Solid solid_{};
};

text_mesher() -> text_mesher<>;
text_mesher(memory) -> text_mesher<>;
template <class Font, class... Option>
text_mesher(Font&, Option...) -> text_mesher<detail::solid_among<Option...>>;
template <class Font, class... Option>
text_mesher(const Font&&, Option...) -> text_mesher<detail::solid_among<Option...>>;  // chosen only to be refused

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/glyph/glyph_levels.hpp>
#include <typemesh/text/impl/glyph_maker.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_plan.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Plans the levels of detail of a text: first the finest, then coarser ones. Each glyph is filled once; a coarser
/// level drops points of the level before.
///
///     text_mesher mesher{font, extruded<>{.depth = 0.1f}};
///     level_mesher levels{mesher};
///     auto level = levels.plan("Hello", {.tolerance = quality::high});             // level 0
///     if (level) level->write(into(vertices[0], indices[0]));
///     for (std::size_t k = 1; level && k < 4; ++k) {
///         level = levels.coarser(tolerances[k]);                         // {0, 1.0 / 160, 1.0 / 60, 1.0 / 25}
///         if (level) level->write(into(vertices[k], indices[k]));
///     }
///
/// coarsened.hpp says what the levels promise: no point moves; corners and normals stay, and so do
/// holes, gaps and strokes. The mesher's policies make each level; a step before the solid, such as embolden,
/// changes the level's region. The mesher's cache is not used.
///
/// It refers to a mesher, which must outlive it. The plans are plans of this mesher, so each ends the one before.
/// Memory is kept for the next text.
template <extruder Solid = extruded<>>
class level_mesher {
public:
    using plan_type = text_plan<Solid>;

    explicit level_mesher(text_mesher<Solid>& mesher, memory source = heap()) noexcept
        : mesher_{&mesher}, levels_{source}, refusals_{source}
    {
    }

    /// Plans the finest level, at the tolerance of the options. The text may be a glyph_run, which must not change
    /// until the last level is planned.
    ///
    /// Fails  as text_mesher::plan() does; error::bad_option: the options ask for merging ("merge")
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options = {}) noexcept
    {
        if (error e = begin(options)) return e;
        return level([&] { return mesher_->plan_text(text, options_, nullptr); }, &mesher_->planner_.run());
    }
    [[nodiscard]] result<plan_type> plan(const glyph_run& run, const text_options& options = {}) noexcept
    {
        if (error e = begin(options)) return e;
        return level([&] { return mesher_->plan_run(run, options_, nullptr); }, &run);
    }
    result<plan_type> plan(glyph_run&& run, const text_options& options = {}) noexcept = delete;  // coarser() reads it

    /// Plans the next level of the same text: within a tolerance, in em, which is at least as large as the one before.
    ///
    /// Fails  error::bad_option: there is no finer level, because plan() has failed, was not called, or another text
    ///        was planned since ("level_mesher::plan"); the tolerance is smaller than before, or not finite
    ///        ("tolerance"); then as text_mesher::plan() does
    /// Cost   O(n log n) for the n points of the level before
    [[nodiscard]] result<plan_type> coarser(double tolerance) noexcept
    {
        if (run_ == nullptr || mesher_->planner_.glyphs().generation.number != generation_)
            return error::bad("level_mesher::plan");
        if (!is_finite(tolerance) || tolerance < tolerance_) return error::bad("tolerance");
        tolerance_ = tolerance;
        ++number_;
        return level([&] { return mesher_->plan_run(*run_, options_, nullptr); }, run_);
    }

    /// The number of the level that was planned last; 0 is the finest.
    [[nodiscard]] std::uint32_t number() const noexcept { return number_; }

private:
    /// Of each different glyph.
    struct refusal {
        error reason;
        corner_parting parted;
        std::uint32_t level = 0;  // the last level that was made
    };

    [[nodiscard]] error begin(const text_options& options) noexcept
    {
        run_ = nullptr;
        if (options.merge) return error::bad("merge");
        options_ = options;
        tolerance_ = options.tolerance;
        number_ = 0;
        return {};
    }

    template <class Plan>
    [[nodiscard]] result<plan_type> level(const Plan& plan, const glyph_run* run) noexcept
    {
        text_planner& planner = mesher_->planner_;
        planner.maker = {make, this};
        const cached_in cache = std::exchange(planner.cache, cached_in{});
        auto made = plan();
        planner.maker = {};
        planner.cache = cache;
        run_ = made ? run : nullptr;
        generation_ = planner.glyphs().generation.number;
        return made;
    }

    /// See glyph_maker.
    static result<glyph_draft> make(void* self, std::size_t number, glyph_builder& builder,
                                    const wanted_glyph& wanted) noexcept
    {
        level_mesher& own = *static_cast<level_mesher*>(self);
        return own.number_ == 0 ? own.fill(number, builder, wanted) : own.coarsen(number, builder, wanted);
    }

    [[nodiscard]] result<glyph_draft> fill(std::size_t number, glyph_builder& builder,
                                           const wanted_glyph& wanted) noexcept
    {
        if (number == 0) {
            levels_.clear();
            refusals_.clear();
        }
        const policies& with = wanted.with;
        const auto filled =
            builder.build_region(wanted.face, wanted.id, wanted.how, with, with.warp, wanted.place.origin);
        if (!filled && !glyph_builder::concerns_the_glyph_alone(filled.error())) return filled.error();
        if (!refusals_.push_back({filled.error(), builder.parting(), 0})) return error::out_of_memory;
        if (error e = levels_.keep(filled ? *filled : region{})) return e;
        if (!filled) return refused(filled.error());
        return builder.raise({*filled, builder.triangles(), builder.parting()}, with, wanted.place);
    }

    [[nodiscard]] result<glyph_draft> coarsen(std::size_t number, glyph_builder& builder,
                                              const wanted_glyph& wanted) noexcept
    {
        if (number >= refusals_.size()) return error::bad("level_mesher::plan");
        refusal& own = refusals_[number];
        if (own.reason) return refused(own.reason);
        // A text that is planned again, because bevels have to fit, does not become coarser again.
        const auto made = levels_.coarser(number, own.level == number_ ? 0.0 : tolerance_, wanted.with.cut);
        if (!made) return made.error();
        own.level = number_;
        return builder.raise({*made, levels_.triangles(), own.parted}, wanted.with, wanted.place);
    }

    [[nodiscard]] static glyph_draft refused(const error& reason) noexcept
    {
        glyph_draft made;
        made.refusal = reason;
        return made;
    }

    text_mesher<Solid>* mesher_;
    glyph_levels levels_;
    buffer<refusal> refusals_;
    text_options options_;
    const glyph_run* run_ = nullptr;  // null: there is no level
    double tolerance_ = 0.0;          // of the last level, in em
    std::uint32_t number_ = 0;
    std::uint64_t generation_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI

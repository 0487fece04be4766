// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/text/cap_outline.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_plan.hpp>
#include <typemesh/text/text_shapes.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh {

/// Joins the stages: text in, mesh out.
///
///     text_mesher mesher{font};                                 // certified, monotone, extruded with curve normals
///     auto made = mesher.build("Hello world!", into(vertices, indices));
///     if (!made) puts(made.error().message());
///
/// Change one policy by naming it:
///
///     auto flat_text = text_mesher{font}.with(flat{});
///     auto deep_text = text_mesher{font}.with(extruded<>{.depth = 0.5f}).with(two_lines{});
///
/// `font` is an outline source and, for plan(text), a shaper as well; it is referred to and must outlive the mesher.
/// Memory grows to what the largest text needs and stays: after warm-up a text of the same size allocates nothing here.
/// One mesher a thread.
template <outline_source Font, discretiser Discretiser = certified, triangulator Triangulator = monotone,
          extruder Extruder = extruded<>, stage_observer Observer = no_observer>
class text_mesher {
public:
    using plan_type = text_plan<Extruder>;

    explicit text_mesher(Font& font, memory source = heap()) noexcept
        : font_{&font}, space_{source}, outline_{source}, loops_{source}, run_{source}, shapes_{source}
    {
    }

    text_mesher(const Font&&, memory = heap()) = delete;  // the mesher refers to its font: a temporary will not do

    /// The same mesher with one policy exchanged: a discretiser, a triangulator, an extruder or a stage_observer.
    template <class Policy>
    [[nodiscard]] auto with(Policy policy) && noexcept
    {
        if constexpr (discretiser<Policy>)
            return changed(std::move(policy), triangulator_, extruder_, observer_);
        else if constexpr (triangulator<Policy>)
            return changed(discretiser_, std::move(policy), extruder_, observer_);
        else if constexpr (extruder<Policy>)
            return changed(discretiser_, triangulator_, std::move(policy), observer_);
        else {
            static_assert(stage_observer<Policy>,
                          "typemesh: with() takes a discretiser, a triangulator, an extruder or a stage_observer, and "
                          "this type is none of them; static_assert the concept that it should model to see what it "
                          "lacks.");
            return changed(discretiser_, triangulator_, extruder_, std::move(policy));
        }
    }

    /// The policies, to change their options between texts.
    [[nodiscard]] Discretiser& discretiser_policy() noexcept { return discretiser_; }
    [[nodiscard]] Triangulator& triangulator_policy() noexcept { return triangulator_; }
    [[nodiscard]] Extruder& extruder_policy() noexcept { return extruder_; }
    [[nodiscard]] Observer& observer() noexcept { return observer_; }

    /// Shapes, lays out and meshes a text: everything but the writing. Ends the plan before it.
    ///
    /// Glyphs that cannot be built are left out and reported by the plan; empty text and blank glyphs give an empty
    /// mesh.
    /// Fails  what layout() fails with (error::mixed_direction, ...); error::bad_tolerance, error::bad_option;
    ///        error::too_large; error::out_of_memory
    [[nodiscard]] result<plan_type> plan(text_view text, const text_options& options = {}) & noexcept
        requires shaper<Font>
    {
        shapes_.clear();
        observer_(stage::shape);
        if (error e = layout(*font_, text, options.shape, options.layout, run_)) return stop(e);
        return plan_run(run_, options);
    }

    /// The same from shaped text; no shaper is needed. The run must stay as it is while the plan is used.
    [[nodiscard]] result<plan_type> plan(const glyph_run& run, const text_options& options = {}) & noexcept
    {
        shapes_.clear();
        return plan_run(run, options);
    }

    // A plan refers to its run and to its mesher: temporaries would leave it in the air.
    result<plan_type> plan(glyph_run&& run, const text_options& options = {}) & = delete;
    result<plan_type> plan(text_view text, const text_options& options = {}) && = delete;
    result<plan_type> plan(const glyph_run& run, const text_options& options = {}) && = delete;

    /// plan() and write() in one: the report of what was built, or the error. Nothing reaches the sink if the plan
    /// fails.
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

private:
    template <outline_source, discretiser, triangulator, extruder, stage_observer>
    friend class text_mesher;

    text_mesher(Font* font, workspace&& space, outline&& o, contours&& c, glyph_run&& run, text_shapes&& shapes,
                Discretiser d, Triangulator t, Extruder e, Observer w) noexcept
        : font_{font},
          space_{std::move(space)},
          outline_{std::move(o)},
          loops_{std::move(c)},
          run_{std::move(run)},
          shapes_{std::move(shapes)},
          discretiser_{std::move(d)},
          triangulator_{std::move(t)},
          extruder_{std::move(e)},
          observer_{std::move(w)}
    {
    }

    template <class D, class T, class E, class W>
    auto changed(D d, T t, E e, W w) noexcept
    {
        return text_mesher<Font, D, T, E, W>{
            font_,           std::move(space_),  std::move(outline_), std::move(loops_),
            std::move(run_), std::move(shapes_), std::move(d),        std::move(t),
            std::move(e),    std::move(w)};
    }

    error stop(error e) noexcept
    {
        observer_(stage::idle);
        return e;
    }

    result<plan_type> plan_run(const glyph_run& run, const text_options& options) noexcept
    {
        if (!is_finite(options.tolerance) || !(options.tolerance > 0.0)) return stop(error::bad_tolerance);
        if (!is_finite(options.pixels_per_em) || !(options.pixels_per_em > 0.0) || options.pixels_per_em > 0x1p30)
            return stop(error::bad_option);
        if (!is_finite(run.units_per_em) || !(run.units_per_em > 0.0)) return stop(error::bad_option);

        TYPEMESH_ASSERT(run.units_per_em == font_->units_per_em(),
                        "the glyph_run was made for a font of other units per em");
        TYPEMESH_ASSERT(options.frame.is_orthonormal(), "a frame's axes must be unit vectors at right angles");

        text_report& report = shapes_.report;
        report.missing = run.missing;
        report.first_missing = run.first_missing;
        report.invalid_units = run.invalid_units;
        report.first_invalid_unit = run.first_invalid_unit;

        std::size_t line = 0;
        for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
            while (line + 1 < run.lines.size() && i >= run.lines[line + 1].first_glyph) ++line;
            const placed_glyph& glyph = run.glyphs[i];
            ++report.glyphs;
            if (glyph.missing && !options.draw_missing) continue;
            if (error e = add(glyph, static_cast<std::uint32_t>(line), options)) {
                if (!concerns_the_glyph_alone(e)) return stop(e);
                if (report.refused++ == 0) report.first_refusal = e.at(glyph.id, glyph.cluster);
            }
        }
        if (error e = arrange(run, options)) return stop(e);
        observer_(stage::idle);
        return plan_type{shapes_, run, extruder_};
    }

    /// Everything for one glyph. After an error the shapes are as they were.
    error add(const placed_glyph& glyph, std::uint32_t line, const text_options& options) noexcept
    {
        const double units_per_em = font_->units_per_em();
        if (!is_finite(glyph.origin.x) || !is_finite(glyph.origin.y)) return error::outline_not_finite;
        constexpr double farthest = 0x1p80;  // font units; 32-bit floats do not reach much farther in any unit
        if (std::fabs(glyph.origin.x) > farthest || std::fabs(glyph.origin.y) > farthest)
            return error::outline_beyond_grid;
        observer_(stage::outline);
        if (error e = record(*font_, glyph.id, outline_)) return e;
        if (outline_.curves.empty()) return blank();

        const auto fitting = grid::fitting(units_per_em, outline_.bounds);
        if (!fitting) return fitting.error();

        const auto triangles_before = shapes_.triangles.size(), sides_before = shapes_.sides.size();
        const auto undo = [&](error e) noexcept {
            shapes_.triangles.truncate(triangles_before);
            shapes_.sides.truncate(sides_before);
            return e;
        };
        const auto filled =
            cap_outline(outline_, options.fill.value_or(outline_.rule), discretiser_, options.tolerance * units_per_em,
                        *fitting, triangulator_, space_, loops_, shapes_.triangles, observer_);
        if (!filled) return undo(filled.error());
        if (filled->points().empty()) return blank();

        observer_(stage::extrude);
        const auto sizes = extruder_.plan(*filled, shapes_.sides);
        if (!sizes) return undo(sizes.error());
        shape_record s;
        s.id = glyph.id;
        s.cluster = glyph.cluster;
        s.line = line;
        s.origin = glyph.origin;
        s.first_triangle = static_cast<std::uint32_t>(triangles_before);
        s.first_side = static_cast<std::uint32_t>(sides_before);
        if (error e = shapes_.keep(s, *filled, *sizes)) return undo(e);
        return {};
    }

    error blank() noexcept
    {
        ++shapes_.report.blank;
        return {};
    }

    /// What is known only when all glyphs are: boxes, unit, bounds.
    error arrange(const glyph_run& run, const text_options& options) noexcept
    {
        text_shapes& all = shapes_;
        const bool by_line = options.texture_over == texture_box::line;
        if (by_line) {
            const std::size_t lines = run.lines.empty() ? 1 : run.lines.size();
            box* boxes = all.line_boxes.append(lines);
            if (boxes == nullptr) return error::out_of_memory;
            for (std::size_t i = 0; i < lines; ++i) boxes[i] = {};
        }
        for (const shape_record& s : all.records) {
            const box ink = text_shapes::ink_of(s);
            all.ink.merge(ink);
            if (by_line) all.line_boxes[s.line].merge(ink);
        }

        text_placement& placed = all.placed;
        placed = {};
        placed.units_per_em = font_->units_per_em();
        placed.texture_over = options.texture_over;
        placed.frame = options.frame;
        switch (options.unit) {
        case output_unit::em: placed.unit_per_font_unit = 1.0 / placed.units_per_em; break;
        case output_unit::font_units: placed.unit_per_font_unit = 1.0; break;
        case output_unit::pixels: placed.unit_per_font_unit = options.pixels_per_em / placed.units_per_em; break;
        case output_unit::unit_box:
            const double longer = all.ink.width() > all.ink.height() ? all.ink.width() : all.ink.height();
            placed.unit_per_font_unit = longer > 0.0 ? 2.0 / longer : 1.0;
            if (!all.ink.empty()) placed.centre = lerp(all.ink.low, all.ink.high, 0.5);
            break;
        }
        measure();
        return {};
    }

    void measure() noexcept
    {
        bool first = true;
        const height_range heights = extruder_.heights();
        for (const shape_record& s : shapes_.records) {
            const placement at = shapes_.place(s);
            for (const grid_point corner :
                 {s.low, s.high, grid_point{s.low.x, s.high.y}, grid_point{s.high.x, s.low.y}}) {
                for (const double height : {heights.low, heights.high}) {
                    const vec3 p = at.position(corner, static_cast<float>(height * at.unit_per_em));
                    if (first) shapes_.bounds = {p, p};
                    first = false;
                    shapes_.bounds.add(p);
                }
            }
        }
    }

    /// Whether a text may go on without this glyph.
    [[nodiscard]] static constexpr bool concerns_the_glyph_alone(const error& e) noexcept
    {
        switch (e.code) {
        case error::unknown_glyph:
        case error::bad_outline:
        case error::outline_not_finite:
        case error::outline_beyond_grid:
        case error::crossing_contours:
        case error::font_library_failed:
        case error::refused_by_user: return true;
        default: return false;
        }
    }

    Font* font_;
    workspace space_;
    outline outline_;
    contours loops_;
    glyph_run run_;
    text_shapes shapes_;
    [[no_unique_address]] Discretiser discretiser_{};
    [[no_unique_address]] Triangulator triangulator_{};
    [[no_unique_address]] Extruder extruder_{};
    [[no_unique_address]] Observer observer_{};
};

template <class Font>
text_mesher(Font&) -> text_mesher<Font>;
template <class Font>
text_mesher(Font&, memory) -> text_mesher<Font>;
template <class Font>
text_mesher(const Font&&) -> text_mesher<Font>;  // chosen only to be refused: see the deleted constructor

}  // namespace typemesh

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// An outline source for your own drawings: logos, icons, test shapes.
///
///     recorded_outlines icons{1000.0};                              // units per em
///     auto id = icons.add([](outline_sink auto& pen) {
///         pen.move({0, 0}); pen.line({800, 0}); pen.quadratic({800, 900}, {0, 900}); pen.close();
///     });                                                           // ids start at 0
class recorded_outlines {
public:
    explicit recorded_outlines(double units_per_em, fill_rule rule = fill_rule::non_zero,
                               memory source = heap()) noexcept
        : units_per_em_{units_per_em},
          rule_{rule},
          scratch_{source},
          curves_{source},
          contours_{source},
          glyphs_{source}
    {
    }

    /// Calls draw(sink) once, stores the drawing and returns its id. A failed add() leaves the set unchanged. It fails
    /// with the error that draw() returns, if it returns one, and otherwise as outline_recorder does.
    ///
    ///     icons.add([&](outline_sink auto& pen) { return font.outline(id, pen); });    // a glyph of a font
    template <class Draw>
    result<glyph_id> add(Draw&& draw) noexcept
    {
        outline_recorder recorder{scratch_};
        if constexpr (std::same_as<decltype(draw(recorder)), error>) {
            if (error e = draw(recorder)) return e;
        } else {
            draw(recorder);
        }
        if (error e = recorder.finish()) return e;

        const glyph kept{contours_.size(), scratch_.starts.size(), curves_.size()};
        if (!contours_.append(scratch_.starts.view()) || !curves_.append(scratch_.curves.view()) ||
            !glyphs_.push_back(kept)) {
            contours_.truncate(kept.first_start);
            curves_.truncate(kept.first_curve);
            return error::out_of_memory;
        }
        return static_cast<glyph_id>(glyphs_.size() - 1);
    }

    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }
    [[nodiscard]] fill_rule fill() const noexcept { return rule_; }
    [[nodiscard]] std::size_t size() const noexcept { return glyphs_.size(); }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) const noexcept
    {
        if (id >= glyphs_.size()) return error{error::unknown_glyph}.at(id, no_cluster);
        const glyph& g = glyphs_[id];
        if (g.start_count != 0)
            draw_outline(curves_.view().subspan(g.first_curve), contours_.view().subspan(g.first_start, g.start_count),
                         sink);
        return {};
    }

private:
    struct glyph {
        std::size_t first_start;
        std::size_t start_count;  // one more than contours, or 0
        std::size_t first_curve;
    };

    double units_per_em_;
    fill_rule rule_;
    typemesh::outline scratch_;
    buffer<curve> curves_;
    buffer<std::uint32_t> contours_;
    buffer<glyph> glyphs_;
};

static_assert(outline_source<recorded_outlines>);

}  // namespace typemesh::inline TYPEMESH_ABI

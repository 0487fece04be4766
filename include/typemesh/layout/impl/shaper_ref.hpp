// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/item_shaper.hpp>
#include <typemesh/layout/shaper.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// Refers to a shaper of any type, which must outlive it. It is itself a shaper. A line costs one indirect call.
class shaper_ref {
public:
    /// One table for each type of shaper.
    struct calls {
        double (*units_per_em)(void* shaper) noexcept;
        line_metrics (*metrics)(void* shaper, direction d) noexcept;
        double (*column_middle)(void* shaper) noexcept;
        result<point> (*shape)(void* shaper, text_view text, std::size_t first, std::size_t last,
                               const shape_options& how, glyph_run& run) noexcept;
    };
    template <shaper Shaper>
    struct table {
        static const calls of;
    };

    shaper_ref(void* shaper, const calls& does) noexcept : shaper_{shaper}, does_{&does} {}

    [[nodiscard]] double units_per_em() const noexcept { return does_->units_per_em(shaper_); }
    [[nodiscard]] line_metrics metrics(direction d) const noexcept { return does_->metrics(shaper_, d); }
    [[nodiscard]] double column_middle() const noexcept { return does_->column_middle(shaper_); }
    result<point> shape(text_view text, std::size_t first, std::size_t last, const shape_options& how,
                        glyph_run& run) const noexcept
    {
        return does_->shape(shaper_, text, first, last, how, run);
    }

private:
    void* shaper_;
    const calls* does_;
};

template <shaper Shaper>
constinit const shaper_ref::calls shaper_ref::table<Shaper>::of = {
    [](void* shaper) noexcept -> double { return static_cast<Shaper*>(shaper)->units_per_em(); },
    [](void* shaper, direction d) noexcept { return static_cast<Shaper*>(shaper)->metrics(d); },
    [](void* shaper) noexcept { return column_middle_of(*static_cast<Shaper*>(shaper)); },
    [](void* shaper, text_view text, std::size_t first, std::size_t last, const shape_options& how,
       glyph_run& run) noexcept { return static_cast<Shaper*>(shaper)->shape(text, first, last, how, run); }};
static_assert(shaper<shaper_ref>);

}  // namespace typemesh::inline TYPEMESH_ABI

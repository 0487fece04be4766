// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/glyph_store.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The plan_workers of a mesher without others: its own font, builder, store and observer.
template <outline_source Font, stage_observer Observer>
struct lone_worker {
    static constexpr bool is_alone = true;

    Font& font;
    glyph_builder& builder;
    glyph_store& store;
    Observer& observe;

    template <shaper Shaper>
    error layout(Shaper& shapes, text_view text, const shape_options& how, const layout_options& options,
                 glyph_run& run) noexcept
    {
        return typemesh::layout(shapes, text, how, options, run);
    }

    [[nodiscard]] double units_per_em() noexcept { return font.units_per_em(); }

    /// Its store is the plan's own.
    static const std::uint64_t* begin_plan() noexcept { return nullptr; }

    template <class Task>
    error each(std::size_t n, const Task& task) noexcept
    {
        for (std::size_t k = 0; k < n; ++k)
            if (error e = task(k, font, builder, store, observe)) return e;
        return {};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

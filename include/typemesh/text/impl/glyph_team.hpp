// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/executor_ref.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/impl/glyph_store.hpp>
#include <typemesh/layout/impl/shared_shaping.hpp>
#include <typemesh/layout/shaped_glyph.hpp>
#include <typemesh/text/impl/font_ref.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One worker's resources for building glyphs. It has its own cache lines, so there is no false sharing.
struct alignas(64) team_member {
    font_ref font;
    glyph_builder builder;
    glyph_store store;
    buffer<shaped_glyph> shaped;
    error failure;
    std::size_t failed_at;

    team_member(font_ref source, memory from) noexcept
        : font{source}, builder{from}, store{from}, shaped{from}, failure{}, failed_at{0}
    {
    }
};

/// The part of a glyph_workers that does not depend on the types of its executor and of its fonts.
struct glyph_team {
    executor_ref executor;
    array_view<team_member> members;
    std::uint64_t plans = 0;  ///< started so far

    /// Whether all workers can shape text of this font, which is a shaper: their sources have its type.
    [[nodiscard]] bool shapes_for(font_ref font) const noexcept
    {
        return members.size() > 1 && members[0].font.is_like(font);
    }

    /// Shapes the items of a text: see shaping_team.
    error shape(shared_shaping& shared, const shaped_text& shaped) noexcept
    {
        const array_view<team_member> all = members;
        return shared(
            executor, [all](std::size_t worker) noexcept { return all[worker].font.shaper(); },
            [all](std::size_t worker) noexcept -> buffer<shaped_glyph>& { return all[worker].shaped; }, shaped);
    }

    /// Removes the glyphs of the previous plan.
    void begin_plan() noexcept
    {
        for (team_member& m : members) m.store.clear();
        ++plans;
    }

    /// Calls task(k, font, builder, store) for each k < n, with the state of the worker that runs it. Returns the error
    /// of the lowest k that fails; some tasks above it may not have been called.
    template <class Task>
    error each(std::size_t n, const Task& task) noexcept
    {
        const array_view<team_member> all = members;
        for (team_member& m : all) m.failure = {};
        executor.run(n, [all, &task](std::size_t k, std::size_t worker) noexcept {
            team_member& own = all[worker];
            if (own.failure && own.failed_at < k) return;
            if (error e = task(k, own.font, own.builder, own.store)) {
                own.failure = e;
                own.failed_at = k;
            }
        });
        const team_member* first = nullptr;
        for (const team_member& m : all)
            if (m.failure && (first == nullptr || m.failed_at < first->failed_at)) first = &m;
        return first == nullptr ? error{} : first->failure;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI

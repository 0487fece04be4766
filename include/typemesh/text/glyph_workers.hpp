// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/text/impl/glyph_team.hpp>

#include <concepts>
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Makes the outline source of one worker: clone(worker) returns a result<Source>, once per worker.
///
/// All sources must draw and shape alike. No source may share mutable state with another source, or with the mesher's
/// font:
///
///     HarfBuzz    [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); }
///                 all large data is shared; only the text's own buffers are not
///     FreeType    [&](std::size_t) noexcept { return freetype_font::open(path, options); }
///                 each worker has a face and a library of its own: two threads may use neither at once
///     your own    a shared source that reading does not change: transformed_outlines<const My_source> over it
template <class C>
concept source_maker = requires(C& clone, std::size_t worker) {
    { clone(worker) } noexcept;
    requires outline_source<std::remove_cvref_t<decltype(*clone(worker))>>;
    { clone(worker).error() } noexcept -> std::same_as<error>;
};

/// The workers that shape a text's lines and build its glyphs in parallel: an executor and, for each of its workers, an
/// outline source, scratch memory, and a store for the glyphs that it builds. See workers_of().
///
/// Move-only. It refers to its executor. It holds one plan at a time: the next plan() with these workers invalidates
/// the previous plan, whichever mesher made it, unless a glyph_cache holds the glyphs.
///
/// Memory   several workers take memory from `source` at once; the source must allow this, as heap() does. The memory
///          is kept for the next text. It is not defined which worker builds which glyph. A worker may therefore need
///          more memory than for the last text, until each worker has built the majority of the glyphs.
template <executor Executor, outline_source Source>
class glyph_workers {
    struct alignas(64) own_source {  // aligned to a cache line, because reading a font changes it
        Source font;
    };
    struct block {
        std::size_t count = 0;
        glyph_team team;

        explicit block(executor_ref workers) noexcept : team{workers, {}} {}
    };
    static constexpr std::size_t alignment = alignof(team_member) > alignof(own_source) ? alignof(team_member)
                                                                                        : alignof(own_source);
    static constexpr std::size_t header = (sizeof(block) + alignment - 1) / alignment * alignment;

public:
    /// Fails  with the first error of clone(); error::out_of_memory
    template <source_maker Clone>
    [[nodiscard]] static result<glyph_workers> make(Executor& workers, Clone&& clone, memory source = heap()) noexcept
    {
        const std::size_t count = workers.workers();
        TYPEMESH_ASSERT(count != 0, "an executor must have at least one worker");
        const std::size_t bytes = header + count * (sizeof(team_member) + sizeof(own_source));
        void* raw = source.allocate(source.user, bytes, alignment);
        if (raw == nullptr) return error::out_of_memory;
        glyph_workers all{workers, source, new (raw) block{workers}, bytes};
        std::byte* members = static_cast<std::byte*>(raw) + header;
        std::byte* sources = members + count * sizeof(team_member);
        for (std::size_t& k = all.block_->count; k < count; ++k) {
            auto made = clone(std::size_t{k});
            if (!made) return made.error();
            auto* own = new (sources + k * sizeof(own_source)) own_source{std::move(*made)};
            auto* member = new (members + k * sizeof(team_member)) team_member{own->font, source};
            if (k == 0) {
                all.sources_ = own;
                all.block_->team.members = {member, 0};
            }
            all.block_->team.members = {all.block_->team.members.data(), k + 1};
        }
        return result<glyph_workers>{std::move(all)};
    }

    glyph_workers(glyph_workers&& other) noexcept
        : executor_{other.executor_},
          source_{other.source_},
          block_{taken(other.block_)},
          sources_{other.sources_},
          bytes_{other.bytes_}
    {
    }
    glyph_workers& operator=(glyph_workers&& other) noexcept
    {
        swap_values(executor_, other.executor_);
        swap_values(source_, other.source_);
        swap_values(block_, other.block_);
        swap_values(sources_, other.sources_);
        swap_values(bytes_, other.bytes_);
        return *this;
    }
    ~glyph_workers()
    {
        if (block_ == nullptr) return;
        for (std::size_t i = block_->count; i-- > 0;) {
            block_->team.members[i].~team_member();
            sources_[i].~own_source();
        }
        block_->~block();
        source_.deallocate(source_.user, block_, bytes_, alignment);
    }

    /// The executor, for writing the plan with the same workers.
    [[nodiscard]] Executor& pool() noexcept { return *executor_; }

    /// The font units per em of its sources.
    [[nodiscard]] double units_per_em() noexcept { return sources_[0].font.units_per_em(); }

    /// The team that a mesher plans with. Its address does not change when the workers are moved.
    [[nodiscard]] glyph_team& team() noexcept { return block_->team; }

    /// Returns the scratch memory for building glyphs to its source. Plans stay as they are.
    void trim() noexcept
    {
        for (team_member& m : block_->team.members) m.builder.trim();
    }

private:
    glyph_workers(Executor& workers, memory source, block* b, std::size_t bytes) noexcept
        : executor_{&workers}, source_{source}, block_{b}, bytes_{bytes}
    {
    }

    Executor* executor_;
    memory source_;
    block* block_;  // followed in memory by the members, then the sources
    own_source* sources_ = nullptr;
    std::size_t bytes_;
};

/// The workers of an executor, each with its own source:
///
///     thread_pool pool;                                                                // adapt/threads.hpp
///     auto workers = workers_of(pool, [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); });
///     if (!workers) return puts(workers.error().message());
///     auto plan = mesher.plan(text, options, *workers);
///     if (plan) plan->write(into(vertices, indices), pool);
///
/// Fails  as glyph_workers::make() does
template <executor Executor, source_maker Clone>
[[nodiscard]] auto workers_of(Executor& workers, Clone&& clone, memory source = heap()) noexcept
{
    using source_type = std::remove_cvref_t<decltype(*clone(std::size_t{0}))>;
    return glyph_workers<Executor, source_type>::make(workers, clone, source);
}

}  // namespace typemesh::inline TYPEMESH_ABI

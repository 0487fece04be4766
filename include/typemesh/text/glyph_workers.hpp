// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/executor.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/glyph_store.hpp>
#include <typemesh/glyph/stage.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/layout/shared_layout.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Makes the outline source of one worker: clone(worker) returns a result<Source>, once per worker.
///
/// All must draw and shape alike, and none may share mutable state with another, or with the mesher's font:
///
///     HarfBuzz    [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); }
///                 all large data is shared; only the text's own buffers are not
///     FreeType    [&](std::size_t) noexcept { return freetype_font::open(path, options); }
///                 a face and a library for each: neither may be used by two threads at once
///     your own    if reading it changes nothing, transformed_outlines<const My_source> over one that all share
template <class C>
concept source_maker = requires(C& clone, std::size_t worker) {
    { clone(worker) } noexcept;
    requires outline_source<std::remove_cvref_t<decltype(*clone(worker))>>;
    { clone(worker).error() } noexcept -> std::same_as<error>;
};

/// The workers that shape a text's lines and build its glyphs in parallel: an executor, and for each of its workers an
/// outline source, scratch memory, and a store for the glyphs that it builds. See workers_of().
///
/// Move-only. It refers to its executor. It holds one plan at a time: the next plan() with these workers ends the one
/// before, whichever mesher made it, unless a glyph_cache holds the glyphs.
///
/// Memory   from `source`, by several workers at once: it must allow that, as heap() does. It is kept for the next
///          text. Which worker builds which glyph is open, so a worker may need more than the last time until each has
///          built most of what there is.
template <executor Executor, outline_source Source>
class glyph_workers {
    struct alignas(64) member {  // a cache line of its own: no false sharing between workers
        Source font;
        glyph_builder builder;
        glyph_store store;
        glyph_run lines;
        error failure;
        std::size_t failed_at;
    };
    struct block {
        std::uint64_t plans = 0;  // begun so far
        std::size_t count = 0;
        shared_layout lines;

        explicit block(memory source) noexcept : lines{source} {}
    };
    static constexpr std::size_t header = (sizeof(block) + alignof(member) - 1) / alignof(member) * alignof(member);

public:
    static constexpr bool is_alone = false;  ///< see plan_workers

    /// Fails  with the first error of clone(); error::out_of_memory
    template <source_maker Clone>
    [[nodiscard]] static result<glyph_workers> make(Executor& workers, Clone&& clone, memory source = heap()) noexcept
    {
        const std::size_t count = workers.workers();
        TYPEMESH_ASSERT(count != 0, "an executor without workers was given");
        const std::size_t bytes = header + count * sizeof(member);
        void* raw = source.allocate(source.user, bytes, alignof(member));
        if (raw == nullptr) return error::out_of_memory;
        glyph_workers all{workers, source, new (raw) block{source}, bytes};
        for (; all.block_->count < count; ++all.block_->count) {
            const std::size_t worker = all.block_->count;
            auto made = clone(worker);
            if (!made) return made.error();
            new (all.members() + worker)
                member{std::move(*made), glyph_builder{source}, glyph_store{source}, glyph_run{source}, {}, 0};
        }
        return result<glyph_workers>{std::move(all)};
    }

    glyph_workers(glyph_workers&& other) noexcept
        : executor_{other.executor_},
          source_{other.source_},
          block_{std::exchange(other.block_, nullptr)},
          bytes_{other.bytes_}
    {
    }
    glyph_workers& operator=(glyph_workers&& other) noexcept
    {
        std::swap(executor_, other.executor_);
        std::swap(source_, other.source_);
        std::swap(block_, other.block_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    ~glyph_workers()
    {
        if (block_ == nullptr) return;
        for (std::size_t i = block_->count; i-- > 0;) members()[i].~member();
        block_->~block();
        source_.deallocate(source_.user, block_, bytes_, alignof(member));
    }

    /// The executor, for writing the plan with the same workers.
    [[nodiscard]] Executor& pool() noexcept { return *executor_; }

    /// The font units per em of its sources.
    [[nodiscard]] double units_per_em() noexcept { return members()[0].font.units_per_em(); }

    /// layout(), with the same result: lines are shaped by all workers if the sources are shapers of the mesher's own
    /// type, else by its font.
    template <shaper Shaper>
    error layout(Shaper& font, text_view text, const shape_options& how, const layout_options& options,
                 glyph_run& run) noexcept
    {
        if constexpr (std::is_same_v<Shaper, Source>) {
            member* all = members();
            if (block_->count > 1)
                return block_->lines(
                    *executor_, [all](std::size_t worker) noexcept -> Source& { return all[worker].font; },
                    [all](std::size_t worker) noexcept -> glyph_run& { return all[worker].lines; }, font, text, how,
                    options, run);
        }
        return typemesh::layout(font, text, how, options, run);
    }

    /// Removes the glyphs of the previous plan, and returns the number that identifies the new one. Its address stays
    /// the same when the workers are moved.
    const std::uint64_t* begin_plan() noexcept
    {
        for (std::size_t i = 0; i < block_->count; ++i) members()[i].store.clear();
        ++block_->plans;
        return &block_->plans;
    }

    /// Gives the scratch memory for building glyphs back to its source. Plans stay as they are.
    void trim() noexcept
    {
        for (std::size_t i = 0; i < block_->count; ++i) members()[i].builder.trim();
    }

    /// Calls task(k, font, builder, store, observer) for each k < n, with the per-worker state of whoever runs it.
    /// Returns the error of the lowest k that has one; above it not all may have been called. The observer is the null
    /// observer.
    template <class Task>
    error each(std::size_t n, const Task& task) noexcept
    {
        member* all = members();
        for (std::size_t i = 0; i < block_->count; ++i) all[i].failure = {};
        executor_->run(n, [all, &task](std::size_t k, std::size_t worker) noexcept {
            member& own = all[worker];
            if (own.failure && own.failed_at < k) return;
            no_observer nobody;
            if (error e = task(k, own.font, own.builder, own.store, nobody)) {
                own.failure = e;
                own.failed_at = k;
            }
        });
        const member* first = nullptr;
        for (std::size_t i = 0; i < block_->count; ++i)
            if (all[i].failure && (first == nullptr || all[i].failed_at < first->failed_at)) first = all + i;
        return first == nullptr ? error{} : first->failure;
    }

private:
    glyph_workers(Executor& workers, memory source, block* b, std::size_t bytes) noexcept
        : executor_{&workers}, source_{source}, block_{b}, bytes_{bytes}
    {
    }

    [[nodiscard]] member* members() const noexcept
    {
        return std::launder(reinterpret_cast<member*>(reinterpret_cast<std::byte*>(block_) + header));
    }

    Executor* executor_;
    memory source_;
    block* block_;  // and the members after it
    std::size_t bytes_;
};

/// The workers of an executor, each with a source of its own:
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

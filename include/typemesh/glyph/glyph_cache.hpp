// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/glyph_context.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// Prevents two threads from using a cache at once.
template <class L>
concept cache_lock = requires(L& l) {
    { l.lock() } noexcept;
    { l.unlock() } noexcept;
};

/// The lock of a cache that only one thread uses. adapt/threads.hpp has one based on std::mutex.
struct no_lock {
    constexpr void lock() noexcept {}
    constexpr void unlock() noexcept {}
};

/// The contents and the requests of a glyph_cache.
struct cache_statistics {
    std::uint64_t hits = 0;        ///< the number of successful find() calls
    std::uint64_t misses = 0;      ///< the number of unsuccessful find() calls
    std::uint64_t evictions = 0;   ///< the number of glyphs removed to keep within the bound
    std::size_t entries = 0;       ///< the number of glyphs held, including blank and refused glyphs
    std::size_t bytes = 0;         ///< the total size of their blocks, in bytes
    std::size_t pinned = 0;        ///< the number of pinned entries
    std::size_t pinned_bytes = 0;  ///< the bytes of the pinned entries
};

/// Keeps built glyphs for the next text that needs them.
///
///     glyph_cache cache;                                             // 64 MiB, for one thread
///     auto mesher = text_mesher{font}.with(cached_in{cache, 1});     // 1: your number for this font
///
/// Glyphs are distinguished by their id and by everything else on which they depend: see glyph_context. Blank and
/// refused glyphs are also kept, so no glyph is built twice in vain.
///
/// Glyphs that find() and keep() return are pinned: a pinned glyph stays unchanged and in place until release(), even
/// if other users evict glyphs. The bound applies to all glyphs that are not pinned; the glyph released longest ago is
/// evicted first. Any number of threads may use the cache if Lock is a real lock. Each call is one short critical
/// section; reading a pinned glyph needs no lock.
///
/// Memory   one block per glyph, and the table. The memory source is called only under the lock. clear() gives back all
///          memory that no pinned glyph needs, the destructor everything.
/// Cost     O(1) per call
template <cache_lock Lock = no_lock>
class glyph_cache {
    struct entry {
        glyph_context context;
        std::uint64_t hash;
        glyph_id id;
        std::uint32_t pins;
        std::size_t bytes;
        entry* next_in_bucket;
        entry* newer;  // while not pinned
        entry* older;
    };
    static constexpr std::size_t alignment = alignof(entry) > alignof(built_glyph) ? alignof(entry)
                                                                                   : alignof(built_glyph);
    static constexpr std::size_t header = (sizeof(entry) + alignment - 1) / alignment * alignment;

    class locked {
    public:
        explicit locked(Lock& l) noexcept : lock_{l} { lock_.lock(); }
        locked(const locked&) = delete;
        locked& operator=(const locked&) = delete;
        ~locked() { lock_.unlock(); }

    private:
        Lock& lock_;
    };

public:
    explicit glyph_cache(std::size_t bound = std::size_t{64} << 20, memory source = heap()) noexcept
        : source_{source}, bound_{bound}, buckets_{source}
    {
    }
    glyph_cache(const glyph_cache&) = delete;
    glyph_cache& operator=(const glyph_cache&) = delete;
    ~glyph_cache()
    {
        clear();
        TYPEMESH_ASSERT(numbers_.entries == 0, "a glyph_cache ended while plans still read its glyphs");
    }

    /// Finds a built glyph and pins it; null if the cache does not hold it.
    [[nodiscard]] const built_glyph* find(const glyph_context& context, glyph_id id) noexcept
    {
        return find(context, context.hash(), id);
    }

    /// For many glyphs of one context: `hash` is context.hash().
    [[nodiscard]] const built_glyph* find(const glyph_context& context, std::uint64_t hash, glyph_id id) noexcept
    {
        const locked until_end{lock_};
        entry* e = look_up(context, mixed_key(hash, id), id);
        ++(e != nullptr ? numbers_.hits : numbers_.misses);
        if (e == nullptr) return nullptr;
        pin(*e);
        return shape_of(e);
    }

    /// Keeps a copy of the draft and returns it, pinned. If another thread was faster, that thread's glyph is returned
    /// and nothing is kept. Null if out of memory; then nothing has changed.
    [[nodiscard]] const built_glyph* keep(const glyph_context& context, glyph_id id, const glyph_draft& draft) noexcept
    {
        return keep(context, context.hash(), id, draft);
    }
    [[nodiscard]] const built_glyph* keep(const glyph_context& context, std::uint64_t hash, glyph_id id,
                                          const glyph_draft& draft) noexcept
    {
        const locked until_end{lock_};
        hash = mixed_key(hash, id);
        if (entry* e = look_up(context, hash, id)) {
            pin(*e);
            return shape_of(e);
        }
        if (numbers_.entries >= buckets_.size() && !grow() && buckets_.empty()) return nullptr;
        const std::size_t bytes = header + built_glyph::bytes_for(draft);
        void* block = source_.allocate(source_.user, bytes, alignment);
        if (block == nullptr) return nullptr;
        entry*& bucket = bucket_of(hash);
        entry* e = new (block) entry{context, hash, id, 1, bytes, bucket, nullptr, nullptr};
        bucket = e;
        ++numbers_.entries;
        ++numbers_.pinned;
        numbers_.bytes += bytes;
        numbers_.pinned_bytes += bytes;
        return built_glyph::make(static_cast<std::byte*>(block) + header, draft);
    }

    /// Removes one pin from each of these glyphs, which find() or keep() returned; nulls are skipped. They count as
    /// used now, in this order.
    void release(array_view<const built_glyph* const> glyphs) noexcept
    {
        const locked until_end{lock_};
        for (const built_glyph* built : glyphs) {
            if (built == nullptr) continue;
            entry* e = entry_of(built);
            TYPEMESH_ASSERT(e->pins != 0, "a glyph was released more often than it was pinned");
            if (--e->pins != 0) continue;
            --numbers_.pinned;
            numbers_.pinned_bytes -= e->bytes;
            e->older = newest_;
            e->newer = nullptr;
            (newest_ != nullptr ? newest_->newer : oldest_) = e;
            newest_ = e;
        }
        keep_bound();
    }

    /// Sets the bound for the bytes of unpinned glyphs. A smaller bound takes effect at once.
    void set_bound(std::size_t bytes) noexcept
    {
        const locked until_end{lock_};
        bound_ = bytes;
        keep_bound();
    }

    /// Frees all entries that are not pinned.
    void clear() noexcept
    {
        const locked until_end{lock_};
        while (oldest_ != nullptr) drop(oldest_);
        if (numbers_.entries == 0) buckets_ = buffer<entry*>{source_};
    }

    /// The present contents, and all requests so far. Cost: O(1), under the lock
    [[nodiscard]] cache_statistics statistics() const noexcept
    {
        const locked until_end{lock_};
        return numbers_;
    }

private:
    static const built_glyph* shape_of(entry* e) noexcept
    {
        return std::launder(reinterpret_cast<const built_glyph*>(reinterpret_cast<std::byte*>(e) + header));
    }
    static entry* entry_of(const built_glyph* built) noexcept
    {
        auto* block = reinterpret_cast<std::byte*>(const_cast<built_glyph*>(built)) - header;
        return std::launder(reinterpret_cast<entry*>(block));
    }
    entry*& bucket_of(std::uint64_t hash) noexcept { return buckets_[hash & (buckets_.size() - 1)]; }

    entry* look_up(const glyph_context& context, std::uint64_t hash, glyph_id id) noexcept
    {
        if (buckets_.empty()) return nullptr;
        entry* e = bucket_of(hash);
        while (e != nullptr && !(e->hash == hash && e->id == id && e->context == context)) e = e->next_in_bucket;
        return e;
    }

    void pin(entry& e) noexcept
    {
        if (e.pins++ != 0) return;
        take_out(e);
        ++numbers_.pinned;
        numbers_.pinned_bytes += e.bytes;
    }

    /// Removes an entry from the list of unpinned entries.
    void take_out(entry& e) noexcept
    {
        (e.older != nullptr ? e.older->newer : oldest_) = e.newer;
        (e.newer != nullptr ? e.newer->older : newest_) = e.older;
        e.older = e.newer = nullptr;
    }

    void keep_bound() noexcept
    {
        for (; numbers_.bytes - numbers_.pinned_bytes > bound_; ++numbers_.evictions) drop(oldest_);
    }

    void drop(entry* e) noexcept
    {
        take_out(*e);
        entry** link = &bucket_of(e->hash);
        while (*link != e) link = &(*link)->next_in_bucket;
        *link = e->next_in_bucket;
        --numbers_.entries;
        numbers_.bytes -= e->bytes;
        source_.deallocate(source_.user, e, e->bytes, alignment);
    }

    /// Doubles the number of buckets. If out of memory, chains only grow longer.
    bool grow() noexcept
    {
        const std::size_t wanted = buckets_.empty() ? 256 : 2 * buckets_.size();
        buffer<entry*> more{source_};
        if (!more.reserve(wanted)) return false;
        entry** fresh = more.append(wanted);
        for (std::size_t i = 0; i < wanted; ++i) fresh[i] = nullptr;
        for (entry* e : buckets_) {
            while (e != nullptr) {
                entry* next = e->next_in_bucket;
                e->next_in_bucket = fresh[e->hash & (wanted - 1)];
                fresh[e->hash & (wanted - 1)] = e;
                e = next;
            }
        }
        buckets_ = std::move(more);
        return true;
    }

    memory source_;
    std::size_t bound_;
    buffer<entry*> buckets_;
    entry* newest_ = nullptr;
    entry* oldest_ = nullptr;
    cache_statistics numbers_;
    mutable Lock lock_;
};

/// Refers to a glyph_cache with any lock, which must outlive it.
class cache_ref {
public:
    cache_ref() noexcept = default;  ///< refers to no cache
    template <cache_lock Lock>
    cache_ref(glyph_cache<Lock>& cache) noexcept : cache_{&cache}, does_{&calls_of<Lock>}
    {
    }

    /// Whether it refers to a cache; all other functions require this.
    [[nodiscard]] explicit operator bool() const noexcept { return does_ != nullptr; }

    /// See glyph_cache.
    [[nodiscard]] const built_glyph* find(const glyph_context& context, std::uint64_t hash, glyph_id id) const noexcept
    {
        return does_->find(cache_, context, hash, id);
    }
    [[nodiscard]] const built_glyph* keep(const glyph_context& context, std::uint64_t hash, glyph_id id,
                                          const glyph_draft& draft) const noexcept
    {
        return does_->keep(cache_, context, hash, id, draft);
    }
    void release(array_view<const built_glyph* const> glyphs) const noexcept { does_->release(cache_, glyphs); }

    /// Whether several threads may use it at once.
    [[nodiscard]] bool has_lock() const noexcept { return does_->has_lock; }

private:
    struct calls {
        const built_glyph* (*find)(void* cache, const glyph_context& context, std::uint64_t hash, glyph_id id) noexcept;
        const built_glyph* (*keep)(void* cache, const glyph_context& context, std::uint64_t hash, glyph_id id,
                                   const glyph_draft& draft) noexcept;
        void (*release)(void* cache, array_view<const built_glyph* const> glyphs) noexcept;
        bool has_lock;
    };
    template <cache_lock Lock>
    static constexpr calls calls_of = {
        [](void* cache, const glyph_context& context, std::uint64_t hash, glyph_id id) noexcept {
            return static_cast<glyph_cache<Lock>*>(cache)->find(context, hash, id);
        },
        [](void* cache, const glyph_context& context, std::uint64_t hash, glyph_id id,
           const glyph_draft& draft) noexcept {
            return static_cast<glyph_cache<Lock>*>(cache)->keep(context, hash, id, draft);
        },
        [](void* cache, array_view<const built_glyph* const> glyphs) noexcept {
            static_cast<glyph_cache<Lock>*>(cache)->release(glyphs);
        },
        !std::is_same_v<Lock, no_lock>};

    void* cache_ = nullptr;
    const calls* does_ = nullptr;
};

/// The option that makes a text_mesher use a cache: the cache, and the caller's number for the font. Fonts of your own
/// that share a cache need distinct numbers. The adapters' fonts have a variation_key(), which distinguishes them and
/// their axis values automatically. The cache must outlive the mesher.
struct cached_in {
    cache_ref cache;
    std::uint64_t font = 0;

    cached_in() noexcept = default;  ///< uses no cache

    template <cache_lock Lock>
    cached_in(glyph_cache<Lock>& c, std::uint64_t font_number) noexcept : cache{c}, font{font_number}
    {
    }
};

/// The option for a mesher without a cache.
struct no_cache {};

}  // namespace typemesh::inline TYPEMESH_ABI

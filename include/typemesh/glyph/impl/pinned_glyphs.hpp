// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/glyph_cache.hpp>

#include <cstddef>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The built glyphs among a text's different glyphs, by number, and the cache, if any, in which they are pinned.
class pinned_glyphs {
public:
    explicit pinned_glyphs(memory source = heap()) noexcept : glyphs_{source} {}
    pinned_glyphs(pinned_glyphs&& other) noexcept
        : glyphs_{std::move(other.glyphs_)}, cache_{taken(other.cache_)}, pinned_{other.pinned_}
    {
    }
    pinned_glyphs& operator=(pinned_glyphs&& other) noexcept
    {
        glyphs_.swap(other.glyphs_);
        swap_values(cache_, other.cache_);
        swap_values(pinned_, other.pinned_);
        return *this;
    }
    ~pinned_glyphs() { release(); }

    /// Reserves `count` entries, all null at first. Among the first `pinned` ones, each that is set must be pinned in
    /// `cache`, which outlives this. False if out of memory.
    [[nodiscard]] bool reserve(std::size_t count, cache_ref cache, std::size_t pinned) noexcept
    {
        if (!reserve(count)) return false;
        cache_ = cache;
        pinned_ = pinned;
        return true;
    }
    /// The same for glyphs that are not pinned.
    [[nodiscard]] bool reserve(std::size_t count) noexcept
    {
        clear();
        if (!glyphs_.reserve(count)) return false;
        for (std::size_t i = 0; i < count; ++i) glyphs_.push_back_unchecked(nullptr);
        return true;
    }

    void set(std::size_t number, const built_glyph* built) noexcept { glyphs_[number] = built; }
    [[nodiscard]] const built_glyph* operator[](std::size_t number) const noexcept { return glyphs_[number]; }

    /// Releases the pins; the glyphs must no longer be read.
    void release() noexcept
    {
        if (cache_) taken(cache_).release(glyphs_.view().first(pinned_));
    }

    void clear() noexcept
    {
        release();
        glyphs_.clear();
    }

private:
    buffer<const built_glyph*> glyphs_;
    cache_ref cache_;
    std::size_t pinned_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI

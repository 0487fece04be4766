// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/glyph/glyph_shape.hpp>

#include <cstddef>
#include <span>
#include <utility>

namespace typemesh {

/// The shapes of a text's different glyphs, by number, and the cache that must hold them still meanwhile, if one does.
class pinned_shapes {
public:
    explicit pinned_shapes(memory source = heap()) noexcept : shapes_{source} {}
    pinned_shapes(pinned_shapes&& other) noexcept
        : shapes_{std::move(other.shapes_)}, cache_{std::exchange(other.cache_, nullptr)}, release_{other.release_}
    {
    }
    pinned_shapes& operator=(pinned_shapes&& other) noexcept
    {
        shapes_.swap(other.shapes_);
        std::swap(cache_, other.cache_);
        std::swap(release_, other.release_);
        return *this;
    }
    ~pinned_shapes() { release(); }

    /// Room for `count` shapes, all null as yet. Those that are set must be pinned in `cache`, which outlives this.
    /// False when the memory gives none.
    template <class Cache>
    [[nodiscard]] bool expect(std::size_t count, Cache* cache) noexcept
    {
        if (!expect(count)) return false;
        cache_ = cache;
        release_ = [](void* held, std::span<const glyph_shape* const> shapes) noexcept {
            static_cast<Cache*>(held)->release(shapes);
        };
        return true;
    }
    /// The same for shapes that nobody pins.
    [[nodiscard]] bool expect(std::size_t count) noexcept
    {
        clear();
        if (!shapes_.reserve(count)) return false;
        for (std::size_t i = 0; i < count; ++i) shapes_.push_back_unchecked(nullptr);
        return true;
    }

    void set(std::size_t number, const glyph_shape* shape) noexcept { shapes_[number] = shape; }
    [[nodiscard]] const glyph_shape* operator[](std::size_t number) const noexcept { return shapes_[number]; }

    /// Gives the pins back; the shapes must not be read any more.
    void release() noexcept
    {
        if (cache_ != nullptr) release_(std::exchange(cache_, nullptr), shapes_.view());
    }

    void clear() noexcept
    {
        release();
        shapes_.clear();
    }

private:
    buffer<const glyph_shape*> shapes_;
    void* cache_ = nullptr;
    void (*release_)(void* cache, std::span<const glyph_shape* const> shapes) noexcept = nullptr;
};

}  // namespace typemesh

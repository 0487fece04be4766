// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/glyph/built_glyph.hpp>

#include <cstddef>
#include <new>

namespace typemesh::inline TYPEMESH_ABI {

/// The built glyphs of one text that no cache keeps. They are in blocks that never move, are freed all at once and are
/// reused for the next text. If several blocks were needed, one of their total size replaces them: after warm-up
/// nothing is allocated.
class glyph_store {
    struct block {
        block* next;
        std::size_t bytes;  // excluding the header
        [[nodiscard]] std::byte* data() noexcept { return reinterpret_cast<std::byte*>(this) + header; }
    };
    static constexpr std::size_t alignment = alignof(built_glyph) > alignof(block) ? alignof(built_glyph)
                                                                                   : alignof(block);
    static constexpr std::size_t header = (sizeof(block) + alignment - 1) / alignment * alignment;

public:
    explicit glyph_store(memory source) noexcept : source_{source} {}
    glyph_store(glyph_store&& other) noexcept
        : source_{other.source_}, newest_{taken(other.newest_)}, used_{taken(other.used_)}, total_{taken(other.total_)}
    {
    }
    glyph_store& operator=(glyph_store&& other) noexcept
    {
        swap_values(source_, other.source_);
        swap_values(newest_, other.newest_);
        swap_values(used_, other.used_);
        swap_values(total_, other.total_);
        return *this;
    }
    ~glyph_store() { release(); }

    /// Copies a draft; null if out of memory.
    [[nodiscard]] const built_glyph* keep(const glyph_draft& draft) noexcept
    {
        const std::size_t bytes = (built_glyph::bytes_for(draft) + alignment - 1) / alignment * alignment;
        if (newest_ == nullptr || bytes > newest_->bytes - used_) {
            const std::size_t more = total_ / 4 > 16 * 1024 ? total_ / 4 : 16 * 1024;  // never much more than needed
            if (!add_block(bytes > more ? bytes : more)) return nullptr;
        }
        void* place = newest_->data() + used_;
        used_ += bytes;
        return built_glyph::make(place, draft);
    }

    /// Removes all glyphs.
    void clear() noexcept
    {
        used_ = 0;
        if (newest_ == nullptr || newest_->next == nullptr) return;
        const std::size_t joint = total_;
        release();
        (void)add_block(joint);  // if this fails, the next keep() tries again
    }

private:
    bool add_block(std::size_t bytes) noexcept
    {
        void* raw = source_.allocate(source_.user, header + bytes, alignment);
        if (raw == nullptr) return false;
        newest_ = new (raw) block{newest_, bytes};
        used_ = 0;
        total_ += bytes;
        return true;
    }

    void release() noexcept
    {
        while (newest_ != nullptr) {
            block* next = newest_->next;
            source_.deallocate(source_.user, newest_, header + newest_->bytes, alignment);
            newest_ = next;
        }
        used_ = total_ = 0;
    }

    memory source_;
    block* newest_ = nullptr;  // all other blocks are full
    std::size_t used_ = 0;     // in the newest block
    std::size_t total_ = 0;    // of all blocks
};

}  // namespace typemesh::inline TYPEMESH_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/memory.hpp>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace typemesh {

/// Scratch memory that stages borrow and give back in the order of a stack, and that stays for the next call.
///
///     workspace::scope scratch{space};                // gives back at its end all that was taken through it
///     auto* rank = scratch.take<std::uint32_t>(n);    // n values, not initialised; null when there is no memory
///
/// Blocks never move, so pointers hold until their scope ends. When the outermost scope ends and several blocks were
/// needed, they are replaced by one of their joint size: after warm-up nothing is allocated. A workspace serves one thread at a time.
class workspace {
    static constexpr std::size_t alignment = 64;  // a cache line, and enough for any vector register

    struct alignas(alignment) block {
        block* next;
        std::size_t bytes;  // behind the header
        std::size_t used;
        [[nodiscard]] std::byte* data() noexcept { return reinterpret_cast<std::byte*>(this + 1); }
    };

public:
    explicit workspace(memory source = heap()) noexcept : source_{source} {}
    workspace(workspace&& other) noexcept
        : source_{other.source_},
          first_{std::exchange(other.first_, nullptr)},
          current_{std::exchange(other.current_, nullptr)}
    {
        TYPEMESH_ASSERT(other.depth_ == 0, "a workspace was moved while a scope was open");
    }
    workspace& operator=(workspace&& other) noexcept
    {
        TYPEMESH_ASSERT(depth_ == 0 && other.depth_ == 0, "a workspace was moved while a scope was open");
        std::swap(source_, other.source_);
        std::swap(first_, other.first_);
        std::swap(current_, other.current_);
        return *this;
    }
    ~workspace() { release(); }

    /// The memory behind it, for buffers that should draw from the same source.
    [[nodiscard]] memory source() const noexcept { return source_; }

    /// Bytes held now, used or not.
    [[nodiscard]] std::size_t capacity() const noexcept
    {
        std::size_t total = 0;
        for (const block* b = first_; b != nullptr; b = b->next) total += b->bytes;
        return total;
    }

    /// A stretch of borrowing; scopes nest.
    class scope {
    public:
        explicit scope(workspace& w) noexcept
            : workspace_{w}, block_{w.current_}, used_{w.current_ != nullptr ? w.current_->used : 0}
        {
            ++w.depth_;
        }
        scope(const scope&) = delete;
        scope& operator=(const scope&) = delete;
        ~scope() { workspace_.rewind(block_, used_); }

        /// `count` values that are not initialised, or null when the memory gives none; never null for count = 0 alone.
        template <class T>
        [[nodiscard]] T* take(std::size_t count) noexcept
        {
            static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>,
                          "scratch memory holds plain values");
            static_assert(alignof(T) <= alignment);
            if (count > (~std::size_t{0} >> 2) / sizeof(T)) return nullptr;
            return static_cast<T*>(workspace_.take_bytes(count * sizeof(T)));
        }

    private:
        workspace& workspace_;
        block* block_;
        std::size_t used_;
    };

private:
    void* take_bytes(std::size_t wanted) noexcept
    {
        wanted = (wanted + alignment - 1) & ~(alignment - 1);
        while (current_ == nullptr || wanted > current_->bytes - current_->used) {
            block* next = current_ == nullptr ? first_ : current_->next;
            if (next == nullptr) {
                const std::size_t doubled = current_ == nullptr ? 16 * 1024 : 2 * current_->bytes;
                next = make_block(wanted > doubled ? wanted : doubled);
                if (next == nullptr) return nullptr;
                (current_ == nullptr ? first_ : current_->next) = next;
            }
            current_ = next;
        }
        void* taken = current_->data() + current_->used;
        current_->used += wanted;
        return taken;
    }

    block* make_block(std::size_t bytes) noexcept
    {
        void* raw = source_.allocate(source_.user, sizeof(block) + bytes, alignof(block));
        return raw == nullptr ? nullptr : new (raw) block{nullptr, bytes, 0};
    }

    void rewind(block* to, std::size_t used) noexcept
    {
        for (block* b = to == nullptr ? first_ : to->next; b != nullptr; b = b->next) b->used = 0;
        if (to != nullptr) to->used = used;
        current_ = to;
        if (--depth_ == 0 && first_ != nullptr && first_->next != nullptr) {
            const std::size_t total = capacity();
            release();
            first_ = make_block(total);  // null is fine: the next take tries again
        }
    }

    void release() noexcept
    {
        while (first_ != nullptr) {
            block* next = first_->next;
            source_.deallocate(source_.user, first_, sizeof(block) + first_->bytes, alignof(block));
            first_ = next;
        }
        current_ = nullptr;
    }

    memory source_;
    block* first_ = nullptr;
    block* current_ = nullptr;
    std::size_t depth_ = 0;
};

}  // namespace typemesh
